/* Shards of a table of cases. */
#include "study/asked/shard.h"
#include <stdio.h>
#include <string.h>

static bool take_number(u32 *number, const char **text)
{
	const size_t digits = strspn(*text, "0123456789");
	*number = 0;
	for (size_t i = 0; i < digits && *number <= TS_MOST_SHARDS; i++) *number = 10 * *number + (u32)((*text)[i] - '0');
	*text += digits;
	return digits > 0 && *number >= 1 && *number <= TS_MOST_SHARDS;
}

ts_status ts_shard_read(ts_shard *shard, const char *text)
{
	const char *at = text;
	bool good = take_number(&shard->index, &at) && *at++ == '/' && take_number(&shard->of, &at) && *at == 0;
	if (good && shard->index <= shard->of) return TS_OK;
	return ts_fail("--shard %s: not I/N, with I from 1 to N and N at most %d; for instance 1/4", text, TS_MOST_SHARDS);
}

bool ts_shard_has(ts_shard shard, u64 place) { return shard.of == 0 || place % shard.of == shard.index - 1; }

bool ts_shard_has_block(ts_shard shard, u64 place, u64 n)
{
	return shard.of == 0 || place * shard.of / n == shard.index - 1;
}

void ts_shard_say_empty(ts_shard shard, u64 n_cases)
{
	ts_say("shard %u/%u: none of the %u cases is in it; it passes", (unsigned)shard.index, (unsigned)shard.of,
	       (unsigned)n_cases);
}

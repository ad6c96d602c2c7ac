/* Shards: each case of a table is in exactly one, and none has over one case more than another; what is no shard. */
#include <stdio.h>
#include "study/asked/shard.h"
#include "tests/model/test.h"

enum { MOST = 40 };

/* All tables of up to so many cases, in up to as many shards, either way. */
static void each_case_is_in_exactly_one_shard(void **state)
{
	(void)state;
	for (u32 n = 1; n <= MOST; n++) {
		for (u32 of = 1; of <= MOST; of++) {
			u32 size[2][MOST] = {{0}};
			for (u32 k = 0; k < n; k++) {
				u32 owners[2] = {0};
				for (u32 i = 1; i <= of; i++) {
					const ts_shard shard = {i, of};
					const bool has[2] = {ts_shard_has(shard, k), ts_shard_has_block(shard, k, n)};
					for (u32 way = 0; way < 2; way++) {
						owners[way] += has[way];
						size[way][i - 1] += has[way];
					}
				}
				assert_true(owners[0] == 1 && owners[1] == 1);
			}
			for (u32 way = 0; way < 2; way++) {
				for (u32 i = 0; i < of; i++) assert_in_range(size[way][i], n / of, n / of + (n % of != 0));
			}
		}
	}
}

/* Cases of a block follow one another, and blocks their shards. */
static void blocks_follow_one_another(void **state)
{
	(void)state;
	for (u32 n = 1; n <= MOST; n++) {
		for (u32 of = 1, last = 0; of <= MOST; of++, last = 0) {
			for (u32 k = 0; k < n; k++) {
				u32 i = 1;
				while (!ts_shard_has_block((ts_shard){i, of}, k, n)) i++;
				assert_true(i >= last);
				last = i;
			}
		}
	}
}

static void no_shard_has_every_case(void **state)
{
	(void)state;
	assert_true(ts_shard_has((ts_shard){0, 0}, 7) && ts_shard_has_block((ts_shard){0, 0}, 7, 9));
}

static void only_texts_of_shards_are_read(void **state)
{
	(void)state;
	static const char *const bad[] = {"",       "/",       "1",     "1/",  "/1",   "0/1", "2/1",
	                                  "1/1001", "01001/2", "1/2/3", "a/b", "+1/2", "1 /2"};
	ts_shard shard;
	char text[32];
	for (u32 of = 1; of <= TS_MOST_SHARDS; of += 37) {
		for (u32 i = 1; i <= of; i += 11) {
			snprintf(text, sizeof text, "%u/%u", (unsigned)i, (unsigned)of);
			assert_int_equal(ts_shard_read(&shard, text), TS_OK);
			assert_true(shard.index == i && shard.of == of);
		}
	}
	for (u32 i = 0; i < sizeof bad / sizeof *bad; i++) assert_int_equal(ts_shard_read(&shard, bad[i]), TS_ERROR);
	assert_int_equal(ts_shard_read(&shard, "99999999999999999999/2"), TS_ERROR);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(each_case_is_in_exactly_one_shard),
		cmocka_unit_test(blocks_follow_one_another),
		cmocka_unit_test(no_shard_has_every_case),
		cmocka_unit_test(only_texts_of_shards_are_read),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

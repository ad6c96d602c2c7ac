/* A part of a table of cases, --shard I/N: each case is in exactly one of the N parts; sizes differ by one at most. */
#ifndef TS_STUDY_ASKED_SHARD_H
#define TS_STUDY_ASKED_SHARD_H
#include "kernels/base/compat.h"
#include "model/core.h"

enum { TS_MOST_SHARDS = 1000 };

typedef struct {
	u32 index, of; /* from 1; of 0: all cases */
} ts_shard;

/* Reads "I/N", with I from 1 to N. */
ts_status ts_shard_read(ts_shard *shard, const char *text);
/* Whether case `place`, from 0, is in the part: every N-th case from the I-th on is. */
bool ts_shard_has(ts_shard shard, u64 place);
/* As ts_shard_has, for cases of which each needs the one before: parts are ranges of the n cases. */
bool ts_shard_has_block(ts_shard shard, u64 place, u64 n);
/* Says that the part has none of so many cases, and passes. */
void ts_shard_say_empty(ts_shard shard, u64 n_cases);

#endif

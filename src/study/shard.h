/* A part of a table of cases, --shard I/N: every N-th case from the I-th on, so that each is in exactly one part. */
#ifndef TS_STUDY_SHARD_H
#define TS_STUDY_SHARD_H
#include "../model/core.h"
#include "../kernels/base/compat.h"

enum { TS_MOST_SHARDS = 1000 };

typedef struct {
	u32 index, of; /* from 1; of 0: all cases */
} ts_shard;

/* Reads "I/N", with I from 1 to N. */
ts_status ts_shard_read(ts_shard *shard, const char *text);
/* Whether case `place`, from 0, is in it. */
bool ts_shard_has(ts_shard shard, u64 place);
/* Says so where no case is in it: a shard of none passes. */
void ts_shard_say_empty(ts_shard shard, u64 n_cases);

#endif

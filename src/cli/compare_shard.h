/* The part of a comparison that a shard judges: some of the stages; the scene counts as the first. */
#ifndef TS_CLI_COMPARE_SHARD_H
#define TS_CLI_COMPARE_SHARD_H
#include "cli/compare.h"

/* The names of all cases: "scene" and the stages of the method; a new reference, or NULL with the message set. */
json_t *ts_compare_cases(const ts_trace_info *of);
/* The cases of the shard, "scene,split,..."; release by free(); NULL with the message set. */
char *ts_compare_own(const json_t *cases, ts_shard shard);

#endif

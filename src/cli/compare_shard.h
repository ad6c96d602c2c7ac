/* The part of a comparison that is a shard's: stages, the scene's buffers first. */
#ifndef TS_CLI_COMPARE_SHARD_H
#define TS_CLI_COMPARE_SHARD_H
#include "compare.h"

/* The place of the stage that makes a buffer among the cases; 0: the scene. */
u32 ts_compare_place(const ts_pipeline *pipeline, ts_buffer_id id);
/* The names of all cases; a new reference, or NULL without memory. */
json_t *ts_compare_cases(const ts_pipeline *pipeline);
/* Marks the buffers of the shard. Fails where there is none that both have, in any shard. */
ts_status ts_compare_own(bool own[TS_N_BUFFERS], const ts_trace *reference, const ts_trace *candidate,
                         const ts_relaxations *relaxations, ts_shard shard);
/* Judges aside the inputs of the stages that differ, as far as other shards judge them. */
ts_status ts_compare_aside(ts_comparison *comparison, const ts_trace *reference, const ts_trace *candidate,
                           const ts_relaxations *relaxations);

#endif

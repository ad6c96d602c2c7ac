/* Teacher forcing: each stage of a candidate, given the candidate's own buffers before it. What it had no buffers of is
 * the reference's. So one early error does not hide whether the stages behind it are right. */
#ifndef TS_TRACE_FORCED_H
#define TS_TRACE_FORCED_H
#include "../compare/compare.h"

/* A buffer of the reference's points that the stage would mix with the candidate's, which stand in another order;
 * TS_N_BUFFERS: none. */
ts_buffer_id ts_forced_mixed(const ts_stage *stage, const ts_trace *reference, const ts_trace *candidate);

/* As ts_compare_traces, but the reference of each buffer is what its stage makes of the candidate's inputs: stages of
 * which the candidate has outputs are replayed, and its inputs are checked first. The outputs of a stage that cannot
 * be run on its inputs are TS_UNABLE; if nothing differs, that is TS_ERROR with the reason. Points in the order of
 * their arrival cannot be mixed with the reference's: a stage that reads or makes points' indices is TS_UNABLE unless
 * the candidate has them all. */
ts_status ts_compare_forced(ts_comparison *comparison, const ts_trace *reference, const ts_trace *candidate,
                            const ts_relaxations *relaxations, u32 threads);

#endif

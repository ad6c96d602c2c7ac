/* Teacher forcing: each stage of a candidate is judged given the candidate's own inputs, and the reference's where the
 * candidate lacks them. So one early error does not hide whether later stages are right. */
#ifndef TS_REPLAY_FORCED_H
#define TS_REPLAY_FORCED_H
#include "compare/compare.h"

/* A buffer of the reference's points that the stage would read together with the candidate's points, whose order
 * differs; TS_N_BUFFERS: none. */
ts_buffer_id ts_forced_mixed(const ts_stage *stage, const ts_trace *reference, const ts_trace *candidate);

/* As ts_compare_traces, but each buffer is compared with what its stage makes of the candidate's inputs: every stage of
 * which the candidate has outputs is replayed, after its inputs are checked. The outputs of a stage that cannot run on
 * these inputs are TS_UNABLE; if there are such outputs and nothing differs, the result is TS_ERROR with the reason.
 * Points in the order of their arrival cannot be mixed with the reference's: a stage that reads or makes indices of
 * points is TS_UNABLE unless the candidate has all buffers of points. */
ts_status ts_compare_forced(ts_comparison *comparison, const ts_trace *reference, const ts_trace *candidate,
                            const ts_relaxations *relaxations, u32 threads);

#endif

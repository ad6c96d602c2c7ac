/* Replay: runs one stage alone on the buffers of a trace, a port's for example, so that "stage 5 is right, given your
 * stage 4" can be said (teacher forcing). */
#ifndef TS_REPLAY_REPLAY_H
#define TS_REPLAY_REPLAY_H
#include "replay/check.h"

/* The stage of that name if `pipeline` runs it with these parameters; else NULL with the message set. */
const ts_stage *ts_replay_find(const char *name, const ts_pipeline *pipeline, const ts_params *params);

/* True if the run that made the trace took this step; a step of margins was taken if the run was asked for margins. */
bool ts_replay_takes(const ts_step *step, const ts_trace *reference);

/* Writes the buffers that a stage reads with these parameters, ended by TS_N_BUFFERS, without those of bounces beyond
 * the parameters' number. */
void ts_replay_reads(ts_buffer_id ids[TS_N_BUFFERS + 1], const ts_stage *stage, const ts_pipeline *pipeline,
                     const ts_params *params);

/* Runs a stage on the buffers of the run's frame, which ts_check has accepted, and makes its outputs anew in the frame.
 * Buffers that the stage does not read may be absent: they are left empty. Stages that work by batches of reflectors or
 * of depth maps take all of them as one batch, which gives the buffers of a trace: those of the batches one behind the
 * other. Splatting takes no fast path, because a port's points may stand in any order. The result never depends on
 * threads. */
ts_status ts_replay_stage(ts_run *run, const ts_stage *stage);

/* Loads the buffers that the stage reads, the candidate's where it has them, and checks them; candidate may be NULL.
 * Both traces must outlive *load, which is to be released by ts_load_end; on failure *load is NULL. The message begins
 * with "stage NAME: ". */
ts_status ts_replay_load(ts_load **load, const ts_stage *stage, const ts_trace *reference, const ts_trace *candidate,
                         u32 threads);

/* "Given these inputs, what should this stage's outputs be": ts_replay_load, then ts_replay_stage; its outputs are
 * in (*load)->run.frame. */
ts_status ts_replay_run(ts_load **load, const ts_stage *stage, const ts_trace *reference, const ts_trace *candidate,
                        u32 threads);

#endif

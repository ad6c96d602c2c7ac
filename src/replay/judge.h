/* Compares the outputs of a replayed stage with the files of a trace. */
#ifndef TS_REPLAY_JUDGE_H
#define TS_REPLAY_JUDGE_H
#include "compare/compare.h"
#include "replay/replay.h"

enum { TS_JUDGED_TEXT = 480 };

typedef struct {
	ts_buffer_id id;
	const ts_trace_item *item; /* the file judged: the candidate's, else the reference's; NULL: there is none */
	bool not_given;     /* the candidate lacks the buffer: the reference's was judged, given the candidate's inputs */
	bool shape_differs; /* in more than a size that the stage counts; nothing was compared */
	ts_verdict verdict; /* its reference is the replayed output */
	char text[TS_JUDGED_TEXT]; /* "" or the first difference, in one line */
} ts_judged;

/* Compares output `id` of the stage that ran in `load` with its file, exactly but for `relaxations`, which may be NULL.
 * Points of a candidate in order of arrival are found by their keys. Of a cropped file the crop is compared. On entry
 * only verdict.list of *judged is read. TS_OK if the same or if judged->item is NULL, TS_DIFFERENT, or TS_ERROR with
 * the message set if the file cannot be read. */
ts_status ts_judge(ts_judged *judged, const ts_load *load, ts_buffer_id id, const ts_relaxations *relaxations);

/* Teacher forcing (forced.c): each stage of a candidate is judged given the candidate's own inputs, and the reference's
 * where the candidate lacks them. So one early error does not hide whether later stages are right. */

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

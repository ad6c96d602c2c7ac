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

#endif

/* What a replayed stage made against what a trace says it made. */
#ifndef TS_TRACE_JUDGE_H
#define TS_TRACE_JUDGE_H
#include "../compare/compare.h"
#include "replay.h"

enum { TS_JUDGED_TEXT = 480 };

typedef struct {
	ts_buffer_id id;
	const ts_trace_item
		*item;          /* whose buffer was judged: the candidate's if it has it; NULL: nobody's, so nothing was */
	bool not_given;     /* there is a candidate, which lacks the buffer: the reference's was judged by its inputs */
	bool shape_differs; /* in more than a number of things that the stage counts; nothing was compared */
	ts_verdict verdict; /* what is right is its reference */
	char text[TS_JUDGED_TEXT]; /* "" or how they first differ, in one line */
} ts_judged;

/* Compares output `id` of the stage that ran in `load` with the file of it, exactly but for `relaxations`, which may be
 * NULL. Points of a candidate in order of arrival are found by their keys. Of a cropped file the part that is there is
 * compared. Of *judged only verdict.list is read. TS_OK if the same or if judged->item is NULL, TS_DIFFERENT, or
 * TS_ERROR with the message set if the file cannot be read. */
ts_status ts_judge(ts_judged *judged, const ts_load *load, ts_buffer_id id, const ts_relaxations *relaxations);

#endif

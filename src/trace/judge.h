/* What a replayed stage made against what a trace says it made. */
#ifndef TS_TRACE_JUDGE_H
#define TS_TRACE_JUDGE_H
#include "replay.h"
#include "same.h"

typedef struct {
	ts_buffer_id id;
	const ts_trace_item *item; /* whose buffer was judged: the candidate's if it has it; NULL: nobody's, so nothing was */
	bool shape_differs;
	u64 n, n_different;        /* elements compared, and those that are not the same */
	ts_place first;            /* of the file; if n_different > 0 */
	char replayed[TS_VALUE_TEXT], found[TS_VALUE_TEXT]; /* both values there */
	char text[TS_SAME_TEXT];   /* "" or how they differ, in one line */
} ts_verdict;

/* Compares output `id` of the stage that ran in `load` with the file of it, bit by bit. Points of a candidate that
 * declared arrival order are found by their keys. Of a cropped file the part that is there is compared. TS_OK if
 * the same or if verdict->item is NULL, TS_DIFFERENT, or TS_ERROR with the message set if the file cannot be read. */
ts_status ts_judge(ts_verdict *verdict, const ts_load *load, ts_buffer_id id);

#endif

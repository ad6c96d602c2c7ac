/* Rules of families: elements in which a candidate with points in the order of arrival may answer otherwise. */
#ifndef TS_COMPARE_TIE_H
#define TS_COMPARE_TIE_H
#include "trace/read.h"

/* A rule keeps its own state: `open` makes the state, `close` releases it. */
typedef struct {
	ts_buffer_id buffer;
	/* *ties: NULL if there are no ties. TS_ERROR if the reference cannot be read; *ties is NULL then. */
	ts_status (*open)(void **ties, const ts_trace *reference);
	/* *allows: the reference's value of an element and the candidate's, mapped to the reference's indices, are equally
	 * right. */
	ts_status (*allows)(void *ties, u64 element, u64 ref, u64 cand, bool *allows);
	void (*close)(void *ties);
} ts_tie_rule;

/* Takes the rules of all families: lists ended by NULL, each ended by a row without `open`. They must stay. */
void ts_tie_use(const ts_tie_rule *const *rules);

/* The rule of a buffer; NULL: there is none. */
const ts_tie_rule *ts_tie_find(ts_buffer_id buffer);

#endif

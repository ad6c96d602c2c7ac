/* Elements in which a candidate may answer otherwise, by rules of families: ties between points in the order of
 * arrival, and what a reference does not decide. */
#ifndef TS_COMPARE_DECIDED_H
#define TS_COMPARE_DECIDED_H
#include "trace/read.h"
#include "trace/reader.h"

/* A tie, in which a candidate with points in the order of arrival may answer otherwise. A rule keeps its own state:
 * `open` makes the state, `close` releases it. */
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

/* Elements that a reference does not decide: there a port with other sub-pixel bits, or other snapping, may answer
 * otherwise. A margin says how near an element of another buffer is to another answer: edges and depths in steps of
 * 1/256 pixel and of rounding, random numbers as a share of their range. An element is decided if its margin is larger
 * than the rule says; in buffers without a margin every element is decided. The reference must have the margins (render
 * --margins). A rule is a row of a family. */
typedef struct {
	ts_buffer_id buffer, margin; /* margin: pairs of f32 bits in 64-bit words, an f32, or for ties a byte, 0 if none */
	u32 of;                      /* elements of the buffer per element of the margin */
	f32 steps;                   /* an element is decided if its margin is above this; not used for ties */
	bool rare;                   /* most methods have the buffer without the margin, so a single file has no margin */
} ts_margin_rule;

/* Takes the rules of all families: lists ended by NULL, each ended by a row of no elements. They must stay. */
void ts_decided_use(const ts_margin_rule *const *rules);

typedef struct {
	const ts_margin_rule *rule; /* NULL: every element is decided */
	ts_reader *reader;
} ts_decided;

/* Opens the margins of a buffer. TS_ERROR if the reference lacks them. Release by ts_decided_close, also on failure. */
ts_status ts_decided_open(ts_decided *decided, const ts_trace *reference, ts_buffer_id id);
void ts_decided_close(ts_decided *decided);
/* Whether the reference decides an element. */
ts_status ts_decided_is(ts_decided *decided, u64 element, bool *is);

#endif

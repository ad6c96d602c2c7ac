/* What a reference does not decide: places where a port with other sub-pixel bits, or other snapping, may legally
 * answer otherwise. A margin says how near an element of another buffer is to another answer: its edges and depths in
 * steps of 1/256 pixel and of rounding, its random number as a share of its range. An element is decided if it is
 * farther than the margin's rule says; of buffers without a margin every element is. The reference must hold the
 * margins (render --margins). */
#ifndef TS_TRACE_DECIDED_H
#define TS_TRACE_DECIDED_H
#include "../trace/read.h"
#include "../trace/reader.h"

/* A row of a family. */
typedef struct {
	ts_buffer_id buffer, margin; /* pairs of f32 bits in words of 64, a f32, or of ties a byte, not 0 where it ties */
	u32 of;                      /* elements of the buffer to one of the margin */
	f32 steps;                   /* decided is what is farther than so much; of ties nothing */
	bool rare;                   /* most methods have the buffer and not the margin, so that a file alone has none */
} ts_margin_rule;

/* Takes the rules of all families: lists ended by NULL, each ended by a row of no elements. They must stay. */
void ts_decided_use(const ts_margin_rule *const *rules);

typedef struct {
	const ts_margin_rule *rule; /* NULL: everything is decided */
	ts_reader *reader;
} ts_decided;

/* Opens the margins of a buffer. TS_ERROR if the reference lacks them. Release by ts_decided_close, also on failure. */
ts_status ts_decided_open(ts_decided *decided, const ts_trace *reference, ts_buffer_id id);
void ts_decided_close(ts_decided *decided);
/* Whether the reference decides an element. */
ts_status ts_decided_is(ts_decided *decided, u64 element, bool *is);

#endif

/* Texels at which points that stand in the order of their arrival may answer otherwise: equal distances go to the lowest
 * index, and their indices are others. Nothing else is free. */
#ifndef TS_TRACE_TIE_H
#define TS_TRACE_TIE_H
#include "../../../trace/read.h"
#include "../../../trace/reader.h"

/* What decides whether a point offers a distance to a texel. */
typedef struct {
	const ts_trace *reference;
	ts_reader *tie, *face, *piece, *align, *point, *bits;
	u64 n_words;
} ts_ties;

/* Opens what the reference has of splat.tie and of the inputs of stage splat; without all of them nothing is free. Release
 * by ts_ties_close, also on failure. */
ts_status ts_ties_open(ts_ties *ties, const ts_trace *reference);
void ts_ties_close(ts_ties *ties);

/* *allows: the reference's key and the candidate's, mapped to the reference's indices, name two points that both offer
 * the least distance to this texel. */
ts_status ts_tie_allows(ts_ties *ties, u64 texel, u64 ref, u64 cand, bool *allows);

#endif

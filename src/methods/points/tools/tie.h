/* Texels at which points that stand in the order of their arrival may answer otherwise: equal distances go to the
 * lowest index, and their indices are others. Nothing else is free. A rule of compare/tie.h. */
#ifndef TS_POINTS_TOOLS_TIE_H
#define TS_POINTS_TOOLS_TIE_H
#include "../../../trace/read.h"

/* Opens what the reference has of splat.tie and of the inputs of stage splat; without all of them nothing is free. */
ts_status ts_splat_ties_open(void **ties, const ts_trace *reference);
void ts_splat_ties_close(void *ties);

/* *allows: the reference's key and the candidate's, mapped to the reference's indices, name two points that both offer
 * the least distance to this texel. */
ts_status ts_splat_tie_allows(void *ties, u64 texel, u64 ref, u64 cand, bool *allows);

#endif

/* Texels in which points in the order of arrival may answer otherwise: of equal distances the lowest index wins, and
 * indices differ. All other texels must be equal. A rule of compare/tie.h. */
#ifndef TS_METHODS_POINTS_TOOLS_TIE_H
#define TS_METHODS_POINTS_TOOLS_TIE_H
#include "trace/read.h"

/* Opens splat.tie and the inputs of stage splat in the reference; if one of them is missing there are no ties. */
ts_status ts_splat_ties_open(void **ties, const ts_trace *reference);
void ts_splat_ties_close(void *ties);

/* *allows: the reference's key and the candidate's, mapped to the reference's indices, name two points that both offer
 * the least distance to this texel. */
ts_status ts_splat_tie_allows(void *ties, u64 texel, u64 ref, u64 cand, bool *allows);

#endif

/* The part of a comparison that was asked for: the buffers of some stages. */
#ifndef TS_COMPARE_PART_H
#define TS_COMPARE_PART_H
#include "compare/compare.h"

/* Marks the buffers that the stages "scene,split,..." make. Fails if a name is of no stage, or both traces have no such
 * buffer in common. */
ts_status ts_part_make(bool part[TS_N_BUFFERS], const char *stages, const ts_trace *reference,
                       const ts_trace *candidate, const ts_relaxations *relaxations);
/* Judges the buffers outside the part that a stage with a difference has read, without counting them: by them the
 * report says whether inputs are identical. */
ts_status ts_part_inputs(ts_comparison *comparison, const ts_trace *reference, const ts_trace *candidate,
                         const ts_relaxations *relaxations);

#endif

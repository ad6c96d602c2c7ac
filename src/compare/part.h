/* The part of a comparison that was asked for: what some stages make. */
#ifndef TS_COMPARE_PART_H
#define TS_COMPARE_PART_H
#include "compare.h"

/* Marks the buffers that these stages make, "scene,split,...". Fails where a name is of none, or there is no buffer of
 * any stage that both have. */
ts_status ts_part_make(bool part[TS_N_BUFFERS], const char *stages, const ts_trace *reference,
                       const ts_trace *candidate, const ts_relaxations *relaxations);
/* Judges aside what is beside the part and a stage that differs has read: it says whether inputs are identical. */
ts_status ts_part_inputs(ts_comparison *comparison, const ts_trace *reference, const ts_trace *candidate,
                         const ts_relaxations *relaxations);

#endif

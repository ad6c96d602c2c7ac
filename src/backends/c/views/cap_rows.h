/* Filling the texels of a cap row by row, in maps that no other thread writes. */
#ifndef TS_BACKENDS_C_VIEWS_CAP_ROWS_H
#define TS_BACKENDS_C_VIEWS_CAP_ROWS_H
#include "kernels/views/view_map.h"

enum { TS_MOST_SIDE = 1024, TS_MOST_LEVELS = 11 }; /* of a map */

/* Texels before each level; ts_k_paraboloid_middle of each texel of a side. */
typedef struct {
	ts_pyramid pyramid;
	u32 before[TS_MOST_LEVELS];
	f32 middle[TS_MOST_SIDE];
} ts_cap_sides;

/* Sets the middles for maps of the pyramid, which are not wider than TS_MOST_SIDE. */
void ts_cap_sides_set(ts_cap_sides *sides, const ts_pyramid *pyramid);
/* ts_k_cap_fill. */
void ts_cap_rows_fill(u64 *map, const ts_cap_sides *sides, const ts_cap *cap, bool back, u64 key);

#endif

/* Random off-screen views, and texels that two ways of drawing left in them. */
#ifndef TS_TESTS_BACKENDS_C_RASTER_OFFSCREEN_H
#define TS_TESTS_BACKENDS_C_RASTER_OFFSCREEN_H
#include "kernels/raster/offscreen.h"
#include "tests/backends/c/raster/triangles.h"

enum { VIEWS = 5, MOST = 100, TEXELS = VIEWS * MOST * MOST };

/* Some straight ahead, some orthographic, some out of sight. */
static inline void random_views(ts_offscreen *views)
{
	u64 offset = 0;
	for (u32 v = 0; v < VIEWS; v++) {
		bool straight = below(2) == 0;
		ts_v3 back = straight ? ts_v3_make(0, 0, 1) : direction();
		ts_v3 right = straight ? ts_v3_make(1, 0, 0) : ts_normalize(ts_cross(direction(), back));
		views[v] = (ts_offscreen){.width = below(8) == 0 ? 0 : 1 + below(MOST),
		                          .height = 1 + below(MOST),
		                          .near = power(-14, 1),
		                          .focal = power(0, 9),
		                          .offset = offset,
		                          .orthographic = below(3) == 0,
		                          .object = below(5)};
		ts_store3(views[v].eye, place(4, below(2) == 0));
		ts_store3(views[v].right, right);
		ts_store3(views[v].up, ts_cross(back, right));
		ts_store3(views[v].back, back);
		offset += (u64)views[v].width * views[v].height;
	}
}

#endif

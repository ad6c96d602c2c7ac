/* Scenes of random triangles, biased to what rasterization decides differently: of any size, on planes and corners of
 * a grid, as slivers, degenerate, around the eye, far away; one- and two-sided, with and without an alpha mask. */
#ifndef TS_TESTS_BACKENDS_C_RASTER_TRIANGLES_H
#define TS_TESTS_BACKENDS_C_RASTER_TRIANGLES_H
#include "backends/fast.h"
#include "backends/kernels.h"
#include "tests/kernels/small.h"

static inline f32 power(f32 low, f32 high) { return exp2f(uniform(low, high)); }

/* Multiples of 1/8, or any. */
static inline ts_v3 place(f32 reach, bool on_grid)
{
	ts_v3 p = uniform3(-reach, reach);
	if (!on_grid) return p;
	return ts_v3_make(ts_rint(p.x * 8) / 8, ts_rint(p.y * 8) / 8, ts_rint(p.z * 8) / 8);
}

static inline void triangle(small_scene *s)
{
	static const f32 size[] = {0.01f, 0.05f, 0.25f, 1, 8, 1024, 1048576, 1.1529215e18f};
	bool on_grid = below(3) == 0;
	f32 side = size[below(4) != 0 ? below(4) : below(8)];
	ts_v3 a = place(below(16) == 0 ? side : 4, on_grid), b = ts_add(a, place(side, on_grid));
	ts_v3 c = below(8) == 0 ? ts_mad(a, ts_sub(b, a), uniform(-1, 2)) : ts_add(a, place(side, on_grid));
	u32 t = small_add(s, a, b, below(16) == 0 ? a : c, below(4), below(4));
	for (u32 k = 0; k < 3; k++) s->vertices[3 * t + k].colour[3] = uniform(0, 1);
}

/* Whole blocks, or not. */
static inline ts_arrays triangles(small_scene *s)
{
	small_clear(s);
	s->materials[1].flags = TS_DOUBLE_SIDED;
	s->materials[2].flags = TS_MASKED;
	s->materials[3].flags = TS_DOUBLE_SIDED | TS_MASKED;
	u32 n = below(3) == 0 ? 64 * (1 + below(6)) : 1 + below(700);
	while (s->n_triangles < n) triangle(s);
	return small_arrays(s);
}

/* What a buffer held before: mostly nothing. */
static inline u32 before(void) { return below(8) == 0 ? ts_f2u(power(-4, 4)) : TS_NONE; }

#endif

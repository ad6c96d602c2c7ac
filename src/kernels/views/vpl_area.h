/* Areas of the scene's triangles, by which paths begin at random on its surfaces (MegaViews section 4.1, figure 11;
 * METHODS 12), in units of 2^-24 of a face of the root cube, plus one unit if the triangle has area. Both sides of a
 * two-sided triangle count. */
#ifndef TS_KERNELS_VIEWS_VPL_AREA_H
#define TS_KERNELS_VIEWS_VPL_AREA_H
#include "kernels/base/args.h"
#include "kernels/base/scene.h"
#include "kernels/views/octree_root.h"

#define TS_ROWS_ts_vpl_area_args(ARG) \
	ARG(INNER, ts_arrays, scene, none) \
	ARG(IN, ts_root, root, octree_root) \
	ARG(OUT, u32, areas, vpl_area) /* then their prefix sums */
TS_ARGS(ts_vpl_area_args);

/* The area of a triangle; of both sides if it is two-sided. */
TS_FN f32 ts_k_vpl_sides(const ts_arrays *scene, u32 triangle, const ts_corners *t)
{
	f32 twice = ts_length(t->n);
	return ts_k_is_two_sided(scene, triangle) ? twice : twice * 0.5f;
}

/* map over triangles */
TS_FN void ts_k_vpl_area_item(const ts_vpl_area_args *args, u64 i)
{
	ts_corners t = ts_k_corners(&args->scene, (u32)i);
	f32 area = ts_k_vpl_sides(&args->scene, (u32)i, &t);
	f32 squares = ts_flush(area / args->root->side) / args->root->side;
	bool none = ts_k_is_degenerate(t.n);
	args->areas[i] = none ? 0u : 1u + (u32)ts_f2i(ts_min(squares * 16777216.0f, 1073741824.0f));
}

/* The triangle to which a number below the total of the prefix sums belongs. */
TS_FN u32 ts_k_vpl_triangle(TS_GLOBAL const u32 *areas, u32 n, u32 place)
{
	u32 low = 0u;
	u32 high = n - 1u;
	while (low < high) {
		u32 middle = low + (high - low) / 2u;
		bool before = areas[middle + 1u] <= place;
		low = before ? middle + 1u : low;
		high = before ? high : middle;
	}
	return low;
}

#endif

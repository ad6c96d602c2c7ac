/* The root cube of both octrees, around all vertices of the frame, and its lattice with 256 steps per leaf voxel
 * (METHODS 12). Least and greatest coordinates are integer minima of ordered bits, so that the order of the vertices
 * changes nothing. */
#ifndef TS_KERNELS_VIEWS_OCTREE_ROOT_H
#define TS_KERNELS_VIEWS_OCTREE_ROOT_H
#include "kernels/base/args.h"
#include "kernels/base/morton.h"
#include "kernels/base/records.h"
#include "kernels/base/vec.h"

/* Bits that sort like the numbers: the sign bit is flipped, or all bits if the number is negative. */
TS_FN u32 ts_k_ordered(f32 x)
{
	u32 u = ts_f2u(x);
	return (u & 0x80000000u) != 0u ? ~u : u | 0x80000000u;
}

TS_FN f32 ts_k_of_ordered(u32 o) { return ts_u2f((o & 0x80000000u) != 0u ? o & 0x7fffffffu : ~o); }

#define TS_ROWS_ts_octree_root_args(ARG) \
	ARG(IN, ts_vertex, vertices, pose_vertex) \
	ARG(MIN, u32, least, octree_root_least) \
	ARG(OUT, ts_root, root, octree_root)
TS_ARGS(ts_octree_root_args);

TS_FN void ts_k_root_least(TS_GLOBAL u32 *least, u32 axis, f32 x)
{
	u32 o = ts_k_ordered(x);
	ts_min_u32(&least[axis], o);
	ts_min_u32(&least[3u + axis], ~o);
}

/* scatter over vertices */
TS_FN void ts_k_octree_root_least_item(const ts_octree_root_args *args, u64 i)
{
	for (u32 axis = 0u; axis < 3u; axis++) ts_k_root_least(args->least, axis, args->vertices[i].position[axis]);
}

#define TS_ROOT_MARGIN 1.0009765625f         /* 1 + 2^-10 */
#define TS_ROOT_ROUNDING 9.5367431640625e-7f /* 2^-20 */

/* item 0. With the greatest extent e and the greatest coordinate m of either sign, the side is e (1 + 2^-10) + m 2^-20.
 * Rounding moves a vertex by at most 3 m 2^-24, so every vertex stays inside, even after it is snapped with 2^11 voxels
 * per side. */
TS_FN void ts_k_octree_root_item(const ts_octree_root_args *args, u64 i)
{
	if (i != 0u) return;
	/* Read the extent of the vertices; without vertices it is a point at 0. */
	bool any = args->least[0] != TS_NONE;
	ts_v3 zero = ts_v3_make(0.0f, 0.0f, 0.0f);
	TS_GLOBAL const u32 *least = args->least;
	ts_v3 low = ts_v3_make(ts_k_of_ordered(least[0]), ts_k_of_ordered(least[1]), ts_k_of_ordered(least[2]));
	ts_v3 high = ts_v3_make(ts_k_of_ordered(~least[3]), ts_k_of_ordered(~least[4]), ts_k_of_ordered(~least[5]));
	low = any ? low : zero;
	high = any ? high : zero;
	/* Find the greatest extent, and the greatest coordinate of either sign, which bounds the rounding. */
	ts_v3 size = ts_sub(high, low);
	ts_v3 most = ts_max3(high, ts_neg(low));
	f32 extent = ts_max(size.x, ts_max(size.y, size.z));
	f32 far = ts_max(most.x, ts_max(most.y, most.z));
	/* Enlarge the side by both margins, so that every vertex stays inside; a scene of one point gets the side 1. */
	f32 side = extent * TS_ROOT_MARGIN;
	f32 room = far * TS_ROOT_ROUNDING;
	side = ts_flush(side + room);
	side = side > 0.0f ? side : 1.0f;
	/* Place the cube about the middle of the vertices. */
	ts_v3 centre = ts_scale(ts_add(low, high), 0.5f);
	f32 half_side = side * 0.5f;
	ts_store3(args->root->lower, ts_sub(centre, ts_v3_make(half_side, half_side, half_side)));
	args->root->side = ts_put(side);
}

TS_FN f32 ts_k_voxel_side(TS_GLOBAL const ts_root *root, u32 level) { return root->side / (f32)(1u << level); }

TS_FN ts_v3 ts_k_voxel_middle(TS_GLOBAL const ts_root *root, u32 level, ts_i3 voxel)
{
	ts_v3 middle = ts_v3_make((f32)voxel.x + 0.5f, (f32)voxel.y + 0.5f, (f32)voxel.z + 0.5f);
	return ts_mad(ts_load3(root->lower), middle, ts_k_voxel_side(root, level));
}

#define TS_VOXEL 256
#define TS_VOXEL_BITS 8

/* The lattice point nearest to p; coordinates are in [0, 2^(levels + 8)], at most 2^19. */
TS_FN ts_i3 ts_k_root_place(TS_GLOBAL const ts_root *root, u32 levels, ts_v3 p)
{
	i32 most = (i32)((u32)TS_VOXEL << levels);
	f32 scale = (f32)most / root->side;
	ts_v3 q = ts_scale(ts_sub(p, ts_load3(root->lower)), scale);
	return ts_i3_make(ts_min_i32(ts_max_i32(ts_fix(q.x, 0, 20), 0), most),
	                  ts_min_i32(ts_max_i32(ts_fix(q.y, 0, 20), 0), most),
	                  ts_min_i32(ts_max_i32(ts_fix(q.z, 0, 20), 0), most));
}

/* The leaf voxel that contains p. */
TS_FN ts_i3 ts_k_voxel_of(TS_GLOBAL const ts_root *root, u32 levels, ts_v3 p)
{
	i32 last = (i32)(1u << levels) - 1;
	ts_i3 q = ts_k_root_place(root, levels, p);
	return ts_i3_make(ts_min_i32(q.x >> TS_VOXEL_BITS, last), ts_min_i32(q.y >> TS_VOXEL_BITS, last),
	                  ts_min_i32(q.z >> TS_VOXEL_BITS, last));
}

#endif

/* Composites of MegaViews and ManyLoDs: paraboloid maps (paraboloid.h, cap.h), the cut through two octrees (pair.h,
 * traverse.h), voxels of triangles (voxel.h), rays (cast.h), virtual point lights (vpl_gather.h). */
#ifndef TS_KERNELS_VIEWS_COMPOSITES_H
#define TS_KERNELS_VIEWS_COMPOSITES_H
#include "kernels/vectors/composites_row.h"
#include "kernels/views/cap.h"
#include "kernels/views/cast.h"
#include "kernels/views/traverse.h"
#include "kernels/views/voxel.h"
#include "kernels/views/vpl_gather.h"

TS_ROW_AT(ts_node)
TS_ROW_AT(ts_cone)

TS_VECTOR(paraboloid_texel)
{
	ts_v3 d = ts_row_v3(in, 0u);
	ts_put_v2(out, ts_k_paraboloid_at(d, in[3]));
	out[2] = ts_k_paraboloid_texel(d, in[3]);
}

TS_VECTOR(paraboloid_direction) { ts_put_v3(out, ts_k_paraboloid_direction(in[0], in[1])); }

TS_COMPOSITE_FLOAT(paraboloid_size, ts_k_paraboloid_size(ts_row_f32(in, 0u), ts_row_f32(in, 1u), in[2]))

/* The fate of the pair of the first nodes of both octrees. */
TS_VECTOR(pair_fate)
{
	ts_traverse_args args;
	args.nodes = ts_row_at_ts_node(in, 0u);
	args.views = ts_row_at_ts_node(in, 8u);
	args.cones = ts_row_at_ts_cone(in, 16u);
	args.phi.cosine = ts_row_f32(in, 24u);
	args.phi.sine = ts_row_f32(in, 25u);
	args.n = in[26];
	args.apart = ts_row_f32(in, 27u);
	args.last = in[28];
	args.to_last = in[29];
	args.cutoff = ts_row_f32(in, 30u);
	out[0] = ts_k_pair_fate(&args, 0u);
}

TS_VECTOR(cap_inside)
{
	ts_cap cap = ts_k_cap(ts_row_v3(in, 0u), ts_row_f32(in, 3u), in[4] != 0u);
	ts_put_f32(out, 0u, ts_k_cap_inside(&cap, in[5], in[6], in[7], in[8]));
}

TS_FN ts_i3 ts_row_i3(TS_GLOBAL const u32 *row, u32 k)
{
	return ts_i3_make(ts_row_i32(row, k), ts_row_i32(row, k + 1u), ts_row_i32(row, k + 2u));
}

TS_FN bool ts_k_range_holds(ts_range r, i64 x) { return x >= r.first && x <= r.last; }

TS_VECTOR(voxel_touches)
{
	ts_touch t = ts_k_touch(ts_row_i3(in, 0u), ts_row_i3(in, 3u), ts_row_i3(in, 6u), (i32)in[9]);
	ts_i3 v = ts_k_turned(ts_row_i3(in, 10u), t.turn);
	bool is = ts_k_range_holds(t.box[1], v.y) && ts_k_range_holds(ts_k_touch_row(&t, v.y), v.x) &&
	          ts_k_range_holds(ts_k_touch_column(&t, v.x, v.y), v.z) && ts_k_touch_voxel(&t, v.x, v.y, v.z);
	out[0] = is ? 1u : 0u;
}

TS_VECTOR(cast_inside)
{
	ts_cast_ray ray = ts_k_cast_ray(ts_row_v3(in, 0u), ts_row_v3(in, 3u));
	ts_corners t;
	t.a = ts_row_v3(in, 6u);
	t.b = ts_row_v3(in, 9u);
	t.c = ts_row_v3(in, 12u);
	t.n = ts_v3_make(0.0f, 0.0f, 0.0f);
	out[0] = ts_k_cast_inside(&ray, &t) ? 1u : 0u;
}

TS_COMPOSITE_FLOAT(vpl_form, ts_k_vpl_form(ts_row_v3(in, 0u), ts_row_v3(in, 3u), ts_row_v3(in, 6u), ts_row_f32(in, 9u)))

#define TS_LIST_views_composites(VECTOR) \
	VECTOR(paraboloid_texel) \
	VECTOR(paraboloid_direction) \
	VECTOR(paraboloid_size) \
	VECTOR(pair_fate) \
	VECTOR(cap_inside) \
	VECTOR(voxel_touches) \
	VECTOR(cast_inside) \
	VECTOR(vpl_form)
/* map over rows */
TS_VECTORS(views_composites)

#endif

/* T_epr = S T_align: a piece into its own plane, centroid on a sample, longest edge along x (EPR section 3.2, eq. 1;
 * METHODS 2). q = s (u.(v - c), v.(v - c)) + (1/2, 1/2), snapped to 24.8. */
#ifndef TS_KERNELS_ALIGN_H
#define TS_KERNELS_ALIGN_H
#include "../base/args.h"
#include "../base/area.h"
#include "../base/records.h"

#define TS_ROWS_ts_align_args(ARG) \
	ARG(IN, ts_piece, pieces, split_triangle) \
	ARG(IN, f32, scale, density_scale) \
	ARG(IN, u32, keep, cull_keep) \
	ARG(OUT, ts_align, frames, align_frame)
TS_ARGS(ts_align_args);

/* A point of the plane in the lattice. */
TS_FN ts_v2 ts_k_lattice(ts_v3 c, ts_v3 u, ts_v3 v, f32 s, ts_v3 p)
{
	ts_v3 d = ts_sub(p, c);
	return ts_v2_make(s * ts_dot(u, d) + 0.5f, s * ts_dot(v, d) + 0.5f);
}

/* map over pieces */
TS_FN void ts_k_align_item(const ts_align_args *args, u64 i)
{
	TS_GLOBAL const ts_piece *piece = &args->pieces[i];
	TS_GLOBAL ts_align *out = &args->frames[i];
	ts_v3 corner[3];
	corner[0] = ts_load3(piece->a);
	corner[1] = ts_load3(piece->b);
	corner[2] = ts_load3(piece->c);
	f32 length;
	u32 edge = ts_k_longest_edge(corner[0], corner[1], corner[2], &length);
	ts_v3 u = ts_normalize(ts_sub(corner[edge == 2u ? 0u : edge + 1u], corner[edge]));
	ts_v3 n = ts_normalize(ts_cross(ts_sub(corner[1], corner[0]), ts_sub(corner[2], corner[0])));
	ts_v3 v = ts_normalize(ts_cross(n, u));
	ts_v3 sum = ts_add(ts_add(corner[0], corner[1]), corner[2]);
	ts_v3 c = ts_scale(sum, 0.3333333432674407958984375f);
	f32 s = args->keep[i] != 0u ? args->scale[i] : 0.0f;
	ts_store3(out->c, c);
	ts_store3(out->u, u);
	ts_store3(out->v, v);
	out->s = s;
	out->pad0 = 0u;
	out->pad1 = 0u;
	out->pad2[0] = 0u;
	out->pad2[1] = 0u;
	for (u32 k = 0u; k < 3u; k++) {
		ts_v2 q = ts_k_lattice(c, u, v, s, corner[k]);
		out->q[k * 2u] = ts_fix(q.x, 8, 23);
		out->q[k * 2u + 1u] = ts_fix(q.y, 8, 23);
	}
}

#endif

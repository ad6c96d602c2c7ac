/* Primitives of rasterization: projection, snapping, edges, coverage, interpolation (CONTRACT rules 15 to 22). */
#ifndef TS_KERNELS_VECTORS_VECTORS_RASTER_H
#define TS_KERNELS_VECTORS_VECTORS_RASTER_H
#include "kernels/raster/clip.h"
#include "kernels/raster/cover.h"
#include "kernels/raster/raster.h"
#include "kernels/vectors/vectors_row.h"

TS_FN ts_snapped ts_row_snapped(TS_GLOBAL const u32 *in, u32 k)
{
	ts_snapped r;
	r.x = ts_row_i32(in, k);
	r.y = ts_row_i32(in, k + 1u);
	return r;
}

/* A view of a size and a focal length; its other members are 0, and its image is not moved. */
TS_FN ts_camera_k ts_row_view(TS_GLOBAL const u32 *in)
{
	ts_v3 zero = ts_v3_make(0.0f, 0.0f, 0.0f);
	ts_camera_k r;
	/* Place the view at the origin; rows have points in view space already. */
	r.eye = zero;
	r.right = zero;
	r.up = zero;
	r.back = zero;
	r.near = 0.0f;
	/* Read the size and the focal length. */
	r.width = ts_row_i32(in, 0u);
	r.height = ts_row_i32(in, 1u);
	r.focal = ts_row_f32(in, 2u);
	/* Leave the image unmoved, in perspective. */
	r.side = 1.0f;
	r.shift_x = 0;
	r.shift_y = 0;
	r.orthographic = 0u;
	return r;
}

TS_FN ts_corner ts_k_vector_corner(ts_v3 p)
{
	ts_corner r;
	r.x = p.x;
	r.y = p.y;
	r.z = p.z;
	r.w = ts_v3_make(0.0f, 0.0f, 0.0f);
	return r;
}

TS_VECTOR(cut)
{
	ts_corner from = ts_k_vector_corner(ts_v3_make(TS_A, 0.0f, 0.0f));
	ts_corner to = ts_k_vector_corner(ts_v3_make(TS_C, 0.0f, 0.0f));
	ts_corner r = ts_k_cut(&from, TS_B, &to, ts_row_f32(in, 3u), 0.0f);
	ts_set_f32(out, 0u, r.x);
}

TS_VECTOR(project)
{
	ts_camera_k view = ts_row_view(in);
	ts_corner p = ts_k_vector_corner(ts_row_v3(in, 3u));
	ts_set_v2(out, ts_k_project(&view, &p));
}

TS_VECTOR(snap)
{
	ts_snapped s = ts_k_snap(ts_row_v2(in, 0u));
	out[0] = (u32)s.x;
	out[1] = (u32)s.y;
}

TS_FN i64 ts_k_vector_edge_of(TS_GLOBAL const u32 *in)
{
	return ts_k_edge(ts_row_snapped(in, 0u), ts_row_snapped(in, 2u), ts_row_i32(in, 4u), ts_row_i32(in, 5u));
}
TS_VECTOR_WIDE(edge, ts_k_vector_edge_of(in))

TS_VECTOR_WIDE(floor_quotient, ts_k_floor_quotient(ts_row_i64(in, 0u), ts_row_i64(in, 2u)))

TS_VECTOR_WORD(top_left, ts_k_is_top_left(ts_row_snapped(in, 0u), ts_row_snapped(in, 2u)))

TS_VECTOR(covers)
{
	ts_setup t = ts_k_setup(ts_row_snapped(in, 0u), ts_row_snapped(in, 2u), ts_row_snapped(in, 4u));
	ts_edges e = ts_k_edges(&t, ts_row_i32(in, 6u), ts_row_i32(in, 7u));
	out[0] = t.area != 0 && ts_k_covers(&t, &e) ? 1u : 0u;
}

TS_FN ts_cover ts_row_cover(TS_GLOBAL const u32 *in)
{
	ts_cover r;
	r.n = 3u;
	for (u32 k = 0u; k < 3u; k++) r.v[k] = ts_row_snapped(in, 2u * k);
	ts_k_cover_finish(&r, ts_row_i32(in, 6u));
	return r;
}

TS_VECTOR(touches)
{
	ts_cover cover = ts_row_cover(in);
	ts_box box = cover.touched;
	i32 i = ts_row_i32(in, 7u);
	i32 j = ts_row_i32(in, 8u);
	bool meets = i >= box.x0 && i <= box.x1 && j >= box.y0 && j <= box.y1;
	out[0] = meets && ts_k_touches(&cover, i, j) ? 1u : 0u;
}

/* The first of the pixels, and how many. */
TS_VECTOR(touched_row)
{
	ts_cover cover = ts_row_cover(in);
	ts_box box = cover.touched;
	i32 j = ts_row_i32(in, 7u);
	ts_lines lines;
	ts_k_lines(&lines, &cover);
	ts_span row = ts_k_touched_row(&lines, box, j);
	bool none = j < box.y0 || j > box.y1 || row.last < row.first;
	out[0] = none ? 0u : (u32)row.first;
	out[1] = none ? 0u : (u32)(row.last - row.first) + 1u;
}

/* The fragment at three edges, whose sum is the area, between corners of three depths. out: weights, depth. */
TS_FN void ts_k_vector_fragment_of(TS_GLOBAL u32 *out, TS_GLOBAL const u32 *in, bool parallel)
{
	ts_corner corner[3];
	ts_setup setup;
	ts_edges edges;
	/* Take the edges as they are, with the area that they add up to. */
	setup.area = 0;
	for (u32 k = 0u; k < 3u; k++) {
		setup.from[k] = k;
		edges.e[k] = ts_row_i64(in, 2u * k);
		setup.area += edges.e[k];
		corner[k] = ts_k_vector_corner(ts_v3_make(0.0f, 0.0f, ts_row_f32(in, 6u + k)));
	}
	/* Give each corner the whole of its own weight, so that the results are the fragment's weights. */
	corner[0].w.x = 1.0f;
	corner[1].w.y = 1.0f;
	corner[2].w.z = 1.0f;
	/* Interpolate, and store without ts_put, which is a primitive of its own. */
	ts_fragment f = parallel ? ts_k_fragment_parallel(&setup, &edges, &corner[0], &corner[1], &corner[2])
	                         : ts_k_fragment(&setup, &edges, &corner[0], &corner[1], &corner[2]);
	ts_set_v3(out, f.w);
	ts_set_f32(out, 3u, f.z);
}
TS_VECTOR(fragment) { ts_k_vector_fragment_of(out, in, false); }
TS_VECTOR(fragment_parallel) { ts_k_vector_fragment_of(out, in, true); }

#endif

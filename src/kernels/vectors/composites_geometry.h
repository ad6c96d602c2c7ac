/* Composites of triangles: edges, closest points (closest.h), rays (hit.h), footprints (surface.h), poses (pose.h),
 * clipping (clip.h). */
#ifndef TS_KERNELS_VECTORS_COMPOSITES_GEOMETRY_H
#define TS_KERNELS_VECTORS_COMPOSITES_GEOMETRY_H
#include "kernels/base/area.h"
#include "kernels/base/closest.h"
#include "kernels/base/hit.h"
#include "kernels/base/pose.h"
#include "kernels/base/surface.h"
#include "kernels/vectors/composites_row.h"
#include "kernels/vectors/vectors_raster.h"

TS_VECTOR(longest_edge)
{
	f32 longest;
	out[0] = ts_k_longest_edge(ts_row_v3(in, 0u), ts_row_v3(in, 3u), ts_row_v3(in, 6u), &longest);
	ts_put_f32(out, 1u, longest);
}

TS_VECTOR(closest_on_triangle)
{
	ts_put_v3(out,
	          ts_k_closest_on_triangle(ts_row_v3(in, 0u), ts_row_v3(in, 3u), ts_row_v3(in, 6u), ts_row_v3(in, 9u)));
}

TS_VECTOR(closest_on_border)
{
	ts_put_v3(out, ts_k_closest_on_border(ts_row_v3(in, 0u), ts_row_v3(in, 3u), ts_row_v3(in, 6u), ts_row_v3(in, 9u)));
}

TS_VECTOR(circumcentre) { ts_put_v3(out, ts_k_circumcentre(ts_row_v3(in, 0u), ts_row_v3(in, 3u), ts_row_v3(in, 6u))); }

TS_VECTOR(hit)
{
	ts_corners t;
	t.a = ts_row_v3(in, 6u);
	t.b = ts_row_v3(in, 9u);
	t.c = ts_row_v3(in, 12u);
	t.n = ts_row_v3(in, 15u);
	ts_hit r = ts_k_hit(ts_row_v3(in, 0u), ts_row_v3(in, 3u), &t);
	ts_put_f32(out, 0u, r.t);
	ts_put_v3(out + 1, r.weights);
}

TS_COMPOSITE_FLOAT(footprint, ts_k_footprint(TS_A, ts_row_v3(in, 1u), ts_row_v3(in, 4u)))

/* A vertex, as ts_k_pose_item has it; the normal is the tangent too. */
TS_VECTOR(pose)
{
	ts_pose pose = ts_k_pose_at(ts_row_at_ts_object(in, 0u), 1u, 0u, ts_row_at_ts_motion(in, 12u), in[37], in[36]);
	ts_v3 n = ts_row_v3(in, 41u);
	ts_put_v3(out, ts_k_pose_point(&pose, ts_row_v3(in, 38u)));
	ts_put_v3(out + 3, pose.moves != 0u ? ts_k_pose_normal(&pose, n) : n);
	ts_put_v3(out + 6, pose.moves != 0u ? ts_k_pose_tangent(&pose, n) : n);
}

TS_FN void ts_put_polygon(TS_GLOBAL u32 *out, const ts_polygon *polygon)
{
	out[0] = polygon->n;
	for (u32 k = 0u; k < TS_MAX_CORNERS; k++) {
		TS_GLOBAL u32 *corner = out + 1u + k * 6u;
		bool is = k < polygon->n;
		ts_v3 zero = ts_v3_make(0.0f, 0.0f, 0.0f);
		ts_put_v3(corner, is ? ts_v3_make(polygon->corner[k].x, polygon->corner[k].y, polygon->corner[k].z) : zero);
		ts_put_v3(corner + 3, is ? polygon->corner[k].w : zero);
	}
}

TS_VECTOR(clip)
{
	ts_camera_k view = ts_row_view(in);
	view.near = ts_row_f32(in, 3u);
	view.orthographic = in[4];
	ts_polygon polygon;
	polygon.n = 3u;
	for (u32 k = 0u; k < 3u; k++) polygon.corner[k] = ts_k_vector_corner(ts_row_v3(in, 5u + 3u * k));
	polygon.corner[0].w.x = 1.0f;
	polygon.corner[1].w.y = 1.0f;
	polygon.corner[2].w.z = 1.0f;
	ts_k_clip_to_range(&view, &polygon);
	ts_put_polygon(out, &polygon);
}

#endif

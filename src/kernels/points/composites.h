/* Composites of points: densities (density.h, view_density.h), culling (cull.h), splats (splat_box.h), reflected rays
 * (samples.h), the codes of depth and colour in texels (scatter.h, forward.h). */
#ifndef TS_KERNELS_POINTS_COMPOSITES_H
#define TS_KERNELS_POINTS_COMPOSITES_H
#include "kernels/points/cull.h"
#include "kernels/points/forward.h"
#include "kernels/points/samples.h"
#include "kernels/points/scatter.h"
#include "kernels/points/splat_box.h"
#include "kernels/points/view_density.h"
#include "kernels/vectors/composites_row.h"

TS_ROW_AT(ts_face)
TS_ROW_AT(ts_offscreen)
TS_ROW_AT(ts_pixel)

TS_COMPOSITE_FLOAT(path_length,
                   ts_k_path_length(ts_row_v3(in, 0u), ts_row_v3(in, 3u), ts_row_f32(in, 6u), ts_row_v3(in, 7u),
                                    ts_row_v3(in, 10u), ts_row_v3(in, 13u), in[16] != 0u))

TS_COMPOSITE_FLOAT(ball_spread, ts_k_ball_spread(TS_A, TS_B, TS_C))

/* The density that one cube demands. */
TS_VECTOR(eye_density)
{
	ts_density_args args;
	/* Describe one cube, one eye and the choices of the row. */
	args.cubes = ts_row_at_ts_face(in, 0u);
	args.view = ts_row_at_ts_view(in, 16u);
	args.rho = ts_row_f32(in, 34u);
	args.n_cubes = 1u;
	args.paper = in[35];
	args.cap = in[36];
	args.greatest = 0u;
	args.offaxis = in[37];
	args.ball = in[38];
	/* Compute the density of the row's triangle. */
	ts_eye_density d =
		ts_k_density(&args, ts_row_at_u64(in, 32u), ts_row_v3(in, 39u), ts_row_v3(in, 42u), ts_row_v3(in, 45u));
	ts_put_f32(out, 0u, d.s);
	out[1] = d.limited;
}

/* The density that one view demands. */
TS_VECTOR(view_density)
{
	ts_density_args args;
	args.views = ts_row_at_ts_offscreen(in, 0u);
	args.n_views = 1u;
	args.rate = in[26];
	ts_need r =
		ts_k_view_density(&args, ts_row_at_u64(in, 24u), ts_row_v3(in, 27u), ts_row_v3(in, 30u), ts_row_v3(in, 33u));
	ts_put_f32(out, 0u, r.s);
	ts_put_f32(out, 1u, r.uneven);
}

TS_VECTOR(cull_chance)
{
	ts_cull_args args;
	args.pieces = ts_row_at_ts_piece(in, 0u);
	args.seed = in[12];
	out[0] = (u32)ts_k_cull_chance(&args, 0u);
}

TS_VECTOR(splat_box)
{
	ts_camera_k view = ts_k_view(ts_row_at_ts_view(in, 0u));
	ts_square square;
	square.c = ts_row_v3(in, 16u);
	square.u = ts_row_v3(in, 19u);
	square.v = ts_row_v3(in, 22u);
	square.length = ts_row_f32(in, 25u);
	square.slack = ts_row_f32(in, 26u);
	ts_box box = ts_k_splat_box(&view, &square, in[27] != 0u ? 0.0f : TS_SPLAT_INSET);
	out[0] = (u32)box.x0;
	out[1] = (u32)box.y0;
	out[2] = (u32)box.x1;
	out[3] = (u32)box.y1;
}

TS_VECTOR(plane_distance)
{
	ts_camera_k view = ts_k_view(ts_row_at_ts_view(in, 0u));
	ts_put_f32(out, 0u,
	           ts_k_plane_distance(&view, ts_row_v3(in, 16u), ts_row_v3(in, 19u), ts_row_f32(in, 22u),
	                               ts_row_f32(in, 23u), ts_row_i32(in, 24u), ts_row_i32(in, 25u)));
}

TS_VECTOR(sample_ray)
{
	ts_ray ray = ts_k_sample_ray(ts_row_at_ts_pixel(in, 0u), ts_row_v3(in, 24u), in[27]);
	ts_put_v3(out, ray.p);
	ts_put_v3(out + 3, ray.direction);
}

TS_VECTOR(bounce_direction)
{
	ts_put_v3(out, ts_k_bounce_direction(ts_row_v3(in, 0u), ts_row_v3(in, 3u), ts_row_v3(in, 6u), ts_row_v3(in, 9u),
	                                     ts_row_v3(in, 12u), ts_row_f32(in, 15u), in[16]));
}

TS_VECTOR_WORD(depth_code, ts_k_depth_code(TS_A, TS_B))
TS_VECTOR_WORD(colour_code, ts_k_colour_code(ts_row_v3(in, 0u), ts_row_f32(in, 3u)))
TS_VECTOR_WORD(shared_code, ts_k_shared_code(ts_row_v3(in, 0u)))

#define TS_LIST_points_composites(VECTOR) \
	VECTOR(path_length) \
	VECTOR(ball_spread) \
	VECTOR(eye_density) \
	VECTOR(view_density) \
	VECTOR(cull_chance) \
	VECTOR(splat_box) \
	VECTOR(plane_distance) \
	VECTOR(sample_ray) \
	VECTOR(bounce_direction) \
	VECTOR(depth_code) \
	VECTOR(colour_code) \
	VECTOR(shared_code)
/* map over rows */
TS_VECTORS(points_composites)

#endif

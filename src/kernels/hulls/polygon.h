/* Lamps as polygons of light (SSAGH sections 3 and 5; METHODS 11): eight triangles each, in place of the disc or ball
 * on which soft shadows have samples. The disc of a light with a direction becomes a regular octagon of the same area,
 * which shines in that direction. The ball of a point light becomes a regular octahedron with the same surface: on
 * average over all directions it sends as much light as the ball, and in one direction as much within a fifth. A sun's
 * disc stands `away` from the middle of the scene. Exitance is I / r^2, so that far off, on the axis, the polygon has
 * the light's intensity I. Lambert's law takes the place of a spot light's cone. A lamp without extent has no
 * triangles: all fields are 0. */
#ifndef TS_KERNELS_HULLS_POLYGON_H
#define TS_KERNELS_HULLS_POLYGON_H
#include "kernels/base/shade.h"
#include "kernels/raster/patch.h"

#define TS_LAMP_TRIANGLES 8u

#define TS_ROWS_ts_polygon_args(ARG) \
	ARG(IN, ts_light, lamps, lamp_light) \
	ARG(IN, ts_lamp, shapes, lamp_shape) \
	ARG(OUT, ts_patch, patches, polygon_patch) \
	ARG(VALUE, ts_v3, middle, none) /* of the scene */ \
	ARG(VALUE, f32, away, none)     /* distance of suns from the middle, world units */
TS_ARGS(ts_polygon_args);

/* Triangle k of the octagon about p with the area of a disc of radius r: circumradius r sqrt(pi / (2 sqrt 2)). */
TS_FN void ts_k_polygon_disc(TS_GLOBAL ts_patch *patch, ts_v3 p, ts_v3 n, f32 r, u32 k)
{
	f32 reach = r * 1.0539073944091796875f;
	ts_v3 u = ts_scale(ts_k_across(n), reach);
	ts_v3 v = ts_cross(n, u);
	f32 from = (f32)k * 0.125f;
	f32 to = (f32)((k + 1u) % TS_LAMP_TRIANGLES) * 0.125f;
	ts_store3(patch->a, p);
	ts_store3(patch->b, ts_mad(ts_mad(p, u, ts_cos_turn(from)), v, ts_sin_turn(from)));
	ts_store3(patch->c, ts_mad(ts_mad(p, u, ts_cos_turn(to)), v, ts_sin_turn(to)));
	ts_store3(patch->normal, n);
}

/* Triangle k of the octahedron about p with the surface of a ball of radius r: circumradius r sqrt(pi / sqrt 3). */
TS_FN void ts_k_polygon_ball(TS_GLOBAL ts_patch *patch, ts_v3 p, f32 r, u32 k)
{
	/* Place a corner on each of the three half axes that the bits of k name. */
	f32 reach = r * 1.34677374362945556640625f;
	f32 x = (k & 1u) != 0u ? 1.0f : -1.0f;
	f32 y = (k & 2u) != 0u ? 1.0f : -1.0f;
	f32 z = (k & 4u) != 0u ? 1.0f : -1.0f;
	ts_v3 on_x = ts_mad(p, ts_v3_make(x, 0.0f, 0.0f), reach);
	ts_v3 on_y = ts_mad(p, ts_v3_make(0.0f, y, 0.0f), reach);
	ts_v3 on_z = ts_mad(p, ts_v3_make(0.0f, 0.0f, z), reach);
	/* Order them to turn left as seen from outside: an odd number of negative axes mirrors the triangle. */
	bool left = x * y * z > 0.0f;
	ts_store3(patch->a, on_x);
	ts_store3(patch->b, left ? on_y : on_z);
	ts_store3(patch->c, left ? on_z : on_y);
	/* Point the normal out of the octant, made a unit vector by 1 / sqrt 3. */
	ts_store3(patch->normal, ts_scale(ts_v3_make(x, y, z), 0.57735025882720947265625f));
}

/* map over triangles of lamps */
TS_FN void ts_k_polygon_item(const ts_polygon_args *args, u64 i)
{
	/* Find the lamp; one without extent has no triangles, and all fields stay 0. */
	TS_GLOBAL ts_patch *patch = &args->patches[i];
	TS_GLOBAL const ts_light *light = &args->lamps[i / TS_LAMP_TRIANGLES];
	f32 r = args->shapes[i / TS_LAMP_TRIANGLES].radius;
	f32 square = ts_flush(r * r);
	u32 k = (u32)(i % TS_LAMP_TRIANGLES);
	ts_k_patch_clear(patch);
	if (!(square > 0.0f)) return;
	/* Move a sun's disc far off, and scale it, so that the scene sees its disc at the same angle from everywhere. */
	ts_v3 p = ts_load3(light->position);
	ts_v3 n = ts_load3(light->direction);
	if (light->kind == TS_LIGHT_KIND_DIRECTIONAL) {
		p = ts_mad(args->middle, n, -args->away);
		r = r * args->away;
	}
	/* Make a triangle of a ball's octahedron, or of a disc's octagon. */
	if (light->kind == TS_LIGHT_KIND_POINT) {
		ts_k_polygon_ball(patch, p, r, k);
	} else {
		ts_k_polygon_disc(patch, p, n, r, k);
	}
	/* Set the exitance I / r^2. For a sun both I and r^2 would grow by away^2, which cancels. */
	ts_v3 intensity = ts_load3(light->intensity);
	ts_store3(patch->exitance, ts_v3_make(intensity.x / square, intensity.y / square, intensity.z / square));
}

#endif

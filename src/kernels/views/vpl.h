/* Virtual point lights (instant radiosity, Keller 1997; MegaViews section 4.1; METHODS 12). Paths begin at the texels
 * of the reflective shadow maps that reflect light, at all of them or at n random ones, with repetition; or at random
 * places on all surfaces, by area. A path leaves a light at its beginning and at each later reflection. Directions are
 * cosine-distributed, so that a reflection multiplies the flux by the albedo alone. Lights stand half a leaf's side
 * above the surface, since in the voxel of its own surface a light would be in its shadow (METHODS 13). */
#ifndef TS_KERNELS_VIEWS_VPL_H
#define TS_KERNELS_VIEWS_VPL_H
#include "kernels/base/args.h"
#include "kernels/base/shade.h"
#include "kernels/raster/patch.h"
#include "kernels/views/cast.h"
#include "kernels/views/vpl_area.h"

#define TS_ROWS_ts_vpl_args(ARG) \
	ARG(INNER, ts_cast_args, cast, none) \
	ARG(IN, ts_patch, patches, rsm_patch) \
	ARG(OUT, u32, offset, vpl_offset) /* counts, then their prefix sums */ \
	ARG(OUT, u32, paths, vpl_path)    /* counts, then their prefix sums */ \
	ARG(OUT, ts_vpl, lights, vpl_light) \
	ARG(IN_OPT, u32, areas, vpl_area) /* NULL: paths begin at texels */ \
	ARG(IN_OPT, ts_light, lamps, lamp_light) \
	ARG(VALUE, u32, n_lamps, none) \
	ARG(VALUE, u64, n_patches, none) \
	ARG(VALUE, u32, n_lit, none) /* patches that reflect light */ \
	ARG(VALUE, u32, n, none)     /* paths; n_lit unless random */ \
	ARG(VALUE, u32, random, none) \
	ARG(VALUE, u32, seed, none) \
	ARG(VALUE, u32, bounces, none)
TS_ARGS(ts_vpl_args);

/* A light in registers. */
typedef struct {
	ts_v3 p, n, flux;
	u32 bounce; /* 0: no light */
} ts_light_k;

#define TS_STREAM_VPL 4u
#define TS_VPL_PLACE 9u /* first random number of place and side; those of 4 bounces come before */

/* map over texels: 1 where a texel reflects light */
TS_FN void ts_k_vpl_count_item(const ts_vpl_args *args, u64 i)
{
	TS_GLOBAL const f32 *exitance = args->patches[i].exitance;
	args->offset[i] = exitance[0] > 0.0f || exitance[1] > 0.0f || exitance[2] > 0.0f ? 1u : 0u;
}

/* The texel that reflects light and has `rank` such texels before it, by binary search in their prefix sums. */
TS_FN u64 ts_k_vpl_texel(const ts_vpl_args *args, u32 rank)
{
	u64 low = 0u;
	u64 high = args->n_patches - 1u;
	while (low < high) {
		u64 middle = (low + high) / 2u;
		bool before = args->offset[middle + 1u] <= rank;
		low = before ? middle + 1u : low;
		high = before ? high : middle;
	}
	return low;
}

/* Random number `which` of a path. */
TS_FN u32 ts_k_vpl_random(const ts_vpl_args *args, u32 path, u32 which)
{
	return ts_random(path ^ ts_pcg(which), TS_STREAM_VPL, args->seed);
}

/* The texel at which a path begins. */
TS_FN u64 ts_k_vpl_start(const ts_vpl_args *args, u32 path)
{
	u32 chance = ts_k_vpl_random(args, path, 0u);
	return ts_k_vpl_texel(args, args->random != 0u ? (u32)(((u64)chance * args->n_lit) >> 32) : path);
}

/* The first light of a path that begins at a texel. */
TS_FN ts_light_k ts_k_vpl_of_texel(const ts_vpl_args *args, u32 path)
{
	/* Find the triangle of light at which the path begins, and its middle. */
	TS_GLOBAL const ts_patch *patch = &args->patches[ts_k_vpl_start(args, path)];
	ts_v3 a = ts_load3(patch->a);
	ts_v3 b = ts_load3(patch->b);
	ts_v3 c = ts_load3(patch->c);
	ts_v3 third = ts_k_hit_weights(0.0f, 0.0f, 0.0f);
	/* Find its area, and the number of lit texels for which the path stands. */
	f32 area = ts_length(ts_cross(ts_sub(b, a), ts_sub(c, a))) * 0.5f;
	f32 share = (f32)args->n_lit / (f32)args->n;
	/* Place the light half a leaf above the surface, with the flux exitance times area. */
	ts_light_k r;
	r.n = ts_load3(patch->normal);
	r.p = ts_mad(ts_blend(third, a, b, c), r.n, args->cast.leaf * 0.5f);
	r.flux = ts_scale(ts_load3(patch->exitance), ts_flush(area * share));
	r.bounce = 1u;
	return r;
}

/* Whether nothing is between a lamp and a place on a triangle. The ray begins at the lamp, like the lamp's map, so the
 * backs of single-sided triangles let light pass. A hit within 2^-12 of the distance counts as the place itself. The
 * ray of a sun begins outside the scene. */
TS_FN bool ts_k_vpl_is_lit(const ts_cast_args *cast, TS_GLOBAL const ts_light *lamp, u32 triangle, ts_v3 p)
{
	ts_v3 away = ts_scale(ts_load3(lamp->direction), -4.0f * cast->nodes[0].radius);
	ts_v3 from = lamp->kind == TS_LIGHT_KIND_DIRECTIONAL ? ts_add(p, away) : ts_load3(lamp->position);
	ts_v3 way = ts_sub(p, from);
	ts_cast_hit hit = ts_k_cast(cast, from, ts_normalize(way));
	return hit.triangle == triangle || hit.t >= ts_length(way) * 0.999755859375f;
}

/* The irradiance of a place on a triangle from all lamps. */
TS_FN ts_v3 ts_k_vpl_received(const ts_vpl_args *args, u32 triangle, ts_v3 p, ts_v3 n)
{
	ts_v3 sum = ts_v3_make(0.0f, 0.0f, 0.0f);
	for (u32 k = 0u; k < args->n_lamps; k++) {
		TS_GLOBAL const ts_light *lamp = &args->lamps[k];
		ts_v3 l;
		f32 arrives = ts_k_light(lamp, p, &l);
		f32 cosine = ts_flush(ts_dot(n, l));
		if (!(arrives > 0.0f) || !(cosine > 0.0f) || !ts_k_vpl_is_lit(&args->cast, lamp, triangle, p)) continue;
		sum = ts_mad(sum, ts_load3(lamp->intensity), ts_flush(arrives * cosine));
	}
	return sum;
}

/* Weights of a random place in a triangle, uniform by area (Turk 1990). */
TS_FN ts_v3 ts_k_vpl_weights(const ts_vpl_args *args, u32 path)
{
	f32 across = ts_sqrt(ts_uniform(ts_k_vpl_random(args, path, TS_VPL_PLACE)));
	f32 along = ts_uniform(ts_k_vpl_random(args, path, TS_VPL_PLACE + 1u));
	f32 c = across * along;
	return ts_k_hit_weights(1.0f - across, across - c, c);
}

/* The triangle of a path that begins at random on the surfaces. */
TS_FN u32 ts_k_vpl_surface(const ts_vpl_args *args, u32 path)
{
	u32 n = args->cast.scene.n_triangles;
	u64 chance = ts_k_vpl_random(args, path, 0u);
	return ts_k_vpl_triangle(args->areas, n, (u32)((chance * args->areas[n]) >> 32));
}

/* The first light of a path that begins at random, on either side of a two-sided surface; none where a mask cuts the
 * surface away. Its flux is the reflected irradiance times the triangle's area over the expected number of paths that
 * begin there. */
TS_FN ts_light_k ts_k_vpl_anywhere(const ts_vpl_args *args, u32 path)
{
	/* Choose a triangle by area, a place on it, and a side, all uniformly. */
	const ts_arrays *scene = &args->cast.scene;
	u32 triangle = ts_k_vpl_surface(args, path);
	ts_corners t = ts_k_corners(scene, triangle);
	ts_v3 weights = ts_k_vpl_weights(args, path);
	ts_surface s = ts_k_surface(scene, triangle, weights, args->cast.leaf);
	bool back = ts_k_is_two_sided(scene, triangle) && (ts_k_vpl_random(args, path, TS_VPL_PLACE + 2u) & 1u) != 0u;
	/* Find the area for which the path stands: the triangle's over the expected number of paths that begin on it. */
	f32 parts = (f32)(args->areas[triangle + 1u] - args->areas[triangle]);
	f32 shares = parts > 0.0f ? (f32)args->areas[scene->n_triangles] / parts : 0.0f;
	f32 area = ts_flush(ts_k_vpl_sides(scene, triangle, &t) * shares) / (f32)args->n;
	/* Place the light half a leaf above the chosen side; holes of masks have none. */
	ts_light_k r;
	r.n = back ? ts_neg(s.face) : s.face;
	r.p = ts_mad(s.p, r.n, args->cast.leaf * 0.5f);
	r.bounce = ts_k_is_cut(scene, triangle, weights, t.n, args->cast.leaf) ? 0u : 1u;
	/* Send on the lamps' irradiance, times albedo and area. */
	r.flux = ts_scale(ts_mul(ts_k_albedo(&s), ts_k_vpl_received(args, triangle, s.p, r.n)), ts_flush(area));
	return r;
}

/* The first light of a path. */
TS_FN ts_light_k ts_k_vpl_first(const ts_vpl_args *args, u32 path)
{
	return args->areas != NULL ? ts_k_vpl_anywhere(args, path) : ts_k_vpl_of_texel(args, path);
}

/* A direction that is cosine-distributed about n (Malley's method): a uniform point of the unit disc across n,
 * projected up to the sphere. */
TS_FN ts_v3 ts_k_vpl_direction(const ts_vpl_args *args, u32 path, u32 bounce, ts_v3 n)
{
	f32 square = ts_uniform(ts_k_vpl_random(args, path, 2u * bounce - 1u));
	f32 turn = ts_uniform(ts_k_vpl_random(args, path, 2u * bounce));
	ts_v3 u = ts_k_across(n);
	ts_v3 v = ts_cross(n, u);
	f32 r = ts_sqrt(square);
	f32 up = ts_sqrt(1.0f - square);
	ts_v3 across = ts_mad(ts_scale(u, r * ts_cos_turn(turn)), v, r * ts_sin_turn(turn));
	return ts_normalize(ts_mad(across, n, up));
}

/* The next light of a path; false if the path leaves the scene or meets a black surface. */
TS_FN bool ts_k_vpl_next(const ts_vpl_args *args, u32 path, ts_light_k *light)
{
	ts_v3 d = ts_k_vpl_direction(args, path, light->bounce, light->n);
	ts_cast_hit hit = ts_k_cast(&args->cast, light->p, d);
	if (hit.triangle == TS_NONE) return false;
	ts_surface s = ts_k_surface(&args->cast.scene, hit.triangle, hit.weights, args->cast.leaf);
	light->n = ts_dot(s.face, d) > 0.0f ? ts_neg(s.face) : s.face;
	light->p = ts_mad(s.p, light->n, args->cast.leaf * 0.5f);
	light->flux = ts_mul(light->flux, ts_k_albedo(&s));
	light->bounce++;
	return light->flux.x > 0.0f || light->flux.y > 0.0f || light->flux.z > 0.0f;
}

/* map over paths: number of lights that each leaves */
TS_FN void ts_k_vpl_path_item(const ts_vpl_args *args, u64 i)
{
	ts_light_k light = ts_k_vpl_first(args, (u32)i);
	u32 n = light.bounce;
	while (n > 0u && n < args->bounces && ts_k_vpl_next(args, (u32)i, &light)) n++;
	args->paths[i] = n;
}

TS_FN void ts_k_vpl_store(TS_GLOBAL ts_vpl *to, const ts_light_k *light)
{
	ts_store3(to->position, light->p);
	ts_store3(to->normal, light->n);
	ts_store3(to->flux, light->flux);
	to->bounce = light->bounce;
	to->pad0 = 0u;
	to->pad1 = 0u;
}

/* emit over paths */
TS_FN void ts_k_vpl_item(const ts_vpl_args *args, u64 i)
{
	if (args->paths[i + 1u] == args->paths[i]) return;
	ts_light_k light = ts_k_vpl_first(args, (u32)i);
	TS_GLOBAL ts_vpl *to = args->lights + args->paths[i];
	ts_k_vpl_store(to, &light);
	for (u32 k = 1u; k < args->paths[i + 1u] - args->paths[i]; k++) {
		ts_k_vpl_next(args, (u32)i, &light);
		ts_k_vpl_store(to + k, &light);
	}
}

#endif

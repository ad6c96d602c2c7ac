/* Off-screen buffers compared with rays through the centres of their texels: holes, leaks and wrong depths (METHODS
 * 17).
 *
 * The theorem behind density.rate=watertight: let the ray hit triangle t, in front, at x. The squares of the lattice of
 * t's piece cover it, so x is in one whose sample, moved to the piece if need be, is within sqrt(1/2) / s of x. No
 * segment of that length on t is longer than half a texel in the image, so t has a sample within half a texel of the
 * centre, which is in the texel. So the texel is not empty, and holds nothing farther than t anywhere within half a
 * texel of its centre. That holds for all triangles that are neither culled, nor capped, nor masked; not for their
 * parts before the near plane. */
#include <float.h>
#include <math.h>
#include <omp.h>
#include "kernels/points/colour_code.h"
#include "kernels/raster/shadow_map.h"
#include "methods/points/tools/tools.h"
#include "methods/stages.h"
#include "truth/sampling.h"
#include "truth/truth.h"

#define ROUNDING 1.00001

enum { STREAM_TEXELS = 11, SHARE = 4 }; /* of ts_random; one in SHARE of params.truth_rays is for texels */

/* A texel's depth, or the interval of its code; radial in environment maps, otherwise axial. */
typedef struct {
	double least, most;
	bool any;
} held;

typedef struct {
	const ts_truth *truth;
	const ts_arrays *scene;
	ts_shadow_test_args rule; /* whose bias is used */
	const void *texels;       /* of the batch */
	ts_buffer_id id;
	u64 first_texel;
	u32 one_of, seed; /* one texel in one_of is judged */
	int n_threads;
} judge;

/* One view: what it sees, without triangles of reflector `masked`. */
typedef struct {
	ts_camera_k camera;
	u64 offset;
	u32 masked;
} window;

static held held_depth(u32 bits)
{
	double z = bits != TS_NONE ? (double)ts_u2f(bits) : 0;
	return (held){z, z, bits != TS_NONE};
}

/* The ends of the interval of a logarithmic code; the last one has no end. */
static held held_colour(u32 code, f32 near)
{
	double step = (double)TS_FAR_BITS / 8191, q = code >> 19;
	double most = q < 8190 ? (double)near * exp2(step * (q + 1)) * ROUNDING : DBL_MAX;
	return (held){(double)near * exp2(step * q) / ROUNDING, most, code != TS_NONE};
}

static held held_in(const judge *j, u64 texel, f32 near)
{
	switch (j->id) {
	case TS_B_depth_map_depth: return held_depth(((const u32 *)j->texels)[texel]);
	case TS_B_scatter_colour: return held_colour(((const u32 *)j->texels)[texel], near);
	default: return held_depth((u32)(((const u64 *)j->texels)[texel] >> 32));
	}
}

static ts_truth_query ray_through(const window *w, u32 x, u32 y)
{
	const ts_camera_k *view = &w->camera;
	bool parallel = view->orthographic != 0;
	f32 right = ((f32)x + 0.5f - (f32)view->width * 0.5f) / view->focal;
	f32 up = ((f32)view->height * 0.5f - (f32)y - 0.5f) / view->focal;
	ts_v3 aside = ts_mad(ts_scale(view->right, right), view->up, up);
	ts_v3 ahead = parallel ? ts_neg(view->back) : ts_sub(aside, view->back);
	ts_v3 from = parallel ? ts_add(view->eye, aside) : view->eye;
	return (ts_truth_query){.origin = from,
	                        .direction = ts_normalize(ahead),
	                        .near = view->near * ts_length(ahead),
	                        .masked = w->masked,
	                        .from = from,
	                        .spread = parallel ? 0.0f : 1.0f / view->focal};
}

/* The greatest factor by which the depth of a triangle's plane grows within half a texel: 1/z is linear in the image;
 * in orthographic views z itself is. Infinite if the plane is seen on edge within half a texel. */
static double farther(const ts_camera_k *view, const ts_corners *t, const ts_truth_query *ray, double z)
{
	double x = (double)ts_dot(view->right, t->n), y = (double)ts_dot(view->up, t->n);
	double turn = 0.5 * hypot(x, y) / (double)view->focal;
	if (view->orthographic != 0) return 1 + turn / fabs((double)ts_dot(view->back, t->n)) / z;
	double ahead = -(double)ts_dot(view->back, ray->direction);
	double facing = fabs((double)ts_dot(t->n, ray->direction)) / ahead;
	return turn < facing ? facing / (facing - turn) : INFINITY;
}

static double deepest_corner(const ts_camera_k *view, const ts_corners *t)
{
	f32 z = ts_max(ts_k_to_view(view, t->a).z, ts_k_to_view(view, t->b).z);
	return (double)ts_max(z, ts_k_to_view(view, t->c).z);
}

/* Compares the texel with the triangle that its ray hits at t. */
static ts_texel_counts compare(const judge *j, const ts_camera_k *view, const ts_truth_query *ray,
                               const ts_truth_hit *hit, held has)
{
	if (!has.any) return (ts_texel_counts){.covered = 1, .holes = 1};
	ts_corners corner = ts_k_corners(j->scene, hit->triangle);
	ts_receiver at = {ts_mad(ray->origin, ray->direction, hit->t), ts_normalize(corner.n), true};
	double z = (double)(hit->t * -ts_dot(view->back, ray->direction));
	double bias = (double)ts_k_shadow_bias(&j->rule, view, &at, (f32)z);
	double reach = fmin(z * farther(view, &corner, ray, z), deepest_corner(view, &corner));
	bool is_radial = j->id == TS_B_scatter_colour;
	double radial = is_radial ? (double)hit->t / z : 1;
	double slant = is_radial ? 1 + 0.5 / (double)view->focal : 1; /* for the radial distance, half a texel away */
	double limit = fmax(z + bias, reach * slant) * radial * ROUNDING;
	bool apart = has.least > (z + bias) * radial * ROUNDING || has.most < (z - bias) * radial / ROUNDING;
	return (ts_texel_counts){.covered = 1, .leaks = has.least > limit, .apart = apart};
}

static ts_texel_counts judge_texel(const judge *j, const window *w, u32 x, u32 y)
{
	u64 at = w->offset + (u64)y * (u64)w->camera.width + x;
	if (j->one_of > 1 && ts_random((u32)at, STREAM_TEXELS, j->seed) % j->one_of != 0) return (ts_texel_counts){0};
	ts_truth_query ray = ray_through(w, x, y);
	ts_truth_hit hit = ts_truth_cast(j->truth, &ray);
	bool counts = hit.triangle != TS_NONE &&
	              (j->scene->materials[j->scene->triangles[hit.triangle].material].flags & TS_MASKED) == 0;
	if (!counts) return (ts_texel_counts){0};
	return compare(j, &w->camera, &ray, &hit, held_in(j, at - j->first_texel, w->camera.near));
}

static void judge_view(const judge *j, const window *w, ts_texel_counts *counts)
{
	u64 covered = 0, holes = 0, leaks = 0, apart = 0;
#pragma omp parallel for num_threads(j->n_threads) schedule(dynamic, 4) reduction(+ : covered, holes, leaks, apart)
	for (i32 y = 0; y < w->camera.height; y++) {
		for (i32 x = 0; x < w->camera.width; x++) {
			ts_texel_counts one = judge_texel(j, w, (u32)x, (u32)y);
			covered += one.covered;
			holes += one.holes;
			leaks += one.leaks;
			apart += one.apart;
		}
	}
	counts->covered += covered;
	counts->holes += holes;
	counts->leaks += leaks;
	counts->apart += apart;
}

static u32 reflector_of(const judge *j, u32 object)
{
	return object != TS_NONE ? j->scene->objects[object].reflector : TS_NONE;
}

static window face_of(const judge *j, const ts_face *cube, u32 face)
{
	u64 first = cube->offset + (u64)face * cube->n * cube->n;
	return (window){ts_k_cube_view(cube, face), first, reflector_of(j, cube->object)};
}

/* Texels of all views of the run, not only of this batch. */
static u64 n_texels(const ts_run *run, const ts_face *faces, const ts_offscreen *views)
{
	u64 n = 0;
	for (u32 u = 0; u < run->plan.units; u++) {
		n += faces != NULL ? 6 * (u64)faces[u].n * faces[u].n : (u64)views[u].width * views[u].height;
	}
	return n;
}

ts_status ts_truth_texels(ts_texel_counts *counts, ts_truth *truth, const ts_run *run, ts_buffer_id id)
{
	if (run->n_units == 0) return TS_OK;
	bool cubes = ts_run_has_cubes(run);
	const ts_face *faces = cubes ? ts_frame_data(&run->frame, TS_B_cube_size_face) : NULL;
	const ts_offscreen *views = cubes ? NULL : ts_frame_data(&run->frame, TS_B_offscreen_view);
	u64 all = n_texels(run, faces, views), rays = TS_PARAM(&run->params, truth_rays), most = (rays + SHARE - 1) / SHARE;
	u64 one_of = most > 0 ? (all + most - 1) / most : 1;
	judge j = {
		.truth = truth,
		.scene = ts_truth_scene(truth),
		.id = id,
		.n_threads = (int)run->c.threads,
		.rule = {.bias = TS_PARAM(&run->params, depth_map_bias), .slope = TS_PARAM(&run->params, depth_map_bias_slope)},
		.first_texel = cubes ? faces[run->first_unit].offset : views[run->first_unit].offset,
		.one_of = one_of < TS_NONE ? (u32)one_of : TS_NONE,
		.seed = TS_PARAM(&run->params, seed),
		.texels = ts_frame_data(&run->frame, id)};
	ts_work work = ts_work_begin("texels against rays", all / (j.one_of > 0 ? j.one_of : 1));
	for (u32 u = 0; u < run->n_units; u++) {
		u32 unit = run->first_unit + u;
		for (u32 face = 0; face < (cubes ? 6u : 1u); face++) {
			window w = cubes ? face_of(&j, &faces[unit], face)
			                 : (window){ts_k_offscreen(&views[unit]), views[unit].offset,
			                            reflector_of(&j, views[unit].object)};
			judge_view(&j, &w, counts);
		}
		if (run->first_unit == 0) ts_work_at(&work, u + 1, run->plan.units);
	}
	ts_work_end(&work);
	if (j.one_of > 1) counts->one_of = j.one_of;
	return TS_OK;
}

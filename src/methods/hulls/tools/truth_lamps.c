/* Truths of the light of lamps (METHODS 17). `exact` has no shadows, as hulls have none: form factors of the lamps'
 * triangles in double precision. `shadowed` multiplies these by the share of each triangle that the pixel sees, by rays
 * to truth.area_samples places, a lamp's divided among its triangles. A place is weighted by its unoccluded light, cos
 * cos' / r^2, so that rays only decide visibility.
 *
 * With gloss.lobe both have specular reflection, too: the BRDF in double precision (truth_gloss.c) in place of the
 * cosine.
 *
 * Places form a lattice whose steps are the powers of the root of x^3 = x + 1, folded into the triangle, at a random
 * shift per pixel. */
#include "kernels/hulls/direct.h"
#include "kernels/hulls/polygon.h"
#include "methods/hulls/gloss.h"
#include "methods/hulls/tools/tools.h"
#include "methods/hulls/tools/truth_gloss.h"
#include "methods/raster/tools/truth_gather.h"

typedef struct {
	const ts_truth *truth; /* NULL: nothing blocks light */
	const ts_patch *patches;
	u64 n_patches;
	const ts_light *lamps;
	const ts_lamp *shapes;
	u32 n_lamps;
	const ts_gloss *gloss; /* of the pixels; NULL: light that arrives is computed, not specular reflection */
	ts_v3 eye;
} tracer;

/* A surface that receives or reflects light. */
typedef struct {
	ts_v3 p;
	u32 pixel, n_rays; /* rays per triangle */
	bool reflects;
	ts_truth_glossy glossy; /* if it does not reflect, n alone */
} receiver;

/* Lambert's sum over the edges of the part above the horizon of n, from corners relative to the surface. */
static double form_factor(ts_double3 n, const ts_double3 corner[3])
{
	ts_double3 above[6];
	u32 count = 0;
	double sum = 0;
	for (u32 i = 0; i < 3; i++) {
		ts_double3 p = corner[i], q = corner[(i + 1) % 3];
		double dp = ts_double3_dot(n, p), dq = ts_double3_dot(n, q);
		if (dp >= 0) above[count++] = p;
		if ((dp >= 0) != (dq >= 0)) above[count++] = ts_double3_mix(p, q, dp / (dp - dq));
	}
	for (u32 i = 0; i < count; i++) {
		ts_double3 p = above[i], q = above[(i + 1) % count], across = ts_double3_cross(p, q);
		double length = sqrt(ts_double3_dot(across, across));
		if (length > 0) sum += ts_double3_dot(across, n) / length * atan2(length, ts_double3_dot(p, q));
	}
	return fabs(sum) / (2 * TS_PI);
}

/* Response of a surface to light from l, per unit of irradiance on a surface that faces it: red, green, blue. */
static ts_double3 taken(const receiver *at, ts_double3 l)
{
	if (at->reflects) return ts_truth_gloss_brdf(&at->glossy, l);
	double cosine = fmax(0, ts_double3_dot(at->glossy.n, l));
	return (ts_double3){cosine, cosine, cosine};
}

/* The same for a triangle relative to the surface, per unit of its exitance. */
static ts_double3 taken_of_triangle(const receiver *at, const ts_double3 corner[3])
{
	if (at->reflects) {
		ts_double3 none = {0, 0, 0};
		return ts_double3_mad(none, ts_truth_gloss_triangle(&at->glossy, corner), 1 / TS_PI);
	}
	double factor = form_factor(at->glossy.n, corner);
	return (ts_double3){factor, factor, factor};
}

static double sum_of(ts_double3 a) { return a.x + a.y + a.z; }

/* The share of a triangle that the pixel sees, weighted by each place's unoccluded light. */
static double seen(const tracer *t, const ts_patch *patch, const receiver *at)
{
	ts_v3 p = at->p;
	f32 s = ts_uniform(ts_random(at->pixel, 7, 0)), r = ts_uniform(ts_random(at->pixel, 7, 1));
	ts_double3 front = ts_double3_of(ts_load3(patch->normal));
	double all = 0, lit = 0;
	for (u32 k = 0; k < at->n_rays; k++) {
		f32 u = s + 0.7548777f * (f32)k, v = r + 0.56984029f * (f32)k;
		u -= ts_floor(u);
		v -= ts_floor(v);
		bool over = u + v > 1.0f;
		ts_v3 w = {over ? 1.0f - u : u, over ? 1.0f - v : v, 0};
		w.z = 1.0f - w.x - w.y;
		ts_v3 place = ts_blend(w, ts_load3(patch->a), ts_load3(patch->b), ts_load3(patch->c));
		ts_double3 way = ts_double3_from_to(p, place), l = ts_double3_unit(way);
		double gives = sum_of(taken(at, l)) * fmax(0, -ts_double3_dot(front, l)) / ts_double3_dot(way, way);
		if (!(gives > 0)) continue;
		all += gives;
		if (ts_truth_sees(t->truth, p, place, ts_truth_skip(place))) lit += gives;
	}
	return all > 0 ? lit / all : 0;
}

static ts_double3 of_triangle(const tracer *t, const ts_patch *patch, const receiver *at)
{
	const ts_double3 none = {0, 0, 0}, corner[3] = {ts_double3_from_to(at->p, ts_load3(patch->a)),
	                                                ts_double3_from_to(at->p, ts_load3(patch->b)),
	                                                ts_double3_from_to(at->p, ts_load3(patch->c))};
	if (!ts_k_is_in_front(at->p, ts_load3(patch->a), ts_load3(patch->normal))) return none;
	ts_double3 all = taken_of_triangle(at, corner);
	return sum_of(all) > 0 && t->truth != NULL ? ts_double3_mad(none, all, seen(t, patch, at)) : all;
}

/* A sun without extent gets the distance that its triangles would have. */
static bool sees_point(const tracer *t, const ts_light *light, ts_v3 p)
{
	if (t->truth == NULL) return true;
	if (light->kind != TS_LIGHT_KIND_DIRECTIONAL) return ts_truth_sees(t->truth, p, ts_load3(light->position), 0.0f);
	ts_truth_query ray = {.origin = p,
	                      .direction = ts_neg(ts_load3(light->direction)),
	                      .near = ts_truth_skip(p),
	                      .masked = TS_NONE,
	                      .from = p};
	return ts_truth_cast(t->truth, &ray).triangle == TS_NONE;
}

static ts_double3 of_point(const tracer *t, const ts_light *light, const receiver *at)
{
	ts_v3 way;
	const ts_double3 none = {0, 0, 0};
	double arrives = (double)ts_k_light(light, at->p, &way);
	ts_double3 all = ts_double3_mad(none, taken(at, ts_double3_of(way)), arrives);
	return sum_of(all) > 0 && sees_point(t, light, at->p) ? all : none;
}

static ts_double3 add(ts_double3 sum, ts_double3 share, const f32 light[3])
{
	return (ts_double3){sum.x + share.x * (double)light[0], sum.y + share.y * (double)light[1],
	                    sum.z + share.z * (double)light[2]};
}

static ts_v3 from_lamps(const void *user, const ts_share *share, ts_v3 p, ts_v3 n)
{
	const tracer *t = user;
	ts_double3 sum = {0, 0, 0};
	receiver at = {.p = p,
	               .pixel = share->pixel,
	               .n_rays = (u32)share->asked,
	               .reflects = t->gloss != NULL,
	               .glossy = {.n = ts_double3_of(n)}};
	if (at.reflects) at.glossy = ts_truth_glossy_of(&t->gloss[share->pixel], p, n, t->eye);
	for (u64 k = 0; k < t->n_patches; k++) {
		sum = add(sum, of_triangle(t, &t->patches[k], &at), t->patches[k].exitance);
	}
	for (u32 k = 0; k < t->n_lamps; k++) {
		if (!(t->shapes[k].radius > 0)) sum = add(sum, of_point(t, &t->lamps[k], &at), t->lamps[k].intensity);
	}
	return ts_double3_round(sum);
}

/* Casts `items` rays to each triangle. */
static ts_status trace(const ts_truth *truth, ts_run *run, ts_sampling *sampling, u64 items, const char *label)
{
	tracer t = {
		.truth = truth,
		.patches = ts_frame_data(&run->frame, TS_B_polygon_patch),
		.n_patches = ts_frame_n(&run->frame, TS_B_polygon_patch),
		.lamps = ts_frame_data(&run->frame, TS_B_lamp_light),
		.shapes = ts_frame_data(&run->frame, TS_B_lamp_shape),
		.n_lamps = (u32)ts_frame_n(&run->frame, TS_B_lamp_light),
	};
	bool glossy = ts_gloss_is_asked(&run->params);
	u64 each = truth == NULL ? 0 : t.n_patches * (glossy ? 2 : 1);
	const ts_truth_gathered of = {label, from_lamps, &t, items, each};
	if (ts_truth_gather(run, TS_B_indirect_irradiance, &of, sampling) != TS_OK) return TS_ERROR;
	if (!glossy) return TS_OK;
	if (ts_truth_gloss(run, &t.gloss, &t.eye) != TS_OK) return TS_ERROR;
	return ts_truth_gather(run, TS_B_indirect_specular, &of, sampling);
}

ts_status ts_truth_lamps_begin(ts_run *run, const char *effect)
{
	static const ts_buffer_id needs[] = {TS_B_polygon_patch, TS_B_gbuffer_pixel, TS_N_BUFFERS};
	return ts_truth_begin(run, effect, needs);
}

ts_status ts_truth_lamps_exact(ts_truth *truth, ts_run *run, ts_sampling *sampling)
{
	(void)truth;
	return trace(NULL, run, sampling, 1, "truth exact");
}

ts_status ts_truth_lamps_shadowed(ts_truth *truth, ts_run *run, ts_sampling *sampling)
{
	u32 n_rays = TS_PARAM(&run->params, truth_area_samples) / TS_LAMP_TRIANGLES;
	return trace(truth, run, sampling, n_rays > 0 ? n_rays : 1, "truth shadowed");
}

/* Truths of the light of lamps (METHODS 17). `exact` has no shadows, as hulls have none: form factors of the lamps'
 * triangles in double precision. `shadowed` has: of each triangle it is that by the share of the triangle which the
 * pixel sees, by rays to truth.area_samples places, a lamp's shared out among its triangles. A place counts by what it
 * would give, cos cos' / r^2, so that rays say what is hidden, and nothing else.
 *
 * Places are those of a lattice whose steps are the powers of the root of x^3 = x + 1, folded into the triangle, at a
 * random shift a pixel. */
#include <math.h>
#include "../../../kernels/hulls/polygon.h"
#include "../../../kernels/hulls/direct.h"
#include "../../raster/tools/truth_gather.h"
#include "../../stages.h"
#include "tools.h"

#define PI 3.14159265358979323846

typedef struct {
	double x, y, z;
} vec;

typedef struct {
	const ts_truth *truth; /* NULL: nothing is in the way */
	const ts_patch *patches;
	u64 n_patches;
	const ts_light *lamps;
	const ts_lamp *shapes;
	u32 n_lamps, n_rays; /* rays to a triangle */
} tracer;

static vec from_to(ts_v3 p, const f32 to[3])
{
	return (vec){(double)to[0] - (double)p.x, (double)to[1] - (double)p.y, (double)to[2] - (double)p.z};
}
static double dot(vec a, vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static vec cross(vec a, vec b) { return (vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
static vec mix(vec a, vec b, double t)
{
	return (vec){a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}

/* Lambert's sum over the edges of what is above the horizon of n, by the corners seen from the surface. */
static double form_factor(vec n, const vec corner[3])
{
	vec above[6];
	u32 count = 0;
	double sum = 0;
	for (u32 i = 0; i < 3; i++) {
		vec p = corner[i], q = corner[(i + 1) % 3];
		double dp = dot(n, p), dq = dot(n, q);
		if (dp >= 0) above[count++] = p;
		if ((dp >= 0) != (dq >= 0)) above[count++] = mix(p, q, dp / (dp - dq));
	}
	for (u32 i = 0; i < count; i++) {
		vec p = above[i], q = above[(i + 1) % count], across = cross(p, q);
		double length = sqrt(dot(across, across));
		if (length > 0) sum += dot(across, n) / length * atan2(length, dot(p, q));
	}
	return fabs(sum) / (2 * PI);
}

/* How much of a triangle the pixel sees, weighed by what each place gives. */
static double seen(const tracer *t, const ts_patch *patch, ts_v3 p, vec n, u32 pixel)
{
	f32 s = ts_uniform(ts_random(pixel, 7, 0)), r = ts_uniform(ts_random(pixel, 7, 1));
	double all = 0, lit = 0;
	for (u32 k = 0; k < t->n_rays; k++) {
		f32 u = s + 0.7548777f * (f32)k, v = r + 0.56984029f * (f32)k;
		u -= ts_floor(u);
		v -= ts_floor(v);
		bool over = u + v > 1.0f;
		ts_v3 w = {over ? 1.0f - u : u, over ? 1.0f - v : v, 0};
		w.z = 1.0f - w.x - w.y;
		f32 at[3];
		ts_v3 place = ts_blend(w, ts_load3(patch->a), ts_load3(patch->b), ts_load3(patch->c));
		ts_store3(at, place);
		vec way = from_to(p, at), normal = {patch->normal[0], patch->normal[1], patch->normal[2]};
		double square = dot(way, way), gives = fmax(0, dot(n, way)) * fmax(0, -dot(normal, way)) / (square * square);
		if (!(gives > 0)) continue;
		all += gives;
		if (ts_truth_sees(t->truth, p, place, ts_truth_skip(place))) lit += gives;
	}
	return all > 0 ? lit / all : 0;
}

static double share_of(const tracer *t, const ts_patch *patch, u64 pixel, ts_v3 p, ts_v3 n)
{
	const vec corner[3] = {from_to(p, patch->a), from_to(p, patch->b), from_to(p, patch->c)};
	vec normal = {(double)n.x, (double)n.y, (double)n.z};
	vec front = {patch->normal[0], patch->normal[1], patch->normal[2]};
	if (!(dot(front, corner[0]) < 0)) return 0;
	double factor = form_factor(normal, corner);
	return factor > 0 && t->truth != NULL ? factor * seen(t, patch, p, normal, (u32)pixel) : factor;
}

/* A sun without extent is as far as its triangles would be. */
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

static ts_v3 from_lamps(const void *user, u64 pixel, ts_v3 p, ts_v3 n)
{
	const tracer *t = user;
	double sum[3] = {0};
	for (u64 k = 0; k < t->n_patches; k++) {
		const ts_patch *patch = &t->patches[k];
		double share = share_of(t, patch, pixel, p, n);
		for (u32 c = 0; c < 3; c++) sum[c] += share * (double)patch->exitance[c];
	}
	for (u32 k = 0; k < t->n_lamps; k++) {
		if (t->shapes[k].radius > 0) continue;
		ts_v3 light = ts_k_direct_point(&t->lamps[k], p, n);
		if (!(light.x + light.y + light.z > 0) || !sees_point(t, &t->lamps[k], p)) continue;
		sum[0] += (double)light.x;
		sum[1] += (double)light.y;
		sum[2] += (double)light.z;
	}
	return ts_v3_make((f32)sum[0], (f32)sum[1], (f32)sum[2]);
}

static ts_status trace(const ts_truth *truth, ts_run *run, u32 n_rays, const char *label)
{
	const tracer t = {
		.truth = truth,
		.patches = ts_frame_data(&run->frame, TS_B_polygon_patch),
		.n_patches = ts_frame_n(&run->frame, TS_B_polygon_patch),
		.lamps = ts_frame_data(&run->frame, TS_B_lamp_light),
		.shapes = ts_frame_data(&run->frame, TS_B_lamp_shape),
		.n_lamps = (u32)ts_frame_n(&run->frame, TS_B_lamp_light),
		.n_rays = n_rays,
	};
	return ts_truth_gather(run, from_lamps, &t, label);
}

ts_status ts_truth_lamps_begin(ts_run *run, const char *effect)
{
	static const ts_buffer_id needs[] = {TS_B_polygon_patch, TS_B_gbuffer_pixel, TS_N_BUFFERS};
	return ts_truth_begin(run, effect, needs);
}

ts_status ts_truth_lamps_exact(ts_truth *truth, ts_run *run)
{
	(void)truth;
	return trace(NULL, run, 0, "truth exact");
}

ts_status ts_truth_lamps_shadowed(ts_truth *truth, ts_run *run)
{
	u32 n_rays = TS_PARAM(&run->params, truth_area_samples) / TS_LAMP_TRIANGLES;
	return trace(truth, run, n_rays > 0 ? n_rays : 1, "truth shadowed");
}

/* Rays into the triangles: Embree finds the nearest, our own kernel measures the hit (METHODS 17). Such rays also ask
 * whether two points see each other.
 * Filters apply the rasters' rules: facing by the ray's origin, alpha at the hit's footprint, the masked reflector. */
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "kernels/base/surface.h"
#include "truth/parts.h"
#include "truth/truth.h"

enum { BATCH = 16 * TS_TRUTH_PACKET, ONE_OF = 16 };

const ts_arrays *ts_truth_scene(const ts_truth *truth) { return &truth->scene; }

static ts_truth_hit measure(const ts_truth *truth, const ts_truth_query *query, u32 triangle)
{
	ts_corners corner = ts_k_corners(&truth->scene, triangle);
	ts_hit hit = ts_k_hit(query->origin, query->direction, &corner);
	ts_v3 q = ts_blend(hit.weights, corner.a, corner.b, corner.c);
	f32 path = query->path + ts_length(ts_sub(query->from, q));
	return (ts_truth_hit){triangle, hit.t, hit.weights, query->spread * path, path};
}

static u32 flags_of(const ts_truth *truth, u32 triangle)
{
	return truth->scene.materials[truth->scene.triangles[triangle].material].flags;
}

bool ts_truth_is_cut(const ts_truth *truth, const ts_truth_query *query, u32 triangle, ts_v3 normal)
{
	ts_truth_hit hit = measure(truth, query, triangle);
	return ts_k_is_cut(&truth->scene, triangle, hit.weights, normal, hit.footprint);
}

static bool passes(const ts_truth *truth, const ts_truth_query *query, u32 triangle)
{
	if (query->masked != TS_NONE && ts_k_reflector_of(&truth->scene, triangle) == query->masked) return false;
	ts_corners corner = ts_k_corners(&truth->scene, triangle);
	if (!ts_k_is_facing(&truth->scene, triangle, &corner, query->origin)) return false;
	if (query->whole || (flags_of(truth, triangle) & TS_MASKED) == 0) return true;
	return !ts_truth_is_cut(truth, query, triangle, corner.n);
}

/* For single rays, one lane at a time. */
static void filter(const struct RTCFilterFunctionNArguments *arguments)
{
	const ts_truth_part *part = arguments->geometryUserPtr;
	const ts_truth_request *asked = (const ts_truth_request *)(const void *)arguments->context;
	if (asked->packet != NULL) return;
	assert(arguments->N == 1);
	u32 triangle = part->triangle[((const struct RTCHit *)(const void *)arguments->hit)->primID];
	if (!passes(part->truth, asked->queries, triangle)) arguments->valid[0] = 0;
}

u32 ts_truth_find(const ts_truth *truth, const ts_truth_query *query)
{
	if (ts_dot(query->direction, query->direction) == 0.0f) return TS_NONE;
	struct RTCRayHit ray = {
		.ray = {.org_x = query->origin.x,
	            .org_y = query->origin.y,
	            .org_z = query->origin.z,
	            .tnear = query->near,
	            .dir_x = query->direction.x,
	            .dir_y = query->direction.y,
	            .dir_z = query->direction.z,
	            .tfar = INFINITY,
	            .mask = 0xffffffffu},
		.hit = {.geomID = RTC_INVALID_GEOMETRY_ID, .primID = RTC_INVALID_GEOMETRY_ID},
	};
	ts_truth_request asked = {.queries = query};
	ts_tree_cast(&truth->tree, &ray, &asked.base);
	if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return TS_NONE;
	assert(ray.hit.geomID < truth->n_parts && ray.hit.primID < truth->parts[ray.hit.geomID].n);
	return truth->parts[ray.hit.geomID].triangle[ray.hit.primID];
}

static ts_truth_hit hit_of(const ts_truth *truth, const ts_truth_query *query, u32 triangle)
{
	return triangle != TS_NONE ? measure(truth, query, triangle) : (ts_truth_hit){.triangle = TS_NONE};
}

static void add_cost(const ts_truth *truth, u32 rays, double seconds)
{
	__atomic_fetch_add(&truth->cost->rays, rays, __ATOMIC_RELAXED);
	__atomic_fetch_add(&truth->cost->nanoseconds, (u64)(1e9 * seconds), __ATOMIC_RELAXED);
}

ts_truth_cost ts_truth_cost_of(const ts_truth *truth)
{
	u64 rays = __atomic_load_n(&truth->cost->rays, __ATOMIC_RELAXED);
	u64 nanoseconds = __atomic_load_n(&truth->cost->nanoseconds, __ATOMIC_RELAXED);
	return (ts_truth_cost){rays, 1e-9 * (double)nanoseconds};
}

/* Reading the clock costs up to a tenth of a ray, so only some rays are timed. */
ts_truth_hit ts_truth_cast(const ts_truth *truth, const ts_truth_query *query)
{
	static _Thread_local u32 turn;
	bool timed = turn++ % ONE_OF == 0;
	double begin = timed ? ts_seconds() : 0;
	u32 triangle = ts_truth_find(truth, query);
	if (timed) add_cost(truth, ONE_OF, ONE_OF * (ts_seconds() - begin));
	return hit_of(truth, query, triangle);
}

static u32 least(u32 a, u32 b) { return a < b ? a : b; }

void ts_truth_cast_all(ts_truth_hit *hits, const ts_truth *truth, const ts_truth_query *queries, u32 n)
{
	for (u32 first = 0; first < n; first += BATCH) {
		u32 triangle[BATCH], some = least(n - first, BATCH);
		const ts_truth_query *query = queries + first;
		double begin = ts_seconds();
		for (u32 i = 0; i < some; i += TS_TRUTH_PACKET)
			ts_truth_find_all(triangle + i, truth, query + i, least(some - i, TS_TRUTH_PACKET));
		add_cost(truth, some, ts_seconds() - begin);
		for (u32 i = 0; i < some; i++) hits[first + i] = hit_of(truth, &query[i], triangle[i]);
	}
}

static ts_status copy_positions(ts_truth *truth)
{
	u32 n = truth->n_vertices;
	truth->position = ts_alloc_zero((size_t)n * 3 + 1, sizeof(f32), "truth's positions");
	if (truth->position == NULL) return TS_ERROR;
	for (u32 i = 0; i < n; i++)
		memcpy(&truth->position[(size_t)i * 3], truth->scene.vertices[i].position, 3 * sizeof(f32));
	return TS_OK;
}

/* Adds one part as geometry number `id`. */
static ts_status attach(ts_truth *truth, u32 id)
{
	ts_truth_part *p = &truth->parts[id];
	RTCGeometry geometry = ts_rtc.NewGeometry(truth->tree.device, RTC_GEOMETRY_TYPE_TRIANGLE);
	if (geometry == NULL) return ts_tree_fail(&truth->tree, "making a geometry");
	ts_rtc.SetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, truth->position, 0,
	                               3 * sizeof(f32), truth->n_vertices);
	u32 *corner =
		ts_rtc.SetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(u32), p->n);
	if (corner != NULL) {
		for (u32 i = 0; i < p->n; i++)
			memcpy(&corner[(size_t)i * 3], truth->scene.triangles[p->triangle[i]].vertex, 3 * sizeof(u32));
		ts_rtc.SetGeometryUserData(geometry, p);
		if (p->facet != NULL) ts_rtc.SetGeometryIntersectFilterFunction(geometry, filter);
		ts_rtc.CommitGeometry(geometry);
		ts_rtc.AttachGeometryByID(truth->tree.scene, geometry, id);
	}
	ts_rtc.ReleaseGeometry(geometry);
	const char *doing = "copying the triangles";
	return corner != NULL ? ts_tree_check(&truth->tree, doing) : ts_tree_fail(&truth->tree, doing);
}

static ts_status grow_tree(ts_truth *truth)
{
	for (u32 i = 0; i < truth->n_parts; i++)
		if (attach(truth, i)) return TS_ERROR;
	return ts_tree_build(&truth->tree);
}

ts_status ts_truth_new(ts_truth **truth, const ts_run *run)
{
	*truth = NULL;
	ts_truth *made = ts_alloc_zero(1, sizeof(*made), "truth");
	if (made == NULL) return TS_ERROR;
	made->scene = ts_run_arrays(run);
	made->scene.vertices = ts_frame_data(&run->frame, TS_B_pose_vertex);
	made->n_vertices = run->scene->n_vertices;
	made->cost = ts_alloc_zero(1, sizeof *made->cost, "truth");
	if (made->cost == NULL || ts_tree_begin(&made->tree, run->c.threads) || ts_truth_parts_make(made) ||
	    copy_positions(made) || grow_tree(made)) {
		ts_truth_free(made);
		return TS_ERROR;
	}
	*truth = made;
	return TS_OK;
}

void ts_truth_free(ts_truth *truth)
{
	if (truth == NULL) return;
	ts_tree_end(&truth->tree);
	ts_truth_parts_free(truth);
	free(truth->position);
	free(truth->cost);
	free(truth);
}

#define SKIP 0.000244140625f /* 2^-12 of the greatest coordinate */

f32 ts_truth_skip(ts_v3 p) { return ts_max(ts_max(ts_abs(p.x), ts_abs(p.y)), ts_abs(p.z)) * SKIP; }

static ts_truth_query ray_of(const ts_truth_pair *pair)
{
	return (ts_truth_query){.origin = pair->from,
	                        .direction = ts_normalize(ts_sub(pair->to, pair->from)),
	                        .near = ts_truth_skip(pair->from),
	                        .masked = TS_NONE,
	                        .from = pair->from};
}

static bool is_free(const ts_truth_pair *pair, const ts_truth_hit *hit)
{
	return hit->triangle == TS_NONE || hit->t >= ts_length(ts_sub(pair->to, pair->from)) - pair->reach;
}

bool ts_truth_sees(const ts_truth *truth, ts_v3 from, ts_v3 to, f32 reach)
{
	const ts_truth_pair pair = {from, to, reach};
	ts_truth_query ray = ray_of(&pair);
	ts_truth_hit hit = ts_truth_cast(truth, &ray);
	return is_free(&pair, &hit);
}

void ts_truth_sees_all(bool *sees, const ts_truth *truth, const ts_truth_pair *pairs, u32 n)
{
	ts_truth_query rays[TS_TRUTH_PAIRS] = {{.near = 0}};
	ts_truth_hit hits[TS_TRUTH_PAIRS];
	for (u32 i = 0; i < n; i++) rays[i] = ray_of(&pairs[i]);
	ts_truth_cast_all(hits, truth, rays, n);
	for (u32 i = 0; i < n; i++) sees[i] = is_free(&pairs[i], &hits[i]);
}

/* Rays into the triangles: Embree finds the nearest, our own kernel measures the hit (METHODS 17).
 * Filters see what the rasters see: facing by the ray's origin, alpha at the hit's footprint, the masked reflector. */
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "../kernels/base/surface.h"
#include "query.h"
#include "tree.h"

/* Geometry of Embree and the scene's triangle behind each of its primitives. */
typedef struct {
	const ts_truth *truth;
	u32 *triangle;
	u32 n;
} part;

enum { OPEN, FILTERED, N_PARTS };
enum { PACKET = 16, BATCH = 4 * PACKET, ONE_OF = 16 };
#define AS_FAR 0.0000152587890625f /* 2^-16: distances that do not differ more are as far */

/* Of all threads. */
typedef struct {
	u64 rays, nanoseconds;
} costs;

struct ts_truth {
	ts_arrays scene; /* the run's pose.vertex among them */
	u32 n_vertices;
	ts_tree tree;
	costs *cost;
	f32 *position; /* xyz of every vertex, then the 4 bytes that Embree may read beyond them */
	part parts[N_PARTS];
};

/* Queries as the filter finds them, by the rays' ids: Embree hands on the address of `base`. */
typedef struct {
	ts_tree_context base;
	const ts_truth_query *queries;
	const u32 *found; /* a triangle of each, which does not count; NULL: all count */
} request;

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

static bool passes(const ts_truth *truth, const ts_truth_query *query, u32 triangle)
{
	if (query->masked != TS_NONE && ts_k_reflector_of(&truth->scene, triangle) == query->masked) return false;
	ts_corners corner = ts_k_corners(&truth->scene, triangle);
	if (!ts_k_is_facing(&truth->scene, triangle, &corner, query->origin)) return false;
	if (query->whole || (flags_of(truth, triangle) & TS_MASKED) == 0) return true;
	ts_truth_hit hit = measure(truth, query, triangle);
	return !ts_k_is_cut(&truth->scene, triangle, hit.weights, corner.n, hit.footprint);
}

/* A field of lane i, of the n that a packet has: n of each follow in the order of the single ray's or hit's fields. */
static u32 lane(const void *packet, size_t offset, u32 n, u32 i)
{
	u32 value;
	memcpy(&value, (const char *)packet + offset * n + i * sizeof value, sizeof value);
	return value;
}

static void filter(const struct RTCFilterFunctionNArguments *arguments)
{
	const part *p = arguments->geometryUserPtr;
	const request *asked = (const request *)(const void *)arguments->context;
	u32 n = arguments->N;
	for (u32 i = 0; i < n; i++) {
		if (arguments->valid[i] == 0) continue;
		const ts_truth_query *query = &asked->queries[lane(arguments->ray, offsetof(struct RTCRay, id), n, i)];
		u32 triangle = p->triangle[lane(arguments->hit, offsetof(struct RTCHit, primID), n, i)];
		bool counts = asked->found == NULL || triangle != asked->found[query - asked->queries];
		if (!counts || !passes(p->truth, query, triangle)) arguments->valid[i] = 0;
	}
}

/* The nearest triangle that passes, or TS_NONE. */
static u32 find(const ts_truth *truth, const ts_truth_query *query)
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
	request asked = {.queries = query};
	ts_tree_cast(&truth->tree, &ray, &asked.base);
	if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return TS_NONE;
	assert(ray.hit.geomID < N_PARTS && ray.hit.primID < truth->parts[ray.hit.geomID].n);
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

/* The clock would cost as much as a tenth of a ray: one of some stands for them. */
ts_truth_hit ts_truth_cast(const ts_truth *truth, const ts_truth_query *query)
{
	static _Thread_local u32 turn;
	bool timed = turn++ % ONE_OF == 0;
	double begin = timed ? ts_seconds() : 0;
	u32 triangle = find(truth, query);
	if (timed) add_cost(truth, ONE_OF, ONE_OF * (ts_seconds() - begin));
	return hit_of(truth, query, triangle);
}

/* Sets ray i of a packet; one that goes nowhere is not valid. */
static int aim(struct RTCRayHit16 *rays, u32 i, const ts_truth_query *query)
{
	rays->ray.org_x[i] = query->origin.x;
	rays->ray.org_y[i] = query->origin.y;
	rays->ray.org_z[i] = query->origin.z;
	rays->ray.tnear[i] = query->near;
	rays->ray.dir_x[i] = query->direction.x;
	rays->ray.dir_y[i] = query->direction.y;
	rays->ray.dir_z[i] = query->direction.z;
	rays->ray.time[i] = 0;
	rays->ray.tfar[i] = INFINITY;
	rays->ray.mask[i] = 0xffffffffu;
	rays->ray.id[i] = i;
	rays->ray.flags[i] = 0;
	rays->hit.geomID[i] = rays->hit.primID[i] = RTC_INVALID_GEOMETRY_ID;
	return ts_dot(query->direction, query->direction) == 0.0f ? 0 : -1;
}

/* The triangle of each lane, TS_NONE: it hits none. */
static void take_triangles(u32 *triangle, int *valid, const ts_truth *truth, const struct RTCRayHit16 *rays)
{
	for (u32 i = 0; i < PACKET; i++) {
		u32 id = rays->hit.geomID[i];
		valid[i] = valid[i] != 0 && id != RTC_INVALID_GEOMETRY_ID ? -1 : 0;
		assert(valid[i] == 0 || (id < N_PARTS && rays->hit.primID[i] < truth->parts[id].n));
		triangle[i] = valid[i] != 0 ? truth->parts[id].triangle[rays->hit.primID[i]] : TS_NONE;
	}
}

/* Packets and single rays divide in other ways: of triangles that are as far to a rounding either may be the nearest.
 * Where another is as near as what a packet found, the single ray is asked. */
static void ask_again(u32 *triangle, int *valid, const ts_truth *truth, const ts_truth_query *queries,
                      struct RTCRayHit16 *rays)
{
	request asked = {.queries = queries, .found = triangle};
	for (u32 i = 0; i < PACKET; i++) {
		f32 t = valid[i] != 0 ? rays->ray.tfar[i] : 0.0f;
		rays->ray.tnear[i] = ts_max(rays->ray.tnear[i], t - t * AS_FAR);
		rays->ray.tfar[i] = t + t * AS_FAR;
	}
	ts_tree_meet_16(&truth->tree, valid, &rays->ray, &asked.base);
	for (u32 i = 0; i < PACKET; i++) {
		if (valid[i] != 0 && rays->ray.tfar[i] < 0) triangle[i] = find(truth, &queries[i]);
	}
}

static void cast_packet(const ts_truth *truth, const ts_truth_query *queries, u32 n, u32 *triangle)
{
	struct RTCRayHit16 rays __attribute__((aligned(64))) = {.ray = {.tnear = {0}}};
	int valid[PACKET] __attribute__((aligned(64))) = {0};
	request asked = {.queries = queries};
	for (u32 i = 0; i < n; i++) valid[i] = aim(&rays, i, &queries[i]);
	ts_tree_cast_16(&truth->tree, valid, &rays, &asked.base);
	take_triangles(triangle, valid, truth, &rays);
	ask_again(triangle, valid, truth, queries, &rays);
}

void ts_truth_cast_all(ts_truth_hit *hits, const ts_truth *truth, const ts_truth_query *queries, u32 n)
{
	for (u32 first = 0; first < n; first += BATCH) {
		u32 triangle[BATCH], some = n - first < BATCH ? n - first : BATCH;
		const ts_truth_query *query = queries + first;
		double begin = ts_seconds();
		for (u32 i = 0; i < some; i += PACKET)
			cast_packet(truth, query + i, some - i < PACKET ? some - i : PACKET, triangle + i);
		add_cost(truth, some, ts_seconds() - begin);
		for (u32 i = 0; i < some; i++) hits[first + i] = hit_of(truth, &query[i], triangle[i]);
	}
}

static bool needs_filter(const ts_truth *truth, u32 triangle)
{
	u32 flags = flags_of(truth, triangle) & (TS_DOUBLE_SIDED | TS_MASKED);
	return flags != TS_DOUBLE_SIDED || ts_k_reflector_of(&truth->scene, triangle) != TS_NONE;
}

/* Deals the triangles that have an area to the two parts. */
static ts_status sort_triangles(ts_truth *truth)
{
	u32 n = truth->scene.n_triangles;
	for (u32 i = 0; i < N_PARTS; i++) {
		truth->parts[i].truth = truth;
		truth->parts[i].triangle = ts_alloc(n, sizeof(u32), "truth's triangles");
		if (truth->parts[i].triangle == NULL) return TS_ERROR;
	}
	for (u32 t = 0; t < n; t++) {
		if (ts_k_is_degenerate(ts_k_corners(&truth->scene, t).n)) continue;
		part *p = &truth->parts[needs_filter(truth, t) ? FILTERED : OPEN];
		p->triangle[p->n++] = t;
	}
	return TS_OK;
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

/* Adds one part as geometry number `id`; an empty one is left out. */
static ts_status attach(ts_truth *truth, u32 id)
{
	part *p = &truth->parts[id];
	if (p->n == 0) return TS_OK;
	RTCGeometry geometry = rtcNewGeometry(truth->tree.device, RTC_GEOMETRY_TYPE_TRIANGLE);
	if (geometry == NULL) return ts_tree_check(&truth->tree, "making a geometry");
	rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, truth->position, 0,
	                           3 * sizeof(f32), truth->n_vertices);
	u32 *corner = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(u32), p->n);
	if (corner != NULL) {
		for (u32 i = 0; i < p->n; i++)
			memcpy(&corner[(size_t)i * 3], truth->scene.triangles[p->triangle[i]].vertex, 3 * sizeof(u32));
		rtcSetGeometryUserData(geometry, p);
		if (id == FILTERED) rtcSetGeometryIntersectFilterFunction(geometry, filter);
		rtcSetGeometryOccludedFilterFunction(geometry, filter);
		rtcCommitGeometry(geometry);
		rtcAttachGeometryByID(truth->tree.scene, geometry, id);
	}
	rtcReleaseGeometry(geometry);
	return ts_tree_check(&truth->tree, "copying the triangles");
}

static ts_status grow_tree(ts_truth *truth)
{
	for (u32 i = 0; i < N_PARTS; i++)
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
	if (made->cost == NULL || ts_tree_begin(&made->tree, run->c.threads) || sort_triangles(made) ||
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
	for (u32 i = 0; i < N_PARTS; i++) free(truth->parts[i].triangle);
	free(truth->position);
	free(truth->cost);
	free(truth);
}

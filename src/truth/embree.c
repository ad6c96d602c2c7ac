/* All of Embree, version 3 or 4: it finds the nearest triangle, our own kernel measures the hit (SPEC 0.3.5, 0.3.6).
 * Filters see what the rasters see: facing by the ray's origin, alpha at the hit's footprint, the masked reflector. */
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../kernels/surface.h"
#include "../stages/stages.h"
#include "first_error.h"
#include "query.h"
#if TS_EMBREE == 4
#include <embree4/rtcore.h>
typedef struct RTCRayQueryContext context;
#else
#include <embree3/rtcore.h>
typedef struct RTCIntersectContext context;
#endif

/* Geometry of Embree and the scene's triangle behind each of its primitives. */
typedef struct {
	const ts_truth *truth;
	u32 *triangle;
	u32 n;
} part;

enum { OPEN, FILTERED, N_PARTS };

struct ts_truth {
	ts_arrays scene;         /* the run's pose.vertex among them */
	u32 n_vertices;
	RTCDevice device;
	RTCScene tree;
	f32 *position;           /* xyz of every vertex, then the 4 bytes that Embree may read beyond them */
	part parts[N_PARTS];
	i64 bytes_left;          /* of the memory that Embree may still take, from any thread */
	ts_first_error error;    /* Embree's threads report theirs at once */
};

/* A query as the filter finds it: Embree hands on the address of `base`. */
typedef struct {
	context base;
	const ts_truth_query *query;
} request;

const ts_arrays *ts_truth_scene(const ts_truth *truth)
{
	return &truth->scene;
}

static ts_truth_hit measure(const ts_truth *truth, const ts_truth_query *query, u32 triangle)
{
	ts_corners corner = ts_k_corners(&truth->scene, triangle);
	ts_hit hit = ts_k_hit(query->origin, query->direction, &corner);
	ts_v3 q = ts_blend(hit.weights, corner.a, corner.b, corner.c);
	f32 path = query->path + ts_length(ts_sub(query->from, q));
	return (ts_truth_hit){ triangle, hit.t, hit.weights, query->spread * path, path };
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
	if ((flags_of(truth, triangle) & TS_MASKED) == 0) return true;
	ts_truth_hit hit = measure(truth, query, triangle);
	return !ts_k_is_cut(&truth->scene, triangle, hit.weights, corner.n, hit.footprint);
}

static void filter(const struct RTCFilterFunctionNArguments *arguments)
{
	assert(arguments->N == 1);
	const part *p = arguments->geometryUserPtr;
	const request *asked = (const request *)(const void *)arguments->context;
	u32 primitive;
	memcpy(&primitive, (const char *)arguments->hit + offsetof(struct RTCHit, primID), sizeof(primitive));
	u32 triangle = p->triangle[primitive];
	if (!passes(p->truth, asked->query, triangle)) arguments->valid[0] = 0;
}

static void intersect(const ts_truth *truth, struct RTCRayHit *ray, request *asked)
{
#if TS_EMBREE == 4
	struct RTCIntersectArguments arguments;
	rtcInitIntersectArguments(&arguments);
	rtcInitRayQueryContext(&asked->base);
	arguments.context = &asked->base;
	rtcIntersect1(truth->tree, ray, &arguments);
#else
	rtcInitIntersectContext(&asked->base);
	rtcIntersect1(truth->tree, &asked->base, ray);
#endif
}

ts_truth_hit ts_truth_cast(const ts_truth *truth, const ts_truth_query *query)
{
	ts_truth_hit none = { .triangle = TS_NONE };
	if (ts_dot(query->direction, query->direction) == 0.0f) return none;
	struct RTCRayHit ray = {
		.ray = { .org_x = query->origin.x, .org_y = query->origin.y, .org_z = query->origin.z, .tnear = query->near,
		         .dir_x = query->direction.x, .dir_y = query->direction.y, .dir_z = query->direction.z,
		         .tfar = INFINITY, .mask = 0xffffffffu },
		.hit = { .geomID = RTC_INVALID_GEOMETRY_ID, .primID = RTC_INVALID_GEOMETRY_ID },
	};
	request asked = { .query = query };
	intersect(truth, &ray, &asked);
	if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return none;
	assert(ray.hit.geomID < N_PARTS && ray.hit.primID < truth->parts[ray.hit.geomID].n);
	return measure(truth, query, truth->parts[ray.hit.geomID].triangle[ray.hit.primID]);
}

/* Embree calls this from the thread that failed, and check reports it from ours. */
static void on_error(void *user, enum RTCError code, const char *text)
{
	ts_truth *truth = user;
	ts_first_error_keep(&truth->error, (int)code, text);
}

/* Refuses what would take Embree beyond its share of the machine. */
static bool on_memory(void *user, ssize_t bytes, bool post)
{
	ts_truth *truth = user;
	i64 left = __atomic_sub_fetch(&truth->bytes_left, (i64)bytes, __ATOMIC_RELAXED);
	return post || bytes <= 0 || left >= 0;
}

static ts_status check(ts_truth *truth, const char *doing)
{
	bool failed = truth->device == NULL || rtcGetDeviceError(truth->device) != RTC_ERROR_NONE;
	const char *error = ts_first_error_text(&truth->error);
	if (!failed && error == NULL) return TS_OK;
	return ts_fail("truth: Embree failed while %s: %s; it may take %llu MiB", doing,
	               error != NULL ? error : "no reason given", (unsigned long long)(ts_memory_limit() >> 20));
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
	RTCGeometry geometry = rtcNewGeometry(truth->device, RTC_GEOMETRY_TYPE_TRIANGLE);
	if (geometry == NULL) return check(truth, "making a geometry");
	rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, truth->position, 0,
	                           3 * sizeof(f32), truth->n_vertices);
	u32 *corner = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(u32), p->n);
	if (corner != NULL) {
		for (u32 i = 0; i < p->n; i++)
			memcpy(&corner[(size_t)i * 3], truth->scene.triangles[p->triangle[i]].vertex, 3 * sizeof(u32));
		rtcSetGeometryUserData(geometry, p);
		if (id == FILTERED) rtcSetGeometryIntersectFilterFunction(geometry, filter);
		rtcCommitGeometry(geometry);
		rtcAttachGeometryByID(truth->tree, geometry, id);
	}
	rtcReleaseGeometry(geometry);
	return check(truth, "copying the triangles");
}

static ts_status grow_tree(ts_truth *truth, u32 threads)
{
	char options[32];
	snprintf(options, sizeof(options), "threads=%u", threads > 0 ? threads : 1);
	__atomic_store_n(&truth->bytes_left, (i64)ts_memory_limit(), __ATOMIC_RELEASE);
	truth->device = rtcNewDevice(options);
	if (truth->device == NULL) return check(truth, "starting");
	rtcSetDeviceErrorFunction(truth->device, on_error, truth);
	rtcSetDeviceMemoryMonitorFunction(truth->device, on_memory, truth);
	truth->tree = rtcNewScene(truth->device);
	if (truth->tree == NULL) return check(truth, "making a scene");
	rtcSetSceneFlags(truth->tree, RTC_SCENE_FLAG_ROBUST);
	for (u32 i = 0; i < N_PARTS; i++)
		if (attach(truth, i)) return TS_ERROR;
	rtcCommitScene(truth->tree);
	if (check(truth, "building its tree")) return TS_ERROR;
	return ts_selftest_require();
}

ts_status ts_truth_new(ts_truth **truth, const ts_run *run)
{
	*truth = NULL;
	ts_truth *made = ts_alloc_zero(1, sizeof(*made), "truth");
	if (made == NULL) return TS_ERROR;
	ts_first_error_begin(&made->error);
	made->scene = ts_run_arrays(run);
	made->scene.vertices = ts_frame_data(&run->frame, TS_B_pose_vertex);
	made->n_vertices = run->scene->n_vertices;
	if (sort_triangles(made) || copy_positions(made) || grow_tree(made, run->c.threads)) {
		ts_truth_free(made);
		return TS_ERROR;
	}
	*truth = made;
	return TS_OK;
}

void ts_truth_free(ts_truth *truth)
{
	if (truth == NULL) return;
	if (truth->tree != NULL) rtcReleaseScene(truth->tree);
	if (truth->device != NULL) rtcReleaseDevice(truth->device);
	for (u32 i = 0; i < N_PARTS; i++) free(truth->parts[i].triangle);
	free(truth->position);
	ts_first_error_end(&truth->error);
	free(truth);
}

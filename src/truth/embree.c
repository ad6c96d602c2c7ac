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

struct ts_truth {
	ts_arrays scene; /* the run's pose.vertex among them */
	u32 n_vertices;
	ts_tree tree;
	f32 *position; /* xyz of every vertex, then the 4 bytes that Embree may read beyond them */
	part parts[N_PARTS];
};

/* A query as the filter finds it: Embree hands on the address of `base`. */
typedef struct {
	ts_tree_context base;
	const ts_truth_query *query;
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

ts_truth_hit ts_truth_cast(const ts_truth *truth, const ts_truth_query *query)
{
	ts_truth_hit none = {.triangle = TS_NONE};
	if (ts_dot(query->direction, query->direction) == 0.0f) return none;
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
	request asked = {.query = query};
	ts_tree_cast(&truth->tree, &ray, &asked.base);
	if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return none;
	assert(ray.hit.geomID < N_PARTS && ray.hit.primID < truth->parts[ray.hit.geomID].n);
	return measure(truth, query, truth->parts[ray.hit.geomID].triangle[ray.hit.primID]);
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
	if (ts_tree_begin(&made->tree, run->c.threads) || sort_triangles(made) || copy_positions(made) || grow_tree(made)) {
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
	free(truth);
}

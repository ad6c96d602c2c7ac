/* Embree alone: see bare.h. */
#include "truth/bare.h"
#include <math.h>
#include <stdlib.h>
#include "kernels/raster/offscreen.h"
#include "truth/tree.h"
#include "truth/truth.h"

enum {
	SIDE = 4,
	PACKET = SIDE * SIDE,
	ROW = 16
}; /* a packet's rays go through a square of texels; packets cast at once */

struct ts_bare {
	ts_tree tree;
	f32 *position; /* as Embree requires it: xyz, and 4 bytes beyond the last */
	u32 *corner;
	ts_camera_k *views;
	f32 *from;  /* how far from its eye each view's rays begin: outside the reflector that has its middle there */
	u64 *first; /* texel of each view; then their number */
	u32 n_views;
	f32 *depth;
	u32 *triangle;
};

static ts_status copy_triangles(ts_bare *bare, const ts_run *run)
{
	const ts_vertex *vertices = ts_frame_data(&run->frame, TS_B_pose_vertex);
	const ts_triangle *triangles = ts_frame_data(&run->frame, TS_B_scene_triangle);
	u32 n_vertices = run->scene->n_vertices, n = run->scene->n_triangles;
	bare->position = ts_alloc_zero((size_t)n_vertices * 3 + 1, sizeof(f32), "Embree's positions");
	bare->corner = ts_alloc((size_t)n * 3, sizeof(u32), "Embree's triangles");
	if (bare->position == NULL || bare->corner == NULL) return TS_ERROR;
	for (u32 i = 0; i < n_vertices; i++) memcpy(&bare->position[(size_t)i * 3], vertices[i].position, 3 * sizeof(f32));
	for (u32 t = 0; t < n; t++) memcpy(&bare->corner[(size_t)t * 3], triangles[t].vertex, 3 * sizeof(u32));
	return TS_OK;
}

static ts_status grow_tree(ts_bare *bare, const ts_run *run)
{
	RTCGeometry geometry = ts_rtc.NewGeometry(bare->tree.device, RTC_GEOMETRY_TYPE_TRIANGLE);
	if (geometry == NULL) return ts_tree_fail(&bare->tree, "making a geometry");
	ts_rtc.SetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, bare->position, 0,
	                               3 * sizeof(f32), run->scene->n_vertices);
	ts_rtc.SetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, bare->corner, 0,
	                               3 * sizeof(u32), run->scene->n_triangles);
	ts_rtc.CommitGeometry(geometry);
	ts_rtc.AttachGeometry(bare->tree.scene, geometry);
	ts_rtc.ReleaseGeometry(geometry);
	ts_rtc.SetSceneFlags(bare->tree.scene, RTC_SCENE_FLAG_NONE);
	return ts_tree_build(&bare->tree);
}

/* Rays from the eye itself would all hit that reflector from inside. */
static f32 begin_of(const ts_run *run, u32 v)
{
	if (!ts_run_has_cubes(run)) return 0.0f;
	const ts_face *cubes = ts_frame_data(&run->frame, TS_B_cube_size_face);
	return cubes[v / 6].radius;
}

static ts_camera_k view_of(const ts_run *run, u32 v)
{
	if (ts_run_has_cubes(run)) {
		const ts_face *cubes = ts_frame_data(&run->frame, TS_B_cube_size_face);
		return ts_k_cube_view(&cubes[v / 6], v % 6);
	}
	const ts_offscreen *views = ts_frame_data(&run->frame, TS_B_offscreen_view);
	return ts_k_offscreen(&views[v]);
}

static ts_status copy_views(ts_bare *bare, const ts_run *run)
{
	bool cubes = ts_run_has_cubes(run), views = ts_run_made(run, TS_B_offscreen_view);
	if (!cubes && !views) return ts_fail("Embree's rays: the method has no off-screen views");
	u64 n = cubes ? 6 * ts_frame_n(&run->frame, TS_B_cube_size_face) : ts_frame_n(&run->frame, TS_B_offscreen_view);
	bare->n_views = (u32)n;
	bare->views = ts_alloc(n, sizeof *bare->views, "Embree's views");
	bare->from = ts_alloc(n, sizeof *bare->from, "Embree's views");
	bare->first = ts_alloc(n + 1, sizeof *bare->first, "Embree's views");
	if (bare->views == NULL || bare->from == NULL || bare->first == NULL) return TS_ERROR;
	bare->first[0] = 0;
	for (u32 v = 0; v < n; v++) {
		ts_camera_k view = bare->views[v] = view_of(run, v);
		bare->from[v] = begin_of(run, v);
		bare->first[v + 1] = bare->first[v] + (u64)view.width * (u64)view.height;
	}
	bare->depth = ts_alloc_zero(bare->first[n], sizeof *bare->depth, "Embree's depths");
	bare->triangle = ts_alloc_zero(bare->first[n], sizeof *bare->triangle, "Embree's hits");
	return bare->depth != NULL && bare->triangle != NULL ? TS_OK : TS_ERROR;
}

ts_status ts_bare_new(ts_bare **bare, const ts_run *run)
{
	*bare = NULL;
	ts_bare *made = ts_alloc_zero(1, sizeof *made, "Embree's rays");
	if (made == NULL) return TS_ERROR;
	bool failed = ts_tree_begin(&made->tree, run->c.threads) || copy_triangles(made, run) || grow_tree(made, run) ||
	              copy_views(made, run);
	if (failed) {
		ts_bare_free(made);
		return TS_ERROR;
	}
	*bare = made;
	return TS_OK;
}

void ts_bare_free(ts_bare *bare)
{
	if (bare == NULL) return;
	ts_tree_end(&bare->tree);
	free(bare->position);
	free(bare->corner);
	free(bare->views);
	free(bare->from);
	free(bare->first);
	free(bare->depth);
	free(bare->triangle);
	free(bare);
}

u64 ts_bare_n_rays(const ts_bare *bare) { return bare->first[bare->n_views]; }

/* Sets the rays through a square of texels; directions have length 1 along the axis, so that `tfar` is a depth. */
static void aim(struct RTCRayHit16 *rays, int *valid, const ts_bare *bare, u32 v, i32 x0, i32 y0)
{
	const ts_camera_k *view = &bare->views[v];
	f32 from = bare->from[v];
	f32 per_texel = 1.0f / view->focal, left = (f32)view->width * 0.5f - 0.5f, top = (f32)view->height * 0.5f - 0.5f;
	f32 slant = view->orthographic != 0 ? 0.0f : 1.0f, shift = 1.0f - slant;
	for (i32 i = 0; i < PACKET; i++) {
		i32 x = x0 + i % SIDE, y = y0 + i / SIDE;
		f32 u = ((f32)x - left) * per_texel, w = (top - (f32)y) * per_texel;
		ts_v3 aside = {view->right.x * u + view->up.x * w, view->right.y * u + view->up.y * w,
		               view->right.z * u + view->up.z * w};
		rays->ray.org_x[i] = view->eye.x + aside.x * shift;
		rays->ray.org_y[i] = view->eye.y + aside.y * shift;
		rays->ray.org_z[i] = view->eye.z + aside.z * shift;
		rays->ray.dir_x[i] = aside.x * slant - view->back.x;
		rays->ray.dir_y[i] = aside.y * slant - view->back.y;
		rays->ray.dir_z[i] = aside.z * slant - view->back.z;
		rays->ray.tnear[i] = ts_max(view->near, from / ts_sqrt(1.0f + u * u + w * w));
		rays->ray.tfar[i] = INFINITY;
		rays->ray.mask[i] = 0xffffffffu;
		rays->ray.time[i] = 0;
		rays->ray.flags[i] = 0;
		rays->hit.geomID[i] = rays->hit.primID[i] = RTC_INVALID_GEOMETRY_ID;
		valid[i] = x < view->width && y < view->height ? -1 : 0;
	}
}

static void keep(ts_bare *bare, const struct RTCRayHit16 *rays, u32 v, i32 x0, i32 y0)
{
	const ts_camera_k *view = &bare->views[v];
	for (i32 y = y0; y < y0 + SIDE && y < view->height; y++) {
		for (i32 x = x0; x < x0 + SIDE && x < view->width; x++) {
			u64 at = bare->first[v] + (u64)y * (u64)view->width + (u64)x;
			i32 i = (y - y0) * SIDE + x - x0;
			bare->depth[at] = rays->ray.tfar[i];
			bare->triangle[at] = rays->hit.primID[i];
		}
	}
}

static void cast_rows(ts_bare *bare, u32 v, i32 y)
{
	struct RTCRayHit16 rays __attribute__((aligned(64)));
	int valid[PACKET] __attribute__((aligned(64)));
	ts_tree_context context;
	for (i32 x = 0; x < bare->views[v].width; x += SIDE) {
		aim(&rays, valid, bare, v, x, y);
		ts_tree_cast_16(&bare->tree, valid, &rays, &context, NULL);
		keep(bare, &rays, v, x, y);
	}
}

void ts_bare_cast(ts_bare *bare, u32 threads)
{
#pragma omp parallel for num_threads((int)threads) schedule(dynamic, 1)
	for (u32 v = 0; v < bare->n_views; v++) {
		for (i32 y = 0; y < bare->views[v].height; y += SIDE) cast_rows(bare, v, y);
	}
}

/* Casts a row of packets like a truth. */
static void cast_truth_rows(const ts_bare *bare, const ts_truth *truth, u32 v, i32 y)
{
	struct RTCRayHit16 rays __attribute__((aligned(64)));
	int valid[PACKET] __attribute__((aligned(64)));
	ts_truth_query queries[ROW * PACKET];
	ts_truth_hit hits[ROW * PACKET];
	u32 n = 0;
	for (i32 x = 0; x < bare->views[v].width; x += SIDE) {
		aim(&rays, valid, bare, v, x, y);
		for (u32 i = 0; i < PACKET; i++) {
			if (valid[i] == 0) continue;
			ts_v3 from = {rays.ray.org_x[i], rays.ray.org_y[i], rays.ray.org_z[i]};
			ts_v3 way = {rays.ray.dir_x[i], rays.ray.dir_y[i], rays.ray.dir_z[i]};
			queries[n++] = (ts_truth_query){
				.origin = from, .direction = way, .near = rays.ray.tnear[i], .masked = TS_NONE, .from = from};
		}
		bool full = n > (ROW - 1) * PACKET || x + SIDE >= bare->views[v].width;
		if (!full) continue;
		ts_truth_cast_all(hits, truth, queries, n);
		n = 0;
	}
}

void ts_bare_cast_truth(const ts_bare *bare, const ts_truth *truth, u32 threads)
{
#pragma omp parallel for num_threads((int)threads) schedule(dynamic, 1)
	for (u32 v = 0; v < bare->n_views; v++) {
		for (i32 y = 0; y < bare->views[v].height; y += SIDE) cast_truth_rows(bare, truth, v, y);
	}
}

u64 ts_bare_n_hits(const ts_bare *bare)
{
	u64 n = 0;
	for (u64 i = 0; i < ts_bare_n_rays(bare); i++) n += bare->triangle[i] != RTC_INVALID_GEOMETRY_ID;
	return n;
}

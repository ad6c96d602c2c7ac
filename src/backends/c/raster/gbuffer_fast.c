/* Fast path of the G-buffer, with the same bits: pixels beside each other mostly show one triangle, which is brought
 * into the view, clipped and set up once for all of them. */
#include "../../../kernels/raster/gbuffer.h"
#include "../../fast.h"

enum { PIXELS = 256 };

/* A triangle in the view: its polygon and the triangles of its fan, by their last corner. */
typedef struct {
	u32 triangle;
	ts_corners corners;
	ts_polygon polygon;
	ts_setup setup[TS_MAX_CORNERS];
} prepared;

static void prepare(prepared *p, const ts_gbuffer_args *args, const ts_camera_k *view, u32 triangle)
{
	p->triangle = triangle;
	p->corners = ts_k_corners(&args->scene, triangle);
	p->polygon = ts_k_polygon(view, p->corners.a, p->corners.b, p->corners.c);
	ts_k_clip_to_range(view, &p->polygon);
	ts_snapped v[TS_MAX_CORNERS];
	for (u32 k = 0; k < p->polygon.n; k++) v[k] = ts_k_snap(ts_k_project(view, &p->polygon.corner[k]));
	for (u32 k = 2; k < p->polygon.n; k++) p->setup[k] = ts_k_setup(v[0], v[k - 1], v[k]);
}

/* As ts_k_fragment_at. */
static ts_fragment fragment_at(const prepared *p, const ts_camera_k *view, i32 x, i32 y)
{
	const ts_corner *corner = p->polygon.corner;
	for (u32 k = 2; k < p->polygon.n; k++) {
		if (p->setup[k].area == 0) continue;
		ts_edges e = ts_k_edges(&p->setup[k], x * 256 + 128, y * 256 + 128);
		if (!ts_k_covers(&p->setup[k], &e)) continue;
		return ts_k_view_fragment(view, &p->setup[k], &e, &corner[0], &corner[k - 1], &corner[k]);
	}
	return (ts_fragment){.z = 0, .w = {1, 0, 0}};
}

/* As ts_k_gpixel. */
static void add_pixel(const ts_gbuffer_args *args, prepared *p, const ts_camera_k *view, u64 i)
{
	u64 key = args->depth_triangle[i];
	if (key == TS_EMPTY) {
		ts_k_gbuffer_item(args, i);
		return;
	}
	u32 triangle = (u32)key;
	if (triangle != p->triangle) prepare(p, args, view, triangle);
	ts_fragment f = fragment_at(p, view, (i32)(i % (u64)view->width), (i32)(i / (u64)view->width));
	ts_surface s = ts_k_surface(&args->scene, triangle, f.w, ts_k_fragment_footprint(view, &p->corners, &f));
	ts_v3 n = ts_k_facing_normal(&s, ts_sub(view->eye, s.p));
	f32 depth = ts_k_screen_depth(view->near, ts_u2f((u32)(key >> 32)));
	ts_k_gpixel_store(&args->pixels[i], s.p, depth, n, ts_k_albedo(&s));
}

bool ts_c_fast_gbuffer(const void *of, u64 n, u32 threads)
{
	const ts_gbuffer_args *args = of;
	const ts_camera_k view = ts_k_view(args->view);
#pragma omp parallel for num_threads(threads) schedule(dynamic, 16)
	for (i64 group = 0; group < (i64)((n + PIXELS - 1) / PIXELS); group++) {
		u64 first = (u64)group * PIXELS, end = first + PIXELS < n ? first + PIXELS : n;
		prepared p = {.triangle = TS_NONE};
		for (u64 i = first; i < end; i++) add_pixel(args, &p, &view, i);
	}
	return true;
}

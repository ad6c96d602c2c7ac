/* Fast path of the G-buffer, with the same bits: pixels beside each other mostly show one triangle, which is brought
 * into the view, clipped and set up once for all of them. */
#include "../../../kernels/raster/gbuffer.h"
#include "../../fast.h"
#include "prepared.h"

enum { PIXELS = 256 };

/* A triangle that is set up for a sample of the pixels, whose first element this is. */
typedef struct {
	ts_prepared of;
	u64 first;
} prepared;

/* As ts_k_gpixel. */
static void add_pixel(const ts_gbuffer_args *args, prepared *p, u64 i)
{
	u64 key = args->depth_triangle[i];
	if (key == TS_EMPTY) {
		ts_k_gbuffer_item(args, i);
		return;
	}
	u32 triangle = (u32)key;
	const ts_eye_place at = ts_k_eye_place(args->view, args->samples, i);
	const ts_camera_k *view = &at.view;
	if (triangle != p->of.triangle || at.first != p->first) ts_prepare(&p->of, &args->scene, view, triangle);
	p->first = at.first;
	ts_fragment f = ts_prepared_fragment(&p->of, view, at.x, at.y);
	ts_surface s = ts_k_surface(&args->scene, triangle, f.w, ts_k_fragment_footprint(view, &p->of.corners, &f));
	ts_v3 n = ts_k_facing_normal(&s, ts_sub(view->eye, s.p));
	f32 depth = ts_k_screen_depth(view->near, ts_u2f((u32)(key >> 32)));
	ts_k_gpixel_store(&args->pixels[i], s.p, depth, n, ts_k_albedo(&s));
}

bool ts_c_fast_gbuffer(const void *of, u64 n, u32 threads)
{
	const ts_gbuffer_args *args = of;
#pragma omp parallel for num_threads(threads) schedule(dynamic, 16)
	for (i64 group = 0; group < (i64)((n + PIXELS - 1) / PIXELS); group++) {
		u64 first = (u64)group * PIXELS, end = first + PIXELS < n ? first + PIXELS : n;
		prepared p = {.of = {.triangle = TS_NONE}};
		for (u64 i = first; i < end; i++) add_pixel(args, &p, i);
	}
	return true;
}

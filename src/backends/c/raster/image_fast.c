/* Fast path of the picture, with the same bits: neighbouring pixels are transformed into the view together, and those
 * of one material are shaded together. */
#include "backends/c/raster/srgb_table.h"
#include "backends/c/raster/surface_batch.h"
#include "backends/c/raster/surface_rows.h"
#include "backends/fast.h"
#include "kernels/raster/image.h"

typedef struct {
	const ts_image_args *args;
	ts_srgb_table srgb;
} picture;

/* Like ts_k_show. */
static void show(const picture *p, u64 i, ts_v3 value)
{
	f32 *radiance = p->args->radiance + i * 3;
	ts_store3(radiance, value);
	if (p->args->srgb == NULL) return;
	for (u32 k = 0; k < 3; k++) p->args->srgb[i * 3 + k] = ts_srgb_find(&p->srgb, radiance[k] * p->args->exposure);
}

static void show_lit(const void *user, const ts_surface_batch *of, const ts_surfaces *found)
{
	const picture *p = user;
	ts_lanes3 radiance;
	ts_light_batch(&radiance, &p->args->scene, p->args->lamps, of, found);
	for (u32 i = 0; i < of->n; i++) show(p, of->place[i], ts_lane3(&radiance, i));
}

static void show_pixel(ts_row_worker *w, const ts_eye_place *at, i32 x, u64 i)
{
	const picture *p = w->user;
	const ts_image_args *args = p->args;
	u64 key = args->depth_triangle[i];
	if (args->offset != NULL && args->offset[i + 1] != args->offset[i]) {
		show(p, i, ts_load3(args->reflected + (u64)args->offset[i] * 3));
	} else if (key == TS_EMPTY) {
		show(p, i, ts_k_background());
	} else {
		ts_fragment_add(&w->fragments, (u32)key, x, at->y, i);
		if (w->fragments.n == TS_ABREAST) ts_fragments_ask(&w->fragments, &w->bins, &at->view, args->lit);
	}
}

static void show_row(ts_row_worker *w, u64 first, u64 n)
{
	const ts_image_args *args = ((const picture *)w->user)->args;
	ts_eye_place at = ts_k_eye_place(args->view, args->samples, first);
	for (u64 x = 0; x < n; x++) show_pixel(w, &at, (i32)x, first + x);
	ts_fragments_ask(&w->fragments, &w->bins, &at.view, args->lit);
}

bool ts_c_fast_image(const void *of, u64 n, u32 threads)
{
	picture p = {.args = of};
	ts_srgb_table_make(&p.srgb);
	ts_surface_rows rows = {&p.args->scene, &p, show_row, show_lit, n, (u64)p.args->view->width};
	return ts_see_rows(&rows, threads);
}

#include "backends/selftest.h"

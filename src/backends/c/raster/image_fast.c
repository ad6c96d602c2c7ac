/* Fast path of the picture, with the same bits: pixels beside each other are brought into the view together, and those
 * of one material are shaded together. */
#include <omp.h>
#include <stdlib.h>
#include "../../../kernels/raster/image.h"
#include "../../../model/core.h"
#include "../../fast.h"
#include "fragment_batch.h"
#include "light_batch.h"
#include "srgb_table.h"
#include "surface_bins.h"

enum { ROWS = 4 };

typedef struct {
	const ts_image_args *args;
	const ts_srgb_table *srgb;
	ts_surface_bins bins;
	ts_fragment_batch fragments;
} worker;

/* As ts_k_show. */
static void show(const worker *w, u64 i, ts_v3 value)
{
	f32 *radiance = w->args->radiance + i * 3;
	ts_store3(radiance, value);
	if (w->args->srgb == NULL) return;
	for (u32 k = 0; k < 3; k++) w->args->srgb[i * 3 + k] = ts_srgb_find(w->srgb, radiance[k] * w->args->exposure);
}

static void show_lit(void *user, const ts_surface_batch *of, const ts_surfaces *found)
{
	const worker *w = user;
	ts_lanes3 radiance;
	ts_light_batch(&radiance, &w->args->scene, w->args->lamps, of, found);
	for (u32 i = 0; i < of->n; i++) show(w, of->place[i], ts_lane3(&radiance, i));
}

static void shade_fragments(worker *w, const ts_camera_k *view)
{
	const ts_image_args *args = w->args;
	ts_fragment_batch *f = &w->fragments;
	ts_fragments_find(f, &args->scene, view);
	for (u32 i = 0; i < f->n; i++) {
		ts_surface_ask ask = ts_fragment_ask(f, i, view->eye);
		if (args->lit != NULL) ask.lit = args->lit + ask.place * args->scene.n_lights;
		ts_surface_bins_add(&w->bins, &ask);
	}
	f->n = 0;
}

static void show_pixel(worker *w, const ts_eye_place *at, i32 x, u64 i)
{
	const ts_image_args *args = w->args;
	u64 key = args->depth_triangle[i];
	if (args->offset != NULL && args->offset[i + 1] != args->offset[i]) {
		show(w, i, ts_load3(args->reflected + (u64)args->offset[i] * 3));
	} else if (key == TS_EMPTY) {
		show(w, i, ts_k_background());
	} else {
		ts_fragment_add(&w->fragments, (u32)key, x, at->y, i);
		if (w->fragments.n == TS_ABREAST) shade_fragments(w, &at->view);
	}
}

static void show_row(worker *w, u64 first, u64 n)
{
	ts_eye_place at = ts_k_eye_place(w->args->view, w->args->samples, first);
	for (u64 x = 0; x < n; x++) show_pixel(w, &at, (i32)x, first + x);
	shade_fragments(w, &at.view);
}

bool ts_c_fast_image(const void *of, u64 n, u32 threads)
{
	const ts_image_args *args = of;
	u64 width = (u64)args->view->width;
	ts_srgb_table srgb;
	worker *workers = ts_alloc(threads, sizeof *workers, "shading");
	if (workers == NULL) return false;
	ts_srgb_table_make(&srgb);
#pragma omp parallel num_threads(threads)
	{
		worker *w = &workers[omp_get_thread_num()];
		w->args = args;
		w->srgb = &srgb;
		w->fragments.n = 0;
		ts_surface_bins_begin(&w->bins, &args->scene, show_lit, w);
#pragma omp for schedule(dynamic, ROWS)
		for (i64 first = 0; first < (i64)n; first += (i64)width)
			show_row(w, (u64)first, n - (u64)first < width ? n - (u64)first : width);
		ts_surface_bins_flush(&w->bins);
	}
	free(workers);
	return true;
}

/* Fast path of MVR's shading, with the same bits: texels beside each other are brought into the view together, and
 * those of one material are shaded together. */
#include <omp.h>
#include <stdlib.h>
#include "../../../kernels/raster/illuminate.h"
#include "../../../model/core.h"
#include "../../fast.h"
#include "fragment_batch.h"
#include "light_batch.h"
#include "surface_bins.h"

enum { TEXELS = 4096 };

typedef struct {
	const ts_illuminate_args *args;
	ts_surface_bins bins;
	ts_fragment_batch fragments;
} worker;

static void put(const worker *w, u64 texel, ts_v3 radiance)
{
	f32 *out = w->args->mip + texel * 4;
	ts_store3(out, radiance);
	out[3] = 1;
}

static void put_lit(void *user, const ts_surface_batch *of, const ts_surfaces *found)
{
	const worker *w = user;
	ts_lanes3 radiance;
	ts_light_batch(&radiance, &w->args->scene, NULL, of, found);
	for (u32 i = 0; i < of->n; i++) put(w, of->place[i], ts_lane3(&radiance, i));
}

static void shade_fragments(worker *w, const ts_camera_k *view)
{
	ts_fragment_batch *f = &w->fragments;
	ts_fragments_find(f, &w->args->scene, view);
	for (u32 i = 0; i < f->n; i++) {
		ts_surface_ask ask = ts_fragment_ask(f, i, view->eye);
		ts_surface_bins_add(&w->bins, &ask);
	}
	f->n = 0;
}

/* Up to `most` texels, to the end of their row; returns their number. */
static u64 light_row(worker *w, u64 first, u64 most)
{
	const ts_illuminate_args *args = w->args;
	ts_texel_place at = ts_k_texel_place(args, first);
	ts_camera_k view = ts_k_cube_view(&args->cubes[at.cube], at.face);
	u64 to = ts_k_mip_first(args->cubes, args->first_cube, at.cube) + at.inside, row = (u64)view.width - at.x;
	u64 n = row < most ? row : most;
	for (u64 i = 0; i < n; i++) {
		u64 key = args->depth_triangle[first + i];
		if (key == TS_EMPTY) {
			put(w, to + i, ts_k_background());
			continue;
		}
		ts_fragment_add(&w->fragments, (u32)key, (i32)(at.x + i), (i32)at.y, to + i);
		if (w->fragments.n == TS_ABREAST) shade_fragments(w, &view);
	}
	shade_fragments(w, &view);
	return n;
}

bool ts_c_fast_illuminate(const void *of, u64 n, u32 threads)
{
	const ts_illuminate_args *args = of;
	worker *workers = ts_alloc(threads, sizeof *workers, "shading");
	if (workers == NULL) return false;
#pragma omp parallel num_threads(threads)
	{
		worker *w = &workers[omp_get_thread_num()];
		w->args = args;
		w->fragments.n = 0;
		ts_surface_bins_begin(&w->bins, &args->scene, put_lit, w);
#pragma omp for schedule(dynamic, 1)
		for (i64 first = 0; first < (i64)n; first += TEXELS) {
			u64 end = n - (u64)first < TEXELS ? n : (u64)first + TEXELS;
			for (u64 i = (u64)first; i < end; i += light_row(w, i, end - i)) {
			}
		}
		ts_surface_bins_flush(&w->bins);
	}
	free(workers);
	return true;
}

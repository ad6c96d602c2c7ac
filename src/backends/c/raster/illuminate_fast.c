/* Fast path of MVR's shading, with the same bits: neighbouring texels are transformed into the view together, and those
 * of one material are shaded together. */
#include "backends/c/raster/surface_batch.h"
#include "backends/c/raster/surface_rows.h"
#include "backends/fast.h"
#include "kernels/base/shade.h"
#include "kernels/raster/cube.h"
#include "kernels/raster/texel_place.h"

enum { TEXELS = 1024 };

static void put(const ts_illuminate_args *args, u64 texel, ts_v3 radiance)
{
	f32 *out = args->mip + texel * 4;
	ts_store3(out, radiance);
	out[3] = 1;
}

static void put_lit(const void *user, const ts_surface_batch *of, const ts_surfaces *found)
{
	const ts_illuminate_args *args = user;
	ts_lanes3 radiance;
	ts_light_batch(&radiance, &args->scene, NULL, of, found);
	for (u32 i = 0; i < of->n; i++) put(args, of->place[i], ts_lane3(&radiance, i));
}

/* Shades up to `most` texels, to the end of their row; returns their number. */
static u64 light_row(ts_row_worker *w, u64 first, u64 most)
{
	const ts_illuminate_args *args = w->user;
	ts_texel_place at = ts_k_texel_place(args, first);
	ts_camera_k view = ts_k_cube_view(&args->cubes[at.cube], at.face);
	u64 to = ts_k_mip_first(args->cubes, args->first_cube, at.cube) + at.inside, row = (u64)view.width - at.x;
	u64 n = row < most ? row : most;
	for (u64 i = 0; i < n; i++) {
		u64 key = args->depth_triangle[first + i];
		if (key == TS_EMPTY) {
			put(args, to + i, ts_k_background());
			continue;
		}
		ts_fragment_add(&w->fragments, (u32)key, (i32)(at.x + i), (i32)at.y, to + i);
		if (w->fragments.n == TS_ABREAST) ts_fragments_ask(&w->fragments, &w->bins, &view, NULL);
	}
	ts_fragments_ask(&w->fragments, &w->bins, &view, NULL);
	return n;
}

static void light_texels(ts_row_worker *w, u64 first, u64 n)
{
	for (u64 i = 0; i < n; i += light_row(w, first + i, n - i)) {
	}
}

bool ts_c_fast_illuminate(const void *of, u64 n, u32 threads)
{
	const ts_illuminate_args *args = of;
	ts_surface_rows rows = {&args->scene, args, light_texels, put_lit, n, TEXELS};
	return ts_see_rows(&rows, threads);
}

#include "backends/selftest.h"

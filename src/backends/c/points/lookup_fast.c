/* Fast path of the look-ups of reflective pixels, with the same bits: a pixel's samples side by side, and the texels of
 * some pixels prefetched. */
#include "backends/c/points/sample_texels.h"
#include "backends/fast.h"
#include "kernels/points/lookup.h"

enum { PIXELS = 8 };

/* A pixel of a mirror without a cube finds nothing. */
static const u64 nothing = TS_EMPTY;

static void look_up(const ts_lookup_args *args, const ts_sample_offsets *o, u64 first, u32 n)
{
	u32 at[PIXELS][TS_SAMPLE_ROOM];
	const u64 *texels[PIXELS];
	ts_v3 eye = ts_load3(args->view->eye);
	for (u32 i = 0; i < n; i++) {
		const ts_pixel *from = &args->pixels[first + i];
		const ts_face *cube = &args->cubes[from->reflector];
		texels[i] = cube->n != 0 ? args->texels + cube->offset : &nothing;
		ts_sample_texels(at[i], o, from, eye, cube->n);
		for (u32 k = 0; k < args->n_samples; k++) {
			at[i][k] = cube->n != 0 ? at[i][k] : 0;
			__builtin_prefetch(&texels[i][at[i][k]]);
		}
	}
	for (u32 i = 0; i < n; i++) {
		u32 *found = args->found + (first + i) * args->n_samples;
		for (u32 k = 0; k < args->n_samples; k++) found[k] = (u32)texels[i][at[i][k]];
	}
}

bool ts_c_fast_lookup(const void *of, u64 n, u32 threads)
{
	const ts_lookup_args *args = of;
	if (args->n_samples > TS_SAMPLE_ROOM) return false;
	ts_sample_offsets o = ts_sample_offsets_of(args->n_samples);
	ts_stop *stop = ts_stop_here();
#pragma omp parallel for schedule(dynamic, 64) num_threads(threads)
	for (i64 first = 0; first < (i64)n; first += PIXELS) {
		if (ts_stopped(stop)) continue;
		look_up(args, &o, (u64)first, (i64)n - first < PIXELS ? (u32)((i64)n - first) : PIXELS);
	}
	return true;
}

#include "backends/selftest.h"

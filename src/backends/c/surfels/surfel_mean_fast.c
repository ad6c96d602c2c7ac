/* Fast path of the means of surfels, with the same bits: pixels with fragments side by side, by the kernel's own
 * functions in loops without branches, which compilers vectorize; the sky is the same everywhere. */
#include "backends/fast.h"
#include "backends/wide.h"
#include "kernels/surfels/surfel_blend_mean.h"

enum { LOT = 64, VECTOR = 16, PART = 4096 };

/* Pixels with fragments, in full vectors of which the last ones are not used. */
typedef struct {
	u32 n, at[LOT]; /* from the part's first pixel */
	i32 x[LOT], y[LOT];
	f32 sum[TS_BLEND_FRAGMENTS][LOT];
	f32 depth[LOT]; /* of the key or, where that is empty, of the heaviest surfel */
	u32 empty[LOT];
	f32 position[3][LOT], screen[LOT], normal[3][LOT], albedo[3][LOT];
	u32 cancels[LOT]; /* the normals */
} lot;

static u32 padded(u32 n) { return (n + VECTOR - 1) / VECTOR * VECTOR; }

static void add(lot *l, const ts_surfel_blend_mean_args *args, u64 first, u32 at)
{
	u64 i = first + at, width = args->view->width;
	u32 k = l->n++;
	bool empty = args->keys[i] == TS_EMPTY;
	l->at[k] = at;
	l->x[k] = (i32)(i % width);
	l->y[k] = (i32)(i / width);
	l->empty[k] = empty ? 1 : 0;
	l->depth[k] = empty ? args->discs[(u32)args->heaviest[i]].depth : ts_u2f((u32)(args->keys[i] >> 32));
	for (u32 s = 0; s < TS_BLEND_FRAGMENTS; s++) l->sum[s][k] = (f32)args->sums[i * TS_BLEND_SUMS + s];
}

/* ts_k_surfel_blend_mean_item, by selects. */
TS_WIDE(void, mean_lot, (lot *restrict l, ts_camera_k view, f32 epsilon), (l, view, epsilon))
{
	for (u32 i = 0; i < padded(l->n); i++) {
		f32 weight = l->sum[TS_BLEND_WEIGHT][i];
		ts_v3 n = ts_v3_make(l->sum[3][i] / weight, l->sum[4][i] / weight, l->sum[5][i] / weight);
		l->cancels[i] = ts_length(n) < TS_LEAST_NORMAL ? 1u : 0u;
		n = ts_normalize(n);
		f32 shifted = ts_max(l->depth[i] - ts_k_pixel_shift(&view, epsilon, l->x[i], l->y[i]), view.near);
		f32 z = l->empty[i] != 0u ? l->depth[i] : shifted;
		ts_v2 way = ts_k_pixel_way(&view, l->x[i], l->y[i]);
		ts_v3 across = ts_mad(ts_scale(view.right, way.x), view.up, way.y);
		ts_v3 p = ts_mad(view.eye, ts_sub(across, view.back), z);
		l->position[0][i] = ts_put(p.x);
		l->position[1][i] = ts_put(p.y);
		l->position[2][i] = ts_put(p.z);
		l->screen[i] = ts_put(ts_k_screen_depth(view.near, z));
		l->normal[0][i] = ts_put(n.x);
		l->normal[1][i] = ts_put(n.y);
		l->normal[2][i] = ts_put(n.z);
		for (u32 k = 0; k < 3; k++) l->albedo[k][i] = ts_put(l->sum[k][i] / weight);
	}
}

static void store_lot(lot *l, const ts_surfel_blend_mean_args *args, const ts_camera_k *view, u64 first)
{
	for (u32 i = l->n; i < padded(l->n); i++) l->x[i] = l->y[i] = 0;
	mean_lot(l, *view, args->epsilon[0]);
	for (u32 i = 0; i < l->n; i++) {
		u64 at = first + l->at[i];
		if (l->cancels[i] != 0) {
			ts_k_surfel_blend_mean_item(args, at);
			continue;
		}
		args->pixels[at] = (ts_gpixel){
			.position = {l->position[0][i], l->position[1][i], l->position[2][i]},
			.depth = l->screen[i],
			.normal = {l->normal[0][i], l->normal[1][i], l->normal[2][i]},
			.albedo = {l->albedo[0][i], l->albedo[1][i], l->albedo[2][i]},
		};
	}
	l->n = 0;
}

static void mean_part(const ts_surfel_blend_mean_args *args, const ts_camera_k *view, u64 first, u32 n)
{
	const ts_gpixel sky = {.depth = TS_SKY};
	lot l;
	memset(&l, 0, sizeof l);
	for (u32 i = 0; i < n; i++) {
		u64 at = first + i;
		if (args->heaviest[at] == TS_EMPTY || args->sums[at * TS_BLEND_SUMS + TS_BLEND_WEIGHT] <= 0) {
			args->pixels[at] = sky;
			continue;
		}
		add(&l, args, first, i);
		if (l.n == LOT) store_lot(&l, args, view, first);
	}
	if (l.n != 0) store_lot(&l, args, view, first);
}

bool ts_c_fast_surfel_blend_mean(const void *of, u64 n, u32 threads)
{
	const ts_surfel_blend_mean_args *args = of;
	ts_camera_k view = ts_k_view(args->view);
	ts_stop *stop = ts_stop_here();
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
	for (i64 first = 0; first < (i64)n; first += PART) {
		if (ts_stopped(stop)) continue;
		mean_part(args, &view, (u64)first, (u32)(n - (u64)first < PART ? n - (u64)first : PART));
	}
	return true;
}

#include "backends/selftest.h"

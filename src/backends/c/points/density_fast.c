/* Fast path of iVIR's and VIR's densities, with the same bits: the needs of a triangle in one loop over the views,
 * which compilers vectorize. */
#include <omp.h>
#include <stdlib.h>
#include "backends/c/points/closest_lanes.h"
#include "backends/c/points/density_bound.h"
#include "backends/fast.h"
#include "backends/wide.h"
#include "kernels/points/split.h"

enum { ENTRIES = 10, TRIANGLES_A_CHUNK = 256 };

/* The views as arrays: entry v is of view v. */
typedef struct {
	f32 *eye[3], *back[3], *focal, *near, *reach[2];
} lanes;

static void set(lanes *to, f32 *room, const ts_offscreen *views, u32 n)
{
	for (u32 k = 0; k < 3; k++) {
		to->eye[k] = room + k * n;
		to->back[k] = room + (3 + k) * n;
	}
	to->focal = room + 6 * n;
	to->near = room + 7 * n;
	for (u32 k = 0; k < 2; k++) to->reach[k] = room + (8 + k) * n;
	for (u32 v = 0; v < n; v++) {
		for (u32 k = 0; k < 3; k++) {
			to->eye[k][v] = views[v].eye[k];
			to->back[k][v] = views[v].back[k];
		}
		to->focal[v] = views[v].focal;
		to->near[v] = views[v].near;
		for (u32 k = 0; k < 2; k++) to->reach[k][v] = views[v].reach[k];
	}
}

TS_WIDE(void, rates, (f32 *restrict s, lanes l, u32 n, u32 rate, ts_v3 normal, ts_v3 a, ts_v3 b, ts_v3 c),
        (s, l, n, rate, normal, a, b, c))
{
	ts_v3 none = ts_v3_make(0, 0, 0);
	for (u32 v = 0; v < n; v++) {
		ts_camera_k view;
		view.eye = ts_v3_make(l.eye[0][v], l.eye[1][v], l.eye[2][v]);
		view.back = ts_v3_make(l.back[0][v], l.back[1][v], l.back[2][v]);
		view.right = view.up = none;
		view.focal = l.focal[v];
		view.near = l.near[v];
		f32 reach[2] = {l.reach[0][v], l.reach[1][v]};
		s[v] = ts_k_closest_rate(&view, reach, normal, ts_closest_lane(view.eye, a, b, c), rate);
	}
}

/* Like ts_k_split_count_item. */
static void count(const ts_density_args *args, const lanes *of, f32 *s, u32 triangle)
{
	const u64 *words = args->bits + (u64)triangle * args->n_words;
	ts_corners t = ts_k_corners(&args->scene, triangle);
	u64 any = 0;
	f32 most = 0.0f;
	for (u32 w = 0; w < args->n_words; w++) any |= words[w];
	if (any != 0) rates(s, *of, args->n_views, args->rate, ts_normalize(t.n), t.a, t.b, t.c);
	for (u32 v = 0; any != 0 && v < args->n_views; v++) {
		most = ts_k_offscreen_bit(words, v) && s[v] > most ? s[v] : most;
	}
	args->whole[triangle] = ts_put(most);
	args->offset[triangle] = args->whole[triangle] > 0.0f ? ts_k_split(args, triangle, false) : 0;
}

/* Only where all views have the same rate and perspective, and the rate ignores clipping. */
static bool applies(const ts_density_args *args)
{
	bool good = args->shadow == TS_SHADOW_NONE && args->rate >= TS_RATE_PAPER;
	for (u32 v = 0; good && v < args->n_views; v++) good = args->views[v].orthographic == 0;
	return good;
}

bool ts_c_fast_split_count(const void *arguments, u64 n, u32 threads)
{
	const ts_density_args *args = arguments;
	if (args->views == NULL) return ts_c_eye_density(args, (u32)n, threads);
	if (!applies(args)) return false;
	u32 n_views = args->n_views;
	f32 *room = malloc((ENTRIES + (size_t)threads) * n_views * sizeof *room);
	if (room == NULL) return false;
	lanes of;
	set(&of, room, args->views, n_views);
	ts_stop *stop = ts_stop_here();
#pragma omp parallel for schedule(dynamic, TRIANGLES_A_CHUNK) num_threads(threads)
	for (i64 i = 0; i < (i64)n; i++) {
		if (ts_stopped(stop)) continue;
		count(args, &of, room + (ENTRIES + (size_t)omp_get_thread_num()) * n_views, (u32)i);
	}
	free(room);
	return true;
}

#include "backends/selftest.h"

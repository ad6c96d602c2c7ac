/* Fast path of iVIR's and VIR's densities, with the same bits: what each view needs of a triangle, in one loop over the
 * views, which compilers vectorize. */
#include <omp.h>
#include <stdlib.h>
#include "../../../kernels/points/split.h"
#include "../../fast.h"
#include "../../wide.h"

enum { ENTRIES = 10, TRIANGLES_A_CHUNK = 256 };

/* Of all views, one array each. */
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

/* p where `which`, a number that loops of vectors can hold, is 1. */
static ts_v3 choose(u32 which, ts_v3 p, ts_v3 q)
{
	return ts_v3_make(which != 0u ? p.x : q.x, which != 0u ? p.y : q.y, which != 0u ? p.z : q.z);
}

static u32 all3(bool x, bool y, bool z)
{
	u32 r = x ? 1u : 0u;
	r = y ? r : 0u;
	return z ? r : 0u;
}

/* ts_k_closest_on_triangle without branches: the first region that holds p of a, b, the edge ab, c, the edges ac and
 * bc, the inside. */
static ts_v3 closest(ts_v3 p, ts_v3 a, ts_v3 b, ts_v3 c)
{
	ts_v3 ab = ts_sub(b, a);
	ts_v3 ac = ts_sub(c, a);
	ts_v3 ap = ts_sub(p, a);
	ts_v3 bp = ts_sub(p, b);
	ts_v3 cp = ts_sub(p, c);
	f32 d1 = ts_dot(ab, ap);
	f32 d2 = ts_dot(ac, ap);
	f32 d3 = ts_dot(ab, bp);
	f32 d4 = ts_dot(ac, bp);
	f32 d5 = ts_dot(ab, cp);
	f32 d6 = ts_dot(ac, cp);
	f32 va = ts_flush(ts_diff_of_products(d3, d6, d5, d4));
	f32 vb = ts_flush(ts_diff_of_products(d5, d2, d1, d6));
	f32 vc = ts_flush(ts_diff_of_products(d1, d4, d3, d2));
	f32 bc = d4 - d3;
	f32 cb = d5 - d6;
	f32 s = va + vb;
	s = s + vc;
	u32 on_bc = all3(va <= 0.0f, bc >= 0.0f, cb >= 0.0f);
	u32 on_ac = all3(vb <= 0.0f, d2 >= 0.0f, d6 <= 0.0f);
	u32 on_ab = all3(vc <= 0.0f, d1 >= 0.0f, d3 <= 0.0f);
	ts_v3 r = ts_mad(ts_mad(a, ab, ts_k_ratio(vb, s)), ac, ts_k_ratio(vc, s));
	r = choose(on_bc, ts_mad(b, ts_sub(c, b), ts_k_ratio(bc, bc + cb)), r);
	r = choose(on_ac, ts_mad(a, ac, ts_k_ratio(d2, d2 - d6)), r);
	r = choose(all3(d6 >= 0.0f, d5 <= d6, true), c, r);
	r = choose(on_ab, ts_mad(a, ab, ts_k_ratio(d1, d1 - d3)), r);
	r = choose(all3(d3 >= 0.0f, d4 <= d3, true), b, r);
	return choose(all3(d1 <= 0.0f, d2 <= 0.0f, true), a, r);
}

TS_WIDE static void rates(f32 *restrict s, lanes l, u32 n, u32 rate, ts_v3 normal, ts_v3 a, ts_v3 b, ts_v3 c)
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
		s[v] = ts_k_closest_rate(&view, reach, normal, closest(view.eye, a, b, c), rate);
	}
}

/* As ts_k_split_count_item. */
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

/* The same rate of all views, all perspective, and not by what clipping leaves. */
static bool applies(const ts_density_args *args)
{
	bool good = args->views != NULL && args->shadow == TS_SHADOW_IS_NONE && args->rate >= TS_RATE_IS_PAPER;
	for (u32 v = 0; good && v < args->n_views; v++) good = args->views[v].orthographic == 0;
	return good;
}

bool ts_c_fast_split_count(const void *arguments, u64 n, u32 threads)
{
	const ts_density_args *args = arguments;
	if (!applies(args)) return false;
	u32 n_views = args->n_views;
	f32 *room = malloc((ENTRIES + (size_t)threads) * n_views * sizeof *room);
	if (room == NULL) return false;
	lanes of;
	set(&of, room, args->views, n_views);
#pragma omp parallel for schedule(dynamic, TRIANGLES_A_CHUNK) num_threads(threads)
	for (i64 i = 0; i < (i64)n; i++)
		count(args, &of, room + (ENTRIES + (size_t)omp_get_thread_num()) * n_views, (u32)i);
	free(room);
	return true;
}

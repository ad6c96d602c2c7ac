/* Fast path of alignment, with the same bits: pieces side by side. */
#include <string.h>
#include "backends/c/points/closest_lanes.h"
#include "backends/fast.h"
#include "backends/wide.h"
#include "kernels/points/align.h"

enum { PIECES = 64, COORDINATES = 9, PLACES = 6 };

/* Corners and densities; and their frames. */
typedef struct {
	f32 corner[COORDINATES][PIECES], s[PIECES];
	f32 c[3][PIECES], u[3][PIECES], v[3][PIECES];
	i32 q[PLACES][PIECES];
} part;

static inline ts_v3 choose(u32 which, ts_v3 a, ts_v3 b, ts_v3 c)
{
	return ts_choose_lane(which == 2u ? 1u : 0u, c, ts_choose_lane(which == 1u ? 1u : 0u, b, a));
}

static inline void put(f32 to[3][PIECES], u32 i, ts_v3 p)
{
	to[0][i] = ts_put(p.x);
	to[1][i] = ts_put(p.y);
	to[2][i] = ts_put(p.z);
}

/* ts_k_lattice_align */
TS_WIDE(void, align, (part *restrict p), (p))
{
	for (u32 i = 0; i < PIECES; i++) {
		ts_v3 a = ts_v3_make(p->corner[0][i], p->corner[1][i], p->corner[2][i]);
		ts_v3 b = ts_v3_make(p->corner[3][i], p->corner[4][i], p->corner[5][i]);
		ts_v3 c = ts_v3_make(p->corner[6][i], p->corner[7][i], p->corner[8][i]);
		f32 length, s = p->s[i];
		u32 edge = ts_k_longest_edge(a, b, c, &length);
		ts_v3 u = ts_normalize(ts_sub(choose(edge, b, c, a), choose(edge, a, b, c)));
		ts_v3 n = ts_normalize(ts_cross(ts_sub(b, a), ts_sub(c, a)));
		ts_v3 v = ts_normalize(ts_cross(n, u));
		ts_v3 middle = ts_scale(ts_add(ts_add(a, b), c), TS_THIRD);
		ts_v2 qa = ts_k_lattice(middle, u, v, s, a), qb = ts_k_lattice(middle, u, v, s, b);
		ts_v2 qc = ts_k_lattice(middle, u, v, s, c);
		put(p->c, i, middle);
		put(p->u, i, u);
		put(p->v, i, v);
		p->q[0][i] = ts_fix(qa.x, 8, 23);
		p->q[1][i] = ts_fix(qa.y, 8, 23);
		p->q[2][i] = ts_fix(qb.x, 8, 23);
		p->q[3][i] = ts_fix(qb.y, 8, 23);
		p->q[4][i] = ts_fix(qc.x, 8, 23);
		p->q[5][i] = ts_fix(qc.y, 8, 23);
	}
}

static void take(part *p, const ts_align_args *args, u64 first, u32 n)
{
	for (u32 i = 0; i < n; i++) {
		const ts_piece *piece = &args->pieces[first + i];
		for (u32 k = 0; k < 3; k++) {
			p->corner[k][i] = piece->a[k];
			p->corner[3 + k][i] = piece->b[k];
			p->corner[6 + k][i] = piece->c[k];
		}
		p->s[i] = args->keep[first + i] != 0 ? args->scale[first + i] : 0.0f;
	}
}

static void give(const part *p, ts_align *frames, u32 n)
{
	for (u32 i = 0; i < n; i++) {
		ts_align frame = {.s = p->s[i]};
		for (u32 k = 0; k < 3; k++) {
			frame.c[k] = p->c[k][i];
			frame.u[k] = p->u[k][i];
			frame.v[k] = p->v[k][i];
		}
		for (u32 k = 0; k < PLACES; k++) frame.q[k] = p->q[k][i];
		frames[i] = frame;
	}
}

bool ts_c_fast_align(const void *of, u64 n, u32 threads)
{
	const ts_align_args *args = of;
	ts_stop *stop = ts_stop_here();
#pragma omp parallel for num_threads(threads)
	for (i64 first = 0; first < (i64)n; first += PIECES) {
		if (ts_stopped(stop)) continue;
		part p;
		u32 m = (i64)n - first < PIECES ? (u32)((i64)n - first) : PIECES;
		if (m < PIECES) memset(&p, 0, sizeof p);
		take(&p, args, (u64)first, m);
		align(&p);
		give(&p, args->frames + first, m);
	}
	return true;
}

#include "backends/selftest.h"

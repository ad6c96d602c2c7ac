/* EPR's densities, with the bits of ts_k_density: the triangles that a cube may see are processed side by side. */
#include "backends/c/points/closest_lanes.h"
#include "backends/c/points/density_bound.h"
#include "backends/wide.h"
#include "model/core.h"

enum { LANES = 16 };

/* The densities of a part. */
typedef struct {
	f32 density[TS_PART];
	u32 limited[TS_PART], large[TS_PART]; /* 1: the densest cube limits; there are too many samples for a piece */
} densities;

/* The triangles that a cube may see, and their bounds. There is room for lanes beyond the last. */
typedef struct {
	u32 n, triangle[TS_PART + LANES];
	f32 way[TS_PART + LANES], need[TS_PART + LANES];
} seen;

/* A step of ts_k_path_length: the point of the ball that light passes through, and whether its path meets the ball. */
typedef struct {
	ts_v3 by;
	u32 meets;
} step;

static inline step step_of(const ts_density_cube *r, ts_v3 t)
{
	ts_v3 near = ts_k_closest_on_segment(r->centre, t, r->eye);
	ts_v3 out = ts_sub(near, r->centre);
	f32 distance = ts_length(out);
	u32 meets = distance <= r->radius ? 1u : 0u;
	return (step){ts_choose_lane(meets, near, ts_mad(r->centre, out, r->radius / distance)), meets};
}

TS_WIDE(void, measure, (seen *restrict to, const ts_density_part *restrict of, ts_density_cube r), (to, of, r))
{
	u32 n = (to->n + LANES - 1) / LANES * LANES;
	for (u32 i = 0; i < n; i++) {
		u32 at = to->triangle[i];
		ts_v3 a = ts_part_corner(of, 0, at), b = ts_part_corner(of, 1, at), c = ts_part_corner(of, 2, at);
		ts_v3 t = ts_closest_lane(r.centre, a, b, c);
		f32 to_triangle = ts_length(ts_sub(t, r.centre));
		t = ts_closest_lane(step_of(&r, t).by, a, b, c);
		step last = step_of(&r, t);
		f32 straight = ts_length(ts_sub(r.eye, t));
		f32 bent = ts_length(ts_sub(r.eye, last.by)) + ts_length(ts_sub(last.by, t));
		to->way[i] = ts_max(last.meets != 0u ? straight : bent, r.least);
		to->need[i] = r.half_size / ts_max(to_triangle, r.least);
	}
}

static void take(ts_density_part *p, u32 lane, const ts_density_args *args, u32 triangle)
{
	ts_corners t = ts_k_corners(&args->scene, triangle);
	const ts_v3 corner[3] = {t.a, t.b, t.c};
	for (u32 k = 0; k < 3; k++) {
		p->corner[3 * k][lane] = corner[k].x;
		p->corner[3 * k + 1][lane] = corner[k].y;
		p->corner[3 * k + 2][lane] = corner[k].z;
	}
}

/* Keeps those of the n listed triangles that cube r sees. */
static void find_seen(seen *s, const u64 *words, u32 n_words, u32 r, u32 n)
{
	s->n = 0;
	for (u32 k = 0; k < n; k++) {
		u32 i = s->triangle[k];
		s->triangle[s->n] = i;
		s->n += ts_k_cube_bits(words + (u64)i * n_words, r) != 0;
	}
	for (u32 i = s->n; i % LANES != 0; i++) s->triangle[i] = 0;
}

static void merge(ts_density_part *p, const seen *s)
{
	for (u32 k = 0; k < s->n; k++) {
		u32 i = s->triangle[k];
		p->shortest[i] = p->any[i] != 0 ? ts_min(p->shortest[i], s->way[k]) : s->way[k];
		p->densest[i] = p->any[i] != 0 ? ts_max(p->densest[i], s->need[k]) : s->need[k];
		p->any[i] = 1;
	}
}

static ts_density_cube cube_of(const ts_density_args *args, u32 r)
{
	const ts_face *of = &args->cubes[r];
	u32 side = args->greatest != 0 ? args->greatest : of->n;
	return (ts_density_cube){.eye = ts_load3(args->view->eye),
	                         .centre = ts_load3(of->centre),
	                         .radius = of->radius,
	                         .least = ts_flush(of->radius * TS_NEAR_OF_RADIUS),
	                         .half_size = (f32)side * 0.5f};
}

/* Like the end of ts_k_density, and the start of ts_k_split. */
TS_WIDE(void, finish, (densities *restrict to, const ts_density_part *restrict p, f32 wanted, u32 cap),
        (to, p, wanted, cap))
{
	for (u32 i = 0; i < p->n; i++) {
		ts_v3 a = ts_part_corner(p, 0, i), b = ts_part_corner(p, 1, i), c = ts_part_corner(p, 2, i);
		f32 s = p->any[i] != 0u ? wanted / p->shortest[i] : 0.0f, length;
		u32 limited = p->densest[i] < s ? cap : 0u;
		s = ts_put(limited != 0u ? p->densest[i] : s);
		(void)ts_k_longest_edge(a, b, c, &length);
		u32 wide = length * s > TS_MOST_WIDTH ? 1u : 0u;
		to->large[i] = (ts_k_area(a, b, c) * s) * s > TS_SPLIT_SAMPLES ? 1u : wide;
		to->limited[i] = limited;
		to->density[i] = s;
	}
}

/* Like the end of ts_k_split_count_item. Returns 1 where the densest cube limits. */
static u32 put(const ts_density_args *args, const densities *d, u32 lane, u32 triangle)
{
	args->whole[triangle] = d->density[lane];
	args->offset[triangle] = d->density[lane] > 0.0f ? 1 : 0;
	if (d->large[lane] != 0) args->offset[triangle] = ts_k_split(args, triangle, false);
	return d->limited[lane];
}

static void count_part(const ts_density_args *args, u32 first, u32 n)
{
	ts_density_part p = {.n = n};
	densities d;
	seen s;
	i64 n_limited = 0;
	const u64 *words = args->bits + (u64)first * args->n_words;
	for (u32 i = 0; i < n; i++) take(&p, i, args, first + i);
	ts_density_begin(&p);
	for (u32 r = 0; r < args->n_cubes; r++) {
		ts_density_cube cube = cube_of(args, r);
		find_seen(&s, words, args->n_words, r, ts_density_may_count(s.triangle, &p, &cube));
		if (s.n == 0) continue;
		measure(&s, &p, cube);
		merge(&p, &s);
	}
	finish(&d, &p, args->rho * args->view->focal, args->cap != 0 ? 1 : 0);
	for (u32 i = 0; i < n; i++) n_limited += put(args, &d, i, first + i);
	ts_add_i64(args->n_limited, n_limited);
}

/* Only for defaults: the paper's path, balls, off-axis densities and an eye within a ball are left to the kernel. */
static bool applies(const ts_density_args *args)
{
	ts_v3 eye = ts_load3(args->view->eye);
	bool good = args->paper == 0 && args->ball == 0 && args->offaxis == 0;
	for (u32 r = 0; good && r < args->n_cubes; r++) {
		good = !(ts_length(ts_sub(eye, ts_load3(args->cubes[r].centre))) <= args->cubes[r].radius);
	}
	return good;
}

bool ts_c_eye_density(const ts_density_args *args, u32 n, u32 threads)
{
	if (!applies(args)) return false;
	ts_stop *stop = ts_stop_here();
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
	for (i64 first = 0; first < (i64)n; first += TS_PART) {
		if (ts_stopped(stop)) continue;
		count_part(args, (u32)first, (i64)n - first < TS_PART ? (u32)((i64)n - first) : TS_PART);
	}
	return true;
}

#include "backends/selftest.h"

/* Fast path of the scatter kernels for depth maps, with the same bits: the threads fill pools with points, then each
 * takes whole depth maps and scatters all pools into them, so there are no atomics. Points come in runs, each of one
 * piece. A view takes the runs that it may see, and transforms a block of points side by side. Runs that no view may
 * see are counted, and not made. */
#include <omp.h>
#include <stdlib.h>
#include "backends/c/points/made_points.h"
#include "backends/c/points/view_planes.h"
#include "backends/c/raster/prepared.h"
#include "backends/fast.h"
#include "backends/wide.h"
#include "kernels/points/scatter.h"

enum {
	ROOM = (1 << 16) + 256, /* a row of a lattice, 24.8 and dilated, has at most 65538 points */
	RUNS = 1 << 14,
	BLOCK = 256,
	LANES = 16,
	TAKEN = 64,
	MOST_GROUPS = 64, /* of 32 views; more are not worth their memory */
};

/* Points of one thread. Run r has those from begin[r] to begin[r + 1], of piece of[r]; its views are bits of
 * seen[g * RUNS + r]: those of 32 [32 (first + g), ...) that may see it. */
typedef struct {
	f32 *centre[3];
	u32 *seen;
	u32 n_runs, begin[RUNS + 1], of[RUNS];
	i64 n_points, n_scatters;
	u64 piece, end; /* pieces that this thread took and has not finished */
	i32 row;        /* the first row of `piece`, from touched.y0 */
} pool;

typedef struct {
	const ts_scatter_args *args;
	u64 n_items;
	bool stored; /* items are points, not pieces */
	u64 next;    /* the next item that nobody took; atomic */
	u32 first_group, n_groups;
	ts_view_planes *planes; /* of each group */
	i64 n_writes;
	pool *pools;
	u32 n_pools;
	ts_stop *stop;
} job;

static u32 n_points(const pool *p) { return p->begin[p->n_runs]; }

/* Bits of a group's views in the batch that may see a triangle. */
static u32 bits_of(const job *j, u32 triangle, u32 g)
{
	const u64 *words = j->args->bits + (u64)triangle * j->args->n_words;
	u32 group = j->first_group + g;
	return (u32)(words[group >> 1] >> ((group & 1u) * 32u)) & j->planes[g].views;
}

/* Begins a run of a piece, whose points are in a box of world space; NULL: they may be anywhere. Returns how many views
 * may see its triangle; `any` receives whether one may see the box. */
static u32 begin_run(const job *j, pool *to, u64 piece, const ts_bounds *box, bool *any)
{
	u32 n = 0, seen = 0;
	for (u32 g = 0; g < j->n_groups; g++) {
		u32 bits = bits_of(j, j->args->from.pieces[piece].triangle, g);
		n += (u32)__builtin_popcount(bits);
		if (box != NULL && bits != 0) bits &= ts_view_planes_meet(&j->planes[g], box);
		to->seen[(size_t)g * RUNS + to->n_runs] = bits;
		seen |= bits;
	}
	to->of[to->n_runs] = (u32)piece;
	*any = seen != 0;
	return n;
}

static void end_run(pool *to, u32 n)
{
	u32 end = n_points(to) + n;
	to->n_runs += n != 0;
	to->begin[to->n_runs] = end;
}

static u64 take(job *j, u64 n) { return __atomic_fetch_add(&j->next, n, __ATOMIC_RELAXED); }

/* Adds stored points of a piece from i on; returns how many. */
static u32 fill_run(const job *j, pool *to, u64 i, u64 end)
{
	const ts_point *points = j->args->from.points;
	u32 n = 0, at = n_points(to), piece = points[i].piece;
	bool any;
	u32 views = begin_run(j, to, piece, NULL, &any);
	for (; i + n < end && points[i + n].piece == piece; n++) {
		for (u32 axis = 0; axis < 3; axis++) to->centre[axis][at + n] = points[i + n].centre[axis];
	}
	to->n_points += n;
	to->n_scatters += (i64)n * views;
	end_run(to, n);
	return n;
}

static void fill_stored(job *j, pool *to)
{
	u64 begin = take(j, RUNS), end = begin + RUNS < j->n_items ? begin + RUNS : j->n_items;
	for (u64 i = begin; i < end;) i += fill_run(j, to, i, end);
}

/* Makes the rows of a piece that fit, from `row` on. True if those were all. */
static bool make_rows(pool *to, const ts_made_piece *piece)
{
	u32 first = n_points(to), n = 0;
	ts_box touched = piece->cover.touched;
	u32 width = (u32)ts_max_i32(touched.x1 - touched.x0 + 1, 0);
	for (; touched.y0 + to->row <= touched.y1 && first + n + width <= ROOM; to->row++) {
		f32 *centre[3] = {to->centre[0] + first + n, to->centre[1] + first + n, to->centre[2] + first + n};
		n += ts_made_row(piece, touched.y0 + to->row, centre);
	}
	end_run(to, n);
	return touched.y0 + to->row > touched.y1;
}

/* Makes the points of the pool's first piece that fit. True if those were all. */
static bool fill_piece(const job *j, pool *to)
{
	const ts_points_args *from = &j->args->from;
	if (!(from->frames[to->piece].s > 0.0f)) return true;
	ts_made_piece piece = ts_made_piece_begin(from, to->piece);
	ts_bounds box = ts_made_piece_bounds(&piece);
	bool any;
	u32 views = begin_run(j, to, to->piece, &box, &any);
	if (any && !make_rows(to, &piece)) return false;
	u64 n = ts_made_piece_count(&piece);
	to->n_points += (i64)n;
	to->n_scatters += (i64)n * views;
	return true;
}

static void fill_pieces(job *j, pool *to)
{
	while (to->n_runs < RUNS) {
		if (to->piece >= to->end) {
			to->piece = take(j, TAKEN);
			if (to->piece >= j->n_items) {
				to->end = to->piece;
				return;
			}
			to->end = to->piece + TAKEN < j->n_items ? to->piece + TAKEN : j->n_items;
		}
		if (!fill_piece(j, to)) return;
		to->piece++;
		to->row = 0;
	}
}

/* Texel and depth bits of n points in a view; -1: none. Uses selects, so that it is vectorized. */
TS_WIDE(void, place,
        (ts_camera_k view, const f32 *restrict x, const f32 *restrict y, const f32 *restrict z, u32 n,
         i32 *restrict texel, u32 *restrict depth),
        (view, x, y, z, n, texel, depth))
{
	f32 width = (f32)view.width, height = (f32)view.height;
	f32 middle_x = width * 0.5f, middle_y = height * 0.5f;
	bool parallel = view.orthographic != 0;
	for (u32 i = 0; i < (n + LANES - 1) / LANES * LANES; i++) {
		ts_v3 d = ts_v3_make(x[i] - view.eye.x, y[i] - view.eye.y, z[i] - view.eye.z);
		f32 ahead = -ts_dot(view.back, d);
		f32 by = parallel ? 1.0f : ahead;
		f32 across = middle_x + (view.focal * ts_dot(view.right, d)) / by;
		f32 down = middle_y - (view.focal * ts_dot(view.up, d)) / by;
		i32 in = ahead >= view.near ? 1 : 0;
		in = across >= 0.0f ? in : 0;
		in = across < width ? in : 0;
		in = down >= 0.0f ? in : 0;
		in = down < height ? in : 0;
		i32 column = (i32)(in != 0 ? across : 0.0f);
		i32 row = (i32)(in != 0 ? down : 0.0f);
		texel[i] = in != 0 ? row * view.width + column : -1;
		depth[i] = ts_f2u(ts_put(ahead));
	}
}

/* A piece, whether its points count at texel centres, and its triangle's depth at the previous point's texel. */
typedef struct {
	u32 piece;
	bool at_centre, has_triangle;
	ts_prepared triangle;
	i32 texel;
	u32 depth; /* TS_NONE: the triangle does not cover the texel */
} caster;

static u32 centre_depth(const job *j, const ts_camera_k *view, caster *c, i32 texel)
{
	const ts_arrays *scene = &j->args->from.scene;
	u32 triangle = j->args->from.pieces[c->piece].triangle;
	if (!c->has_triangle) ts_prepare(&c->triangle, scene, view, triangle);
	c->has_triangle = true;
	ts_fragment f = ts_prepared_fragment(&c->triangle, view, texel % view->width, texel / view->width);
	if (!(f.z > 0.0f)) return TS_NONE;
	if (!ts_k_is_masked(scene, triangle)) return ts_f2u(f.z);
	f32 footprint = ts_k_fragment_footprint(view, &c->triangle.corners, &f);
	return ts_k_is_cut(scene, triangle, f.w, c->triangle.corners.n, footprint) ? TS_NONE : ts_f2u(f.z);
}

/* Offers points where they are; returns to how many texels. */
static u32 offer_points(u32 *map, const i32 *texel, const u32 *depth, u32 n)
{
	u32 writes = 0;
	for (u32 i = 0; i < n; i++) {
		if (texel[i] < 0) continue;
		u32 *at = &map[texel[i]], old = *at;
		*at = depth[i] < old ? depth[i] : old;
		writes++;
	}
	return writes;
}

/* Offers the depths of their triangle at the centres of texels. */
static u32 offer_centres(const job *j, const ts_camera_k *view, caster *c, u32 *map, const i32 *texel, u32 n)
{
	u32 writes = 0;
	for (u32 i = 0; i < n; i++) {
		if (texel[i] < 0) continue;
		if (texel[i] != c->texel) c->depth = centre_depth(j, view, c, texel[i]);
		c->texel = texel[i];
		u32 *at = &map[texel[i]], old = *at;
		*at = c->depth < old ? c->depth : old;
		writes += c->depth != TS_NONE;
	}
	return writes;
}

/* Scatters points from `begin` to `end`, at texel centres if the caster has that. */
static u32 scatter_points(const job *j, const ts_camera_k *view, caster *c, const pool *from, u32 begin, u32 end,
                          u32 *map)
{
	u32 writes = 0;
	i32 texel[BLOCK];
	u32 depth[BLOCK];
	for (u32 i = begin; i < end; i += BLOCK) {
		u32 n = end - i < BLOCK ? end - i : BLOCK;
		place(*view, from->centre[0] + i, from->centre[1] + i, from->centre[2] + i, n, texel, depth);
		writes += c->at_centre ? offer_centres(j, view, c, map, texel, n) : offer_points(map, texel, depth, n);
	}
	return writes;
}

/* Adjacent runs are scattered together, unless points count at texel centres. */
static void scatter_pool(job *j, const ts_camera_k *view, u32 v, const pool *from, u32 *map)
{
	i64 writes = 0;
	const u32 *seen = from->seen + (size_t)(v / 32 - j->first_group) * RUNS;
	bool together = j->args->centre == 0;
	for (u32 r = 0; r < from->n_runs; r++) {
		u32 first = r, bit = v % 32;
		if ((seen[r] >> bit & 1) == 0) continue;
		while (together && r + 1 < from->n_runs && (seen[r + 1] >> bit & 1) != 0) r++;
		caster c = {.piece = from->of[first], .texel = -1};
		c.at_centre = !together && ts_k_is_at_centre(j->args, c.piece);
		writes += scatter_points(j, view, &c, from, from->begin[first], from->begin[r + 1], map);
	}
	ts_add_i64(&j->n_writes, writes);
}

static void scatter_view(job *j, u32 v)
{
	const ts_offscreen *offscreen = &j->args->views[v];
	ts_camera_k view = ts_k_offscreen(offscreen);
	u32 *map = j->args->depths + (offscreen->offset - j->args->views[j->args->first_view].offset);
	for (u32 p = 0; p < j->n_pools; p++) scatter_pool(j, &view, v, &j->pools[p], map);
}

static bool is_empty(const job *j)
{
	u32 n = 0;
	for (u32 p = 0; p < j->n_pools; p++) n += j->pools[p].n_runs;
	return n == 0;
}

/* Every thread of the team runs this. */
static void work(job *j)
{
	pool *mine = &j->pools[omp_get_thread_num()];
	i64 last = (i64)j->args->first_view + j->args->n_views;
	for (;;) {
		mine->n_runs = 0;
		if (ts_stopped(j->stop)) {
			/* The last round. */
		} else if (j->stored) {
			fill_stored(j, mine);
		} else {
			fill_pieces(j, mine);
		}
#pragma omp barrier
		if (is_empty(j)) break;
#pragma omp for schedule(dynamic, 1)
		for (i64 v = j->args->first_view; v < last; v++) scatter_view(j, (u32)v);
	}
}

static bool make_pools(job *j, u32 n)
{
	j->pools = calloc(n, sizeof *j->pools);
	bool made = j->pools != NULL;
	for (; made && j->n_pools < n; j->n_pools++) {
		pool *p = &j->pools[j->n_pools];
		p->centre[0] = calloc(3 * (ROOM + LANES), sizeof(f32));
		p->seen = malloc((size_t)j->n_groups * RUNS * sizeof(u32));
		made = p->centre[0] != NULL && p->seen != NULL;
		for (u32 axis = 1; made && axis < 3; axis++) p->centre[axis] = p->centre[0] + axis * (ROOM + LANES);
	}
	return made;
}

static bool make_planes(job *j)
{
	j->planes = calloc(j->n_groups, sizeof *j->planes);
	if (j->planes == NULL) return false;
	for (u32 i = 0; i < j->args->n_views; i++) {
		u32 v = j->args->first_view + i;
		ts_camera_k view = ts_k_offscreen(&j->args->views[v]);
		ts_view_planes_set(&j->planes[v / 32 - j->first_group], v % 32, &view);
	}
	return true;
}

static void clear(job *j)
{
	for (u32 p = 0; p < j->n_pools; p++) {
		free(j->pools[p].centre[0]);
		free(j->pools[p].seen);
	}
	free(j->pools);
	free(j->planes);
}

static void count(const job *j)
{
	for (u32 p = 0; p < j->n_pools; p++) {
		ts_add_i64(j->args->n_points, j->pools[p].n_points);
		ts_add_i64(j->args->n_scatters, j->pools[p].n_scatters);
	}
	ts_add_i64(j->args->n_writes, j->n_writes);
}

/* Scatters n stored points or n pieces into depth maps; n_views must not be 0. False if there are more than 2048
 * views. */
static bool scatter(const ts_scatter_args *args, u64 n, bool stored, u32 threads)
{
	if (args->depths == NULL) return false;
	job j = {
		.args = args, .n_items = n, .stored = stored, .stop = ts_stop_here(), .first_group = args->first_view / 32};
	j.n_groups = (args->first_view + args->n_views - 1) / 32 - j.first_group + 1;
	if (j.n_groups > MOST_GROUPS) return false;
	bool made = make_planes(&j) && make_pools(&j, threads);
	if (made) {
#pragma omp parallel num_threads(threads)
		work(&j);
		count(&j);
	}
	clear(&j);
	return made;
}

bool ts_c_fast_scatter(const void *of, u64 n, u32 threads) { return scatter(of, n, true, threads); }
bool ts_c_fast_scatter_pieces(const void *of, u64 n, u32 threads) { return scatter(of, n, false, threads); }

#include "backends/selftest.h"

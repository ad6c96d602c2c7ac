/* Fast path of the scatter kernels for depth maps, with the same bits: the threads fill pools with points, then each
 * takes whole depth maps and scatters all pools into them, so there are no atomics; a block of points goes side by
 * side through a view's transform, in loops that compilers vectorize. Points that count at the centre of their texel
 * come piece by piece: a view sets their triangle up once, and asks it once for neighbours in one texel. */
#include <omp.h>
#include <stdlib.h>
#include "../../../kernels/points/scatter.h"
#include "../../fast.h"
#include "../../wide.h"
#include "../raster/prepared.h"

enum {
	ROOM = (1 << 16) + 256, /* a row of a lattice, 24.8 and dilated, has at most 65538 points */
	BLOCK = 256,
	TAKEN = 64,
	MOST_GROUPS = 64, /* of 32 views; more are not worth the memory */
};

/* Points of one thread; seen[g] has a bit for each view of 32 [32 (first + g), ...). */
typedef struct {
	f32 *centre[3];
	u32 *seen;
	u32 *of; /* the piece of each; NULL: nobody asks */
	u32 n;
	u64 piece, end; /* pieces that this thread took and has not finished */
	i32 row;        /* of the first of them, from touched.y0 */
} pool;

typedef struct {
	const ts_scatter_args *args;
	u64 n_items;
	bool stored; /* items are points, not pieces */
	u64 next;    /* item that nobody took; atomic */
	u32 first_group, n_groups;
	i64 n_points, n_scatters, n_writes;
	pool *pools;
	u32 n_pools;
} job;

static void add_point(const job *j, pool *to, ts_v3 p, u64 piece, const u64 *words)
{
	u32 at = to->n++;
	if (to->of != NULL) to->of[at] = (u32)piece;
	to->centre[0][at] = p.x;
	to->centre[1][at] = p.y;
	to->centre[2][at] = p.z;
	for (u32 g = 0; g < j->n_groups; g++) {
		u32 group = j->first_group + g;
		to->seen[(size_t)g * ROOM + at] = (u32)(words[group >> 1] >> ((group & 1u) * 32u));
	}
}

static const u64 *words_of(const ts_scatter_args *args, u64 piece)
{
	return args->bits + (u64)args->from.pieces[piece].triangle * args->n_words;
}

static u64 take(job *j, u64 n) { return __atomic_fetch_add(&j->next, n, __ATOMIC_RELAXED); }

static void fill_stored(job *j, pool *to)
{
	u64 begin = take(j, ROOM), end = begin + ROOM < j->n_items ? begin + ROOM : j->n_items;
	for (u64 i = begin; i < end; i++) {
		const ts_point *point = &j->args->from.points[i];
		add_point(j, to, ts_load3(point->centre), point->piece, words_of(j->args, point->piece));
	}
}

/* The rows that fit of the pool's first piece. True if that was all of them. */
static bool fill_rows(const job *j, pool *to)
{
	const ts_points_args *from = &j->args->from;
	if (!(from->frames[to->piece].s > 0.0f)) return true;
	ts_cover cover = ts_k_lattice_cover(&from->frames[to->piece], from->half_size);
	const u64 *words = words_of(j->args, to->piece);
	u32 width = (u32)ts_max_i32(cover.touched.x1 - cover.touched.x0 + 1, 0);
	for (; cover.touched.y0 + to->row <= cover.touched.y1; to->row++) {
		if (to->n + width > ROOM) return false;
		i32 y = cover.touched.y0 + to->row;
		for (i32 x = cover.touched.x0; x <= cover.touched.x1; x++) {
			if (!ts_k_is_point(from, &cover, to->piece, x, y)) continue;
			ts_v3 p = ts_k_point_centre(from, to->piece, x, y);
			add_point(j, to, ts_v3_make(ts_put(p.x), ts_put(p.y), ts_put(p.z)), to->piece, words);
		}
	}
	return true;
}

static void fill_pieces(job *j, pool *to)
{
	for (;;) {
		if (to->piece >= to->end) {
			to->piece = take(j, TAKEN);
			if (to->piece >= j->n_items) {
				to->end = to->piece;
				return;
			}
			to->end = to->piece + TAKEN < j->n_items ? to->piece + TAKEN : j->n_items;
		}
		if (!fill_rows(j, to)) return;
		to->piece++;
		to->row = 0;
	}
}

/* Texel and depth bits of n points in a view; -1: none. `bit` is the view's in `seen`. Selects, so that it is
 * vectorized. */
TS_WIDE static u32 place(ts_camera_k view, const f32 *restrict x, const f32 *restrict y, const f32 *restrict z,
                         const u32 *restrict seen, u32 bit, u32 n, i32 *restrict texel, u32 *restrict depth)
{
	f32 width = (f32)view.width, height = (f32)view.height;
	f32 middle_x = width * 0.5f, middle_y = height * 0.5f;
	bool parallel = view.orthographic != 0;
	u32 count = 0;
	for (u32 i = 0; i < n; i++) {
		ts_v3 d = ts_v3_make(x[i] - view.eye.x, y[i] - view.eye.y, z[i] - view.eye.z);
		f32 ahead = -ts_dot(view.back, d);
		f32 by = parallel ? 1.0f : ahead;
		f32 across = middle_x + (view.focal * ts_dot(view.right, d)) / by;
		f32 down = middle_y - (view.focal * ts_dot(view.up, d)) / by;
		i32 in = (i32)(seen[i] >> bit & 1u);
		count += (u32)in;
		in = ahead >= view.near ? in : 0;
		in = across >= 0.0f ? in : 0;
		in = across < width ? in : 0;
		in = down >= 0.0f ? in : 0;
		in = down < height ? in : 0;
		i32 column = (i32)(in != 0 ? across : 0.0f);
		i32 row = (i32)(in != 0 ? down : 0.0f);
		texel[i] = in != 0 ? row * view.width + column : -1;
		u32 bits = ts_f2u(ahead);
		depth[i] = (bits & 0x7fffffffu) < 0x0d800000u ? 0u : bits; /* ts_put */
	}
	return count;
}

/* The piece whose points come, and what its triangle shows at the centre of the texel of the point before. */
typedef struct {
	u32 piece;
	bool at_centre, has_triangle;
	ts_prepared triangle;
	i32 texel;
	u32 depth; /* TS_NONE: it is not drawn there */
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

/* The depth that a point of the piece offers to a texel. */
static u32 offer(const job *j, const ts_camera_k *view, caster *c, u32 piece, i32 texel, u32 own)
{
	if (piece != c->piece) {
		c->piece = piece;
		c->at_centre = ts_k_is_at_centre(j->args, piece);
		c->has_triangle = false;
		c->texel = -1;
	}
	if (!c->at_centre) return own;
	if (texel != c->texel) c->depth = centre_depth(j, view, c, texel);
	c->texel = texel;
	return c->depth;
}

static void scatter_pool(job *j, const ts_camera_k *view, u32 v, const pool *from, u32 *map)
{
	caster c = {.piece = TS_NONE};
	i32 texel[BLOCK];
	u32 depth[BLOCK];
	i64 scatters = 0, writes = 0;
	const u32 *seen = from->seen + (size_t)(v / 32 - j->first_group) * ROOM;
	for (u32 begin = 0; begin < from->n; begin += BLOCK) {
		u32 n = from->n - begin < BLOCK ? from->n - begin : BLOCK;
		const f32 *x = from->centre[0] + begin, *y = from->centre[1] + begin, *z = from->centre[2] + begin;
		scatters += place(*view, x, y, z, seen + begin, v % 32, n, texel, depth);
		for (u32 i = 0; i < n; i++) {
			if (texel[i] < 0) continue;
			u32 *at = &map[texel[i]], old = *at;
			u32 new = from->of != NULL ? offer(j, view, &c, from->of[begin + i], texel[i], depth[i]) : depth[i];
			*at = new < old ? new : old;
			writes += new != TS_NONE;
		}
	}
	ts_add_i64(&j->n_scatters, scatters);
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
	for (u32 p = 0; p < j->n_pools; p++) n += j->pools[p].n;
	return n == 0;
}

/* Every thread of the team comes here. */
static void work(job *j)
{
	pool *mine = &j->pools[omp_get_thread_num()];
	i64 last = (i64)j->args->first_view + j->args->n_views;
	for (;;) {
		mine->n = 0;
		if (j->stored) {
			fill_stored(j, mine);
		} else {
			fill_pieces(j, mine);
		}
		ts_add_i64(&j->n_points, mine->n);
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
		p->centre[0] = malloc(3 * ROOM * sizeof(f32));
		p->seen = malloc((size_t)j->n_groups * ROOM * sizeof(u32));
		made = p->centre[0] != NULL && p->seen != NULL;
		if (made && j->args->centre != 0) {
			p->of = malloc(ROOM * sizeof(u32));
			made = p->of != NULL;
		}
		for (u32 axis = 1; made && axis < 3; axis++) p->centre[axis] = p->centre[0] + axis * ROOM;
	}
	return made;
}

static void free_pools(job *j)
{
	for (u32 p = 0; p < j->n_pools; p++) {
		free(j->pools[p].centre[0]);
		free(j->pools[p].seen);
		free(j->pools[p].of);
	}
	free(j->pools);
}

/* Of n stored points or n pieces, into depth maps; n_views must not be 0. False if there are more than 2048 views. */
static bool scatter(const ts_scatter_args *args, u64 n, bool stored, u32 threads)
{
	if (args->depths == NULL) return false;
	job j = {.args = args, .n_items = n, .stored = stored, .first_group = args->first_view / 32};
	j.n_groups = (args->first_view + args->n_views - 1) / 32 - j.first_group + 1;
	if (j.n_groups > MOST_GROUPS) return false;
	bool made = make_pools(&j, threads);
	if (made) {
#pragma omp parallel num_threads(threads)
		work(&j);
		ts_add_i64(args->n_points, j.n_points);
		ts_add_i64(args->n_scatters, j.n_scatters);
		ts_add_i64(args->n_writes, j.n_writes);
	}
	free_pools(&j);
	return made;
}

bool ts_c_fast_scatter(const void *of, u64 n, u32 threads) { return scatter(of, n, true, threads); }
bool ts_c_fast_scatter_pieces(const void *of, u64 n, u32 threads) { return scatter(of, n, false, threads); }

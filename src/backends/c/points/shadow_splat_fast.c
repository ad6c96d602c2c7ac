/* Fast path of EPR's shadow splats that are made piece by piece, with the same bits: the points of a piece are made
 * once for all views. Blocks of them are transformed side by side, in loops that compilers vectorize. A piece's edges
 * are evaluated as lines in (i, j). */
#include <omp.h>
#include <stdlib.h>
#include "backends/fast.h"
#include "backends/wide.h"
#include "kernels/points/shadow_splat.h"
#include "kernels/raster/cube.h"

enum { BLOCK = 64, MOST_VIEWS = 1024, PIECES_A_CHUNK = 64 };

/* Points of a piece, and their places in its lattice, where their squares tile the plane. */
typedef struct {
	f32 centre[3][BLOCK], place[3][BLOCK];
	u32 n;
} block;

/* A block as a view sees it. */
typedef struct {
	f32 z[BLOCK];
	i32 texel[BLOCK];  /* of a point that is written alone; -1: none */
	u32 square[BLOCK]; /* its splat is longer than a texel, and may reach into the view */
} places;
/* Points of a block whose splats are longer than a texel. */
typedef struct {
	f32 place[3][BLOCK], z[BLOCK];
	ts_box box[BLOCK]; /* of the square, not yet intersected with the view */
	f32 ahead[BLOCK];  /* of the nearest corner */
	u32 n;
} squares;

/* A piece as a view sees it. */
typedef struct {
	ts_shadow_caster of;
	ts_lines lines; /* set where of.has_cover is */
} caster;

/* What a thread works with. */
typedef struct {
	const ts_shadow_splat_args *args;
	u64 piece;
	ts_flight point;
	ts_v3 u, v;
	f32 slack;
	block points;
	caster *casters;
	u32 n_casters;
	ts_shadow_tally tally;
} worker;

/* ts_k_is_within_texel, and the texel of ts_k_scatter_into. A point farther outside a plane of the view than its square
 * reaches, by the margins of ts_k_misses, gets no square. */
TS_WIDE(void, place_points,
        (places *restrict to, const block *restrict b, ts_camera_k view, ts_v2 reach, f32 length, f32 cell),
        (to, b, view, reach, length, cell))
{
	f32 far = 2.0f * cell, far_x = far * (1.0f + reach.x), far_y = far * (1.0f + reach.y);
	for (u32 i = 0; i < b->n; i++) {
		ts_corner p = ts_k_to_view(&view, ts_v3_make(b->centre[0][i], b->centre[1][i], b->centre[2][i]));
		ts_v2 at = ts_k_project(&view, &p);
		f32 over_z = 1.0f / p.z;
		f32 scale = view.focal * (over_z * (ts_length(ts_v3_make(p.x, p.y, p.z)) * over_z));
		u32 within = (length * 1.42526209354400634765625f) * scale <= 1.0f ? 1u : 0u;
		within = p.z >= view.near ? within : 0u;
		u32 in = within, square = 1u - within;
		in = at.x >= 0.0f ? in : 0u;
		in = at.x < (f32)view.width ? in : 0u;
		in = at.y >= 0.0f ? in : 0u;
		in = at.y < (f32)view.height ? in : 0u;
		square = ts_abs(p.x) - reach.x * p.z > far_x ? 0u : square;
		square = ts_abs(p.y) - reach.y * p.z > far_y ? 0u : square;
		square = p.z < view.near - far ? 0u : square;
		i32 column = (i32)(in != 0u ? at.x : 0.0f);
		i32 row = (i32)(in != 0u ? at.y : 0.0f);
		to->texel[i] = in != 0u ? row * view.width + column : -1;
		to->square[i] = square;
		to->z[i] = p.z;
	}
}

/* The texels of the projected squares, like ts_k_splat_box where no corner is behind the near plane. */
TS_WIDE(void, put_boxes, (squares *restrict to, ts_camera_k view, ts_v3 du, ts_v3 dv, f32 widest, f32 slack),
        (to, view, du, dv, widest, slack))
{
	f32 width = (f32)view.width, height = (f32)view.height;
	for (u32 i = 0; i < to->n; i++) {
		ts_v3 c = ts_v3_make(to->place[0][i], to->place[1][i], to->place[2][i]);
		ts_v3 low = ts_sub(c, du), high = ts_add(c, du);
		ts_corner corner[4] = {ts_k_to_view(&view, ts_sub(low, dv)), ts_k_to_view(&view, ts_sub(high, dv)),
		                       ts_k_to_view(&view, ts_add(high, dv)), ts_k_to_view(&view, ts_add(low, dv))};
		ts_v2 p[4];
		for (u32 k = 0; k < 4; k++) p[k] = ts_k_project(&view, &corner[k]);
		f32 ahead = ts_min(ts_min(corner[0].z, corner[1].z), ts_min(corner[2].z, corner[3].z));
		f32 inset = ts_k_box_inset(widest, view.focal, slack, ahead);
		to->box[i].x0 = ts_k_floor_within(ts_min(ts_min(p[0].x, p[1].x), ts_min(p[2].x, p[3].x)) + inset, width);
		to->box[i].y0 = ts_k_floor_within(ts_min(ts_min(p[0].y, p[1].y), ts_min(p[2].y, p[3].y)) + inset, height);
		to->box[i].x1 = ts_k_floor_within(ts_max(ts_max(p[0].x, p[1].x), ts_max(p[2].x, p[3].x)) - inset, width);
		to->box[i].y1 = ts_k_floor_within(ts_max(ts_max(p[0].y, p[1].y), ts_max(p[2].y, p[3].y)) - inset, height);
		to->ahead[i] = ahead;
	}
}

static u32 *map_of(const ts_scatter_args *args, const ts_offscreen *view)
{
	return args->depths + (view->offset - args->views[args->first_view].offset);
}

/* Like ts_k_shadow_square. */
static void square(worker *w, const caster *c, ts_box box, f32 own)
{
	const ts_shadow_splat_args *args = w->args;
	const ts_camera_k *view = &c->of.view;
	u32 *map = map_of(&args->of, c->of.offscreen), count = 0;
	f32 least = ts_max(own, view->near);
	bool clip = args->clip != 0;
	if (clip || (w->point.flags & TS_POINT_TINY) != 0) box = ts_k_box_meet(box, c->of.cover.touched);
	for (i32 j = box.y0; j <= box.y1; j++) {
		for (i32 i = box.x0; i <= box.x1; i++) {
			if (clip && !ts_k_inside_lines(&c->lines, i, j)) continue;
			ts_min_u32(&map[(u64)j * (u64)view->width + (u64)i],
			           ts_f2u(ts_put(ts_k_shadow_depth(args, &c->of, least, i, j))));
			count++;
		}
	}
	w->tally.splats += count != 0;
	w->tally.texels += count;
}

static void splat(worker *w, caster *c, squares *of)
{
	const ts_camera_k *view = &c->of.view;
	ts_box all = ts_k_view_box(view);
	f32 length = w->point.length, half_length = length * 0.5f;
	if (!c->of.has_cover) {
		ts_k_shadow_cover(&w->args->of, &c->of, w->piece);
		if (c->of.cover.n != 0) ts_k_lines(&c->lines, &c->of.cover);
	}
	if (c->of.cover.n == 0) return;
	ts_square s = {.u = w->u, .v = w->v, .length = length, .slack = w->slack};
	put_boxes(of, *view, ts_scale(w->u, half_length), ts_scale(w->v, half_length), w->args->inset, w->slack);
	for (u32 i = 0; i < of->n; i++) {
		s.c = ts_v3_make(of->place[0][i], of->place[1][i], of->place[2][i]);
		bool behind = ts_flush(of->ahead[i] - view->near) < 0.0f;
		ts_box box = behind ? ts_k_splat_box(view, &s, w->args->inset) : ts_k_box_meet(of->box[i], all);
		square(w, c, box, of->z[i]);
	}
}

static void scatter_block(worker *w, caster *c)
{
	places p;
	squares s;
	const block *b = &w->points;
	const ts_offscreen *offscreen = c->of.offscreen;
	u32 *map = map_of(&w->args->of, offscreen);
	ts_v2 reach = ts_v2_make(offscreen->reach[0], offscreen->reach[1]);
	place_points(&p, b, c->of.view, reach, w->point.length, 1.0f / w->args->of.from.frames[w->piece].s);
	w->tally.of.scatters += b->n;
	s.n = 0;
	for (u32 i = 0; i < b->n; i++) {
		if (p.texel[i] >= 0) {
			ts_min_u32(&map[p.texel[i]], ts_f2u(ts_put(p.z[i])));
			w->tally.of.writes++;
		} else if (p.square[i] != 0) {
			for (u32 axis = 0; axis < 3; axis++) s.place[axis][s.n] = b->place[axis][i];
			s.z[s.n++] = p.z[i];
		}
	}
	if (s.n > 0) splat(w, c, &s);
}

static void flush(worker *w)
{
	if (w->points.n == 0) return;
	for (u32 k = 0; k < w->n_casters; k++) scatter_block(w, &w->casters[k]);
	w->tally.of.points += w->points.n;
	w->points.n = 0;
}

static void add_point(worker *w, i32 x, i32 y)
{
	block *b = &w->points;
	ts_v3 lattice = ts_k_lattice_point(&w->args->of.from.frames[w->piece], x, y);
	ts_k_flight_start(&w->args->of.from, &w->point, x, y);
	for (u32 axis = 0; axis < 3; axis++) {
		b->centre[axis][b->n] = ts_k_along(w->point.centre, axis);
		b->place[axis][b->n] = ts_k_along(lattice, axis);
	}
	if (++b->n == BLOCK) flush(w);
}

/* Finds the views that a point of the piece may reach. */
static void find_casters(worker *w)
{
	const ts_scatter_args *args = &w->args->of;
	const u64 *words = args->bits + (u64)args->from.pieces[w->piece].triangle * args->n_words;
	w->n_casters = 0;
	for (u32 v = args->first_view; v < args->first_view + args->n_views; v++) {
		if (!ts_k_offscreen_bit(words, v)) continue;
		caster *c = &w->casters[w->n_casters];
		c->of = ts_k_shadow_caster(args, v, &w->point);
		w->n_casters += !c->of.misses;
	}
}

static void scatter_piece(worker *w, u64 piece)
{
	const ts_points_args *from = &w->args->of.from;
	const ts_align *frame = &from->frames[piece];
	if (!(frame->s > 0.0f)) return;
	w->piece = piece;
	w->point = ts_k_flight_of_piece(from, piece);
	w->u = ts_load3(frame->u);
	w->v = ts_load3(frame->v);
	w->slack = ts_k_piece_slack(&from->pieces[piece]);
	find_casters(w);
	if (w->n_casters == 0 && w->args->of.first_view != 0) return;
	ts_cover cover = ts_k_lattice_cover(frame, from->half_size);
	for (i32 y = cover.touched.y0; y <= cover.touched.y1; y++) {
		for (i32 x = cover.touched.x0; x <= cover.touched.x1; x++) {
			if (ts_k_is_point(from, &cover, piece, x, y)) add_point(w, x, y);
		}
	}
	flush(w);
}

/* The first batch counts the points. */
static void work(worker *w, i64 n, ts_stop *stop)
{
#pragma omp for schedule(dynamic, PIECES_A_CHUNK)
	for (i64 i = 0; i < n; i++) {
		if (ts_stopped(stop)) continue;
		scatter_piece(w, (u64)i);
	}
	if (w->args->of.first_view != 0) w->tally.of.points = 0;
	ts_k_shadow_count(w->args, &w->tally);
}

bool ts_c_fast_shadow_splat_pieces(const void *of, u64 n, u32 threads)
{
	const ts_shadow_splat_args *args = of;
	u32 n_views = args->of.n_views;
	caster *casters = n_views <= MOST_VIEWS ? malloc((size_t)threads * n_views * sizeof *casters) : NULL;
	worker *workers = calloc(threads, sizeof *workers);
	bool made = casters != NULL && workers != NULL;
	for (u32 t = 0; made && t < threads; t++) {
		workers[t].args = args;
		workers[t].casters = casters + (size_t)t * n_views;
	}
	ts_stop *stop = ts_stop_here();
	if (made) {
#pragma omp parallel num_threads(threads)
		work(&workers[omp_get_thread_num()], (i64)n, stop);
	}
	free(workers);
	free(casters);
	return made;
}

#include "backends/selftest.h"

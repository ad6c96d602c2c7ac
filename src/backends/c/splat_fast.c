/* Fast path of the splat kernel, with the same bits: a thread owns a cube face, so there are no atomics; a piece is
 * projected once for all its points; edges are evaluated as lines in (i, j). */
#include "../backend.h"

/* Inside where x i + y j + c >= 0. */
typedef struct { i64 x, y, c; } line;
typedef struct { line edge[TS_MAX_CORNERS]; u32 n; } lines;

static lines make_lines(const ts_cover *cover)
{
	lines r = {.n = cover->n};
	i64 sign = cover->turned ? -1 : 1;
	for (u32 k = 0; k < cover->n; k++) {
		ts_snapped a = cover->v[k];
		ts_snapped b = cover->v[k + 1 < cover->n ? k + 1 : 0];
		i64 dx = b.x - a.x;
		i64 dy = b.y - a.y;
		i64 reach = cover->half_size * ((dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy));
		r.edge[k] = (line){-sign * dy * 256, sign * dx * 256, sign * (dx * (128 - a.y) - dy * (128 - a.x)) + reach};
	}
	return r;
}

static bool inside(const lines *l, i32 i, i32 j)
{
	for (u32 k = 0; k < l->n; k++) {
		if (l->edge[k].x * i + l->edge[k].y * j + l->edge[k].c < 0) return false;
	}
	return true;
}

/* A piece as one face sees it. */
typedef struct {
	const ts_splat_args *args;
	ts_camera_k view;
	ts_cover cover;
	lines lines;
	ts_v3 u, v, n;
	u64 *texels;
	i64 scatters, writes;
} face;

static void splat_point(face *f, u32 index)
{
	const ts_point *point = &f->args->points[index];
	bool clip = f->args->clip != 0;
	ts_v3 c = ts_load3(point->centre);
	ts_box box = ts_k_splat_box(&f->view, c, f->u, f->v, point->length);
	if (clip || (point->flags & TS_POINT_TINY) != 0) box = ts_k_box_meet(box, f->cover.touched);
	f32 distance = ts_put(ts_length(ts_sub(c, f->view.eye)));
	for (i32 j = box.y0; j <= box.y1; j++) {
		u64 *row = f->texels + (u64)j * (u64)f->view.width;
		for (i32 i = box.x0; i <= box.x1; i++) {
			if (clip && !inside(&f->lines, i, j)) continue;
			f32 d = distance;
			if (f->args->plane_depth != 0) {
				d = ts_put(ts_k_plane_distance(&f->view, f->n, c, distance, point->length, i, j));
			}
			u64 key = ((u64)ts_f2u(d) << 32) | index;
			row[i] = key < row[i] ? key : row[i];
			f->writes++;
		}
	}
}

static bool misses(const face *f)
{
	ts_box box = ts_k_box_meet(f->cover.touched, ts_k_view_box(&f->view));
	return f->args->clip != 0 && (box.x1 < box.x0 || box.y1 < box.y0);
}

static void splat_piece(face *f, u64 piece, u32 begin, u32 end)
{
	f->cover = ts_k_splat_triangle(&f->view, &f->args->pieces[piece]);
	if (f->cover.n == 0) return;
	f->scatters += end - begin;
	if (misses(f)) return;
	f->lines = make_lines(&f->cover);
	f->u = ts_load3(f->args->frames[piece].u);
	f->v = ts_load3(f->args->frames[piece].v);
	f->n = ts_cross(f->u, f->v);
	for (u32 i = begin; i < end; i++) splat_point(f, i);
}

static void splat_face(const ts_splat_args *args, const u32 *offset, u64 n_pieces, u32 cube_index, u32 side)
{
	const ts_face *cube = &args->cubes[cube_index];
	face f = {.args = args, .view = ts_k_cube_view(cube, side)};
	f.texels = args->texels + cube->offset + (u64)side * cube->n * cube->n;
	for (u64 piece = 0; cube->n != 0 && piece < n_pieces; piece++) {
		if (offset[piece + 1] == offset[piece]) continue;
		const u64 *words = args->bits + (u64)args->pieces[piece].triangle * args->n_words;
		if ((ts_k_cube_bits(words, cube_index) >> side & 1) == 0) continue;
		splat_piece(&f, piece, offset[piece], offset[piece + 1]);
	}
	ts_add_i64(args->n_scatters, f.scatters);
	ts_add_i64(args->n_writes, f.writes);
}

void ts_c_splat_fast(const ts_splat_args *args, const u32 *offset, u64 n_pieces, u32 threads)
{
	i64 n_faces = (i64)args->n_cubes * 6;
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
	for (i64 i = 0; i < n_faces; i++) splat_face(args, offset, n_pieces, (u32)(i / 6), (u32)(i % 6));
}

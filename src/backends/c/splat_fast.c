/* Fast path of the splat kernel, with the same bits: a thread owns a cube face, so there are no atomics; a piece is
 * projected once for all its points; the four corners of a square go through a face's axes, which are the world's but for
 * sign and order, side by side; edges are evaluated as lines in (i, j). */
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

/* Four numbers side by side; each is rounded as if it were alone. */
typedef f32 lanes __attribute__((vector_size(16)));

/* A row of a face: a world axis and a sign. */
typedef struct { u32 axis; f32 sign; } row;

static row make_row(ts_v3 v)
{
	return v.x != 0.0f ? (row){0, v.x} : v.y != 0.0f ? (row){1, v.y} : (row){2, v.z};
}

/* A piece as one face sees it. */
typedef struct {
	const ts_splat_args *args;
	ts_camera_k view;
	row right, up, ahead;
	ts_cover cover;
	lines lines;
	ts_v3 u, v, n;
	u64 *texels;
	i64 scatters, writes;
} face;

static f32 least(lanes v) { return ts_min(ts_min(v[0], v[1]), ts_min(v[2], v[3])); }
static f32 greatest(lanes v) { return ts_max(ts_max(v[0], v[1]), ts_max(v[2], v[3])); }

/* One world coordinate of the four corners, from the eye: ((c -+ du) -+ dv) - eye. */
static lanes corners(f32 c, f32 du, f32 dv, f32 eye)
{
	f32 low = c - du;
	f32 high = c + du;
	lanes r = {low - dv, high - dv, high + dv, low + dv};
	return r - eye;
}

/* ts_k_splat_box of this face. */
static ts_box square_box(const face *f, ts_v3 c, f32 length)
{
	f32 half_length = length * 0.5f;
	ts_v3 du = ts_scale(f->u, half_length);
	ts_v3 dv = ts_scale(f->v, half_length);
	const ts_v3 *eye = &f->view.eye;
	lanes d[3] = {corners(c.x, du.x, dv.x, eye->x), corners(c.y, du.y, dv.y, eye->y), corners(c.z, du.z, dv.z, eye->z)};
	lanes z = d[f->ahead.axis] * f->ahead.sign;
	if (ts_flush(least(z) - f->view.near) < 0.0f) return ts_k_splat_box(&f->view, c, f->u, f->v, length);
	lanes x = (d[f->right.axis] * f->right.sign) * f->view.focal / z + (f32)f->view.width * 0.5f;
	lanes y = (f32)f->view.height * 0.5f - (d[f->up.axis] * f->up.sign) * f->view.focal / z;
	ts_box box = ts_k_extent_box(ts_v2_make(least(x), least(y)), ts_v2_make(greatest(x), greatest(y)));
	return ts_k_box_meet(box, ts_k_view_box(&f->view));
}

static void write_texel(face *f, const ts_point *point, u32 index, ts_v3 c, f32 distance, i32 i, i32 j)
{
	f32 d = distance;
	if (f->args->plane_depth != 0) {
		d = ts_put(ts_k_plane_distance(&f->view, f->n, c, distance, point->length, i, j));
	}
	u64 *texel = &f->texels[(u64)j * (u64)f->view.width + (u64)i];
	u64 key = ((u64)ts_f2u(d) << 32) | index;
	*texel = key < *texel ? key : *texel;
	f->writes++;
}

static void splat_point(face *f, u32 index)
{
	const ts_point *point = &f->args->points[index];
	bool clip = f->args->clip != 0;
	ts_v3 c = ts_load3(point->centre);
	ts_box box = square_box(f, c, point->length);
	if (clip || (point->flags & TS_POINT_TINY) != 0) box = ts_k_box_meet(box, f->cover.touched);
	f32 distance = ts_put(ts_length(ts_sub(c, f->view.eye)));
	for (i32 j = box.y0; j <= box.y1; j++) {
		for (i32 i = box.x0; i <= box.x1; i++) {
			if (!clip || inside(&f->lines, i, j)) write_texel(f, point, index, c, distance, i, j);
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
	f.right = make_row(f.view.right);
	f.up = make_row(f.view.up);
	f.ahead = make_row(ts_neg(f.view.back));
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

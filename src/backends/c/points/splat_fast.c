/* Fast path of the splat kernel, with the same bits: a thread owns a cube face, so there are no atomics; a piece is
 * projected once for all its points; the squares of a block of points go side by side through a face's axes, which
 * are the world's but for sign and order, in loops that compilers vectorize; edges are evaluated as lines in (i, j). */
#include "../../../kernels/points/splat_pieces.h"
#include "../../fast.h"

/* A piece as one face sees it. */
typedef struct {
	const ts_splat_args *args;
	ts_camera_k view;
	ts_row right, up, ahead;
	ts_cover cover;
	ts_lines lines;
	ts_v3 u, v, n;
	u64 *texels;
	i64 scatters, writes;
} face;

/* The points of a piece into a face that it was set up for. */
typedef void splat_points(face *f, u64 piece);

/* Points of a piece side by side, a multiple of four; the first fills up. */
enum { BLOCK = 32 };
typedef struct {
	u32 n;
	f32 corner[3][4][BLOCK]; /* of the squares, on the face's axes: right, up, ahead */
	f32 ahead[BLOCK];        /* of the nearest corner */
	f32 distance[BLOCK];
	ts_box box[BLOCK];
} block;

/* One coordinate of the corners of n squares, from the eye: ((c -+ du) -+ dv) - eye. */
static void put_corners(f32 corner[4][BLOCK], u32 n, const f32 *c, f32 du, f32 dv, f32 eye, f32 sign)
{
	for (u32 i = 0; i < n; i++) {
		f32 low = c[i] - du;
		f32 high = c[i] + du;
		corner[0][i] = ((low - dv) - eye) * sign;
		corner[1][i] = ((high - dv) - eye) * sign;
		corner[2][i] = ((high + dv) - eye) * sign;
		corner[3][i] = ((low + dv) - eye) * sign;
	}
}

/* The texels of the projected squares, like ts_k_splat_box but not yet met with the face. */
static void put_boxes(const face *f, block *b)
{
	f32 size = (f32)f->view.width;
	f32 middle = size * 0.5f;
	for (u32 i = 0; i < b->n; i++) {
		f32 x[4], y[4];
		for (u32 k = 0; k < 4; k++) {
			x[k] = middle + (f->view.focal * b->corner[0][k][i]) / b->corner[2][k][i];
			y[k] = middle - (f->view.focal * b->corner[1][k][i]) / b->corner[2][k][i];
		}
		b->box[i].x0 = ts_k_floor_within(ts_min(ts_min(x[0], x[1]), ts_min(x[2], x[3])), size);
		b->box[i].y0 = ts_k_floor_within(ts_min(ts_min(y[0], y[1]), ts_min(y[2], y[3])), size);
		b->box[i].x1 = ts_k_floor_within(ts_max(ts_max(x[0], x[1]), ts_max(x[2], x[3])), size);
		b->box[i].y1 = ts_k_floor_within(ts_max(ts_max(y[0], y[1]), ts_max(y[2], y[3])), size);
		b->ahead[i] =
			ts_min(ts_min(b->corner[2][0][i], b->corner[2][1][i]), ts_min(b->corner[2][2][i], b->corner[2][3][i]));
	}
}

/* Squares and distances of n points, n <= BLOCK; all of one piece, so of one length. */
static void measure(const face *f, block *b, const ts_point *points, u32 n)
{
	f32 centre[3][BLOCK];
	b->n = (n + 3) / 4 * 4;
	for (u32 i = 0; i < b->n; i++) {
		const ts_point *point = &points[i < n ? i : 0];
		for (u32 axis = 0; axis < 3; axis++) centre[axis][i] = point->centre[axis];
	}
	f32 half_length = points->length * 0.5f;
	ts_v3 u = ts_scale(f->u, half_length);
	ts_v3 v = ts_scale(f->v, half_length);
	const f32 du[3] = {u.x, u.y, u.z}, dv[3] = {v.x, v.y, v.z};
	const f32 eye[3] = {f->view.eye.x, f->view.eye.y, f->view.eye.z};
	const ts_row rows[3] = {f->right, f->up, f->ahead};
	for (u32 r = 0; r < 3; r++) {
		u32 axis = rows[r].axis;
		put_corners(b->corner[r], b->n, centre[axis], du[axis], dv[axis], eye[axis], rows[r].sign);
	}
	put_boxes(f, b);
	for (u32 i = 0; i < b->n; i++) {
		ts_v3 c = ts_v3_make(centre[0][i], centre[1][i], centre[2][i]);
		b->distance[i] = ts_put(ts_length(ts_sub(c, f->view.eye)));
	}
}

static void write_texel(face *f, const ts_point *point, u32 word, ts_v3 c, f32 distance, i32 i, i32 j)
{
	f32 d = distance;
	if (f->args->plane_depth != 0) {
		d = ts_put(ts_k_plane_distance(&f->view, f->n, c, distance, point->length, i, j));
	}
	u64 *texel = &f->texels[(u64)j * (u64)f->view.width + (u64)i];
	u64 key = ((u64)ts_f2u(d) << 32) | word;
	*texel = key < *texel ? key : *texel;
	f->writes++;
}

static void splat_point(face *f, const ts_point *point, u32 word, ts_box box, f32 distance)
{
	bool clip = f->args->clip != 0;
	ts_v3 c = ts_load3(point->centre);
	if (clip || (point->flags & TS_POINT_TINY) != 0) box = ts_k_box_meet(box, f->cover.touched);
	for (i32 j = box.y0; j <= box.y1; j++) {
		for (i32 i = box.x0; i <= box.x1; i++) {
			if (!clip || ts_k_inside_lines(&f->lines, i, j)) write_texel(f, point, word, c, distance, i, j);
		}
	}
}

/* n points, the first of index `begin`. */
static void splat_block(face *f, const ts_point *points, u32 begin, u32 n)
{
	block b;
	ts_box all = ts_k_view_box(&f->view);
	measure(f, &b, points, n);
	for (u32 i = 0; i < n; i++) {
		const ts_point *point = &points[i];
		bool behind = ts_flush(b.ahead[i] - f->view.near) < 0.0f;
		ts_box box = behind ? ts_k_splat_box(&f->view, ts_load3(point->centre), f->u, f->v, point->length)
		                    : ts_k_box_meet(b.box[i], all);
		splat_point(f, point, ts_k_splat_word(f->args, begin + i), box, b.distance[i]);
	}
}

static void splat_stored(face *f, u64 piece)
{
	u32 end = f->args->from.offset[piece + 1];
	for (u32 i = f->args->from.offset[piece]; i < end; i += BLOCK) {
		splat_block(f, f->args->from.points + i, i, end - i < BLOCK ? end - i : BLOCK);
	}
}

/* Points that are made and not kept, for each face again. */
static void splat_made(face *f, u64 piece)
{
	const ts_points_args *from = &f->args->from;
	ts_point points[BLOCK];
	u32 begin = from->offset[piece], n = 0;
	ts_cover cover = ts_k_lattice_cover(&from->frames[piece], from->half_size);
	ts_flight point = ts_k_flight_of_piece(from, piece);
	for (i32 y = cover.touched.y0; y <= cover.touched.y1; y++) {
		for (i32 x = cover.touched.x0; x <= cover.touched.x1; x++) {
			if (!ts_k_is_point(from, &cover, piece, x, y)) continue;
			ts_k_flight_start(from, &point, x, y);
			points[n] = (ts_point){.length = point.length, .flags = point.flags};
			ts_store3(points[n++].centre, point.centre);
			if (n < BLOCK) continue;
			splat_block(f, points, begin, n);
			begin += n;
			n = 0;
		}
	}
	if (n > 0) splat_block(f, points, begin, n);
}

static bool misses(const face *f)
{
	ts_box box = ts_k_box_meet(f->cover.touched, ts_k_view_box(&f->view));
	return f->args->clip != 0 && (box.x1 < box.x0 || box.y1 < box.y0);
}

static void splat_piece(face *f, u64 piece, splat_points *points)
{
	f->cover = ts_k_splat_triangle(&f->view, &f->args->from.pieces[piece]);
	if (f->cover.n == 0) return;
	f->scatters += f->args->from.offset[piece + 1] - f->args->from.offset[piece];
	if (misses(f)) return;
	ts_k_lines(&f->lines, &f->cover);
	f->u = ts_load3(f->args->from.frames[piece].u);
	f->v = ts_load3(f->args->from.frames[piece].v);
	f->n = ts_cross(f->u, f->v);
	points(f, piece);
}

static void splat_face(const ts_splat_args *args, u32 cube_index, u32 side, splat_points *points)
{
	const ts_face *cube = &args->cubes[cube_index];
	const u32 *offset = args->from.offset;
	face f = {.args = args, .view = ts_k_cube_view(cube, side)};
	f.texels = args->texels + cube->offset + (u64)side * cube->n * cube->n;
	f.right = ts_k_row(f.view.right);
	f.up = ts_k_row(f.view.up);
	f.ahead = ts_k_row(ts_neg(f.view.back));
	for (u64 piece = 0; cube->n != 0 && piece < args->n_pieces; piece++) {
		if (offset[piece + 1] == offset[piece]) continue;
		const u64 *words = args->bits + (u64)args->from.pieces[piece].triangle * args->n_words;
		if ((ts_k_cube_bits(words, cube_index) >> side & 1) == 0) continue;
		splat_piece(&f, piece, points);
	}
	ts_add_i64(args->n_scatters, f.scatters);
	ts_add_i64(args->n_writes, f.writes);
}

static bool splat_faces(const ts_splat_args *args, u32 threads, splat_points *points)
{
	if (args->from.offset == NULL || args->mark != 0) return false;
	i64 n_faces = (i64)args->n_cubes * 6;
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
	for (i64 i = 0; i < n_faces; i++) splat_face(args, (u32)(i / 6), (u32)(i % 6), points);
	return true;
}

/* Points that stand by piece, and nothing to mark. */
bool ts_c_fast_splat(const void *of, u64 n, u32 threads)
{
	(void)n;
	return splat_faces(of, threads, splat_stored);
}

bool ts_c_fast_splat_fragments(const void *of, u64 n, u32 threads)
{
	(void)n;
	return splat_faces(of, threads, splat_made);
}

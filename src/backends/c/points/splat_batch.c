/* Pieces side by side: projected, snapped, and their edges as lines, like ts_k_splat_triangle and ts_k_lines where no
 * plane clips. */
#include "backends/c/points/splat_batch.h"
#include <stdlib.h>
#include "backends/wide.h"
#include "kernels/points/splat_pieces.h"

enum { PIECES = TS_SPLAT_PIECES, LANES = TS_SPLAT_LANES, LONGEST = 1 << 18, HALF_SIZE = TS_SAFE_HALF };

ts_splat_face ts_splat_face_begin(const ts_splat_args *args, u32 cube, u32 side)
{
	const ts_face *of = &args->cubes[cube];
	ts_splat_face f = {
		.args = args, .view = ts_k_cube_view(of, side), .inset = args->inset, .cube = cube, .side = side};
	f.texels = args->texels + of->offset + (u64)side * of->n * of->n;
	f.tie = args->mark != 0 ? args->tie + (f.texels - args->texels) : NULL;
	f.row[0] = ts_k_row(f.view.right);
	f.row[1] = ts_k_row(f.view.up);
	f.row[2] = ts_k_row(ts_neg(f.view.back));
	f.eye[0] = f.view.eye.x;
	f.eye[1] = f.view.eye.y;
	f.eye[2] = f.view.eye.z;
	return f;
}

/* What all lanes share; [3] is right, up, ahead. */
typedef struct {
	f32 eye[3], sign[3];
	f32 focal, middle, near;
	i32 last; /* texel of a row or column */
	i32 keep; /* 0: edges do not count */
	u32 clip, together;
} lanes;

/* Coordinates right, up, ahead of a corner of all live pieces. */
typedef struct {
	const f32 *right, *up, *ahead;
} ends;

/* A snapped corner; `ok` is 0 near the eye or a plane of the snapping range. */
typedef struct {
	i32 x, y;
	u32 ok;
} snapped;

static inline snapped snap(const lanes *f, ends from, u32 at)
{
	f32 x = (from.right[at] - f->eye[0]) * f->sign[0], y = (from.up[at] - f->eye[1]) * f->sign[1];
	f32 z = (from.ahead[at] - f->eye[2]) * f->sign[2];
	f32 px = f->middle + (f->focal * x) / z, py = f->middle - (f->focal * y) / z;
	u32 ok = (z >= f->near ? 1u : 0u) & (ts_abs(px) < 8192.0f ? 1u : 0u) & (ts_abs(py) < 8192.0f ? 1u : 0u);
	return (snapped){(i32)ts_rint(ok != 0u ? px * 256.0f : 0.0f), (i32)ts_rint(ok != 0u ? py * 256.0f : 0.0f), ok};
}

static inline i32 least(i32 a, i32 b, i32 c) { return ts_min_i32(ts_min_i32(a, b), c); }
static inline i32 most(i32 a, i32 b, i32 c) { return ts_max_i32(ts_max_i32(a, b), c); }
static inline i32 size_of(i32 x) { return x < 0 ? -x : x; }

/* A line of ts_k_lines by 256, from texel (i, j): its terms in (i, j) are multiples of that. */
typedef struct {
	i32 x, y, c;
} line;

/* `turned` is -1 where the area is negative. For an unseen triangle the line may be anything. */
static inline line edge(snapped a, snapped b, i32 turned, i32 i, i32 j)
{
	i32 dx = ((b.x - a.x) ^ turned) - turned, dy = ((b.y - a.y) ^ turned) - turned;
	i32 within = dx * (128 - (a.y & 255)) - dy * (128 - (a.x & 255)) + HALF_SIZE * (size_of(dx) + size_of(dy));
	u32 c = (u32)dx * (u32)(j - (a.y >> 8)) - (u32)dy * (u32)(i - (a.x >> 8));
	return (line){-dy, dx, (i32)(c + (u32)(within >> 8))};
}

/* (a d - b c) / 512, rounded down: the sign is the area's. Edges beyond LONGEST overflow. */
static inline i32 area_of(i32 a, i32 b, i32 c, i32 d)
{
	u32 high = (u32)a * (u32)(d >> 9) - (u32)b * (u32)(c >> 9);
	i32 low = (i32)((u32)a * (u32)(d & 511) - (u32)b * (u32)(c & 511));
	return (i32)(high + (u32)(low >> 9));
}

TS_WIDE(void, place_pieces,
        (ts_splat_batch *restrict b, lanes f, const u32 *restrict tiny, ends from, ends to, ends last),
        (b, f, tiny, from, to, last))
{
	u32 n = (b->n + LANES - 1) / LANES * LANES;
	for (u32 i = 0; i < n; i++) {
		u32 at = b->live[i];
		snapped p = snap(&f, from, at), q = snap(&f, to, at), r = snap(&f, last, at);
		i32 x0 = least(p.x, q.x, r.x), x1 = most(p.x, q.x, r.x), y0 = least(p.y, q.y, r.y), y1 = most(p.y, q.y, r.y);
		u32 small = (x1 - x0 <= LONGEST ? 1u : 0u) & (y1 - y0 <= LONGEST ? 1u : 0u);
		u32 together = p.ok & q.ok & r.ok & small & f.together;
		u32 within = f.clip | tiny[at];
		x0 = ts_max_i32(within != 0u ? (x0 - HALF_SIZE + TS_SUB_FIRST) >> 8 : 0, 0);
		y0 = ts_max_i32(within != 0u ? (y0 - HALF_SIZE + TS_SUB_FIRST) >> 8 : 0, 0);
		x1 = ts_min_i32(within != 0u ? (x1 + HALF_SIZE - TS_SUB_CENTRE) >> 8 : f.last, f.last);
		y1 = ts_min_i32(within != 0u ? (y1 + HALF_SIZE - TS_SUB_CENTRE) >> 8 : f.last, f.last);
		u32 seen = (x1 >= x0 ? 1u : 0u) & (y1 >= y0 ? 1u : 0u);
		i32 turned = area_of(q.x - p.x, q.y - p.y, r.x - p.x, r.y - p.y) >> 31;
		line a = edge(p, q, turned, x0, y0), c = edge(q, r, turned, x0, y0), e = edge(r, p, turned, x0, y0);
		b->way[i] = together == 0u ? TS_SPLAT_ALONE : seen != 0u ? TS_SPLAT_TOGETHER : TS_SPLAT_UNSEEN;
		b->whole[0][i] = x0;
		b->whole[1][i] = y0;
		b->whole[2][i] = x1;
		b->whole[3][i] = y1;
		b->whole[4][i] = a.x & f.keep;
		b->whole[5][i] = a.y & f.keep;
		b->whole[6][i] = a.c & f.keep;
		b->whole[7][i] = c.x & f.keep;
		b->whole[8][i] = c.y & f.keep;
		b->whole[9][i] = c.c & f.keep;
		b->whole[10][i] = e.x & f.keep;
		b->whole[11][i] = e.y & f.keep;
		b->whole[12][i] = e.c & f.keep;
	}
}

static ends ends_of(const ts_splat_face *f, f32 *const corner[3])
{
	return (ends){corner[f->row[0].axis], corner[f->row[1].axis], corner[f->row[2].axis]};
}

void ts_splat_batch_place(ts_splat_batch *b, const ts_splat_face *f, const ts_splat_live *live)
{
	lanes of = {.focal = f->view.focal,
	            .middle = (f32)f->view.width * 0.5f,
	            .near = f->view.near,
	            .last = f->view.width - 1,
	            .keep = f->args->clip != 0 ? -1 : 0,
	            .clip = f->args->clip != 0,
	            .together = f->args->plane_depth == 0};
	for (u32 k = 0; k < 3; k++) {
		of.eye[k] = f->eye[f->row[k].axis];
		of.sign[k] = f->row[k].sign;
	}
	for (u32 i = b->n; i % LANES != 0; i++) b->live[i] = 0;
	place_pieces(b, of, live->tiny, ends_of(f, live->corner), ends_of(f, live->corner + 3),
	             ends_of(f, live->corner + 6));
}

ts_box ts_splat_batch_box_of(const ts_splat_batch *b, u32 k)
{
	return (ts_box){b->whole[0][k], b->whole[1][k], b->whole[2][k], b->whole[3][k]};
}

/* The line at the corners of a box: the least, and the largest by size. */
typedef struct {
	i64 least, size;
} extremes;

static extremes at_corners(const ts_line *l, ts_box box)
{
	extremes r = {INT64_MAX, 0};
	for (u32 corner = 0; corner < 4; corner++) {
		i64 x = corner & 1 ? box.x1 : box.x0, y = corner & 2 ? box.y1 : box.y0;
		i64 at = l->x * x + l->y * y + l->c;
		r.least = at < r.least ? at : r.least;
		r.size = llabs(at) > r.size ? llabs(at) : r.size;
	}
	return r;
}

/* x and y of lines are multiples of 256. */
bool ts_splat_batch_box(ts_splat_batch *b, u32 k, ts_box box, const ts_lines *lines)
{
	const i32 box_of[TS_SPLAT_EDGES] = {box.x0, box.y0, box.x1, box.y1};
	for (u32 s = 0; s < TS_SPLAT_EDGES; s++) b->whole[s][k] = box_of[s];
	for (u32 s = TS_SPLAT_EDGES; s < TS_SPLAT_WHOLES; s++) b->whole[s][k] = 0;
	u32 s = TS_SPLAT_EDGES;
	for (u32 i = 0; i < lines->n; i++) {
		const ts_line *l = &lines->edge[i];
		extremes at = at_corners(l, box);
		if (at.least >= 0) continue;
		if (s == TS_SPLAT_WHOLES || at.size >> 8 > INT32_MAX) return false;
		b->whole[s++][k] = (i32)(l->x >> 8);
		b->whole[s++][k] = (i32)(l->y >> 8);
		b->whole[s++][k] = (i32)((l->x * box.x0 + l->y * box.y0 + l->c) >> 8);
	}
	return true;
}

#include "backends/selftest.h"

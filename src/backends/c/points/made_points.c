/* Points of a piece side by side: the lattice's in loops without branches, which compilers vectorize; then the samples
 * beside the piece, which move to its border. */
#include "backends/c/points/made_points.h"
#include "backends/wide.h"

enum { PART = 256, LANES = TS_MADE_LANES };

static u32 padded(u32 n) { return (n + LANES - 1) / LANES * LANES; }

ts_made_piece ts_made_piece_begin(const ts_points_args *from, u64 piece)
{
	const ts_piece *of = &from->pieces[piece];
	const ts_align *frame = &from->frames[piece];
	const f32 *corners[3] = {of->a, of->b, of->c};
	ts_made_piece r = {.from = from, .piece = piece, .cover = ts_k_lattice_cover(frame, from->half_size)};
	ts_k_lines(&r.lines, &r.cover);
	r.masked = ts_k_is_masked(&from->scene, of->triangle);
	if (r.masked) r.mask = ts_sample_mask_of(&from->scene, frame, of->triangle);
	for (u32 k = 0; k < 3; k++) {
		r.corner[k] =
			ts_k_lattice(ts_load3(frame->c), ts_load3(frame->u), ts_load3(frame->v), frame->s, ts_load3(corners[k]));
	}
	return r;
}

bool ts_made_is_point(const ts_made_piece *p, i32 x, i32 y)
{
	return ts_k_touches(&p->cover, x, y) && !(p->masked && ts_sample_mask_cuts(&p->mask, x, y));
}

static u32 count_masked(const ts_made_piece *p, i32 y)
{
	u32 n = 0;
	for (i32 x = p->cover.touched.x0; x <= p->cover.touched.x1; x++) {
		n += ts_made_is_point(p, x, y) ? 1 : 0;
	}
	return n;
}

u64 ts_made_piece_count(const ts_made_piece *p)
{
	u64 n = 0;
	for (i32 y = p->cover.touched.y0; y <= p->cover.touched.y1; y++) {
		ts_span row = ts_k_touched_row(&p->lines, p->cover.touched, y);
		n += p->masked ? count_masked(p, y) : (u32)(row.last - row.first + 1);
	}
	return n;
}

typedef struct {
	ts_v3 low, high;
} limits;

static void widen(limits *to, ts_v3 p)
{
	to->low = ts_min3(to->low, p);
	to->high = ts_max3(to->high, p);
}

/* A coordinate of a sample never falls, or never rises, along rows and columns, so four samples bound all; those that
 * moved are on the piece's border, but for rounding. */
ts_bounds ts_made_piece_bounds(const ts_made_piece *p)
{
	const f32 rounding = 0x1p-18f;
	const ts_piece *piece = &p->from->pieces[p->piece];
	ts_box box = p->cover.touched;
	limits all = {ts_load3(piece->a), ts_load3(piece->a)};
	widen(&all, ts_load3(piece->b));
	widen(&all, ts_load3(piece->c));
	for (u32 k = 0; k < 4; k++) {
		i32 x = k % 2 == 0 ? box.x0 : box.x1, y = k / 2 == 0 ? box.y0 : box.y1;
		widen(&all, ts_k_lattice_point(&p->from->frames[p->piece], x, y));
	}
	ts_v3 middle = ts_scale(ts_add(all.low, all.high), 0.5f), half = ts_scale(ts_sub(all.high, all.low), 0.5f);
	ts_bounds r;
	ts_store3(r.middle, middle);
	ts_store3(r.half, half);
	for (u32 axis = 0; axis < 3; axis++) r.half[axis] += rounding * (ts_abs(r.middle[axis]) + r.half[axis]);
	return r;
}

/* A row of the lattice, from sample x on. */
typedef struct {
	ts_v3 c, u, v;
	f32 s, down, middle; /* y / s, y + 1/2 */
	ts_v2 corner[3];
	i32 x;
	u32 n;
} samples;

/* ts_k_lattice_point and ts_k_is_in_piece. */
TS_WIDE(void, make_samples, (samples of, f32 *restrict x, f32 *restrict y, f32 *restrict z, u32 *restrict in),
        (of, x, y, z, in))
{
	ts_v2 q0 = of.corner[0], q1 = of.corner[1], q2 = of.corner[2];
	f32 row = of.middle;
	for (u32 i = 0; i < padded(of.n); i++) {
		f32 column = (f32)(of.x + (i32)i), across = column / of.s, middle = column + 0.5f;
		ts_v3 p = ts_mad(ts_mad(of.c, of.u, across), of.v, of.down);
		x[i] = ts_put(p.x);
		y[i] = ts_put(p.y);
		z[i] = ts_put(p.z);
		f32 ax = q0.x - middle, ay = q0.y - row, bx = q1.x - middle, by = q1.y - row, dx = q2.x - middle,
			dy = q2.y - row;
		u32 ab = ts_diff_of_products(ax, by, ay, bx) >= 0.0f ? 1u : 0u;
		u32 bd = ts_diff_of_products(bx, dy, by, dx) >= 0.0f ? 1u : 0u;
		u32 da = ts_diff_of_products(dx, ay, dy, ax) >= 0.0f ? 1u : 0u;
		in[i] = ab & bd & da;
	}
}

/* Samples beside a piece, by their columns. */
typedef struct {
	u32 n, at[PART];
	f32 column[PART], x[PART], y[PART], z[PART];
} strays;

/* ts_k_closest_on_border */
TS_WIDE(void, move_strays, (strays *restrict to, samples of, ts_v3 a, ts_v3 b, ts_v3 c), (to, of, a, b, c))
{
	for (u32 i = 0; i < padded(to->n); i++) {
		ts_v3 on_lattice = ts_mad(ts_mad(of.c, of.u, to->column[i] / of.s), of.v, of.down);
		ts_v3 p = ts_k_closest_on_border(on_lattice, a, b, c);
		to->x[i] = ts_put(p.x);
		to->y[i] = ts_put(p.y);
		to->z[i] = ts_put(p.z);
	}
}

static void snap_samples(const samples *of, const u32 *in, const ts_piece *piece, f32 *x, f32 *y, f32 *z)
{
	strays s;
	s.n = 0;
	for (u32 i = 0; i < of->n; i++) {
		s.at[s.n] = i;
		s.column[s.n] = (f32)(of->x + (i32)i);
		s.n += in[i] ^ 1u;
	}
	if (s.n == 0) return;
	for (u32 i = s.n; i < padded(s.n); i++) s.column[i] = 0.0f;
	move_strays(&s, *of, ts_load3(piece->a), ts_load3(piece->b), ts_load3(piece->c));
	for (u32 k = 0; k < s.n; k++) {
		x[s.at[k]] = s.x[k];
		y[s.at[k]] = s.y[k];
		z[s.at[k]] = s.z[k];
	}
}

static u32 make_masked(const ts_made_piece *p, i32 y, f32 *const centre[3])
{
	u32 n = 0;
	for (i32 x = p->cover.touched.x0; x <= p->cover.touched.x1; x++) {
		if (!ts_made_is_point(p, x, y)) continue;
		ts_v3 c = ts_k_point_centre(p->from, p->piece, x, y);
		centre[0][n] = ts_put(c.x);
		centre[1][n] = ts_put(c.y);
		centre[2][n] = ts_put(c.z);
		n++;
	}
	return n;
}

void ts_made_span(const ts_made_piece *p, ts_span row, i32 y, f32 *const centre[3])
{
	const ts_align *frame = &p->from->frames[p->piece];
	u32 n = (u32)(row.last - row.first + 1), in[PART];
	samples of = {.c = ts_load3(frame->c), .u = ts_load3(frame->u), .v = ts_load3(frame->v), .s = frame->s};
	of.down = (f32)y / frame->s;
	of.middle = (f32)y + 0.5f;
	memcpy(of.corner, p->corner, sizeof of.corner);
	for (u32 done = 0; done < n; done += PART) {
		f32 *to[3] = {centre[0] + done, centre[1] + done, centre[2] + done};
		of.x = row.first + (i32)done;
		of.n = n - done < PART ? n - done : PART;
		make_samples(of, to[0], to[1], to[2], in);
		if (p->from->snap != 0) snap_samples(&of, in, &p->from->pieces[p->piece], to[0], to[1], to[2]);
	}
}

u32 ts_made_row(const ts_made_piece *p, i32 y, f32 *const centre[3])
{
	if (p->masked) return make_masked(p, y, centre);
	ts_span row = ts_k_touched_row(&p->lines, p->cover.touched, y);
	ts_made_span(p, row, y, centre);
	return (u32)(row.last - row.first + 1);
}

#include "backends/selftest.h"

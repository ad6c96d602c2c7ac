/* Points side by side. Most splats touch at most three texels by three: vectorized loops find which of the nine they
 * offer a key to, and those are written one after another, the first four without branches. */
#include <string.h>
#include "backends/c/points/splat_batch.h"
#include "backends/wide.h"
#include "kernels/points/splat_pieces.h"

enum { POINTS = TS_SPLAT_POINTS, LANES = TS_SPLAT_LANES, ROOM = TS_SPLAT_ROOM, EDGES = TS_SPLAT_EDGES };

/* Texels per side that are offered at once; masks of the first column, the first row, and the first two by two. */
enum { SIDE = 3, COLUMN = 0x49, ROW = 7, FEW = 0x1b };

/* What all lanes share; [3] is right, up, ahead. */
typedef struct {
	f32 eye[3], sign[3], world_eye[3];
	f32 focal, middle, size, near, widest;
	i32 width, last; /* last: texel of the face */
	u32 apart;       /* 1: all are drawn one by one */
} lanes;

/* Where the splats are. Those that offer nothing offer an empty key to a texel of their lane. */
typedef struct {
	u32 distance[ROOM];
	i32 x0[ROOM], y0[ROOM], x1[ROOM], y1[ROOM]; /* of the box */
	u32 texel[ROOM], high[ROOM], low[ROOM];     /* (x0, y0), and the halves of its key */
	u32 more[ROOM];                             /* 1: the box has a second column; 2: a second row */
	u32 covered[ROOM];                          /* bits 3 j + i: texel (x0 + i, y0 + j) */
	u32 rest[ROOM];                             /* 1: larger than that; 2: a corner is behind the eye */
	f32 front[ROOM];                            /* of the corner farthest ahead: < 0: behind the eye */
} places;

static lanes lanes_of(const ts_splat_face *f)
{
	lanes r = {.focal = f->view.focal,
	           .middle = (f32)f->view.width * 0.5f,
	           .size = (f32)f->view.width,
	           .near = f->view.near,
	           .widest = f->inset,
	           .width = f->view.width,
	           .last = f->view.width * f->view.width - 1};
	for (u32 k = 0; k < 3; k++) {
		r.eye[k] = f->eye[f->row[k].axis];
		r.sign[k] = f->row[k].sign;
		r.world_eye[k] = f->eye[k];
	}
	return r;
}

/* One coordinate of a square's corners, from the eye: ((c -+ du) -+ dv) - eye. */
typedef struct {
	f32 at[4];
} corners;

static inline corners corners_of(f32 c, f32 du, f32 dv, f32 eye, f32 sign)
{
	f32 low = c - du, high = c + du;
	return (corners){
		{((low - dv) - eye) * sign, ((high - dv) - eye) * sign, ((high + dv) - eye) * sign, ((low + dv) - eye) * sign}};
}

static inline f32 least(const corners *c) { return ts_min(ts_min(c->at[0], c->at[1]), ts_min(c->at[2], c->at[3])); }
static inline f32 most(const corners *c) { return ts_max(ts_max(c->at[0], c->at[1]), ts_max(c->at[2], c->at[3])); }

static inline void project(const lanes *f, corners *x, corners *y, const corners *z)
{
	for (u32 k = 0; k < 4; k++) {
		x->at[k] = f->middle + (f->focal * x->at[k]) / z->at[k];
		y->at[k] = f->middle - (f->focal * y->at[k]) / z->at[k];
	}
}

/* Bit 31: texel (i, j) of the box that may be written is outside an edge. */
static inline u32 outside(i32 whole[][ROOM], u32 at, u32 i, u32 j)
{
	u32 out = 0;
	for (u32 k = EDGES; k < EDGES + 9; k += 3)
		out |= (u32)whole[k][at] * i + (u32)whole[k + 1][at] * j + (u32)whole[k + 2][at];
	return out;
}

/* Bits 3 j + i: texel (s + i, t + j) is inside the edges. */
static inline u32 inside(i32 whole[][ROOM], u32 at, u32 s, u32 t)
{
	u32 bits = 0;
	for (u32 j = 0; j < SIDE; j++) {
		for (u32 i = 0; i < SIDE; i++) bits |= ~outside(whole, at, s + i, t + j) >> 31 << (SIDE * j + i);
	}
	return bits;
}

/* 1 if a < b, for integers whose difference does not overflow. */
static inline u32 is_less(i32 a, i32 b) { return (u32)(a - b) >> 31; }

static inline u32 of_box(i32 across, i32 down)
{
	u32 columns = COLUMN | is_less(0, across) * COLUMN << 1 | is_less(1, across) * COLUMN << 2;
	u32 rows = ROW | is_less(0, down) * ROW << SIDE | is_less(1, down) * ROW << 2 * SIDE;
	return columns & rows;
}

/* Texels of the squares' boxes, like ts_k_splat_box; distances; covered texels, whose number is returned. */
TS_WIDE(u32, place_splats,
        (places *restrict to, ts_splat_block *restrict b, u32 n_points, lanes f, const f32 *const centre[3],
         const u32 axis[3]),
        (to, b, n_points, f, centre, axis))
{
	const f32 *x = centre[0], *y = centre[1], *z = centre[2];
	const f32 *right = centre[axis[0]], *up = centre[axis[1]], *ahead = centre[axis[2]];
	u32 writes = 0;
	for (u32 i = 0; i < (n_points + LANES - 1) / LANES * LANES; i++) {
		corners px = corners_of(right[i], b->side[0][i], b->side[3][i], f.eye[0], f.sign[0]);
		corners py = corners_of(up[i], b->side[1][i], b->side[4][i], f.eye[1], f.sign[1]);
		corners pz = corners_of(ahead[i], b->side[2][i], b->side[5][i], f.eye[2], f.sign[2]);
		project(&f, &px, &py, &pz);
		f32 inset = ts_k_box_inset(f.widest, f.focal, b->slack[i], least(&pz));
		i32 x0 = ts_max_i32(ts_k_floor_within(least(&px) + inset, f.size), b->whole[0][i]);
		i32 y0 = ts_max_i32(ts_k_floor_within(least(&py) + inset, f.size), b->whole[1][i]);
		i32 x1 = ts_min_i32(ts_k_floor_within(most(&px) - inset, f.size), b->whole[2][i]);
		i32 y1 = ts_min_i32(ts_k_floor_within(most(&py) - inset, f.size), b->whole[3][i]);
		ts_v3 to_point = ts_v3_make(x[i] - f.world_eye[0], y[i] - f.world_eye[1], z[i] - f.world_eye[2]);
		u32 distance = ts_f2u(ts_put(ts_length(to_point)));
		u32 counts = (u32)((i32)(i - n_points) >> 31); /* all bits, or none */
		u32 behind = ts_flush(least(&pz) - f.near) < 0.0f ? 1u : 0u;
		i32 across = x1 - x0, down = y1 - y0;
		u32 any = (is_less(across, 0) | is_less(down, 0) | behind) ^ 1u;
		u32 large = is_less(SIDE - 1, across) | is_less(SIDE - 1, down) | f.apart;
		u32 covered = inside(b->whole, i, (u32)(x0 - b->whole[0][i]), (u32)(y0 - b->whole[1][i]));
		covered &= of_box(across, down) & (0u - (any & (large ^ 1u))) & counts;
		for (u32 bit = 0; bit < SIDE * SIDE; bit++) writes += covered >> bit & 1u;
		u32 none = (covered & 1u) - 1u;
		to->texel[i] = (u32)ts_min_i32(none != 0u ? (i32)i : y0 * f.width + x0, f.last);
		to->high[i] = distance | none;
		to->low[i] = b->word[i] | none;
		to->distance[i] = distance;
		to->covered[i] = covered;
		to->rest[i] = (behind << 1 | (any & large)) & counts;
		to->front[i] = ts_flush(most(&pz) - f.near);
		to->more[i] = is_less(0, down) << 1 | is_less(0, across);
		to->x0[i] = x0;
		to->y0[i] = y0;
		to->x1[i] = x1;
		to->y1[i] = y1;
	}
	return writes;
}

static inline u64 key_of(u32 high, u32 low) { return (u64)high << 32 | low; }

/* A key that lost only by its low half marks the texel. */
static inline void mark(const ts_splat_face *f, i32 at, u64 key)
{
	u64 least = f->texels[at];
	f->tie[at] |= key != least && key >> 32 == least >> 32;
}

static inline void offer(u64 *texel, u64 key)
{
	u64 old = *texel;
	*texel = key < old ? key : old;
}

/* Writes the others of two texels by two. */
static void write_few(u64 *texels, const places *p, u64 key, u32 i, i32 width)
{
	u64 *first = &texels[p->y0[i] * width + p->x0[i]], *below = first + (p->more[i] >> 1) * (u32)width;
	u32 right = p->more[i] & 1, covered = p->covered[i];
	offer(first + right, key | ((u64)(covered >> 1 & 1) - 1));
	offer(below, key | ((u64)(covered >> SIDE & 1) - 1));
	offer(below + right, key | ((u64)(covered >> (SIDE + 1) & 1) - 1));
}

static void write_beyond(u64 *texels, const places *p, u64 key, u32 i, i32 width)
{
	u64 *first = &texels[p->y0[i] * width + p->x0[i]];
	for (u32 bits = p->covered[i] & ~(u32)FEW; bits != 0; bits &= bits - 1) {
		i32 bit = __builtin_ctz(bits);
		offer(first + bit / SIDE * width + bit % SIDE, key);
	}
}

static void write(u64 *texels, const places *p, const u32 *word, u32 n, i32 width)
{
	u32 n_few = 0, few[POINTS], n_beyond = 0, beyond[POINTS];
	for (u32 i = 0; i < n; i++) {
		offer(&texels[p->texel[i]], key_of(p->high[i], p->low[i]));
		few[n_few] = beyond[n_beyond] = i;
		n_few += p->covered[i] > 1;
		n_beyond += (p->covered[i] & ~(u32)FEW) != 0;
	}
	for (u32 k = 0; k < n_few; k++) write_few(texels, p, key_of(p->distance[few[k]], word[few[k]]), few[k], width);
	for (u32 k = 0; k < n_beyond; k++)
		write_beyond(texels, p, key_of(p->distance[beyond[k]], word[beyond[k]]), beyond[k], width);
}

static void mark_all(const ts_splat_face *f, const places *p, const u32 *word, u32 n)
{
	for (u32 i = 0; i < n; i++) {
		for (u32 bits = p->covered[i]; bits != 0; bits &= bits - 1) {
			i32 bit = __builtin_ctz(bits), x = p->x0[i] + bit % SIDE, y = p->y0[i] + bit / SIDE;
			mark(f, y * f->view.width + x, key_of(p->distance[i], word[i]));
		}
	}
}

static inline void offer_or_mark(ts_splat_face *f, i32 at, u64 key)
{
	if (f->tie == NULL) {
		offer(&f->texels[at], key);
	} else {
		mark(f, at, key);
	}
}

/* Splats that are drawn alone. */
typedef struct {
	const ts_splat_live *live;
	const ts_lines *lines;
	const f32 *const *centre;
} alone;

static ts_box box_of(const ts_splat_face *f, const ts_splat_block *b, const alone *of, u32 at, ts_v3 c)
{
	ts_box limit = {b->whole[0][at], b->whole[1][at], b->whole[2][at], b->whole[3][at]};
	u32 piece = of->live->piece[b->live[at]];
	const ts_points_args *from = &f->args->from;
	ts_square s = ts_k_square(&from->pieces[piece], &from->frames[piece], c, of->live->length[b->live[at]]);
	return ts_k_box_meet(ts_k_splat_box(&f->view, &s, f->args->inset), limit);
}

static u32 plane_distance(const ts_splat_face *f, const ts_splat_live *live, u32 at, ts_v3 c, f32 distance, i32 i,
                          i32 j)
{
	const ts_align *frame = &f->args->from.frames[live->piece[at]];
	ts_v3 n = ts_cross(ts_load3(frame->u), ts_load3(frame->v));
	return ts_f2u(ts_put(ts_k_plane_distance(&f->view, n, c, distance, live->length[at], i, j)));
}

/* Draws a splat of any size; its edges are separate from the box that may be written. */
static void draw(ts_splat_face *f, ts_splat_block *b, u32 at, ts_box box, u32 distance)
{
	u64 key = key_of(distance, b->word[at]);
	i64 writes = 0;
	for (i32 j = box.y0; j <= box.y1; j++) {
		for (i32 i = box.x0; i <= box.x1; i++) {
			i32 out = (i32)outside(b->whole, at, (u32)(i - b->whole[0][at]), (u32)(j - b->whole[1][at])) >> 31;
			offer_or_mark(f, j * f->view.width + i, key | (u64)(i64)out);
			writes += 1 + out;
		}
	}
	f->writes += writes;
}

/* Like draw, but by lines, or with a depth per texel. */
static void draw_apart(ts_splat_face *f, ts_splat_block *b, const alone *of, u32 at, ts_box box, ts_v3 c, f32 distance)
{
	for (i32 j = box.y0; j <= box.y1; j++) {
		for (i32 i = box.x0; i <= box.x1; i++) {
			if (of->lines != NULL && !ts_k_inside_lines(of->lines, i, j)) continue;
			u32 d = f->args->plane_depth == 0 ? ts_f2u(distance)
			                                  : plane_distance(f, of->live, b->live[at], c, distance, i, j);
			offer_or_mark(f, j * f->view.width + i, key_of(d, b->word[at]));
			f->writes++;
		}
	}
}

/* A square that is wholly behind the eye is not seen. */
static void draw_rest(ts_splat_face *f, ts_splat_block *b, const alone *of, u32 at, const places *p, bool apart)
{
	if (p->front[at] < 0) return;
	ts_v3 c = ts_v3_make(of->centre[0][at], of->centre[1][at], of->centre[2][at]);
	ts_box box = {p->x0[at], p->y0[at], p->x1[at], p->y1[at]};
	if (p->rest[at] == 2) box = box_of(f, b, of, at, c);
	if (apart) {
		draw_apart(f, b, of, at, box, c, ts_u2f(p->distance[at]));
	} else {
		draw(f, b, at, box, p->distance[at]);
	}
}

static void put(ts_splat_block *b, ts_splat_face *f, const alone *of, u32 n, bool apart)
{
	places p;
	lanes all = lanes_of(f);
	all.apart = apart ? 1 : 0;
	const u32 axis[3] = {f->row[0].axis, f->row[1].axis, f->row[2].axis};
	f->writes += place_splats(&p, b, n, all, of->centre, axis);
	if (!apart && f->tie == NULL) write(f->texels, &p, b->word, n, f->view.width);
	if (!apart && f->tie != NULL) mark_all(f, &p, b->word, n);
	u32 rest = 0;
	for (u32 i = 0; i < n; i++) rest |= p.rest[i];
	for (u32 i = 0; rest != 0 && i < n; i++) {
		if (p.rest[i] != 0) draw_rest(f, b, of, i, &p, apart);
	}
}

void ts_splat_block_write(ts_splat_block *b, ts_splat_face *f, const ts_splat_live *live)
{
	const f32 *const centre[3] = {b->centre[0], b->centre[1], b->centre[2]};
	alone of = {live, NULL, centre};
	if (b->n > 0) put(b, f, &of, b->n, false);
	b->n = 0;
}

typedef f32 floats __attribute__((vector_size(4 * LANES)));
typedef i32 integers __attribute__((vector_size(4 * LANES)));

/* What all points of a row have in common. */
typedef struct {
	f32 side[TS_SPLAT_SIDES], slack;
	i32 whole[TS_SPLAT_WHOLES], live;
} common;

static common common_of(const ts_splat_face *f, const ts_splat_live *live, const ts_splat_batch *batch, u32 k)
{
	common c = {.live = (i32)batch->live[k], .slack = live->slack[batch->live[k]]};
	for (u32 s = 0; s < TS_SPLAT_SIDES; s++) c.side[s] = live->side[s / 3 * 3 + f->row[s % 3].axis][batch->live[k]];
	for (u32 s = 0; s < TS_SPLAT_WHOLES; s++) c.whole[s] = batch->whole[s][k];
	return c;
}

/* Adds from point `at` on. */
TS_WIDE(void, add_common, (ts_splat_block * b, const common *c, u32 at, u32 n), (b, c, at, n))
{
	for (u32 begin = at; begin < at + n; begin += LANES) {
		for (u32 s = 0; s < TS_SPLAT_SIDES; s++) {
			floats side = (floats){0} + c->side[s];
			memcpy(b->side[s] + begin, &side, sizeof side);
		}
		floats slack = (floats){0} + c->slack;
		memcpy(b->slack + begin, &slack, sizeof slack);
		for (u32 s = 0; s < TS_SPLAT_WHOLES; s++) {
			integers whole = (integers){0} + c->whole[s];
			memcpy(b->whole[s] + begin, &whole, sizeof whole);
		}
		integers live = (integers){0} + c->live;
		memcpy(b->live + begin, &live, sizeof live);
	}
}

/* Adds the words that texels hold: points' indices or colours. */
static void add_words(ts_splat_block *b, const ts_splat_face *f, u32 at, ts_splat_row row)
{
	for (u32 i = 0; i < row.n; i++)
		b->word[at + i] = ts_k_splat_word(f->args, row.which != NULL ? row.which[i] : row.index + i);
}

/* Lanes beyond the last point are overwritten by the next row, or do not count. */
static void add(ts_splat_block *b, const ts_splat_face *f, const common *c, ts_splat_row row)
{
	add_common(b, c, b->n, row.n);
	add_words(b, f, b->n, row);
	for (u32 done = 0; done < row.n; done += LANES) {
		for (u32 axis = 0; axis < 3; axis++) {
			memcpy(b->centre[axis] + b->n + done, row.centre[axis] + done, LANES * sizeof(f32));
		}
	}
	b->n += row.n;
}

void ts_splat_block_add(ts_splat_block *b, ts_splat_face *f, const ts_splat_live *live, const ts_splat_batch *batch,
                        u32 k, ts_splat_row row)
{
	common c = common_of(f, live, batch, k);
	for (u32 done = 0; done < row.n;) {
		u32 room = POINTS - b->n, n = row.n - done < room ? row.n - done : room;
		const u32 *which = row.which != NULL ? row.which + done : NULL;
		ts_splat_row part = {
			{row.centre[0] + done, row.centre[1] + done, row.centre[2] + done}, row.index + done, n, which};
		add(b, f, &c, part);
		done += n;
		if (b->n == POINTS) ts_splat_block_write(b, f, live);
	}
}

void ts_splat_block_own(ts_splat_block *b, const ts_splat_face *f, const ts_splat_live *live,
                        const ts_splat_batch *batch, u32 k)
{
	common c = common_of(f, live, batch, k);
	add_common(b, &c, 0, POINTS);
}

void ts_splat_block_row(ts_splat_block *b, ts_splat_face *f, const ts_splat_live *live, ts_splat_row row,
                        const ts_lines *lines)
{
	alone of = {live, lines, row.centre};
	add_words(b, f, 0, row);
	put(b, f, &of, row.n, lines != NULL || f->args->plane_depth != 0);
}

#include "backends/selftest.h"

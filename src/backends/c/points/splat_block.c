/* Points side by side. Most splats touch at most two texels by two: loops for vectors find which of the four they offer
 * a key to, and those are written one after another, without branches. */
#include <string.h>
#include "../../wide.h"
#include "splat_batch.h"

enum { POINTS = TS_SPLAT_POINTS, LANES = TS_SPLAT_LANES, ROOM = TS_SPLAT_ROOM, EDGES = TS_SPLAT_EDGES };

/* What all lanes know; [3] is right, up, ahead. */
typedef struct {
	f32 eye[3], sign[3], world_eye[3];
	f32 focal, middle, size, near;
	i32 width;
} lanes;

/* Where the splats are. */
typedef struct {
	u32 distance[ROOM];
	i32 x0[ROOM], y0[ROOM], x1[ROOM], y1[ROOM]; /* of the box */
	u32 texel[ROOM];                            /* (x0, y0) */
	u32 covered[ROOM];                          /* bits: that texel, the one to its right, those below */
	u32 rest[ROOM];                             /* 1: larger than that; 2: a corner is behind the eye */
} places;

typedef struct {
	u32 n;
	u32 texel[4 * POINTS];
	u64 key[4 * POINTS];
} offers;

static lanes lanes_of(const ts_splat_face *f)
{
	lanes r = {.focal = f->view.focal,
	           .middle = (f32)f->view.width * 0.5f,
	           .size = (f32)f->view.width,
	           .near = f->view.near,
	           .width = f->view.width};
	for (u32 k = 0; k < 3; k++) {
		r.eye[k] = f->eye[f->row[k].axis];
		r.sign[k] = f->row[k].sign;
		r.world_eye[k] = f->eye[k];
	}
	return r;
}

/* One coordinate of the corners of a square, from the eye: ((c -+ du) -+ dv) - eye. */
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

/* Bit 31: texel (i, j) from the box that may be written is on the outer side of an edge. */
static inline u32 outside(i32 whole[][ROOM], u32 at, u32 i, u32 j)
{
	u32 out = 0;
	for (u32 k = EDGES; k < EDGES + 9; k += 3)
		out |= (u32)whole[k][at] * i + (u32)whole[k + 1][at] * j + (u32)whole[k + 2][at];
	return out;
}

/* Texels of the squares' boxes, like ts_k_splat_box; distances; what is covered. */
TS_WIDE static void place_splats(places *restrict to, ts_splat_block *restrict b, lanes f, const f32 *right,
                                 const f32 *up, const f32 *ahead)
{
	u32 n = (b->n + LANES - 1) / LANES * LANES;
	for (u32 i = 0; i < n; i++) {
		corners px = corners_of(right[i], b->side[0][i], b->side[3][i], f.eye[0], f.sign[0]);
		corners py = corners_of(up[i], b->side[1][i], b->side[4][i], f.eye[1], f.sign[1]);
		corners pz = corners_of(ahead[i], b->side[2][i], b->side[5][i], f.eye[2], f.sign[2]);
		for (u32 k = 0; k < 4; k++) {
			px.at[k] = f.middle + (f.focal * px.at[k]) / pz.at[k];
			py.at[k] = f.middle - (f.focal * py.at[k]) / pz.at[k];
		}
		i32 x0 = ts_max_i32(ts_k_floor_within(least(&px), f.size), b->whole[0][i]);
		i32 y0 = ts_max_i32(ts_k_floor_within(least(&py), f.size), b->whole[1][i]);
		i32 x1 = ts_min_i32(ts_k_floor_within(most(&px), f.size), b->whole[2][i]);
		i32 y1 = ts_min_i32(ts_k_floor_within(most(&py), f.size), b->whole[3][i]);
		u32 behind = ts_flush(least(&pz) - f.near) < 0.0f ? 1u : 0u;
		u32 any = (x1 >= x0 ? 1u : 0u) & (y1 >= y0 ? 1u : 0u) & (behind ^ 1u);
		u32 wide = x1 > x0 ? 1u : 0u, tall = y1 > y0 ? 1u : 0u;
		u32 large = (x1 > x0 + 1 ? 1u : 0u) | (y1 > y0 + 1 ? 1u : 0u);
		u32 s = (u32)(x0 - b->whole[0][i]), t = (u32)(y0 - b->whole[1][i]);
		u32 out = outside(b->whole, i, s, t) >> 31;
		out |= ((outside(b->whole, i, s + 1, t) >> 31) | (wide ^ 1u)) << 1;
		out |= ((outside(b->whole, i, s, t + 1) >> 31) | (tall ^ 1u)) << 2;
		out |= ((outside(b->whole, i, s + 1, t + 1) >> 31) | ((wide & tall) ^ 1u)) << 3;
		to->covered[i] = (out ^ 15u) & (0u - (any & (large ^ 1u)));
		to->rest[i] = behind << 1 | (any & large);
		to->texel[i] = (u32)(y0 * f.width + x0);
		to->x0[i] = x0;
		to->y0[i] = y0;
		to->x1[i] = x1;
		to->y1[i] = y1;
		ts_v3 d = ts_v3_make(b->centre[0][i] - f.world_eye[0], b->centre[1][i] - f.world_eye[1],
		                     b->centre[2][i] - f.world_eye[2]);
		to->distance[i] = ts_f2u(ts_put(ts_length(d)));
	}
}

static void offer(offers *to, u32 texel, u64 key, u32 counts)
{
	to->texel[to->n] = texel;
	to->key[to->n] = key;
	to->n += counts;
}

static u64 key_of(const ts_splat_face *f, u32 distance, u32 index)
{
	return (u64)distance << 32 | ts_k_splat_word(f->args, index);
}

static void write(ts_splat_face *f, const places *p, const ts_splat_block *b)
{
	offers list;
	u32 width = (u32)f->view.width;
	list.n = 0;
	for (u32 i = 0; i < b->n; i++) {
		u64 key = key_of(f, p->distance[i], b->index[i]);
		u32 covered = p->covered[i], texel = p->texel[i];
		offer(&list, texel, key, covered & 1u);
		offer(&list, texel + 1, key, covered >> 1 & 1u);
		offer(&list, texel + width, key, covered >> 2 & 1u);
		offer(&list, texel + width + 1, key, covered >> 3);
	}
	for (u32 k = 0; k < list.n; k++) {
		u64 *texel = &f->texels[list.texel[k]], old = *texel;
		*texel = list.key[k] < old ? list.key[k] : old;
	}
	f->writes += list.n;
}

/* A splat by itself. */
static void draw(ts_splat_face *f, ts_splat_block *b, u32 at, ts_box box, u32 distance)
{
	u64 key = key_of(f, distance, b->index[at]);
	for (i32 j = box.y0; j <= box.y1; j++) {
		for (i32 i = box.x0; i <= box.x1; i++) {
			if (outside(b->whole, at, (u32)(i - b->whole[0][at]), (u32)(j - b->whole[1][at])) >> 31 != 0) continue;
			u64 *texel = &f->texels[(u64)j * (u64)f->view.width + (u64)i];
			*texel = key < *texel ? key : *texel;
			f->writes++;
		}
	}
}

static void draw_rest(ts_splat_face *f, const places *p, ts_splat_block *b)
{
	for (u32 i = 0; i < b->n; i++) {
		if (p->rest[i] == 0) continue;
		ts_box box = {p->x0[i], p->y0[i], p->x1[i], p->y1[i]};
		if (p->rest[i] == 2) {
			const ts_align *frame = &f->args->from.frames[b->piece[i]];
			ts_v3 c = ts_v3_make(b->centre[0][i], b->centre[1][i], b->centre[2][i]);
			ts_box limit = {b->whole[0][i], b->whole[1][i], b->whole[2][i], b->whole[3][i]};
			box = ts_k_splat_box(&f->view, c, ts_load3(frame->u), ts_load3(frame->v), b->length[i]);
			box = ts_k_box_meet(box, limit);
		}
		draw(f, b, i, box, p->distance[i]);
	}
}

void ts_splat_block_write(ts_splat_block *b, ts_splat_face *f)
{
	places p;
	u32 rest = 0;
	if (b->n == 0) return;
	place_splats(&p, b, lanes_of(f), b->centre[f->row[0].axis], b->centre[f->row[1].axis], b->centre[f->row[2].axis]);
	write(f, &p, b);
	for (u32 i = 0; i < b->n; i++) rest |= p.rest[i];
	if (rest != 0) draw_rest(f, &p, b);
	b->n = 0;
}

/* LANES of it. */
static inline void put_f32(f32 *to, f32 value)
{
	for (u32 i = 0; i < LANES; i++) to[i] = value;
}

static inline void put_u32(u32 *to, u32 value)
{
	for (u32 i = 0; i < LANES; i++) to[i] = value;
}

static inline void put_i32(i32 *to, i32 value)
{
	for (u32 i = 0; i < LANES; i++) to[i] = value;
}

/* Lanes beyond the last point are overwritten by what comes next, or stay unread. */
static void add(ts_splat_block *b, const ts_splat_batch *batch, u32 k, const f32 *const centre[3], u32 index, u32 n)
{
	for (u32 done = 0; done < n; done += LANES) {
		u32 at = b->n + done;
		for (u32 axis = 0; axis < 3; axis++) memcpy(b->centre[axis] + at, centre[axis] + done, LANES * sizeof(f32));
		for (u32 s = 0; s < TS_SPLAT_SIDES; s++) put_f32(b->side[s] + at, batch->side[s][k]);
		for (u32 s = 0; s < TS_SPLAT_WHOLES; s++) put_i32(b->whole[s] + at, batch->whole[s][k]);
		put_f32(b->length + at, batch->length[k]);
		put_u32(b->piece + at, batch->piece[k]);
		for (u32 i = 0; i < LANES; i++) b->index[at + i] = index + done + i;
	}
	b->n += n;
}

void ts_splat_block_add(ts_splat_block *b, ts_splat_face *f, const ts_splat_batch *batch, u32 k,
                        const f32 *const centre[3], u32 index, u32 n)
{
	for (u32 done = 0; done < n;) {
		u32 room = POINTS - b->n, part = n - done < room ? n - done : room;
		const f32 *from[3] = {centre[0] + done, centre[1] + done, centre[2] + done};
		add(b, batch, k, from, index + done, part);
		done += part;
		if (b->n == POINTS) ts_splat_block_write(b, f);
	}
}

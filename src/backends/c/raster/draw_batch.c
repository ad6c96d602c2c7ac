/* Small triangles side by side, like ts_k_draw where no plane clips: corners are snapped, edges set up, covered pixels
 * listed, and the list's depths found. */
#include "backends/c/raster/draw_batch.h"
#include "backends/wide.h"

enum { TRIANGLES = TS_DRAW_TRIANGLES, LANES = TS_DRAW_LANES, LONGEST = (1 << 15) - 1, MOST_PIXELS = 128, LIST = 512 };

typedef enum { UNSEEN, TOGETHER, ALONE, CLIPPED } way;

/* Triangles turned to positive area. Edges are evaluated in 32 bits: within the box of a triangle at most 128 pixels
 * wide and high they are at most 2^30. */
typedef struct {
	u32 way[TRIANGLES];
	i32 x0[TRIANGLES], y0[TRIANGLES], x1[TRIANGLES], y1[TRIANGLES];
	i32 edge[3][TRIANGLES]; /* at (x0, y0) */
	i32 right[3][TRIANGLES], down[3][TRIANGLES], least[3][TRIANGLES];
	i32 area[TRIANGLES], turned[TRIANGLES];
	u32 z[3][TRIANGLES]; /* bits */
} placed;

/* Pixels that triangles cover. */
typedef struct {
	u32 n, texel[LIST], of[LIST];
	i32 edge[3][LIST], area[LIST], turned[LIST];
	u32 z[3][LIST];
	u32 depth[LIST];
} fragments;

void ts_draw_block_read(ts_draw_block *b, const ts_arrays *scene, u32 first, u32 n)
{
	b->first = first;
	b->n = n;
	for (u32 i = 0; i < n; i++) {
		const ts_triangle *t = &scene->triangles[first + i];
		u32 flags = scene->materials[t->material].flags;
		b->object[i] = scene->vertices[t->vertex[0]].object;
		b->two_sided[i] = (flags & TS_DOUBLE_SIDED) != 0;
		b->masked[i] = (flags & TS_MASKED) != 0;
		for (u32 k = 0; k < 3; k++) {
			const f32 *p = scene->vertices[t->vertex[k]].position;
			for (u32 axis = 0; axis < 3; axis++) b->corners.at[3 * k + axis][i] = p[axis];
		}
	}
}

/* What all lanes share. */
typedef struct {
	f32 focal, middle_x, middle_y, near;
	i32 shift_x, shift_y;
	u32 orthographic;
	ts_box owned;
} lanes;

/* A snapped corner; `ok` is 0 near the eye or a plane of the snapping range. */
typedef struct {
	i32 x, y;
	u32 ok;
} snapped;

static inline snapped snap(const lanes *f, f32 x, f32 y, f32 z)
{
	f32 by = f->orthographic != 0u ? 1.0f : z;
	f32 px = f->middle_x + (f->focal * x) / by, py = f->middle_y - (f->focal * y) / by;
	u32 ok = (z >= f->near ? 1u : 0u) & (ts_abs(px) < 8192.0f ? 1u : 0u) & (ts_abs(py) < 8192.0f ? 1u : 0u);
	i32 sx = (i32)ts_rint(ok != 0u ? px * 256.0f : 0.0f), sy = (i32)ts_rint(ok != 0u ? py * 256.0f : 0.0f);
	return (snapped){sx + f->shift_x, sy + f->shift_y, ok};
}

static inline i32 least(i32 a, i32 b, i32 c) { return ts_min_i32(ts_min_i32(a, b), c); }
static inline i32 most(i32 a, i32 b, i32 c) { return ts_max_i32(ts_max_i32(a, b), c); }

/* a where `other` is 0, b where it is -1. */
static inline i32 choose(i32 a, i32 b, i32 other) { return a ^ ((a ^ b) & other); }

static inline i32 edge_at(i32 ax, i32 ay, i32 bx, i32 by, i32 x, i32 y)
{
	return (i32)((u32)(bx - ax) * (u32)(y - ay) - (u32)(by - ay) * (u32)(x - ax));
}

/* Edge k from a to b; 0 is inside on a top or left edge. */
static inline void put_edge(placed *restrict to, u32 i, u32 k, snapped a, snapped b)
{
	i32 dx = b.x - a.x, dy = b.y - a.y;
	to->edge[k][i] = edge_at(a.x, a.y, b.x, b.y, to->x0[i] * TS_SUB_PIXELS + TS_SUB_CENTRE,
	                         to->y0[i] * TS_SUB_PIXELS + TS_SUB_CENTRE);
	to->right[k][i] = -dy * 256;
	to->down[k][i] = dx * 256;
	to->least[k][i] = 1 + ((i32)(((u32)dy << 16) - (u32)dx) >> 31);
}

TS_WIDE(void, place_triangles, (placed *restrict to, const ts_draw_batch *restrict b, lanes f), (to, b, f))
{
	u32 n = (b->n + LANES - 1) / LANES * LANES;
	for (u32 i = 0; i < n; i++) {
		snapped p = snap(&f, b->corners.at[0][i], b->corners.at[1][i], b->corners.at[2][i]);
		snapped q = snap(&f, b->corners.at[3][i], b->corners.at[4][i], b->corners.at[5][i]);
		snapped r = snap(&f, b->corners.at[6][i], b->corners.at[7][i], b->corners.at[8][i]);
		i32 x0 = least(p.x, q.x, r.x), x1 = most(p.x, q.x, r.x), y0 = least(p.y, q.y, r.y), y1 = most(p.y, q.y, r.y);
		u32 large = (u32)(LONGEST - (x1 - x0)) | (u32)(LONGEST - (y1 - y0));
		x0 = ts_max_i32((x0 + TS_SUB_FIRST) >> 8, f.owned.x0);
		y0 = ts_max_i32((y0 + TS_SUB_FIRST) >> 8, f.owned.y0);
		x1 = ts_min_i32((x1 - TS_SUB_CENTRE) >> 8, f.owned.x1);
		y1 = ts_min_i32((y1 - TS_SUB_CENTRE) >> 8, f.owned.y1);
		to->x0[i] = x0;
		to->y0[i] = y0;
		to->x1[i] = x1;
		to->y1[i] = y1;
		i32 area = edge_at(p.x, p.y, q.x, q.y, r.x, r.y), turned = area >> 31;
		snapped s = {choose(q.x, r.x, turned), choose(q.y, r.y, turned), 1u};
		snapped t = {choose(r.x, q.x, turned), choose(r.y, q.y, turned), 1u};
		put_edge(to, i, 0, s, t);
		put_edge(to, i, 1, t, p);
		put_edge(to, i, 2, p, s);
		i32 zq = (i32)ts_f2u(b->corners.at[5][i]), zr = (i32)ts_f2u(b->corners.at[8][i]);
		to->area[i] = (i32)(((u32)area ^ (u32)turned) - (u32)turned);
		to->turned[i] = turned;
		to->z[0][i] = ts_f2u(b->corners.at[2][i]);
		to->z[1][i] = (u32)choose(zq, zr, turned);
		to->z[2][i] = (u32)choose(zr, zq, turned);
		large |= (u32)(MOST_PIXELS - (x1 - x0 + 1) * (y1 - y0 + 1));
		u32 ok = p.ok & q.ok & r.ok, seen = (u32) ~((x1 - x0) | (y1 - y0)) >> 31;
		u32 solid = ((u32)area | (0u - (u32)area)) >> 31;
		u32 together = solid & (large >> 31 ^ 1u), whole = seen & (large >> 31 | solid);
		to->way[i] = ok != 0u ? whole * (ALONE - together) : CLIPPED;
	}
}

/* Depths like ts_k_fragment's. */
TS_WIDE(void, find_depths, (fragments *restrict l), (l))
{
	u32 n = (l->n + LANES - 1) / LANES * LANES;
	for (u32 i = 0; i < n; i++) {
		f32 area = (f32)l->area[i];
		f32 a = ((f32)l->edge[0][i] / area) / ts_u2f(l->z[0][i]);
		f32 b = ((f32)l->edge[1][i] / area) / ts_u2f(l->z[1][i]);
		f32 c = ((f32)l->edge[2][i] / area) / ts_u2f(l->z[2][i]);
		f32 sum = (0.0f + a) + b;
		l->depth[i] = ts_f2u(ts_put(1.0f / (sum + c)));
	}
}

/* Like ts_k_fragment_parallel's, which adds in the order of the source's corners. */
TS_WIDE(void, find_depths_parallel, (fragments *restrict l), (l))
{
	u32 n = (l->n + LANES - 1) / LANES * LANES;
	for (u32 i = 0; i < n; i++) {
		f32 area = (f32)l->area[i];
		f32 a = ((f32)l->edge[0][i] / area) * ts_u2f(l->z[0][i]);
		i32 b = (i32)ts_f2u(((f32)l->edge[1][i] / area) * ts_u2f(l->z[1][i]));
		i32 c = (i32)ts_f2u(((f32)l->edge[2][i] / area) * ts_u2f(l->z[2][i]));
		f32 sum = a + ts_u2f((u32)choose(b, c, l->turned[i]));
		l->depth[i] = ts_f2u(ts_put(sum + ts_u2f((u32)choose(c, b, l->turned[i]))));
	}
}

/* ts_k_view_fragment of a triangle that is not clipped. */
static ts_fragment fragment_of(const fragments *l, u32 i, bool orthographic)
{
	f32 share[3], over_z[3], z = ts_u2f(l->depth[i]);
	for (u32 k = 0; k < 3; k++) {
		share[k] = (f32)l->edge[k][i] / (f32)l->area[i];
		over_z[k] = share[k] / ts_u2f(l->z[k][i]);
	}
	u32 b = l->turned[i] != 0 ? 2 : 1;
	const f32 *w = orthographic ? share : over_z;
	ts_v3 by = ts_v3_make(w[0], w[b], w[3 - b]);
	return (ts_fragment){.z = z, .w = orthographic ? by : ts_scale(by, z)};
}

/* Looks up the alpha mask only where the fragment is nearer than the texel. */
static bool is_left(const fragments *l, u32 i, const ts_draw_batch *b, u32 triangle)
{
	if (!ts_draw_is_nearer(&b->target, l->texel[i], l->depth[i], triangle)) return false;
	ts_fragment f = fragment_of(l, i, b->view.orthographic != 0);
	ts_corners t = ts_k_corners(b->scene, triangle);
	return !ts_k_is_below_cutoff(b->scene, triangle, f.w, t.n, ts_k_fragment_footprint(&b->view, &t, &f));
}

static void write(fragments *l, const placed *p, const ts_draw_batch *b)
{
	for (u32 i = 0; i < l->n; i++) {
		u32 k = l->of[i];
		l->area[i] = p->area[k];
		l->turned[i] = p->turned[k];
		for (u32 c = 0; c < 3; c++) l->z[c][i] = p->z[c][k];
	}
	if (b->view.orthographic != 0) {
		find_depths_parallel(l);
	} else {
		find_depths(l);
	}
	for (u32 i = 0; i < l->n; i++) {
		u32 k = l->of[i], triangle = b->triangle[k];
		if (b->masked[k] != 0 && !is_left(l, i, b, triangle)) continue;
		ts_draw_texel(&b->target, l->texel[i], l->depth[i], triangle);
	}
	l->n = 0;
}

/* Lists the pixels of triangle k; there must be room for its box. */
static void cover(fragments *restrict l, const placed *restrict p, u32 k, u32 width)
{
	u32 n = l->n;
	i32 e0 = p->edge[0][k], e1 = p->edge[1][k], e2 = p->edge[2][k];
	const i32 l0 = p->least[0][k], l1 = p->least[1][k], l2 = p->least[2][k];
	for (i32 j = p->y0[k]; j <= p->y1[k]; j++) {
		i32 a = e0, b = e1, c = e2;
		for (i32 i = p->x0[k]; i <= p->x1[k]; i++) {
			l->texel[n] = (u32)j * width + (u32)i;
			l->of[n] = k;
			l->edge[0][n] = a;
			l->edge[1][n] = b;
			l->edge[2][n] = c;
			n += ~(u32)((a - l0) | (b - l1) | (c - l2)) >> 31;
			a += p->right[0][k];
			b += p->right[1][k];
			c += p->right[2][k];
		}
		e0 += p->down[0][k];
		e1 += p->down[1][k];
		e2 += p->down[2][k];
	}
	l->n = n;
}

void ts_draw_flush(ts_draw_batch *b)
{
	placed p;
	fragments list;
	lanes f = {.focal = b->view.focal,
	           .middle_x = (f32)b->view.width * 0.5f,
	           .middle_y = (f32)b->view.height * 0.5f,
	           .near = b->view.near,
	           .shift_x = b->view.shift_x,
	           .shift_y = b->view.shift_y,
	           .orthographic = b->view.orthographic,
	           .owned = b->owned};
	list.n = 0;
	place_triangles(&p, b, f);
	for (u32 k = 0; k < b->n; k++) {
		if (p.way[k] >= ALONE) ts_draw_alone(b, b->triangle[k], b->masked[k] != 0, p.way[k] == CLIPPED);
		if (p.way[k] != TOGETHER) continue;
		if (list.n > LIST - MOST_PIXELS) write(&list, &p, b);
		cover(&list, &p, k, (u32)b->view.width);
	}
	write(&list, &p, b);
	b->n = 0;
}

void ts_draw_add(ts_draw_batch *b, const ts_draw_block *block, u32 k, const ts_draw_corners *corners,
                 const ts_row row[3])
{
	u32 at = b->n++;
	b->triangle[at] = block->first + k;
	b->masked[at] = block->masked[k];
	for (u32 r = 0; r < 3; r++) {
		for (u32 c = 0; c < 3; c++) {
			b->corners.at[3 * c + r][at] = corners->at[3 * c + row[r].axis][k] * row[r].sign;
		}
	}
	if (b->n == TRIANGLES) ts_draw_flush(b);
}

#include "backends/selftest.h"

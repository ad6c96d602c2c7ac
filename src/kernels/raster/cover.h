/* Conservative rasterization: the pixels that a convex polygon touches, by integer edge functions (rule 19), after
 * Akenine-Moller and Aila, Conservative and Tiled Rasterization Using a Modified Triangle Set-Up, 2005. */
#ifndef TS_KERNELS_RASTER_COVER_H
#define TS_KERNELS_RASTER_COVER_H
#include "kernels/raster/snap.h"

/* Half size, in sub-pixels, of squares that miss nothing: half a pixel plus 1/256, which exceeds the 1/512 by which
 * snapping moves a corner. */
#define TS_SAFE_HALF 129

/* Whether the square of half size h around (x, y) meets the half plane of edge a, b (rule 19). turned: the polygon's
 * area is negative. */
TS_FN bool ts_k_square_meets(ts_snapped a, ts_snapped b, bool turned, i32 x, i32 y, i64 half_size)
{
	i64 e = ts_k_edge(a, b, x, y);
	i64 dx = b.x - a.x;
	i64 dy = b.y - a.y;
	i64 reach = half_size * ((dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy));
	return (turned ? -e : e) + reach >= 0;
}

/* A convex polygon of snapped corners for the conservative test: its edges and its box (CONTRACT rule 19). */
typedef struct {
	ts_snapped v[TS_MAX_CORNERS];
	u32 n;
	bool turned;
	ts_box touched;
	i32 half_size;
} ts_cover;

/* Sets what follows from the corners. An area of 0 counts as positive, and drops nothing (CONTRACT rules 17 and 19). */
TS_FN void ts_k_cover_finish(ts_cover *c, i32 half_size)
{
	i64 area = 0;
	for (u32 i = 2u; i < c->n; i++) area += ts_k_edge(c->v[0], c->v[i - 1u], c->v[i].x, c->v[i].y);
	c->turned = area < 0;
	c->half_size = half_size;
	c->touched = ts_k_touched_box(c->v, c->n, half_size);
}

/* Whether a pixel of c->touched touches the polygon (rule 19). */
TS_FN bool ts_k_touches(const ts_cover *c, i32 i, i32 j)
{
	for (u32 k = 0u; k < c->n; k++) {
		ts_snapped b = c->v[k + 1u < c->n ? k + 1u : 0u];
		if (!ts_k_square_meets(c->v[k], b, c->turned, i * TS_SUB_PIXELS + TS_SUB_CENTRE,
		                       j * TS_SUB_PIXELS + TS_SUB_CENTRE, c->half_size))
			return false;
	}
	return true;
}

/* Inside where x i + y j + c >= 0. */
typedef struct {
	i64 x, y, c;
} ts_line;
typedef struct {
	ts_line edge[TS_MAX_CORNERS];
	u32 n;
} ts_lines;

/* ts_k_touches as lines: e grows by 256 dx and 256 dy from texel to texel (rule 19). */
TS_FN void ts_k_lines(ts_lines *r, const ts_cover *cover)
{
	i64 sign = cover->turned ? -1 : 1;
	r->n = cover->n;
	for (u32 k = 0u; k < cover->n; k++) {
		ts_snapped a = cover->v[k];
		ts_snapped b = cover->v[k + 1u < cover->n ? k + 1u : 0u];
		i64 dx = b.x - a.x;
		i64 dy = b.y - a.y;
		i64 reach = cover->half_size * ((dx < 0 ? -dx : dx) + (dy < 0 ? -dy : dy));
		r->edge[k].x = -sign * dy * TS_SUB_PIXELS;
		r->edge[k].y = sign * dx * TS_SUB_PIXELS;
		r->edge[k].c = sign * (dx * (TS_SUB_CENTRE - a.y) - dy * (TS_SUB_CENTRE - a.x)) + reach;
	}
}

TS_FN bool ts_k_inside_lines(const ts_lines *l, i32 i, i32 j)
{
	for (u32 k = 0u; k < l->n; k++) {
		if (l->edge[k].x * i + l->edge[k].y * j + l->edge[k].c < 0) return false;
	}
	return true;
}

/* The samples of a row that touch: none, or all from first to last, since the polygon is convex. */
typedef struct {
	i32 first, last;
} ts_span;

/* The floor of a / b, b > 0. */
TS_FN i64 ts_k_floor_quotient(i64 a, i64 b)
{
	i64 q = a / b;
	return q * b > a ? q - 1 : q;
}

/* The part of row j of `box` that the triangle may touch: each edge, as a line, cuts the row. */
TS_FN ts_span ts_k_touched_row(const ts_lines *l, ts_box box, i32 j)
{
	/* Begin with the whole row of the box. */
	i64 first = box.x0;
	i64 last = box.x1;
	for (u32 k = 0u; k < l->n; k++) {
		/* Solve x i + c >= 0 for the pixels i; an edge along the row admits all of them or none. */
		i64 x = l->edge[k].x;
		i64 c = l->edge[k].y * j + l->edge[k].c;
		if (x == 0 && c < 0) last = first - 1;
		i64 at = x > 0 ? -ts_k_floor_quotient(c, x) : x < 0 ? ts_k_floor_quotient(c, -x) : 0;
		/* Cut the row from the left or from the right. */
		if (x > 0 && at > first) first = at;
		if (x < 0 && at < last) last = at;
	}
	ts_span r;
	/* Write an empty row as last = first - 1, so that no loop runs. */
	r.first = first <= box.x1 ? (i32)first : box.x1 + 1;
	r.last = first <= last ? (i32)last : r.first - 1;
	return r;
}

#endif

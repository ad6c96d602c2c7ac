/* Standard rasterization: covered pixels by integer edge functions and the top-left rule, and what a triangle shows
 * there (CONTRACT rules 17 to 23). */
#ifndef TS_KERNELS_RASTER_RASTER_H
#define TS_KERNELS_RASTER_RASTER_H
#include "kernels/raster/snap.h"

/* y grows downward and the area is positive, so corners run clockwise on the screen: a left edge runs up, a top edge to
 * the right. Both own the pixels whose centres they pass through (CONTRACT rule 18). */
TS_FN bool ts_k_is_top_left(ts_snapped a, ts_snapped b) { return b.y < a.y || (b.y == a.y && b.x > a.x); }

/* A snapped triangle turned to positive area; corner k is corner from[k] of the source. */
typedef struct {
	ts_snapped v[3];
	u32 from[3];
	i64 area;
} ts_setup;

/* Turns a triangle of negative area by swapping its last two corners (CONTRACT rule 17). */
TS_FN ts_setup ts_k_setup(ts_snapped a, ts_snapped b, ts_snapped c)
{
	ts_setup r;
	i64 area = ts_k_edge(a, b, c.x, c.y);
	bool turn = area < 0;
	r.v[0] = a;
	r.v[1] = turn ? c : b;
	r.v[2] = turn ? b : c;
	r.from[0] = 0u;
	r.from[1] = turn ? 2u : 1u;
	r.from[2] = turn ? 1u : 2u;
	r.area = turn ? -area : area;
	return r;
}

/* Edge k lies opposite corner k, from corner k + 1 to corner k + 2, modulo 3. */
typedef struct {
	i64 e[3];
} ts_edges;

TS_FN ts_edges ts_k_edges(const ts_setup *t, i32 x, i32 y)
{
	ts_edges r;
	r.e[0] = ts_k_edge(t->v[1], t->v[2], x, y);
	r.e[1] = ts_k_edge(t->v[2], t->v[0], x, y);
	r.e[2] = ts_k_edge(t->v[0], t->v[1], x, y);
	return r;
}

/* Whether the place of the edges is inside, or on a top or left edge (rule 18). */
TS_FN bool ts_k_covers(const ts_setup *t, const ts_edges *e)
{
	for (u32 k = 0u; k < 3u; k++) {
		ts_snapped a = t->v[k == 2u ? 0u : k + 1u];
		ts_snapped b = t->v[k == 0u ? 2u : k - 1u];
		if (e->e[k] < 0 || (e->e[k] == 0 && !ts_k_is_top_left(a, b))) return false;
	}
	return true;
}

/* Coverage from pixel to pixel: edges are integers, so steps are exact. */
typedef struct {
	ts_edges at;
	i64 right[3], down[3]; /* steps */
	i64 least[3];          /* least value that is inside: 0 for a top or left edge, otherwise 1 */
} ts_walk;

/* The edges at the centre of pixel (i, j), and their steps to the pixel on the right and to the one below. */
TS_FN ts_walk ts_k_walk(const ts_setup *t, i32 i, i32 j)
{
	ts_walk r;
	r.at = ts_k_edges(t, i * TS_SUB_PIXELS + TS_SUB_CENTRE, j * TS_SUB_PIXELS + TS_SUB_CENTRE);
	for (u32 k = 0u; k < 3u; k++) {
		ts_snapped a = t->v[k == 2u ? 0u : k + 1u];
		ts_snapped b = t->v[k == 0u ? 2u : k - 1u];
		r.right[k] = ((i64)a.y - b.y) * TS_SUB_PIXELS;
		r.down[k] = ((i64)b.x - a.x) * TS_SUB_PIXELS;
		r.least[k] = ts_k_is_top_left(a, b) ? 0 : 1;
	}
	return r;
}

TS_FN void ts_k_step(ts_edges *e, const i64 step[3])
{
	e->e[0] += step[0];
	e->e[1] += step[1];
	e->e[2] += step[2];
}

TS_FN bool ts_k_walk_covers(const ts_walk *w, const ts_edges *e)
{
	return e->e[0] >= w->least[0] && e->e[1] >= w->least[1] && e->e[2] >= w->least[2];
}

/* A covered pixel: axial depth, and perspective weights of the source triangle's corners (rule 22): b_k = E_k / area,
 * z = 1 / sum b/z, w = z sum (b/z) w. The area is the sum of the three E, exactly, as all are integers. */
typedef struct {
	f32 z;
	ts_v3 w;
} ts_fragment;

TS_FN ts_fragment ts_k_fragment(const ts_setup *t, const ts_edges *e, const ts_corner *a, const ts_corner *b,
                                const ts_corner *c)
{
	const f32 z[3] = {a->z, b->z, c->z};
	const ts_v3 corner[3] = {a->w, b->w, c->w};
	/* Interpolate 1 / z and the weights over z, which are linear in the image. */
	f32 sum = 0.0f;
	ts_v3 w = ts_v3_make(0.0f, 0.0f, 0.0f);
	f32 area = (f32)t->area;
	for (u32 k = 0u; k < 3u; k++) {
		u32 from = t->from[k];
		f32 share = (f32)e->e[k] / area;
		f32 over_z = share / z[from];
		sum = sum + over_z;
		w = ts_mad(w, corner[from], over_z);
	}
	ts_fragment r;
	/* Divide the perspective out. */
	r.z = ts_put(1.0f / sum);
	r.w = ts_scale(w, r.z);
	return r;
}

/* ts_k_fragment for an orthographic view: z = sum b z, w = sum b w. */
TS_FN ts_fragment ts_k_fragment_parallel(const ts_setup *t, const ts_edges *e, const ts_corner *a, const ts_corner *b,
                                         const ts_corner *c)
{
	f32 area = (f32)t->area;
	f32 share[3];
	for (u32 k = 0u; k < 3u; k++) share[t->from[k]] = (f32)e->e[k] / area;
	ts_v3 by = ts_v3_make(share[0], share[1], share[2]);
	ts_fragment r;
	r.z = ts_put(ts_blend1(by, a->z, b->z, c->z));
	r.w = ts_blend(by, a->w, b->w, c->w);
	return r;
}

#endif

/* A triangle alone, like ts_k_draw: clipped and set up once; then, tile by tile, the span of each row that it covers,
 * and all their pixels side by side. Edges are whole numbers below 2^52, which doubles hold exactly. Their crossings
 * with rows are exact, too: a quotient by a step of up to 2^32 is at least 2^-32 from any whole number that it does not
 * equal. */
#include "backends/c/raster/draw_batch.h"
#include "backends/c/raster/prepared.h"
#include "backends/wide.h"

enum { LANES = TS_DRAW_LANES, WIDEST = 512, ROWS = 64, PIXELS = 2048 };

/* A triangle of the fan in a tile. */
typedef struct {
	ts_box box;
	double edge[3], right[3], down[3], least[3]; /* at the tile's first pixel; steps */
	f32 z[3], area;
	u32 swapped; /* corners 1 and 2 are those of the source */
} tile;

/* Pixels that the triangle covers, row by row. */
typedef struct {
	double begin[ROWS], end[ROWS]; /* columns of the tile */
	i32 first[ROWS], n[ROWS];
	u32 n_pixels;
	f32 edge[3][PIXELS + LANES];
	u32 depth[PIXELS + LANES];
} pixels;

/* What is drawn. */
typedef struct {
	const ts_draw_batch *batch;
	ts_prepared of;
	u32 k; /* its fan's triangle */
	bool masked;
} drawn;

static inline double floor_within(double x, double least, double most)
{
	double near_by = x < least ? least : x > most ? most : x;
	return (double)((i32)(near_by + 65536.0) - 65536);
}

/* Each edge, as a line, cuts the rows. */
static inline void cut_rows(pixels *restrict to, const tile *restrict t, u32 k, i32 n)
{
	double edge = t->edge[k] - t->least[k], right = t->right[k], down = t->down[k], most = t->box.x1 - t->box.x0 + 1;
	if (right > 0) {
		for (i32 j = 0; j < n; j++) {
			double at = -floor_within((edge + (double)j * down) / right, -most, 0.0);
			to->begin[j] = at > to->begin[j] ? at : to->begin[j];
		}
	} else if (right < 0) {
		for (i32 j = 0; j < n; j++) {
			double at = floor_within((edge + (double)j * down) / -right, -1.0, most) + 1.0;
			to->end[j] = at < to->end[j] ? at : to->end[j];
		}
	} else {
		for (i32 j = 0; j < n; j++) to->end[j] = edge + (double)j * down < 0.0 ? 0.0 : to->end[j];
	}
}

TS_WIDE(void, find_spans, (pixels *restrict p, const tile *restrict t, i32 n), (p, t, n))
{
	for (i32 j = 0; j < n; j++) {
		p->begin[j] = 0.0;
		p->end[j] = t->box.x1 - t->box.x0 + 1;
	}
	for (u32 k = 0; k < 3; k++) cut_rows(p, t, k, n);
	u32 n_pixels = 0;
	for (i32 j = 0; j < n; j++) {
		p->first[j] = (i32)p->begin[j];
		p->n[j] = ts_max_i32((i32)p->end[j] - p->first[j], 0);
		n_pixels += (u32)p->n[j];
	}
	p->n_pixels = n_pixels;
}

/* Rows are written with room for spare lanes, which the next row overwrites. */
TS_WIDE(void, find_edges, (pixels *restrict to, const tile *restrict t, i32 n_rows), (to, t, n_rows))
{
	for (u32 k = 0; k < 3; k++) {
		f32 *row = to->edge[k];
		double right = t->right[k];
		for (i32 j = 0; j < n_rows; j++) {
			double edge = t->edge[k] + (double)j * t->down[k] + (double)to->first[j] * right;
			i32 n = (to->n[j] + LANES - 1) / LANES * LANES;
			for (i32 i = 0; i < n; i++) row[i] = (f32)(edge + (double)i * right);
			row += to->n[j];
		}
	}
}

TS_WIDE(void, find_pixel_depths, (pixels *restrict to, const tile *restrict t), (to, t))
{
	u32 n = (to->n_pixels + LANES - 1) / LANES * LANES;
	f32 area = t->area, za = t->z[0], zb = t->z[1], zc = t->z[2];
	for (u32 i = 0; i < n; i++) {
		f32 sum = (0.0f + (to->edge[0][i] / area) / za) + (to->edge[1][i] / area) / zb;
		to->depth[i] = ts_f2u(ts_put(1.0f / (sum + (to->edge[2][i] / area) / zc)));
	}
}

/* In an orthographic view. */
TS_WIDE(void, find_pixel_depths_parallel, (pixels *restrict to, const tile *restrict t), (to, t))
{
	u32 n = (to->n_pixels + LANES - 1) / LANES * LANES, b = 1 + t->swapped, c = 2 - t->swapped;
	f32 area = t->area, za = t->z[0], zb = t->z[b], zc = t->z[c];
	for (u32 i = 0; i < n; i++) {
		f32 sum = (to->edge[0][i] / area) * za + (to->edge[b][i] / area) * zb;
		to->depth[i] = ts_f2u(ts_put(sum + (to->edge[c][i] / area) * zc));
	}
}

TS_WIDE(void, write_keys, (u64 *restrict to, i32 width, const pixels *restrict p, u32 triangle, i32 n_rows),
        (to, width, p, triangle, n_rows))
{
	const u32 *depth = p->depth;
	for (i32 j = 0; j < n_rows; depth += p->n[j], to += width, j++) {
		u64 *row = to + p->first[j];
		for (i32 i = 0; i < p->n[j]; i++) {
			u64 key = (u64)depth[i] << 32 | triangle;
			row[i] = key < row[i] ? key : row[i];
		}
	}
}

TS_WIDE(void, write_depths, (u32 *restrict to, i32 width, const pixels *restrict p, i32 n_rows), (to, width, p, n_rows))
{
	const u32 *depth = p->depth;
	for (i32 j = 0; j < n_rows; depth += p->n[j], to += width, j++) {
		u32 *row = to + p->first[j];
		for (i32 i = 0; i < p->n[j]; i++) row[i] = depth[i] < row[i] ? depth[i] : row[i];
	}
}

/* Whether the alpha mask leaves pixel (i, j). */
static bool is_left(const drawn *d, i32 i, i32 j)
{
	const ts_draw_batch *b = d->batch;
	const ts_corner *corner = d->of.polygon.corner;
	const ts_setup *setup = &d->of.setup[d->k];
	ts_edges e = ts_k_edges(setup, i * TS_SUB_PIXELS + TS_SUB_CENTRE, j * TS_SUB_PIXELS + TS_SUB_CENTRE);
	ts_fragment f = ts_k_view_fragment(&b->view, setup, &e, &corner[0], &corner[d->k - 1], &corner[d->k]);
	f32 footprint = ts_k_fragment_footprint(&b->view, &d->of.corners, &f);
	return !ts_k_is_below_cutoff(b->scene, d->of.triangle, f.w, d->of.corners.n, footprint);
}

static void write_masked(const drawn *d, const pixels *p, const tile *t, i32 n_rows)
{
	const ts_target *to = &d->batch->target;
	const u32 *depth = p->depth;
	for (i32 j = 0; j < n_rows; depth += p->n[j], j++) {
		i32 x = t->box.x0 + p->first[j], y = t->box.y0 + j;
		u64 at = (u64)y * (u64)d->batch->view.width + (u64)x;
		for (i32 i = 0; i < p->n[j]; i++) {
			if (!ts_draw_is_nearer(to, at + (u64)i, depth[i], d->of.triangle) || !is_left(d, x + i, y)) continue;
			ts_draw_texel(to, at + (u64)i, depth[i], d->of.triangle);
		}
	}
}

static void draw_tile(const drawn *d, const tile *t)
{
	pixels p;
	const ts_draw_batch *b = d->batch;
	i32 n_rows = t->box.y1 - t->box.y0 + 1;
	u64 at = (u64)t->box.y0 * (u64)b->view.width + (u64)t->box.x0;
	find_spans(&p, t, n_rows);
	if (p.n_pixels == 0) return;
	find_edges(&p, t, n_rows);
	if (b->view.orthographic != 0) {
		find_pixel_depths_parallel(&p, t);
	} else {
		find_pixel_depths(&p, t);
	}
	if (d->masked) {
		write_masked(d, &p, t, n_rows);
	} else if (b->target.keys != NULL) {
		write_keys(b->target.keys + at, b->view.width, &p, d->of.triangle, n_rows);
	} else {
		write_depths(b->target.depths + at, b->view.width, &p, n_rows);
	}
}

static tile tile_of(const drawn *d, i32 i, i32 j)
{
	const ts_setup *setup = &d->of.setup[d->k];
	const ts_corner *corner[3] = {&d->of.polygon.corner[0], &d->of.polygon.corner[d->k - 1],
	                              &d->of.polygon.corner[d->k]};
	ts_walk walk = ts_k_walk(setup, i, j);
	tile t = {.area = (f32)setup->area, .swapped = setup->from[1] == 2};
	for (u32 k = 0; k < 3; k++) {
		t.z[k] = corner[setup->from[k]]->z;
		t.edge[k] = (double)walk.at.e[k];
		t.right[k] = (double)walk.right[k];
		t.down[k] = (double)walk.down[k];
		t.least[k] = (double)walk.least[k];
	}
	return t;
}

static void draw_fan(const drawn *d)
{
	ts_box box = ts_k_box_meet(ts_k_touched_box(d->of.setup[d->k].v, 3, 0), d->batch->owned);
	i32 width = ts_min_i32(box.x1 - box.x0 + 1, WIDEST), n_rows = width > 0 ? ts_min_i32(PIXELS / width, ROWS) : ROWS;
	for (i32 j = box.y0; j <= box.y1; j += n_rows) {
		for (i32 i = box.x0; i <= box.x1; i += width) {
			tile t = tile_of(d, i, j);
			t.box = ts_k_box_meet(box, (ts_box){i, j, i + width - 1, j + n_rows - 1});
			draw_tile(d, &t);
		}
	}
}

void ts_draw_alone(const ts_draw_batch *batch, u32 triangle, bool masked, bool clips)
{
	drawn d = {.batch = batch, .masked = masked};
	ts_prepare_if(&d.of, batch->scene, &batch->view, triangle, clips);
	for (d.k = 2; d.k < d.of.polygon.n; d.k++) {
		if (d.of.setup[d.k].area != 0) draw_fan(&d);
	}
}

#include "backends/selftest.h"

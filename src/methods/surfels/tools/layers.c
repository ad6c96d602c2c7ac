/* Whether epsilon blends two surfaces, such as a carpet and the floor below.
 *
 * Measured at pixels of a lattice, for the surfels whose ellipses the visibility pass leaves there and that face about
 * as the nearest does. The height of one over the nearest is along the mean of both normals, along which neighbours on
 * any curve of constant curvature are level. Heights of one surface lie close together or are scattered; those of two
 * layers form two clusters with a gap between them that is far wider than either. Both must have a surfel whose centre
 * is near: at the rim of a layer surfels stand out over the other one, and these should blend. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include "kernels/surfels/surfel_blend.h"
#include "methods/surfels/tools/tools.h"

#define ALIKE 0.9f       /* least cosine of their normals */
#define LEAST_GAP 0.05f  /* of epsilon: less is roughness */
#define FLAT 0.001f      /* of epsilon: the least width of clusters */
#define APART 16.0f      /* the least ratio of a gap's width to the clusters' */
#define INNER 0.1f       /* greatest r3D squared of the nearest centre of a layer */
#define LEAST_SHARE 0.01 /* of the pixels */

enum { MOST_PIXELS = 16384, HEAP = 2 }; /* of the lattice; least surfels of a layer */

typedef struct {
	const ts_surfel *surfels;
	const ts_disc *discs;
	const u64 *keys;
	ts_camera_k view;
	f32 epsilon;
	u32 n_surfels, step, columns, rows; /* the lattice has every step-th pixel */
	u32 *end;                           /* where each pixel's list ends; one entry later while it is written */
	u32 *list;                          /* NULL: surfels are counted */
} lattice;

static void take_surfel(const lattice *l, u32 i)
{
	const ts_filter nearest = {.opens = 0};
	i32 step = (i32)l->step;
	const ts_disc *disc = &l->discs[i];
	for (i32 y = (disc->low[1] + step - 1) / step * step; y <= disc->high[1]; y += step) {
		for (i32 x = (disc->low[0] + step - 1) / step * step; x <= disc->high[0]; x += step) {
			u64 key = l->keys[(u64)y * l->view.width + (u64)x];
			ts_v2 d = ts_k_disc_offset(disc, x, y);
			ts_disc_hit hit = ts_k_disc_hit(disc, l->view.near, d.x, d.y);
			if (!hit.inside || !ts_k_is_visible(&nearest, key, hit.z)) continue;
			u32 *at = &l->end[(u32)(y / step) * l->columns + (u32)(x / step) + 1];
			if (l->list != NULL) l->list[*at] = i;
			(*at)++;
		}
	}
}

static ts_v3 normal_of(const ts_surfel *s) { return ts_normalize(ts_cross(ts_load3(s->u), ts_load3(s->v))); }

/* A surfel at a pixel: its height over the nearest, and r3D squared. */
typedef struct {
	f32 height, r2;
} part;

/* False if it faces another way than the nearest. */
static bool part_of(part *r, const lattice *l, u32 nearest, u32 surfel, i32 x, i32 y)
{
	const ts_surfel *a = &l->surfels[nearest], *b = &l->surfels[surfel];
	ts_v3 n = normal_of(a), m = normal_of(b);
	ts_v2 d = ts_k_disc_offset(&l->discs[surfel], x, y);
	r->height = ts_dot(ts_sub(ts_load3(b->centre), ts_load3(a->centre)), ts_normalize(ts_add(n, m)));
	r->r2 = ts_k_disc_hit(&l->discs[surfel], l->view.near, d.x, d.y).r2;
	return ts_dot(n, m) >= ALIKE;
}

static int by_height(const void *a, const void *b)
{
	const part *x = a, *y = b;
	return (x->height > y->height) - (x->height < y->height);
}

static int by_value(const void *a, const void *b)
{
	f32 x = *(const f32 *)a, y = *(const f32 *)b;
	return (x > y) - (x < y);
}

static bool has_inner(const part *parts, u32 n)
{
	u32 k = 0;
	while (k < n && parts[k].r2 > INNER) k++;
	return k < n;
}

/* The gap between two layers, from parts in the order of their heights; 0: there is one layer. */
static f32 gap_of(const part *parts, u32 n, f32 epsilon)
{
	f32 widest = 0.0f;
	for (u32 k = HEAP; k + HEAP <= n; k++) {
		f32 gap = parts[k].height - parts[k - 1].height;
		f32 below = parts[k - 1].height - parts[0].height, above = parts[n - 1].height - parts[k].height;
		f32 heap = ts_max(ts_max(below, above), FLAT * epsilon);
		bool layers = gap > APART * heap && gap > LEAST_GAP * epsilon && has_inner(parts, k);
		if (layers && has_inner(parts + k, n - k)) widest = ts_max(widest, gap);
	}
	return widest;
}

static f32 gap_at(const lattice *l, u32 p, part *parts)
{
	u32 n = 0, x = p % l->columns * l->step, y = p / l->columns * l->step;
	u32 nearest = (u32)l->keys[(u64)y * l->view.width + x];
	for (u32 k = l->end[p]; k < l->end[p + 1]; k++) {
		if (part_of(&parts[n], l, nearest, l->list[k], (i32)x, (i32)y)) n++;
	}
	qsort(parts, n, sizeof *parts, by_height);
	return gap_of(parts, n, l->epsilon);
}

static void judge(ts_layers *layers, const lattice *l, part *parts, f32 *gaps)
{
	for (u32 p = 0; p < l->columns * l->rows; p++) {
		if (l->end[p] == l->end[p + 1]) continue;
		gaps[layers->apart] = gap_at(l, p, parts);
		if (gaps[layers->apart] > 0.0f) layers->apart++;
		layers->pixels++;
	}
	qsort(gaps, layers->apart, sizeof *gaps, by_value);
	if (layers->apart > 0) layers->gap = gaps[layers->apart / 2];
}

/* Lists the surfels at each pixel of the lattice; lists end where the next begins. */
static ts_status make_lists(lattice *l)
{
	u32 n = l->columns * l->rows, most = 0;
	for (u32 i = 0; i < l->n_surfels; i++) take_surfel(l, i);
	for (u32 p = 0; p < n; p++) {
		u32 count = l->end[p + 1];
		l->end[p + 1] = most;
		most += count;
	}
	l->list = ts_alloc((size_t)most + 1, sizeof *l->list, "layers of surfels");
	if (l->list == NULL) return TS_ERROR;
	for (u32 i = 0; i < l->n_surfels; i++) take_surfel(l, i);
	return TS_OK;
}

static lattice lattice_of(const ts_run *run)
{
	const ts_frame *frame = &run->frame;
	lattice l = {.surfels = ts_frame_data(frame, TS_B_scene_surfel),
	             .discs = ts_frame_data(frame, TS_B_surfel_setup_disc),
	             .keys = ts_frame_data(frame, TS_B_surfel_depth_surfel),
	             .view = ts_k_view(ts_frame_data(frame, TS_B_eye_view)),
	             .epsilon = *(const f32 *)ts_frame_data(frame, TS_B_surfel_setup_epsilon),
	             .n_surfels = (u32)ts_frame_n(frame, TS_B_scene_surfel),
	             .step = 1};
	do {
		l.columns = (l.view.width + l.step - 1) / l.step;
		l.rows = (l.view.height + l.step - 1) / l.step;
	} while ((u64)l.columns * l.rows > MOST_PIXELS && l.step++ > 0);
	return l;
}

ts_status ts_layers_measure(ts_layers *layers, const ts_run *run)
{
	*layers = (ts_layers){0};
	lattice l = lattice_of(run);
	u32 n = l.columns * l.rows;
	l.end = ts_alloc_zero((size_t)n + 1, sizeof *l.end, "layers of surfels");
	ts_status status = l.end != NULL ? make_lists(&l) : TS_ERROR;
	part *parts = status == TS_OK ? ts_alloc((size_t)l.end[n] + 1, sizeof *parts, "layers of surfels") : NULL;
	f32 *gaps = parts != NULL ? ts_alloc(n, sizeof *gaps, "layers of surfels") : NULL;
	if (gaps != NULL) judge(layers, &l, parts, gaps);
	status = gaps != NULL ? TS_OK : TS_ERROR;
	free(gaps);
	free(parts);
	free(l.list);
	free(l.end);
	return status;
}

ts_status ts_layers_note(char note[TS_NOTE_CHARS], const ts_run *run)
{
	ts_layers layers;
	if (ts_layers_measure(&layers, run) != TS_OK) return TS_ERROR;
	double share = layers.pixels > 0 ? (double)layers.apart / layers.pixels : 0.0;
	if (share < LEAST_SHARE) return TS_OK;
	f32 epsilon = *(const f32 *)ts_frame_data(&run->frame, TS_B_surfel_setup_epsilon);
	snprintf(note, TS_NOTE_CHARS,
	         "at %.0f %% of its surface or more, layers are blended that lie %.3g apart (median): epsilon is %.3g, "
	         "a surfel_depth.epsilon below that gap parts them",
	         100.0 * share, (double)layers.gap, (double)epsilon);
	return TS_OK;
}

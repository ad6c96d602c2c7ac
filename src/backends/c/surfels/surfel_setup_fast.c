/* Fast path of the set-up of surfels, with the same bits: those that face the eye side by side, by the kernel's own
 * functions in loops without branches, which compilers vectorize. */
#include "backends/fast.h"
#include "backends/wide.h"
#include "kernels/surfels/surfel_setup.h"
#include "model/core.h"

enum { LOT = 64, VECTOR = 16, FATES = TS_DISC_BESIDE + 1 };

/* Some of the surfels from `first` on side by side, in full vectors, and their set-up in the view. The fate is
 * TS_DISC_DRAWN if only the place of the box can speak against that. */
typedef struct {
	const ts_surfel *first;
	u32 n, index[LOT], fate[LOT], flags[LOT];
	f32 centre[3][LOT], u[3][LOT], v[3][LOT], slant[LOT], normal[3][LOT];
	i32 pixel[2][LOT], low[2][LOT], high[2][LOT];
	f32 fraction[2][LOT], a[2][LOT], b[2][LOT], g[2][LOT], depth[LOT];
} lot;

static u32 padded(u32 n) { return (n + VECTOR - 1) / VECTOR * VECTOR; }

static void load(lot *l)
{
	for (u32 i = 0; i < l->n; i++) {
		const ts_surfel *s = &l->first[l->index[i]];
		for (u32 k = 0; k < 3; k++) {
			l->centre[k][i] = s->centre[k];
			l->u[k][i] = s->u[k];
			l->v[k][i] = s->v[k];
		}
	}
}

static ts_surfel surfel(const lot *l, u32 i)
{
	return (ts_surfel){.centre = {l->centre[0][i], l->centre[1][i], l->centre[2][i]},
	                   .u = {l->u[0][i], l->u[1][i], l->u[2][i]},
	                   .v = {l->v[0][i], l->v[1][i], l->v[2][i]}};
}

static void keep_facing(lot *l, ts_camera_k view)
{
	u32 n = 0;
	for (u32 i = 0; i < padded(l->n); i++) {
		ts_surfel s = surfel(l, i);
		l->slant[i] = ts_k_disc_slant(&view, ts_load3(s.centre), ts_k_disc_normal(&s));
	}
	for (u32 i = 0; i < l->n; i++) {
		l->index[n] = i;
		n += l->slant[i] > 0.0f ? 1 : 0;
	}
	l->n = n;
	load(l);
}

/* ts_k_disc_make, by selects; not for surfels that may cross the near plane. */
static void make(lot *l, ts_camera_k view, ts_filter filter)
{
	const ts_filter unmoved = {.filter = TS_FILTER_SCREEN};
	u32 parallel = view.orthographic != 0 ? TS_DISC_PARALLEL : 0;
	for (u32 i = 0; i < padded(l->n); i++) {
		ts_surfel s = surfel(l, i);
		ts_v3 n = ts_k_disc_normal(&s);
		f32 slant = ts_k_disc_slant(&view, ts_load3(s.centre), n);
		ts_disc_frame frame = ts_k_disc_frame(&view, &unmoved, &s);
		ts_disc d = {.flags = (slant < TS_LEAST_SLANT ? TS_DISC_FLAT : 0) | parallel};
		ts_k_disc_place(&d, &view, &frame);
		ts_k_disc_map(&d, &frame);
		f32 farther = ts_max(ts_abs((f32)d.pixel[0]), ts_abs((f32)d.pixel[1]));
		u32 fate = farther < TS_FARTHEST_PIXEL ? TS_DISC_DRAWN : TS_DISC_BESIDE;
		for (u32 k = 0; k < 2; k++) d.pixel[k] = fate == TS_DISC_DRAWN ? d.pixel[k] : 0;
		ts_k_disc_box(&d, &view, &filter, &frame);
		l->fate[i] = frame.c.z >= view.near ? fate : TS_DISC_BEFORE;
		l->flags[i] = d.flags;
		l->depth[i] = d.depth;
		for (u32 k = 0; k < 2; k++) {
			l->pixel[k][i] = d.pixel[k];
			l->fraction[k][i] = d.fraction[k];
			l->a[k][i] = d.a[k];
			l->b[k][i] = d.b[k];
			l->g[k][i] = d.g[k];
			l->low[k][i] = d.low[k];
			l->high[k][i] = d.high[k];
		}
		l->normal[0][i] = ts_put(n.x);
		l->normal[1][i] = ts_put(n.y);
		l->normal[2][i] = ts_put(n.z);
	}
}

static void store(ts_disc *d, const lot *l, u32 i)
{
	d->flags = l->flags[i];
	d->depth = l->depth[i];
	for (u32 k = 0; k < 2; k++) {
		d->pixel[k] = l->pixel[k][i];
		d->fraction[k] = l->fraction[k][i];
		d->a[k] = l->a[k][i];
		d->b[k] = l->b[k][i];
		d->g[k] = l->g[k][i];
		d->low[k] = l->low[k][i];
		d->high[k] = l->high[k][i];
	}
	for (u32 k = 0; k < 3; k++) d->normal[k] = l->normal[k][i];
}

TS_WIDE(void, set_up, (const ts_surfel_setup_args *args, u64 first, u32 n, i64 tally[FATES]), (args, first, n, tally))
{
	ts_camera_k view = ts_k_view(args->view);
	lot l = {.first = args->surfels + first, .n = n};
	for (u32 i = 0; i < n; i++) {
		l.index[i] = i;
		ts_k_disc_clear(&args->discs[first + i]);
	}
	load(&l);
	keep_facing(&l, view);
	make(&l, view, args->filter);
	tally[TS_DISC_TURNED] += n - l.n;
	for (u32 i = 0; i < l.n; i++) {
		bool beside = l.low[0][i] > l.high[0][i] || l.low[1][i] > l.high[1][i];
		u32 fate = beside && l.fate[i] == TS_DISC_DRAWN ? TS_DISC_BESIDE : l.fate[i];
		u64 at = first + l.index[i];
		if (fate == TS_DISC_BEFORE) {
			fate = ts_k_disc(&args->discs[at], &view, &args->filter, &args->surfels[at]);
		} else if (fate == TS_DISC_DRAWN) {
			store(&args->discs[at], &l, i);
		}
		tally[fate]++;
	}
}

bool ts_c_fast_surfel_setup(const void *of, u64 n, u32 threads)
{
	enum { LOTS = 16 };
	const ts_surfel_setup_args *args = of;
	ts_stop *stop = ts_stop_here();
	if (args->filter.filter == TS_FILTER_EWA) return false;
#pragma omp parallel num_threads(threads)
	{
		i64 tally[FATES] = {0};
#pragma omp for schedule(dynamic, LOTS)
		for (i64 i = 0; i < (i64)n; i += LOT) {
			if (ts_stopped(stop)) continue;
			set_up(args, (u64)i, (u32)(n - (u64)i < LOT ? n - (u64)i : LOT), tally);
		}
		for (u32 fate = 0; fate < FATES; fate++) ts_add_i64(&args->tally[fate], tally[fate]);
	}
	return true;
}

#include "backends/selftest.h"

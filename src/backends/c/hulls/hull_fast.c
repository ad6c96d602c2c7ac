/* Fast path of the hull kernel, with the same bits: the closed form of many lobes in one loop without branches, which
 * compilers make of vector instructions. */
#include "backends/fast.h"
#include "backends/wide.h"
#include "kernels/hulls/hull.h"

enum { PIXELS = 64, LOBES = 3 * PIXELS };

/* Lobes to integrate, and the element of the irradiance that each is for. */
typedef struct {
	f32 mu[LOBES], lambda[LOBES], phi[3][LOBES], n[3][LOBES], e[LOBES];
	u64 at[LOBES];
	u32 count;
} lobes;

static const ts_hull_args stable = {.cosine = TS_COSINE_OURS, .printed = 0};

static void add(lobes *l, u64 at, ts_sg g, ts_v3 n)
{
	u32 i = l->count++;
	l->mu[i] = g.mu;
	l->lambda[i] = g.lambda;
	l->phi[0][i] = g.phi.x;
	l->phi[1][i] = g.phi.y;
	l->phi[2][i] = g.phi.z;
	l->n[0][i] = n.x;
	l->n[1][i] = n.y;
	l->n[2][i] = n.z;
	l->at[i] = at;
}

static void add_pixel(const ts_hull_args *args, lobes *l, u64 i)
{
	u32 x = (u32)(i % args->width), y = (u32)(i / args->width % args->height);
	u32 box = ts_k_hull_box(args, i, x, y);
	if (box == TS_NONE) return;
	ts_shares shares = ts_k_box_shares(args, box, x, y);
	ts_v3 n = ts_load3(args->pixels[i].normal);
	for (u32 c = 0; c < 3; c++) add(l, i * 3 + c, ts_k_lobes_blend(args->lobes + (u64)box * 4, &shares, c), n);
}

TS_WIDE(void, integrate, (lobes * l), (l))
{
	for (u32 i = 0; i < LOBES; i++) {
		ts_v3 phi = ts_normalize(ts_v3_make(l->phi[0][i], l->phi[1][i], l->phi[2][i]));
		ts_sg g = ts_sg_make(l->mu[i], l->lambda[i], phi);
		l->e[i] = ts_k_lobe_irradiance(&stable, &g, ts_v3_make(l->n[0][i], l->n[1][i], l->n[2][i]));
	}
}

/* Eqs 15 to 18 in their stable forms, with interpolated parameters. */
bool ts_c_fast_hull(const void *of, u64 n, u32 threads)
{
	const ts_hull_args *args = of;
	if (args->cosine != TS_COSINE_OURS || args->printed != 0 || args->by_moments != 0) return false;
	ts_stop *stop = ts_stop_here();
#pragma omp parallel num_threads(threads)
	{
		lobes l = {.count = 0};
#pragma omp for schedule(dynamic, 64)
		for (i64 group = 0; group < (i64)((n + PIXELS - 1) / PIXELS); group++) {
			u64 first = (u64)group * PIXELS;
			if (ts_stopped(stop)) continue;
			l.count = 0;
			for (u64 i = first; i < first + PIXELS && i < n; i++) add_pixel(args, &l, i);
			integrate(&l);
			for (u32 i = 0; i < l.count; i++) args->irradiance[l.at[i]] = l.e[i];
		}
	}
	return true;
}

#include "backends/selftest.h"

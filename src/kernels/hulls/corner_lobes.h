/* Spherical Gaussians of the light that a corner gathered, one per channel (SSAGH eqs 4 and 5; METHODS 11). m is the
 * sum of the weights, phi' the sum of weights times directions divided by m, r the length of phi'. Then phi = phi' / r,
 * lambda follows from r, and mu = m / A(lambda). Without light mu is 0 and lambda 1. If r < 1e-6 there is nearly no
 * direction: the lobe is the same on all sides, and phi is 0. */
#ifndef TS_KERNELS_HULLS_CORNER_LOBES_H
#define TS_KERNELS_HULLS_CORNER_LOBES_H
#include "kernels/base/args.h"
#include "kernels/base/records.h"
#include "kernels/hulls/gaussian.h"

TS_FN ts_sg ts_k_fit(f32 m, ts_v3 directions, u32 vmf)
{
	ts_v3 none = ts_v3_make(0.0f, 0.0f, 0.0f);
	if (!(ts_flush(m) > 0.0f)) return ts_sg_make(0.0f, 1.0f, none);
	ts_v3 mean = ts_v3_make(directions.x / m, directions.y / m, directions.z / m);
	f32 r = ts_length(mean);
	f32 lambda = ts_k_sg_sharpness(r, vmf);
	ts_v3 phi = r < ts_u2f(0x358637bdu) ? none : ts_normalize(mean); /* 1e-6 */
	return ts_sg_make(m / ts_k_sg_integral(lambda), lambda, phi);
}

#define TS_ROWS_ts_corner_lobes_args(ARG) \
	ARG(IN, ts_moment, moments, corner_moment) \
	ARG(OUT, ts_lobes, lobes, corner_lobes) \
	ARG(VALUE, u32, vmf, none) /* hull.sharpness=vmf */
TS_ARGS(ts_corner_lobes_args);

/* map over corners of boxes */
TS_FN void ts_k_corner_lobes_item(const ts_corner_lobes_args *args, u64 i)
{
	TS_GLOBAL const ts_moment *moment = &args->moments[i];
	TS_GLOBAL ts_lobes *out = &args->lobes[i];
	for (u32 channel = 0u; channel < 3u; channel++) {
		ts_sg g = ts_k_fit(moment->sum[channel], ts_load3(moment->direction + channel * 3u), args->vmf);
		out->mu[channel] = ts_put(g.mu);
		out->lambda[channel] = ts_put(g.lambda);
		ts_store3(out->phi + channel * 3u, g.phi);
	}
	out->pad = 0u;
}

#endif

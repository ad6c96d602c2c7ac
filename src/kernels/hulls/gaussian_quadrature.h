/* The integral of a spherical Gaussian with the clamped cosine (SSAGH 4, eq. 12) by quadrature, against which the
 * closed form of gaussian.h is tested. The sphere is divided into rings about the Gaussian's axis, at u = 1 - phi.w.
 * A_h is the integral of e^(-lambda u) H(u) for u from 0 to 2, where H is the integral of max(0, n.w) along the ring.
 * With c = n.phi, s = sqrt(1 - c^2) and x = 1 - u:
 *   |x| <= s   H = 2 (c x psi + root), root = sqrt(s^2 - x^2), psi the angle of (-c x, root): a ring on the horizon
 *   otherwise  H = 2 pi max(0, c x): a ring above the horizon, or below it
 * So two parts have light: the band |x| <= s, and a cap before the band if c is above 0, otherwise behind it. */
#ifndef TS_KERNELS_HULLS_GAUSSIAN_QUADRATURE_H
#define TS_KERNELS_HULLS_GAUSSIAN_QUADRATURE_H
#include "kernels/base/vec.h"

#define TS_SG_NODES 64u

/* The length of u that is integrated: the rest, in which e^(-lambda u) is below 2e-9 of its value at the start, is left
 * out. */
TS_FN f32 ts_k_sg_reach(f32 lambda, f32 length)
{
	f32 decay = lambda * length;
	return decay > 20.0f ? 20.0f / lambda : length;
}

/* Node i, from 0 to 1, and its weight: the midpoint rule after the substitution y^3 (10 - 15 y + 6 y^2) (Korobov 1963),
 * which flattens both ends of an interval. There H behaves like the power 3/2 of the distance from the end, which the
 * plain midpoint rule integrates badly. */
TS_FN f32 ts_k_sg_node(u32 i, f32 *weight)
{
	f32 y = ((f32)i + 0.5f) * (1.0f / (f32)TS_SG_NODES);
	f32 rest = 1.0f - y;
	f32 both = y * rest;
	*weight = (both * both) * (30.0f / (f32)TS_SG_NODES);
	f32 p = 6.0f * y;
	p = p - 15.0f;
	p = p * y;
	p = p + 10.0f;
	f32 cube = (y * y) * y;
	return cube * p;
}

/* H / 2 in the band, v from its start. */
TS_FN f32 ts_k_sg_band(f32 c, f32 s, f32 v)
{
	f32 cx = c * (s - v);
	f32 width = 2.0f * s;
	f32 root = ts_sqrt(v * (width - v));
	f32 turned = cx * ts_atan2(root, -cx);
	return turned + root;
}

/* The integral of SSAGH eq. 12 for G(1, lambda, phi), where c = n.phi is from -1 to 1. */
TS_CALL f32 ts_k_sg_quadrature(f32 lambda, f32 c)
{
	/* Find the lengths of cap and band along u; the cap's is 1 - s, here without cancellation. */
	f32 s = ts_sqrt((1.0f - c) * (1.0f + c));
	f32 height = (c * c) / (1.0f + s);
	f32 width = 2.0f * s;
	/* Shorten both where e^(-lambda u) has died out. */
	f32 cap = ts_k_sg_reach(lambda, height);
	f32 band = ts_k_sg_reach(lambda, width);
	f32 in_cap = 0.0f;
	f32 in_band = 0.0f;
	for (u32 i = 0u; i < TS_SG_NODES; i++) {
		f32 weight;
		f32 at = ts_k_sg_node(i, &weight);
		/* Add the node's part of the cap: it comes before the band if c is above 0, otherwise behind it. */
		f32 v = cap * at;
		f32 x = c > 0.0f ? 1.0f - v : s + v;
		f32 part = (weight * x) * ts_exp(-(lambda * v));
		in_cap = in_cap + part;
		/* Add the node's part of the band, whose rings cross the horizon. */
		v = band * at;
		part = (weight * ts_k_sg_band(c, s, v)) * ts_exp(-(lambda * v));
		in_band = in_band + part;
	}
	/* Multiply by the exponential at the start of each part, from which the nodes count. */
	f32 to_band = ts_flush(ts_exp(-(lambda * height)));
	f32 to_cap = c > 0.0f ? 1.0f : ts_flush(ts_exp(-(lambda * (1.0f + s))));
	f32 of_cap = ts_flush((ts_abs(c) * (cap * in_cap)) * to_cap);
	f32 of_band = ts_flush((band * in_band) * to_band);
	/* Apply the factors of H: 2 pi in the cap, and 2 in the band. */
	of_cap = of_cap * TS_PI_F32;
	return 2.0f * (of_cap + of_band);
}

#endif

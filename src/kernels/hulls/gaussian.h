/* Spherical Gaussians (SSAGH, section 4; CONTRACT rule 41): G(mu, lambda, phi) is mu e^(lambda (phi.w - 1)) in
 * direction w, phi a unit vector. The integrals are over the sphere, and with the cosine to a normal n over the
 * hemisphere about n, for the height mu = 1 and sharpness lambda from 0 to 1e5. Where the paper's forms cancel or
 * overflow in single precision, equal forms take their place that do not; errors are within 8e-7. */
#ifndef TS_KERNELS_HULLS_GAUSSIAN_H
#define TS_KERNELS_HULLS_GAUSSIAN_H
#include "kernels/hulls/gaussian_quadrature.h"

#define TS_COSINE_OURS 0u       /* eqs 15 to 18 */
#define TS_COSINE_CONSTANT 1u   /* eq 7 */
#define TS_COSINE_SG 2u         /* eq 8 */
#define TS_COSINE_QUADRATURE 3u /* eq 12 */

typedef struct {
	ts_v3 phi;
	f32 mu, lambda;
} ts_sg;

TS_FN ts_sg ts_sg_make(f32 mu, f32 lambda, ts_v3 phi)
{
	ts_sg r;
	r.phi = phi;
	r.mu = mu;
	r.lambda = lambda;
	return r;
}

/* Eq 3. The exponent lambda3 - lambda1 - lambda2 is -lambda1 lambda2 |phi1 - phi2|^2 over the sum of the three. */
TS_FN ts_sg ts_k_sg_product(const ts_sg *a, const ts_sg *b)
{
	ts_v3 both = ts_mad(ts_scale(a->phi, a->lambda), b->phi, b->lambda);
	ts_v3 apart = ts_sub(a->phi, b->phi);
	f32 lambda = ts_length(both);
	f32 all = (a->lambda + b->lambda) + lambda;
	f32 lost = (a->lambda * b->lambda) * ts_dot(apart, apart);
	lost = all > 0.0f ? lost / all : 0.0f;
	return ts_sg_make(ts_flush((a->mu * b->mu) * ts_exp(-lost)), lambda, ts_normalize(both));
}

/* clang-format off */
/* Eq 2: A(lambda) = 2 pi / lambda (1 - e^(-2 lambda)). If lambda is below 1/4, A is computed as 4 pi times the sum of
 * (-2 lambda)^j / (j + 1)!, j from 0 to 7. */
TS_FN f32 ts_k_sg_integral(f32 lambda)
{
	/* Evaluate the series of (1 - e^-x) / x by Horner's rule, for small x, where the closed form cancels. */
	f32 x = 2.0f * lambda;
	f32 p = -0.000024801587642286904156208038330078125f;
	p = p * x; p = p + 0.000198412701138295233249664306640625f;
	p = p * x; p = p - 0.001388888922519981861114501953125f;
	p = p * x; p = p + 0.008333333767950534820556640625f;
	p = p * x; p = p - 0.0416666679084300994873046875f;
	p = p * x; p = p + 0.16666667163372039794921875f;
	p = p * x; p = p - 0.5f;
	p = p * x; p = p + 1.0f;
	/* Evaluate the closed form; x is not 0 where it is chosen. */
	f32 closed = x > 0.0f ? (1.0f - ts_exp(-x)) / x : 1.0f;
	/* Choose one of the two; 4 pi is the integral where lambda is 0. */
	return TS_FOUR_PI * (x < 0.5f ? p : closed);
}

/* Eq 9, or eq 10 for the lower side, as printed, for lambda above 0. Both cancel where lambda is small; e^lambda
 * saturates at the largest float. */
TS_FN f32 ts_k_sg_printed(f32 lambda, bool lower)
{
	f32 scale = TS_TWO_PI / (lambda * lambda);
	f32 upper = (ts_exp(-lambda) - 1.0f) + lambda;
	f32 rest = (ts_exp(lambda) - 1.0f) - lambda;
	f32 faded = scale * ts_flush(ts_exp(-2.0f * lambda));
	return lower ? faded * rest : scale * upper;
}

/* Eq 9: A_u(lambda) = 2 pi / lambda^2 (e^-lambda - 1 + lambda), for n = phi. If lambda is below 1/2, A_u is computed as
 * 2 pi times the sum of (-lambda)^j / (j + 2)!, j from 0 to 7. */
TS_FN f32 ts_k_sg_upper(f32 lambda, u32 printed)
{
	/* Follow SSAGH eq. 9 as printed, if asked to. */
	if (printed != 0u && lambda > 0.0f) return ts_k_sg_printed(lambda, false);
	/* Evaluate the series by Horner's rule, for small lambda, where the closed form cancels. */
	f32 p = -0.000002755731884462875314056873321533203125f;
	p = p * lambda; p = p + 0.000024801587642286904156208038330078125f;
	p = p * lambda; p = p - 0.000198412701138295233249664306640625f;
	p = p * lambda; p = p + 0.001388888922519981861114501953125f;
	p = p * lambda; p = p - 0.008333333767950534820556640625f;
	p = p * lambda; p = p + 0.0416666679084300994873046875f;
	p = p * lambda; p = p - 0.16666667163372039794921875f;
	p = p * lambda; p = p + 0.5f;
	if (lambda < 0.5f) return TS_TWO_PI * p;
	/* Evaluate the closed form of SSAGH eq. 9; its digits suffice from 1/2 on. */
	f32 m = (ts_exp(-lambda) - 1.0f) + lambda;
	return (TS_TWO_PI * m) / (lambda * lambda);
}

/* Eq 10: A_b(lambda) = 2 pi / lambda^2 e^(-2 lambda) (e^lambda - 1 - lambda), for n = -phi. If lambda is below 1/2, A_b
 * is computed as 2 pi e^-lambda times the sum of (-lambda)^j (j + 1) / (j + 2)!, j from 0 to 7. */
TS_FN f32 ts_k_sg_lower(f32 lambda, u32 printed)
{
	/* Follow SSAGH eq. 10 as printed, if asked to. */
	if (printed != 0u && lambda > 0.0f) return ts_k_sg_printed(lambda, true);
	/* Compute e^-lambda, which is flushed to 0 for sharp lobes: they send nothing to the other side. */
	f32 e = ts_flush(ts_exp(-lambda));
	/* Evaluate the series by Horner's rule, for small lambda, where the closed form cancels. */
	f32 p = -0.000022045855075703002512454986572265625f;
	p = p * lambda; p = p + 0.000173611115314997732639312744140625f;
	p = p * lambda; p = p - 0.001190476235933601856231689453125f;
	p = p * lambda; p = p + 0.0069444444961845874786376953125f;
	p = p * lambda; p = p - 0.0333333350718021392822265625f;
	p = p * lambda; p = p + 0.125f;
	p = p * lambda; p = p - TS_THIRD;
	p = p * lambda; p = p + 0.5f;
	f32 scale = TS_TWO_PI * e;
	if (lambda < 0.5f) return scale * p;
	/* Evaluate the closed form of SSAGH eq. 10, with e^(-2 lambda) e^lambda as e^-lambda, so that nothing overflows. */
	f32 le = lambda * e;
	f32 m = (1.0f - e) - le;
	return (scale * m) / (lambda * lambda);
}

/* Eq 18: the steepness of the logistic curve. */
TS_FN f32 ts_k_sg_t(f32 lambda)
{
	f32 part = lambda / (lambda + 4.465300083160400390625f);
	f32 root = 2.100699901580810546875f * ts_sqrt(lambda);
	return root * part;
}

/* Eq 17, 1 / u = 0.2958 t + 0.5033: the share of the cosine over the whole sphere. */
TS_FN f32 ts_k_sg_s(f32 t, f32 cos_beta)
{
	f32 per_u = 0.2958000004291534423828125f * t;
	per_u = per_u + 0.503300011157989501953125f;
	f32 x = ts_flush(ts_exp(-(ts_abs(cos_beta) * t)));
	return (x / (1.0f + x)) / per_u;
}

/* Eq 16: from the cosine over the whole sphere to the clamped one. */
TS_FN f32 ts_k_sg_c(f32 s, f32 cos_beta)
{
	f32 whole = 0.5f * cos_beta;
	whole = whole + 0.5f;
	f32 clamped = ts_max(0.0f, cos_beta);
	f32 a = s * whole;
	f32 b = (1.0f - s) * clamped;
	return ts_flush(a + b);
}

/* Eq 15: A_h from A_u and A_b. */
TS_FN f32 ts_k_sg_ours(f32 lambda, f32 cos_beta, u32 printed)
{
	f32 c = ts_k_sg_c(ts_k_sg_s(ts_k_sg_t(lambda), cos_beta), cos_beta);
	f32 upper = c * ts_k_sg_upper(lambda, printed);
	f32 lower = (1.0f - c) * ts_k_sg_lower(lambda, printed);
	return upper + lower;
}

/* Eq 8: the cosine as G(1, 2, n), here n = (0, 0, 1). */
TS_FN f32 ts_k_sg_as_sg(f32 lambda, f32 cos_beta)
{
	f32 sine = ts_sqrt((1.0f - cos_beta) * (1.0f + cos_beta));
	ts_sg light = ts_sg_make(1.0f, lambda, ts_v3_make(sine, 0.0f, cos_beta));
	ts_sg cosine = ts_sg_make(1.0f, 2.0f, ts_v3_make(0.0f, 0.0f, 1.0f));
	ts_sg both = ts_k_sg_product(&light, &cosine);
	return both.mu * ts_k_sg_integral(both.lambda);
}

/* A_h, the integral of G(1, lambda, phi) times the clamped cosine to n, where cos_beta = n.phi. The method is one of
 * TS_COSINE_*; if printed is not 0, eqs 9 and 10 are taken as printed. */
TS_FN f32 ts_k_sg_cosine(f32 lambda, f32 cos_beta, u32 method, u32 printed)
{
	f32 c = ts_clamp(cos_beta, -1.0f, 1.0f);
	if (method == TS_COSINE_CONSTANT) return ts_max(0.0f, c) * ts_k_sg_integral(lambda);
	if (method == TS_COSINE_SG) return ts_k_sg_as_sg(lambda, c);
	if (method == TS_COSINE_QUADRATURE) return ts_k_sg_quadrature(lambda, c);
	return ts_k_sg_ours(lambda, c, printed);
}

/* The length of the mean of a von Mises-Fisher distribution (Fisher 1953), which is a normalized spherical Gaussian of
 * sharpness k: coth k - 1 / k, or its series if k is below 1/2. */
TS_FN f32 ts_k_sg_mean(f32 k)
{
	/* Evaluate the series in k^2 by Horner's rule, for small k, where coth k and 1 / k cancel. */
	f32 z = k * k;
	f32 p = -0.000211640217457897961139678955078125f;
	p = p * z; p = p + 0.0021164021454751491546630859375f;
	p = p * z; p = p - 0.02222222276031970977783203125f;
	p = p * z; p = p + TS_THIRD;
	if (k < 0.5f) return p * k;
	/* Compute coth k from e^(-2 k), which cannot overflow, and subtract 1 / k. */
	f32 e = ts_exp(-2.0f * k);
	f32 coth = (1.0f + e) / (1.0f - e);
	return coth - 1.0f / k;
}
/* clang-format on */

#define TS_VMF_NEAR_ONE 0.89999997615814208984375f /* from here on coth k is 1 within 4e-9 */

/* The inverse of ts_k_sg_mean: the estimate k = r (3 - r^2) / (1 - r^2) of Banerjee, Dhillon, Ghosh and Sra (2005),
 * which is within 5 %, improved by three Newton steps. Near r = 1 coth k is 1, so k is 1 / (1 - r). */
TS_FN f32 ts_k_sg_vmf(f32 r)
{
	/* Answer both ends directly: without a direction there is no sharpness, and near 1 coth k is 1. */
	if (!(r > 0.0f)) return 0.0f;
	if (r > TS_VMF_NEAR_ONE) return 1.0f / (1.0f - r);
	/* Start from the estimate of Banerjee, Dhillon, Ghosh and Sra (2005). */
	f32 r2 = r * r;
	f32 k = (r * (3.0f - r2)) / (1.0f - r2);
	/* Improve the estimate by Newton's method; the mean R has the derivative 1 - R^2 - 2 R / k. */
	for (u32 i = 0u; i < 3u; i++) {
		f32 at = ts_k_sg_mean(k);
		f32 square = at * at;
		f32 slope = (1.0f - square) - (2.0f * at) / k;
		k = k - (at - r) / slope;
	}
	return k;
}

/* Eq 4: the sharpness of light whose directions have a mean of length r, clamped to 1 - 1e-5. It is r / (1 - r)
 * (Toksvig 2005), or that of the von Mises-Fisher distribution with this mean. */
TS_FN f32 ts_k_sg_sharpness(f32 r, u32 vmf)
{
	f32 at = ts_clamp(r, 0.0f, 0.999989986419677734375f);
	return vmf != 0u ? ts_k_sg_vmf(at) : at / (1.0f - at);
}

#define TS_LEAST_ACROSS 0.0009765625f /* 2^-10: bounds the sharpness at grazing angles */

/* The lobe of a glossy surface about the reflected direction to the eye. GGX's distribution of normals (Walter,
 * Marschner, Li and Torrance 2007) has the peak 1 / (pi a2), a2 = alpha^2, and the integral 1 with the cosine. The
 * Gaussian about the normal with the same peak and integral has a sharpness of (1 - a2) (2 / a2 + 1) within 1.4 %, and
 * exactly where a2 is 0 or 1. A half vector turns by half the angle of the direction of light, and by less across the
 * plane of the eye, so the sharpness is divided by 4 n.v (Wang, Ren, Gong, Snyder and Guo 2009). n and v are unit
 * vectors; n.v counts as at least 2^-10. */
TS_FN ts_sg ts_k_gloss_lobe(ts_v3 n, ts_v3 v, f32 alpha_squared)
{
	f32 n_v = ts_dot(n, v);
	f32 across = ts_max(ts_abs(n_v), TS_LEAST_ACROSS);
	ts_v3 phi = ts_normalize(ts_sub(ts_scale(n, 2.0f * n_v), v));
	f32 sharpness = (1.0f - alpha_squared) * (2.0f / alpha_squared + 1.0f);
	return ts_sg_make(TS_PER_PI / alpha_squared, sharpness / (4.0f * across), phi);
}

#endif

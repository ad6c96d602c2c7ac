/* The integrals of spherical Gaussians in double precision, from their definitions. */
#ifndef TS_TESTS_KERNELS_HULLS_GAUSSIAN_TRUTH_H
#define TS_TESTS_KERNELS_HULLS_GAUSSIAN_TRUTH_H
#include <math.h>

static const double sg_pi = 3.14159265358979323846;

/* Eq 1, in a direction at this cosine to phi. */
static inline double sg_value(double mu, double lambda, double c) { return mu * exp(lambda * (c - 1)); }

/* e^-x I0(x): the power series, as far as its terms count, or the asymptotic one. */
static inline double sg_bessel(double x)
{
	double term = 1, sum = 1;
	if (x < 30) {
		for (int k = 1; term > 1e-17 * sum; k++) {
			term *= x * x / (4.0 * k * k);
			sum += term;
		}
		return sum * exp(-x);
	}
	for (int k = 1; k < 16; k++) {
		term *= (2 * k - 1.0) * (2 * k - 1.0) / (8 * k * x);
		sum += term;
	}
	return sum / sqrt(2 * sg_pi * x);
}

/* Gauss and Legendre's rule of eight nodes, over `panels` parts of [from, to]. */
typedef double sg_integrand(double x, const double *parameters);
static inline double sg_integrate(sg_integrand *f, const double *parameters, double from, double to, int panels)
{
	static const double node[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
	static const double weight[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
	double half = (to - from) / panels / 2, sum = 0;
	for (int i = 0; i < panels; i++) {
		double middle = from + half * (2 * i + 1);
		for (int k = 0; k < 4; k++) {
			sum += weight[k] * (f(middle - half * node[k], parameters) + f(middle + half * node[k], parameters));
		}
	}
	return sum * half;
}

/* Eq 12, the integral over phi done: 2 pi cos sin e^(lambda (cos beta cos - 1)) I0(lambda sin beta sin). */
static inline double sg_slice(double theta, const double *at)
{
	double lambda = at[0], c = at[1], s = at[2], x = lambda * s * sin(theta);
	return 2 * sg_pi * cos(theta) * sin(theta) * exp(lambda * (c * cos(theta) - 1) + x) * sg_bessel(x);
}

/* A_h(lambda, beta), c = cos beta. Beyond twelve widths of the Gaussian there is nothing. */
static inline double sg_truth(double lambda, double c)
{
	double s = sqrt(fmax(0, 1 - c * c)), beta = atan2(s, c), width = 12 / sqrt(fmax(lambda, 1));
	double at[] = {lambda, c, s}, horizon = sg_pi / 2;
	return sg_integrate(sg_slice, at, fmax(0, fmin(beta, horizon) - width), fmin(horizon, beta + width), 48);
}

/* Over the sphere, and with the cosine over the hemisphere about phi and about -phi, by theta. */
static inline double sg_ring(double theta, const double *at)
{
	return 2 * sg_pi * sin(theta) * exp(at[0] * (cos(theta) - 1));
}
static inline double sg_ring_up(double theta, const double *at) { return fabs(cos(theta)) * sg_ring(theta, at); }
static inline double sg_sphere(double lambda)
{
	return sg_integrate(sg_ring, &lambda, 0, fmin(sg_pi, 12 / sqrt(fmax(lambda, 1e-3))), 48);
}
static inline double sg_up(double lambda)
{
	return sg_integrate(sg_ring_up, &lambda, 0, fmin(sg_pi / 2, 12 / sqrt(fmax(lambda, 1e-3))), 48);
}
static inline double sg_down(double lambda)
{
	return sg_integrate(sg_ring_up, &lambda, sg_pi / 2, sg_pi, (int)fmin(48 + lambda, 1000));
}

/* Eqs 15 to 18: the share of sg_up; the rest is of sg_down. */
static inline double sg_share(double lambda, double c)
{
	double t = 2.1007 * sqrt(lambda) * (lambda / (lambda + 4.4653)),
		   s = 1 / (0.2958 * t + 0.5033) / (exp(fabs(c) * t) + 1);
	return s * (0.5 * c + 0.5) + (1 - s) * fmax(0, c);
}
static inline double sg_closed(double lambda, double c)
{
	double share = sg_share(lambda, c);
	return share * sg_up(lambda) + (1 - share) * sg_down(lambda);
}

/* Eq 8. */
static inline double sg_as_sg(double lambda, double c)
{
	double both = sqrt((lambda - 2) * (lambda - 2) + 4 * lambda * (1 + c));
	return exp(-4 * lambda * (1 - c) / (lambda + 2 + both)) * sg_sphere(both);
}

#endif

/* Solid angles and form factors of triangles in double precision, the corners seen from the origin. */
#ifndef TS_TESTS_KERNELS_HULLS_FORM_FACTOR_TRUTH_H
#define TS_TESTS_KERNELS_HULLS_FORM_FACTOR_TRUTH_H
#include "tests/kernels/seeded.h"

static const double ff_pi = 3.14159265358979323846;

static inline double ff_angle(double3 a, double3 b) { return atan2(d3_length(d3_cross(a, b)), d3_dot(a, b)); }

/* L'Huilier's theorem, from the three sides. */
static inline double ff_solid(double3 a, double3 b, double3 c)
{
	double x = ff_angle(a, b) / 2, y = ff_angle(b, c) / 2, z = ff_angle(c, a) / 2, s = (x + y + z) / 2;
	return 4 * atan(sqrt(fmax(0, tan(s) * tan(s - x) * tan(s - y) * tan(s - z))));
}

/* The polygon above the horizon of n, by Sutherland and Hodgman, then Lambert's sum over its edges. */
static inline double ff_factor(double3 n, const double3 corner[3])
{
	double3 above[6];
	int count = 0;
	double sum = 0;
	for (int i = 0; i < 3; i++) {
		double3 p = corner[i], q = corner[(i + 1) % 3];
		double dp = d3_dot(n, p), dq = d3_dot(n, q);
		if (dp >= 0) above[count++] = p;
		if ((dp >= 0) != (dq >= 0)) above[count++] = d3_mad(p, d3_sub(q, p), dp / (dp - dq));
	}
	for (int i = 0; i < count; i++) {
		double3 p = above[i], q = above[(i + 1) % count], across = d3_cross(p, q);
		double length = d3_length(across);
		if (length > 0) sum += d3_dot(across, n) / length * ff_angle(p, q);
	}
	return fabs(sum) / (2 * ff_pi);
}

#endif

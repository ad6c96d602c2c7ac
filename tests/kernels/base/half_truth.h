/* Rounding to binary16 in double, by the rounding of the library. */
#ifndef TS_TESTS_KERNELS_BASE_HALF_TRUTH_H
#define TS_TESTS_KERNELS_BASE_HALF_TRUTH_H
#include <math.h>

static inline double half_of(double x)
{
	if (x == 0 || isinf(x)) return x;
	int e = ilogb(x) < -14 ? -14 : ilogb(x);
	double r = ldexp(nearbyint(ldexp(x, 10 - e)), e - 10);
	return fabs(r) >= 65536 ? copysign(INFINITY, x) : r;
}

#endif

/* cmocka, seeded random input, and vectors in double precision for independent truths. */
#ifndef TS_TESTS_KERNELS_SEEDED_H
#define TS_TESTS_KERNELS_SEEDED_H
#include <math.h>
#include "kernels/base/vec.h"
#include "tests/model/test.h"

enum { SEED = 17, STREAM = 6 };

static u32 n_random;

static inline int restart(void **state)
{
	(void)state;
	n_random = 0;
	return 0;
}

/* A test that draws the same numbers whichever test ran before it. */
#define seeded_test(f) cmocka_unit_test_setup(f, restart)

static inline u32 bits(void) { return ts_random(n_random++, STREAM, SEED); }
static inline u32 below(u32 n) { return (u32)(((u64)bits() * n) >> 32); }
static inline f32 uniform(f32 low, f32 high) { return low + (high - low) * ts_uniform(bits()); }

static inline ts_v3 uniform3(f32 low, f32 high)
{
	f32 x = uniform(low, high), y = uniform(low, high);
	return ts_v3_make(x, y, uniform(low, high));
}

/* A unit vector, every direction alike. */
static inline ts_v3 direction(void)
{
	for (;;) {
		ts_v3 d = uniform3(-1, 1);
		f32 l = ts_length(d);
		if (l > 0.1f && l <= 1) return ts_normalize(d);
	}
}

/* Positive, sum 1. */
static inline ts_v3 random_weights(void)
{
	f32 x = uniform(0.001f, 1), y = uniform(0.001f, 1), z = uniform(0.001f, 1);
	f32 sum = x + y + z;
	return ts_v3_make(x / sum, y / sum, z / sum);
}

static inline bool same_bits(f32 a, f32 b) { return ts_f2u(a) == ts_f2u(b); }
static inline bool same_bits3(ts_v3 a, ts_v3 b)
{
	return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

typedef struct {
	double x, y, z;
} double3;

static inline double3 d3_of(ts_v3 a) { return (double3){a.x, a.y, a.z}; }
static inline double3 d3_add(double3 a, double3 b) { return (double3){a.x + b.x, a.y + b.y, a.z + b.z}; }
static inline double3 d3_sub(double3 a, double3 b) { return (double3){a.x - b.x, a.y - b.y, a.z - b.z}; }
static inline double3 d3_scale(double3 a, double s) { return (double3){a.x * s, a.y * s, a.z * s}; }
static inline double3 d3_mad(double3 a, double3 b, double s) { return d3_add(a, d3_scale(b, s)); }
static inline double d3_dot(double3 a, double3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline double d3_length(double3 a) { return sqrt(d3_dot(a, a)); }
static inline double3 d3_unit(double3 a) { return d3_scale(a, 1 / d3_length(a)); }
static inline double3 d3_cross(double3 a, double3 b)
{
	return (double3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
static inline double3 d3_blend(ts_v3 w, double3 a, double3 b, double3 c)
{
	return d3_add(d3_add(d3_scale(a, w.x), d3_scale(b, w.y)), d3_scale(c, w.z));
}
static inline double d3_distance(double3 a, double3 b) { return d3_length(d3_sub(a, b)); }

#define assert_near(a, b, tolerance) assert_true(fabs((double)(a) - (double)(b)) <= (tolerance))

#endif

/* Vectors in double precision, for truths. */
#ifndef TS_METHODS_HULLS_TOOLS_DOUBLE_H
#define TS_METHODS_HULLS_TOOLS_DOUBLE_H
#include <math.h>
#include "kernels/base/vec.h"

#define TS_PI 3.14159265358979323846

typedef struct {
	double x, y, z;
} ts_double3;

static inline ts_double3 ts_double3_of(ts_v3 a) { return (ts_double3){(double)a.x, (double)a.y, (double)a.z}; }
static inline ts_double3 ts_double3_from_to(ts_v3 p, ts_v3 q)
{
	return (ts_double3){(double)q.x - (double)p.x, (double)q.y - (double)p.y, (double)q.z - (double)p.z};
}
static inline double ts_double3_dot(ts_double3 a, ts_double3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static inline ts_double3 ts_double3_cross(ts_double3 a, ts_double3 b)
{
	return (ts_double3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/* a + s b */
static inline ts_double3 ts_double3_mad(ts_double3 a, ts_double3 b, double s)
{
	return (ts_double3){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}
static inline ts_double3 ts_double3_mix(ts_double3 a, ts_double3 b, double t)
{
	return (ts_double3){a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}
/* 0 stays 0. */
static inline ts_double3 ts_double3_unit(ts_double3 a)
{
	double length = sqrt(ts_double3_dot(a, a)), by = length > 0 ? 1 / length : 0;
	return (ts_double3){a.x * by, a.y * by, a.z * by};
}
static inline ts_v3 ts_double3_round(ts_double3 a) { return ts_v3_make((f32)a.x, (f32)a.y, (f32)a.z); }

#endif

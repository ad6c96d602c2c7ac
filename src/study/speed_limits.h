/* What a machine can do at most: what stages are measured by. */
#ifndef TS_STUDY_SPEED_LIMITS_H
#define TS_STUDY_SPEED_LIMITS_H
#include "../methods/stages.h"

/* 64-bit minima a second and thread, at random texels of a buffer of so many bytes that each thread has for itself:
 * independent, without branches, prefetched. */
ts_status ts_limit_minima(double *a_second, u64 bytes, u32 threads);
/* Bytes a second, of all threads together, that loops read and write of arrays too large for caches: a word written for
 * one read. */
ts_status ts_limit_stream(double *a_second, u32 threads);

/* Points that lie evenly on a surface, and the cubes that show them: a point renderer with neither visibility, nor
 * holes filled, nor splats larger than a texel. */
typedef struct {
	u64 n; /* points; whole blocks, padded by points that are nowhere */
	f32 *x, *y, *z;
	u32 *triangle;
	ts_face *cubes;
	u32 n_cubes;
	u64 *texels; /* of all cubes: depth << 32 | triangle */
} ts_limit_points;

/* Places n points on the run's triangles, and takes its cubes. Released by ts_limit_points_free, also on failure; zero
 * before. */
ts_status ts_limit_points_place(ts_limit_points *points, const ts_run *run, u64 n);
/* Renders them into all cubes. */
void ts_limit_points_draw(const ts_limit_points *points, u32 threads);
void ts_limit_points_free(ts_limit_points *points);

#endif

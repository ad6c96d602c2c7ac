/* Limits of a machine, with which stages are compared. */
#ifndef TS_STUDY_SPEED_LIMITS_H
#define TS_STUDY_SPEED_LIMITS_H
#include "methods/stages.h"

/* 64-bit minima a second of one thread, at random texels of a buffer of so many bytes, one for each thread:
 * independent, without branches, prefetched. */
ts_status ts_limit_minima(double *a_second, u64 bytes, u32 threads);
/* Bytes a second that loops of all threads together read and write of arrays too large for caches, with one word
 * written for each word read. */
ts_status ts_limit_stream(double *a_second, u32 threads);

/* Points that lie evenly on a surface, and the cubes that show them: a point renderer with neither visibility, nor
 * holes filled, nor splats larger than a texel. */
typedef struct {
	u64 n; /* points; in whole blocks, padded with points that draw nothing */
	f32 *x, *y, *z;
	u32 *triangle;
	ts_face *cubes;
	u32 n_cubes;
	u64 *texels; /* of all cubes: depth << 32 | triangle */
} ts_limit_points;

/* Places n points on the run's triangles, and copies the views of its cubes. Released by ts_limit_points_free, also on
 * failure; zero before. */
ts_status ts_limit_points_place(ts_limit_points *points, const ts_run *run, u64 n);
/* Renders the points into all cubes. */
void ts_limit_points_draw(const ts_limit_points *points, u32 threads);
void ts_limit_points_free(ts_limit_points *points);

#endif

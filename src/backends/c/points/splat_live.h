/* The input of splatting: rows of points, each of one piece, as arrays. If points are made as they are splatted, a row
 * is a whole piece. */
#ifndef TS_BACKENDS_C_POINTS_SPLAT_LIVE_H
#define TS_BACKENDS_C_POINTS_SPLAT_LIVE_H
#include "kernels/raster/cover.h"
#include "kernels/raster/cube.h"

typedef struct ts_splat_args ts_splat_args;

enum { TS_SPLAT_POINTS = 128, TS_SPLAT_LANES = 8, TS_SPLAT_CORNERS = 9, TS_SPLAT_SIDES = 6 };

typedef struct {
	f32 least, most;
} ts_range;

/* Bounds of points, in the world. */
typedef struct {
	ts_range of[3];
} ts_splat_bounds;

/* World coordinates of the corners a, b, c of the piece, of half a square's sides du, dv, and of stored points: at most
 * TS_SPLAT_POINTS per row; arrays may be read up to a multiple of lanes. */
typedef struct {
	u64 n;
	u32 *piece, *triangle, *tiny;
	u32 *index; /* of the first point of each row; [n]: number of all points */
	f32 *length, *slack, *corner[TS_SPLAT_CORNERS], *side[TS_SPLAT_SIDES];
	f32 *centre[3];          /* NULL: points are made */
	ts_splat_bounds *bounds; /* of rows */
} ts_splat_live;

static inline u32 ts_splat_live_points(const ts_splat_live *live, u64 begin, u64 end)
{
	return live->index[end] - live->index[begin];
}

/* False: no memory, or the work is cancelled. Clear *live in either case. */
bool ts_splat_live_make(ts_splat_live *live, const ts_splat_args *args, u32 threads);
void ts_splat_live_clear(ts_splat_live *live);

ts_splat_bounds ts_splat_bounds_of(const f32 *const centre[3], u32 n);
void ts_splat_bounds_add(ts_splat_bounds *to, const ts_splat_bounds *more);

#endif

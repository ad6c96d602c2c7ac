/* Triangles of one view in vector lanes, drawn into texels that their thread owns. Most triangles cover few pixels:
 * vector loops project and snap them, and compute the depths of all pixels that they cover. Triangles that are clipped
 * or large are drawn alone. */
#ifndef TS_BACKENDS_C_RASTER_DRAW_BATCH_H
#define TS_BACKENDS_C_RASTER_DRAW_BATCH_H
#include "kernels/raster/draw.h"

enum { TS_DRAW_TRIANGLES = 64, TS_DRAW_LANES = 16 };

/* Corners of triangles: x, y, z of a, then of b, then of c. */
typedef struct {
	f32 at[9][TS_DRAW_TRIANGLES];
} ts_draw_corners;

/* Corner k of triangle i. */
static inline ts_v3 ts_draw_corner(const ts_draw_corners *from, u32 k, u32 i)
{
	return ts_v3_make(from->at[3 * k][i], from->at[3 * k + 1][i], from->at[3 * k + 2][i]);
}

static inline void ts_draw_set_corner(ts_draw_corners *to, u32 k, u32 i, f32 x, f32 y, f32 z)
{
	to->at[3 * k][i] = x;
	to->at[3 * k + 1][i] = y;
	to->at[3 * k + 2][i] = z;
}

typedef struct {
	const ts_arrays *scene;
	ts_camera_k view;
	ts_target target; /* the view's first texel */
	ts_box owned;     /* pixels that may be written */
	u32 n, triangle[TS_DRAW_TRIANGLES], masked[TS_DRAW_TRIANGLES];
	ts_draw_corners corners; /* on the view's axes: right, up, ahead */
} ts_draw_batch;

/* Consecutive triangles of the scene, from `first` on. */
typedef struct {
	u32 first, n;
	u32 object[TS_DRAW_TRIANGLES];
	u32 two_sided[TS_DRAW_TRIANGLES], masked[TS_DRAW_TRIANGLES]; /* 0 or 1 */
	ts_draw_corners corners;                                     /* world */
} ts_draw_block;

void ts_draw_block_read(ts_draw_block *block, const ts_arrays *scene, u32 first, u32 n);

/* Adds triangle k of `block`, which is facing, not degenerate and not ts_k_is_outside: `row` are the view's right, up
 * and ahead in the axes of `corners`. Draws the batch when it is full. */
void ts_draw_add(ts_draw_batch *batch, const ts_draw_block *block, u32 k, const ts_draw_corners *corners,
                 const ts_row row[3]);
/* Draws the triangles of the batch, and empties it. */
void ts_draw_flush(ts_draw_batch *batch);

/* Draws one triangle of the scene; clips: a plane of ts_k_clip_to_range may clip it. */
void ts_draw_alone(const ts_draw_batch *batch, u32 triangle, bool masked, bool clips);

/* 1 if x is a number above 0 after ts_flush; ts_draw_is_below: below 0. */
static inline u32 ts_draw_is_above(f32 x)
{
	return ts_f2u(x) - TS_FLUSH_BITS <= TS_INFINITE_BITS - TS_FLUSH_BITS ? 1u : 0u;
}
static inline u32 ts_draw_is_below(f32 x) { return ts_draw_is_above(-x); }

static inline bool ts_draw_is_nearer(const ts_target *target, u64 at, u32 depth, u32 triangle)
{
	if (target->keys != NULL) return ((u64)depth << 32 | triangle) < target->keys[at];
	return depth < target->depths[at];
}

/* Lowers the texel to the depth, or the key, if that is less. */
static inline void ts_draw_texel(const ts_target *target, u64 at, u32 depth, u32 triangle)
{
	if (target->keys != NULL) {
		u64 key = (u64)depth << 32 | triangle, old = target->keys[at];
		target->keys[at] = key < old ? key : old;
	} else {
		u32 old = target->depths[at];
		target->depths[at] = depth < old ? depth : old;
	}
}

#endif

/* Splats of many pieces and points in vector lanes, into a cube face that their thread owns. The axes of a cube's face
 * are those of the world except for sign and order, so projections need no products; edges are lines in (i, j). */
#ifndef TS_BACKENDS_C_POINTS_SPLAT_BATCH_H
#define TS_BACKENDS_C_POINTS_SPLAT_BATCH_H
#include "backends/c/points/splat_live.h"

enum { TS_SPLAT_PIECES = 64 };

/* Values that the splats of a piece share. Lanes of floats: half a square's sides du, dv. Lanes of integers: the box
 * that may be written; then x, y, c of three edges, inside where x i + y j + c >= 0, counted from the box's first
 * texel. */
enum { TS_SPLAT_BOX = 0, TS_SPLAT_EDGES = 4, TS_SPLAT_WHOLES = 13 };

typedef struct {
	const ts_splat_args *args;
	ts_camera_k view;
	ts_row row[3]; /* right, up, ahead */
	f32 eye[3];    /* world */
	f32 inset;     /* of boxes, in texels, at most */
	u32 cube, side;
	u64 *texels;
	u8 *tie; /* not NULL: the texels are complete, and ties are marked */
	i64 scatters, writes;
} ts_splat_face;

typedef enum { TS_SPLAT_UNSEEN, TS_SPLAT_TOGETHER, TS_SPLAT_ALONE } ts_splat_way;

/* Live pieces that a face may see. Pieces that a plane clips, or that are too large, are drawn alone. */
typedef struct {
	u32 n, live[TS_SPLAT_PIECES], way[TS_SPLAT_PIECES];
	u32 begin[TS_SPLAT_PIECES], left[TS_SPLAT_PIECES]; /* points in the sieve; TS_NONE: all points of the row */
	i32 whole[TS_SPLAT_WHOLES][TS_SPLAT_PIECES];
} ts_splat_batch;

/* Points of pieces that are drawn together. Arrays have room for lanes beyond the last point. */
enum { TS_SPLAT_ROOM = TS_SPLAT_POINTS + TS_SPLAT_LANES };
typedef struct {
	u32 n, live[TS_SPLAT_ROOM], word[TS_SPLAT_ROOM];
	f32 centre[3][TS_SPLAT_ROOM]; /* world */
	f32 side[TS_SPLAT_SIDES][TS_SPLAT_ROOM], slack[TS_SPLAT_ROOM];
	i32 whole[TS_SPLAT_WHOLES][TS_SPLAT_ROOM];
} ts_splat_block;

/* n points of one piece, from `index` on, or those that `which` names. Arrays of coordinates may be read up to a
 * multiple of lanes. */
typedef struct {
	const f32 *centre[3];
	u32 index, n;
	const u32 *which; /* NULL: consecutive ones */
} ts_splat_row;

ts_splat_face ts_splat_face_begin(const ts_splat_args *args, u32 cube, u32 side);
/* Decides how each piece of the batch is drawn. */
void ts_splat_batch_place(ts_splat_batch *batch, const ts_splat_face *f, const ts_splat_live *live);

/* Texels that piece k of the batch may write. */
ts_box ts_splat_batch_box_of(const ts_splat_batch *batch, u32 k);
/* Lets piece k of the batch write the box, within the lines. False: there are more or larger lines than edges have room
 * for, and the lines must be tested. */
bool ts_splat_batch_box(ts_splat_batch *batch, u32 k, ts_box box, const ts_lines *lines);

/* Adds points of piece k of the batch; writes the block whenever it is full. */
void ts_splat_block_add(ts_splat_block *block, ts_splat_face *f, const ts_splat_live *live, const ts_splat_batch *batch,
                        u32 k, ts_splat_row row);
/* Writes the points of the block, and empties it. */
void ts_splat_block_write(ts_splat_block *block, ts_splat_face *f, const ts_splat_live *live);
/* Reserves the block for one piece, until it is written or points are added. */
void ts_splat_block_own(ts_splat_block *block, const ts_splat_face *f, const ts_splat_live *live,
                        const ts_splat_batch *batch, u32 k);
/* Writes a row of points of the block's own piece, within `lines`, unless that is NULL. */
void ts_splat_block_row(ts_splat_block *block, ts_splat_face *f, const ts_splat_live *live, ts_splat_row row,
                        const ts_lines *lines);

#endif

/* Splats of many pieces and points side by side, into a cube face that their thread owns. The axes of a cube's face are
 * the world's but for sign and order, so nothing that is projected needs products; edges are lines in (i, j). */
#ifndef TS_BACKENDS_SPLAT_BATCH_H
#define TS_BACKENDS_SPLAT_BATCH_H
#include "../../../kernels/points/splat_pieces.h"

enum { TS_SPLAT_PIECES = 64, TS_SPLAT_POINTS = 128, TS_SPLAT_LANES = 8 };

typedef struct {
	const ts_splat_args *args;
	ts_camera_k view;
	ts_row row[3]; /* right, up, ahead */
	f32 eye[3];    /* world */
	u32 cube, side;
	u64 *texels;
	i64 scatters, writes;
} ts_splat_face;

/* What the splats of a piece have in common. Lanes of floats: half a square's sides on the face's axes, du then dv.
 * Lanes of integers: the box that may be written; then x, y, c of three edges, inside where x i + y j + c >= 0, from
 * that box's first texel. */
enum { TS_SPLAT_SIDES = 6, TS_SPLAT_BOX = 0, TS_SPLAT_EDGES = 4, TS_SPLAT_WHOLES = 13 };

typedef enum { TS_SPLAT_UNSEEN, TS_SPLAT_TOGETHER, TS_SPLAT_ALONE } ts_splat_way;

/* Pieces that a face may see. Those that a plane clips, or that are too large, go alone. */
typedef struct {
	u32 n, piece[TS_SPLAT_PIECES], way[TS_SPLAT_PIECES], tiny[TS_SPLAT_PIECES];
	f32 length[TS_SPLAT_PIECES];
	f32 corner[9][TS_SPLAT_PIECES]; /* of a, b, c: on the face's axes */
	f32 side[TS_SPLAT_SIDES][TS_SPLAT_PIECES];
	i32 whole[TS_SPLAT_WHOLES][TS_SPLAT_PIECES];
} ts_splat_batch;

/* Points of such pieces that go together. Arrays have room for lanes beyond the last point. */
enum { TS_SPLAT_ROOM = TS_SPLAT_POINTS + TS_SPLAT_LANES };
typedef struct {
	u32 n, piece[TS_SPLAT_ROOM], index[TS_SPLAT_ROOM];
	f32 length[TS_SPLAT_ROOM];
	f32 centre[3][TS_SPLAT_ROOM]; /* world */
	f32 side[TS_SPLAT_SIDES][TS_SPLAT_ROOM];
	i32 whole[TS_SPLAT_WHOLES][TS_SPLAT_ROOM];
} ts_splat_block;

ts_splat_face ts_splat_face_begin(const ts_splat_args *args, u32 cube, u32 side);
/* Adds a piece; there must be room. */
void ts_splat_batch_add(ts_splat_batch *batch, const ts_splat_face *f, u32 piece, f32 length, u32 flags);
/* Finds how each piece of the batch goes. */
void ts_splat_batch_place(ts_splat_batch *batch, const ts_splat_face *f);

/* n points of piece k of the batch, of which `index` is the first one's. The arrays may be read up to a multiple of
 * lanes. What is full is written. */
void ts_splat_block_add(ts_splat_block *block, ts_splat_face *f, const ts_splat_batch *batch, u32 k,
                        const f32 *const centre[3], u32 index, u32 n);
/* Writes what the block has, and empties it. */
void ts_splat_block_write(ts_splat_block *block, ts_splat_face *f);

#endif

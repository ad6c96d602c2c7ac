/* The texels that samples of reflective pixels read, and whether a box of texels has one. */
#ifndef TS_BACKENDS_C_POINTS_ASKED_TEXELS_H
#define TS_BACKENDS_C_POINTS_ASKED_TEXELS_H
#include "kernels/points/splat.h"

enum { TS_ASKED_LEVELS = 32 };

typedef struct {
	u64 n;
	u8 *texel;  /* of all cubes, n texels; 1: a sample reads it */
	u8 *blocks; /* of all faces, level after level */
	u64 *first; /* of each cube: its first block */
} ts_asked;

/* Blocks of a face, 2^level texels wide; 1: the block, or its neighbour to the right or below, has a texel that a
 * sample reads. */
typedef struct {
	const u8 *level[TS_ASKED_LEVELS]; /* from 1 on */
	u32 n;                            /* texels per side; 0: all texels count */
} ts_asked_face;

/* Finds the texels that args->pixels read. False: no memory. Clear *asked in either case. */
bool ts_asked_make(ts_asked *asked, const ts_splat_args *args, u32 threads);
void ts_asked_clear(ts_asked *asked);

/* The blocks of a face. If *asked is empty, all texels count. */
ts_asked_face ts_asked_face_of(const ts_asked *asked, const ts_face *cubes, u32 cube, u32 side);

/* Closes the empty texels that no sample reads, so that no key wins them; and empties them again. */
void ts_asked_close(const ts_asked *asked, u64 *texels, u32 threads);
void ts_asked_open(const ts_asked *asked, u64 *texels, u32 threads);

static inline u32 ts_asked_blocks(u32 n, u32 level) { return ((n - 1) >> level) + 1; }

/* Whether a sample may read a texel of the box, which is within the face and not empty. A box touches at most two
 * blocks per side. */
static inline bool ts_asked_any(const ts_asked_face *f, ts_box box)
{
	if (f->n == 0) return true;
	u32 across = (u32)(box.x1 - box.x0), down = (u32)(box.y1 - box.y0);
	u32 level = 32 - (u32)__builtin_clz(across | down | 1);
	return f->level[level][((u32)box.y0 >> level) * ts_asked_blocks(f->n, level) + ((u32)box.x0 >> level)] != 0;
}

#endif

/* Which samples touch narrow pieces, side by side, with the bits of ts_k_touches. */
#ifndef TS_BACKENDS_NARROW_PIECES_H
#define TS_BACKENDS_NARROW_PIECES_H
#include "../../../kernels/points/points.h"

/* A narrow piece touches the samples of a box of that many a side at most. */
enum { TS_NARROW = 8, TS_NARROW_PIECES = 64 };

/* By piece; `rows` has bit x - x0 of each sample of row y0 + y that touches, and is told up to the last row of any
 * narrow piece. */
typedef struct {
	u32 narrow[TS_NARROW_PIECES]; /* 0: nothing else is told */
	i32 x0[TS_NARROW_PIECES], y0[TS_NARROW_PIECES];
	u32 n_rows, rows[TS_NARROW][TS_NARROW_PIECES];
	u32 n[TS_NARROW_PIECES]; /* samples that touch */
} ts_narrow_pieces;

/* Of n pieces, at most TS_NARROW_PIECES, with these frames. */
void ts_narrow_find(ts_narrow_pieces *to, const ts_align *frames, u32 n, i32 half_size);

#endif

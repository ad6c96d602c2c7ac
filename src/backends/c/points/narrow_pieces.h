/* The samples that touch narrow pieces, in vector lanes, with the bits of ts_k_touches. */
#ifndef TS_BACKENDS_C_POINTS_NARROW_PIECES_H
#define TS_BACKENDS_C_POINTS_NARROW_PIECES_H
#include "kernels/raster/lattice.h"

/* A narrow piece touches samples of a box of at most TS_NARROW per side. */
enum { TS_NARROW = 8, TS_NARROW_PIECES = 64 };

/* Results by piece. Bit x - x0 of `rows` is set if the sample of row y0 + y touches; rows are valid up to the last row
 * of any narrow piece. */
typedef struct {
	u32 narrow[TS_NARROW_PIECES]; /* 0: the other members are not set */
	i32 x0[TS_NARROW_PIECES], y0[TS_NARROW_PIECES];
	u32 n_rows, rows[TS_NARROW][TS_NARROW_PIECES];
	u32 n[TS_NARROW_PIECES]; /* samples that touch */
} ts_narrow_pieces;

/* Finds the samples of n pieces with these frames, at most TS_NARROW_PIECES. */
void ts_narrow_find(ts_narrow_pieces *to, const ts_align *frames, u32 n, i32 half_size);

#endif

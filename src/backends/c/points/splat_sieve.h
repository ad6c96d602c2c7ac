/* Leaves out points whose splats cannot change a texel: they lie beside the face or between the centres of texels, or
 * every texel that they touch holds a nearer point. */
#ifndef TS_BACKENDS_C_POINTS_SPLAT_SIEVE_H
#define TS_BACKENDS_C_POINTS_SPLAT_SIEVE_H
#include "backends/c/points/splat_extent.h"

/* Points that are left, of several rows. The arrays have room for those of another row and for lanes more. */
enum { TS_SIEVE_POINTS = 1024, TS_SIEVE_ROOM = TS_SIEVE_POINTS + TS_SPLAT_ROOM };
typedef struct {
	u32 n, index[TS_SIEVE_ROOM];
	f32 centre[3][TS_SIEVE_ROOM];
} ts_splat_sieve;

/* Adds what is left of a live row, and returns how many points; before, there must be at most TS_SIEVE_POINTS. Texels
 * must have one distance per splat (splat.plane_depth=off). */
u32 ts_splat_sieve_add(ts_splat_sieve *sieve, const ts_splat_face *f, const ts_splat_live *live, u32 row,
                       const ts_splat_reach *reach);

#endif

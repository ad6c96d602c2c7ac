/* A room of light: what stands in it sees light on all sides. */
#ifndef TS_TESTS_KERNELS_HULLS_ROOM_H
#define TS_TESTS_KERNELS_HULLS_ROOM_H
#include "kernels/base/records.h"
#include "kernels/base/vec.h"

/* Two triangles of a square, counter-clockwise. */
static const f32 room_corners[2][3][2] = {{{0, 0}, {1, 0}, {1, 1}}, {{1, 1}, {0, 1}, {0, 0}}};

/* The cube from -1 to 1, with walls of parts x parts squares: 12 * parts * parts triangles, which face inwards. */
static inline void room_make(ts_patch *out, u32 parts, ts_v3 exitance)
{
	u32 squares = parts * parts;
	f32 step = 2 / (f32)parts;
	for (u32 i = 0; i < 12 * squares; i++) {
		u32 square = i / 2 % squares, wall = i / 2 / squares, axis = wall % 3;
		f32 side = wall < 3 ? -1 : 1, corner[3][3] = {{0}};
		for (u32 k = 0; k < 3; k++) {
			const f32 *at = room_corners[i % 2][k];
			corner[k][axis] = side;
			corner[k][(axis + 1) % 3] = -side * (step * ((f32)(square % parts) + at[0]) - 1);
			corner[k][(axis + 2) % 3] = step * ((f32)(square / parts) + at[1]) - 1;
		}
		out[i] = (ts_patch){.pad = 0};
		for (u32 k = 0; k < 3; k++) {
			out[i].a[k] = corner[0][k];
			out[i].b[k] = corner[1][k];
			out[i].c[k] = corner[2][k];
		}
		out[i].normal[axis] = -side;
		ts_store3(out[i].exitance, exitance);
	}
}

#endif

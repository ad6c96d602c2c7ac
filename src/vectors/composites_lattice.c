/* Composites of the lattice of samples (kernels/vectors/composites_lattice.h). */
#include "kernels/vectors/composites_lattice.h"
#include "vectors/relate.h"

enum { SCALE = 12 };

/* Unseen and degenerate pieces have no samples. */
static void relate_align(u32 *in, u32 random)
{
	ts_relate_piece(in, &random);
	if (ts_once_in(&random, 16)) in[SCALE] = 0;
}

enum { X = 6, Y = 7 };

/* Samples in the triangle, around it, at a corner; and triangles without area. */
static void relate_weights(u32 *in, u32 random)
{
	u32 k = (ts_more(&random) >> 8) % 16;
	in[X] = (u32)(ts_floor_i32(ts_row_f32(in, 2 * (k % 3))) + (i32)(random >> 20 & 3) - 1);
	in[Y] = (u32)(ts_floor_i32(ts_row_f32(in, 2 * (k % 3) + 1)) + (i32)(random >> 24 & 3) - 1);
	if (k == 3) memcpy(in + 2, in, 2 * sizeof *in);
	if (k == 4) memcpy(in + 4, in, 2 * sizeof *in), memcpy(in + 2, in, 2 * sizeof *in);
	if (k == 5) {
		ts_relate_f32(in, (f32)ts_row_i32(in, X) + 0.5f);
		ts_relate_f32(in + 1, (f32)ts_row_i32(in, Y) + 0.5f);
	}
}

enum { FRAME = 12, CENTRE_X = 33 };

/* The piece's own lattice, and a sample that it touches or nearly touches. */
static void relate_centre(u32 *in, u32 random)
{
	ts_piece piece;
	ts_align frame;
	ts_relate_piece(in, &random);
	memcpy(&piece, in, sizeof piece);
	f32 s = ts_row_f32(in, FRAME + 3);
	ts_k_lattice_align(&piece, s > 0 ? s : 1, &frame);
	memcpy(in + FRAME, &frame, sizeof frame);
	f32 shares[3] = {ts_uniform(ts_more(&random)), ts_uniform(ts_more(&random)), ts_uniform(ts_more(&random))};
	ts_v3 w = ts_k_hit_weights(shares[0], shares[1], shares[2]);
	for (u32 k = 0; k < 2; k++) {
		f32 q = ts_blend1(w, (f32)frame.q[k], (f32)frame.q[k + 2], (f32)frame.q[k + 4]);
		in[CENTRE_X + k] = (u32)(ts_floor_i32(q * 0.00390625f) + (i32)(ts_more(&random) >> 16) % 3 - 1);
	}
}

/* clang-format off */
#define SNAPPED_MAX ((1 << 23) - 1)
#define LATTICE(name) { name, TS_VECTOR_F32, 2, 119, 133, true }

const ts_vector ts_composites_lattice[] = {
	{ PRIMITIVE(align), "ts_k_lattice_align", "align.frame of a piece at s samples per world unit (T_epr)",
	  { PIECE("piece"), POSITIVE("s", 1, 119, 135) },
	  { COLUMN("c", F32, 3), COLUMN("s", F32, 1), COLUMN("u", F32, 3), COLUMN("pad0", U32, 1), COLUMN("v", F32, 3),
	    COLUMN("pad1", U32, 1), COLUMN("q", I32, 6), COLUMN("pad2", U32, 2) }, .relate = relate_align },
	{ PRIMITIVE(lattice_weights), "ts_k_weights_around",
	  "weights of sample (x, y) on a triangle a b c in lattice coordinates",
	  { LATTICE("a"), LATTICE("b"), LATTICE("c"), INTEGER("x", 1, -32768, 32767), INTEGER("y", 1, -32768, 32767) },
	  GIVES(F32, 3), .relate = relate_weights },
	{ PRIMITIVE(sample_centre), "ts_k_sample_centre",
	  "position of a sample of a piece: on the lattice or, with snap, the closest point of the piece's border",
	  { PIECE("piece"), WORLD("frame.c", 3), POSITIVE("frame.s", 1, 119, 135), UNIT("frame.u"), ZERO("frame.pad0", 1),
	    UNIT("frame.v"), ZERO("frame.pad1", 1), INTEGER("frame.q", 6, -SNAPPED_MAX, SNAPPED_MAX), ZERO("frame.pad2", 2),
	    FLAG("snap"), INTEGER("x", 1, -32768, 32767), INTEGER("y", 1, -32768, 32767) },
	  GIVES(F32, 3), .relate = relate_centre },
	{ 0 },
};
/* clang-format on */

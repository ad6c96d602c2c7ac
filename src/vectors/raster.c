/* Primitives of rasterization: projection, snapping, edges, coverage, interpolation (CONTRACT rules 15 to 22). */
#include "kernels/vectors/vectors_raster.h"
#include "vectors/row.h"

enum { SNAPPED_MAX = (1 << 23) - 1, PIXEL_MAX = 32767 };

static void project_reciprocal(u32 *out, const u32 *in)
{
	ts_camera_k view = ts_row_view(in);
	f32 r = 1.0f / ts_row_f32(in, 5);
	f32 x = (view.focal * ts_row_f32(in, 3)) * r;
	f32 y = (view.focal * ts_row_f32(in, 4)) * r;
	ts_set_v2(out, ts_v2_make((f32)view.width * 0.5f + x, (f32)view.height * 0.5f - y));
}

/* A point in the image, and not close to the eye. */
static void relate_project(u32 *in, u32 random)
{
	(void)random;
	in[5] &= 0x7fffffffu;
	if (in[5] == 0) in[5] = 0x3f800000u;
}

static i32 snapped_by(f32 x, double (*whole)(double))
{
	double y = isnan(x) ? 0 : whole(256.0 * x);
	return (i32)(y > SNAPPED_MAX ? SNAPPED_MAX : y < -SNAPPED_MAX ? -SNAPPED_MAX : y);
}

static void snap_away(u32 *out, const u32 *in)
{
	out[0] = (u32)snapped_by(A, round);
	out[1] = (u32)snapped_by(B, round);
}

static void snap_truncate(u32 *out, const u32 *in)
{
	out[0] = (u32)snapped_by(A, trunc);
	out[1] = (u32)snapped_by(B, trunc);
}

/* Both coordinates in the image, half-way between two steps of the lattice. */
static void relate_snap(u32 *in, u32 random)
{
	if ((random & 3) != 0) return;
	ts_set_f32(in, 0, ((f32)(i32)(random >> 8 & 0xffff) + 0.5f) * 0.00390625f);
	ts_set_f32(in, 1, ((f32)(i32)(random >> 4 & 0xffff) + 0.5f) * -0.00390625f);
}

static i64 edge_in_float(const u32 *in)
{
	f32 x = (f32)(ts_row_i32(in, 2) - ts_row_i32(in, 0)) * (f32)(ts_row_i32(in, 5) - ts_row_i32(in, 1));
	f32 y = (f32)(ts_row_i32(in, 3) - ts_row_i32(in, 1)) * (f32)(ts_row_i32(in, 4) - ts_row_i32(in, 0));
	return (i64)(x - y);
}

WIDE_ITEM(edge_narrow, (i64)(i32)(u32)(u64)ts_k_vector_edge_of(in))
WIDE_ITEM(edge_float, edge_in_float(in))

static i32 limited(i64 x) { return (i32)(x > SNAPPED_MAX ? SNAPPED_MAX : x < -SNAPPED_MAX ? -SNAPPED_MAX : x); }

/* The point on the edge or one step beside it. */
static void relate_edge(u32 *in, u32 random)
{
	if ((random & 3) == 0) return;
	i64 t = random >> 8 & 8191;
	i64 dx = (i64)ts_row_i32(in, 2) - ts_row_i32(in, 0), dy = (i64)ts_row_i32(in, 3) - ts_row_i32(in, 1);
	in[4] = (u32)limited(ts_row_i32(in, 0) + dx * t / 4096 + (i32)(random >> 2 & 1));
	in[5] = (u32)limited(ts_row_i32(in, 1) + dy * t / 4096 - (i32)(random >> 3 & 1));
}

WIDE_ITEM(quotient_truncate, ts_row_i64(in, 0) / ts_row_i64(in, 2))

/* Multiples of b, and one beside them. */
static void relate_quotient(u32 *in, u32 random)
{
	i64 a = ts_row_i64(in, 0), b = ts_row_i64(in, 2);
	if ((random & 3) < 3) ts_set_u64(in, 0, (u64)(a / 2 / b * b + (i64)(random & 3) - 1));
}

/* One coordinate is equal. */
static void relate_top_left(u32 *in, u32 random)
{
	if ((random & 3) == 1) in[2] = in[0];
	if ((random & 3) > 1) in[3] = in[1];
}

static bool covered_inclusively(const u32 *in)
{
	ts_setup t = ts_k_setup(ts_row_snapped(in, 0), ts_row_snapped(in, 2), ts_row_snapped(in, 4));
	ts_edges e = ts_k_edges(&t, ts_row_i32(in, 6), ts_row_i32(in, 7));
	return t.area != 0 && e.e[0] >= 0 && e.e[1] >= 0 && e.e[2] >= 0;
}

WORD_ITEM(covers_inclusive, covered_inclusively(in))

/* Small triangles, and points inside, on an edge, or at a corner. */
static void relate_covers(u32 *in, u32 random)
{
	if ((random & 7) == 0) return;
	bool small = (random & 7) > 2;
	for (u32 k = 0; k < 6 && small; k++) in[k] = (u32)(ts_row_i32(in, k) % 16 * 16);
	i64 s = random >> 8 & 15, t = (random >> 12 & 15) % (17 - s);
	s = (random & 8) != 0 ? 0 : s;
	for (u32 k = 0; k < 2; k++) {
		i64 a = ts_row_i32(in, k), b = ts_row_i32(in, 2 + k), c = ts_row_i32(in, 4 + k);
		in[6 + k] = (u32)limited(a + (b - a) * s / 16 + (c - a) * t / 16);
	}
}

/* A half size of 128 or 129, triangles of a few pixels, and a pixel near the first corner. */
static void relate_touches(u32 *in, u32 random)
{
	for (u32 k = 0; k < 6 && (random & 7) != 0; k++) in[k] = (u32)(ts_row_i32(in, k) % 1024);
	in[6] = 128 + (random >> 3 & 1);
	i32 i = (ts_row_i32(in, 0) >> 8) + (i32)(random >> 8 & 7) - 4;
	i32 j = (ts_row_i32(in, 1) >> 8) + (i32)(random >> 11 & 7) - 4;
	in[7] = (u32)ts_min_i32(ts_max_i32(i, -PIXEL_MAX), PIXEL_MAX);
	in[8] = (u32)ts_min_i32(ts_max_i32(j, -PIXEL_MAX), PIXEL_MAX);
}

/* A row near the first corner. */
static void relate_row(u32 *in, u32 random)
{
	u32 touches[9];
	memcpy(touches, in, sizeof touches - sizeof *touches);
	touches[8] = 0;
	relate_touches(touches, random);
	memcpy(in, touches, 7 * sizeof *in);
	in[7] = touches[8];
}

static void fragment_reciprocal(u32 *out, const u32 *in)
{
	i64 area = ts_row_i64(in, 0) + ts_row_i64(in, 2) + ts_row_i64(in, 4);
	f32 r = 1.0f / (f32)area, over_z[3];
	for (u32 k = 0; k < 3; k++) over_z[k] = ((f32)ts_row_i64(in, 2 * k) * r) * (1.0f / ts_row_f32(in, 6 + k));
	f32 s = over_z[0] + over_z[1];
	s = s + over_z[2];
	f32 z = ts_put(1.0f / s);
	ts_set_f32(out, 3, z);
	for (u32 k = 0; k < 3; k++) ts_set_f32(out, k, over_z[k] * z);
}

static void fragment_parallel_reciprocal(u32 *out, const u32 *in)
{
	f32 r = 1.0f / (f32)(ts_row_i64(in, 0) + ts_row_i64(in, 2) + ts_row_i64(in, 4));
	ts_v3 w = ts_v3_make((f32)ts_row_i64(in, 0) * r, (f32)ts_row_i64(in, 2) * r, (f32)ts_row_i64(in, 4) * r);
	ts_set_v3(out, w);
	ts_set_f32(out, 3, ts_put(ts_blend1(w, ts_row_f32(in, 6), ts_row_f32(in, 7), ts_row_f32(in, 8))));
}

static void cut_fused(u32 *out, const u32 *in)
{
	f32 t = B / (B - ts_row_f32(in, 3));
	ts_set_f32(out, 0, fmaf(C - A, t, A));
}

/* The other end is outside. */
static void relate_cut(u32 *in, u32 random)
{
	(void)random;
	in[3] = in[3] == 0 ? 0xbf800000u : in[3] | 0x80000000u;
}

static const f32 snap_edges[] = {32767.998046875f, 32767.99609375f, -32767.998046875f, 0.001953125f, 0.005859375f};

#define SNAPPED(name) INTEGER(name, 2, -SNAPPED_MAX, SNAPPED_MAX)
#define SIZE(name) UNSIGNED(name, 2, 1, 16384)

/* clang-format off */
const ts_vector ts_vectors_raster[] = {
	{ PRIMITIVE(cut), "16",
	  "x of the corner where an edge is clipped, from inside to outside, d = distances to the plane",
	  { WORLD("x_in", 1), POSITIVE("d_in", 1, 88, 150), WORLD("x_out", 1), WORLD("d_out", 1) }, GIVES(F32, 1),
	  { { TS_FAULT_FMA, cut_fused } }, .relate = relate_cut },
	{ PRIMITIVE(project), "ts_k_project", "view space to pixels: size / 2 +- focal p / p.z",
	  { SIZE("size"), POSITIVE("focal", 1, 127, 142), { "p", TS_VECTOR_F32, 3, 107, 150, true } }, GIVES(F32, 2),
	  { { TS_FAULT_RECIPROCAL, project_reciprocal } }, .relate = relate_project },
	{ PRIMITIVE(snap), "15", "pixels to signed 24.8 fixed point, to the nearest, ties to even", { ANY("p", 2) },
	  GIVES(I32, 2), { { TS_FAULT_AWAY, snap_away }, { TS_FAULT_TRUNCATE, snap_truncate } },
	  EDGES(snap_edges), .relate = relate_snap },
	{ PRIMITIVE(edge), "17", "(bx - ax)(py - ay) - (by - ay)(px - ax)", { SNAPPED("a"), SNAPPED("b"), SNAPPED("p") },
	  GIVES(I64, 1), { { TS_FAULT_NARROW, edge_narrow }, { TS_FAULT_FLOAT, edge_float } },
	  .relate = relate_edge },
	{ PRIMITIVE(floor_quotient), "3, 19", "the floor of a / b",
	  { { "a", TS_VECTOR_I64, 1, -((i64)1 << 57), (i64)1 << 57, true },
	    { "b", TS_VECTOR_I64, 1, 1, (i64)1 << 33, false } }, GIVES(I64, 1),
	  { { TS_FAULT_TRUNCATE, quotient_truncate } }, .relate = relate_quotient },
	{ PRIMITIVE(top_left), "18", "1 if the edge from a to b is a top or left one", { SNAPPED("a"), SNAPPED("b") },
	  GIVES(U32, 1), .relate = relate_top_left },
	{ PRIMITIVE(covers), "18", "1 if point p is in triangle a b c, or on a top or left edge; 0 if it has no area",
	  { SNAPPED("a"), SNAPPED("b"), SNAPPED("c"), SNAPPED("p") }, GIVES(U32, 1),
	  { { TS_FAULT_INCLUSIVE, covers_inclusive } }, .relate = relate_covers },
	{ PRIMITIVE(touches), "19", "1 if the square of half size `half` around the centre of `pixel` meets triangle a b c",
	  { SNAPPED("a"), SNAPPED("b"), SNAPPED("c"), INTEGER("half", 1, 128, 129),
	    INTEGER("pixel", 2, -PIXEL_MAX, PIXEL_MAX) }, GIVES(U32, 1), .relate = relate_touches },
	{ PRIMITIVE(touched_row), "19", "of the pixels of row j that triangle a b c touches: the first, and how many",
	  { SNAPPED("a"), SNAPPED("b"), SNAPPED("c"), INTEGER("half", 1, 128, 129),
	    INTEGER("j", 1, -PIXEL_MAX, PIXEL_MAX) },
	  { COLUMN("first", I32, 1), COLUMN("n", U32, 1) }, .relate = relate_row },
	{ PRIMITIVE(fragment), "22", "weights and depth (w0, w1, w2, z) of edges e and corner depths z",
	  { { "e", TS_VECTOR_I64, 3, 0, (i64)1 << 47, true }, POSITIVE("z", 3, 107, 150) }, GIVES(F32, 4),
	  { { TS_FAULT_RECIPROCAL, fragment_reciprocal } } },
	{ PRIMITIVE(fragment_parallel), "22", "the same of an orthographic view",
	  { { "e", TS_VECTOR_I64, 3, 0, (i64)1 << 47, true }, POSITIVE("z", 3, 107, 150) }, GIVES(F32, 4),
	  { { TS_FAULT_RECIPROCAL, fragment_parallel_reciprocal } } },
	{ 0 },
};
/* clang-format on */

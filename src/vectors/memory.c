/* Primitives of shared memory: keys, minima, sums, prefix sums, Morton codes (CONTRACT rules 24 to 30). */
#include "kernels/vectors/vectors_memory.h"
#include "vectors/row.h"

static f32 depth_of_24_bits(f32 depth) { return (f32)(rint(fmin((double)depth, 1) * 16777215) / 16777215); }

WIDE_ITEM(key_depth24, ts_k_vector_packed(depth_of_24_bits(A), in[1]))

/* Only the 24 bits of depth below the sign and the highest bit of the exponent count. */
static void key_min_depth24(u32 *out, const u32 *in)
{
	u64 a = ts_row_u64(in, 0), b = ts_row_u64(in, 2);
	u32 da = (u32)(a >> 38), db = (u32)(b >> 38);
	ts_set_u64(out, 0, db < da || (db == da && (u32)b < (u32)a) ? b : a);
}

static void key_min_narrow(u32 *out, const u32 *in)
{
	u64 a = ts_row_u64(in, 0), b = ts_row_u64(in, 2);
	ts_set_u64(out, 0, (b >> 32) < (a >> 32) ? b : a);
}

/* Equal depths, or depths a step apart. */
static void relate_keys(u32 *in, u32 random)
{
	in[1] &= 0x7fffffffu;
	in[3] &= 0x7fffffffu;
	if ((random & 3) == 0) in[3] = in[1];
	if ((random & 3) == 1) in[3] = in[1] ^ 1;
}

static i32 term(const u32 *in, u32 k) { return ts_fix(ts_row_f32(in, k), 24, 31); }

static i64 sum_in_float(const u32 *in)
{
	f32 sum = 0;
	for (u32 k = 0; k < 4; k++) sum += (f32)term(in, k);
	return (i64)sum;
}

WIDE_ITEM(sum_narrow, (i64)(i32)((u32)term(in, 0) + (u32)term(in, 1) + (u32)term(in, 2) + (u32)term(in, 3)))
WIDE_ITEM(sum_float, sum_in_float(in))

WIDE_ITEM(morton_narrow, (u32)ts_k_morton(ts_i3_make(ts_row_i32(in, 0), ts_row_i32(in, 1), ts_row_i32(in, 2))))

static void unmorton_narrow(u32 *out, const u32 *in)
{
	ts_i3 p = ts_k_unmorton(in[0]);
	out[0] = (u32)p.x;
	out[1] = (u32)p.y;
	out[2] = (u32)p.z;
}

/* Up to 11 bits of each coordinate. */
static void relate_code(u32 *in, u32 random)
{
	(void)random;
	in[1] &= 1;
}

/* Few enough that the total fits (rule 27). */
static void relate_counts(u32 *in, u32 random)
{
	(void)random;
	for (u32 k = 0; k < 8; k++) in[k] >>= 4;
}

static const f32 depth_edges[] = {0x1p-100f, 1.0f, 0.5f, 0.25f};

/* clang-format off */
#define WIDE(name) { name, TS_VECTOR_U64, 1, INT64_MIN, INT64_MAX, false }
/* clang-format on */

/* clang-format off */
const ts_vector ts_vectors_memory[] = {
	{ PRIMITIVE(key), "12, 24", "bits of put(depth) << 32 | payload", { POSITIVE("depth", 1, 0, 254),
	    UNSIGNED("payload", 1, 0, UINT32_MAX - 1) }, GIVES(U64, 1),
	  { { TS_FAULT_DEPTH24, key_depth24 } }, EDGES(depth_edges) },
	{ PRIMITIVE(key_min), "24, 25", "the smaller of two keys", { WIDE("a"), WIDE("b") }, GIVES(U64, 1),
	  { { TS_FAULT_DEPTH24, key_min_depth24 }, { TS_FAULT_NARROW, key_min_narrow } }, .relate = relate_keys },
	{ PRIMITIVE(point_key), "ts_k_points_item", "triangle << 32 | (y + 2^15) << 16 | x + 2^15",
	  { ALL_U32("triangle", 1), INTEGER("x", 1, -32768, 32767), INTEGER("y", 1, -32768, 32767) },
	  GIVES(U64, 1) },
	{ PRIMITIVE(min_u32), "25", "the smaller of two words", { ALL_U32("a", 1), ALL_U32("b", 1) }, GIVES(U32, 1) },
	{ PRIMITIVE(add_i64), "13, 30", "sum of four terms, each rounded to steps of 2^-24", { ANY("x", 4) }, GIVES(I64, 1),
	  { { TS_FAULT_NARROW, sum_narrow }, { TS_FAULT_FLOAT, sum_float } } },
	{ PRIMITIVE(scan), "27", "exclusive prefix sums of eight counts, and their total", { ALL_U32("count", 8) },
	  GIVES(U32, 9), .relate = relate_counts },
	{ PRIMITIVE(morton), "ts_k_morton", "the bits of x, y and z in turn, x lowest", { INTEGER("p", 3, 0, 2047) },
	  GIVES(U64, 1), { { TS_FAULT_NARROW, morton_narrow } } },
	{ PRIMITIVE(unmorton), "ts_k_unmorton", "the place that a Morton code stands for", { WIDE("code") }, GIVES(I32, 3),
	  { { TS_FAULT_NARROW, unmorton_narrow } }, .relate = relate_code },
	{ 0 },
};
/* clang-format on */

/* Rows of arithmetic vectors: the arguments or the results of one item as words of 32 bits without padding, 64-bit
 * values low word first. Floats are stored as they are, without ts_put. */
#ifndef TS_KERNELS_VECTORS_VECTORS_ROW_H
#define TS_KERNELS_VECTORS_VECTORS_ROW_H
#include "kernels/base/vec.h"

TS_FN f32 ts_row_f32(TS_GLOBAL const u32 *row, u32 k) { return ts_u2f(row[k]); }
TS_FN i32 ts_row_i32(TS_GLOBAL const u32 *row, u32 k) { return (i32)row[k]; }
TS_FN u64 ts_row_u64(TS_GLOBAL const u32 *row, u32 k) { return (u64)row[k + 1u] << 32 | row[k]; }
TS_FN i64 ts_row_i64(TS_GLOBAL const u32 *row, u32 k) { return (i64)ts_row_u64(row, k); }
TS_FN ts_v2 ts_row_v2(TS_GLOBAL const u32 *row, u32 k)
{
	return ts_v2_make(ts_row_f32(row, k), ts_row_f32(row, k + 1u));
}
TS_FN ts_v3 ts_row_v3(TS_GLOBAL const u32 *row, u32 k)
{
	return ts_v3_make(ts_row_f32(row, k), ts_row_f32(row, k + 1u), ts_row_f32(row, k + 2u));
}

TS_FN void ts_set_f32(TS_GLOBAL u32 *row, u32 k, f32 x) { row[k] = ts_f2u(x); }
TS_FN void ts_set_u64(TS_GLOBAL u32 *row, u32 k, u64 x)
{
	row[k] = (u32)x;
	row[k + 1u] = (u32)(x >> 32);
}
TS_FN void ts_set_v2(TS_GLOBAL u32 *row, ts_v2 a)
{
	ts_set_f32(row, 0u, a.x);
	ts_set_f32(row, 1u, a.y);
}
TS_FN void ts_set_v3(TS_GLOBAL u32 *row, ts_v3 a)
{
	ts_set_f32(row, 0u, a.x);
	ts_set_f32(row, 1u, a.y);
	ts_set_f32(row, 2u, a.z);
}

/* Defines the item of a primitive by a body, or by an expression of its row `in`: a float, a word, a value of 64 bits.
 * Each macro pastes the name itself: passed on to another macro, the name would be replaced by a compiler's own macro,
 * say `sqrt`. */
#define TS_VECTOR(name) TS_FN void ts_k_vector_##name(TS_GLOBAL u32 *out, TS_GLOBAL const u32 *in)
#define TS_VECTOR_FLOAT(name, expression) \
	TS_FN void ts_k_vector_##name(TS_GLOBAL u32 *out, TS_GLOBAL const u32 *in) { ts_set_f32(out, 0u, expression); }
#define TS_VECTOR_WORD(name, expression) \
	TS_FN void ts_k_vector_##name(TS_GLOBAL u32 *out, TS_GLOBAL const u32 *in) { out[0] = (u32)(expression); }
#define TS_VECTOR_WIDE(name, wide) \
	TS_FN void ts_k_vector_##name(TS_GLOBAL u32 *out, TS_GLOBAL const u32 *in) { ts_set_u64(out, 0u, (u64)(wide)); }

/* The first words of the row `in`. */
#define TS_A ts_row_f32(in, 0u)
#define TS_B ts_row_f32(in, 1u)
#define TS_C ts_row_f32(in, 2u)

#endif

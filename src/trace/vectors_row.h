/* What the tables of primitives share: reading and writing rows, models of faults, ranges of arguments. */
#ifndef TS_TRACE_VECTORS_ROW_H
#define TS_TRACE_VECTORS_ROW_H
#include "../kernels/vec.h"
#include "vectors.h"

/* The tables, each ended by a row without a name. */
extern const ts_vector ts_vectors_arithmetic[], ts_vectors_number[], ts_vectors_vector[], ts_vectors_raster[],
	ts_vectors_cube[], ts_vectors_texture[];

static inline f32 row_f32(const u32 *row, u32 k) { return ts_u2f(row[k]); }
static inline i32 row_i32(const u32 *row, u32 k) { return (i32)row[k]; }
static inline u64 row_u64(const u32 *row, u32 k) { return (u64)row[k + 1] << 32 | row[k]; }
static inline i64 row_i64(const u32 *row, u32 k) { return (i64)row_u64(row, k); }
static inline ts_v3 row_v3(const u32 *row, u32 k)
{
	return ts_v3_make(row_f32(row, k), row_f32(row, k + 1), row_f32(row, k + 2));
}
static inline void set_f32(u32 *row, u32 k, f32 x) { row[k] = ts_f2u(x); }
static inline void set_u64(u32 *row, u32 k, u64 x)
{
	row[k] = (u32)x;
	row[k + 1] = (u32)(x >> 32);
}
static inline void set_v3(u32 *row, ts_v3 a)
{
	set_f32(row, 0, a.x);
	set_f32(row, 1, a.y);
	set_f32(row, 2, a.z);
}

/* An item that is one expression of the first words of its row. */
#define FLOAT_ITEM(name, expression) \
	static void name(u32 *out, const u32 *in) { set_f32(out, 0, (expression)); }
#define WORD_ITEM(name, expression) \
	static void name(u32 *out, const u32 *in) { out[0] = (u32)(expression); }
#define WIDE_ITEM(name, expression) \
	static void name(u32 *out, const u32 *in) { set_u64(out, 0, (u64)(expression)); }
#define A row_f32(in, 0)
#define B row_f32(in, 1)
#define C row_f32(in, 2)

/* What a processor that flushes makes of a denormal. */
static inline f32 flushed(f32 x) { return ts_abs(x) < FLT_MIN ? copysignf(0.0f, x) : x; }

/* What it makes of an exact or nearly exact result: tiny is what rounds to less than the smallest normal number where
 * denormals are none. */
static inline f32 flushed_result(double x)
{
	return fabs(x) < FLT_MIN * (1 - 0x1p-25) ? copysignf(0.0f, (f32)x) : (f32)x;
}

/* Columns. ANY holds every pattern of bits; SANE what ts_san lets through (rule 10); WORLD coordinates (rule 11). */
#define ANY(name, count) { name, TS_VECTOR_F32, count, 0, 255, true }
#define FINITE(name, count) { name, TS_VECTOR_F32, count, 0, 254, true }
#define SANE(name, count) { name, TS_VECTOR_F32, count, 88, 188, true }
#define WORLD(name, count) { name, TS_VECTOR_F32, count, 88, 150, true }
#define POSITIVE(name, count, low, high) { name, TS_VECTOR_F32, count, low, high, false }
#define INTEGER(name, count, low, high) { name, TS_VECTOR_I32, count, low, high, true }
#define UNSIGNED(name, count, low, high) { name, TS_VECTOR_U32, count, low, high, false }
#define ALL_U32(name, count) UNSIGNED(name, count, 0, UINT32_MAX)

#define EDGES(list) .edges = list, .n_edges = sizeof list / sizeof list[0]

#endif

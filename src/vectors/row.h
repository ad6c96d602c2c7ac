/* Shared by the tables of primitives: models of faults, ranges of arguments. */
#ifndef TS_VECTORS_ROW_H
#define TS_VECTORS_ROW_H
#include "kernels/vectors/composites_row.h"
#include "vectors/vectors.h"

/* The tables of the primitives that all methods share, each ended by a row without a name. */
extern const ts_vector ts_vectors_arithmetic[], ts_vectors_number[], ts_vectors_vector[], ts_vectors_raster[],
	ts_vectors_cube[], ts_vectors_memory[], ts_vectors_texture[];
extern const ts_vector ts_composites_geometry[], ts_composites_shade[], ts_composites_lattice[];

/* The first fields of a ts_vector: the kernels' item of that name. */
#define PRIMITIVE(n) .name = #n, .item = ts_k_vector_##n

/* A faulty item that is one expression of the first words of its row. */
#define FLOAT_ITEM(name, expression) \
	static void name(u32 *out, const u32 *in) { ts_set_f32(out, 0, (expression)); }
#define WORD_ITEM(name, expression) \
	static void name(u32 *out, const u32 *in) { out[0] = (u32)(expression); }
#define WIDE_ITEM(name, expression) \
	static void name(u32 *out, const u32 *in) { ts_set_u64(out, 0, (u64)(expression)); }
#define A TS_A
#define B TS_B
#define C TS_C

/* A value on a processor that flushes denormals to 0. */
static inline f32 flushed(f32 x) { return ts_abs(x) < FLT_MIN ? copysignf(0.0f, x) : x; }

/* The result of such a processor for an exact or nearly exact value: 0 if the value, rounded as if exponents had no
 * lower bound, is below the smallest normal number. */
static inline f32 flushed_result(double x)
{
	return fabs(x) < FLT_MIN * (1 - 0x1p-25) ? copysignf(0.0f, (f32)x) : (f32)x;
}

/* Columns. ANY: every pattern of bits; SANE: values that ts_san leaves unchanged (rule 10); WORLD: coordinates (rule
 * 11). */
/* clang-format off */
#define ANY(name, count) { name, TS_VECTOR_F32, count, 0, 255, true }
#define FINITE(name, count) { name, TS_VECTOR_F32, count, 0, 254, true }
#define SANE(name, count) { name, TS_VECTOR_F32, count, 88, 188, true }
#define WORLD(name, count) { name, TS_VECTOR_F32, count, 88, 150, true }
#define POSITIVE(name, count, low, high) { name, TS_VECTOR_F32, count, low, high, false }
#define INTEGER(name, count, low, high) { name, TS_VECTOR_I32, count, low, high, true }
#define UNSIGNED(name, count, low, high) { name, TS_VECTOR_U32, count, low, high, false }
/* clang-format on */
#define ALL_U32(name, count) UNSIGNED(name, count, 0, UINT32_MAX)

/* Outputs: elements of one type, or several columns with names. */
/* clang-format off */
#define GIVES(type, count) { COLUMN("", type, count) }
#define COLUMN(name, type, count) { name, TS_VECTOR_##type, count, 0, 0, false }
/* clang-format on */

#define EDGES(list) .edges = list, .n_edges = sizeof list / sizeof list[0]

#endif

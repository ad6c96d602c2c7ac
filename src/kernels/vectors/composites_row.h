/* Reads records and parts of records from a row, for the functions that take them. */
#ifndef TS_KERNELS_VECTORS_COMPOSITES_ROW_H
#define TS_KERNELS_VECTORS_COMPOSITES_ROW_H
#include "kernels/base/records.h"
#include "kernels/vectors/vectors_args.h"

/* ts_row_at_TYPE(row, k): the words from k on as a record of that type; if it has 64-bit fields, k and the row's first
 * word are even. */
#define TS_ROW_AT(type) \
	TS_FN TS_GLOBAL const type *ts_row_at_##type(TS_GLOBAL const u32 *row, u32 k) \
	{ \
		return (TS_GLOBAL const type *)(row + k); \
	}
TS_ROW_AT(u64)
TS_ROW_AT(ts_vertex)
TS_ROW_AT(ts_triangle)
TS_ROW_AT(ts_material)
TS_ROW_AT(ts_slot)
TS_ROW_AT(ts_image)
TS_ROW_AT(ts_object)
TS_ROW_AT(ts_motion)
TS_ROW_AT(ts_light)
TS_ROW_AT(ts_view)
TS_ROW_AT(ts_piece)
TS_ROW_AT(ts_align)

/* Outputs pass ts_put, like all floats that kernels store. */
TS_FN void ts_put_f32(TS_GLOBAL u32 *row, u32 k, f32 x) { ts_set_f32(row, k, ts_put(x)); }
TS_FN void ts_put_v2(TS_GLOBAL u32 *row, ts_v2 a) { ts_set_v2(row, ts_v2_make(ts_put(a.x), ts_put(a.y))); }
TS_FN void ts_put_v3(TS_GLOBAL u32 *row, ts_v3 a) { ts_set_v3(row, ts_v3_make(ts_put(a.x), ts_put(a.y), ts_put(a.z))); }
#define TS_COMPOSITE_FLOAT(name, expression) \
	TS_FN void ts_k_vector_##name(TS_GLOBAL u32 *out, TS_GLOBAL const u32 *in) { ts_put_f32(out, 0u, expression); }

TS_FN TS_GLOBAL ts_align *ts_row_at_result(TS_GLOBAL u32 *row) { return (TS_GLOBAL ts_align *)row; }

#endif

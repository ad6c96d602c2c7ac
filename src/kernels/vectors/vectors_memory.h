/* Primitives of what items share: keys and their minima, sums in fixed point, prefix sums, Morton codes (CONTRACT rules
 * 24 to 30). Minima and sums are taken in the result's memory, since devices have these operations only in memory. */
#ifndef TS_KERNELS_VECTORS_VECTORS_MEMORY_H
#define TS_KERNELS_VECTORS_VECTORS_MEMORY_H
#include "kernels/base/morton.h"
#include "kernels/vectors/vectors_row.h"

TS_FN u64 ts_k_vector_packed(f32 depth, u32 payload) { return (u64)ts_f2u(depth) << 32 | payload; }
TS_VECTOR_WIDE(key, ts_k_vector_packed(ts_put(TS_A), in[1]))

TS_VECTOR(key_min)
{
	TS_GLOBAL u64 *key = (TS_GLOBAL u64 *)out;
	*key = ts_row_u64(in, 0u);
	ts_min_u64(key, ts_row_u64(in, 2u));
	ts_set_u64(out, 0u, *key);
}

TS_VECTOR(point_key)
{
	u32 x = (u32)(ts_row_i32(in, 1u) + 32768);
	u32 y = (u32)(ts_row_i32(in, 2u) + 32768);
	ts_set_u64(out, 0u, (u64)in[0] << 32 | (u64)y << 16 | (u64)x);
}

TS_VECTOR(min_u32)
{
	out[0] = in[0];
	ts_min_u32(out, in[1]);
}

TS_VECTOR(add_i64)
{
	TS_GLOBAL i64 *sum = (TS_GLOBAL i64 *)out;
	*sum = 0;
	for (u32 k = 0u; k < 4u; k++) ts_add_i64(sum, (i64)ts_fix(ts_row_f32(in, k), 24, 31));
	ts_set_u64(out, 0u, (u64)*sum);
}

TS_VECTOR(scan)
{
	u32 sum = 0u;
	for (u32 k = 0u; k < 8u; k++) {
		out[k] = sum;
		sum += in[k];
	}
	out[8] = sum;
}

TS_VECTOR_WIDE(morton, ts_k_morton(ts_i3_make(ts_row_i32(in, 0u), ts_row_i32(in, 1u), ts_row_i32(in, 2u))))

TS_VECTOR(unmorton)
{
	ts_i3 p = ts_k_unmorton(ts_row_u64(in, 0u));
	out[0] = (u32)p.x;
	out[1] = (u32)p.y;
	out[2] = (u32)p.z;
}

#endif

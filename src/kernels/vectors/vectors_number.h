/* Primitives of numbers: the operations of IEEE 754, one each, the two pairs that compilers like to fuse (CONTRACT
 * rules 4 to 6), and the functions of num.h, half.h and vec.h. */
#ifndef TS_KERNELS_VECTORS_VECTORS_NUMBER_H
#define TS_KERNELS_VECTORS_VECTORS_NUMBER_H
#include "kernels/base/half.h"
#include "kernels/vectors/vectors_row.h"

/* The binary32 next to 1.1 and 1.7. */
#define TS_VECTOR_FACTOR 1.10000002384185791015625f
#define TS_VECTOR_OTHER 1.7000000476837158203125f

TS_VECTOR_FLOAT(add, TS_A + TS_B)
TS_VECTOR_FLOAT(sub, TS_A - TS_B)
TS_VECTOR_FLOAT(mul, TS_A *TS_B)
TS_VECTOR_FLOAT(div, TS_A / TS_B)
TS_VECTOR_FLOAT(sqrt, ts_sqrt(TS_A))

/* Each is one expression, which compilers fuse first. */
TS_VECTOR_FLOAT(muladd, TS_A *TS_B + TS_C)
TS_VECTOR_FLOAT(mulsub, TS_C - TS_A * TS_B)

TS_FN u32 ts_k_vector_order(f32 a, f32 b) { return (a < b ? 1u : 0u) | (a == b ? 2u : 0u) | (a > b ? 4u : 0u); }
TS_VECTOR_WORD(compare, ts_k_vector_order(TS_A, TS_B))

TS_VECTOR_FLOAT(floor, ts_floor(TS_A))
TS_VECTOR_FLOAT(i32_to_f32, (f32)ts_row_i32(in, 0u))
TS_VECTOR_FLOAT(u32_to_f32, (f32)in[0])
TS_VECTOR_FLOAT(i64_to_f32, (f32)ts_row_i64(in, 0u))

/* Numbers that the compiler knows: drivers turn such a quotient into a product, and two such factors into one. */
TS_VECTOR_FLOAT(third, TS_A / 3.0f)
TS_VECTOR(constants)
{
	ts_set_f32(out, 0u, (TS_A * TS_VECTOR_FACTOR) * TS_VECTOR_OTHER);
	ts_set_f32(out, 1u, TS_A * (TS_VECTOR_FACTOR * TS_VECTOR_OTHER));
}

TS_VECTOR_FLOAT(min, ts_min(TS_A, TS_B))
TS_VECTOR_FLOAT(max, ts_max(TS_A, TS_B))
TS_VECTOR_FLOAT(clamp, ts_clamp(TS_A, TS_B, TS_C))
TS_VECTOR_FLOAT(abs, ts_abs(TS_A))
TS_VECTOR_FLOAT(san, ts_san(TS_A))
TS_VECTOR_FLOAT(put, ts_put(TS_A))
TS_VECTOR_WORD(fix, ts_fix(TS_A, ts_row_i32(in, 1u), ts_row_i32(in, 2u)))
TS_VECTOR_WORD(to_half, ts_f2u(ts_half(TS_A)))
TS_VECTOR_WORD(f2i, ts_f2i(TS_A))
TS_VECTOR_WORD(floor_i32, ts_floor_i32(TS_A))
TS_VECTOR_FLOAT(rint, ts_rint(TS_A))
TS_VECTOR_WORD(pcg, ts_pcg(in[0]))
TS_VECTOR_WORD(random, ts_random(in[0], in[1], in[2]))
TS_VECTOR_FLOAT(uniform, ts_uniform(in[0]))
TS_VECTOR_FLOAT(log2, ts_log2(TS_A))
TS_VECTOR_FLOAT(exp, ts_exp(TS_A))
TS_VECTOR_FLOAT(sin_turn, ts_sin_turn(TS_A))
TS_VECTOR_FLOAT(cos_turn, ts_cos_turn(TS_A))
TS_VECTOR_FLOAT(atan2, ts_atan2(TS_A, TS_B))

TS_VECTOR_FLOAT(diff_of_products, ts_diff_of_products(TS_A, TS_B, TS_C, ts_row_f32(in, 3u)))
TS_VECTOR_FLOAT(dot, ts_dot(ts_row_v3(in, 0u), ts_row_v3(in, 3u)))
TS_VECTOR(cross) { ts_set_v3(out, ts_cross(ts_row_v3(in, 0u), ts_row_v3(in, 3u))); }
TS_VECTOR(mad) { ts_set_v3(out, ts_mad(ts_row_v3(in, 0u), ts_row_v3(in, 3u), ts_row_f32(in, 6u))); }
TS_VECTOR_FLOAT(length, ts_length(ts_row_v3(in, 0u)))
TS_VECTOR(normalize) { ts_set_v3(out, ts_normalize(ts_row_v3(in, 0u))); }
TS_VECTOR(reflect) { ts_set_v3(out, ts_reflect(ts_row_v3(in, 0u), ts_row_v3(in, 3u))); }
TS_VECTOR(blend)
{
	ts_set_v3(out, ts_blend(ts_row_v3(in, 0u), ts_row_v3(in, 3u), ts_row_v3(in, 6u), ts_row_v3(in, 9u)));
}

#endif

/* The functions that kernels/base/compat.h takes from the CUDA toolkit, by clang's built-in functions, so that no
 * toolkit is needed. */
#ifndef TS_BACKENDS_CUDA_BUILTINS_H
#define TS_BACKENDS_CUDA_BUILTINS_H

#define __device__ __attribute__((device))
#define __global__ __attribute__((global))
#define __constant__ __attribute__((constant))
#define __forceinline__ inline __attribute__((always_inline))
#define __noinline__ __attribute__((noinline))
#define NULL 0

typedef unsigned long long ts_word;
static __device__ __forceinline__ unsigned __float_as_uint(float x) { return __builtin_bit_cast(unsigned, x); }
static __device__ __forceinline__ float __uint_as_float(unsigned x) { return __builtin_bit_cast(float, x); }
static __device__ __forceinline__ float __fsqrt_rn(float x) { return __nvvm_sqrt_rn_f(x); }
static __device__ __forceinline__ float floorf(float x) { return __builtin_floorf(x); }
static __device__ __forceinline__ ts_word atomicMin(ts_word *p, ts_word v) { return __nvvm_atom_min_gen_ull(p, v); }
static __device__ __forceinline__ unsigned atomicMin(unsigned *p, unsigned v) { return __nvvm_atom_min_gen_ui(p, v); }
static __device__ __forceinline__ unsigned atomicAdd(unsigned *p, unsigned v)
{
	return __nvvm_atom_add_gen_i((int *)p, v);
}
static __device__ __forceinline__ ts_word atomicAdd(ts_word *p, ts_word v)
{
	return __nvvm_atom_add_gen_ll((long long *)p, v);
}
static __device__ __forceinline__ ts_word atomicOr(ts_word *p, ts_word v)
{
	return __nvvm_atom_or_gen_ll((long long *)p, v);
}

#endif

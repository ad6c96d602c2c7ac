/* The only file that asks which language is compiled. Everything else under kernels/ is the common subset of C11,
 * OpenCL C 1.2 and CUDA C: see CONTRIBUTING.md, "Kernels". */
#ifndef TS_KERNELS_BASE_COMPAT_H
#define TS_KERNELS_BASE_COMPAT_H

#if defined(__OPENCL_C_VERSION__)

#ifndef TS_CANARY_CONTRACTS /* defined by tests that must see contraction */
#pragma OPENCL FP_CONTRACT OFF
#endif
#pragma OPENCL EXTENSION cl_khr_int64_base_atomics : enable
#pragma OPENCL EXTENSION cl_khr_int64_extended_atomics : enable
typedef float f32;
typedef int i32;
typedef uint u32;
typedef long i64;
typedef ulong u64;
typedef uchar u8;
/* OpenCL compilers leave long functions out of line, which costs a third of a frame, so TS_FN is inlined. Copies of
 * functions that are called from many places take long to compile: TS_CALL is out of line everywhere, TS_HOT only on
 * devices. */
#ifndef TS_FN /* Oclgrind rejects functions that must be inlined: -DTS_FN=static */
#define TS_FN static inline __attribute__((always_inline))
#endif
#define TS_CALL static __attribute__((noinline, unused))
#define TS_HOT TS_CALL
#define TS_GLOBAL __global
#define TS_CONSTANT __constant
#define ts_f2u(x) as_uint(x)
#define ts_u2f(x) as_float(x)
#define ts_sqrt(x) sqrt(x)
#define ts_floor(x) floor(x)
/* No read comes first: OpenCL C 1.2 has no atomic load, and a plain load races with writes of other items. */
#define ts_min_u64(p, v) ((void)atom_min((p), (v)))
#define ts_min_u32(p, v) ((void)atomic_min((p), (v)))
#define ts_peek_u32(p) atomic_or((p), 0u)
#define ts_or_u64(p, v) ((void)atom_or((p), (v)))
#define ts_add_i64(p, v) ((void)atom_add((p), (v)))
#define ts_next_i64(p) atom_inc(p)
#define ts_next_u32(p) atomic_inc(p)
#define ts_mark_u8(p) (*(p) = 1)
/* An array in as many parts as the device needs: the program is built with TS_PARTS and TS_PART_BYTES, a power of
 * two. */
#if TS_PARTS > 1
#define TS_PARTED(type, name) __global type *name[TS_PARTS]
#define TS_PART_OF(array) (TS_PART_BYTES / sizeof(*(array)[0]))
#define ts_at(array, i) (&(array)[(i) / TS_PART_OF(array)][(i) % TS_PART_OF(array)])
#endif
#define TS_ASSERT_SIZE(type, bytes) typedef char type##_is_packed[sizeof(type) == (bytes) ? 1 : -1]

#elif defined(__CUDACC__)

typedef float f32;
typedef int i32;
typedef unsigned int u32;
typedef long long i64;
typedef unsigned long long u64;
typedef unsigned char u8;
#define TS_FN static __device__ __forceinline__
#define TS_CALL static __device__ __noinline__
#define TS_HOT TS_CALL
#define TS_GLOBAL
#define TS_CONSTANT static __constant__
#define ts_f2u(x) __float_as_uint(x)
#define ts_u2f(x) __uint_as_float(x)
#define ts_sqrt(x) __fsqrt_rn(x)
#define ts_floor(x) floorf(x)
/* A volatile read is a relaxed read in PTX's memory model, so it does not race with relaxed atomics of the device. */
#define ts_min_u64(p, v) \
	do { \
		if ((v) < *(volatile u64 *)(p)) atomicMin((p), (v)); \
	} while (0)
#define ts_min_u32(p, v) \
	do { \
		if ((v) < *(volatile u32 *)(p)) atomicMin((p), (v)); \
	} while (0)
#define ts_peek_u32(p) (*(volatile u32 *)(p))
#define ts_or_u64(p, v) \
	do { \
		if (((v) & ~*(volatile u64 *)(p)) != 0u) atomicOr((p), (v)); \
	} while (0)
#define ts_add_i64(p, v) ((void)atomicAdd((u64 *)(p), (u64)(v)))
#define ts_next_i64(p) ((i64)atomicAdd((u64 *)(p), (u64)1u))
#define ts_next_u32(p) atomicAdd((p), 1u)
#define ts_mark_u8(p) (*(p) = 1)
#define TS_ASSERT_SIZE(type, bytes) static_assert(sizeof(type) == (bytes), #type)

#else

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0)
#error "the numeric contract needs strict IEEE arithmetic: remove -ffast-math, -Ofast and -ffinite-math-only"
#endif
static_assert(FLT_EVAL_METHOD == 0, "float expressions must be evaluated as float");

typedef float f32;
typedef int32_t i32;
typedef uint32_t u32;
typedef int64_t i64;
typedef uint64_t u64;
typedef uint8_t u8;
#define TS_FN static inline
#if defined(__GNUC__)
#define TS_CALL static __attribute__((noinline, unused))
#else
#define TS_CALL static inline
#endif
#define TS_HOT static inline
#define TS_GLOBAL
#define TS_CONSTANT static const
static inline u32 ts_f2u(f32 x)
{
	u32 u;
	memcpy(&u, &x, 4);
	return u;
}
static inline f32 ts_u2f(u32 u)
{
	f32 x;
	memcpy(&x, &u, 4);
	return x;
}
#define ts_sqrt(x) sqrtf(x)
#define ts_floor(x) floorf(x)
/* A value that is not below the one read may be skipped, since the stored value only ever falls. */
static inline void ts_min_u64(u64 *p, u64 v)
{
	u64 old = __atomic_load_n(p, __ATOMIC_RELAXED);
	while (v < old && !__atomic_compare_exchange_n(p, &old, v, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {
	}
}
static inline void ts_min_u32(u32 *p, u32 v)
{
	u32 old = __atomic_load_n(p, __ATOMIC_RELAXED);
	while (v < old && !__atomic_compare_exchange_n(p, &old, v, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {
	}
}
/* Reads a value that other items may lower at the same time. */
static inline u32 ts_peek_u32(const u32 *p) { return __atomic_load_n(p, __ATOMIC_RELAXED); }
/* Sets bits. Bits that are set already may be skipped, since no bit is ever cleared. */
static inline void ts_or_u64(u64 *p, u64 v)
{
	if ((v & ~__atomic_load_n(p, __ATOMIC_RELAXED)) != 0u) __atomic_fetch_or(p, v, __ATOMIC_RELAXED);
}
static inline void ts_add_i64(i64 *p, i64 v) { __atomic_fetch_add(p, v, __ATOMIC_RELAXED); }
/* Adds 1 and returns the value before. */
static inline i64 ts_next_i64(i64 *p) { return __atomic_fetch_add(p, 1, __ATOMIC_RELAXED); }
static inline u32 ts_next_u32(u32 *p) { return __atomic_fetch_add(p, 1u, __ATOMIC_RELAXED); }
/* Stores 1; other items may store 1 at the same time. */
static inline void ts_mark_u8(u8 *p) { __atomic_store_n(p, 1, __ATOMIC_RELAXED); }
#define TS_ASSERT_SIZE(type, bytes) static_assert(sizeof(type) == (bytes), #type " has padding")

#endif

/* TS_PARTED: a member that points to an array that may be larger than a device allocates at once; ts_at: the address of
 * its element i. */
#ifndef TS_PARTED
#define TS_PARTED(type, name) TS_GLOBAL type *name
#define ts_at(array, i) (&(array)[i])
#endif
#endif

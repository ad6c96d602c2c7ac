/* What instructions of PTX compute, by the manual "Parallel Thread Execution ISA": a function each, of its name.
 * Registers hold unsigned numbers of their width. */
#ifndef TS_TESTS_BACKENDS_CUDA_INSTRUCTIONS_H
#define TS_TESTS_BACKENDS_CUDA_INSTRUCTIONS_H
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

typedef float f32;
typedef uint8_t u8;
typedef uint16_t u16;
typedef uint32_t u32;
typedef uint64_t u64;
typedef int16_t s16;
typedef int32_t s32;
typedef int64_t s64;

static inline u32 f2u(f32 x)
{
	u32 u;
	memcpy(&u, &x, sizeof u);
	return u;
}
static inline f32 u2f(u32 u)
{
	f32 x;
	memcpy(&x, &u, sizeof x);
	return x;
}

/* Of each width: what asks for no sign; what does. A divisor of 0 leaves what the manual leaves open. */
#define SAME(bits, name, expression) \
	static inline u##bits name(u##bits a, u##bits b) { return (u##bits)(expression); }
#define WITH_SIGN(type, bits) \
	static inline u##bits min_##type##bits(type##bits a, type##bits b) { return (u##bits)(a < b ? a : b); } \
	static inline u##bits max_##type##bits(type##bits a, type##bits b) { return (u##bits)(a > b ? a : b); } \
	static inline u##bits shr_##type##bits(type##bits a, u32 n) \
	{ \
		return (u##bits)(n < bits ? a >> n : a < 0 ? -1 : 0); \
	} \
	static inline u##bits div_##type##bits(type##bits a, type##bits b) \
	{ \
		bool minus = (type##bits) - 1 < 0 && b == (type##bits) - 1; \
		return (u##bits)(b == 0 ? 0x5555 : minus ? 0 - (u##bits)a : (u##bits)(a / b)); \
	} \
	static inline u##bits rem_##type##bits(type##bits a, type##bits b) \
	{ \
		bool minus = (type##bits) - 1 < 0 && b == (type##bits) - 1; \
		return (u##bits)(b == 0 ? 0x5555 : minus ? 0 : a % b); \
	} \
	static inline bool setp_eq_##type##bits(type##bits a, type##bits b) { return a == b; } \
	static inline bool setp_ne_##type##bits(type##bits a, type##bits b) { return a != b; } \
	static inline bool setp_lt_##type##bits(type##bits a, type##bits b) { return a < b; } \
	static inline bool setp_le_##type##bits(type##bits a, type##bits b) { return a <= b; } \
	static inline bool setp_gt_##type##bits(type##bits a, type##bits b) { return a > b; } \
	static inline bool setp_ge_##type##bits(type##bits a, type##bits b) { return a >= b; } \
	SAME(bits, add_##type##bits, a + b) \
	SAME(bits, sub_##type##bits, a - b) \
	SAME(bits, mul_lo_##type##bits, a *b) \
	static inline u##bits selp_##type##bits(u##bits a, u##bits b, bool p) { return p ? a : b; } \
	static inline u##bits mov_##type##bits(u##bits a) { return a; }
#define OF_BITS(bits) \
	WITH_SIGN(u, bits) \
	WITH_SIGN(s, bits) \
	SAME(bits, and_b##bits, a &b) \
	SAME(bits, or_b##bits, a | b) \
	SAME(bits, xor_b##bits, a ^ b) \
	static inline u##bits not_b##bits(u##bits a) { return (u##bits) ~a; } \
	static inline u##bits shl_b##bits(u##bits a, u32 n) { return (u##bits)(n < bits ? (u64)a << n : 0); } \
	static inline bool setp_eq_b##bits(u##bits a, u##bits b) { return a == b; } \
	static inline bool setp_ne_b##bits(u##bits a, u##bits b) { return a != b; } \
	static inline u##bits selp_b##bits(u##bits a, u##bits b, bool p) { return p ? a : b; } \
	static inline u##bits mov_b##bits(u##bits a) { return a; } \
	static inline u##bits neg_s##bits(u##bits a) { return (u##bits)(0 - a); } \
	static inline u##bits abs_s##bits(u##bits a) { return (s##bits)a < 0 ? (u##bits)(0 - a) : a; }
OF_BITS(16)
OF_BITS(32)
OF_BITS(64)

static inline u64 mul_wide_u32(u32 a, u32 b) { return (u64)a * b; }
static inline u64 mul_wide_s32(s32 a, s32 b) { return (u64)((s64)a * b); }
static inline u32 mul_hi_u32(u32 a, u32 b) { return (u32)((u64)a * b >> 32); }
static inline u64 mul_hi_u64(u64 a, u64 b) { return (u64)((unsigned __int128)a * b >> 64); }
static inline u32 mad_lo_s32(u32 a, u32 b, u32 c) { return a * b + c; }
static inline u32 bfe_u32(u32 a, u32 from, u32 n)
{
	return from < 32 ? (u32)((a >> from) & ((1ull << (n < 32 ? n : 32)) - 1)) : 0;
}

static inline u32 bfi_b32(u32 a, u32 b, u32 to, u32 n)
{
	u64 mask = (1ull << (n < 32 ? n : 32)) - 1;
	return to < 32 ? (u32)((b & ~(mask << to)) | (a & mask) << to) : b;
}
static inline u32 popc_b64(u64 a) { return (u32)__builtin_popcountll(a); }
static inline u32 mov_high_b64(u64 a) { return (u32)(a >> 32); } /* of mov.b64 into two halves */

/* Predicates, of which -1 is true. */
static inline bool and_pred(bool a, bool b) { return a && b; }
static inline bool or_pred(bool a, bool b) { return a || b; }
static inline bool xor_pred(bool a, bool b) { return a != b; }
static inline bool not_pred(bool a) { return !a; }
static inline bool mov_pred(bool a) { return a; }

/* Floats. Each NaN that is made has the bits 0x7fffffff, which no other processor's has. */
static inline f32 made(f32 x) { return x == x ? x : u2f(0x7fffffffu); }
static inline f32 add_rn_f32(f32 a, f32 b) { return made(a + b); }
static inline f32 sub_rn_f32(f32 a, f32 b) { return made(a - b); }
static inline f32 mul_rn_f32(f32 a, f32 b) { return made(a * b); }
static inline f32 div_rn_f32(f32 a, f32 b) { return made(a / b); }
static inline f32 rcp_rn_f32(f32 a) { return made(1 / a); }
static inline f32 sqrt_rn_f32(f32 a) { return made(sqrtf(a)); }
static inline f32 fma_rn_f32(f32 a, f32 b, f32 c) { return made(fmaf(a, b, c)); }
/* A driver may fuse these, which the kernels must not have. */
static inline f32 add_f32(f32 a, f32 b) { return made(a + b); }
static inline f32 sub_f32(f32 a, f32 b) { return made(a - b); }
static inline f32 mul_f32(f32 a, f32 b) { return made(a * b); }
static inline f32 neg_f32(f32 a) { return u2f(f2u(a) ^ 0x80000000u); }
static inline f32 abs_f32(f32 a) { return u2f(f2u(a) & 0x7fffffffu); }
static inline f32 mov_f32(f32 a) { return a; }
static inline f32 selp_f32(f32 a, f32 b, bool p) { return p ? a : b; }
/* The number of a number and a NaN; -0 is less than 0. */
static inline f32 min_f32(f32 a, f32 b) { return made(b != b ? a : a < b || (a == b && f2u(a) >> 31 != 0) ? a : b); }
static inline f32 max_f32(f32 a, f32 b) { return made(b != b ? a : a > b || (a == b && f2u(b) >> 31 != 0) ? a : b); }
static inline bool setp_num_f32(f32 a, f32 b) { return a == a && b == b; }
static inline bool setp_nan_f32(f32 a, f32 b) { return a != a || b != b; }
#define COMPARED(name, sign) \
	static inline bool setp_##name##_f32(f32 a, f32 b) { return setp_num_f32(a, b) && a sign b; } \
	static inline bool setp_##name##u_f32(f32 a, f32 b) { return setp_nan_f32(a, b) || a sign b; }
COMPARED(eq, ==)
COMPARED(ne, !=)
COMPARED(lt, <)
COMPARED(le, <=)
COMPARED(gt, >)
COMPARED(ge, >=)

/* Conversions. Of a float to an integer: what does not fit is the nearest that does, and NaN is 0. */
static inline f32 cvt_rmi_f32_f32(f32 a) { return made(floorf(a)); }
static inline f32 cvt_rn_f32_s32(s32 a) { return (f32)a; }
static inline f32 cvt_rn_f32_u32(u32 a) { return (f32)a; }
static inline f32 cvt_rn_f32_u64(u64 a) { return (f32)a; }
static inline f32 cvt_rn_f32_s64(s64 a) { return (f32)a; }
static inline u32 cvt_rzi_s32_f32(f32 a)
{
	return a != a ? 0 : a >= 0x1p31f ? INT32_MAX : a <= -0x1p31f ? (u32)INT32_MIN : (u32)(s32)a;
}
static inline u64 cvt_u64_u32(u32 a) { return a; }
static inline u64 cvt_u64_u16(u16 a) { return a; }
static inline u64 cvt_s64_s32(s32 a) { return (u64)(s64)a; }
static inline u32 cvt_u32_u64(u64 a) { return (u32)a; }
static inline u32 cvt_u32_u16(u16 a) { return a; }
static inline u16 cvt_u16_u64(u64 a) { return (u16)a; }
static inline u16 cvt_u16_u32(u32 a) { return (u16)a; }

/* Memory, all of which has generic addresses. What is smaller than its register is extended. */
static inline u64 cvta_to_u64(u64 a) { return a; }
static inline u64 cvta_u64(u64 a) { return a; }
#define OF_MEMORY(kind, type, wide) \
	static inline wide ld_##kind(u64 at) \
	{ \
		type a; \
		memcpy(&a, (const void *)at, sizeof a); \
		return (wide)a; \
	} \
	static inline void st_##kind(u64 at, wide a) \
	{ \
		type narrow = (type)a; \
		memcpy((void *)at, &narrow, sizeof narrow); \
	}
OF_MEMORY(u8, u8, u64)
OF_MEMORY(b8, u8, u64)
OF_MEMORY(u16, u16, u64)
OF_MEMORY(u32, u32, u64)
OF_MEMORY(b32, u32, u64)
OF_MEMORY(s32, s32, u64)
OF_MEMORY(u64, u64, u64)
OF_MEMORY(b64, u64, u64)
OF_MEMORY(f32, f32, f32)
static inline u32 ld_volatile_u32(u64 at) { return __atomic_load_n((u32 *)at, __ATOMIC_RELAXED); }
static inline u64 ld_volatile_u64(u64 at) { return __atomic_load_n((u64 *)at, __ATOMIC_RELAXED); }
#define ATOMIC(name, type, expression) \
	static inline type atom_##name(u64 at, type b) \
	{ \
		type a = __atomic_load_n((type *)at, __ATOMIC_RELAXED); \
		while (!__atomic_compare_exchange_n((type *)at, &a, expression, true, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) { \
		} \
		return a; \
	}
ATOMIC(add_u32, u32, a + b)
ATOMIC(add_u64, u64, a + b)
ATOMIC(min_u32, u32, a < b ? a : b)
ATOMIC(min_u64, u64, a < b ? a : b)
ATOMIC(or_b64, u64, a | b)

#endif

/* The kernels' language as scripts/kernel/tree.py reads it, in the place of src/kernels/base/compat.h. Qualifiers that
 * kernels have no other use for mark what items share and what may be in parts. */
#ifndef TS_KERNELS_BASE_COMPAT_H
#define TS_KERNELS_BASE_COMPAT_H

typedef float f32;
typedef int i32;
typedef unsigned int u32;
typedef long i64;
typedef unsigned long u64;
typedef unsigned char u8;
typedef _Bool bool;
extern const bool false, true;
#define NULL ts_null

#define TS_FN static inline
#define TS_CALL static
#define TS_HOT static
#define TS_GLOBAL volatile
#define TS_CONSTANT static const

u32 ts_f2u(f32 x);
f32 ts_u2f(u32 u);
f32 ts_sqrt(f32 x);
f32 ts_floor(f32 x);
void ts_min_u64(TS_GLOBAL u64 *p, u64 v);
void ts_min_u32(TS_GLOBAL u32 *p, u32 v);
u32 ts_peek_u32(TS_GLOBAL const u32 *p);
void ts_or_u64(TS_GLOBAL u64 *p, u64 v);
void ts_add_i64(TS_GLOBAL i64 *p, i64 v);
i64 ts_next_i64(TS_GLOBAL i64 *p);
u32 ts_next_u32(TS_GLOBAL u32 *p);
void ts_mark_u8(TS_GLOBAL u8 *p);

#define TS_PARTED(type, name) TS_GLOBAL type *restrict name
#define ts_at(array, i) (&(array)[i])
#define TS_ASSERT_SIZE(type, bytes) typedef u8 type##_is_packed[bytes]

#endif

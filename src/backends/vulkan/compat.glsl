// The kernels' primitives in GLSL: what kernels/base/compat.h is to C, OpenCL C and CUDA C.
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_buffer_reference2 : require
#extension GL_EXT_shader_explicit_arithmetic_types_int8 : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#extension GL_EXT_shader_atomic_int64 : require
#extension GL_KHR_memory_scope_semantics : require

layout(buffer_reference, scalar, buffer_reference_align = 4) buffer f32_ref { float v; };
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer i32_ref { int v; };
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer u32_ref { uint v; };
layout(buffer_reference, scalar, buffer_reference_align = 8) buffer i64_ref { int64_t v; };
layout(buffer_reference, scalar, buffer_reference_align = 8) buffer u64_ref { uint64_t v; };
layout(buffer_reference, scalar, buffer_reference_align = 1) buffer u8_ref { uint8_t v; };

uint ts_f2u(float x) { return floatBitsToUint(x); }
float ts_u2f(uint u) { return uintBitsToFloat(u); }
float ts_floor(float x) { return floor(x); }
// int64_t(x): whose comparisons with constants Mesa 22.3 (NIR) gets wrong.
int64_t ts_i64(int x) { return int64_t(packUint2x32(uvec2(uint(x), uint(x >> 31)))); }

#define TS_PEEK(p) atomicLoad(p.v, gl_ScopeDevice, gl_StorageSemanticsBuffer, gl_SemanticsRelaxed)
// Reading first and skipping what is not smaller is safe, because the value only ever falls.
void ts_min_u64(u64_ref p, uint64_t v)
{
	if (v < TS_PEEK(p)) atomicMin(p.v, v);
}
void ts_min_u32(u32_ref p, uint v)
{
	if (v < TS_PEEK(p)) atomicMin(p.v, v);
}
uint ts_peek_u32(u32_ref p) { return TS_PEEK(p); }
// The same of bits, which are only ever set.
void ts_or_u64(u64_ref p, uint64_t v)
{
	if ((v & ~TS_PEEK(p)) != 0ul) atomicOr(p.v, v);
}
void ts_add_i64(i64_ref p, int64_t v) { atomicAdd(p.v, v); }
int64_t ts_next_i64(i64_ref p) { return atomicAdd(p.v, 1l); }
uint ts_next_u32(u32_ref p) { return atomicAdd(p.v, 1u); }
// 1, whoever else says so at the same time: a byte of a word that others set bytes of.
void ts_mark_u8(u8_ref p)
{
	uint64_t at = uint64_t(p);
	atomicOr(u32_ref(at & ~3ul).v, 1u << (8u * uint(at & 3ul)));
}

// What may be larger than a device allocates at once is in parts of 1 << TS_PART_SHIFT bytes, and `base` leads to their
// addresses; or in one, if TS_PART_SHIFT is 0.
layout(constant_id = 1) const uint TS_PART_SHIFT = 0;
uint64_t ts_address(uint64_t base, uint64_t offset)
{
	if (TS_PART_SHIFT == 0) return base + offset;
	return (u64_ref(base) + (offset >> TS_PART_SHIFT)).v + (offset & ((1ul << TS_PART_SHIFT) - 1ul));
}
#define TS_PART(ref, base, i, bytes) ref(ts_address(uint64_t(base), uint64_t(i) * bytes))

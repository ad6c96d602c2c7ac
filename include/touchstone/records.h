/* SPDX-License-Identifier: Apache-2.0 */
/* The records of records.def as structs: what the elements of buffers are. */
#ifndef TOUCHSTONE_RECORDS_H
#define TOUCHSTONE_RECORDS_H
#ifndef TS_HAS_RECORDS /* src/kernels/base/records.h has them, too */
#define TS_HAS_RECORDS
#include <stdint.h>

#define TS_RECORD_TYPE_f32 float
#define TS_RECORD_TYPE_i32 int32_t
#define TS_RECORD_TYPE_u32 uint32_t
#define TS_RECORD_TYPE_u64 uint64_t
#define TS_RECORD_COUNT_1
#define TS_RECORD_COUNT_2 [2]
#define TS_RECORD_COUNT_3 [3]
#define TS_RECORD_COUNT_4 [4]
#define TS_RECORD_COUNT_5 [5]
#define TS_RECORD_COUNT_6 [6]
#define TS_RECORD_COUNT_9 [9]
/* A program may have macros of these names, and keeps them. */
#pragma push_macro("RECORD")
#pragma push_macro("FIELD")
#pragma push_macro("RECORD_END")
#pragma push_macro("DIM")
#pragma push_macro("SUM")
#pragma push_macro("INDEX")
#pragma push_macro("BUFFER")
#undef RECORD
#undef FIELD
#undef RECORD_END
#undef DIM
#undef SUM
#undef INDEX
#undef BUFFER
#define RECORD(name, doc) typedef struct {
#define FIELD(type, name, count, doc) TS_RECORD_TYPE_##type name TS_RECORD_COUNT_##count;
#define RECORD_END(name, bytes) \
	} \
	name;
#include <touchstone/records.def>
#pragma pop_macro("RECORD")
#pragma pop_macro("FIELD")
#pragma pop_macro("RECORD_END")
#pragma pop_macro("DIM")
#pragma pop_macro("SUM")
#pragma pop_macro("INDEX")
#pragma pop_macro("BUFFER")
#undef TS_RECORD_TYPE_f32
#undef TS_RECORD_TYPE_i32
#undef TS_RECORD_TYPE_u32
#undef TS_RECORD_TYPE_u64
#undef TS_RECORD_COUNT_1
#undef TS_RECORD_COUNT_2
#undef TS_RECORD_COUNT_3
#undef TS_RECORD_COUNT_4
#undef TS_RECORD_COUNT_5
#undef TS_RECORD_COUNT_6
#undef TS_RECORD_COUNT_9
#endif

/* An index that names nothing. */
#define TS_NO_INDEX 0xffffffffu

/* Bits of ts_material.flags. */
enum { TS_MATERIAL_DOUBLE_SIDED = 1, TS_MATERIAL_MASKED = 2, TS_MATERIAL_UNLIT = 4 };

/* Places in ts_material.slot. */
enum { TS_TEXTURE_BASE, TS_TEXTURE_METALLIC_ROUGHNESS, TS_TEXTURE_NORMAL, TS_TEXTURE_OCCLUSION, TS_TEXTURE_EMISSIVE };

/* Values of ts_slot.wrap, and of ts_light.kind. */
enum { TS_WRAP_REPEAT, TS_WRAP_MIRRORED_REPEAT, TS_WRAP_CLAMP_TO_EDGE };
enum { TS_LIGHT_DIRECTIONAL, TS_LIGHT_POINT, TS_LIGHT_SPOT };

#endif

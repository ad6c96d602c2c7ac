/* Fields of the elements of buffers: comparing and printing their values. */
#ifndef TS_TRACE_FIELD_H
#define TS_TRACE_FIELD_H
#include "model/frame.h"

/* What stands for an index of the candidate that names no point of the reference. */
#define TS_NO_PARTNER 0xfffffffeu

enum { TS_MAX_FIELDS = 24, TS_VALUE_TEXT = 96 };

/* A field of a buffer's elements; of scalars the one field is called "". */
typedef struct {
	const char *name;
	char kind;         /* f: f32; i: i32; u: u8, u32 or u64 */
	u32 count;         /* components */
	u32 bytes;         /* of one component */
	u32 offset;        /* in the element */
	const ts_axis *of; /* of an index: the size that bounds it; NULL: the field is no index */
	bool none;         /* the index may also be 0xffffffff */
	bool distance;     /* of 64 bits: the upper half has the bits of a distance, the lower half an index */
} ts_field;

typedef struct {
	ts_field field[TS_MAX_FIELDS];
	u32 n;
} ts_fields;

ts_fields ts_fields_of(ts_buffer_id id);
/* True if the field is an index below size `dim`. */
bool ts_field_names(const ts_field *field, ts_dim dim);

/* The bits of a component of the element at `data`. */
u64 ts_field_bits(const ts_field *field, const void *data, u32 component);

/* Steps between floats from the first to the second, with -0 and +0 one step apart; INT64_MAX if either is a NaN. */
i64 ts_field_ulps(u64 from, u64 to);
bool ts_field_is_nan(u64 bits);

/* "3 = 0x1.8p+1 (40400000)", "812 (0000032c)"; 64 bits with an index in the lower half: with a distance over it
 * "3.5 | 812 (40600000_0000032c)", otherwise "7 | 812 (00000007_0000032c)". */
void ts_field_show(char text[TS_VALUE_TEXT], const ts_field *field, u64 bits);

/* "centre[2]", "s", or "" of a scalar. */
void ts_field_name(char text[64], const ts_field *field, u32 component);

#endif

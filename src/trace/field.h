/* The fields of a buffer's elements, with where they lie: for code that walks any buffer value by value. */
#ifndef TS_TRACE_FIELD_H
#define TS_TRACE_FIELD_H
#include "../core/frame.h"

enum { TS_MAX_FIELDS = 16 };

typedef enum { TS_TYPE_F32, TS_TYPE_I32, TS_TYPE_U32, TS_TYPE_U64, TS_TYPE_U8 } ts_type;

typedef struct {
	const char *name; /* "" if the element is one scalar */
	ts_type type;
	u32 count;        /* components */
	size_t at;        /* bytes before it in the element */
} ts_field;

/* Writes the fields of an element of buffer `id`, in order, and returns how many there are. Together they are the whole
 * element: records have no hidden padding. */
u32 ts_field_list(ts_field fields[TS_MAX_FIELDS], ts_buffer_id id);
/* Bytes of one component. */
size_t ts_type_bytes(ts_type type);

#endif

/* Where two arrays of a buffer's elements first differ. Bits decide: -0 is not 0, and a NaN is the same as itself. */
#ifndef TS_TRACE_SAME_H
#define TS_TRACE_SAME_H
#include "field.h"

/* A place in a buffer: a component of a field of an element. */
typedef struct {
	u64 element;
	ts_field field;
	u32 component; /* of field.count */
} ts_place;

enum { TS_VALUE_TEXT = 96, TS_PLACE_TEXT = 96, TS_SAME_TEXT = 400 };

/* True if n elements of buffer `id` are the same in a and b; else *first is the first place where they are not. a and b
 * need no alignment. */
bool ts_same_find(ts_place *first, ts_buffer_id id, const void *a, const void *b, u64 n);

/* A value as text, in decimal, as hexadecimal float and as bits: "3.14 (0x1.91eb86p+1, 4048f5c3)", "17 (00000011)". The
 * value needs no alignment. */
void ts_value_print(char text[TS_VALUE_TEXT], ts_type type, const void *value);
/* A place as text: "element 12, field centre[1]", "element 3". */
void ts_place_print(char text[TS_PLACE_TEXT], const ts_place *place);
/* Place and both values as one line, without the buffer's name: "element 12, field s: 0.5 (...) here, 0.25 (...)
 * there". `here` and `there` say whose values these are, cut at 40 bytes each; a and b are the two elements at the
 * place. */
void ts_same_print(char text[TS_SAME_TEXT], const ts_place *place, const char *here, const void *a, const char *there,
                   const void *b);

#endif

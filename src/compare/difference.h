/* One place where a candidate differs from its reference, and the texts for the place and its values. */
#ifndef TS_COMPARE_DIFFERENCE_H
#define TS_COMPARE_DIFFERENCE_H
#include "trace/field.h"
#include "trace/where.h"

typedef enum {
	TS_UNEQUAL,
	TS_LACKED, /* a record of a set that the candidate lacks */
	TS_BESIDE, /* a record that only the candidate has */
	TS_TWICE,  /* a record that the candidate has twice */
} ts_how_unlike;

/* Prefix sums (SUM of records.def) differ by their counts, each the difference of a sum and the sum before it. A wrong
 * count moves all sums behind it, and only the count itself is wrong. */
typedef struct {
	ts_how_unlike how;
	u64 element; /* in the reference's order; of a count the sum after it; of TS_BESIDE and TS_TWICE the candidate's */
	u32 field, component;
	u64 ref, cand; /* bits; an index of the candidate is mapped to the reference's order; a count, as an i64; of
	                  TS_BESIDE and TS_TWICE `cand` is the key */
} ts_difference;

/* A difference, and its place: "pixel (12, 40)". */
typedef struct {
	ts_difference difference;
	char where[TS_WHERE_TEXT];
} ts_named;

/* The first differences of a buffer, in memory that the caller owns; all zero: none are wanted. */
typedef struct {
	ts_named *items;
	u32 n, most;
} ts_differences;

/* Adds a difference, and names its place while the reference is open. Does nothing if the list is full. TS_ERROR with
 * the message set: the place cannot be read. */
ts_status ts_differences_add(ts_differences *list, const ts_trace *reference, ts_buffer_id id,
                             const ts_difference *difference);

/* "pixel (12, 40)", "key (piece 812, x 5, y 3)", "count of piece 17 (element 18 less element 17)". Without a reference,
 * NULL, an element has its number only: "element 12", which cannot fail. */
ts_status ts_difference_where(char text[TS_WHERE_TEXT], const ts_trace *reference, ts_buffer_id id,
                              const ts_difference *difference);
/* The text of one of the two values, `bits`, by ts_field_show; of a count the number. */
void ts_difference_show(char text[TS_VALUE_TEXT], ts_buffer_id id, const ts_difference *difference, u64 bits);
/* The field of a difference, "normal[1]"; "" for a scalar. */
void ts_difference_field(char text[64], ts_buffer_id id, const ts_difference *difference);

#endif

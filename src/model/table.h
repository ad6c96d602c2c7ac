/* The rows of records.def: buffers, the fields of their elements, prefix sums, and what indices are of. */
#ifndef TS_MODEL_TABLE_H
#define TS_MODEL_TABLE_H
#include <touchstone/tables.h>
#include "kernels/base/records.h"
#include "model/shape.h"

#define BUFFER(id, name, element, shape, order, key, doc) TS_B_##id,
typedef enum {
#include <touchstone/records.def>
	TS_N_BUFFERS,
	TS_B_none = TS_N_BUFFERS,
} ts_buffer_id;

/* The BUFFER rows. */
extern const ts_buffer_info ts_buffer_table[TS_N_BUFFERS];

const ts_shape *ts_buffer_shape(ts_buffer_id id);
/* ts_axis_counts of the first dimension of a buffer. */
ts_dim ts_buffer_counts(ts_buffer_id id);
/* The size that follows from the first dimension of a buffer, unless parameters give that size; otherwise
 * TS_DIM_none. */
ts_dim ts_buffer_gives(ts_buffer_id id);

/* The FIELD rows. */
const ts_field_info *ts_field_table(size_t *n);
/* Bytes of a number of a type: `type` of a field, or the type of an element that is no record. */
size_t ts_type_bytes(const char *type);

/* One SUM row. */
typedef struct {
	ts_buffer_id buffer;
	ts_dim size;
	const char *what;
} ts_sum_info;
const ts_sum_info *ts_sum_table(size_t *n);
const ts_sum_info *ts_sum_of(ts_buffer_id id);

/* One INDEX row; `of` is its text `size`, read. */
typedef struct {
	ts_buffer_id buffer;
	const char *field, *size;
	bool none;
	ts_axis of;
} ts_index_info;
const ts_index_info *ts_index_table(size_t *n);

#endif

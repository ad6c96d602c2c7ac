/* The records of a candidate in the order of arrival, matched with those of the reference. */
#ifndef TS_COMPARE_ORDER_H
#define TS_COMPARE_ORDER_H
#include "compare/difference.h"

/* Whether a buffer's records are identified by a key, and may be in any order. */
bool ts_order_is_set(ts_buffer_id id);
/* The buffer of the keys; TS_N_BUFFERS: the buffer is no set. */
ts_buffer_id ts_order_key_of(ts_buffer_id id);
/* The keys of the points, to which other buffers refer by index, and their size; TS_N_BUFFERS and TS_DIM_none: no
 * family has any. */
ts_buffer_id ts_order_key(void);
ts_dim ts_order_of(void);
/* Whether a buffer holds points or indices of points. */
bool ts_order_is_of_points(ts_buffer_id id);

typedef struct {
	bool given; /* false: both stand in the same order, and the arrays are NULL */
	ts_buffer_id key;
	u64 n_ref, n_cand;
	u32 *cand_of_ref;       /* the candidate's index of each record; TS_NONE: it lacks the record */
	u32 *ref_of_cand;       /* the reverse; TS_NO_PARTNER: the key came before */
	u64 n_missing, n_extra; /* keys that the candidate lacks, and keys that it has in addition or twice */
} ts_order;

/* Finds the order of the records of `key`, a buffer of keys; TS_N_BUFFERS: of none. A candidate without the buffer
 * keeps its order. So does a candidate in canonical order if the keys are of points, or do not ascend. The reference's
 * keys must ascend. Release by ts_order_free, also on failure. */
ts_status ts_order_make(ts_order *order, ts_buffer_id key, const ts_trace *reference, const ts_trace *candidate);
void ts_order_free(ts_order *order);

/* Lists the records of set `id` without a partner: those that are missing, then the others, both by their keys. */
ts_status ts_order_unmet(ts_differences *list, const ts_order *order, ts_buffer_id id, const ts_trace *reference,
                         const ts_trace *candidate);

/* The reference's index for one of the candidate's; one that names nothing stays out of range. */
u32 ts_order_map(const ts_order *order, u32 index);
/* Maps the indices in a field of n elements, element_bytes apart: 32-bit numbers or lower halves of 64-bit keys. */
void ts_order_map_field(const ts_order *order, const ts_field *field, u8 *elements, u64 n, size_t element_bytes);

/* Gives the records of a candidate, which are in the order of arrival, in the order of the reference. The file is read
 * once for each window of memory; windows grow with the number of records, so that there are never many. */

typedef struct ts_gather ts_gather;

/* Opens a set of the candidate, which has as many records as `order` says; `order` must stay. NULL with the message set
 * on failure. */
ts_gather *ts_gather_open(const ts_trace_item *item, ts_buffer_id id, const ts_order *order);
/* The candidate's records for those of the reference from `first` on, *n of them, at least 1; the bytes of one that it
 * lacks are 0. Valid until the next call; cheap while `first` ascends. NULL with the message set if the file cannot be
 * read. */
const void *ts_gather_at(ts_gather *gather, u64 first, u64 *n);
/* NULL is allowed. */
void ts_gather_close(ts_gather *gather);

#endif

/* Gives the records of a candidate, which are in the order of arrival, in the order of the reference. The file is read
 * once for each window of memory; windows grow with the number of records, so that there are never many. */
#ifndef TS_COMPARE_GATHER_H
#define TS_COMPARE_GATHER_H
#include "compare/order.h"

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

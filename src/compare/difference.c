/* Differences in words. */
#include "compare/difference.h"
#include <inttypes.h>
#include <stdio.h>

static ts_status where_element(char text[TS_WHERE_TEXT], const ts_trace *reference, ts_buffer_id id, u64 element)
{
	if (reference != NULL) return ts_where(text, reference, id, element);
	snprintf(text, TS_WHERE_TEXT, "element %" PRIu64, element);
	return TS_OK;
}

static ts_status where_count(char text[TS_WHERE_TEXT], const ts_trace *reference, ts_buffer_id id, u64 sum)
{
	char counted[TS_WHERE_TEXT];
	if (sum == 0) {
		snprintf(text, TS_WHERE_TEXT, "element 0, where the sums begin");
		return TS_OK;
	}
	ts_status status = where_element(counted, reference, id, sum - 1);
	snprintf(text, TS_WHERE_TEXT, "count of %.50s (element %" PRIu64 " less element %" PRIu64 ")", counted, sum,
	         sum - 1);
	return status;
}

ts_status ts_difference_where(char text[TS_WHERE_TEXT], const ts_trace *reference, ts_buffer_id id,
                              const ts_difference *d)
{
	if (d->how == TS_BESIDE || d->how == TS_TWICE) {
		ts_where_key(text, id, d->cand);
		return TS_OK;
	}
	if (ts_sum_of(id) != NULL) return where_count(text, reference, id, d->element);
	return where_element(text, reference, id, d->element);
}

ts_status ts_differences_add(ts_differences *list, const ts_trace *reference, ts_buffer_id id, const ts_difference *d)
{
	if (list->n == list->most) return TS_OK;
	list->items[list->n].difference = *d;
	return ts_difference_where(list->items[list->n++].where, reference, id, d);
}

void ts_difference_show(char text[TS_VALUE_TEXT], ts_buffer_id id, const ts_difference *d, u64 bits)
{
	const ts_fields fields = ts_fields_of(id);
	if (ts_sum_of(id) != NULL) {
		snprintf(text, TS_VALUE_TEXT, "%" PRId64, (i64)bits);
	} else {
		ts_field_show(text, &fields.field[d->field], bits);
	}
}

void ts_difference_field(char text[64], ts_buffer_id id, const ts_difference *d)
{
	const ts_fields fields = ts_fields_of(id);
	ts_field_name(text, &fields.field[d->field], d->component);
}

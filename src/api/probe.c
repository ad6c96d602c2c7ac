/* Questions about a trace. */
#include <assert.h>
#include <pthread.h>
#include <touchstone/probe.h>
#include "api/api.h"
#include "probe/probe.h"

static ts_status ask(const ts_context *context, ts_tree **answer, const ts_trace *trace, const ts_probe_question *q)
{
	ts_probe *probe;
	json_t *root = NULL;
	if (TS_LACKS(answer)) return TS_ERROR;
	*answer = NULL;
	if (TS_LACKS(context) || TS_LACKS(trace) || ts_api_enter(context) != TS_OK) return TS_ERROR;
	ts_status status = ts_probe_open(&probe, trace);
	if (status == TS_OK) status = ts_probe_ask(probe, q, &root);
	ts_probe_close(probe);
	ts_api_leave();
	*answer = (ts_tree *)root;
	return status;
}

ts_status ts_probe_pixel(ts_context *context, ts_tree **answer, const ts_trace *trace, uint32_t x, uint32_t y,
                         const char *view)
{
	const ts_probe_question q = {
		.subject = view != NULL ? TS_PROBE_TEXEL : TS_PROBE_PIXEL, .x = x, .y = y, .view = view};
	return ask(context, answer, trace, &q);
}

ts_status ts_probe_triangle(ts_context *context, ts_tree **answer, const ts_trace *trace, uint64_t triangle)
{
	const ts_probe_question q = {.subject = TS_PROBE_TRIANGLE, .index = triangle};
	return ask(context, answer, trace, &q);
}

ts_status ts_probe_point(ts_context *context, ts_tree **answer, const ts_trace *trace, uint64_t point)
{
	const ts_probe_question q = {.subject = TS_PROBE_POINT, .index = point};
	return ask(context, answer, trace, &q);
}

ts_status ts_probe_point_key(ts_context *context, ts_tree **answer, const ts_trace *trace, const int64_t key[3])
{
	const ts_probe_question q = {.subject = TS_PROBE_POINT, .index = key != NULL ? (u64)key[0] : 0, .key = key};
	if (TS_LACKS(key)) return TS_ERROR;
	return ask(context, answer, trace, &q);
}

typedef struct {
	ts_probe_info info;
	char methods[TS_PROBE_TEXT];
} row;

enum { MOST_ROWS = 64 };
static row rows[MOST_ROWS];
static size_t n_rows;

/* By subject, in the order of the families. */
static void make(void)
{
	const ts_probe_part *part;
	ts_api_ready();
	for (u32 subject = 0; subject < TS_N_PROBE_SUBJECTS; subject++) {
		for (u32 i = 0; (part = ts_probe_part_at(i)) != NULL; i++) {
			if (part->subject != subject) continue;
			assert(n_rows < MOST_ROWS);
			row *r = &rows[n_rows++];
			ts_probe_methods(r->methods, part);
			r->info = (ts_probe_info){ts_probe_option(subject), r->methods, part->view != NULL ? part->view->form : "",
			                          part->reports};
		}
	}
}

const ts_probe_info *ts_probe_at(size_t i)
{
	static pthread_once_t once = PTHREAD_ONCE_INIT;
	pthread_once(&once, make);
	return i < n_rows ? &rows[i].info : NULL;
}

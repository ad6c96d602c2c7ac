/* Questions about a trace. */
#include "api.h"
#include <touchstone/probe.h>
#include "../probe/probe.h"

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

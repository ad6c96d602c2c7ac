/* A small run that the tests of a program share: its group's set-up and tear-down. */
#ifndef TS_TESTS_API_RUN_H
#define TS_TESTS_API_RUN_H
#include "tests/api/api.h"

static ts_context *context;
static ts_params *params;
static ts_scene *scene;
static ts_trace *reference; /* by EPR */

/* A host that is asked whether it cancels. */
typedef struct {
	int asked, end_at; /* at which time it says yes, 0: never */
} ending_host;

static inline int asked_to_end(void *user)
{
	ending_host *h = user;
	return ++h->asked == h->end_at;
}

static inline int run_begin(void **state)
{
	(void)state;
	context = open_context(2);
	params = small_params();
	scene = small_scene(context, params);
	reference = small_trace(context, scene, params, "epr");
	return 0;
}

static inline int run_end(void **state)
{
	(void)state;
	ts_trace_close(reference);
	ts_scene_free(scene);
	ts_params_free(params);
	ts_context_close(context);
	return 0;
}

/* Gives a candidate such a buffer; the data are the caller's. */
static inline void put(ts_trace *candidate, const ts_buffer_view *view, const void *data)
{
	done(ts_trace_put(candidate, view->name, view->n_dims, view->shape, data, bytes_of(view)));
}

/* A candidate with every buffer of a trace, as it is. */
static inline ts_trace *candidate_of(ts_trace *trace, int arrival)
{
	ts_trace *candidate;
	const ts_buffer_info *buffer;
	done(ts_trace_candidate(context, &candidate, trace, arrival));
	for (size_t i = 0; (buffer = ts_buffer_at(i)) != NULL; i++) {
		if (!ts_trace_has(trace, buffer->name)) continue;
		const ts_buffer_view *view = ts_trace_buffer(trace, buffer->name);
		put(candidate, view, view->data);
	}
	return candidate;
}

#endif

/* What the tests of the public API share: small runs, by its headers alone. */
#ifndef TS_TESTS_API_API_H
#define TS_TESTS_API_API_H
#include <stdbool.h>
#include <touchstone/touchstone.h>
#include "tests/model/test.h"

#define SMALL "atrium:triangles=10000:texels=32"
enum { FOLDER = 128, PATH = FOLDER + 64 };

static inline void done(ts_status status)
{
	if (status != TS_OK) fail_msg("%s", ts_error_message());
}

/* Fails unless it was refused with a message that has these words. */
static inline void refused(ts_status status, const char *words)
{
	assert_int_equal(status, TS_ERROR);
	if (strstr(ts_error_message(), words) == NULL) fail_msg("\"%s\" does not say \"%s\"", ts_error_message(), words);
}

static inline ts_context *open_context(uint32_t threads)
{
	ts_context *context;
	done(ts_context_open(&context, &(ts_context_options){.bytes = sizeof(ts_context_options), .threads = threads}));
	return context;
}

static inline ts_params *small_params(void)
{
	static const char *const small[][2] = {
		{"width", "64"},        {"height", "36"},    {"reflectors.count", "3"},  {"reflectors.px", "16"},
		{"cube.max_px", "16"},  {"lamp.views", "7"}, {"lamp.views_a_pass", "2"}, {"lamp.cubes", "3"},
		{"depth_map.px", "24"}, {"rsm.px", "6"},     {"depth_grid.px", "64"},    {"octree.levels", "4"}};
	ts_params *params;
	done(ts_params_make(&params));
	for (size_t i = 0; i < sizeof small / sizeof *small; i++) done(ts_params_set(params, small[i][0], small[i][1]));
	return params;
}

static inline ts_scene *small_scene(ts_context *context, const ts_params *params)
{
	ts_scene *scene;
	done(ts_scene_open(context, &scene, SMALL, params, NULL));
	return scene;
}

static inline ts_trace *small_trace(ts_context *context, const ts_scene *scene, const ts_params *params,
                                    const char *method)
{
	ts_trace *trace;
	done(ts_trace_run(context, &trace, scene, params, "reflections", method, NULL));
	return trace;
}

/* A new folder where temporary files go. */
static inline void make_folder(char folder[FOLDER])
{
	const char *where = getenv("TMPDIR");
	snprintf(folder, FOLDER, "%.80s/ts-api-XXXXXX", where != NULL ? where : "/tmp");
	assert_non_null(mkdtemp(folder));
}

static inline void remove_folder(const char *folder)
{
	char command[PATH + 16];
	snprintf(command, sizeof command, "rm -rf '%.*s'", PATH, folder);
	assert_int_equal(system(command), 0);
}

/* Elements of a view, and the bytes that they take. */
static inline size_t count_of(const ts_buffer_view *view)
{
	size_t n = 1;
	for (uint32_t i = 0; i < view->n_dims; i++) n *= (size_t)view->shape[i];
	return n;
}
static inline size_t bytes_of(const ts_buffer_view *view) { return count_of(view) * view->element_bytes; }

#endif

/* Traces of small runs. */
#ifndef TS_TESTS_TRACE_SMALL_H
#define TS_TESTS_TRACE_SMALL_H
#include "methods/pipeline.h"
#include "tests/trace/folder.h"
#include "trace/write.h"

#define SMALL_SCENE "atrium:triangles=10000:texels=32"

/* The files that a trace was given, in order. */
typedef struct {
	const char *dir;
	char paths[TS_N_BUFFERS + 1][2 * SCRATCH_PATH];
	u32 n;
} small_place;

static inline const char *small_take(void *user, const char *name)
{
	small_place *place = user;
	assert_true(place->n < TS_N_BUFFERS + 1);
	snprintf(place->paths[place->n], sizeof place->paths[0], "%s/%s", place->dir, name);
	return place->paths[place->n++];
}

static inline ts_params small_params(void)
{
	ts_params p;
	ts_params_default(&p);
	p.width = 64;
	p.height = 36;
	p.reflectors_count = 3;
	p.lookup_bounces = 3;
	p.reflectors_px = 20;
	p.cube_max_px = 32;
	return p;
}

static inline ts_scene *small_scene(const ts_params *params)
{
	ts_scene *scene;
	if (ts_scene_load(&scene, SMALL_SCENE, params, NULL) != TS_OK) fail_msg("%s", ts_error_message());
	return scene;
}

static inline ts_status small_stage(const ts_run *run, const ts_stage *stage, void *user)
{
	return ts_trace_write_stage(user, run, stage);
}

/* Traces one run to a new folder. */
static inline void small_trace(const char *dir, const char *method, const ts_scene *scene, const ts_params *params,
                               ts_trace_options options)
{
	ts_run run;
	ts_trace_writer *writer;
	small_place *place = calloc(1, sizeof *place);
	assert_non_null(place);
	place->dir = dir;
	assert_int_equal(mkdir(dir, 0777), 0);
	options.place = small_take;
	options.user = place;
	const ts_pipeline *pipeline = ts_pipeline_find("reflections", method);
	ts_run_begin(&run, scene, params, 2);
	run.traced = run.lean = true;
	ts_status status = ts_trace_write_begin(&writer, pipeline, &run, &options);
	run.hook = small_stage;
	run.hook_user = writer;
	if (status == TS_OK) status = ts_pipeline_run(pipeline, &run);
	if (status == TS_OK) status = ts_trace_write_end(writer, &run);
	if (status != TS_OK) fail_msg("%s", ts_error_message());
	ts_trace_write_free(writer);
	ts_run_end(&run);
	free(place);
}

static inline void small_copy(const char *to, const char *from)
{
	char command[4 * SCRATCH_PATH];
	snprintf(command, sizeof command, "rm -rf '%s' && cp -r '%s' '%s'", to, from, to);
	assert_int_equal(system(command), 0);
}

/* The text of trace.json after `change`, which gets its root. */
static inline void small_edit(const char *dir, void (*change)(json_t *root, const void *user), const void *user)
{
	char path[2 * SCRATCH_PATH];
	snprintf(path, sizeof path, "%s/trace.json", dir);
	json_t *root = json_load_file(path, 0, NULL);
	assert_non_null(root);
	change(root, user);
	assert_int_equal(json_dump_file(root, path, 0), 0);
	json_decref(root);
}

#endif

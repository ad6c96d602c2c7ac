/* What the tests of the stages share: small runs of both methods on the atrium. */
#ifndef TS_TESTS_STAGES_SMALL_H
#define TS_TESTS_STAGES_SMALL_H
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "../../src/kernels/samples.h"
#include "../../src/pipelines/pipeline.h"

#define SMALL_SCENE "atrium:triangles=10000"

static inline ts_params small_params(u32 width, u32 height)
{
	ts_params params;
	ts_params_default(&params);
	params.width = width;
	params.height = height;
	return params;
}

static inline ts_scene *small_scene(const ts_params *params)
{
	ts_scene *scene;
	if (ts_scene_open(&scene, SMALL_SCENE, params, NULL) != TS_OK) fail_msg("%s", ts_error_message());
	return scene;
}

/* Runs a method to its end; the frame stays until ts_run_end. */
static inline void small_run(ts_run *run, const ts_scene *scene, const ts_params *params, const char *method, u32 threads,
                             ts_stage_hook hook, void *user)
{
	ts_run_begin(run, scene, params, threads);
	run->hook = hook;
	run->hook_user = user;
	ts_status status = ts_pipeline_run(ts_pipeline_find("reflections", method), run);
	if (status != TS_OK) fail_msg("%s: %s", method, ts_error_message());
}

#endif

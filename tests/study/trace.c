/* What --trace-only and --crop leave of a trace, and traces that a disk has no room for. */
#include "methods/stages.h"
#include "study/trace.h"
#include "tests/trace/small.h"

static const ts_pipeline *epr(void) { return ts_pipeline_find("reflections", "epr"); }

static ts_status made(ts_tracing *tracing, const char *only, const char *crop)
{
	ts_job job = {.output = {.trace = true, .trace_only = only, .crop = crop}};
	job.params = small_params();
	return ts_tracing_make(tracing, &job, epr());
}

static void only_named_stages_are_traced(void **state)
{
	(void)state;
	ts_tracing tracing;
	assert_int_equal(made(&tracing, NULL, NULL), TS_OK);
	assert_string_equal(tracing.folder, "trace-epr");
	for (u32 id = 0; id < TS_N_BUFFERS; id++) assert_false(tracing.options.without[id]);
	assert_int_equal(made(&tracing, "eye,scene", NULL), TS_OK);
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		bool scene = strncmp(ts_buffer_table[id].name, "scene.", 6) == 0;
		assert_int_equal(tracing.options.without[id],
		                 !scene && !ts_stage_writes(ts_stage_find("eye"), (ts_buffer_id)id));
	}
	assert_int_equal(made(&tracing, "eye,splat9", NULL), TS_ERROR);
	says("--trace-only: \"splat9\" is no stage of epr");
}

static void wrong_crops_are_refused(void **state)
{
	(void)state;
	static const char *const bad[] = {"0,0,65,36", "1,0,64,36", "0,1,64,36", "0,0,0,5",
	                                  "0,0,5,0",   "1,2,3",     "1,2,3,4,5"};
	ts_tracing tracing;
	assert_int_equal(made(&tracing, NULL, "3,4,61,32"), TS_OK);
	const u32 right[4] = {3, 4, 61, 32};
	assert_memory_equal(tracing.options.crop, right, sizeof right);
	assert_int_equal(made(&tracing, NULL, "0,0,64,36"), TS_OK);
	for (u32 i = 0; i < sizeof bad / sizeof *bad; i++) {
		assert_int_equal(made(&tracing, NULL, bad[i]), TS_ERROR);
		says("--crop");
	}
}

/* There is room for a small run, also where the folder is not there yet, and none for more than any disk holds. */
static void traces_without_room_are_refused(void **state)
{
	(void)state;
	static const char *const folders[] = {"a/b/c", "", "a", "a//b/"};
	ts_tracing tracing;
	ts_params params = small_params(), large = small_params();
	ts_scene *scene = small_scene(&params);
	const ts_pipeline *method = epr();
	large.width = large.height = 16384;
	assert_int_equal(made(&tracing, NULL, NULL), TS_OK);
	for (u32 i = 0; i < 4; i++) {
		assert_int_equal(ts_tracing_check(&tracing, &method, 1, scene, &params, scratch_path("%s", folders[i])), TS_OK);
	}
	assert_int_equal(ts_tracing_check(&tracing, &method, 1, scene, &params, "no/such/folder"), TS_OK);
	enum { MANY = 400 };
	static ts_tracing tracings[MANY];
	static const ts_pipeline *methods[MANY];
	for (u32 i = 0; i < MANY; i++) {
		tracings[i] = tracing;
		methods[i] = method;
	}
	assert_int_equal(ts_tracing_check(tracings, methods, MANY, scene, &large, scratch_path("a/b")), TS_ERROR);
	says("the traces need about");
	for (u32 i = 0; i < MANY; i++) tracings[i].options.compress = true;
	assert_int_equal(ts_tracing_check(tracings, methods, MANY, scene, &large, scratch_path("a/b")), TS_OK);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(only_named_stages_are_traced),
	                                   cmocka_unit_test(wrong_crops_are_refused),
	                                   cmocka_unit_test(traces_without_room_are_refused)};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_end);
}

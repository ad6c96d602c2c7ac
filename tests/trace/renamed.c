/* Traces, layouts, files and lists of names with the names of before, of a planted table. */
#include <sys/stat.h>
#include "small.h"
#include "../model/said.h"
#include "../../src/compare/compare.h"
#include "../../src/model/renamed.h"
#include "../../src/replay/replay.h"
#include "../../src/trace/read.h"

static const ts_renamed planted[] = {
	{TS_NAME_buffer, "keys.of_points", "points.key"},
	{TS_NAME_buffer, "picture", "image.srgb"},
	{TS_NAME_param, "width_px", "width"},
	{TS_NAME_stage, "splats", "splat"},
	{0},
};

static char dir[SCRATCH_PATH];

static int begin(void **state)
{
	static const char text[] =
		"{\"format\": \"touchstone-trace\", \"version\": 1, \"contract\": 1, \"order\": \"canonical\","
		"\"effect\": \"reflections\", \"pipeline\": \"epr\", \"params\": {\"width_px\": \"64\"}, \"buffers\": ["
		"{\"name\": \"keys.of_points\", \"file\": \"k.npy\"}, {\"name\": \"picture\", \"file\": \"s.npy\"}]}";
	char data[24] = {0};
	if (scratch_begin(state) != 0) return -1;
	snprintf(dir, sizeof dir, "%s", scratch_path("trace"));
	mkdir(dir, 0777);
	file_write(scratch_path("trace/trace.json"), text, sizeof text - 1);
	npy_write(scratch_path("trace/k.npy"), "'<u8'", "(3,)", data, 24);
	npy_write(scratch_path("trace/s.npy"), "'|u1'", "(2, 4, 3)", data, 24);
	npy_write(scratch_path("trace/11-keys.of_points.npy"), "'<u8'", "(3,)", data, 24);
	return 0;
}

static int end(void **state)
{
	ts_renamed_use(NULL);
	return scratch_remove(state);
}

static void old_names_are_none_without_the_table(void **state)
{
	(void)state;
	ts_trace *t;
	assert_int_equal(ts_trace_open_folder(&t, dir), TS_ERROR);
	says("no buffer \"keys.of_points\"");
}

/* One line for the whole of a trace. */
static void a_trace_says_one_line(void **state)
{
	(void)state;
	ts_trace *t;
	ts_renamed_use(planted);
	said_begin();
	ts_status status = ts_trace_open_folder(&t, dir);
	const char *said = said_end();
	assert_int_equal(status, TS_OK);
	assert_string_equal(said, "keys.of_points is now called points.key; the old name works until 0.2\n");
	assert_true(t->item[TS_B_points_key].npy.n == 3 && t->item[TS_B_image_srgb].path != NULL && t->params.width == 64);
	ts_trace_close(t);
}

static void layouts_and_files_may_have_old_names(void **state)
{
	(void)state;
	ts_trace *like, *t;
	ts_buffer_id id;
	ts_renamed_use(planted);
	said_begin();
	assert_int_equal(ts_trace_open_folder(&like, dir), TS_OK);
	assert_int_equal(ts_trace_open_layout(&t, dir, "keys.of_points=k.npy,picture=s.npy", false, like), TS_OK);
	assert_true(t->item[TS_B_points_key].npy.n == 3 && t->item[TS_B_image_srgb].path != NULL);
	ts_trace_close(t);
	assert_int_equal(ts_trace_open_layout(&t, dir, "points.key=k.npy,keys.of_points=k.npy", false, like), TS_ERROR);
	says("there twice");
	ts_trace_close(like);
	assert_int_equal(ts_trace_open_file(&t, scratch_path("trace/11-keys.of_points.npy"), &id), TS_OK);
	assert_int_equal(id, TS_B_points_key);
	ts_trace_close(t);
	assert_string_equal(said_end(), "keys.of_points is now called points.key; the old name works until 0.2\n"
	                                "picture is now called image.srgb; the old name works until 0.2\n");
}

static void ignored_fields_may_have_old_names(void **state)
{
	(void)state;
	static const ts_renamed of_records[] = {{TS_NAME_buffer, "dots", "points.record"}, {0}};
	ts_renamed_use(of_records);
	said_begin();
	const ts_relaxations r = {.ignore = "image.srgb,dots.centre"}, none = {.ignore = "dots.center"};
	assert_int_equal(ts_relax_check(&r), TS_OK);
	assert_true(ts_relax_ignores(&r, "points.record.centre") && !ts_relax_ignores(&r, "points.record"));
	assert_true(ts_relax_ignores(&(ts_relaxations){.ignore = "dots"}, "points.record"));
	assert_int_equal(ts_relax_check(&none), TS_ERROR);
	assert_string_equal(said_end(), "dots is now called points.record; the old name works until 0.2\n");
}

static void stages_may_have_old_names(void **state)
{
	(void)state;
	ts_params params = small_params();
	const ts_pipeline *epr = ts_pipeline_find("reflections", "epr");
	ts_renamed_use(planted);
	said_begin();
	const ts_stage *stage = ts_replay_find("splats", epr, &params);
	assert_string_equal(said_end(), "splats is now called splat; the old name works until 0.2\n");
	assert_non_null(stage);
	assert_string_equal(stage->name, "splat");
}

static bool is_name(ts_name_kind kind, const char *name)
{
	size_t n;
	const ts_param_info *params = ts_param_table(&n);
	bool is = kind == TS_NAME_stage && ts_stage_find(name) != NULL;
	for (size_t i = 0; i < n && kind == TS_NAME_param; i++) is |= strcmp(params[i].name, name) == 0;
	for (u32 i = 0; i < TS_N_BUFFERS && kind == TS_NAME_buffer; i++) is |= strcmp(ts_buffer_table[i].name, name) == 0;
	for (u32 i = 0; i < TS_N_DIMS && kind == TS_NAME_size; i++) is |= strcmp(ts_dim_table[i].name, name) == 0;
	return is;
}

/* Every row of the real table leads from a name that there is no more to one that there is. Options are those of the
 * command, which tests/cli/errors.sh asks. */
static void the_table_leads_to_present_names(void **state)
{
	(void)state;
#define RENAMED(kind, old, now) {TS_NAME_##kind, old, now},
	static const ts_renamed rows[] = {
#include "../../src/model/renamed.def"
		{0},
	};
	for (const ts_renamed *row = rows; row->old != NULL; row++) {
		if (row->kind == TS_NAME_option) continue;
		if (is_name(row->kind, row->old) || !is_name(row->kind, row->now)) fail_msg("%s, %s", row->old, row->now);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(old_names_are_none_without_the_table),
		cmocka_unit_test(a_trace_says_one_line),
		cmocka_unit_test(layouts_and_files_may_have_old_names),
		cmocka_unit_test(ignored_fields_may_have_old_names),
		cmocka_unit_test(stages_may_have_old_names),
		cmocka_unit_test(the_table_leads_to_present_names),
	};
	return cmocka_run_group_tests(tests, begin, end);
}

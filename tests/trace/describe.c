/* What a trace says of who made it, this program and its arithmetic or a backend's that was measured; and of its run:
 * stages, buffers, parameters and counters. */
#include "model/core.h"
#include "tests/methods/small.h"
#include "tests/trace/folder.h"
#include "trace/describe.h"

static void is(const json_t *root, const char *key, const char *text)
{
	const char *value = json_string_value(json_object_get(root, key));
	assert_non_null(value);
	assert_string_equal(value, text);
}

/* The arithmetic of the numeric contract, measured, and the C backend's names. */
static void this_program_tells_its_own_arithmetic(void **state)
{
	(void)state;
	ts_run run = {.backend = NULL};
	ts_c_begin(&run.c, 1);
	const ts_backend *c = ts_run_backend(&run);
	json_t *who = ts_producer(&run), *how = ts_arithmetic(&run);
	is(who, "name", "touchstone");
	is(who, "version", TS_VERSION);
	is(who, "commit", ts_commit());
	is(who, "backend", "c");
	is(who, "device", c->device);
	is(who, "compiler", c->compiler);
	is(who, "flags", c->flags);
	is(how, "rounding", "nearest even");
	is(how, "denormals", "kept");
	assert_true(json_is_false(json_object_get(how, "contraction")));
	assert_int_equal(json_integer_value(json_object_get(how, "selftest")), 0);
	assert_int_equal(json_object_size(how), 4);
	json_decref(who);
	json_decref(how);
}

/* Each property of another backend, as it was measured. */
static void a_backend_tells_what_was_measured(void **state)
{
	(void)state;
	for (u32 k = 0; k < 8; k++) {
		const ts_measured m = {k & 1, (k & 2) != 0, (k & 4) != 0, 5 * k};
		ts_backend backend = {
			.name = "other", .device = "a device", .compiler = "a compiler", .flags = "-some", .arithmetic = m};
		const ts_run run = {.backend = &backend};
		json_t *who = ts_producer(&run), *how = ts_arithmetic(&run);
		is(who, "backend", "other");
		is(who, "device", "a device");
		is(who, "compiler", "a compiler");
		is(who, "flags", "-some");
		is(how, "rounding", k & 1 ? "nearest even" : "other");
		is(how, "denormals", k & 4 ? "kept" : "flushed");
		assert_int_equal(json_is_true(json_object_get(how, "contraction")), (k & 2) != 0);
		assert_int_equal(json_integer_value(json_object_get(how, "selftest")), 5 * k);
		json_decref(who);
		json_decref(how);
	}
}

/* ---- a whole description ---- */

static json_t *describe_if(const ts_run *run, const ts_trace_file *files)
{
	static const u32 crop[4] = {3, 2, 20, 10};
	const ts_trace_description about = {
		.pipeline = run->pipeline, .run = run, .files = files, .crop = crop, .version = TS_TRACE_VERSION};
	return ts_trace_describe(&about);
}

static json_t *describe(const ts_run *run, const ts_trace_file *files)
{
	json_t *root = describe_if(run, files);
	assert_non_null(root);
	return root;
}

static long left; /* allocations of jansson until one fails */

static void *scarce(size_t bytes) { return left-- == 0 ? NULL : malloc(bytes); }

/* One allocation of some hundred fails: nothing is left out. */
static void judge_without_memory(const json_t *whole, const ts_run *run, const ts_trace_file *files)
{
	u32 n_failed = 0;
	json_set_alloc_funcs(scarce, free);
	for (long n = 0;; n += 1 + n / 8) {
		left = n;
		json_t *root = describe_if(run, files);
		assert_true(root == NULL || json_equal(root, whole));
		json_decref(root);
		n_failed += root == NULL;
		if (left >= 0) break;
	}
	assert_true(n_failed > 20);
	json_set_alloc_funcs(malloc, free);
}

/* Files as a writer would note them; every fifth has none, every seventh of the eye's is a crop. */
static void note_files(ts_trace_file *files, const ts_run *run)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_buffer *buffer = &run->frame.buffer[id];
		ts_trace_file *file = &files[id];
		*file = (ts_trace_file){.made = buffer->made, .has_file = id % 5 != 0, .cropped = id % 7 == 0};
		snprintf(file->name, sizeof file->name, "%03u-%.40s.npy", (unsigned)id, ts_buffer_table[id].name);
		snprintf(file->descr, sizeof file->descr, "descr %u", (unsigned)id);
		snprintf(file->sha256, sizeof file->sha256, "digest %u", (unsigned)id);
		file->n_dims = buffer->n_dims;
		memcpy(file->shape, buffer->shape, sizeof buffer->shape);
	}
}

static void judge_buffer(const json_t *told, const ts_trace_file *file, ts_buffer_id id)
{
	const ts_buffer_info *info = &ts_buffer_table[id];
	const json_t *shape = json_object_get(told, "shape"), *crop = json_object_get(told, "crop");
	is(told, "name", info->name);
	is(told, "element", info->element);
	is(told, "dtype", file->descr);
	is(told, "sizes", info->shape);
	is(told, "order", info->order);
	is(told, "key", info->key);
	is(told, "doc", info->doc);
	is(told, "sha256", file->sha256);
	if (file->has_file) is(told, "file", file->name);
	if (!file->has_file) assert_true(json_is_null(json_object_get(told, "file")));
	assert_int_equal(json_array_size(shape), file->n_dims);
	for (u32 k = 0; k < file->n_dims; k++)
		assert_int_equal(json_integer_value(json_array_get(shape, k)), file->shape[k]);
	assert_int_equal(json_array_size(crop), file->cropped ? 4 : 0);
	for (u32 k = 0; k < 4 && crop != NULL; k++)
		assert_int_equal(json_integer_value(json_array_get(crop, k)), ((u32[]){3, 2, 20, 10})[k]);
	assert_int_equal(json_object_size(told), file->cropped ? 11 : 10);
}

/* The digest of a list of buffers is that of their lines. */
static void judge_chain(const json_t *told, const char *key, const json_t *names, const ts_trace_file *files)
{
	ts_digest digest;
	char hex[TS_DIGEST_BYTES];
	ts_digest_begin(&digest);
	for (size_t i = 0; i < json_array_size(names); i++) {
		u32 id = 0;
		char line[200];
		while (strcmp(ts_buffer_table[id].name, json_string_value(json_array_get(names, i))) != 0) id++;
		ts_digest_add(&digest, line,
		              (size_t)snprintf(line, sizeof line, "%s  %s\n", files[id].sha256, ts_buffer_table[id].name));
	}
	ts_digest_end(&digest, hex);
	is(told, key, hex);
}

static void judge_names(const json_t *names, const ts_buffer_id *ids, const ts_trace_file *files)
{
	size_t n = 0;
	for (; *ids != TS_N_BUFFERS; ids++) {
		if (!files[*ids].made) continue;
		assert_string_equal(json_string_value(json_array_get(names, n++)), ts_buffer_table[*ids].name);
	}
	assert_int_equal(json_array_size(names), n);
}

/* Stages that ran, each with the buffers that there are. */
static u32 judge_stages(const json_t *stages, const ts_run *run, const ts_trace_file *files)
{
	const ts_step *step = ts_pipeline_steps(run->pipeline);
	for (size_t i = 0; i < json_array_size(stages); i++, step++) {
		const json_t *told = json_array_get(stages, i);
		const char *name = json_string_value(json_object_get(told, "name"));
		while (step->stage != NULL && strcmp(step->stage, name) != 0) {
			bool ran = ts_pipeline_takes(step, &run->params, true);
			assert_true(!ran || !files[ts_stage_outputs(ts_stage_find(step->stage))[0]].made);
			step++;
		}
		assert_non_null(step->stage);
		const ts_stage *stage = ts_stage_find(name);
		is(told, "kind", stage->kind);
		is(told, "paper", stage->paper);
		is(told, "doc", stage->doc);
		judge_names(json_object_get(told, "reads"), ts_stage_inputs(stage), files);
		judge_names(json_object_get(told, "writes"), ts_stage_outputs(stage), files);
		judge_chain(told, "inputs_sha256", json_object_get(told, "reads"), files);
	}
	return (u32)json_array_size(stages);
}

static void judge_run(const json_t *root, const ts_run *run)
{
	const json_t *counters = json_object_get(root, "counters"), *params = json_object_get(root, "params");
	size_t n;
	const ts_param_info *table = ts_param_table(&n);
	assert_int_equal(json_object_size(counters), run->n_counters);
	for (u32 i = 0; i < run->n_counters; i++) {
		assert_int_equal(json_integer_value(json_object_get(counters, run->counters[i].name)), run->counters[i].value);
	}
	assert_int_equal(json_object_size(params), n);
	for (size_t i = 0; i < n; i++) {
		char text[64];
		ts_params_format(&run->params, i, text, sizeof text);
		is(params, table[i].name, text);
	}
	const json_t *plan = json_object_get(root, "plan");
	assert_int_equal(json_object_size(plan), TS_PLAN_ROWS);
	for (u32 i = 0; i < TS_PLAN_ROWS; i++) {
		char name[64];
		const char *part = ts_plan_table[i].part;
		snprintf(name, sizeof name, part[0] != 0 ? "%s.%s" : "%s%s", part, ts_plan_table[i].name);
		assert_int_equal(json_integer_value(json_object_get(plan, name)), ts_plan_value(&run->plan, &ts_plan_table[i]));
	}
	is(root, "pipeline", run->pipeline->name);
	is(root, "effect", run->pipeline->effect->name);
	is(root, "paper", run->pipeline->paper);
	is(root, "order", "canonical");
	is(json_object_get(root, "scene"), "name", run->scene->name);
	assert_int_equal(json_integer_value(json_object_get(root, "version")), TS_TRACE_VERSION);
}

static void a_trace_is_described_as_its_run(void **state)
{
	(void)state;
	static ts_trace_file files[TS_N_BUFFERS];
	static const char *const methods[] = {"epr", "mvr"};
	ts_params params = small_params_of_all();
	ts_scene *scene = small_scene(&params);
	for (u32 m = 0; m < 2; m++) {
		ts_run run;
		small_run(&run, scene, &params, methods[m], 2, NULL, NULL);
		note_files(files, &run);
		json_t *root = describe(&run, files);
		const json_t *buffers = json_object_get(root, "buffers");
		size_t n = 0;
		for (u32 id = 0; id < TS_N_BUFFERS; id++) {
			if (files[id].made) judge_buffer(json_array_get(buffers, n++), &files[id], (ts_buffer_id)id);
		}
		assert_true(n > 10 && json_array_size(buffers) == n);
		assert_true(judge_stages(json_object_get(root, "stages"), &run, files) > 5);
		judge_run(root, &run);
		judge_without_memory(root, &run, files);
		json_decref(root);
		ts_run_end(&run);
	}
	ts_scene_free(scene);
}

/* Every field of every record, in the order of the table. */
static void records_are_those_of_the_table(void **state)
{
	(void)state;
	static ts_trace_file files[TS_N_BUFFERS];
	size_t n, row = 0, in_record = 0;
	const ts_field_info *fields = ts_field_table(&n);
	const ts_scene scene = {.name = "none"};
	ts_run run = {.scene = &scene, .pipeline = ts_pipeline_find("reflections", "epr")};
	ts_params_default(&run.params);
	ts_c_begin(&run.c, 1);
	json_t *root = describe(&run, files);
	const json_t *records = json_object_get(root, "records");
	for (; row < n; row++) {
		in_record = row > 0 && strcmp(fields[row].record, fields[row - 1].record) == 0 ? in_record + 1 : 0;
		const json_t *told = json_array_get(json_object_get(records, fields[row].record), in_record);
		is(told, "name", fields[row].name);
		is(told, "type", fields[row].type);
		is(told, "doc", fields[row].doc);
		assert_int_equal(json_integer_value(json_object_get(told, "count")), fields[row].count);
	}
	assert_int_equal(json_array_size(json_object_get(root, "buffers")), 0);
	assert_int_equal(json_array_size(json_object_get(root, "stages")), 0);
	json_decref(root);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(this_program_tells_its_own_arithmetic), cmocka_unit_test(a_backend_tells_what_was_measured),
		cmocka_unit_test(a_trace_is_described_as_its_run), cmocka_unit_test(records_are_those_of_the_table)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

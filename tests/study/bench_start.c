/* What is measured in a process of its own: this program again, which tells what it was asked, in place of seconds. */
#include "study/bench_backends.h"
#include "tests/scratch.h"
#include "tests/status.h"

/* ---- a frame whose seconds are ours, in place of that of benches ---- */

static const double frame_seconds[] = {9, 5, 1, 3};
static u32 n_frames;

const char *ts_bench_frame_spec(const ts_job *job) { return job->scenes; }
ts_status ts_bench_frame_params(ts_params *params, const ts_job *job)
{
	*params = job->params;
	return TS_OK;
}
ts_status ts_bench_frame_open(ts_bench_frame *frame, const ts_job *job)
{
	(void)frame;
	return ts_bench_frame_params(&frame->params, job);
}
ts_status ts_bench_frame_run(const ts_bench_frame *frame, const ts_how *how, ts_measure *measure)
{
	(void)frame;
	(void)how;
	measure->seconds = frame_seconds[n_frames++];
	return TS_OK;
}
void ts_bench_frame_close(ts_bench_frame *frame) { (void)frame; }
void ts_bench_frame_report(const ts_bench_frame *frame, ts_report *report)
{
	(void)frame;
	ts_report_value(report, "frame", json_string("ours"));
}

/* ---- a process of its own ---- */

/* The child: its seconds are the number of the device, how often a device was named, and the length of what is set. */
static int answer(int n, char **arguments)
{
	const char *device = "-1", *backend = "", *set = getenv("TS_TEST_CACHE");
	u32 n_devices = 0;
	fprintf(stderr, "a driver talks\n");
	for (int i = 1; i < n; i++) {
		if (strcmp(arguments[i], "--") == 0) return 1;
	}
	if (strcmp(arguments[n - 4], "--runs") != 0 || strcmp(arguments[n - 3], "1") != 0) return 1;
	if (strcmp(arguments[n - 2], "--json") != 0 || getenv("TS_TEST_CACHE_OTHER") == NULL) return 1;
	for (int i = 1; i + 1 < n; i++) {
		if (strcmp(arguments[i], "--device") == 0) device = arguments[i + 1];
		if (strcmp(arguments[i], "--backend") == 0) backend = arguments[i + 1];
		n_devices += strcmp(arguments[i], "--device") == 0;
	}
	if (strcmp(backend, "broken") == 0) return 1;
	if (strcmp(backend, "silent") == 0) return printf("{}\n") < 0;
	if (strcmp(backend, "half") == 0) return printf("{\"start\": [{\"open_s\": 1, \"first_s\": 1}]}\n") < 0;
	bool right = strcmp(arguments[1], "bench") == 0 && strcmp(arguments[n - 1], "start") == 0 && device[0] != 0;
	printf("{\"start\": [{\"backend\": \"%s\", \"open_s\": %s, \"first_s\": %u, \"next_s\": %zu}]}\n", backend,
	       right ? device : "0", (unsigned)n_devices, set != NULL ? strlen(set) : 999);
	return strcmp(backend, "late") == 0 ? 3 : 0; /* an end that is bad after all was told */
}

static ts_bench_started apart(const char *backend, u32 device, char *set)
{
	char *typed[] = {"--device", "7", "--"};
	const ts_job job = {.typed = typed, .n_typed = 3};
	ts_bench_started started;
	if (ts_bench_start_apart(&started, &job, backend, device, set) != TS_OK) fail_msg("%s", ts_error_message());
	return started;
}

static void starts_are_measured_in_a_process_apart(void **state)
{
	(void)state;
	char set[] = "TS_TEST_CACHE=abc";
	for (u32 device = 0; device < 4; device++) {
		ts_bench_started started = apart("fake", device, set);
		assert_true(started.open == device && started.first == 2 && started.next == 3);
	}
	setenv("TS_TEST_CACHE", "of the parent", 1);
	assert_true(apart("fake", 1, set).next == 3);
	assert_true(apart("fake", 1, NULL).next == 13);
	unsetenv("TS_TEST_CACHE");
}

static void a_process_that_fails_is_an_error(void **state)
{
	(void)state;
	const ts_job job = {.n_typed = 0};
	ts_bench_started started;
	refused(ts_bench_start_apart(&started, &job, "broken", 0, NULL), "failed in a process of its own");
	refused(ts_bench_start_apart(&started, &job, "late", 0, NULL), "failed in a process of its own");
	refused(ts_bench_start_apart(&started, &job, "silent", 0, NULL), "told no times");
	refused(ts_bench_start_apart(&started, &job, "half", 0, NULL), "told no times");
}

/* A driver in a process of its own writes to a standard error that nobody reads. */
static void the_process_apart_is_silent(void **state)
{
	(void)state;
	char heard[64] = "";
	FILE *said = tmpfile();
	int before = dup(2);
	assert_true(said != NULL && before >= 0 && dup2(fileno(said), 2) == 2);
	apart("fake", 1, NULL);
	assert_int_equal(dup2(before, 2), 2);
	close(before);
	rewind(said);
	assert_null(fgets(heard, sizeof heard, said));
	fclose(said);
}

/* The first frame is told by itself, and the median of those behind it. */
static void the_first_frame_is_told_by_itself(void **state)
{
	(void)state;
	const ts_backend_kind kind = {.name = "fake"};
	ts_job job = {.program = "touchstone", .backend = &kind, .runs = 3, .open_s = 0.25};
	job.output.json = true;
	const char *path = scratch_path("start.json");
	int before = dup(1);
	fflush(stdout);
	assert_true(before >= 0 && freopen(path, "w", stdout) != NULL);
	ts_status status = ts_bench_start(&job);
	fflush(stdout);
	assert_int_equal(dup2(before, 1), 1);
	close(before);
	require(status);
	json_t *root = json_load_file(path, 0, NULL), *row = json_array_get(json_object_get(root, "start"), 0);
	json_t *right = json_pack("{s:s, s:f, s:f, s:f}", "backend", "fake", "open_s", 0.25, "first_s", 9.0, "next_s", 3.0);
	assert_true(json_equal(row, right));
	assert_string_equal(json_string_value(json_object_get(root, "frame")), "ours");
	assert_int_equal(n_frames, 4);
	json_decref(right);
	json_decref(root);
}

/* ---- the table of builds ---- */

static const ts_backend_kind fake = {.name = "fake"};

static void add(ts_bench_table *table, ts_backend *backend, const char *name, const char *platform)
{
	ts_bench_column *c = &table->column[table->n_columns];
	*c = (ts_bench_column){.kind = &fake, .index = table->n_columns++, .how.backend = backend};
	snprintf(c->name, sizeof c->name, "%s", name);
	snprintf(c->platform, sizeof c->platform, "%s", platform);
}

/* Every column behind the reference has its rows: two where an empty cache can be had, else one and a note. */
static void every_column_of_builds_has_its_rows(void **state)
{
	(void)state;
	ts_backend other = {.compiler = "of its own"}, mesa = {.compiler = "Mesa 1"};
	const ts_job job = {.n_typed = 0};
	setenv("TS_TEST_CACHE", "x", 1);
	for (u32 reference = 0; reference < 2; reference++) {
		ts_report report;
		ts_report_begin(&report, true);
		ts_bench_table table = {.job = &job, .report = &report, .reference = reference, .notes = json_array()};
		for (u32 i = 0; i <= reference; i++) add(&table, NULL, "c", "");
		add(&table, &other, "one", TS_POCL);
		add(&table, &other, "two", "another");
		add(&table, &mesa, "three", "another");
		assert_int_equal(ts_bench_print_builds(&table), TS_OK);
		static const char *const right[][2] = {
			{"one", "empty"}, {"one", "filled"}, {"two", "the driver's own"}, {"three", "empty"}, {"three", "filled"}};
		const json_t *rows = json_object_get(report.root, "kernel_build");
		assert_int_equal(json_array_size(rows), 5);
		for (u32 i = 0; i < 5; i++) {
			const json_t *row = json_array_get(rows, i);
			u32 device = reference + 1 + (i < 2 ? 0 : i == 2 ? 1 : 2);
			assert_string_equal(json_string_value(json_object_get(row, "column")), right[i][0]);
			assert_string_equal(json_string_value(json_object_get(row, "cache")), right[i][1]);
			assert_true(json_number_value(json_object_get(row, "open_s")) == device);
		}
		assert_int_equal(json_array_size(table.notes), 1);
		assert_true(ts_report_is_timed(&report, "kernel_build"));
		json_decref(table.notes);
		ts_report_discard(&report);
	}
	unsetenv("TS_TEST_CACHE");
}

static void without_a_device_there_is_no_table(void **state)
{
	(void)state;
	const ts_job job = {.n_typed = 0};
	ts_report report;
	ts_report_begin(&report, true);
	ts_bench_table table = {.job = &job, .report = &report, .notes = NULL};
	add(&table, NULL, "c", "");
	assert_int_equal(ts_bench_print_builds(&table), TS_OK);
	assert_int_equal(json_object_size(report.root), 0);
	ts_report_discard(&report);
}

int main(int n, char **arguments)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(starts_are_measured_in_a_process_apart),
		cmocka_unit_test(a_process_that_fails_is_an_error),
		cmocka_unit_test(the_process_apart_is_silent),
		cmocka_unit_test(the_first_frame_is_told_by_itself),
		cmocka_unit_test(every_column_of_builds_has_its_rows),
		cmocka_unit_test(without_a_device_there_is_no_table),
	};
	if (n > 1) return answer(n, arguments);
	setenv("TS_TEST_CACHE_OTHER", "stays", 1);
	return cmocka_run_group_tests(tests, scratch_begin, scratch_remove);
}

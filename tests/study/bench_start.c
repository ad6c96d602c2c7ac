/* What is measured in a process of its own: this program again, which tells what it was asked, in place of seconds. */
#include "../../src/study/bench_backends.h"
#include "../model/test.h"

enum { ASKED = 16 };

/* The child: its seconds are the number of the device, how often a device was named, and the length of what is set. */
static int answer(int n, char **arguments)
{
	const char *device = "-1", *backend = "", *set = getenv("TS_TEST_CACHE");
	u32 n_devices = 0;
	for (int i = 1; i + 1 < n; i++) {
		if (strcmp(arguments[i], "--device") == 0) device = arguments[i + 1];
		if (strcmp(arguments[i], "--backend") == 0) backend = arguments[i + 1];
		n_devices += strcmp(arguments[i], "--device") == 0;
	}
	if (strcmp(backend, "broken") == 0) return 1;
	if (strcmp(backend, "silent") == 0) return printf("{}\n") < 0;
	bool right = strcmp(arguments[1], "bench") == 0 && strcmp(arguments[n - 1], "start") == 0 && device[0] != 0;
	printf("{\"start\": [{\"backend\": \"%s\", \"open_s\": %s, \"first_s\": %u, \"next_s\": %zu}]}\n", backend,
	       right ? device : "0", (unsigned)n_devices, set != NULL ? strlen(set) : 999);
	return 0;
}

static ts_bench_started apart(const char *backend, u32 device, char *set)
{
	char *typed[] = {"--device", "7", "--"};
	const ts_job job = {.typed = typed, .n_typed = 3};
	ts_bench_started started;
	if (ts_bench_start_apart(&started, &job, backend, device, set) != TS_OK) fail_msg("%s", ts_error_message());
	return started;
}

static void test_apart(void **state)
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

static void test_fails(void **state)
{
	(void)state;
	const ts_job job = {.n_typed = 0};
	ts_bench_started started;
	assert_int_equal(ts_bench_start_apart(&started, &job, "broken", 0, NULL), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "failed in a process of its own"));
	assert_int_equal(ts_bench_start_apart(&started, &job, "silent", 0, NULL), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "told no times"));
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
static void test_builds(void **state)
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
		add(&table, &other, "one", "Portable Computing Language");
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

/* Without a device there is no table. */
static void test_no_builds(void **state)
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
	const struct CMUnitTest tests[] = {cmocka_unit_test(test_apart), cmocka_unit_test(test_fails),
	                                   cmocka_unit_test(test_builds), cmocka_unit_test(test_no_builds)};
	return n > 1 ? answer(n, arguments) : cmocka_run_group_tests(tests, NULL, NULL);
}

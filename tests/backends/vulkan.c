/* What the Vulkan backend refuses, a dispatch of more groups than one may have, and a loop that a driver ends. */
#include "backends/kernels.h"
#include "backends/vulkan/vk.h"
#include "tests/backends/device.h"
#include "vectors/vectors.h"

static void need(void)
{
	if (!device_is_there(&ts_vulkan_kind)) skip();
}

static void refuses(const char *words, ts_backend_options options)
{
	ts_backend *backend = (ts_backend *)&options;
	if (options.build == NULL) options.build = "";
	assert_int_equal(ts_vulkan_kind.open(&backend, &options), TS_ERROR);
	assert_null(backend);
	says(words);
}

static void wrong_devices_and_groups_are_refused(void **state)
{
	(void)state;
	need();
	refuses("device 31: there are ", (ts_backend_options){.device = 31});
	refuses("work group of 4095: ", (ts_backend_options){.work_group = 4095});
	refuses("/nonexistent/vectors.spv: No such file", (ts_backend_options){.build = "/nonexistent"});
	char many[1200] = "";
	memset(many, 'x', sizeof many - 1);
	refuses("build: at most 900 characters", (ts_backend_options){.build = many});
}

/* Quotients and roots of integers are those of the processor. */
static void repaired_quotients_and_roots_are_exact(void **state)
{
	(void)state;
	need();
	ts_backend *backend = device_open(&ts_vulkan_kind, (ts_backend_options){.work_group = 64});
	assert_true(backend->repair(backend));
	assert_false(backend->repair(backend));
	if (ts_vectors_verify(backend, false) != TS_OK) fail_msg("%s", ts_error_message());
	if (ts_vectors_verify_composites(backend) != TS_OK) fail_msg("%s", ts_error_message());
	assert_string_equal(backend->flags, "group=64, quotients and roots by integers");
	backend->close(backend);
}

/* Sums of n counts in chunks of one, whose second step is one item with a turn for each. */
static ts_status sum(ts_backend *backend, u32 *counts, u64 *sums, u64 n)
{
	ts_frame frame = {.bytes = 0};
	ts_launch step = TS_LAUNCH(scan_sum, TS_WORK(counts, queue));
	ts_scan_args args = {.counts = counts, .sums = sums, .n = n, .n_chunks = n, .chunk = 1};
	ts_frame_lend(&frame, TS_WORK_queue, counts, n * sizeof *counts);
	ts_frame_lend(&frame, TS_WORK_other, sums, (n + 1) * sizeof *sums);
	ts_status status = backend->launch(backend, &frame, &step, &args, n);
	step.kernel = TS_KERNEL_scan_chunks;
	if (status == TS_OK) status = backend->launch(backend, &frame, &step, &args, 1);
	if (status == TS_OK) status = backend->finish(backend);
	ts_status recalled = ts_frame_recall(&frame, TS_WORK_other);
	ts_frame_clear(&frame);
	return status == TS_OK ? recalled : status;
}

/* Two million items of the first step in dispatches of few groups, and 2 million turns of the second. */
static void sums_of_many_groups_are_right(void **state)
{
	(void)state;
	need();
	enum { N = 2000001 };
	u32 *counts = malloc(N * sizeof *counts);
	u64 *sums = malloc((N + 1) * sizeof *sums), sum_of_all = 0;
	ts_backend *backend = device_open(&ts_vulkan_kind, (ts_backend_options){.work_group = 8});
	((ts_vk *)backend)->most.groups = 1000;
	for (u32 i = 0; i < N; i++) counts[i] = (i * 2654435761u) >> 29;
	if (sum(backend, counts, sums, N) != TS_OK) fail_msg("%s", ts_error_message());
	for (u32 i = 0; i < N; i++) {
		assert_true(sums[i] == sum_of_all);
		sum_of_all += counts[i];
	}
	assert_true(sums[N] == sum_of_all);
	backend->close(backend);
	free(counts);
	free(sums);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(wrong_devices_and_groups_are_refused),
	                                   cmocka_unit_test(repaired_quotients_and_roots_are_exact),
	                                   cmocka_unit_test(sums_of_many_groups_are_right)};
	device_begin();
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* What the OpenCL backend refuses, and what the arithmetic vectors find of its options. */
#include "tests/backends/device.h"
#include "vectors/vectors.h"

static void refuses(const char *words, ts_backend_options options)
{
	ts_backend *backend = (ts_backend *)&options;
	assert_int_equal(ts_opencl_kind.open(&backend, &options), TS_ERROR);
	assert_null(backend);
	says(words);
}

static void wrong_devices_and_builds_are_refused(void **state)
{
	(void)state;
	if (!device_is_there(&ts_opencl_kind)) skip();
	char many[400] = "";
	memset(many, ' ', sizeof many - 1);
	refuses("device 31: there are ", (ts_backend_options){.device = 31, .build = ""});
	refuses("build: at most", (ts_backend_options){.build = many});
	refuses("building the kernels", (ts_backend_options){.build = "-no-such-option"});
	refuses("building the kernels, whose log stands above", (ts_backend_options){.build = "-Dts_k_vectors_item=1"});
}

/* What the arithmetic vectors find with these options. */
static ts_status verify(ts_measured *arithmetic, const char *build, bool inexact)
{
	ts_backend *backend = NULL;
	const ts_backend_options options = {.work_group = 64, .build = build};
	assert_int_equal(ts_opencl_kind.open(&backend, &options), TS_OK);
	ts_status status = ts_vectors_verify(backend, inexact);
	*arithmetic = backend->arithmetic;
	backend->close(backend);
	return status;
}

static void verify_composites(const char *build)
{
	ts_backend *backend = NULL;
	const ts_backend_options options = {.work_group = 64, .build = build};
	assert_int_equal(ts_opencl_kind.open(&backend, &options), TS_OK);
	if (ts_vectors_verify_composites(backend) != TS_OK) fail_msg("%s", ts_error_message());
	backend->close(backend);
}

static void breaks(const char *build, const char *primitive)
{
	ts_measured a;
	assert_int_equal(verify(&a, build, false), TS_ERROR);
	if (strstr(ts_error_message(), primitive) == NULL) fail_msg("%s", ts_error_message());
	assert_true(a.n_wrong > 0);
	assert_int_equal(verify(&a, build, true), TS_OK);
	assert_true(a.n_wrong > 0);
}

static void vectors_see_what_options_change(void **state)
{
	(void)state;
	if (!device_is_there(&ts_opencl_kind)) skip();
	ts_measured a;
	if (verify(&a, "", false) != TS_OK) fail_msg("%s", ts_error_message());
	assert_true(a.n_wrong == 0 && a.rounds_to_nearest && !a.contracts);
	verify_composites("");
	verify_composites("-cl-denorms-are-zero");
	if (verify(&a, "-cl-denorms-are-zero", false) != TS_OK) fail_msg("%s", ts_error_message());
	assert_true(a.n_wrong == 0 && a.rounds_to_nearest && !a.keeps_denormals);
	breaks("-cl-fast-relaxed-math", "(");
	breaks("-DTS_CANARY_CONTRACTS", "muladd (");
	verify(&a, "-DTS_CANARY_CONTRACTS", true);
	assert_true(a.contracts && a.keeps_denormals && a.rounds_to_nearest);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(wrong_devices_and_builds_are_refused),
	                                   cmocka_unit_test(vectors_see_what_options_change)};
	device_begin();
	return cmocka_run_group_tests(tests, NULL, NULL);
}

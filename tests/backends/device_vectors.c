/* Every vector on every kind of device: primitives, and what is composed of them. */
#include "tests/backends/device.h"
#include "vectors/vectors.h"

static void vectors(const ts_backend_kind *kind)
{
	ts_backend *backend = device_open(kind, (ts_backend_options){.work_group = 64});
	if (ts_vectors_verify(backend, false) != TS_OK) fail_msg("%s", ts_error_message());
	assert_true(backend->arithmetic.rounds_to_nearest && !backend->arithmetic.contracts);
	if (ts_vectors_verify_composites(backend) != TS_OK) fail_msg("%s", ts_error_message());
	backend->close(backend);
}

static void every_device_gives_every_vector(void **state)
{
	(void)state;
	device_each(vectors);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(every_device_gives_every_vector)};
	device_begin();
	return cmocka_run_group_tests(tests, NULL, NULL);
}

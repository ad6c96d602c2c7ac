/* The traversal on a device: queues in memory that is lent, the same pairs and maps. */
#include "tests/backends/device.h"
#include "tests/methods/views/grove.h"

/* In the host's memory and in copies, kept or mapped at once, by one queue or in pieces. */
static void traverse(const ts_backend_kind *kind)
{
	ts_params params = small_params(64, 64);
	ts_scene *scene = small_scene(&params);
	grove g;
	grove_state = 1234567;
	grove_plant(&g, 5, 5, 20000, grove_surface, 200, grove_surface);
	params.view_map_multipixel = TS_MULTIPIXEL_MIPS;
	grove_outcome expected = grove_run(&g, scene, &params, 2, NULL, true);
	assert_true(expected.n_pairs > 10000);
	for (u32 i = 0; i < 4; i++) {
		ts_backend *backend = device_open(kind, (ts_backend_options){.work_group = 64, .copies = i % 2 == 1});
		params.traverse_queue_mb = i < 2 ? 16 : 1;
		grove_outcome found = grove_run(&g, scene, &params, 1, backend, i % 3 == 0);
		grove_assert_same(&expected, &found);
		grove_outcome_free(&found);
		backend->close(backend);
	}
	grove_outcome_free(&expected);
	grove_free(&g);
	ts_scene_free(scene);
}

static void a_device_traverses_the_same_pairs(void **state)
{
	(void)state;
	device_each(traverse);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(a_device_traverses_the_same_pairs)};
	device_begin();
	return cmocka_run_group_tests(tests, NULL, NULL);
}

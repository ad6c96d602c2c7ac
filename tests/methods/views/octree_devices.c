/* The two octrees of MegaViews on devices: the bits of C. */
#include "tests/backends/device.h"
#include "tests/methods/views/octrees.h"

static void on_device(const ts_backend_kind *kind)
{
	static ts_sums c, cl;
	for (u32 levels = 1; levels <= 6; levels += 5) {
		ts_params params = octrees_params(levels, levels == 1 ? 0 : 300);
		params.vpl_bounces = levels == 1 ? 1 : 3;
		ts_scene *scene = small_scene(&params);
		octrees_sums(&c, scene, &params, 2, NULL);
		ts_backend *backend = device_open(kind, (ts_backend_options){.work_group = kind == &ts_opencl_kind ? 5 : 8});
		octrees_sums(&cl, scene, &params, 1, backend);
		octrees_assert_same(&c, &cl);
		backend->close(backend);
		ts_scene_free(scene);
	}
}

static void devices_make_the_octrees_of_c(void **state)
{
	(void)state;
	device_each(on_device);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(devices_make_the_octrees_of_c)};
	device_begin();
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Goldens of a scene of one triangle: all files are kept, whole; floats that are not finite are counted, and the first
 * buffer with one is named. */
#include <math.h>
#include "golden/golden.h"
#include "scene/sources.h"
#include "tests/model/test.h"

static ts_golden golden;

static void compute(bool finite)
{
	ts_params params;
	ts_scene *scene;
	ts_params_default(&params);
	params.width = 24;
	params.height = 16;
	params.reflectors_count = 1;
	params.reflectors_px = 12;
	params.cube_max_px = 16;
	if (ts_scene_load(&scene, "scenes/triangle.gltf", &params, NULL) != TS_OK) fail_msg("%s", ts_error_message());
	if (!finite) scene->materials[0].emissive[0] = scene->materials[0].emissive[2] = INFINITY;
	const ts_golden_job job = {ts_pipeline_find("reflections", "mvr"), scene, &params, {.threads = 1}};
	if (ts_golden_compute(&golden, &job) != TS_OK) fail_msg("%s", ts_error_message());
	ts_scene_free(scene);
}

/* Floats that are not finite in what is kept. */
static u64 count_kept(void)
{
	u64 n = 0;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_golden_file *file = &golden.file[id];
		assert_int_equal(file->data != NULL, golden.bytes[id] != 0);
		if (file->data == NULL) continue;
		const size_t at = file->npy.data_at;
		assert_int_equal(file->taken, file->bytes);
		assert_int_equal(file->bytes, at + file->npy.n * ts_buffer_table[id].element_bytes);
		n += ts_golden_strays((ts_buffer_id)id, file->data + at, file->bytes - at);
	}
	return n;
}

static void a_finite_golden_has_no_strays(void **state)
{
	(void)state;
	u32 width, height;
	compute(true);
	assert_true(count_kept() == 0 && golden.n_strays == 0 && golden.stray == TS_N_BUFFERS);
	assert_ptr_equal(ts_golden_image(&golden, &width, &height), golden.file[TS_B_image_srgb].data + 128);
	assert_true(width == 24 && height == 16);
	ts_golden_free(&golden);
}

static void infinite_floats_are_counted(void **state)
{
	(void)state;
	compute(false);
	const u64 n = count_kept();
	assert_true(n > 1 && golden.n_strays == n);
	assert_int_equal(golden.stray, TS_B_scene_material);
	ts_golden_free(&golden);
	for (u32 id = 0; id < TS_N_BUFFERS; id++) assert_null(golden.file[id].data);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(a_finite_golden_has_no_strays),
	                                   cmocka_unit_test(infinite_floats_are_counted)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

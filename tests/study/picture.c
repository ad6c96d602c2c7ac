/* A picture takes from a run which pixels are mirrors', with several samples a pixel too; a truth tells its time. */
#include "study/asked/truths.h"
#include "study/picture.h"
#include "tests/methods/small.h"

static void mirrors_are_marked(void **state)
{
	(void)state;
	for (u32 four = 0; four < 2; four++) {
		ts_run run;
		ts_picture picture = {.n_reflective = 0};
		ts_params params = small_params_of_all();
		params.eye_samples = four;
		ts_scene *scene = small_scene(&params);
		small_run(&run, scene, &params, "epr", 2, NULL, NULL);
		assert_int_equal(ts_picture_take(&picture, "epr", &run), TS_OK);
		u64 n = ts_frame_n(&run.frame, TS_B_mirror_pixel_record), n_pixels = (u64)params.width * params.height,
			marked = 0;
		const ts_pixel *pixels = ts_frame_data(&run.frame, TS_B_mirror_pixel_record);
		for (u64 i = 0; i < n; i++) assert_int_equal(picture.reflective[pixels[i].index % n_pixels], 1);
		for (u64 i = 0; i < n_pixels; i++) marked += picture.reflective[i];
		assert_true(marked > 10 && marked == picture.n_reflective && (four ? n > marked : n == marked));
		ts_picture_free(&picture);
		ts_run_end(&run);
		ts_scene_free(scene);
	}
}

static void truth_tells_its_time(void **state)
{
	(void)state;
	ts_run run;
	ts_picture picture = {.n_reflective = 0};
	ts_params params = small_params_of_all();
	ts_scene *scene = small_scene(&params);
	small_run(&run, scene, &params, "epr", 2, NULL, NULL);
	double begin = ts_seconds();
	assert_int_equal(ts_picture_truth(&picture, ts_truths()[0], &run), TS_OK);
	double all = ts_seconds() - begin;
	assert_true(picture.seconds > 0 && picture.seconds <= all);
	assert_true(picture.cost.rays > 0 && picture.cost.seconds > 0 && picture.cost.seconds <= all);
	ts_picture_free(&picture);
	ts_run_end(&run);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(mirrors_are_marked), cmocka_unit_test(truth_tells_its_time)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

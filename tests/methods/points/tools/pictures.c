/* The picture of splats shows those that mirrors' pixels see, and no other pixel. */
#include "study/stage_pictures.h"
#include "tests/methods/small.h"

extern const ts_stage_picture_rule ts_points_pictures[];

static void splats_are_shown_where_mirrors_are(void **state)
{
	(void)state;
	ts_run run;
	ts_stage_pictures pictures = {.n = 0};
	ts_params params = small_params_of_all();
	ts_scene *scene = small_scene(&params);
	small_run(&run, scene, &params, "epr", 2, NULL, NULL);
	for (const ts_stage_picture_rule *rule = ts_points_pictures; rule->take != NULL; rule++) {
		if (rule->buffer == TS_B_lookup_point) assert_int_equal(rule->take(&pictures, &run, rule->buffer), TS_OK);
	}
	const ts_stage_picture *p = ts_stage_pictures_find(&pictures, "splats");
	const ts_pixel *pixels = ts_frame_data(&run.frame, TS_B_mirror_pixel_record);
	u64 n = ts_frame_n(&run.frame, TS_B_mirror_pixel_record), shown = 0, coloured = 0;
	assert_non_null(p);
	for (u64 i = 0; i < n; i++) {
		const u8 *rgb = p->rgb + 3 * (size_t)pixels[i].index;
		assert_int_equal(p->mask[pixels[i].index], 1);
		coloured += rgb[0] + rgb[1] + rgb[2] > 0;
	}
	for (u32 i = 0; i < params.width * params.height; i++) shown += p->mask[i];
	assert_true(n > 10 && shown == n && coloured > n / 2);
	ts_stage_pictures_free(&pictures);
	ts_run_end(&run);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(splats_are_shown_where_mirrors_are)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

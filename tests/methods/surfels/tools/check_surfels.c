/* Checks of surfels: faults in what their stages read, planted in buffers of a run. */
#include "kernels/base/shade.h"
#include "tests/replay/loaded.h"

static int begin(void **state)
{
	(void)state;
	ts_params params = small_params(64, 48);
	params.reflectors_count = 0;
	params.surfels_from_mesh = 3000;
	params.depth_map_px = 32;
	params.deferred_shader = TS_SHADER_PHONG_SHADOW;
	loaded_run(ts_pipeline_find("surfels", "deferred"), &params);
	return 0;
}

/* The stage refuses the value of a component, as it refuses that of a field. */
static void refuses_second(const char *name, u64 element, const char *field, i32 value)
{
	ts_disc *disc = (ts_disc *)ts_frame_data(&run.frame, TS_B_surfel_setup_disc) + element;
	i32 *at = strcmp(field, "low") == 0 ? disc->low : strcmp(field, "high") == 0 ? disc->high : disc->pixel;
	i32 kept = at[1];
	char place[64];
	ts_load load;
	at[1] = value;
	load_for(&load, ts_stage_find(name));
	ts_status status = ts_check(&load, ts_stage_find(name));
	at[1] = kept;
	snprintf(place, sizeof place, "surfel_setup.disc: element %u, field %s[1]: %d (", (unsigned)element, field,
	         (int)value);
	bool told = strstr(ts_error_message(), place) != NULL && strstr(ts_error_message(), "would be right") != NULL;
	if (status != TS_ERROR || !told) fail_msg("%s: %s", place, ts_error_message());
}

/* The first that is drawn, or is not. */
static u64 first_disc(bool drawn)
{
	const ts_disc *discs = ts_frame_data(&run.frame, TS_B_surfel_setup_disc);
	u64 i = 0;
	while ((discs[i].low[0] <= discs[i].high[0]) != drawn) i++;
	return i;
}

/* Kernels write where boxes say. */
static void boxes_beyond_the_image_are_refused(void **state)
{
	(void)state;
	static const char *const readers[] = {"surfel_depth", "surfel_blend", "surfel_blend.mean", "surfel_depth.margin",
	                                      "surfel_blend.margin"};
	u64 n = ts_frame_n(&run.frame, TS_B_surfel_setup_disc), drawn = first_disc(true), empty = first_disc(false);
	for (u32 r = 0; r < sizeof readers / sizeof *readers; r++) {
		const ts_buffer_id id = TS_B_surfel_setup_disc;
		refuses(readers[r], id, drawn, "low", (u32)-1);
		refuses(readers[r], id, n - 1, "low", 0x80000000u);
		refuses(readers[r], id, drawn, "high", 64);
		refuses(readers[r], id, empty, "high", (u32)-2);
		refuses(readers[r], id, 0, "high", 0x7fffffff);
		refuses(readers[r], id, n - 1, "pixel", 1u << 21);
		refuses(readers[r], id, 0, "pixel", 0x80000000u);
		refuses_second(readers[r], drawn, "low", -1);
		refuses_second(readers[r], drawn, "high", 48);
		refuses_second(readers[r], n - 1, "high", INT32_MIN);
		refuses_second(readers[r], 0, "pixel", -(1 << 21));
	}
}

static void the_least_and_the_greatest_are_accepted(void **state)
{
	(void)state;
	ts_load load;
	ts_disc *disc = ts_frame_data(&run.frame, TS_B_surfel_setup_disc), kept = *disc;
	*disc = (ts_disc){.pixel = {(1 << 21) - 1, 1 - (1 << 21)}, .low = {0, 0}, .high = {63, 47}};
	load_for(&load, ts_stage_find("surfel_blend"));
	ts_status status = ts_check(&load, ts_stage_find("surfel_blend"));
	disc->high[0] = disc->high[1] = -1;
	disc->low[0] = INT32_MAX;
	if (status == TS_OK) status = ts_check(&load, ts_stage_find("surfel_blend"));
	*disc = kept;
	if (status != TS_OK) fail_msg("%s", ts_error_message());
}

/* Where there is a fragment the heaviest has a name. */
static void fragments_without_a_heaviest_are_refused(void **state)
{
	(void)state;
	const u64 *sums = ts_frame_data(&run.frame, TS_B_surfel_blend_sum),
			  *heaviest = ts_frame_data(&run.frame, TS_B_surfel_blend_heaviest);
	u64 i = 0, n = ts_frame_n(&run.frame, TS_B_surfel_blend_heaviest);
	while (i < n && heaviest[i] == TS_EMPTY) i++;
	assert_true(i < n && sums[8 * i + 7] > 0);
	refuses("surfel_blend.mean", TS_B_surfel_blend_sum, 8 * i + 7, "", 0);
	refuses("surfel_blend.mean", TS_B_surfel_blend_heaviest, i, "", 0xffffffff);
	ts_load load;
	u64 *names = ts_frame_data(&run.frame, TS_B_surfel_blend_heaviest), kept = names[i];
	char place[64];
	names[i] = TS_EMPTY;
	load_for(&load, ts_stage_find("surfel_blend.mean"));
	ts_status status = ts_check(&load, ts_stage_find("surfel_blend.mean"));
	names[i] = kept;
	snprintf(place, sizeof place, "surfel_blend.sum: element %u", (unsigned)(8 * i + 7));
	assert_int_equal(status, TS_ERROR);
	assert_non_null(strstr(ts_error_message(), place));
	assert_non_null(strstr(ts_error_message(), "no fragment, as surfel_blend.heaviest says, would be right"));
}

/* Keys name surfels, in the half that is an index. */
static void keys_that_name_no_surfel_are_refused(void **state)
{
	(void)state;
	u64 n = ts_frame_n(&run.frame, TS_B_scene_surfel);
	static const struct {
		const char *stage;
		ts_buffer_id id;
	} readers[] = {
		{"surfel_blend", TS_B_surfel_depth_surfel},        {"surfel_blend.mean", TS_B_surfel_depth_surfel},
		{"surfel_blend.mean", TS_B_surfel_blend_heaviest}, {"surfel_depth.margin", TS_B_surfel_depth_surfel},
		{"surfel_blend.margin", TS_B_surfel_depth_surfel}, {"surfel_blend.margin", TS_B_surfel_blend_heaviest},
	};
	for (u32 r = 0; r < sizeof readers / sizeof *readers; r++) {
		refuses(readers[r].stage, readers[r].id, 0, "", n);
		refuses(readers[r].stage, readers[r].id, 64 * 48 - 1, "", 0x3f800000fffffffeull);
	}
}

/* A light that shines all around has six views. */
static void a_point_light_needs_six_views(void **state)
{
	(void)state;
	static const char *const askers[] = {"deferred.lit", "deferred.lit_margin"};
	ts_light *light = ts_frame_data(&run.frame, TS_B_lamp_light);
	u32 kept = light->kind;
	for (u32 k = 0; k < 2; k++) {
		ts_load load;
		light->kind = TS_LIGHT_KIND_POINT;
		load_for(&load, ts_stage_find(askers[k]));
		ts_status status = ts_check(&load, ts_stage_find(askers[k]));
		light->kind = kept;
		assert_int_equal(status, TS_ERROR);
		assert_string_equal(ts_error_message(),
		                    "offscreen.view: 1 views; 6, one a light and six a point light, would be right");
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(what_is_loaded_is_right),
		cmocka_unit_test(boxes_beyond_the_image_are_refused),
		cmocka_unit_test(the_least_and_the_greatest_are_accepted),
		cmocka_unit_test(fragments_without_a_heaviest_are_refused),
		cmocka_unit_test(keys_that_name_no_surfel_are_refused),
		cmocka_unit_test(a_point_light_needs_six_views),
	};
	return cmocka_run_group_tests(tests, begin, end);
}

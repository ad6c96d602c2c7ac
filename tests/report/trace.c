/* Traces of a page: the picture is the trace's display values, or those of its radiance where it holds no others; and
 * what trace.json says. */
#include <math.h>
#include "tests/report/pages.h"
#include "tests/srgb.h"
#include "tests/trace/small.h"

static ts_trace *opened(const char *name)
{
	ts_trace *trace;
	require(ts_trace_open_folder(&trace, scratch_path("%s", name)));
	return trace;
}

static int begin(void **state)
{
	ts_params params = small_params();
	if (scratch_begin(state) != 0) return -1;
	ts_scene *scene = small_scene(&params);
	small_trace(scratch_path("t"), "epr", scene, &params, (ts_trace_options){.margins = false});
	ts_scene_free(scene);
	return 0;
}

static void *all_of(const ts_trace *trace, ts_buffer_id id)
{
	void *data = malloc((size_t)trace->item[id].npy.n * ts_buffer_table[id].element_bytes);
	assert_non_null(data);
	require(ts_trace_copy(data, &trace->item[id], id));
	return data;
}

static void the_picture_is_that_of_the_trace(void **state)
{
	(void)state;
	ts_page *page = new_page(0);
	ts_trace *trace = opened("t");
	require(ts_page_add_trace(page, trace));
	require(ts_page_add_trace(page, trace));
	u8 *rgb = all_of(trace, TS_B_image_srgb);
	for (u32 i = 0; i < 2; i++) {
		const json_t *o = at(page->traces, i), *picture = at(page->pictures, i);
		assert_true(number_of(o, "picture") == i);
		assert_string_equal(text_of(picture, "name"), "epr");
		assert_string_equal(text_of(picture, "from"), scratch_path("t"));
		assert_string_equal(text_of(picture, "trace"), scratch_path("t"));
		assert_true(number_of(picture, "left") == 0 && number_of(picture, "top") == 0);
		assert_shows(get(picture, "png"), rgb, 64, 36, 3);
		assert_memory_equal(page->picture[i].rgb, rgb, 64 * 36 * 3);
		assert_int_equal(page->picture[i].folder, TS_NONE);
	}
	free(rgb);
	ts_trace_close(trace);
	ts_page_free(page);
}

static void a_crop_has_its_place(void **state)
{
	(void)state;
	ts_page *page = new_page(0);
	ts_trace *trace = opened("t");
	trace->item[TS_B_image_srgb].crop[0] = 5;
	trace->item[TS_B_image_srgb].crop[1] = 9;
	require(ts_page_add_trace(page, trace));
	assert_true(number_of(at(page->pictures, 0), "left") == 5 && number_of(at(page->pictures, 0), "top") == 9);
	assert_true(page->picture[0].left == 5 && page->picture[0].top == 9);
	ts_trace_close(trace);
	ts_page_free(page);
}

/* Display value of a radiance, 0 to 255 before rounding. */
static double display(double radiance) { return 255 * srgb_encoded(fmin(fmax(radiance, 0), 1)); }

/* Without display values, or with some of another shape. */
static void without_display_values_radiance_is_shown(void **state)
{
	(void)state;
	for (u32 other = 0; other < 2; other++) {
		ts_page *page = new_page(0);
		ts_trace *trace = opened("t");
		ts_trace_item *srgb = &trace->item[TS_B_image_srgb], kept = *srgb;
		if (other == 0) srgb->path = NULL;
		if (other == 1) srgb->npy.shape[2] = 4;
		trace->params.image_exposure = 3;
		require(ts_page_add_trace(page, trace));
		f32 *radiance = all_of(trace, TS_B_image_radiance);
		u32 lit = 0;
		for (u32 i = 0; i < 64 * 36 * 3; i++) {
			assert_true(fabs(page->picture[0].rgb[i] - display(3.0 * radiance[i])) < 0.501);
			lit += page->picture[0].rgb[i] > 100;
		}
		assert_true(lit > 100);
		assert_shows(get(at(page->pictures, 0), "png"), page->picture[0].rgb, 64, 36, 3);
		free(radiance);
		*srgb = kept;
		ts_trace_close(trace);
		ts_page_free(page);
	}
}

static void a_trace_without_pixels_has_no_picture(void **state)
{
	(void)state;
	ts_page *page = new_page(0);
	ts_trace *trace = opened("t");
	ts_npy *srgb = &trace->item[TS_B_image_srgb].npy, *radiance = &trace->item[TS_B_image_radiance].npy;
	srgb->n_dims = 2;
	radiance->n = 0;
	require(ts_page_add_trace(page, trace));
	assert_int_equal(json_array_size(page->pictures), 0);
	assert_false(has_key(at(page->traces, 0), "picture"));
	ts_trace_close(trace);
	ts_page_free(page);
}

/* What trace.json says of these keys; nothing else. */
static void what_the_trace_says_is_kept(void **state)
{
	(void)state;
	static const char *const keys[] = {"effect",     "paper",  "scene",    "producer", "order",
	                                   "arithmetic", "params", "contract", "stages",   "counters"};
	ts_page *page = new_page(0);
	ts_trace *trace = opened("t");
	json_t *root = json_load_file(scratch_path("t/trace.json"), 0, NULL);
	require(ts_page_add_trace(page, trace));
	const json_t *o = at(page->traces, 0);
	assert_string_equal(text_of(o, "dir"), scratch_path("t"));
	assert_string_equal(text_of(o, "pipeline"), "epr");
	u32 n = 3; /* dir, pipeline and picture */
	for (u32 i = 0; i < sizeof keys / sizeof *keys; i++) {
		if (!has_key(root, keys[i])) continue;
		assert_true(json_equal(get(o, keys[i]), get(root, keys[i])));
		n++;
	}
	assert_true(n > 8 && json_object_size(o) == n);
	json_decref(root);
	ts_trace_close(trace);
	ts_page_free(page);
}

/* A trace whose trace.json went has its names and its picture still. */
static void a_trace_without_json_keeps_its_picture(void **state)
{
	(void)state;
	ts_page *page = new_page(0);
	small_copy(scratch_path("gone"), scratch_path("t"));
	ts_trace *trace = opened("gone");
	unlink(scratch_path("gone/trace.json"));
	require(ts_page_add_trace(page, trace));
	const json_t *o = at(page->traces, 0);
	assert_string_equal(text_of(o, "pipeline"), "epr");
	assert_string_equal(text_of(o, "effect"), "reflections");
	assert_int_equal(json_object_size(o), 4);
	ts_trace_close(trace);
	ts_page_free(page);
}

static void empty_file(const ts_trace *trace, ts_buffer_id id) { file_write(trace->item[id].path, "", 0); }

/* Files that are damaged between the trace's opening and the page. */
static void damaged_traces_are_refused(void **state)
{
	(void)state;
	for (u32 i = 0; i < 3; i++) {
		ts_page *page = new_page(0);
		small_copy(scratch_path("bad"), scratch_path("t"));
		ts_trace *trace = opened("bad");
		char *kept = trace->item[TS_B_image_srgb].path;
		if (i == 0) file_write(scratch_path("bad/trace.json"), "[", 1);
		if (i == 1) empty_file(trace, TS_B_image_srgb);
		if (i == 2) empty_file(trace, TS_B_image_radiance);
		if (i == 2) trace->item[TS_B_image_srgb].path = NULL;
		refused(ts_page_add_trace(page, trace), i == 0 ? "trace.json" : i == 1 ? "image.srgb" : "image.radiance");
		assert_int_equal(page->n_pictures, 0);
		assert_int_equal(json_array_size(page->traces), i != 0);
		trace->item[TS_B_image_srgb].path = kept;
		ts_trace_close(trace);
		ts_page_free(page);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(the_picture_is_that_of_the_trace),
		cmocka_unit_test(a_crop_has_its_place),
		cmocka_unit_test(without_display_values_radiance_is_shown),
		cmocka_unit_test(a_trace_without_pixels_has_no_picture),
		cmocka_unit_test(what_the_trace_says_is_kept),
		cmocka_unit_test(a_trace_without_json_keeps_its_picture),
		cmocka_unit_test(damaged_traces_are_refused),
	};
	return cmocka_run_group_tests(tests, begin, scratch_remove);
}

/* Pictures of stages: as many as there is room for, found by name; what a mask leaves out is the image in grey. */
#include "study/stage_pictures.h"
#include "tests/model/test.h"

static void pictures_are_found_by_their_names(void **state)
{
	(void)state;
	ts_stage_pictures pictures = {.n = 0};
	for (u32 i = 0; i < TS_MAX_STAGE_PICTURES; i++) {
		char name[8];
		snprintf(name, sizeof name, "p%u", (unsigned)i);
		ts_stage_picture *p = ts_stage_pictures_add(&pictures, name, 2 + i, 3, i % 2 == 1);
		assert_non_null(p);
		assert_true(p->width == 2 + i && p->height == 3 && p->zoom == 1 && (p->mask != NULL) == (i % 2 == 1));
		for (u32 k = 0; k < (2 + i) * 3 * 3; k++) assert_int_equal(p->rgb[k], 0);
		for (u32 k = 0; p->mask != NULL && k < (2 + i) * 3; k++) assert_int_equal(p->mask[k], 0);
		assert_ptr_equal(ts_stage_pictures_find(&pictures, name), p);
	}
	assert_null(ts_stage_pictures_find(&pictures, "p"));
	assert_null(ts_stage_pictures_add(&pictures, "more", 1, 1, false));
	assert_non_null(strstr(ts_error_message(), "picture more: one more than 8"));
	assert_int_equal(pictures.n, TS_MAX_STAGE_PICTURES);
	ts_stage_pictures_free(&pictures);
	assert_int_equal(pictures.n, 0);
}

/* Of a picture three times as large as the image, and of one without a mask. */
static void what_a_mask_leaves_out_is_grey(void **state)
{
	(void)state;
	enum { W = 4, H = 3, ZOOM = 3 };
	u8 image[W * H * 3];
	ts_stage_pictures pictures = {.n = 0};
	for (u32 i = 0; i < sizeof image; i++) image[i] = (u8)(i * 53 + 7);
	ts_stage_picture *large = ts_stage_pictures_add(&pictures, "large", W * ZOOM, H * ZOOM, true);
	ts_stage_picture *whole = ts_stage_pictures_add(&pictures, "whole", W, H, false);
	large->zoom = ZOOM;
	memset(large->rgb, 9, W * ZOOM * H * ZOOM * 3);
	memset(whole->rgb, 9, W * H * 3);
	for (u32 i = 0; i < W * ZOOM * H * ZOOM; i++) large->mask[i] = i % 5 == 0;
	ts_stage_pictures_finish(&pictures, image);
	for (u32 y = 0; y < H * ZOOM; y++) {
		for (u32 x = 0; x < W * ZOOM; x++) {
			const u8 *pixel = image + 3 * (y / ZOOM * W + x / ZOOM), *found = large->rgb + 3 * (y * W * ZOOM + x);
			u8 grey = (u8)((pixel[0] + 2 * pixel[1] + pixel[2]) / 12);
			for (u32 c = 0; c < 3; c++) assert_int_equal(found[c], (y * W * ZOOM + x) % 5 == 0 ? 9 : grey);
		}
	}
	for (u32 i = 0; i < W * H * 3; i++) assert_int_equal(whole->rgb[i], 9);
	ts_stage_pictures_free(&pictures);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(pictures_are_found_by_their_names),
	                                   cmocka_unit_test(what_a_mask_leaves_out_is_grey)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Pictures of a page: base64 as RFC 4648 has it, pixels that come back, names that are the page's own; and what does
 * not fit is refused. */
#include "kernels/base/num.h"
#include "tests/report/pages.h"

/* The RFC's own examples. */
static void base64_gives_the_examples(void **state)
{
	(void)state;
	static const char *const examples[][2] = {{"", ""},
	                                          {"f", "Zg=="},
	                                          {"fo", "Zm8="},
	                                          {"foo", "Zm9v"},
	                                          {"foob", "Zm9vYg=="},
	                                          {"fooba", "Zm9vYmE="},
	                                          {"foobar", "Zm9vYmFy"}};
	for (u32 i = 0; i < sizeof examples / sizeof *examples; i++) {
		json_t *value = ts_page_base64(examples[i][0], strlen(examples[i][0]), "a file");
		assert_string_equal(json_string_value(value), examples[i][1]);
		json_decref(value);
	}
}

static void base64_comes_back_the_same(void **state)
{
	(void)state;
	u8 all[600];
	for (u32 i = 0; i < sizeof all; i++) all[i] = (u8)(i * 167 + i / 256);
	for (size_t n = 0; n <= sizeof all; n += n < 70 ? 1 : 53) {
		size_t bytes;
		json_t *value = ts_page_base64(all, n, "a file");
		u8 *back = bytes_of(json_string_value(value), &bytes);
		assert_int_equal(bytes, n);
		assert_memory_equal(back, all, n);
		free(back);
		json_decref(value);
	}
}

static void *none(size_t bytes)
{
	(void)bytes;
	return NULL;
}

static void too_much_for_base64_is_refused(void **state)
{
	(void)state;
	assert_null(ts_page_base64("", ((size_t)1 << 30) + 1, "a film"));
	says("a film: 1073741825 bytes; at most 1073741824 fit into a page");
	json_malloc_t old;
	json_free_t release;
	json_get_alloc_funcs(&old, &release);
	json_set_alloc_funcs(none, release);
	json_t *value = ts_page_base64("foo", 3, "a small file");
	json_set_alloc_funcs(old, release);
	assert_null(value);
	says("a small file: out of memory");
}

static void pictures_come_back_from_png(void **state)
{
	(void)state;
	u8 pixels[7 * 5 * 3];
	for (u32 i = 0; i < sizeof pixels; i++) pixels[i] = (u8)(i * 89);
	for (u32 channels = 1; channels <= 3; channels += 2) {
		json_t *png = ts_page_png(pixels, 7, 5, channels, "a picture");
		assert_shows(png, pixels, 7, 5, channels);
		json_decref(png);
	}
}

static void an_added_picture_is_a_copy(void **state)
{
	(void)state;
	u8 rgb[3 * 2 * 3], kept[sizeof rgb];
	char name[] = "first";
	ts_page *page = new_page(0);
	for (u32 i = 0; i < sizeof rgb; i++) rgb[i] = kept[i] = (u8)(i * 31);
	require(ts_page_add_picture(page, name, "a/folder", rgb, 3, 2));
	memset(rgb, 0, sizeof rgb);
	name[0] = 'x';
	require(ts_page_add_picture(page, "second", "b\xff", rgb, 2, 3));
	const json_t *first = at(page->pictures, 0), *second = at(page->pictures, 1);
	assert_int_equal(json_array_size(page->pictures), 2);
	assert_int_equal(page->n_pictures, 2);
	assert_string_equal(page->picture[0].name, "first");
	assert_string_equal(page->picture[0].group, "");
	assert_int_equal(page->picture[0].folder, TS_NONE);
	assert_memory_equal(page->picture[0].rgb, kept, sizeof kept);
	assert_string_equal(text_of(first, "name"), "first");
	assert_string_equal(text_of(first, "from"), "a/folder");
	assert_true(json_is_true(get(first, "judged")));
	assert_true(number_of(first, "width") == 3 && number_of(first, "height") == 2);
	assert_true(number_of(first, "left") == 0 && number_of(first, "top") == 0);
	assert_shows(get(first, "png"), kept, 3, 2, 3);
	assert_string_equal(text_of(second, "name"), "second");
	assert_shows(get(second, "png"), rgb, 2, 3, 3);
	ts_page_free(page);
}

/* A picture that is a part of the eye's, and is only shown. */
static void a_taken_picture_is_only_shown(void **state)
{
	(void)state;
	ts_page *page = new_page(0);
	ts_page_picture p = {
		.name = (char *)"part", .group = (char *)"frame", .width = 4, .height = 5, .left = 6, .top = 7};
	for (u32 i = 0; i < 40; i++) {
		const json_t *o = ts_page_take(page, &p, "somewhere", json_integer(i));
		assert_non_null(o);
		assert_ptr_equal(o, at(page->pictures, i));
		assert_true(json_is_false(get(o, "judged")) && number_of(o, "png") == i);
		assert_true(number_of(o, "width") == 4 && number_of(o, "height") == 5);
		assert_true(number_of(o, "left") == 6 && number_of(o, "top") == 7);
		assert_string_equal(page->picture[i].group, "frame");
	}
	assert_null(ts_page_take(page, &p, "somewhere", NULL));
	assert_int_equal(page->n_pictures, 40);
	ts_page_free(page);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(base64_gives_the_examples),      cmocka_unit_test(base64_comes_back_the_same),
		cmocka_unit_test(too_much_for_base64_is_refused), cmocka_unit_test(pictures_come_back_from_png),
		cmocka_unit_test(an_added_picture_is_a_copy),     cmocka_unit_test(a_taken_picture_is_only_shown),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

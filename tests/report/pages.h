/* What the tests of pages share: pages in memory, pictures, and the pixels that a page holds. */
#ifndef TS_TESTS_REPORT_PAGES_H
#define TS_TESTS_REPORT_PAGES_H
#include <touchstone/image.h>
#include "report/page.h"
#include "tests/trace/folder.h"

static inline ts_page *new_page(u32 n_probes)
{
	ts_page *page = ts_page_make(67, n_probes);
	assert_non_null(page);
	return page;
}

static inline const json_t *at(const json_t *array, size_t i)
{
	const json_t *found = json_array_get(array, i);
	if (found == NULL) fail_msg("there are only %zu", json_array_size(array));
	return found;
}

static inline const json_t *get(const json_t *object, const char *key)
{
	const json_t *found = json_object_get(object, key);
	if (found == NULL) fail_msg("no %s", key);
	return found;
}

static inline const char *text_of(const json_t *object, const char *key) { return json_string_value(get(object, key)); }

static inline json_int_t number_of(const json_t *object, const char *key)
{
	assert_true(json_is_integer(get(object, key)));
	return json_integer_value(get(object, key));
}

static inline bool has_key(const json_t *object, const char *key) { return json_object_get(object, key) != NULL; }

/* The bytes of base64 by RFC 4648, by free(). */
static inline u8 *bytes_of(const char *text, size_t *bytes)
{
	static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
	size_t n = strlen(text);
	u8 *to = malloc(n + 1);
	assert_non_null(to);
	assert_int_equal(n % 4, 0);
	*bytes = 0;
	u32 held = 0, bits = 0;
	for (size_t i = 0; i < n && text[i] != '='; i++) {
		const char *digit = strchr(digits, text[i]);
		assert_non_null(digit);
		held = (held << 6 | (u32)(digit - digits)) & 0xffff;
		bits += 6;
		if (bits < 8) continue;
		bits -= 8;
		to[(*bytes)++] = (u8)(held >> bits);
	}
	return to;
}

/* The pixels of a picture of a page, RGBA, by free(). */
static inline u8 *pixels_of(const json_t *png, u32 *width, u32 *height)
{
	size_t bytes;
	u8 *rgba, *file = bytes_of(json_string_value(png), &bytes);
	require(ts_image_decode(&rgba, width, height, file, bytes, 1 << 20, "a picture of a page"));
	free(file);
	return rgba;
}

/* The picture shows these pixels. */
static inline void assert_shows(const json_t *png, const u8 *pixels, u32 width, u32 height, u32 channels)
{
	u32 w, h;
	u8 *rgba = pixels_of(png, &w, &h);
	assert_true(w == width && h == height);
	for (size_t i = 0; i < (size_t)w * h; i++) {
		for (u32 c = 0; c < 3; c++) assert_int_equal(rgba[4 * i + c], pixels[channels * i + (channels == 1 ? 0 : c)]);
	}
	free(rgba);
}

#endif

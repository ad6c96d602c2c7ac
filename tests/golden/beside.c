/* What a golden has beside its buffers: pictures that differ in one pixel, reasons that say nothing. */
#include "golden/beside.h"
#include "tests/golden/dir.h"

enum { WIDTH = 5, HEIGHT = 4 };

static u8 stored[4 * WIDTH * HEIGHT];
static u32 stored_width = WIDTH;

/* The picture that is stored is ours, of whatever the file is. */
static ts_status decode(u8 **rgba, u32 *width, u32 *height, const void *file, size_t bytes, u64 most_pixels,
                        const char *what)
{
	*rgba = NULL;
	assert_true(bytes == 3 && memcmp(file, "png", 3) == 0 && most_pixels == TS_GOLDEN_PIXELS);
	if (stored_width == 0) return ts_fail("%s: not a picture", what);
	*width = stored_width;
	*height = HEIGHT;
	*rgba = malloc(sizeof stored);
	assert_non_null(*rgba);
	memcpy(*rgba, stored, sizeof stored);
	return TS_OK;
}

/* Each channel of each pixel; alpha is nothing. */
static void a_wrong_preview_pixel_is_told(void **state)
{
	(void)state;
	static ts_golden golden;
	char text[TS_GOLDEN_TEXT], right[128], pixels[3 * WIDTH * HEIGHT];
	assert_int_equal(ts_golden_check_preview(text, &dir, &golden, decode), TS_OK); /* no image */
	golden.file[TS_B_image_srgb] = (ts_golden_file){.data = pixels, .npy = {.n_dims = 3, .shape = {HEIGHT, WIDTH, 3}}};
	for (u32 i = 0; i < WIDTH * HEIGHT; i++) {
		for (u32 k = 0; k < 3; k++) pixels[3 * i + k] = (char)(stored[4 * i + k] = (u8)(7 * i + 50 * k));
		stored[4 * i + 3] = (u8)i;
	}
	refused(ts_golden_check_preview(text, &dir, &golden, decode), "preview.png: No such file");
	write_file("preview.png", "png", 3);
	assert_int_equal(ts_golden_check_preview(text, &dir, &golden, decode), TS_OK);
	for (u32 i = 0; i < WIDTH * HEIGHT; i++) {
		for (u32 k = 0; k < 3; k++) {
			u8 *at = &stored[4 * i], was = at[k];
			at[k] ^= 1;
			assert_int_equal(ts_golden_check_preview(text, &dir, &golden, decode), TS_DIFFERENT);
			const u8 *here = (const u8 *)&pixels[3 * i];
			snprintf(right, sizeof right, "preview.png: pixel [%u, %u]: golden %u %u %u here %u %u %u",
			         (unsigned)(i / WIDTH), (unsigned)(i % WIDTH), at[0], at[1], at[2], here[0], here[1], here[2]);
			assert_string_equal(text, right);
			at[k] = was;
		}
	}
	stored_width = WIDTH - 1;
	assert_int_equal(ts_golden_check_preview(text, &dir, &golden, decode), TS_DIFFERENT);
	assert_string_equal(text, "preview.png: golden 4 by 4 pixels here 5 by 4");
	stored_width = 0;
	refused(ts_golden_check_preview(text, &dir, &golden, decode), "preview.png: not a picture");
}

static void a_reason_is_one_line(void **state)
{
	(void)state;
	char reason[TS_REASON_BYTES + 2];
	assert_int_equal(ts_reason_check("why"), TS_OK);
	assert_int_equal(ts_reason_check(" \u00e4 reason, of words "), TS_OK);
	refused(ts_reason_check(""), "no reason");
	refused(ts_reason_check(" \t "), "no reason");
	refused(ts_reason_check("two\nlines"), "a reason is one line");
	refused(ts_reason_check("a\x01"), "a reason is one line");
	memset(reason, 'x', sizeof reason);
	reason[TS_REASON_BYTES] = 0;
	assert_int_equal(ts_reason_check(reason), TS_OK);
	reason[TS_REASON_BYTES] = 'x';
	reason[TS_REASON_BYTES + 1] = 0;
	refused(ts_reason_check(reason), "at most 400 bytes");
}

static void changes_say(const char *text, size_t n, const char *words)
{
	write_file("CHANGES", text, n);
	if (words == NULL) assert_int_equal(ts_golden_check_changes(&dir), TS_OK);
	if (words != NULL) refused(ts_golden_check_changes(&dir), words);
}

static void changes_are_lines_of_reasons(void **state)
{
	(void)state;
	refused(ts_golden_check_changes(&dir), "CHANGES: No such file");
	changes_say("one\ntwo\n", 8, NULL);
	changes_say("", 0, "CHANGES: not lines of text");
	changes_say("one\ntwo", 7, "CHANGES: not lines of text");
	changes_say("one\0\n", 5, "CHANGES: not lines of text");
	changes_say("one\n\n", 5, "CHANGES: line 2: no reason");
	changes_say("one\ntwo\nth\x7free\n", 15, "CHANGES: line 3: a reason is one line");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_wrong_preview_pixel_is_told),
		cmocka_unit_test(a_reason_is_one_line),
		cmocka_unit_test(changes_are_lines_of_reasons),
	};
	return cmocka_run_group_tests(tests, dir_begin, dir_end);
}

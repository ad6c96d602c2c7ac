/* Image files: what is written is read back, what is damaged or too large is refused. */
#include <touchstone/image.h>
#include <unistd.h>
#include "tests/scratch.h"
#include "tests/status.h"

enum { WIDTH = 13, HEIGHT = 7, TEXELS = WIDTH * HEIGHT };

static const char *path; /* of the file in hand */

static const char *name(const char *leaf) { return path = scratch_path("%s", leaf); }

static uint8_t value(unsigned i) { return (uint8_t)(i * 2654435761u >> 24); }

static size_t slurp(uint8_t *data, size_t most)
{
	FILE *file = fopen(path, "rb");
	assert_non_null(file);
	size_t n = fread(data, 1, most, file);
	fclose(file);
	return n;
}

static void assert_gone(void)
{
	char partial[SCRATCH_PATH + 8];
	snprintf(partial, sizeof partial, "%s.partial", path);
	assert_int_not_equal(access(partial, F_OK), 0);
	assert_int_equal(unlink(path), 0);
}

static void a_png_is_read_back_the_same(void **state)
{
	(void)state;
	for (uint32_t channels = 1; channels <= 4; channels++) {
		if (channels == 2) continue;
		uint8_t pixels[TEXELS * 4], file[8192], *rgba;
		uint32_t width, height;
		for (unsigned i = 0; i < TEXELS * channels; i++) pixels[i] = value(i);
		assert_int_equal(ts_image_write_png(name("a.png"), pixels, WIDTH, HEIGHT, channels, NULL), TS_OK);
		size_t n = slurp(file, sizeof file);
		assert_int_equal(ts_image_decode(&rgba, &width, &height, file, n, TEXELS, "a.png"), TS_OK);
		assert_int_equal(width, WIDTH);
		assert_int_equal(height, HEIGHT);
		for (unsigned i = 0; i < TEXELS; i++) {
			for (unsigned c = 0; c < 3; c++)
				assert_int_equal(rgba[4 * i + c], pixels[i * channels + (channels == 1 ? 0 : c)]);
			assert_int_equal(rgba[4 * i + 3], channels == 4 ? pixels[4 * i + 3] : 255);
		}
		free(rgba);
		assert_gone();
	}
}

static void a_png_is_read_as_floats(void **state)
{
	(void)state;
	uint8_t pixels[TEXELS * 3];
	uint32_t width, height, channels;
	float *read;
	for (unsigned i = 0; i < TEXELS * 3; i++) pixels[i] = value(i);
	assert_int_equal(ts_image_write_png(name("b.png"), pixels, WIDTH, HEIGHT, 3, NULL), TS_OK);
	assert_int_equal(ts_image_read(&read, &width, &height, &channels, path), TS_OK);
	assert_true(width == WIDTH && height == HEIGHT && channels == 3);
	for (unsigned i = 0; i < TEXELS * 3; i++) assert_true(read[i] == (float)pixels[i] / 255.0f);
	free(read);
	assert_gone();
}

static void an_exr_is_read_back_the_same(void **state)
{
	(void)state;
	for (uint32_t n_channels = 1; n_channels <= 4; n_channels++) {
		if (n_channels == 2) continue;
		float pixels[TEXELS * 4], *read;
		uint32_t width, height, channels;
		for (unsigned i = 0; i < TEXELS * n_channels; i++) pixels[i] = (float)value(i) * 1234.5f - 3.0f;
		assert_int_equal(ts_image_write_exr(name("c.exr"), pixels, WIDTH, HEIGHT, n_channels, NULL), TS_OK);
		assert_int_equal(ts_image_read(&read, &width, &height, &channels, path), TS_OK);
		assert_true(width == WIDTH && height == HEIGHT && channels == n_channels);
		assert_memory_equal(read, pixels, sizeof(float) * TEXELS * n_channels);
		free(read);
		assert_gone();
	}
}

/* In memory a file has the bytes that it has on disk, and is read as well. */
static void files_in_memory_are_those_on_disk(void **state)
{
	(void)state;
	const ts_image_text texts[] = {{"Source", "a test"}, {NULL, NULL}};
	uint8_t codes[TEXELS * 3], file[8192];
	float light[TEXELS * 3], *read;
	for (unsigned i = 0; i < TEXELS * 3; i++) light[i] = (float)(codes[i] = value(i)) / 255.0f;
	for (int exr = 0; exr < 2; exr++) {
		void *made;
		size_t n = 0;
		uint32_t width, height, channels;
		assert_int_equal(exr ? ts_image_write_exr(name("m.exr"), light, WIDTH, HEIGHT, 3, texts)
		                     : ts_image_write_png(name("m.png"), codes, WIDTH, HEIGHT, 3, texts),
		                 TS_OK);
		assert_int_equal(exr ? ts_image_encode_exr(&made, &n, light, WIDTH, HEIGHT, 3, texts, "m")
		                     : ts_image_encode_png(&made, &n, codes, WIDTH, HEIGHT, 3, texts, "m"),
		                 TS_OK);
		assert_int_equal(slurp(file, sizeof file), n);
		assert_memory_equal(made, file, n);
		assert_int_equal(ts_image_read_bytes(&read, &width, &height, &channels, made, n, "m"), TS_OK);
		assert_true(width == WIDTH && height == HEIGHT && channels == 3);
		assert_memory_equal(read, light, sizeof light);
		free(read);
		assert_int_equal(ts_image_read_bytes(&read, &width, &height, &channels, made, n / 2, "m"), TS_ERROR);
		says("m: ");
		assert_null(read);
		free(made);
		assert_gone();
	}
}

/* A picture that no file holds. */
static void odd_sizes_are_refused_by_name(void **state)
{
	(void)state;
	static const uint32_t odd[][3] = {{0, 1, 3}, {1, 0, 3},        {1, 1, 2},
	                                  {1, 1, 5}, {1u << 31, 1, 1}, {1 << 15, 1 << 15, 1}};
	for (size_t i = 0; i < sizeof odd / sizeof *odd; i++) {
		void *made;
		size_t n;
		const float light[4] = {0};
		assert_int_equal(
			ts_image_encode_png(&made, &n, (const uint8_t *)"odd", odd[i][0], odd[i][1], odd[i][2], NULL, "odd"),
			TS_ERROR);
		says("odd: ");
		assert_null(made);
		assert_int_equal(ts_image_write_exr(name("o.exr"), light, odd[i][0], odd[i][1], odd[i][2], NULL), TS_ERROR);
		says("channels would be right");
		assert_int_not_equal(access(path, F_OK), 0);
	}
}

static void refuse(const uint8_t *file, size_t n, uint64_t most, const char *words)
{
	uint8_t *rgba;
	uint32_t width, height;
	assert_int_equal(ts_image_decode(&rgba, &width, &height, file, n, most, "picture"), TS_ERROR);
	assert_null(rgba);
	says(words);
}

/* A header that claims too much, a cut at every byte, and noise. */
static void damaged_bytes_are_refused(void **state)
{
	(void)state;
	uint8_t pixels[TEXELS * 3] = {0}, file[8192];
	assert_int_equal(ts_image_write_png(name("d.png"), pixels, WIDTH, HEIGHT, 3, NULL), TS_OK);
	size_t n = slurp(file, sizeof file);
	refuse(file, n, TEXELS - 1, "at most 90 texels");
	for (size_t cut = 0; cut < 40; cut++) refuse(file, cut, TEXELS, "picture");
	file[0] ^= 1;
	refuse(file, n, TEXELS, "neither PNG nor JPEG");
	static const uint8_t jpeg[] = {0xff, 0xd8, 0xff, 0xe0, 0,    4,    0, 0, 0xff, 0xc2, 0,
	                               11,   8,    0xff, 0xff, 0xff, 0xff, 1, 1, 17,   0};
	refuse(jpeg, sizeof jpeg, 1u << 20, "65535 by 65535");
	assert_gone();
}

/* What ts_image_read says of a file; nothing else is said, by no library. */
static void refuse_file(const void *data, size_t n, const char *words)
{
	float *read;
	uint32_t width, height, channels;
	FILE *file = fopen(name("f.png"), "wb");
	assert_true(file != NULL && fwrite(data, 1, n, file) == n && fclose(file) == 0);
	FILE *said = tmpfile();
	int before = dup(2);
	assert_true(said != NULL && before >= 0 && dup2(fileno(said), 2) == 2);
	ts_status status = ts_image_read(&read, &width, &height, &channels, path);
	long n_said = fseek(said, 0, SEEK_END) == 0 ? ftell(said) : -1;
	assert_int_equal(dup2(before, 2), 2);
	close(before);
	fclose(said);
	assert_int_equal(status, TS_ERROR);
	assert_null(read);
	assert_int_equal(n_said, 0);
	says(words);
	assert_gone();
}

/* Files cut short, and one whose header says more pixels than it can hold. */
static void damaged_files_are_refused(void **state)
{
	(void)state;
	uint8_t file[8192];
	float light[TEXELS * 3] = {0};
	assert_int_equal(ts_image_write_png(name("d.png"), (uint8_t *)light, WIDTH, HEIGHT, 3, NULL), TS_OK);
	size_t n = slurp(file, sizeof file);
	assert_gone();
	for (size_t cut = 8; cut < n; cut++) refuse_file(file, cut, "it is cut short");
	assert_int_equal(ts_image_write_exr(name("d.exr"), light, WIDTH, HEIGHT, 3, NULL), TS_OK);
	n = slurp(file, sizeof file);
	assert_gone();
	for (size_t cut = 4; cut < n; cut += 7) refuse_file(file, cut, "f.png: ");
	uint8_t *window = file + n - 1;
	while (memcmp(window, "dataWindow\0box2i\0\20\0\0\0", 21) != 0) window--;
	window[21 + 10] = 0x7f; /* of the end of a row */
	refuse_file(file, n, "pixels are justified");
}

/* As a file of few bytes may say, if they are packed as deflate packs one value. */
static void pictures_of_one_value_are_read(void **state)
{
	(void)state;
	enum { SIDE = 4200 };
	float *read;
	uint32_t width, height, channels;
	uint8_t *pixels = malloc((size_t)SIDE * SIDE);
	assert_non_null(pixels);
	memset(pixels, 51, (size_t)SIDE * SIDE);
	assert_int_equal(ts_image_write_png(name("g.png"), pixels, SIDE, SIDE, 1, NULL), TS_OK);
	free(pixels);
	assert_int_equal(ts_image_read(&read, &width, &height, &channels, path), TS_OK);
	assert_true(width == SIDE && height == SIDE && channels == 1);
	for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) assert_true(read[i] == 51 / 255.0f);
	free(read);
	assert_gone();
}

static void bad_paths_are_named(void **state)
{
	(void)state;
	uint8_t pixel[3] = {1, 2, 3};
	float *read;
	uint32_t width, height, channels;
	assert_int_equal(ts_image_write_png(name("absent/e.png"), pixel, 1, 1, 3, NULL), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "absent/e.png"));
	assert_int_equal(ts_image_read(&read, &width, &height, &channels, name("none.png")), TS_ERROR);
	assert_null(read);
	assert_non_null(strstr(ts_error_message(), "none.png"));
	assert_int_equal(ts_image_read(&read, &width, &height, &channels, scratch_root), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "not a regular file"));
}

/* What is none of the three formats does not reach the module. */
static void other_formats_are_refused(void **state)
{
	static const char *const heads[3] = {"", "GIF89a", "P6 1 1 255 abc"};
	(void)state;
	for (int i = 0; i < 3; i++) {
		float *read;
		uint32_t width, height, channels;
		FILE *file = fopen(name("f.png"), "wb");
		assert_non_null(file);
		fputs(heads[i], file);
		fclose(file);
		assert_int_equal(ts_image_read(&read, &width, &height, &channels, path), TS_ERROR);
		assert_null(read);
		assert_non_null(
			strstr(ts_error_message(), i == 1 ? ": GIF; a PNG, JPEG or EXR" : "of no format; a PNG, JPEG or EXR"));
		assert_gone();
	}
}

static void texts_have_names_and_words(void **state)
{
	(void)state;
	static const char eighty[] = "12345678901234567890123456789012345678901234567890123456789012345678901234567890";
	const ts_image_text wrong[] = {{"", "a"}, {"a\nb", "c"}, {eighty, "a"}, {"caf\xc3\xa9", "a"}, {"a", NULL}};
	const uint8_t grey = 0;
	const float light = 0;
	void *file;
	size_t bytes;
	for (unsigned i = 0; i < sizeof wrong / sizeof *wrong; i++) {
		const ts_image_text texts[] = {{"good", ""}, wrong[i], {NULL, NULL}};
		assert_int_equal(ts_image_encode_png(&file, &bytes, &grey, 1, 1, 1, texts, "a.png"), TS_ERROR);
		says("a.png: a text's name has 1 to 79 characters");
		assert_int_equal(ts_image_encode_exr(&file, &bytes, &light, 1, 1, 1, texts, "a.exr"), TS_ERROR);
		assert_null(file);
	}
	const ts_image_text good[] = {{eighty + 1, "words\nand lines"}, {NULL, NULL}};
	assert_int_equal(ts_image_encode_png(&file, &bytes, &grey, 1, 1, 1, good, "a.png"), TS_OK);
	free(file);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_png_is_read_back_the_same),       cmocka_unit_test(a_png_is_read_as_floats),
		cmocka_unit_test(an_exr_is_read_back_the_same),      cmocka_unit_test(damaged_bytes_are_refused),
		cmocka_unit_test(pictures_of_one_value_are_read),    cmocka_unit_test(bad_paths_are_named),
		cmocka_unit_test(other_formats_are_refused),         cmocka_unit_test(damaged_files_are_refused),
		cmocka_unit_test(files_in_memory_are_those_on_disk), cmocka_unit_test(odd_sizes_are_refused_by_name),
		cmocka_unit_test(texts_have_names_and_words),
	};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_end);
}

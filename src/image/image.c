/* Image files: PNG by libpng, the others by the module. Input is untrusted: the header's size is checked here before
 * the module sees a file, and of a PNG libpng sees a checked copy. */
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <touchstone/image.h>
#include "image/codec.h"
#include "image/exr.h"
#include "image/format.h"
#include "image/png.h"
#include "model/input.h"
#include "model/library.h"
#include "output/file.h"

enum { MOST_PIXELS = 1 << 28 }; /* for reading and writing */
/* Of a PNG: a page whatever its bytes, and what deflate can make of these. */
enum { FREE_PIXELS = 1 << 24, PIXELS_A_BYTE = 1032 };

static const ts_image_codec *codec;

static ts_status load(const char *what)
{
	void *module;
	ts_status status = ts_library_open(&module, TS_IMAGE_MODULE, RTLD_NOW | RTLD_LOCAL);
	if (status == TS_SKIPPED) {
		return ts_fail("%s: images need a module that did not load, in Debian the package touchstone-image: %s", what,
		               ts_error_message());
	}
	if (status != TS_OK) return ts_fail("%s: the module of images does not open: %s", what, ts_error_message());
	codec = dlsym(module, "ts_image_codec_module");
	return codec != NULL ? TS_OK : ts_fail_as(TS_KIND_LIBRARY, "%s: " TS_IMAGE_MODULE ": not ours", what);
}

ts_status ts_image_load(const char *what)
{
	static pthread_mutex_t one = PTHREAD_MUTEX_INITIALIZER;
	pthread_mutex_lock(&one);
	ts_floats_hold(1);
	ts_status status = codec != NULL ? TS_OK : load(what);
	ts_floats_give();
	pthread_mutex_unlock(&one);
	return status;
}

/* The status of a call of the module: its libraries compute without traps, and it has the message. */
#define CODEC(call) (ts_floats_hold(1), end_call(codec->call))
static ts_status end_call(ts_status status)
{
	ts_floats_give();
	return status == TS_OK ? TS_OK : ts_fail_as(codec->kind(), "%s", codec->message());
}

static uint32_t big_endian(const uint8_t *p, int n)
{
	uint32_t value = 0;
	for (int i = 0; i < n; i++) value = value << 8 | p[i];
	return value;
}

static void png_size(uint32_t size[2], const uint8_t *p, size_t n)
{
	if (n < 24 || memcmp(p + 12, "IHDR", 4) != 0) return;
	size[0] = big_endian(p + 16, 4);
	size[1] = big_endian(p + 20, 4);
}

/* The first frame header (SOF0 to SOF15 without DHT, JPG and DAC). */
static void jpeg_size(uint32_t size[2], const uint8_t *p, size_t n)
{
	for (size_t at = 2; at + 9 <= n;) {
		if (p[at] != 0xff) return;
		unsigned marker = p[at + 1];
		bool bare = marker == 0xff || marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8);
		if (marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc) {
			size[0] = big_endian(p + at + 7, 2);
			size[1] = big_endian(p + at + 5, 2);
			return;
		}
		if (marker == 0xff)
			at += 1;
		else
			at += bare ? 2 : 2 + big_endian(p + at + 2, 2);
	}
}

static ts_status read_png(ts_png *image, const void *file, size_t file_bytes, const char *what)
{
	uint8_t *clean = NULL;
	size_t clean_bytes = 0;
	image->codes = NULL;
	ts_status status = ts_png_clean(&clean, &clean_bytes, file, file_bytes, what);
	if (status == TS_OK) status = ts_png_read(image, clean, clean_bytes, what);
	free(clean);
	return status;
}

static uint8_t code_at(const ts_png *image, size_t i)
{
	if (image->bits == 8) return ((const uint8_t *)image->codes)[i];
	return (uint8_t)((((const uint16_t *)image->codes)[i] * 255u + 32767u) / 65535u);
}

/* Grey is replicated, missing alpha is 255. */
static void to_rgba(uint8_t *rgba, const ts_png *image)
{
	const size_t n = image->channels, green = n < 3 ? 0 : 1;
	for (size_t i = 0; i < (size_t)image->width * image->height; i++) {
		for (size_t c = 0; c < 3; c++) rgba[4 * i + c] = code_at(image, n * i + c * green);
		rgba[4 * i + 3] = n % 2 == 0 ? code_at(image, n * i + n - 1) : 255;
	}
}

static ts_status decode_png(uint8_t *rgba, const void *file, size_t file_bytes, const char *what)
{
	ts_png image;
	ts_status status = read_png(&image, file, file_bytes, what);
	if (status == TS_OK) to_rgba(rgba, &image);
	free(image.codes);
	return status;
}

static ts_status decode_jpeg(uint8_t *rgba, const uint32_t size[2], const void *file, size_t file_bytes,
                             const char *what)
{
	if (ts_image_load(what) != TS_OK) return TS_ERROR;
	return CODEC(decode(rgba, size[0], size[1], "jpeg", file, file_bytes, what));
}

static ts_status decode_file(uint8_t **rgba, uint32_t *width, uint32_t *height, const void *file, size_t file_bytes,
                             uint64_t max_texels, const char *what)
{
	const char *name = "its first bytes are those of no format";
	ts_image_format format = ts_image_format_find(file, file_bytes, &name);
	bool png = format == TS_IMAGE_PNG;
	uint32_t size[2] = {0, 0};
	*rgba = NULL;
	if (!ts_image_format_is_decoded(format)) return ts_fail("%s: neither PNG nor JPEG: %s", what, name);
	(png ? png_size : jpeg_size)(size, file, file_bytes);
	if (size[0] == 0 || size[1] == 0) return ts_fail("%s: no width or height in its header", what);
	if (size[0] > max_texels / size[1])
		return ts_fail("%s: its header says %u by %u; at most %llu texels are justified", what, size[0], size[1],
		               (unsigned long long)max_texels);
	uint8_t *made = ts_alloc((size_t)size[0] * size[1], 4, what);
	if (made == NULL) return TS_ERROR;
	ts_status status = png ? decode_png(made, file, file_bytes, what) : decode_jpeg(made, size, file, file_bytes, what);
	if (status != TS_OK) {
		free(made);
		return status;
	}
	*rgba = made;
	*width = size[0];
	*height = size[1];
	return TS_OK;
}

ts_status ts_image_decode(uint8_t **rgba, uint32_t *width, uint32_t *height, const void *file, size_t file_bytes,
                          uint64_t max_texels, const char *what)
{
	if (TS_LACKS(rgba) || TS_LACKS(width) || TS_LACKS(height) || TS_LACKS(file) || TS_LACKS(what)) return TS_ERROR;
	return ts_blame(decode_file(rgba, width, height, file, file_bytes, max_texels, what), TS_KIND_FORMAT);
}

static ts_status check_picture(const char *what, uint32_t width, uint32_t height, uint32_t channels)
{
	bool right = width > 0 && height > 0 && (channels == 1 || channels == 3 || channels == 4);
	if (right && width <= MOST_PIXELS / height) return TS_OK;
	return ts_fail("%s: %lu x %lu pixels of %lu channels; 1 to %lu pixels of 1, 3 or 4 channels would be right", what,
	               (unsigned long)width, (unsigned long)height, (unsigned long)channels, (unsigned long)MOST_PIXELS);
}

static ts_status check_texts(const char *what, const ts_image_text *texts)
{
	for (; texts != NULL && texts->name != NULL; texts++) {
		const size_t n = strlen(texts->name);
		bool right = n >= 1 && n <= 79 && texts->text != NULL;
		for (size_t i = 0; i < n; i++) right &= texts->name[i] >= 32 && texts->name[i] <= 126;
		if (!right) return ts_fail("%s: a text's name has 1 to 79 characters of printable ASCII, and a text", what);
	}
	return TS_OK;
}

ts_status ts_image_encode_png(void **file, size_t *file_bytes, const uint8_t *pixels, uint32_t width, uint32_t height,
                              uint32_t channels, const ts_image_text *texts, const char *what)
{
	if (TS_LACKS(file)) return TS_ERROR;
	*file = NULL;
	if (TS_LACKS(file_bytes) || TS_LACKS(pixels) || TS_LACKS(what)) return TS_ERROR;
	if (check_picture(what, width, height, channels) != TS_OK || check_texts(what, texts) != TS_OK) return TS_ERROR;
	return ts_png_write(file, file_bytes, pixels, width, height, channels, texts, what);
}

ts_status ts_image_encode_exr(void **file, size_t *file_bytes, const float *pixels, uint32_t width, uint32_t height,
                              uint32_t channels, const ts_image_text *texts, const char *what)
{
	if (TS_LACKS(file)) return TS_ERROR;
	*file = NULL;
	if (TS_LACKS(file_bytes) || TS_LACKS(pixels) || TS_LACKS(what)) return TS_ERROR;
	if (check_picture(what, width, height, channels) != TS_OK || check_texts(what, texts) != TS_OK) return TS_ERROR;
	if (ts_image_load(what) != TS_OK) return TS_ERROR;
	return CODEC(encode_exr(file, file_bytes, what, pixels, width, height, channels, texts));
}

/* Puts an encoded file, which is freed, in its place. */
static ts_status put(const char *path, ts_status encoded, void *file, size_t bytes)
{
	ts_status status = encoded == TS_OK ? ts_file_replace(path, file, bytes) : TS_ERROR;
	free(file);
	return status;
}

ts_status ts_image_write_png(const char *path, const uint8_t *pixels, uint32_t width, uint32_t height,
                             uint32_t channels, const ts_image_text *texts)
{
	void *file;
	size_t bytes = 0;
	if (TS_LACKS(path)) return TS_ERROR;
	ts_status status = ts_image_encode_png(&file, &bytes, pixels, width, height, channels, texts, path);
	return put(path, status, file, bytes);
}

ts_status ts_image_write_exr(const char *path, const float *pixels, uint32_t width, uint32_t height, uint32_t channels,
                             const ts_image_text *texts)
{
	void *file;
	size_t bytes = 0;
	if (TS_LACKS(path)) return TS_ERROR;
	ts_status status = ts_image_encode_exr(&file, &bytes, pixels, width, height, channels, texts, path);
	return put(path, status, file, bytes);
}

#define EXPECTED "%s: %s; a PNG, JPEG or EXR is expected"

static bool is_read(ts_image_format format) { return format == TS_IMAGE_EXR || ts_image_format_is_decoded(format); }

ts_status ts_image_format_of(ts_image_format *format, const char *path)
{
	uint8_t head[TS_IMAGE_HEAD];
	size_t n;
	if (ts_input_head(&n, head, sizeof head, path) != TS_OK)
		return ts_fail_as(TS_KIND_FILE, "%s; a PNG, JPEG or EXR is expected", ts_error_message());
	const char *name = "its first bytes are those of no format";
	*format = ts_image_format_find(head, n, &name);
	return is_read(*format) ? TS_OK : ts_fail(EXPECTED, path, name);
}

static ts_status floats_of(float **pixels, const ts_png *image, const char *what)
{
	const size_t n = (size_t)image->width * image->height * image->channels;
	*pixels = ts_alloc(n, sizeof **pixels, what);
	for (size_t i = 0; i < n && *pixels != NULL; i++) {
		(*pixels)[i] = image->bits == 16 ? (float)((uint16_t *)image->codes)[i] / 65535.0f
		                                 : (float)((uint8_t *)image->codes)[i] / 255.0f;
	}
	return *pixels != NULL ? TS_OK : TS_ERROR;
}

/* Pixels that a file may say it has. */
static uint64_t justified(size_t bytes)
{
	const uint64_t most = FREE_PIXELS + (uint64_t)bytes * PIXELS_A_BYTE;
	return most < MOST_PIXELS ? most : MOST_PIXELS;
}

static ts_status read_png_floats(float **pixels, uint32_t *width, uint32_t *height, uint32_t *channels,
                                 ts_image_frame *frame, const void *file, size_t bytes, const char *what)
{
	uint32_t size[2] = {0, 0};
	const uint64_t most = justified(bytes);
	ts_png image;
	png_size(size, file, bytes);
	if ((uint64_t)size[0] * size[1] > most)
		return ts_fail("%s: its header says %u by %u; 1 to %llu pixels are justified", what, size[0], size[1],
		               (unsigned long long)most);
	ts_status status = read_png(&image, file, bytes, what);
	if (status == TS_OK) status = floats_of(pixels, &image, what);
	free(image.codes);
	if (status != TS_OK) return status;
	*width = image.width;
	*height = image.height;
	*channels = image.channels;
	*frame = (ts_image_frame){.display = {0, 0, (int32_t)image.width, (int32_t)image.height}, .parts = 1};
	return TS_OK;
}

static ts_status read_file(float **pixels, uint32_t *width, uint32_t *height, uint32_t *channels, ts_image_frame *frame,
                           const void *file, size_t bytes, const char *what)
{
	const char *name = "its first bytes are those of no format";
	ts_image_format is = ts_image_format_find(file, bytes, &name);
	if (!is_read(is)) return ts_fail(EXPECTED, what, name);
	if (is == TS_IMAGE_PNG) return read_png_floats(pixels, width, height, channels, frame, file, bytes, what);
	const uint64_t said = is == TS_IMAGE_EXR ? ts_exr_pixels(file, bytes) : 0, most = justified(bytes);
	if (said > most)
		return ts_fail("%s: its header says %llu pixels; 1 to %llu pixels are justified", what,
		               (unsigned long long)said, (unsigned long long)most);
	if (ts_image_load(what) != TS_OK) return TS_ERROR;
	const char *format = is == TS_IMAGE_JPEG ? "jpeg" : "openexr";
	return CODEC(read(pixels, width, height, channels, frame, format, file, bytes, what));
}

/* Whole numbers, of which there are the bits, as floats. */
static void convert(float *pixels, size_t n, uint32_t channels, const ts_image_frame *frame)
{
	for (size_t i = 0; i < n * channels; i++) {
		uint32_t code;
		memcpy(&code, &pixels[i], sizeof code);
		if (frame->whole >> i % channels & 1) pixels[i] = (float)code;
	}
}

ts_status ts_image_read_bytes(float **pixels, uint32_t *width, uint32_t *height, uint32_t *channels, const void *file,
                              size_t file_bytes, const char *what)
{
	if (TS_LACKS(pixels)) return TS_ERROR;
	*pixels = NULL;
	if (TS_LACKS(width) || TS_LACKS(height) || TS_LACKS(channels) || TS_LACKS(file) || TS_LACKS(what)) return TS_ERROR;
	ts_image_frame frame;
	ts_status status =
		ts_blame(read_file(pixels, width, height, channels, &frame, file, file_bytes, what), TS_KIND_FORMAT);
	if (status == TS_OK) convert(*pixels, (size_t)*width * *height, *channels, &frame);
	return status;
}

ts_status ts_image_read(float **pixels, uint32_t *width, uint32_t *height, uint32_t *channels, const char *path)
{
	ts_image_frame frame;
	ts_status status = ts_image_read_framed(pixels, width, height, channels, &frame, path);
	if (status == TS_OK) convert(*pixels, (size_t)*width * *height, *channels, &frame);
	return status;
}

ts_status ts_image_read_framed(float **pixels, uint32_t *width, uint32_t *height, uint32_t *channels,
                               ts_image_frame *frame, const char *path)
{
	size_t bytes = 0;
	ts_image_format is;
	if (TS_LACKS(pixels)) return TS_ERROR;
	*pixels = NULL;
	if (TS_LACKS(width) || TS_LACKS(height) || TS_LACKS(channels) || TS_LACKS(path)) return TS_ERROR;
	if (ts_blame(ts_image_format_of(&is, path), TS_KIND_FORMAT) != TS_OK) return TS_ERROR;
	if (is != TS_IMAGE_PNG && ts_image_load(path) != TS_OK) return TS_ERROR;
	void *file = ts_input_read(&bytes, path, TS_INPUT_ANY);
	if (file == NULL) return TS_ERROR;
	ts_status status = ts_blame(read_file(pixels, width, height, channels, frame, file, bytes, path), TS_KIND_FORMAT);
	free(file);
	return status;
}

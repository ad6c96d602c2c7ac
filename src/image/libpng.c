/* PNG files through libpng, which is named nowhere else. Its errors jump back here, so that what they jump over stands
 * in a struct. */
#include <png.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>
#include "image/png.h"
#include "model/core.h"

typedef struct {
	const char *what;
	png_structp png;
	png_infop info;
	const uint8_t *from; /* what is read, and what is left of that */
	size_t left;
	void *to; /* what is written */
	size_t n, capacity;
	ts_png image;
	png_bytepp rows;
	bool starved;
	char problem[128];
} codec;

static void on_error(png_structp png, png_const_charp problem)
{
	codec *c = png_get_error_ptr(png);
	snprintf(c->problem, sizeof c->problem, "%s", problem);
	png_longjmp(png, 1);
}

static void on_warning(png_structp png, png_const_charp warning)
{
	(void)png;
	(void)warning;
}

static png_voidp take_memory(png_structp png, png_alloc_size_t n)
{
	codec *c = png_get_mem_ptr(png);
	void *memory = malloc(n);
	c->starved |= memory == NULL;
	return memory;
}

static void give_memory(png_structp png, png_voidp memory)
{
	(void)png;
	free(memory);
}

static ts_status conclude(const codec *c, bool good)
{
	if (good) return TS_OK;
	bool starved = c->starved || c->png == NULL || c->info == NULL;
	return starved ? ts_fail_as(TS_KIND_MEMORY, "%s: no memory for the image", c->what)
	               : ts_fail("%s: %s; a whole PNG is expected", c->what, c->problem);
}

static void read_bytes(png_structp png, png_bytep to, size_t n)
{
	codec *c = png_get_io_ptr(png);
	if (n > c->left) png_error(png, "it is cut short");
	memcpy(to, c->from, n);
	c->from += n;
	c->left -= n;
}

/* Room for the pixels, as they are after what was asked for. */
static bool make_rows(codec *c)
{
	ts_png *image = &c->image;
	const size_t row_bytes = png_get_rowbytes(c->png, c->info);
	image->width = png_get_image_width(c->png, c->info);
	image->height = png_get_image_height(c->png, c->info);
	image->channels = png_get_channels(c->png, c->info);
	image->bits = png_get_bit_depth(c->png, c->info);
	image->codes = ts_alloc(image->height, row_bytes, c->what);
	c->rows = ts_alloc(image->height, sizeof *c->rows, c->what);
	c->starved |= image->codes == NULL || c->rows == NULL;
	for (size_t y = 0; y < image->height && !c->starved; y++) c->rows[y] = (png_bytep)image->codes + y * row_bytes;
	return !c->starved;
}

static bool read_all(codec *c)
{
	static const uint16_t one = 1;
	if (setjmp(png_jmpbuf(c->png)) != 0) return false;
	png_set_read_fn(c->png, c, read_bytes);
	png_read_info(c->png, c->info);
	png_set_expand(c->png);
	if (*(const uint8_t *)&one == 1) png_set_swap(c->png);
	png_set_interlace_handling(c->png);
	png_read_update_info(c->png, c->info);
	if (!make_rows(c)) return false;
	png_read_image(c->png, c->rows);
	return true;
}

ts_status ts_png_read(ts_png *image, const void *file, size_t file_bytes, const char *what)
{
	codec c = {.what = what, .from = file, .left = file_bytes};
	c.png = png_create_read_struct_2(PNG_LIBPNG_VER_STRING, &c, on_error, on_warning, &c, take_memory, give_memory);
	if (c.png != NULL) c.info = png_create_info_struct(c.png);
	bool good = c.info != NULL && read_all(&c) && !c.starved;
	ts_status status = conclude(&c, good);
	png_destroy_read_struct(&c.png, &c.info, NULL);
	free(c.rows);
	if (!good) free(c.image.codes);
	*image = good ? c.image : (ts_png){.codes = NULL};
	return status;
}

static void write_bytes(png_structp png, png_bytep bytes, size_t n)
{
	codec *c = png_get_io_ptr(png);
	c->starved |= ts_grow(&c->to, &c->capacity, c->n + n, 1, c->what) != TS_OK;
	if (c->starved) png_error(png, "out of memory");
	memcpy((uint8_t *)c->to + c->n, bytes, n);
	c->n += n;
}

static void flush(png_structp png) { (void)png; }

static void put_texts(codec *c, const ts_image_text *texts)
{
	for (; texts != NULL && texts->name != NULL; texts++) {
		png_text text = {.compression = PNG_TEXT_COMPRESSION_NONE,
		                 .key = (char *)texts->name,
		                 .text = (char *)texts->text,
		                 .text_length = strlen(texts->text)};
		png_set_text(c->png, c->info, &text, 1);
	}
}

static bool write_all(codec *c, const uint8_t *pixels, const ts_image_text *texts)
{
	const ts_png *image = &c->image;
	const int kind = image->channels == 1   ? PNG_COLOR_TYPE_GRAY
	                 : image->channels == 3 ? PNG_COLOR_TYPE_RGB
	                                        : PNG_COLOR_TYPE_RGB_ALPHA;
	if (setjmp(png_jmpbuf(c->png)) != 0) return false;
	png_set_write_fn(c->png, c, write_bytes, flush);
	png_set_user_limits(c->png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
	png_set_compression_strategy(c->png, Z_DEFAULT_STRATEGY); /* with libpng's own, files get other bytes */
	png_set_IHDR(c->png, c->info, image->width, image->height, 8, kind, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_BASE,
	             PNG_FILTER_TYPE_BASE);
	png_set_sRGB_gAMA_and_cHRM(c->png, c->info, PNG_sRGB_INTENT_ABSOLUTE);
	put_texts(c, texts);
	png_write_info(c->png, c->info);
	for (size_t y = 0; y < image->height; y++) png_write_row(c->png, pixels + y * image->width * image->channels);
	png_write_end(c->png, NULL);
	return true;
}

ts_status ts_png_write(void **file, size_t *file_bytes, const uint8_t *pixels, uint32_t width, uint32_t height,
                       uint32_t channels, const ts_image_text *texts, const char *what)
{
	codec c = {.what = what, .image = {.width = width, .height = height, .channels = channels}};
	c.png = png_create_write_struct_2(PNG_LIBPNG_VER_STRING, &c, on_error, on_warning, &c, take_memory, give_memory);
	if (c.png != NULL) c.info = png_create_info_struct(c.png);
	bool good = c.info != NULL && write_all(&c, pixels, texts) && !c.starved;
	ts_status status = conclude(&c, good);
	png_destroy_write_struct(&c.png, &c.info);
	if (!good) free(c.to);
	*file = good ? c.to : NULL;
	*file_bytes = c.n;
	return status;
}

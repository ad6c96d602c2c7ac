/* Pictures of a page. */
#include <openssl/evp.h>
#include <stdlib.h>
#include <touchstone/image.h>
#include "output/json/text.h"
#include "report/page.h"

enum { MOST_BYTES = 1 << 30 };

json_t *ts_page_base64(const void *file, size_t bytes, const char *what)
{
	if (bytes > MOST_BYTES) ts_fail("%s: %zu bytes; at most %d fit into a page", what, bytes, MOST_BYTES);
	char *text = bytes <= MOST_BYTES ? ts_alloc(bytes / 3 + 1, 4 + 1, what) : NULL;
	if (text == NULL) return NULL;
	int n = EVP_EncodeBlock((unsigned char *)text, file, (int)bytes);
	json_t *value = json_stringn_nocheck(text, (size_t)n);
	free(text);
	if (value == NULL) ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", what);
	return value;
}

json_t *ts_page_png(const u8 *pixels, u32 width, u32 height, u32 channels, const char *what)
{
	void *file;
	size_t bytes;
	if (ts_image_encode_png(&file, &bytes, pixels, width, height, channels, NULL, what) != TS_OK) return NULL;
	json_t *png = ts_page_base64(file, bytes, what);
	free(file);
	return png;
}

static char *copied(const char *text)
{
	char *copy = ts_alloc(strlen(text) + 1, 1, "a picture's name");
	if (copy != NULL) strcpy(copy, text);
	return copy;
}

static ts_status keep(ts_page *page, const ts_page_picture *picture)
{
	void *list = page->picture;
	if (ts_grow(&list, &page->capacity, page->n_pictures + 1, sizeof *picture, "pictures") != TS_OK) return TS_ERROR;
	page->picture = list;
	ts_page_picture *kept = &page->picture[page->n_pictures];
	*kept = *picture;
	kept->name = copied(picture->name);
	kept->group = copied(picture->group);
	if (kept->name != NULL && kept->group != NULL) {
		page->n_pictures++;
		return TS_OK;
	}
	free(kept->name);
	free(kept->group);
	return TS_ERROR;
}

json_t *ts_page_take(ts_page *page, const ts_page_picture *picture, const char *from, json_t *png)
{
	if (png == NULL || keep(page, picture) != TS_OK) {
		free(picture->rgb);
		json_decref(png);
		return NULL;
	}
	json_t *o = json_pack("{s:o, s:o, s:I, s:I, s:I, s:I, s:b, s:o}", "name", ts_text_json(picture->name), "from",
	                      ts_text_json(from), "width", (json_int_t)picture->width, "height",
	                      (json_int_t)picture->height, "left", (json_int_t)picture->left, "top",
	                      (json_int_t)picture->top, "judged", picture->rgb != NULL, "png", png);
	ts_page_append(page, page->pictures, o);
	return ts_page_check(page) == TS_OK ? o : NULL;
}

ts_status ts_page_add_picture(ts_page *page, const char *name, const char *from, const u8 *rgb, u32 width, u32 height)
{
	ts_page_picture picture = {.name = (char *)name, .group = "", .width = width, .height = height, .folder = TS_NONE};
	picture.rgb = ts_alloc((size_t)width * height, 3, name);
	if (picture.rgb == NULL) return TS_ERROR;
	memcpy(picture.rgb, rgb, (size_t)width * height * 3);
	return ts_page_take(page, &picture, from, ts_page_png(rgb, width, height, 3, name)) != NULL ? TS_OK : TS_ERROR;
}

/* The whole page: its parts as one JSON object, between fixed text. */
#include "report/page.h"
#include <stdlib.h>
#include <unistd.h>
#include "image/falsecolour.h"
#include "image/flip.h"
#include "model/input.h"
#include "model/json/read.h"
#include "output/file.h"
#include "page.inc"

enum { MOST_JSON_BYTES = 1 << 24, LARGE_BYTES = 64 << 20, PATH_BYTES = 4352 };

void ts_page_put(ts_page *page, json_t *object, const char *key, json_t *value)
{
	page->failed |= json_object_set_new(object, key, value) != 0;
}

void ts_page_append(ts_page *page, json_t *array, json_t *value)
{
	page->failed |= json_array_append_new(array, value) != 0;
}

ts_status ts_page_check(const ts_page *page)
{
	return page->failed ? ts_fail_as(TS_KIND_MEMORY, "the page: out of memory") : TS_OK;
}

static json_t *list(ts_page *page, const char *key)
{
	ts_page_put(page, page->root, key, json_array());
	return json_object_get(page->root, key);
}

/* The colours of heat maps, and of buffers in maps of first differences. */
static void put_colours(ts_page *page)
{
	json_t *ramp = list(page, "ramp"), *names = list(page, "names");
	uint8_t rgb[3];
	for (int i = 0; i < 256; i++) {
		ts_falsecolour_ramp(rgb, i / 255.0);
		ts_page_append(page, ramp, json_pack("[i,i,i]", rgb[0], rgb[1], rgb[2]));
		ts_falsecolour_name(rgb, (uint32_t)i);
		ts_page_append(page, names, json_pack("[i,i,i]", rgb[0], rgb[1], rgb[2]));
	}
}

ts_page *ts_page_make(double ppd, u32 n_probes)
{
	ts_page *page = ts_alloc_zero(1, sizeof *page, "a page");
	if (page == NULL) return NULL;
	page->ppd = ppd;
	page->n_probes = n_probes;
	page->root = json_object();
	ts_page_put(page, page->root, "version", json_string(TS_VERSION));
	ts_page_put(page, page->root, "ppd", json_real(ppd));
	ts_page_put(page, page->root, "most_probes", json_integer(n_probes));
	page->folders = list(page, "folders");
	page->traces = list(page, "traces");
	page->comparisons = list(page, "comparisons");
	page->pairs = list(page, "pairs");
	page->pictures = list(page, "pictures");
	page->media = list(page, "media");
	put_colours(page);
	if (ts_page_check(page) == TS_OK) return page;
	ts_page_free(page);
	return NULL;
}

void ts_page_free(ts_page *page)
{
	if (page == NULL) return;
	for (size_t i = 0; i < page->n_pictures; i++) {
		free(page->picture[i].name);
		free(page->picture[i].group);
		free(page->picture[i].rgb);
	}
	free(page->picture);
	json_decref(page->root);
	free(page);
}

ts_status ts_page_read(json_t **root, const char *dir, const char *name, bool absent)
{
	char path[PATH_BYTES];
	size_t bytes;
	*root = NULL;
	snprintf(path, sizeof path, "%s/%s", dir, name);
	if (absent && access(path, F_OK) != 0) return TS_OK;
	char *text = ts_input_read_in(&bytes, dir, name, MOST_JSON_BYTES);
	if (text == NULL) return TS_ERROR;
	const size_t mark = ts_text_mark(text, bytes);
	*root = ts_json_read(text + mark, bytes - mark, false, path);
	free(text);
	if (*root == NULL) return TS_ERROR;
	if (json_is_object(*root)) return TS_OK;
	json_decref(*root);
	*root = NULL;
	return ts_fail("%s: no JSON object; what render or compare wrote is expected", path);
}

/* Escapes text of files, so that it cannot end its script element. */
static int put_text(const char *text, size_t bytes, void *user)
{
	FILE *out = user;
	for (size_t at = 0; at < bytes;) {
		const char *less = memchr(text + at, '<', bytes - at);
		size_t n = less != NULL ? (size_t)(less - text) - at : bytes - at;
		fwrite(text + at, 1, n, out);
		if (less != NULL) fputs("\\u003c", out);
		at += n + (less != NULL);
	}
	return 0;
}

ts_status ts_page_write(ts_page *page, const char *path)
{
	ts_file_text text;
	if (ts_page_add_pairs(page) != TS_OK || ts_page_check(page) != TS_OK) return TS_ERROR;
	if (ts_file_text_begin(&text, path) != TS_OK) return TS_ERROR;
	fwrite(page_before, 1, sizeof page_before, text.out);
	int bad = json_dump_callback(page->root, put_text, text.out, JSON_COMPACT | JSON_REAL_PRECISION(9));
	fwrite(page_behind, 1, sizeof page_behind, text.out);
	ts_status status =
		bad == 0 ? ts_file_text_flush(&text, path) : ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", path);
	if (status != TS_OK) {
		ts_file_text_drop(&text);
		return TS_ERROR;
	}
	size_t bytes = text.bytes;
	if (ts_file_text_replace(&text, path) != TS_OK) return TS_ERROR;
	if (bytes > LARGE_BYTES) {
		ts_say("%s: %zu MB; browsers take long above %d MB: fewer folders, or smaller pictures, would be quicker", path,
		       bytes >> 20, LARGE_BYTES >> 20);
	}
	return TS_OK;
}

/* Shared by the files that make a page. */
#ifndef TS_REPORT_PAGE_H
#define TS_REPORT_PAGE_H
#include "kernels/base/num.h"
#include "report/report.h"

/* A picture; its index is that in the page's list. */
typedef struct {
	char *name, *group;           /* pictures of a group are of one frame */
	u8 *rgb;                      /* NULL: shown only, never compared */
	u32 width, height, left, top; /* left, top: its first pixel in the eye's image, of which it may be a part */
	bool truth;
	u32 folder;         /* index of the folder that the picture is from; TS_NONE: none */
	const ts_trace *of; /* only to be told from others; NULL: of no trace */
} ts_page_picture;

struct ts_page {
	double ppd;
	u32 n_probes, n_folders;
	json_t *root, *pictures, *pairs, *folders, *traces, *comparisons, *media; /* root owns the others */
	ts_page_picture *picture;
	size_t n_pictures, capacity;
	bool failed; /* out of memory */
};

/* Sets object[key] to value and takes value over; out of memory it sets page->failed. */
void ts_page_put(ts_page *page, json_t *object, const char *key, json_t *value);
void ts_page_append(ts_page *page, json_t *array, json_t *value);
/* Fails if page->failed is set. */
ts_status ts_page_check(const ts_page *page);
/* Reads the object of a JSON file of the folder; `absent`: the file may be missing, and *root is NULL then. */
ts_status ts_page_read(json_t **root, const char *dir, const char *name, bool absent);

/* ---- pictures (picture.c) ---- */
/* A PNG file in memory as base64; NULL with the message set. */
json_t *ts_page_base64(const void *file, size_t bytes, const char *what);
/* As ts_page_base64, for pixels, which are coded as a PNG file. */
json_t *ts_page_png(const u8 *pixels, u32 width, u32 height, u32 channels, const char *what);
/* Adds a picture and takes over `png` and the picture's `rgb` (allocated by malloc), also on failure. Returns its JSON;
 * NULL with the message set on failure. */
json_t *ts_page_take(ts_page *page, const ts_page_picture *picture, const char *from, json_t *png);

/* ---- pairs (pair.c) ---- */
/* Adds the metrics of two pictures of one size, unless they are there. */
ts_status ts_page_add_pair(ts_page *page, size_t reference, size_t image);
/* Adds the pairs of pictures to compare: those of a group with its truths, or without truths with its first; those of
 * further folders with the first folder's picture of the same name; those of traces with the page's first. */
ts_status ts_page_add_pairs(ts_page *page);

#endif

/* What the parts of a page share. */
#ifndef TS_REPORT_PAGE_H
#define TS_REPORT_PAGE_H
#include "../kernels/base/num.h"
#include "report.h"

/* A picture; its place is that in the page's list. */
typedef struct {
	char *name, *group;           /* pictures of a group are of one frame */
	u8 *rgb;                      /* NULL: is only shown */
	u32 width, height, left, top; /* left, top: of its first pixel, where it is a part of the eye's */
	bool truth;
	u32 folder; /* number of the folder that it is from; TS_NONE: of none */
} ts_page_picture;

struct ts_page {
	double ppd;
	u32 n_probes, n_folders;
	json_t *root, *pictures, *pairs, *folders, *traces, *comparisons; /* root owns the others */
	ts_page_picture *picture;
	size_t n_pictures, capacity;
	bool failed; /* out of memory */
};

/* object[key] = value, which is taken over; without memory page->failed is set. */
void ts_page_put(ts_page *page, json_t *object, const char *key, json_t *value);
void ts_page_append(ts_page *page, json_t *array, json_t *value);
/* Fails where memory ended. */
ts_status ts_page_check(const ts_page *page);
/* The object that a JSON file of the folder holds; *root is NULL where it may be `absent` and is. */
ts_status ts_page_read(json_t **root, const char *dir, const char *name, bool absent);

/* ---- pictures (picture.c) ---- */
/* A PNG file in memory as base64; NULL with the message set. */
json_t *ts_page_base64(const void *file, size_t bytes, const char *what);
/* The same of pixels. */
json_t *ts_page_png(const u8 *pixels, u32 width, u32 height, u32 channels, const char *what);
/* Adds one, with its `png` and `rgb` (by free()), which are taken over, also on failure. Returns its JSON; NULL with
 * the message set on failure. */
json_t *ts_page_take(ts_page *page, const ts_page_picture *picture, const char *from, json_t *png);

/* ---- pairs (pair.c) ---- */
/* Adds the metrics of two pictures of one size, unless they are there. */
ts_status ts_page_add_pair(ts_page *page, size_t reference, size_t image);
/* Pairs what belongs together: pictures of a group with its truths or else with its first, those of further folders
 * with the first folder's of the same name, and those of traces with the page's first. */
ts_status ts_page_add_pairs(ts_page *page);

#endif

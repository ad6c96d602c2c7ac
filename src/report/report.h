/* A page of HTML about renders and comparisons: pictures beside and over each other, metrics between them, tables,
 * first differences, and probes that explain pixels. The page is one file, which needs no server and no network. The
 * same input gives the same bytes. */
#ifndef TS_REPORT_REPORT_H
#define TS_REPORT_REPORT_H
#include <jansson.h>
#include "compare/compare.h"

typedef struct ts_page ts_page;

enum { TS_PAGE_PROBES = 64, TS_PAGE_SIDE = 1 << 14 }; /* of a picture, at most */

/* An empty page. ppd: pixels per degree of the viewer, for FLIP (image/flip.h); n_probes: the greatest number of
 * differing pixels of a comparison of which the page holds probes. NULL with the message set on failure. */
ts_page *ts_page_make(double ppd, u32 n_probes);
/* NULL is allowed. */
void ts_page_free(ts_page *page);

/* Adds a picture, whose pixels are copied: 8-bit sRGB, width * height * 3. */
ts_status ts_page_add_picture(ts_page *page, const char *name, const char *from, const u8 *rgb, u32 width, u32 height);
/* Adds the output of render or compare in folder `dir`: the PNG files and tables that its report.json names, and
 * times.json. */
ts_status ts_page_add_folder(ts_page *page, const char *dir);
/* Adds a trace: its picture, and the figures of its trace.json. */
ts_status ts_page_add_trace(ts_page *page, const ts_trace *trace);
/* Adds the comparison of a candidate, after both traces were added; `json` is the comparison as JSON (compare --json).
 * The page gets the differing pixels, and probes of pixels of both traces. */
ts_status ts_page_add_comparison(ts_page *page, const ts_comparison *comparison, const ts_trace *reference,
                                 const ts_trace *candidate, const ts_relaxations *relaxations, const json_t *json);
/* Adds a comparison of the last two pictures that were added. */
ts_status ts_page_add_picture_comparison(ts_page *page, const json_t *json);

/* Compares the pictures of all pairs, and writes or replaces the file as a whole. A line warns of a page that is too
 * large for browsers to open at once. */
ts_status ts_page_write(ts_page *page, const char *path);

#endif

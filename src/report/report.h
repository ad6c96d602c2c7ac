/* A page of HTML that shows what was rendered and compared: pictures beside and over each other, how far they are
 * apart, tables, first differences and why pixels are what they are. All is inside the one file, which needs no server
 * and no network. The same input gives the same bytes. */
#ifndef TS_REPORT_REPORT_H
#define TS_REPORT_REPORT_H
#include <jansson.h>
#include "../compare/compare.h"

typedef struct ts_page ts_page;

enum { TS_PAGE_PROBES = 64 };

/* An empty page. ppd: pixels per degree of who looks at the pictures, for FLIP (image/flip.h); n_probes: the most
 * differing pixels of a comparison whose probes the page holds. NULL with the message set on failure. */
ts_page *ts_page_make(double ppd, u32 n_probes);
/* NULL is allowed. */
void ts_page_free(ts_page *page);

/* Adds a picture, whose pixels are copied: 8-bit sRGB, width * height * 3. */
ts_status ts_page_add_picture(ts_page *page, const char *name, const char *from, const u8 *rgb, u32 width, u32 height);
/* Adds what render or compare wrote to folder `dir`: the PNG files and the tables that its report.json names, and
 * times.json. */
ts_status ts_page_add_folder(ts_page *page, const char *dir);
/* Adds a trace: its picture and what trace.json says. */
ts_status ts_page_add_trace(ts_page *page, const ts_trace *trace);
/* Adds how a candidate was judged, both sides being added already: `said` is the comparison as JSON (compare --json).
 * The page has the pixels of differences, and probes of pixels on both sides. */
ts_status ts_page_add_comparison(ts_page *page, const ts_comparison *comparison, const ts_trace *reference,
                                 const ts_trace *candidate, const ts_relaxations *relaxations, const json_t *said);
/* Adds a comparison of the last two pictures that were added. */
ts_status ts_page_add_picture_comparison(ts_page *page, const json_t *said);

/* Judges pictures against each other, and writes or replaces the file as a whole. Says so where the page is larger than
 * browsers open at once. */
ts_status ts_page_write(ts_page *page, const char *path);

#endif

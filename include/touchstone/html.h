/* SPDX-License-Identifier: Apache-2.0 */
/* A page of HTML that shows what was rendered and compared, as `touchstone report` writes it: pictures side by side and
 * over each other, their distances, tables, first differences, and probes of pixels. The page is one file, which needs
 * no server and no network. The same input gives the same bytes.
 *
 *   ts_html *page;
 *   if (ts_html_open(context, &page, NULL) == TS_OK && ts_html_add_trace(page, reference) == TS_OK &&
 *       ts_html_add_trace(page, candidate) == TS_OK &&
 *       ts_html_add_verdicts(page, verdicts, reference, candidate, NULL, NULL) == TS_OK)
 *           ts_html_write(page, "report.html"); */
#ifndef TOUCHSTONE_HTML_H
#define TOUCHSTONE_HTML_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/compare.h>
#include <touchstone/context.h>
#include <touchstone/status.h>
#include <touchstone/trace.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef struct ts_html ts_html;

/* Options of a page. Only `bytes` must be set; 0 is the default of each other member. */
typedef struct {
	size_t bytes;    /* sizeof(ts_html_options) */
	double ppd;      /* pixels per degree of the viewer's sight, for FLIP; 0: 67 */
	int probes_said; /* not 0: `probes` is read; 0: 64 */
	uint32_t probes; /* the page holds probes of at most this many differing pixels of a comparison */
} ts_html_options;

/* Opens an empty page; options NULL: all defaults. Release it by ts_html_close; NULL on failure. The context must stay
 * until then. */
TS_API ts_status ts_html_open(ts_context *context, ts_html **page, const ts_html_options *options);

/* Adds a picture, whose pixels are copied: 8-bit sRGB, height rows of width pixels of 3 bytes, from 1 to 16384 a side.
 * from: its file, or another source. */
TS_API ts_status ts_html_add_picture(ts_html *page, const char *name, const char *from, const uint8_t *rgb,
                                     uint32_t width, uint32_t height);

/* Adds a folder that render or compare wrote. */
TS_API ts_status ts_html_add_folder(ts_html *page, const char *folder);

/* Adds a trace: its picture, its method and its parameters. */
TS_API ts_status ts_html_add_trace(ts_html *page, const ts_trace *trace);

/* Adds the verdicts of ts_compare on a candidate. Both traces must have been added before.
 * In: options: those of that call. json: an object that holds the members of ts_verdicts_tree, and more; NULL: these
 *   members alone. */
TS_API ts_status ts_html_add_verdicts(ts_html *page, const ts_verdicts *verdicts, const ts_trace *reference,
                                      const ts_trace *candidate, const ts_compare_options *options, const char *json);

/* Adds a comparison of the last two pictures that were added. json: the result of the comparison, an object. */
TS_API ts_status ts_html_add_pair(ts_html *page, const char *json);

/* Judges pictures against each other, and writes or replaces the file as a whole. */
TS_API ts_status ts_html_write(ts_html *page, const char *path);

/* Releases a page; NULL is allowed. */
TS_API void ts_html_close(ts_html *page);

#ifdef __cplusplus
}
#endif
#endif

/* Pages. */
#include <stdlib.h>
#include <touchstone/html.h>
#include "api/verdicts.h"
#include "compare/compare.h"
#include "image/flip.h"
#include "model/json/read.h"
#include "report/report.h"

struct ts_html {
	const ts_context *context;
	ts_page *inner;
};

static ts_status make(ts_html **page, const ts_context *context, const ts_html_options *o)
{
	const double ppd = o->ppd != 0 ? o->ppd : TS_FLIP_PPD;
	if (!(ppd >= TS_FLIP_LEAST_PPD && ppd <= TS_FLIP_MOST_PPD)) {
		return ts_fail("ts_html_options.ppd: %g pixels per degree; %g to %g would be right", ppd, TS_FLIP_LEAST_PPD,
		               TS_FLIP_MOST_PPD);
	}
	ts_html *made = ts_alloc_zero(1, sizeof *made, "a page");
	if (made == NULL) return TS_ERROR;
	made->context = context;
	made->inner = ts_page_make(ppd, o->probes_said != 0 ? o->probes : TS_PAGE_PROBES);
	if (made->inner != NULL) {
		*page = made;
		return TS_OK;
	}
	free(made);
	return TS_ERROR;
}

ts_status ts_html_open(ts_context *context, ts_html **page, const ts_html_options *options)
{
	ts_html_options ours = {0};
	if (TS_LACKS(page)) return TS_ERROR;
	*page = NULL;
	if (TS_LACKS(context) || ts_api_options(&ours, sizeof ours, options, "ts_html_options") != TS_OK) return TS_ERROR;
	return make(page, context, &ours);
}

ts_status ts_html_add_picture(ts_html *page, const char *name, const char *from, const uint8_t *rgb, uint32_t width,
                              uint32_t height)
{
	if (TS_LACKS(page) || TS_LACKS(name) || TS_LACKS(from) || TS_LACKS(rgb)) return TS_ERROR;
	if (width == 0 || height == 0 || width > TS_PAGE_SIDE || height > TS_PAGE_SIDE) {
		return ts_fail("%s: %lu x %lu pixels; 1 to %d a side would be right", name, (unsigned long)width,
		               (unsigned long)height, TS_PAGE_SIDE);
	}
	if (ts_api_enter(page->context) != TS_OK) return TS_ERROR;
	ts_status status = ts_page_add_picture(page->inner, name, from, rgb, width, height);
	ts_api_leave();
	return status;
}

ts_status ts_html_add_folder(ts_html *page, const char *folder)
{
	if (TS_LACKS(page) || TS_LACKS(folder) || ts_api_enter(page->context) != TS_OK) return TS_ERROR;
	ts_status status = ts_blame(ts_page_add_folder(page->inner, folder), TS_KIND_FORMAT);
	ts_api_leave();
	return status;
}

ts_status ts_html_add_trace(ts_html *page, const ts_trace *trace)
{
	if (TS_LACKS(page) || TS_LACKS(trace) || ts_api_enter(page->context) != TS_OK) return TS_ERROR;
	ts_status status = ts_page_add_trace(page->inner, trace);
	ts_api_leave();
	return status;
}

/* Parses the caller's JSON, which must be an object. */
static json_t *parse_object(const char *text)
{
	json_t *tree = ts_json_read(text, strlen(text), false, "json");
	if (tree == NULL || json_is_object(tree)) return tree;
	ts_fail("json: an object would be right");
	json_decref(tree);
	return NULL;
}

/* Whether verdicts can be of these traces: both have all buffers that differ. */
static ts_status match(const ts_comparison *c, const ts_trace *reference, const ts_trace *candidate)
{
	bool both = reference->pipeline == candidate->pipeline;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_verdict *v = &c->verdict[id];
		if (v->judgement != TS_UNLIKE || v->aside) continue;
		both &= ts_digest_known(&reference->item[id]) && ts_digest_known(&candidate->item[id]) &&
		        reference->item[id].npy.n == v->n_ref;
	}
	return both ? TS_OK : ts_fail("ts_html_add_verdicts: verdicts of other traces; those of that comparison are right");
}

ts_status ts_html_add_verdicts(ts_html *page, const ts_verdicts *verdicts, const ts_trace *reference,
                               const ts_trace *candidate, const ts_compare_options *options, const char *json)
{
	ts_compare_options ours = {0};
	ts_relaxations relaxations;
	if (TS_LACKS(page) || TS_LACKS(verdicts) || TS_LACKS(reference) || TS_LACKS(candidate)) return TS_ERROR;
	if (ts_api_options(&ours, sizeof ours, options, "ts_compare_options") != TS_OK) return TS_ERROR;
	if (ts_api_relax(&relaxations, &ours) != TS_OK || ts_relax_check(&relaxations) != TS_OK) return TS_ERROR;
	if (match(verdicts->comparison, reference, candidate) != TS_OK) return TS_ERROR;
	json_t *tree = json != NULL ? parse_object(json) : json_incref(verdicts->tree);
	ts_status status = tree != NULL ? ts_api_enter(page->context) : TS_ERROR;
	if (status == TS_OK) {
		status = ts_page_add_comparison(page->inner, verdicts->comparison, reference, candidate, &relaxations, tree);
		ts_api_leave();
	}
	json_decref(tree);
	return status;
}

ts_status ts_html_add_pair(ts_html *page, const char *json)
{
	if (TS_LACKS(page) || TS_LACKS(json)) return TS_ERROR;
	json_t *tree = parse_object(json);
	ts_status status = tree != NULL ? ts_api_enter(page->context) : TS_ERROR;
	if (status == TS_OK) {
		status = ts_page_add_picture_comparison(page->inner, tree);
		ts_api_leave();
	}
	json_decref(tree);
	return status;
}

ts_status ts_html_write(ts_html *page, const char *path)
{
	if (TS_LACKS(page) || TS_LACKS(path) || ts_api_enter(page->context) != TS_OK) return TS_ERROR;
	ts_status status = ts_page_write(page->inner, path);
	ts_api_leave();
	return status;
}

void ts_html_close(ts_html *page)
{
	if (page == NULL) return;
	ts_page_free(page->inner);
	free(page);
}

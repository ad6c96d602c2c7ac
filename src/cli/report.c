/* `report DIR...`: a page of what folders hold. */
#include <unistd.h>
#include "../image/flip.h"
#include "../report/report.h"
#include "compare.h"

enum { FIRSTS = 10, PATH_BYTES = 4352 }; /* differences that are shown of each buffer */

typedef struct {
	const ts_cli *cli;
	ts_page *page;
	ts_trace *trace[TS_MAX_ARGUMENTS];
	u32 n_traces;
} contents;

/* The first trace of the last one's method; NULL: that is the first. */
static const ts_trace *reference_of(const contents *c)
{
	const ts_trace *last = c->trace[c->n_traces - 1];
	for (u32 i = 0; i + 1 < c->n_traces; i++) {
		if (c->trace[i]->pipeline == last->pipeline) return c->trace[i];
	}
	return NULL;
}

static ts_status compare(const contents *c, const ts_trace *reference, const ts_trace *candidate)
{
	static const ts_relaxations none = {.ulp = 0};
	ts_report report;
	ts_comparison *comparison = ts_comparison_make(FIRSTS);
	if (comparison == NULL) return TS_ERROR;
	ts_status status = ts_compare_traces(comparison, reference, candidate, &none);
	if (status != TS_ERROR) {
		ts_report_begin(&report, true);
		ts_compare_report(&report, comparison, reference, candidate, c->cli);
		ts_report_value(&report, "verdict", json_string(status == TS_DIFFERENT ? "different" : "same"));
		status = ts_report_check(&report);
		if (status == TS_OK) {
			status = ts_page_add_comparison(c->page, comparison, reference, candidate, &none, report.root);
		}
		ts_report_discard(&report);
	}
	ts_comparison_free(comparison);
	return status;
}

static ts_status add_trace(contents *c, const char *dir)
{
	ts_trace *trace;
	if (ts_trace_open_folder(&trace, dir) != TS_OK) return TS_ERROR;
	c->trace[c->n_traces++] = trace;
	if (ts_page_add_trace(c->page, trace) != TS_OK) return TS_ERROR;
	const ts_trace *reference = reference_of(c);
	return reference != NULL ? compare(c, reference, trace) : TS_OK;
}

static ts_status add(contents *c, const char *dir)
{
	char trace[PATH_BYTES], report[PATH_BYTES];
	snprintf(trace, sizeof trace, "%s/trace.json", dir);
	snprintf(report, sizeof report, "%s/report.json", dir);
	if (access(trace, F_OK) == 0) return add_trace(c, dir);
	if (access(report, F_OK) == 0) return ts_page_add_folder(c->page, dir);
	return ts_fail(
		"%s: holds no trace.json and no report.json; a trace, or a folder that render -o or compare -o wrote, "
		"would be right",
		dir);
}

ts_status ts_report_command(ts_cli *cli)
{
	contents c = {.cli = cli};
	const double ppd = cli->given[TS_OPTION_PPD] ? cli->report.ppd : TS_FLIP_PPD;
	const u32 probes = cli->given[TS_OPTION_PROBES] ? cli->report.probes : TS_PAGE_PROBES;
	if (cli->job.output.dir == NULL) return ts_fail("report: no file to write; add -o FILE.html");
	if (!(ppd >= TS_FLIP_LEAST_PPD && ppd <= TS_FLIP_MOST_PPD)) {
		return ts_fail("--ppd: %g pixels per degree; %g to %g would be right", ppd, TS_FLIP_LEAST_PPD,
		               TS_FLIP_MOST_PPD);
	}
	c.page = ts_page_make(ppd, probes);
	ts_status status = c.page != NULL ? TS_OK : TS_ERROR;
	for (u32 i = 0; i < cli->n_arguments && status == TS_OK; i++) status = add(&c, cli->arguments[i]);
	if (status == TS_OK) status = ts_page_write(c.page, cli->job.output.dir);
	for (u32 i = 0; i < c.n_traces; i++) ts_trace_close(c.trace[i]);
	ts_page_free(c.page);
	return status;
}

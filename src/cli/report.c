/* `report DIR...`: a page about folders. */
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "cli/compare.h"
#include "image/flip.h"

enum { FIRSTS = 10, PATH_BYTES = 4352 }; /* FIRSTS: differences shown per buffer */

typedef struct {
	ts_context *context;
	ts_html *page;
	ts_trace *trace[TS_MAX_ARGUMENTS];
	u32 n_traces;
} contents;

/* The first trace with the last one's method; NULL: that is the first. */
static ts_trace *reference_of(const contents *c)
{
	const ts_trace_info *last = ts_trace_about(c->trace[c->n_traces - 1]);
	for (u32 i = 0; i + 1 < c->n_traces; i++) {
		const ts_trace_info *other = ts_trace_about(c->trace[i]);
		bool same = strcmp(other->effect, last->effect) == 0 && strcmp(other->method, last->method) == 0;
		if (same) return c->trace[i];
	}
	return NULL;
}

static ts_status add_verdicts(const contents *c, const ts_compared *of)
{
	ts_report report;
	ts_report_begin(&report, true);
	ts_compare_report(&report, of, "");
	ts_status status = ts_report_check(&report);
	char *json = status == TS_OK ? json_dumps(report.root, JSON_COMPACT) : NULL;
	if (status == TS_OK && json == NULL) status = ts_fail("the page: out of memory");
	if (status == TS_OK) {
		status = ts_html_add_verdicts(c->page, of->verdicts, of->reference, of->candidate, &of->options, json);
	}
	free(json);
	ts_report_discard(&report);
	return status;
}

static ts_status compare(const contents *c, ts_trace *reference, ts_trace *candidate)
{
	ts_compared of = {.context = c->context,
	                  .reference = reference,
	                  .candidate = candidate,
	                  .of = ts_trace_about(reference),
	                  .options = {.bytes = sizeof of.options, .first = FIRSTS}};
	ts_status status = ts_compared_judge(&of);
	if (status != TS_ERROR) status = add_verdicts(c, &of);
	ts_verdicts_free(of.verdicts);
	return status;
}

static ts_status add_trace(contents *c, const char *dir)
{
	ts_trace *trace;
	if (ts_trace_open(c->context, &trace, dir) != TS_OK) return TS_ERROR;
	c->trace[c->n_traces++] = trace;
	if (ts_html_add_trace(c->page, trace) != TS_OK) return TS_ERROR;
	ts_trace *reference = reference_of(c);
	return reference != NULL ? compare(c, reference, trace) : TS_OK;
}

static ts_status add_folder(contents *c, const char *dir) { return ts_html_add_folder(c->page, dir); }

static ts_status add(contents *c, const char *dir)
{
	static const struct {
		const char *file;
		ts_status (*add)(contents *c, const char *dir);
	} kinds[] = {{"trace.json", add_trace}, {"report.json", add_folder}, {"params.txt", add_trace}};
	for (u32 i = 0; i < sizeof kinds / sizeof *kinds; i++) {
		char path[PATH_BYTES];
		snprintf(path, sizeof path, "%s/%s", dir, kinds[i].file);
		if (access(path, F_OK) == 0) return kinds[i].add(c, dir);
	}
	return ts_fail(
		"%s: holds no trace.json, report.json or params.txt; a trace, a golden, or a folder that render -o or "
		"compare -o wrote, would be right",
		dir);
}

ts_status ts_report_command(ts_cli *cli)
{
	contents c = {.context = NULL};
	const double ppd = cli->given[TS_OPTION_PPD] ? cli->report.ppd : TS_FLIP_PPD;
	const ts_html_options options = {
		.bytes = sizeof options, .ppd = ppd, .probes_said = cli->given[TS_OPTION_PROBES], .probes = cli->report.probes};
	if (cli->job.output.dir == NULL) return ts_fail("report: no file to write; add -o FILE.html");
	if (!(ppd >= TS_FLIP_LEAST_PPD && ppd <= TS_FLIP_MOST_PPD)) {
		return ts_fail("--ppd: %g pixels per degree; %g to %g would be right", ppd, TS_FLIP_LEAST_PPD,
		               TS_FLIP_MOST_PPD);
	}
	ts_status status = ts_client_open(&c.context, cli);
	if (status == TS_OK) status = ts_html_open(c.context, &c.page, &options);
	for (u32 i = 0; i < cli->n_arguments && status == TS_OK; i++) status = add(&c, cli->arguments[i]);
	if (status == TS_OK) status = ts_html_write(c.page, cli->job.output.dir);
	for (u32 i = 0; i < c.n_traces; i++) ts_trace_close(c.trace[i]);
	ts_html_close(c.page);
	ts_context_close(c.context);
	return status;
}

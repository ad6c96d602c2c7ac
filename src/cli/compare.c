/* `compare REFERENCE CANDIDATE`: two traces, two buffers or two images. */
#include "cli/compare.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cli/compare_known.h"
#include "cli/reports/outcomes.h"

/* What is compared. */
typedef enum { TRACES, BUFFERS, IMAGES, N_KINDS } kind;
static const char *const kind_names[] = {"traces", "buffers", "images"};

static bool ends_in(const char *path, const char *suffix)
{
	size_t n = strlen(path), m = strlen(suffix);
	return n > m && strcmp(path + n - m, suffix) == 0;
}

static kind kind_of(const char *path)
{
	static const char *const images[] = {".png", ".exr", ".jpg", ".jpeg"};
	for (u32 i = 0; i < sizeof images / sizeof *images; i++) {
		if (ends_in(path, images[i])) return IMAGES;
	}
	return ends_in(path, ".npy") || ends_in(path, ".npy.zst") ? BUFFERS : TRACES;
}

/* Refuses options that would have no effect. */
static ts_status check_options(const ts_cli *cli, kind is)
{
	static const struct {
		u32 option;
		bool takes[N_KINDS];
	} limited[] = {
		{TS_OPTION_FORCED, {[TRACES] = true}},
		{TS_OPTION_DECIDED, {[TRACES] = true}},
		{TS_OPTION_LAYOUT, {[TRACES] = true}},
		{TS_OPTION_ORDER, {[TRACES] = true}},
		{TS_OPTION_BASELINE, {[TRACES] = true}},
		{TS_OPTION_SKIP, {[TRACES] = true}},
		{TS_OPTION_SHARD, {[TRACES] = true}},
		{TS_OPTION_PERCENT, {[IMAGES] = true}},
		{TS_OPTION_HARDFAIL, {[IMAGES] = true}},
		{TS_OPTION_RMSE, {[IMAGES] = true}},
		{TS_OPTION_EXPOSURE, {[IMAGES] = true}},
		{TS_OPTION_IGNORE, {[TRACES] = true, [BUFFERS] = true}},
		{TS_OPTION_REPORT, {[TRACES] = true, [IMAGES] = true}},
	};
	for (u32 i = 0; i < sizeof limited / sizeof *limited; i++) {
		u32 option = limited[i].option;
		if (!cli->given[option] || limited[i].takes[is]) continue;
		const char *images = limited[i].takes[TRACES] ? "traces and images" : "images";
		const char *traces = limited[i].takes[BUFFERS] ? "traces and buffers" : "traces";
		const char *right = limited[i].takes[IMAGES] ? images : traces;
		return ts_fail("--%s: means something for %s only; %s is one of two %s: leave the option out",
		               ts_option_table[option].name, right, cli->arguments[0], kind_names[is]);
	}
	if (cli->given[TS_OPTION_ORDER] && cli->judging.layout == NULL) {
		return ts_fail("--order: only with --layout; a trace.json has its own");
	}
	return ts_judging_check(cli);
}

ts_status ts_compared_judge(ts_compared *c)
{
	return ts_compare(c->context, &c->verdicts, c->reference, c->candidate, &c->options);
}

static void close_all(ts_compared *c)
{
	ts_verdicts_free(c->verdicts);
	ts_trace_close(c->candidate);
	ts_trace_close(c->reference);
	ts_context_close(c->context);
}

const ts_verdict_info *ts_compared_find(const ts_compared *c, const char *buffer, size_t *place)
{
	const ts_verdict_info *v;
	for (*place = 0; (v = ts_verdicts_at(c->verdicts, *place)) != NULL && strcmp(v->buffer, buffer) != 0; ++*place) {
	}
	return v;
}

typedef struct {
	const ts_cli *cli;
	ts_compared of;
	u8 *mask;
	json_t *cases; /* of shards; NULL: none */
	char *own;     /* those of this shard */
	const char *relaxed;
	ts_compare_lists lists;
	ts_outcomes outcomes;
} comparison;

/* The buffer that a trace of one file has. */
static const char *only_buffer(const ts_trace *trace)
{
	const ts_buffer_info *buffer;
	for (size_t i = 0; (buffer = ts_buffer_at(i)) != NULL; i++) {
		if (ts_trace_has(trace, buffer->name)) return buffer->name;
	}
	return "";
}

static ts_status open_buffers(ts_compared *c, const ts_cli *cli)
{
	const char *ref = cli->arguments[0], *cand = cli->arguments[1];
	if (ts_trace_open_npy(c->context, &c->reference, ref) != TS_OK) return TS_ERROR;
	if (ts_trace_open_npy(c->context, &c->candidate, cand) != TS_OK) return TS_ERROR;
	const char *a = only_buffer(c->reference), *b = only_buffer(c->candidate);
	if (cli->judging.mask != NULL && !ts_buffer_is_image(a)) {
		return ts_fail("--mask: means something for pixels only; %s holds %s: leave the option out", ref, a);
	}
	return strcmp(a, b) == 0 ? TS_OK : ts_fail("%s: holds %s, and the reference %s", cand, b, a);
}

static ts_status open_traces(ts_compared *c, const ts_cli *cli)
{
	const char *cand = cli->arguments[1], *layout = cli->judging.layout;
	if (ts_trace_open(c->context, &c->reference, cli->arguments[0]) != TS_OK) return TS_ERROR;
	if (layout == NULL) return ts_trace_open(c->context, &c->candidate, cand);
	const int arrival = cli->job.how.arrival;
	ts_status status = ts_trace_open_list(c->context, &c->candidate, cand, layout, arrival, c->reference);
	return status == TS_OK ? TS_OK : ts_fail("--layout: %s", ts_error_message());
}

static ts_status open_sides(ts_compared *c, const ts_cli *cli, kind is)
{
	ts_status status = ts_client_open(&c->context, cli);
	if (status == TS_OK) status = is == BUFFERS ? open_buffers(c, cli) : open_traces(c, cli);
	if (status == TS_OK) c->of = ts_trace_about(c->reference);
	return status;
}

/* The names of all cases: "scene" and the stages of the method; a new reference, or NULL with the message set. */
static json_t *cases_of(const ts_trace_info *of)
{
	const ts_stage_info *stage;
	json_t *names = json_pack("[s]", "scene");
	int failed = names == NULL;
	for (size_t i = 0; (stage = ts_method_stage(of->effect, of->method, i)) != NULL; i++) {
		failed |= json_array_append_new(names, json_string(stage->name)) != 0;
	}
	if (failed == 0) return names;
	json_decref(names);
	ts_fail("the names of stages: out of memory");
	return NULL;
}

/* The cases of the shard, "scene,split,..."; release by free(); NULL with the message set. */
static char *own_of(const json_t *cases, ts_shard shard)
{
	size_t bytes = 1, used = 0, i;
	json_t *name;
	json_array_foreach (cases, i, name) bytes += json_string_length(name) + 1;
	char *own = ts_alloc_zero(bytes, 1, "the names of stages");
	json_array_foreach (cases, i, name) {
		if (own == NULL || !ts_shard_has(shard, i)) continue;
		used += (size_t)snprintf(own + used, bytes - used, "%s%s", used > 0 ? "," : "", json_string_value(name));
	}
	return own;
}

/* Reads how to judge, except for the lists. */
static ts_status read_options(comparison *c)
{
	ts_compare_options *o = &c->of.options;
	ts_status status = ts_client_options(o, &c->mask, c->cli);
	if (status != TS_OK || c->cli->job.shard.of == 0) return status;
	c->cases = cases_of(c->of.of);
	c->own = c->cases != NULL ? own_of(c->cases, c->cli->job.shard) : NULL;
	o->stages = c->own;
	return c->own != NULL ? TS_OK : TS_ERROR;
}

static ts_status judge(comparison *c)
{
	ts_status status = read_options(c);
	if (status == TS_OK) status = ts_compare_lists_read(&c->lists, c->cli, c->of.of);
	if (status != TS_OK) return status;
	c->lists.stages = c->own;
	c->of.options.ignore = c->lists.ignore;
	return ts_compared_judge(&c->of);
}

static ts_status draw_all(const void *user)
{
	const comparison *c = user;
	return ts_compare_draw(&c->of);
}

static ts_status put_all(ts_html *page, const char *json, const void *user)
{
	const comparison *c = user;
	const ts_compared *of = &c->of;
	if (ts_html_add_trace(page, of->reference) != TS_OK || ts_html_add_trace(page, of->candidate) != TS_OK)
		return TS_ERROR;
	return ts_html_add_verdicts(page, of->verdicts, of->reference, of->candidate, &of->options, json);
}

static ts_status show_all(const ts_cli *cli, const char *json, const void *user)
{
	return ts_client_page(cli, json, put_all, user);
}

static void report_all(ts_report *report, const void *user)
{
	const comparison *c = user;
	ts_compare_report(report, &c->of, c->relaxed);
	ts_compare_report_known(report, &c->lists, &c->of);
	bool failed = ts_outcomes_count(&c->outcomes, TS_FAILED) > 0;
	ts_report_value(report, "verdict", json_string(failed ? "different" : "same"));
	ts_report_value(report, "stages", json_incref(c->outcomes.rows));
}

static ts_status report_verdicts(ts_cli *cli, comparison *c)
{
	char class_name[64], relaxed[TS_RELAXED_TEXT];
	snprintf(class_name, sizeof class_name, "touchstone.%s", c->of.of->method);
	ts_relaxed_text(relaxed, cli);
	c->relaxed = relaxed;
	if (ts_outcomes_begin(&c->outcomes, "stage", class_name) != TS_OK) return TS_ERROR;
	ts_compare_outcomes(&c->outcomes, &c->of, &c->lists);
	ts_status status = ts_outcomes_count(&c->outcomes, TS_FAILED) > 0 ? TS_DIFFERENT : TS_OK;
	const ts_outcomes_output output = {"compare",  &c->outcomes, relaxed,  c->cases, status,
	                                   report_all, false,        draw_all, show_all, c};
	const size_t n = json_array_size(c->cases);
	if (c->cases != NULL && cli->job.shard.index > n) ts_shard_say_empty(cli->job.shard, n);
	return ts_outcomes_report(cli, &output, true) == TS_OK ? status : TS_ERROR;
}

ts_status ts_compare_command(ts_cli *cli)
{
	kind is = kind_of(cli->arguments[0]);
	if (check_options(cli, is) != TS_OK) return TS_ERROR;
	if (is == IMAGES) return ts_compare_images(cli);
	comparison c = {.cli = cli};
	ts_status status = open_sides(&c.of, cli, is);
	if (status == TS_OK) status = judge(&c);
	if (status != TS_ERROR) status = report_verdicts(cli, &c);
	ts_outcomes_end(&c.outcomes);
	ts_compare_lists_free(&c.lists);
	close_all(&c.of);
	json_decref(c.cases);
	free(c.own);
	free(c.mask);
	return status;
}

void ts_compare_failed(const ts_cli *cli, ts_status status) { ts_outcomes_report_failed(cli, "compare", status); }

/* `replay TRACE`: runs one stage again, or every stage, from the buffers of a trace or of a port, and judges the
 * results. */
#include <stdio.h>
#include <string.h>
#include "cli/replay_report.h"

typedef struct {
	const ts_cli *cli;
	ts_context *context;
	ts_trace *reference, *candidate; /* candidate: NULL if there is none */
	ts_report report;
} work;

static bool is_judged(const ts_verdicts *verdicts)
{
	const ts_verdict_info *v;
	bool any = false;
	for (size_t i = 0; (v = ts_verdicts_at(verdicts, i)) != NULL; i++) any |= v->judgement >= TS_SAME;
	return any;
}

/* Runs the stage on its inputs and compares the results. `error` is set if it cannot run. */
static void replay(ts_replayed *r, const work *w)
{
	const ts_compare_options options = {.bytes = sizeof options, .lent = 1};
	r->status = ts_replay(w->context, &r->verdicts, r->stage, w->reference, w->candidate, &options);
	if (r->status == TS_OK && !is_judged(r->verdicts) && w->cli->job.output.dir == NULL) {
		r->status = ts_fail("stage %s: no file of its outputs to compare with", r->stage);
	}
	if (r->status == TS_ERROR) snprintf(r->error, sizeof r->error, "%s", ts_error_message());
}

static ts_status write_outputs(const work *w, const char *stage)
{
	ts_trace *made;
	if (ts_trace_replay(w->context, &made, stage, w->reference, w->candidate) != TS_OK) return TS_ERROR;
	ts_status status = ts_trace_save(w->context, made, w->cli->job.output.dir, NULL);
	ts_trace_close(made);
	return status;
}

/* Stage i of the method, NULL behind the last. */
static const char *stage_at(const work *w, ts_replayed *r, size_t i)
{
	const ts_trace_info *of = ts_trace_about(w->reference);
	const ts_stage_info *stage = ts_method_stage(of->effect, of->method, i);
	*r = (ts_replayed){.number = ts_method_stage_number(of->effect, of->method, i)};
	return r->stage = stage != NULL ? stage->name : NULL;
}

static ts_status replay_one(work *w, const char *name)
{
	ts_replayed r;
	for (size_t i = 0; stage_at(w, &r, i) != NULL && strcmp(r.stage, name) != 0; i++) {
	}
	if (r.stage == NULL) r.stage = name; /* not a stage, which ts_replay reports */
	replay(&r, w);
	ts_status status = r.status;
	if (status != TS_ERROR && w->cli->job.output.dir != NULL && write_outputs(w, name) != TS_OK) status = TS_ERROR;
	if (status != TS_ERROR) ts_replay_report_outputs(&w->report, &r);
	ts_verdicts_free(r.verdicts);
	return status;
}

static ts_status replay_all(work *w)
{
	u32 n = 0, n_failed = 0, n_different = 0;
	ts_replayed r;
	for (size_t i = 0; stage_at(w, &r, i) != NULL; i++) {
		if (!ts_trace_takes(w->reference, r.stage)) continue;
		replay(&r, w);
		ts_replay_report_stage(&w->report, &r);
		n++;
		n_failed += r.status == TS_ERROR;
		n_different += r.status == TS_DIFFERENT;
		ts_verdicts_free(r.verdicts);
	}
	if (n_failed > 0) return ts_fail("%u of %u stages could not be replayed", (unsigned)n_failed, (unsigned)n);
	return n_different > 0 ? TS_DIFFERENT : TS_OK;
}

static ts_status work_on(work *w)
{
	char message[1024];
	const ts_cli *cli = w->cli;
	if (ts_trace_match(w->reference, w->candidate) != TS_OK) return TS_ERROR;
	ts_report_begin(&w->report, cli->job.output.json);
	w->report.quiet = cli->job.output.quiet;
	ts_replay_report_begin(&w->report, w->reference, w->candidate);
	ts_status status = cli->stage != NULL ? replay_one(w, cli->stage) : replay_all(w);
	if (status == TS_ERROR && cli->stage != NULL) {
		ts_report_discard(&w->report);
		return status;
	}
	snprintf(message, sizeof message, "%s", ts_error_message());
	if (ts_report_end(&w->report) != TS_OK) return TS_ERROR;
	return status == TS_ERROR ? ts_fail("%s", message) : status;
}

ts_status ts_replay_command(ts_cli *cli)
{
	work w = {.cli = cli};
	if (cli->job.output.dir != NULL && cli->stage == NULL)
		return ts_fail("replay: -o is for the outputs of one stage; add --stage");
	ts_status status = ts_client_open(&w.context, cli);
	if (status == TS_OK) status = ts_trace_open(w.context, &w.reference, cli->arguments[0]);
	if (status == TS_OK && cli->inputs != NULL) status = ts_trace_open(w.context, &w.candidate, cli->inputs);
	if (status == TS_OK) status = work_on(&w);
	ts_trace_close(w.candidate);
	ts_trace_close(w.reference);
	ts_context_close(w.context);
	return status;
}

/* `replay TRACE`: one stage again, or every stage, from the buffers of a trace or of a port, judged by what they
 * hold. */
#include <stdio.h>
#include "../replay/judge.h"
#include "../replay/outputs.h"
#include "cli.h"
#include "../study/folder.h"
#include "replay_report.h"

static const char *place(void *user, const char *name)
{
	(void)user;
	return ts_folder_file(name);
}

/* What the stage makes of its inputs, and how that compares. `error` is set if it cannot run. */
static void replay(ts_replayed *r, const ts_cli *cli, const ts_trace *reference, const ts_trace *candidate)
{
	ts_load *load;
	r->status = ts_replay_run(&load, r->stage, reference, candidate, cli->job.how.threads);
	for (const ts_buffer_id *id = ts_stage_outputs(r->stage); *id != TS_N_BUFFERS && r->status != TS_ERROR; id++) {
		if (!load->run.frame.buffer[*id].made) continue;
		ts_status status = ts_judge(&r->judged[r->n_judged++], load, *id, NULL);
		if (status == TS_ERROR) ts_fail("stage %s: %s", r->stage->name, ts_error_message());
		r->status = status > r->status ? status : r->status;
	}
	bool writes = r->status != TS_ERROR && cli->job.output.dir != NULL;
	if (writes && ts_outputs_write(load, r->stage, place, NULL) != TS_OK) {
		r->status = ts_fail("stage %s: %s", r->stage->name, ts_error_message());
	}
	bool any = false;
	for (u32 i = 0; i < r->n_judged; i++) any |= r->judged[i].item != NULL;
	if (r->status == TS_OK && !any && cli->job.output.dir == NULL) {
		r->status = ts_fail("stage %s: no file of its outputs to compare with", r->stage->name);
	}
	if (r->status == TS_ERROR) snprintf(r->error, sizeof r->error, "%s", ts_error_message());
	ts_load_end(load);
}

static ts_status replay_one(const ts_cli *cli, const ts_trace *reference, const ts_trace *candidate, ts_report *report)
{
	ts_replayed replayed = {.stage = ts_replay_find(cli->stage, reference->pipeline, &reference->params)};
	if (replayed.stage == NULL) return TS_ERROR;
	if (cli->job.output.dir != NULL && ts_results_begin(cli->job.output.dir, false) != TS_OK) return TS_ERROR;
	replay(&replayed, cli, reference, candidate);
	if (cli->job.output.dir != NULL && (replayed.status == TS_ERROR || ts_folder_commit() != TS_OK)) {
		if (replayed.status != TS_ERROR) snprintf(replayed.error, sizeof replayed.error, "%s", ts_error_message());
		replayed.status = TS_ERROR;
		ts_folder_discard();
	}
	if (replayed.status == TS_ERROR) return ts_fail("%s", replayed.error);
	ts_replay_report_outputs(report, &replayed, reference->pipeline);
	return replayed.status;
}

static ts_status replay_all(const ts_cli *cli, const ts_trace *reference, const ts_trace *candidate, ts_report *report)
{
	u32 n = 0, n_failed = 0, n_different = 0;
	for (const ts_step *step = ts_pipeline_steps(reference->pipeline); step->stage != NULL; step++) {
		if (!ts_replay_takes(step, reference)) continue;
		ts_replayed replayed = {.stage = ts_stage_find(step->stage)};
		replay(&replayed, cli, reference, candidate);
		ts_replay_report_stage(report, &replayed, reference->pipeline);
		n++;
		n_failed += replayed.status == TS_ERROR;
		n_different += replayed.status == TS_DIFFERENT;
	}
	if (n_failed > 0) return ts_fail("%u of %u stages could not be replayed", (unsigned)n_failed, (unsigned)n);
	return n_different > 0 ? TS_DIFFERENT : TS_OK;
}

static ts_status replay_traces(const ts_cli *cli, const ts_trace *reference, const ts_trace *candidate)
{
	ts_report report;
	if (ts_load_match(reference, candidate) != TS_OK) return TS_ERROR;
	ts_report_begin(&report, cli->job.output.json);
	report.quiet = cli->job.output.quiet;
	ts_replay_report_begin(&report, reference, candidate);
	ts_status status = cli->stage != NULL ? replay_one(cli, reference, candidate, &report)
	                                      : replay_all(cli, reference, candidate, &report);
	if (status == TS_ERROR && cli->stage != NULL) {
		ts_report_discard(&report);
		return status;
	}
	char message[1024];
	snprintf(message, sizeof message, "%s", ts_error_message());
	if (ts_report_end(&report) != TS_OK) return TS_ERROR;
	return status == TS_ERROR ? ts_fail("%s", message) : status;
}

ts_status ts_replay_command(ts_cli *cli)
{
	ts_trace *reference, *candidate = NULL;
	if (cli->job.output.dir != NULL && cli->stage == NULL)
		return ts_fail("replay: -o is for the outputs of one stage; add --stage");
	if (ts_selftest_require() != TS_OK || ts_trace_open_folder(&reference, cli->arguments[0]) != TS_OK) return TS_ERROR;
	ts_status status = TS_OK;
	if (cli->inputs != NULL) status = ts_trace_open_folder(&candidate, cli->inputs);
	if (status == TS_OK) status = replay_traces(cli, reference, candidate);
	ts_trace_close(candidate);
	ts_trace_close(reference);
	return status;
}

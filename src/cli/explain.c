/* `explain TRACE [OTHER]`: what one item of a stage computes, line by line; of two traces, the first line that
 * differs. */
#include <stdlib.h>
#include "../explain/explain.h"
#include "../model/renamed.h"
#include "cli.h"
#include "explain_report.h"

enum { LINES = 20000 };

static ts_status take_kernel(ts_question *q, const char *name)
{
	ts_nearest nearest = ts_nearest_begin(name);
	for (u32 k = 0; k < TS_N_KERNELS; k++) {
		ts_nearest_offer(&nearest, ts_kernel_name(k));
		if (strcmp(ts_kernel_name(k), name) == 0) q->kernel = k;
	}
	if (q->kernel != TS_N_KERNELS) return TS_OK;
	return ts_fail("--kernel %s: no such kernel%s", name, ts_nearest_hint(&nearest, NULL));
}

/* "BUFFER:E". */
static ts_status take_element(ts_question *q, const char *text, const ts_stage *stage)
{
	char name[64];
	u32 element;
	const char *colon = strrchr(text, ':');
	if (colon == NULL || (size_t)(colon - text) >= sizeof name)
		return ts_fail("--element %s: not BUFFER:E, such as splat.depth_index:12", text);
	snprintf(name, sizeof name, "%.*s", (int)(colon - text), text);
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		if (strcmp(ts_buffer_table[*id].name, ts_name_typed(TS_NAME_buffer, name)) == 0) q->buffer = *id;
	}
	if (q->buffer == TS_N_BUFFERS)
		return ts_fail("--element %s: stage %s writes no buffer %s; see: touchstone list stages", text, stage->name,
		               name);
	if (ts_words_count(&element, colon + 1, 0, 4294967295u, "--element") != TS_OK) return TS_ERROR;
	q->element = element;
	return TS_OK;
}

static ts_status ask(ts_question *q, const ts_cli *cli, const ts_stage *stage)
{
	*q = (ts_question){.subject = TS_EXPLAIN_LAUNCHES,
	                   .kernel = TS_N_KERNELS,
	                   .item = cli->place.item,
	                   .buffer = TS_N_BUFFERS,
	                   .primitives = cli->place.primitives,
	                   .most = cli->place.lines != 0 ? cli->place.lines : LINES};
	if (cli->given[TS_OPTION_ITEM]) q->subject = TS_EXPLAIN_ITEM;
	if (cli->place.kernel != NULL && take_kernel(q, cli->place.kernel) != TS_OK) return TS_ERROR;
	if (cli->place.element == NULL) return TS_OK;
	if (q->subject == TS_EXPLAIN_ITEM || cli->place.kernel != NULL)
		return ts_fail("explain: --element finds the kernel and the item; leave --item and --kernel out");
	q->subject = TS_EXPLAIN_ELEMENT;
	return take_element(q, cli->place.element, stage);
}

static ts_status explain(const ts_cli *cli, const ts_trace *trace, const ts_trace *other, const ts_trace *inputs)
{
	ts_question question;
	ts_explanation a, b = {.load = NULL};
	const ts_stage *stage = ts_replay_find(cli->stage, trace->pipeline, &trace->params);
	if (stage == NULL || ask(&question, cli, stage) != TS_OK) return TS_ERROR;
	ts_status status = ts_explain(&a, stage, &question, trace, inputs);
	if (status == TS_OK && other != NULL) status = ts_explain(&b, stage, &question, trace, other);
	if (status == TS_OK) {
		ts_told_what what = {stage, &question, trace, inputs, other, &a, other != NULL ? &b : NULL};
		status = ts_explain_report(&what, cli->job.output.json);
	}
	ts_explain_end(&b);
	ts_explain_end(&a);
	return status;
}

ts_status ts_explain_command(ts_cli *cli)
{
	ts_trace *trace, *other = NULL, *inputs = NULL;
	if (cli->stage == NULL) return ts_fail("explain: --stage NAME must be given; see: touchstone list stages");
	if (cli->inputs != NULL && cli->n_arguments > 1)
		return ts_fail("explain: OTHER or --inputs, not both; OTHER is beside TRACE, --inputs in its place");
	if (ts_selftest_require() != TS_OK || ts_trace_open_folder(&trace, cli->arguments[0]) != TS_OK) return TS_ERROR;
	ts_status status = TS_OK;
	if (cli->n_arguments > 1) status = ts_trace_open_folder(&other, cli->arguments[1]);
	if (status == TS_OK && other != NULL) status = ts_load_match(trace, other);
	if (status == TS_OK && cli->inputs != NULL) status = ts_trace_open_folder(&inputs, cli->inputs);
	if (status == TS_OK) status = explain(cli, trace, other, inputs);
	ts_trace_close(inputs);
	ts_trace_close(other);
	ts_trace_close(trace);
	return status;
}

/* `explain TRACE [OTHER]`: what one item of a stage computes, line by line or as an outline; for two traces, the first
 * line that differs, and the paragraph in which they part. */
#include <string.h>
#include "cli/client.h"
#include "study/results/table.h"

enum { NAME = 64 };

/* "BUFFER:E". */
static ts_status take_element(ts_explain_options *o, char name[NAME], const char *text)
{
	u32 element;
	const char *colon = strrchr(text, ':');
	if (colon == NULL || (size_t)(colon - text) >= NAME)
		return ts_fail("--element %s: not BUFFER:E, such as splat.depth_index:12", text);
	snprintf(name, NAME, "%.*s", (int)(colon - text), text);
	if (ts_words_count(&element, colon + 1, 0, 4294967295u, "--element") != TS_OK) return TS_ERROR;
	o->buffer = name;
	o->element = element;
	return TS_OK;
}

static ts_status ask(ts_explain_options *o, char name[NAME], const ts_cli *cli)
{
	*o = (ts_explain_options){.bytes = sizeof *o,
	                          .stage = cli->stage,
	                          .kernel = cli->place.kernel,
	                          .item_said = cli->given[TS_OPTION_ITEM],
	                          .item = cli->place.item,
	                          .primitives = cli->place.primitives,
	                          .lines = cli->place.lines,
	                          .outline = cli->place.outline,
	                          .as_text = !cli->job.output.json};
	if (cli->stage == NULL) return ts_fail("explain: --stage NAME must be given; see: touchstone list stages");
	if (cli->inputs != NULL && cli->n_arguments > 1)
		return ts_fail("explain: OTHER or --inputs, not both; OTHER is beside TRACE, --inputs in its place");
	if (cli->place.element == NULL) return TS_OK;
	if (o->item_said || o->kernel != NULL)
		return ts_fail("explain: --element finds the kernel and the item; leave --item and --kernel out");
	return take_element(o, name, cli->place.element);
}

/* Only the number of lines left out begins with a digit. */
static void print_line(ts_report *report, const char *line)
{
	ts_report_line(report, "%s%s", line, line[0] >= '0' && line[0] <= '9' ? ": --lines" : "");
}

static ts_status print_answer(ts_tree *tree, bool json)
{
	ts_report report;
	const char *key;
	json_t *value, *answer = ts_client_json(tree);
	size_t i;
	if (answer == NULL) return TS_ERROR;
	ts_report_begin(&report, json);
	json_array_foreach (answer, i, value) print_line(&report, json_string_value(value));
	json_object_foreach (answer, key, value) ts_report_value(&report, key, json_incref(value));
	json_decref(answer);
	return ts_report_end(&report);
}

ts_status ts_explain_command(ts_cli *cli)
{
	ts_context *context;
	ts_trace *trace = NULL, *other = NULL, *inputs = NULL;
	ts_explain_options options;
	ts_tree *answer = NULL;
	char name[NAME];
	if (ask(&options, name, cli) != TS_OK) return TS_ERROR;
	ts_status status = ts_client_open(&context, cli);
	if (status == TS_OK) status = ts_trace_open(context, &trace, cli->arguments[0]);
	if (status == TS_OK && cli->n_arguments > 1) status = ts_trace_open(context, &other, cli->arguments[1]);
	if (status == TS_OK && cli->inputs != NULL) status = ts_trace_open(context, &inputs, cli->inputs);
	if (status == TS_OK) status = ts_explain_item(context, &answer, &options, trace, inputs, other);
	if (status != TS_ERROR && print_answer(answer, cli->job.output.json) != TS_OK) status = TS_ERROR;
	ts_trace_close(inputs);
	ts_trace_close(other);
	ts_trace_close(trace);
	ts_context_close(context);
	return status;
}

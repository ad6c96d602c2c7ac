/* Tables. */
#include <touchstone/bench.h>
#include "api/api.h"
#include "study/tables/tables.h"

/* Whether it is another size than that of the defaults. */
static bool is_sized(const ts_params *params)
{
	ts_params defaults;
	ts_params_default(&defaults);
	return TS_PARAM(params, width) != TS_PARAM(&defaults, width) ||
	       TS_PARAM(params, height) != TS_PARAM(&defaults, height);
}

static ts_status measure(const ts_job *job, const char *table)
{
	ts_tables *tables;
	const ts_bench_row *row;
	ts_status status = ts_tables_open_named(&tables, &row, table);
	if (status == TS_OK && ts_tables_is_general(row))
		status = ts_fail("bench %s: measures this machine, which the command alone does", row->name);
	if (status == TS_OK) status = ts_tables_run(row, job);
	if (status == TS_OK && ts_cancelled()) status = ts_fail_as(TS_KIND_CANCELLED, "bench %s: cancelled", row->name);
	ts_tables_close(tables);
	return status;
}

ts_status ts_bench_table(ts_context *context, ts_tree **figures, const char *table, const ts_params *params,
                         const ts_bench_options *options)
{
	json_t *tree = NULL;
	ts_bench_options ours = {0};
	if (TS_LACKS(figures)) return TS_ERROR;
	*figures = NULL;
	if (TS_LACKS(context) || TS_LACKS(table) || TS_LACKS(params)) return TS_ERROR;
	if (ts_api_options(&ours, sizeof ours, options, "ts_bench_options") != TS_OK) return TS_ERROR;
	if (ts_api_enter(context) != TS_OK) return TS_ERROR;
	const ts_job job = {.program = "touchstone",
	                    .backends = ts_backend_kinds,
	                    .backend = context->kind,
	                    .how = context->how,
	                    .params = *params,
	                    .sized = is_sized(params),
	                    .scenes = ours.scenes,
	                    .objects = ours.objects,
	                    .runs = ours.runs,
	                    .output = {.json = true, .tree = &tree}};
	ts_status status = measure(&job, table);
	ts_api_leave();
	*figures = (ts_tree *)tree;
	return status;
}

/* A shard of a series: which renders it has, and its record of each, which merge reads. */
#include "cli/reports/sharded.h"
#include "cli/series.h"
#include "output/json/text.h"

bool ts_series_has(const ts_series *series, u32 combination, u32 k)
{
	const ts_job *job = series->job;
	if (job->sweep.n > 0) return ts_shard_has(job->shard, combination);
	return ts_shard_has_block(job->shard, k, ts_frames_count(&job->frames));
}

/* [["points", 0, "0x1.8p+3"], ...] */
static json_t *figures_json(const ts_series_figure_list *figures)
{
	json_t *list = json_array();
	int failed = list == NULL;
	for (u32 i = 0; i < figures->n; i++) {
		char value[40];
		snprintf(value, sizeof value, "%a", figures->figure[i].value);
		json_t *row = json_pack("[s, i, s]", figures->figure[i].name, figures->figure[i].decimals, value);
		failed |= json_array_append_new(list, row) != 0;
	}
	if (failed == 0) return list;
	json_decref(list);
	return NULL;
}

/* The lines about truths that this render lacks, by the truths' names; NULL without memory. */
static json_t *missing_json(const ts_series *series)
{
	json_t *lines = json_object();
	int failed = lines == NULL;
	for (u32 t = 0; ts_truths()[t] != NULL; t++) {
		char line[TS_MISSING_LINE];
		if ((series->absent >> t & 1) == 0) continue;
		ts_render_truth_missing(line, sizeof line, series->render, t);
		failed |= json_object_set_new(lines, ts_truths()[t]->name, ts_text_json(line)) != 0;
	}
	if (failed == 0) return lines;
	json_decref(lines);
	return NULL;
}

ts_status ts_series_record(ts_series *series)
{
	json_t *images = json_object();
	json_t *row =
		json_pack("{s:i, s:i, s:o, s:o}", "combination", (int)series->combination, "frame",
	              (int)TS_PARAM(&series->job->params, frame), "images", images, "missing", missing_json(series));
	int failed = row == NULL;
	for (u32 i = 0; i < TS_MAX_SHOWN && failed == 0; i++) {
		char name[24];
		if (ts_render_shown(series->render, i) == NULL) continue;
		ts_render_name(name, sizeof name, series->render, i);
		failed = json_object_set_new(images, name, figures_json(&series->rows[i]->figures));
	}
	failed |= json_array_append_new(series->renders, row);
	return failed == 0 ? TS_OK : ts_fail("the figures of a shard: out of memory");
}

/* Combinations, or frames. */
static json_t *cases_json(const ts_series *series)
{
	const ts_job *job = series->job;
	u32 n = job->sweep.n > 0 ? ts_sweep_count(&job->sweep) : ts_frames_count(&job->frames);
	json_t *cases = json_array();
	int failed = cases == NULL;
	for (u32 i = 0; i < n; i++) {
		failed |= json_array_append_new(cases, json_sprintf(job->sweep.n > 0 ? "combination %u" : "frame %u", i)) != 0;
	}
	if (failed == 0) return cases;
	json_decref(cases);
	ts_fail("the names of cases: out of memory");
	return NULL;
}

ts_status ts_series_shard_write(ts_series *series)
{
	const ts_sharded sharded = {"render", "touchstone.render", cases_json(series), TS_OK, series->renders};
	if (sharded.cases == NULL) return TS_ERROR;
	ts_report_value(&series->report, "program", json_string(series->job->program));
	ts_status status = ts_sharded_write(&series->report, series->cli, &sharded);
	json_decref(sharded.cases);
	return status;
}

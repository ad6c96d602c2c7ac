/* The findings of `golden check`, as a report. */
#include "cli/golden/golden.h"
#include "cli/reports/outcomes.h"
#include "output/json/text.h"

typedef struct {
	const ts_goldens *goldens;
	const ts_outcomes *outcomes;
	const char *relaxed;
} found;

static void report_found(ts_report *report, const void *user)
{
	const found *f = user;
	u32 passed = ts_outcomes_count(f->outcomes, TS_PASSED), skipped = ts_outcomes_count(f->outcomes, TS_LEFT_OUT);
	u32 known = ts_outcomes_count(f->outcomes, TS_KNOWN);
	u32 failed = (u32)json_array_size(f->outcomes->rows) - passed - skipped - known;
	const char *verdict = ts_outcomes_count(f->outcomes, TS_FAILED) > 0 ? "different"
	                      : failed > 0                                  ? "error"
	                      : passed + known > 0                          ? "same"
	                                                                    : "skipped";
	ts_report_value(report, "version", json_string(TS_VERSION));
	ts_report_value(report, "contract", json_integer(TS_CONTRACT_VERSION));
	ts_report_value(report, "commit", json_string(ts_commit()));
	ts_report_value(report, "reference_dir", json_string(f->goldens->dir.path));
	ts_report_value(report, "backend", json_string(f->goldens->cli->job.backend->name));
	ts_report_value(report, "relaxations", ts_text_json(f->relaxed));
	ts_report_value(report, "verdict", json_string(verdict));
	ts_report_value(report, "passed", json_integer(passed));
	ts_report_value(report, "failed", json_integer(failed));
	ts_report_value(report, "known", json_integer(known));
	ts_report_value(report, "skipped", json_integer(skipped));
	ts_report_value(report, "cases", json_incref(f->outcomes->rows));
}

static void add(ts_outcomes *outcomes, const ts_checked *c)
{
	static const ts_outcome of[TS_N_CASE_ENDS] = {TS_PASSED, TS_LEFT_OUT, TS_KNOWN, TS_FAILED,
	                                              TS_BROKEN, TS_BROKEN,   TS_BROKEN};
	bool differs = c->first != TS_N_BUFFERS;
	const char *stage = differs ? ts_checked_stage(c) : "";
	ts_outcomes_add(outcomes, c->of->name, ts_case_word(c->end), of[c->end], c->why, c->seconds);
	if (c->text[0] != 0) ts_outcomes_line(outcomes, c->text);
	ts_outcomes_value(outcomes, "stage", differs ? json_string(stage) : json_null());
	ts_outcomes_value(outcomes, "buffer", differs ? json_string(ts_buffer_table[c->first].name) : json_null());
}

static json_t *names_of(const ts_goldens *goldens)
{
	json_t *names = json_array();
	int failed = names == NULL;
	for (u32 i = 0; i < goldens->n_chosen; i++) {
		failed |= json_array_append_new(names, json_string(goldens->chosen[i]->name)) != 0;
	}
	if (failed == 0) return names;
	json_decref(names);
	ts_fail("the names of cases: out of memory");
	return NULL;
}

ts_status ts_golden_report_checks(const ts_goldens *goldens, const ts_checked *checked, u32 n, ts_status status)
{
	ts_outcomes outcomes;
	char relaxed[TS_RELAXED_TEXT];
	ts_relaxed_text(relaxed, goldens->cli);
	const found f = {goldens, &outcomes, relaxed};
	ts_outcomes_output output = {"golden check", &outcomes, relaxed, names_of(goldens), status, report_found, true,
	                             NULL,           NULL,      &f};
	ts_status reported = output.cases != NULL ? ts_outcomes_begin(&outcomes, "case", "touchstone.golden") : TS_ERROR;
	if (reported == TS_OK) {
		for (u32 i = 0; i < n; i++) add(&outcomes, &checked[i]);
		reported = ts_outcomes_report(goldens->cli, &output, goldens->cli->job.output.json);
		ts_outcomes_end(&outcomes);
	}
	json_decref(output.cases);
	return reported;
}

void ts_golden_failed(const ts_cli *cli, ts_status status) { ts_outcomes_report_failed(cli, "golden check", status); }

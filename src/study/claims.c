/* `bench list`: all claims of the papers, with the verdict of the last runs of scripts/verdicts. */
#include "study/claims.h"
#include <assert.h>
#include <string.h>

enum { TEXT_BYTES = 4096 };

#define MEASURED(version, commit, scenes) static const char measured[] = version ", commit " commit ", scenes " scenes;
#define VERDICT(paper, place, verdict, times)
#include "study/verdicts.def"
#undef MEASURED
#undef VERDICT

#define MEASURED(version, commit, scenes)
#define VERDICT(paper, place, verdict, times) {paper, place, verdict, times},
static const struct {
	const char *paper, *place, *verdict, *times;
} verdicts[] = {
#include "study/verdicts.def"
	{NULL, NULL, NULL, NULL},
};

static const ts_claim *const *lists;

void ts_claims_use(const ts_claim *const *claims) { lists = claims; }

const ts_claim *const *ts_claims(void)
{
	assert(lists != NULL);
	return lists;
}

static const ts_column columns[] = {{"paper", "paper", false},
                                    {"place", "where", false},
                                    {"shows", "what", false},
                                    {"bench", "bench", false},
                                    {"rows", "rows", false},
                                    {"verdict", "verdict", false},
                                    {0}};

static void verdict_cell(ts_table *table, const ts_claim *claim)
{
	char text[TEXT_BYTES] = "not asked yet";
	for (u32 i = 0; verdicts[i].paper != NULL; i++) {
		const char *verdict = verdicts[i].verdict, *times = verdicts[i].times;
		if (strcmp(verdicts[i].paper, claim->paper) != 0 || strcmp(verdicts[i].place, claim->place) != 0) continue;
		snprintf(text, sizeof text, "%s%s%s", verdict, verdict[0] != 0 && times[0] != 0 ? "; " : "", times);
	}
	if (claim->bench == NULL) snprintf(text, sizeof text, "cannot be asked: %s", claim->cannot);
	ts_table_text(table, text);
}

static void text_cell(ts_table *table, const char *text)
{
	if (text != NULL) {
		ts_table_text(table, text);
	} else {
		ts_table_none(table);
	}
}

static void add_claim(ts_table *table, const ts_claim *claim)
{
	text_cell(table, claim->paper);
	text_cell(table, claim->place);
	text_cell(table, claim->shows);
	text_cell(table, claim->bench);
	text_cell(table, claim->rows);
	verdict_cell(table, claim);
}

static ts_status work_on(const ts_job *job, ts_report *report, const void *user)
{
	(void)job, (void)user;
	ts_table table = ts_table_begin("claims", "", columns);
	for (const ts_claim *const *list = ts_claims(); *list != NULL; list++) {
		for (const ts_claim *claim = *list; claim->paper != NULL; claim++) add_claim(&table, claim);
	}
	ts_report_table(report, &table);
	ts_report_line(report, "Verdicts of scripts/verdicts by version %s. `bench TABLE` asks again.", measured);
	ts_report_value(report, "measured", json_string(measured));
	return TS_OK;
}

ts_status ts_bench_claims(const ts_job *job) { return ts_bench_with_report(job, work_on, NULL); }

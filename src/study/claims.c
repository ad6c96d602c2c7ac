/* `bench list`: all claims of the papers. */
#include "study/claims.h"
#include <assert.h>
#include <string.h>

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
                                    {"cannot", "why it cannot be asked", false},
                                    {0}};

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
	text_cell(table, claim->bench == NULL ? claim->cannot : NULL);
}

static ts_status work_on(const ts_job *job, ts_report *report, const void *user)
{
	(void)job, (void)user;
	ts_table table = ts_table_begin("claims", "", columns);
	for (const ts_claim *const *list = ts_claims(); *list != NULL; list++) {
		for (const ts_claim *claim = *list; claim->paper != NULL; claim++) add_claim(&table, claim);
	}
	ts_report_table(report, &table);
	ts_report_line(report, "`bench TABLE` asks; reference/VERDICTS.md has the answers of the last runs.");
	return TS_OK;
}

ts_status ts_bench_claims(const ts_job *job) { return ts_bench_with_report(job, work_on, NULL); }

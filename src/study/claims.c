/* The claims of papers and what tests them; claims about a table that is not a paper's table of rows. */
#include "study/claims.h"
#include <assert.h>
#include <string.h>
#include "study/bench.h"

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

static const ts_column relation_columns[] = {{"relation", "relation", false}, {"bound", "must be", false},
                                             {"here", "here", true},          {"paper", "paper", true},
                                             {"verdict", "verdict", false},   {0}};

ts_table ts_bench_relations_begin(void)
{
	return ts_table_begin("relations", "What the paper claims", relation_columns);
}

bool ts_bench_has_class(const char *because)
{
	static const char *const classes[] = {TS_OURS, TS_ELSEWHERE, TS_GPU, TS_NOT_ALWAYS};
	for (u32 i = 0; i < sizeof classes / sizeof *classes; i++)
		if (strncmp(because, classes[i], strlen(classes[i])) == 0) return true;
	return false;
}

void ts_bench_relation_add(ts_table *table, const ts_bench_relation *relation)
{
	char verdict[256];
	assert(ts_bench_has_class(relation->because));
	snprintf(verdict, sizeof verdict, relation->holds ? "holds" : "differs: %s", relation->because);
	ts_table_text(table, relation->text);
	ts_table_text(table, relation->bound);
	ts_table_known(table, relation->here, relation->decimals);
	ts_table_known(table, relation->paper, relation->decimals);
	ts_table_text(table, verdict);
}

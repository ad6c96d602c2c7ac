/* The claims of papers and what tests them; claims about a table that is not a paper's table of rows. */
#include "study/claims.h"
#include <assert.h>
#include <string.h>
#include "study/bench.h"

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

/* What must hold of a table that is no paper's table of rows. */
#include "bench.h"

static const ts_column columns[] = {{"relation", "relation", false}, {"bound", "must be", false},
                                    {"here", "here", true},          {"paper", "paper", true},
                                    {"verdict", "verdict", false},   {0}};

ts_table ts_bench_relations_begin(void) { return ts_table_begin("relations", "What the paper claims", columns); }

void ts_bench_relation_add(ts_table *table, const ts_bench_relation *relation)
{
	char verdict[256];
	snprintf(verdict, sizeof verdict, relation->holds ? "holds" : "differs: %s", relation->because);
	ts_table_text(table, relation->text);
	ts_table_text(table, relation->bound);
	ts_table_known(table, relation->here, relation->decimals);
	ts_table_known(table, relation->paper, relation->decimals);
	ts_table_text(table, verdict);
}

/* The tables of `bench`: those of the families' folders `tables`, which are texts of the program, and those of code; or
 * those of a file. */
#ifndef TS_STUDY_TABLES_TABLES_H
#define TS_STUDY_TABLES_TABLES_H
#include "study/bench.h"
#include "study/claims.h"

typedef struct ts_tables ts_tables;

/* Opens all tables of the program; on failure *tables is NULL. */
ts_status ts_tables_open(ts_tables **tables);
/* Opens those of a file instead. */
ts_status ts_tables_open_file(ts_tables **tables, const char *path);
/* By index; NULL behind the last. They live as long as the tables. */
const ts_bench_row *ts_tables_at(const ts_tables *tables, u32 i);
const ts_claim *ts_tables_claim(const ts_tables *tables, u32 i);
/* By name; fails with the nearest name. */
ts_status ts_tables_find(const ts_bench_row **row, const ts_tables *tables, const char *name);
/* Opens the tables of which an argument names one: FILE.table, which has only that one, FILE.table:NAME, or NAME of the
 * program's. *tables is to be closed on failure, too. */
ts_status ts_tables_open_named(ts_tables **tables, const ts_bench_row **row, const char *argument);
/* Whether a table is of no family: it measures machines, in processes of its own. */
bool ts_tables_is_general(const ts_bench_row *row);
void ts_tables_close(ts_tables *tables);
ts_status ts_tables_run(const ts_bench_row *row, const ts_job *job);

/* The table that `list benches` prints. */
ts_table ts_tables_list(void);

#endif

/* Tables of `bench` as text: lines of a key and what it needs, indented lines that belong to the one above, and
 * comments behind `#` at a line's beginning. reference/BENCH.md has the keys. */
#ifndef TS_STUDY_TABLES_TEXT_H
#define TS_STUDY_TABLES_TEXT_H
#include "study/claims.h"
#include "study/speed.h"
#include "study/tables/paper.h"

/* What a text has a name for and code computes: one of the two. */
typedef struct {
	const char *name;
	double (*look)(const ts_run *run);    /* a figure of buffers */
	ts_status (*work)(const ts_job *job); /* a whole table */
} ts_table_code;

typedef struct ts_table_texts ts_table_texts;

/* Takes the code of all families: lists ended by NULL, each ended by a row without a name. They must stay. */
void ts_table_codes_use(const ts_table_code *const *codes);

/* Reads the tables of a text; `path` names it in messages. On failure *texts is NULL. */
ts_status ts_table_texts_read(ts_table_texts **texts, const char *text, const char *path);
/* The table of this index, or NULL behind the last; it lives as long as the texts. */
const ts_bench_row *ts_table_texts_at(const ts_table_texts *texts, u32 i);
/* The claims, ended by one without a paper. */
const ts_claim *ts_table_texts_claims(const ts_table_texts *texts);
/* What `bench speed` measures. */
const ts_speed_of *ts_table_texts_speed(const ts_table_texts *texts);
void ts_table_texts_free(ts_table_texts *texts);

#endif

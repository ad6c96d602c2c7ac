/* What readers of lines share: the texts that are made, the table that is read, and where. */
#ifndef TS_STUDY_TABLES_READER_H
#define TS_STUDY_TABLES_READER_H
#include "study/figure.h"
#include "study/speed.h"
#include "study/tables/cursor.h"
#include "study/tables/text.h"

enum {
	MOST_TERMS = 1024,
	MOST_PARTS = 16,
	MOST_RELATIONS = 32,
	MOST_PICTURES = 8,
	MOST_ROWS = 32,
	MOST_LISTS = 16,
	MOST_TABLES = 32,
	MOST_CLAIMS = 64,
	MOST_FRAMES = 16,
	MOST_SPEEDS = 96,
	MOST_GROWTHS = 16,
	MOST_NAMES = 256
};

typedef struct {
	ts_paper_table paper; /* refers to what follows */
	ts_bench_row row;
	const char *names[TS_BENCH_VARIANTS];
	ts_bench_variant variants[TS_BENCH_VARIANTS + 1];
	ts_bench_figure figures[TS_BENCH_FIGURES + 1];
	ts_term terms[MOST_TERMS];
	ts_figure measured[TS_BENCH_MEASURED + 1];
	ts_paper_part parts[MOST_PARTS + 1];
	ts_paper_relation relations[MOST_RELATIONS + 1];
	ts_paper_picture pictures[MOST_PICTURES + 1];
	ts_paper_row rows[MOST_ROWS + 1];
	ts_paper_plot plot;
	u8 printed[TS_BENCH_FIGURES]; /* figures of the rows, in the order of their columns */
	u64 taken;                    /* lines that it has, by their number */
	u32 n_variants, n_figures, n_terms, n_measured, n_parts, n_relations, n_pictures, n_rows, n_printed;
} ts_one_table;

struct ts_table_texts {
	char *text, *names; /* names: room behind the text */
	ts_named_list lists[MOST_LISTS];
	ts_one_table *tables[MOST_TABLES];
	ts_claim claims[MOST_CLAIMS + 1];
	ts_speed_scene scenes[MOST_FRAMES + 1];
	ts_speed_figure figures[MOST_SPEEDS + 1];
	ts_speed_growth growths[MOST_GROWTHS + 1];
	ts_speed_name speed_names[MOST_NAMES];
	ts_term terms[MOST_TERMS];
	u32 n_lists, n_tables, n_claims, n_scenes, n_figures, n_growths, n_terms;
	ts_speed_of speed;
};

typedef enum { TS_IN_NOTHING, TS_IN_PART, TS_IN_ROWS } ts_table_place;

typedef struct {
	ts_cursor c;
	ts_table_texts *texts;
	ts_one_table *t;         /* that is read; NULL before the first */
	ts_table_place indented; /* what indented lines belong to */
} ts_table_reader;

/* Each takes what stands behind its key, or an indented line. */
void ts_take_figure(ts_table_reader *r);
void ts_take_part(ts_table_reader *r);
void ts_add_to_part(ts_table_reader *r);
void ts_take_claim(ts_table_reader *r);
void ts_take_paper(ts_table_reader *r);
void ts_add_to_paper(ts_table_reader *r);
void ts_take_frame(ts_table_reader *r);
void ts_take_speed(ts_table_reader *r);
void ts_take_growth(ts_table_reader *r);

/* The place of the next of `n`, of which there are at most so many. */
u32 ts_take_next(ts_table_reader *r, u32 *n, u32 most, const char *what);
/* The index of the figure above whose key comes next, or is `word`. */
u8 ts_take_key(ts_table_reader *r);
u8 ts_take_key_of(ts_table_reader *r, const char *word);
/* Parameters that are set: "NAME=VALUE,...". */
void ts_check_set(ts_table_reader *r, const char *list, bool of_variant);
/* An effect, a truth's or a method's. */
const char *ts_take_effect(ts_table_reader *r);
/* Decimals, or "whole". */
int ts_take_decimals(ts_table_reader *r);
/* Copies a name of `n` characters to where it stays. */
char *ts_keep_name(ts_table_reader *r, const char *text, size_t n);
ts_name_scope ts_table_scope(const ts_table_reader *r);

#endif

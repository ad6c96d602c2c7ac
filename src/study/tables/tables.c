/* The tables of `bench`. */
#include "study/tables/tables.h"
#include <stdlib.h>
#include <string.h>
#include "model/input.h"
#include "study/asked/words.h"
#include "study/tables/text.h"

enum { ROWS = 128, CLAIMS = 256, TEXTS = 32, RUNS = 3, MOST_BYTES = 1 << 24 };

struct ts_tables {
	ts_table_texts *texts[TEXTS];
	const ts_bench_row *rows[ROWS + 1];
	const ts_claim *claims[CLAIMS + 1];
	const ts_speed_of *speeds[TEXTS + 1]; /* of texts that have frames or growths */
	ts_bench_row speed;
	u32 n_texts, n_rows, n_claims, n_speeds;
};

/* A text of the program, ended by a zero. */
typedef struct {
	const char *path, *text;
} source;
#include "tables.inc"

static ts_status bench_list(const ts_job *job);

/* Tables of no family. */
static const ts_bench_row general[] = {
	{"backends", "each stage in C and on every device, of one frame by one --method (epr); and builds",
     "truth " TS_BENCH_FILES, .run = ts_bench_backends, .runs = 5},
	{"start", "the seconds from opening --backend to its first frames", "truth " TS_BENCH_FILES, .run = ts_bench_start},
	{"list", "what the papers show, which table asks it, and the verdict", "", .takes = "json", .run = bench_list},
	{0},
};

static ts_status add(ts_tables *tables, const char *text, const char *path)
{
	ts_table_texts *read;
	const ts_bench_row *row;
	if (tables->n_texts == TEXTS) return ts_fail("%s: more than %d files of tables", path, TEXTS);
	if (ts_table_texts_read(&read, text, path) != TS_OK) return TS_ERROR;
	tables->texts[tables->n_texts++] = read;
	for (u32 i = 0; (row = ts_table_texts_at(read, i)) != NULL && tables->n_rows < ROWS; i++)
		tables->rows[tables->n_rows++] = row;
	for (const ts_claim *c = ts_table_texts_claims(read); c->paper != NULL && tables->n_claims < CLAIMS; c++)
		tables->claims[tables->n_claims++] = c;
	const ts_speed_of *speed = ts_table_texts_speed(read);
	if (speed->scenes->name != NULL || speed->growths->of.name != NULL) tables->speeds[tables->n_speeds++] = speed;
	return TS_OK;
}

/* The table "speed", if a text has frames or growths. */
static void add_speed(ts_tables *tables)
{
	tables->speed =
		(ts_bench_row){.name = "speed",
	                   .doc = "stages beside Embree, bare points and the machine's limits; --scene names frames and "
	                          "growths",
	                   .without = "truth frames",
	                   .speed = tables->speeds,
	                   .quiet = true};
	if (tables->n_speeds > 0) tables->rows[tables->n_rows++] = &tables->speed;
}

ts_status ts_tables_open(ts_tables **tables)
{
	ts_tables *made = *tables = ts_alloc_zero(1, sizeof *made, "tables");
	ts_status status = made != NULL ? TS_OK : TS_ERROR;
	for (const source *s = sources; status == TS_OK && s->text != NULL; s++) status = add(made, s->text, s->path);
	if (status == TS_OK) add_speed(made);
	for (const ts_bench_row *row = general; status == TS_OK && row->name != NULL; row++)
		made->rows[made->n_rows++] = row;
	if (status == TS_OK) return TS_OK;
	ts_tables_close(made);
	*tables = NULL;
	return TS_ERROR;
}

ts_status ts_tables_open_file(ts_tables **tables, const char *path)
{
	size_t bytes;
	char *text = ts_text_read(&bytes, path, MOST_BYTES);
	ts_tables *made = *tables = text != NULL ? ts_alloc_zero(1, sizeof *made, "tables") : NULL;
	ts_status status = made != NULL ? TS_OK : TS_ERROR;
	if (status == TS_OK && strlen(text) != bytes) status = ts_fail("%s: no text: a byte of it is 0", path);
	if (status == TS_OK) status = add(made, text, path);
	if (status == TS_OK) add_speed(made);
	free(text);
	if (status == TS_OK) return TS_OK;
	ts_tables_close(made);
	*tables = NULL;
	return TS_ERROR;
}

const ts_bench_row *ts_tables_at(const ts_tables *tables, u32 i) { return tables->rows[i]; }

const ts_claim *ts_tables_claim(const ts_tables *tables, u32 i) { return tables->claims[i]; }

ts_status ts_tables_find(const ts_bench_row **row, const ts_tables *tables, const char *name)
{
	const ts_bench_row *const *each = tables->rows;
	while (*each != NULL && strcmp((*each)->name, name) != 0) each++;
	*row = *each;
	if (*row != NULL) return TS_OK;
	ts_nearest nearest = ts_nearest_begin(name);
	for (each = tables->rows; *each != NULL; each++) ts_nearest_offer(&nearest, (*each)->name);
	return ts_fail("bench: no table \"%s\"%s", name, ts_nearest_hint(&nearest, "touchstone list benches"));
}

/* The length of the path that ends with .table, behind which nothing stands or a colon; 0: there is none. */
static size_t path_length(const char *argument)
{
	const char *end = strstr(argument, ".table");
	while (end != NULL && end[6] != 0 && end[6] != ':') end = strstr(end + 1, ".table");
	return end != NULL ? (size_t)(end + 6 - argument) : 0;
}

/* Opens the tables of FILE.table or FILE.table:NAME, and finds the one; if there is only one it needs no name. */
static ts_status open_file(ts_tables **tables, const ts_bench_row **row, const char *argument, size_t path_bytes)
{
	char path[4096];
	const char *name = argument[path_bytes] != 0 ? argument + path_bytes + 1 : NULL;
	if (path_bytes >= sizeof path) return ts_fail("bench: the name of the file of tables is too long");
	snprintf(path, path_bytes + 1, "%s", argument);
	if (ts_tables_open_file(tables, path) != TS_OK) return TS_ERROR;
	*row = ts_tables_at(*tables, 0);
	if (name != NULL) return ts_tables_find(row, *tables, name);
	if (*row == NULL) return ts_fail("%s: has no table", path);
	if (ts_tables_at(*tables, 1) == NULL) return TS_OK;
	return ts_fail("%s: has several tables; name one, as %s:%s", path, path, (*row)->name);
}

ts_status ts_tables_open_named(ts_tables **tables, const ts_bench_row **row, const char *argument)
{
	size_t path = path_length(argument);
	*tables = NULL;
	if (path != 0) return open_file(tables, row, argument, path);
	ts_status status = ts_tables_open(tables);
	return status == TS_OK ? ts_tables_find(row, *tables, argument) : status;
}

bool ts_tables_is_general(const ts_bench_row *row)
{
	const ts_bench_row *own = general;
	while (own->name != NULL && own != row) own++;
	return own->name != NULL || row->speed != NULL;
}

void ts_tables_close(ts_tables *tables)
{
	if (tables == NULL) return;
	for (u32 i = 0; i < tables->n_texts; i++) ts_table_texts_free(tables->texts[i]);
	free(tables);
}

static void text_cell(ts_table *table, const char *text)
{
	if (text != NULL) {
		ts_table_text(table, text);
	} else {
		ts_table_none(table);
	}
}

ts_table ts_tables_list(void)
{
	static const ts_column columns[] = {
		{"name", "table", false}, {"doc", "what it measures", false}, {"brief", "in brief", false}, {0}};
	ts_table list = ts_table_begin("benches", "", columns);
	ts_tables *tables;
	if (ts_tables_open(&tables) != TS_OK) {
		list.failed = true;
		return list;
	}
	for (const ts_bench_row *const *row = tables->rows; *row != NULL; row++) {
		ts_table_text(&list, (*row)->name);
		ts_table_text(&list, (*row)->doc);
		text_cell(&list, (*row)->brief);
	}
	ts_tables_close(tables);
	return list;
}

static ts_status report_claims(const ts_job *job, ts_report *report, const void *user)
{
	static const ts_column columns[] = {{"paper", "paper", false},
	                                    {"place", "where", false},
	                                    {"shows", "what", false},
	                                    {"bench", "bench", false},
	                                    {"rows", "rows", false},
	                                    {"cannot", "why it cannot be asked", false},
	                                    {0}};
	(void)job, (void)user;
	ts_tables *tables;
	if (ts_tables_open(&tables) != TS_OK) return TS_ERROR;
	ts_table table = ts_table_begin("claims", "", columns);
	for (const ts_claim *const *claim = tables->claims; *claim != NULL; claim++) {
		ts_table_text(&table, (*claim)->paper);
		ts_table_text(&table, (*claim)->place);
		ts_table_text(&table, (*claim)->shows);
		text_cell(&table, (*claim)->bench);
		text_cell(&table, (*claim)->rows);
		text_cell(&table, (*claim)->cannot);
	}
	ts_tables_close(tables);
	ts_report_table(report, &table);
	ts_report_line(report, "`bench TABLE` asks; reference/VERDICTS.md has the answers of the last runs.");
	return TS_OK;
}

static ts_status bench_list(const ts_job *job) { return ts_bench_with_report(job, report_claims, NULL); }

ts_status ts_tables_run(const ts_bench_row *row, const ts_job *job)
{
	ts_job own = *job;
	if (ts_bench_check(job, row->name) != TS_OK) return TS_ERROR;
	own.scene.options.camera = TS_CAMERA_CIRCLE;
	if (own.runs == 0) own.runs = row->runs != 0 ? row->runs : RUNS;
	if (row->speed != NULL) return ts_bench_speed(&own, row->speed);
	return row->paper != NULL ? ts_paper_bench(&own, row->paper) : row->run(&own);
}

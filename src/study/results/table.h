/* Figures as aligned text for people and as JSON for programs, from one description. */
#ifndef TS_STUDY_RESULTS_TABLE_H
#define TS_STUDY_RESULTS_TABLE_H
#include <jansson.h>
#include <stdio.h>
#include "output/file.h"
#include "study/asked/job.h"

enum { TS_MAX_COLUMNS = 16 };

typedef struct {
	const char *key;  /* in JSON */
	const char *head; /* in text */
	bool right;       /* figures are aligned to the right */
} ts_column;

typedef struct {
	char *text;
	json_t *value;
} ts_cell;

typedef struct {
	const char *key, *title; /* key: name of the array in JSON; title: line above the table, "" none */
	const ts_column *columns;
	u32 n_columns;
	ts_cell *cells;
	size_t n_cells, capacity;
	bool timed;  /* holds times or figures of the system, which differ between runs */
	bool silent; /* the report has the table in JSON and CSV only */
	u32 apart;   /* not 0: in text each cell is a line behind its head, wrapped to this width */
	bool failed; /* out of memory */
} ts_table;

/* `columns` is ended by a row without a key and outlives the table, as do key and title. */
ts_table ts_table_begin(const char *key, const char *title, const ts_column *columns);
/* Append the next cell, row by row. Texts are copied; control characters are not printed. */
void ts_table_text(ts_table *table, const char *text);
void ts_table_count(ts_table *table, i64 value);
void ts_table_bytes(ts_table *table, u64 bytes);
void ts_table_real(ts_table *table, double value, int decimals);
void ts_table_none(ts_table *table);
/* Appends a real; where the value is NaN, an empty cell. */
void ts_table_known(ts_table *table, double value, int decimals);
/* Keeps the rows whose first cell matches a pattern, as names of files do in a shell. Rows must be complete. */
void ts_table_keep(ts_table *table, const char *pattern);
/* Prints the last row, which must be complete, on standard error, as progress of long work. */
void ts_table_say(const ts_table *table);
/* Rows must be complete. Beyond 120 columns texts are wrapped within their columns. */
void ts_table_print(const ts_table *table, FILE *out);
/* An array of objects, one a row; a new reference, or NULL when out of memory. */
json_t *ts_table_json(const ts_table *table);
void ts_table_end(ts_table *table);

/* The output of a command, kept until it is printed: tables and single figures as text, or one JSON object. */
typedef struct {
	json_t *root;
	json_t *timed; /* keys of root whose values differ from run to run */
	ts_file_text text;
	bool json;   /* text is not printed */
	bool quiet;  /* text has failures alone */
	bool failed; /* out of memory */
} ts_report;

/* A report may not be moved. */
void ts_report_begin(ts_report *report, bool json);
/* Adds the table's content to the report, and releases the table. */
void ts_report_table(ts_report *report, ts_table *table);
/* Adds a line to the text only; control characters become '?'. */
void ts_report_line(ts_report *report, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* As ts_report_line, for a failure, which `quiet` does not suppress. */
void ts_report_failure(ts_report *report, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Adds a figure to the JSON object only; takes the value over. */
void ts_report_value(ts_report *report, const char *key, json_t *value);
/* As ts_report_value, for a time or a figure of the system. */
void ts_report_timed(ts_report *report, const char *key, json_t *value);
/* Whether ts_report_timed added the key. */
bool ts_report_is_timed(const ts_report *report, const char *key);
/* Adds program, version, backend, threads and parameters to the JSON object (run_report.c). */
void ts_report_run(ts_report *report, const ts_job *job);
/* Fails if the report is incomplete. */
ts_status ts_report_check(ts_report *report);
/* Prints the text so far, which is not printed again later. */
ts_status ts_report_print(ts_report *report);
/* Prints the rest of the text, or the JSON object if report->json, and releases the report, also on failure. */
ts_status ts_report_end(ts_report *report);
/* Writes a JSON object in the format of reports. Only memory can run out here, which the end of a ts_file_text
 * finds. */
void ts_report_write(const json_t *root, FILE *out);
/* Releases the report and prints nothing. */
void ts_report_discard(ts_report *report);

#endif

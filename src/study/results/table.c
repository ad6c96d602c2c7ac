/* Tables as text and as JSON. */
#include "study/results/table.h"
#include <fnmatch.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include "output/file.h"
#include "output/json/text.h"

enum { LINE_WIDTH = 120, NARROW = 20, NARROWEST = 12, NARROW_FIGURE = 10, GAP = 2 };

ts_table ts_table_begin(const char *key, const char *title, const ts_column *columns)
{
	ts_table table = {.key = key, .title = title, .columns = columns};
	while (columns[table.n_columns].key != NULL) table.n_columns++;
	return table;
}

static void append(ts_table *table, const char *text, json_t *value)
{
	char *copy = strdup(text);
	void *cells = table->cells;
	if (copy == NULL || value == NULL ||
	    ts_grow(&cells, &table->capacity, table->n_cells + 1, sizeof *table->cells, "a table") != TS_OK) {
		free(copy);
		json_decref(value);
		table->failed = true;
		return;
	}
	ts_line_clean(copy);
	table->cells = cells;
	table->cells[table->n_cells++] = (ts_cell){copy, value};
}

void ts_table_text(ts_table *table, const char *text) { append(table, text, ts_text_json(text)); }

/* 1234567 as 1,234,567. */
void ts_table_count(ts_table *table, i64 value)
{
	char digits[32], text[48];
	snprintf(digits, sizeof digits, "%lld", (long long)value);
	size_t n = strlen(digits), k = 0;
	for (size_t i = 0; i < n; i++) {
		text[k++] = digits[i];
		if (digits[i] != '-' && i + 1 < n && (n - i - 1) % 3 == 0) text[k++] = ',';
	}
	text[k] = 0;
	append(table, text, json_integer(value));
}

void ts_table_bytes(ts_table *table, u64 bytes)
{
	static const char *const units[] = {"B", "kB", "MB", "GB", "TB"};
	char text[48];
	double value = (double)bytes;
	u32 unit = 0;
	for (; value >= 999.995 && unit < 4; unit++) value /= 1000;
	snprintf(text, sizeof text, unit == 0 ? "%.0f %s" : "%.2f %s", value, units[unit]);
	append(table, text, json_integer((json_int_t)bytes));
}

void ts_table_real(ts_table *table, double value, int decimals)
{
	char text[64];
	snprintf(text, sizeof text, fabs(value) < 1e15 ? "%.*f" : "%.*g", decimals, value);
	append(table, isinf(value) ? "equal" : text, isfinite(value) ? json_real(value) : json_null());
}

void ts_table_none(ts_table *table) { append(table, "-", json_null()); }

void ts_table_known(ts_table *table, double value, int decimals)
{
	if (isnan(value)) {
		ts_table_none(table);
	} else {
		ts_table_real(table, value, decimals);
	}
}

void ts_table_keep(ts_table *table, const char *pattern)
{
	size_t n = 0;
	for (size_t row = 0; row < table->n_cells; row += table->n_columns) {
		bool kept = fnmatch(pattern, table->cells[row].text, 0) == 0;
		for (u32 c = 0; c < table->n_columns; c++) {
			ts_cell cell = table->cells[row + c];
			if (kept) {
				table->cells[n++] = cell;
			} else {
				free(cell.text);
				json_decref(cell.value);
			}
		}
	}
	table->n_cells = n;
}

/* Bytes of the first line of `text`: as many words as fit in `width`, at least one. A word ends before a blank, or
 * after a bar or an asterisk. */
static size_t line_bytes(const char *text, size_t width)
{
	size_t bytes = 0, n = strlen(text);
	for (size_t i = 1; i <= n && (i <= width || bytes == 0); i++) {
		if (i == n || text[i] == ' ' || text[i - 1] == '|' || text[i - 1] == '*') bytes = i;
	}
	return bytes;
}

static const char *next_line(const char *text, size_t width)
{
	text += line_bytes(text, width);
	return text + strspn(text, " ");
}

/* Bytes of the longest line of a text wrapped to `most` where words allow. */
static size_t text_width(const char *text, size_t most)
{
	size_t widest = 0;
	for (; *text != 0; text = next_line(text, most)) {
		size_t bytes = line_bytes(text, most);
		widest = bytes > widest ? bytes : widest;
	}
	return widest;
}

/* The same for a column, with its head. */
static size_t column_width(const ts_table *table, u32 column, size_t most)
{
	size_t widest = text_width(table->columns[column].head, most);
	for (size_t i = column; i < table->n_cells; i += table->n_columns) {
		size_t bytes = text_width(table->cells[i].text, most);
		widest = bytes > widest ? bytes : widest;
	}
	return widest;
}

/* Sets the widths of columns whose text or figures are wrapped to these widths where words allow. Returns the
 * table's. */
static size_t wrap_columns(const ts_table *table, size_t text, size_t figures, size_t *width)
{
	size_t whole = 0;
	for (u32 c = 0; c < table->n_columns; c++) {
		width[c] = column_width(table, c, table->columns[c].right ? figures : text);
		whole += width[c] + (c > 0 ? GAP : 0);
	}
	return whole;
}

/* If a table is too wide its text is wrapped, narrower where long words require it; text of the last column takes the
 * remaining width. */
static void choose_widths(const ts_table *table, size_t *width)
{
	size_t whole = wrap_columns(table, SIZE_MAX, SIZE_MAX, width);
	if (whole <= LINE_WIDTH) return;
	for (size_t text = NARROW; whole > LINE_WIDTH && text >= NARROWEST; text--)
		whole = wrap_columns(table, text, NARROW_FIGURE, width);
	u32 last = table->n_columns - 1;
	if (!table->columns[last].right && whole < LINE_WIDTH) width[last] += LINE_WIDTH - whole;
}

/* Prints a row of cells, on as many lines as they need. */
static void print_row(const ts_table *table, FILE *out, const size_t *width, const char **rest)
{
	for (bool more = true; more;) {
		size_t at = 0, column = 0;
		more = false;
		for (u32 c = 0; c < table->n_columns; c++) {
			size_t bytes = line_bytes(rest[c], width[c]);
			size_t from = table->columns[c].right ? column + width[c] - bytes : column;
			if (bytes > 0) {
				fprintf(out, "%*s%.*s", (int)(from - at), "", (int)bytes, rest[c]);
				at = from + bytes;
			}
			rest[c] = next_line(rest[c], width[c]);
			more |= *rest[c] != 0;
			column += width[c] + GAP;
		}
		fputc('\n', out);
	}
}

void ts_table_say(const ts_table *table)
{
	char text[512];
	size_t n = 0;
	for (u32 c = 0; c < table->n_columns && n < sizeof text && !table->failed; c++) {
		const ts_cell *cell = &table->cells[table->n_cells - table->n_columns + c];
		n += (size_t)snprintf(text + n, sizeof text - n, "%s%s %s", c > 0 ? ", " : "", table->columns[c].key,
		                      cell->text);
	}
	ts_say("%s", text);
}

static void print_apart(const ts_table *table, FILE *out)
{
	int head = 0;
	for (u32 c = 0; c < table->n_columns; c++) {
		int bytes = (int)strlen(table->columns[c].head);
		head = bytes > head ? bytes : head;
	}
	size_t room = table->apart > (u32)head + GAP ? table->apart - (u32)head - GAP : 1;
	for (size_t i = 0; i < table->n_cells; i++) {
		const char *left = table->columns[i % table->n_columns].head;
		if (i > 0 && i % table->n_columns == 0) fputc('\n', out);
		for (const char *rest = table->cells[i].text; *rest != 0; rest = next_line(rest, room), left = "") {
			fprintf(out, "%-*s%.*s\n", head + GAP, left, (int)line_bytes(rest, room), rest);
		}
	}
}

void ts_table_print(const ts_table *table, FILE *out)
{
	if (table->apart > 0) {
		print_apart(table, out);
		return;
	}
	size_t width[TS_MAX_COLUMNS];
	const char *rest[TS_MAX_COLUMNS];
	u32 n = table->n_columns;
	choose_widths(table, width);
	if (table->title[0] != 0) fprintf(out, "\n%s\n", table->title);
	for (u32 c = 0; c < n; c++) rest[c] = table->columns[c].head;
	print_row(table, out, width, rest);
	for (size_t i = 0; i < table->n_cells; i += n) {
		for (u32 c = 0; c < n; c++) rest[c] = table->cells[i + c].text;
		print_row(table, out, width, rest);
	}
}

json_t *ts_table_json(const ts_table *table)
{
	json_t *rows = json_array();
	json_t *row = NULL;
	int failed = 0;
	for (size_t i = 0; i < table->n_cells && rows != NULL; i++) {
		u32 c = (u32)(i % table->n_columns);
		if (c == 0) {
			row = json_object();
			failed |= json_array_append_new(rows, row);
		}
		if (failed == 0) failed |= json_object_set(row, table->columns[c].key, table->cells[i].value);
	}
	return ts_json_made(rows, failed);
}

void ts_table_end(ts_table *table)
{
	for (size_t i = 0; i < table->n_cells; i++) {
		free(table->cells[i].text);
		json_decref(table->cells[i].value);
	}
	free(table->cells);
	table->cells = NULL;
	table->n_cells = 0;
}

void ts_report_begin(ts_report *report, bool json)
{
	*report = (ts_report){.root = json_object(), .timed = json_object(), .json = json};
	report->failed = ts_file_text_begin(&report->text, "the report") != TS_OK;
	report->failed |= report->root == NULL || report->timed == NULL;
}

void ts_report_table(ts_report *report, ts_table *table)
{
	report->failed |= table->failed;
	if (!report->json && !report->quiet && !table->silent && !report->failed) ts_table_print(table, report->text.out);
	(table->timed ? ts_report_timed : ts_report_value)(report, table->key, ts_table_json(table));
	ts_table_end(table);
}

static void add_line(ts_report *report, const char *format, va_list arguments)
{
	ts_file_text line;
	if (report->json || report->failed) return;
	report->failed = ts_file_text_begin(&line, "a line") != TS_OK;
	if (report->failed) return;
	report->failed = vfprintf(line.out, format, arguments) < 0;
	report->failed |= ts_file_text_close(&line, "a line") != TS_OK;
	if (!report->failed) {
		ts_line_clean(line.text);
		fprintf(report->text.out, "%s\n", line.text);
	}
	free(line.text);
}

void ts_report_line(ts_report *report, const char *format, ...)
{
	va_list arguments;
	va_start(arguments, format);
	if (!report->quiet) add_line(report, format, arguments);
	va_end(arguments);
}

void ts_report_failure(ts_report *report, const char *format, ...)
{
	va_list arguments;
	va_start(arguments, format);
	add_line(report, format, arguments);
	va_end(arguments);
}

void ts_report_value(ts_report *report, const char *key, json_t *value)
{
	if (json_object_set_new(report->root, key, value) != 0) report->failed = true;
}

void ts_report_timed(ts_report *report, const char *key, json_t *value)
{
	ts_report_value(report, key, value);
	if (json_object_set_new(report->timed, key, json_true()) != 0) report->failed = true;
}

bool ts_report_is_timed(const ts_report *report, const char *key)
{
	return json_object_get(report->timed, key) != NULL;
}

ts_status ts_report_check(ts_report *report)
{
	if (report->failed) return ts_fail("the report: out of memory");
	return ts_file_text_flush(&report->text, "the report");
}

ts_status ts_report_print(ts_report *report)
{
	ts_status status = ts_report_check(report);
	if (status != TS_OK) return status;
	status = ts_file_print(report->text.text, report->text.bytes);
	report->text.bytes = 0;
	return status;
}

void ts_report_write(const json_t *root, FILE *out)
{
	json_dumpf(root, out, JSON_INDENT(2) | JSON_REAL_PRECISION(9));
	fputc('\n', out);
}

static ts_status print_json(ts_report *report)
{
	ts_file_text text;
	if (ts_report_check(report) != TS_OK || ts_file_text_begin(&text, "the report") != TS_OK) return TS_ERROR;
	ts_report_write(report->root, text.out);
	return ts_file_text_print(&text);
}

void ts_report_discard(ts_report *report)
{
	if (report->text.out != NULL) ts_file_text_drop(&report->text);
	json_decref(report->root);
	json_decref(report->timed);
	memset(report, 0, sizeof *report);
}

ts_status ts_report_end(ts_report *report)
{
	ts_status status = report->json ? print_json(report) : ts_report_print(report);
	ts_report_discard(report);
	return status;
}

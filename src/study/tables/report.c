/* The report of a paper's table: its parts, ours above the paper's, and whether the paper's claims hold here. */
#include <math.h>
#include <string.h>
#include "output/json/text.h"
#include "study/busy.h"
#include "study/tables/paper.h"

typedef struct {
	ts_table table;
	ts_column columns[TS_MAX_COLUMNS + 1];
} sheet;

static void add_column(sheet *s, u32 *n, const char *key, const char *head, bool right)
{
	s->columns[(*n)++] = (ts_column){key, head, right};
}

static void head_columns(sheet *s, u32 *n, const ts_paper_table *table)
{
	add_column(s, n, "scene", "scene", false);
	if (table->objects_head != NULL) add_column(s, n, table->objects_head, table->objects_head, true);
}

static void head_cells(ts_table *t, const ts_paper_table *table, const char *scene, u32 objects)
{
	ts_table_text(t, scene);
	if (table->objects_head != NULL) ts_table_count(t, objects);
}

static void add_row(ts_table *t, const ts_paper_table *table, const ts_paper_part *part, const ts_paper_line *line,
                    bool paper)
{
	head_cells(t, table, paper ? line->row->name : line->scene, paper ? line->row->objects : line->objects);
	ts_table_text(t, paper ? "paper" : "here");
	for (const u8 *f = part->figures; *f != TS_NO_FIGURE; f++) {
		ts_bench_cell(t, &table->figures[*f], (paper ? line->paper : line->here)[*f]);
	}
}

static void report_part(ts_report *report, const ts_paper_table *table, const ts_paper_part *part,
                        const ts_paper_line *lines, u32 n)
{
	sheet s = {.columns = {{0}}};
	u32 k = 0;
	head_columns(&s, &k, table);
	add_column(&s, &k, "source", "", false);
	for (const u8 *f = part->figures; *f != TS_NO_FIGURE; f++) {
		add_column(&s, &k, table->figures[*f].key, table->figures[*f].head, true);
	}
	s.table = ts_table_begin(part->key, part->title, s.columns);
	for (const u8 *f = part->figures; *f != TS_NO_FIGURE; f++) s.table.timed |= table->figures[*f].timed;
	for (u32 i = 0; i < n; i++) {
		add_row(&s.table, table, part, &lines[i], false);
		if (lines[i].row != NULL) add_row(&s.table, table, part, &lines[i], true);
	}
	ts_report_table(report, &s.table);
}

/* Reports that a time is not judged because other processes kept the machine busy. */
static bool is_busy(ts_table *t, const ts_paper_table *table, const ts_paper_relation *r, const ts_paper_line *lines,
                    u32 n)
{
	double most = 0;
	char text[128];
	for (u32 i = 0; i < n; i++) most = fmax(most, lines[i].others);
	if (!table->figures[r->figure].timed || !(most > ts_busy_limit())) return false;
	snprintf(text, sizeof text, "not judged: others used %.2f processors, %.2f are allowed", most, ts_busy_limit());
	ts_table_text(t, text);
	return true;
}

static bool holds(const ts_paper_relation *r, const ts_paper_line *line)
{
	double value = line->here[r->figure];
	if (r->kind == TS_OF_PAPER) value /= line->paper[r->figure];
	return (r->kind == TS_AT_LEAST || value <= r->high) && (r->kind == TS_AT_MOST || value >= r->low);
}

static bool is_judged(const ts_paper_relation *r, const ts_paper_line *line)
{
	double given = r->given != TS_NO_FIGURE ? line->here[r->given] : 0;
	if (r->kind == TS_OF_PAPER && isnan(line->paper[r->figure])) return false;
	return !isnan(line->here[r->figure]) && (r->given == TS_NO_FIGURE || (given >= r->least && given <= r->most));
}

/* A number with a point, whatever the host's locale. */
static const char *number(char text[32], int digits, double value)
{
	snprintf(text, 32, "%.*g", digits, value);
	char *comma = strchr(text, ',');
	if (comma != NULL) *comma = '.';
	return text;
}

static void bound_text(char *text, size_t bytes, const ts_paper_relation *r)
{
	char low[32], high[32];
	number(low, 6, r->low);
	number(high, 6, r->high);
	switch (r->kind) {
	case TS_AT_MOST:
	case TS_STEADY: snprintf(text, bytes, "at most %s", high); break;
	case TS_AT_LEAST:
	case TS_GROWS: snprintf(text, bytes, "at least %s", low); break;
	case TS_OF_PAPER: snprintf(text, bytes, "%s to %s of the paper's", low, high); break;
	default: snprintf(text, bytes, "%s to %s", low, high); break;
	}
}

static void verdict(ts_table *t, const ts_paper_table *table, const ts_paper_relation *r, const ts_paper_line *line)
{
	char text[TS_PAPER_REASON + TS_PAPER_HEAD + 128], value[32];
	const char *scale = table->figures[r->cause].head, *colon = r->because[0] != 0 ? ": " : "";
	if (is_busy(t, table, r, line, 1)) return;
	if (holds(r, line)) {
		ts_table_text(t, "holds");
		return;
	}
	int n = snprintf(text, sizeof text, "differs%s%s (%s %s here", colon, r->because, scale,
	                 number(value, 4, line->here[r->cause]));
	if (line->row != NULL && !isnan(line->paper[r->cause])) {
		n += snprintf(text + n, sizeof text - (size_t)n, ", %s in the paper", number(value, 4, line->paper[r->cause]));
	}
	snprintf(text + n, sizeof text - (size_t)n, ")");
	ts_table_text(t, text);
}

static void relation_rows(ts_table *t, const ts_paper_table *table, const ts_paper_relation *r,
                          const ts_paper_line *lines, u32 n)
{
	char bound[64];
	bound_text(bound, sizeof bound, r);
	for (u32 i = 0; i < n; i++) {
		if (!is_judged(r, &lines[i])) continue;
		ts_table_text(t, r->text);
		head_cells(t, table, lines[i].scene, lines[i].objects);
		ts_table_text(t, bound);
		ts_bench_cell(t, &table->figures[r->figure], lines[i].here[r->figure]);
		ts_bench_cell(t, &table->figures[r->figure], lines[i].paper[r->figure]);
		verdict(t, table, r, &lines[i]);
	}
}

/* The verdict on several rows. */
static void verdict_of_rows(ts_table *t, const ts_paper_table *table, const ts_paper_relation *r,
                            const ts_paper_line *lines, u32 n, bool right)
{
	char text[TS_PAPER_REASON + 16];
	const char *colon = r->because[0] != 0 ? ": " : "";
	if (is_busy(t, table, r, lines, n)) return;
	snprintf(text, sizeof text, right ? "holds" : "differs%s%s", colon, r->because);
	ts_table_text(t, text);
}

/* Counts pairs of rows in which both figures differ, and those in which both rise. */
static void rising_row(ts_table *t, const ts_paper_table *table, const ts_paper_relation *r, const ts_paper_line *lines,
                       u32 n)
{
	u32 other = (u32)r->low, pairs = 0, rise = 0;
	char text[64];
	for (u32 i = 0; i < n; i++) {
		for (u32 j = 0; j < i; j++) {
			double both =
				(lines[i].here[r->figure] - lines[j].here[r->figure]) * (lines[i].here[other] - lines[j].here[other]);
			pairs += both > 0 || both < 0;
			rise += r->falls ? both < 0 : both > 0;
		}
	}
	if (pairs == 0) return;
	ts_table_text(t, r->text);
	head_cells(t, table, "all", 0);
	ts_table_text(t, "9 pairs in 10");
	snprintf(text, sizeof text, "%u of %u", (unsigned)rise, (unsigned)pairs);
	ts_table_text(t, text);
	ts_table_none(t);
	verdict_of_rows(t, table, r, lines, n, 10 * rise >= 9 * pairs);
}

/* Over the rows of a scene: the least ratio to the row before, or the ratio of the greatest to the least. */
static double change(const ts_paper_relation *r, const ts_paper_line *lines, u32 n, bool paper)
{
	double least = INFINITY, most = 0, step = INFINITY, before = NAN;
	for (u32 i = 0; i < n; i++) {
		double value = (paper ? lines[i].paper : lines[i].here)[r->figure];
		if (isnan(value)) return NAN;
		least = fmin(least, value);
		most = fmax(most, value);
		step = fmin(step, value / before);
		before = value;
	}
	return r->kind == TS_GROWS ? step : most / least;
}

static void change_row(ts_table *t, const ts_paper_table *table, const ts_paper_relation *r, const ts_paper_line *lines,
                       u32 n)
{
	char bound[64];
	double here = change(r, lines, n, false), paper = change(r, lines, n, true);
	if (n < 2 || isnan(here)) return;
	bound_text(bound, sizeof bound, r);
	ts_table_text(t, r->text);
	head_cells(t, table, lines[0].scene, 0);
	ts_table_text(t, bound);
	ts_table_real(t, here, 3);
	if (isnan(paper)) {
		ts_table_none(t);
	} else {
		ts_table_real(t, paper, 3);
	}
	verdict_of_rows(t, table, r, lines, n, r->kind == TS_GROWS ? here >= r->low : here <= r->high);
}

static void change_rows(ts_table *t, const ts_paper_table *table, const ts_paper_relation *r,
                        const ts_paper_line *lines, u32 n)
{
	for (u32 i = 0, end; i < n; i = end) {
		for (end = i; end < n && lines[end].of_scene == lines[i].of_scene; end++) continue;
		change_row(t, table, r, lines + i, end - i);
	}
}

typedef void rows_of(ts_table *t, const ts_paper_table *table, const ts_paper_relation *r, const ts_paper_line *lines,
                     u32 n);
static rows_of *const rows_of_kind[] = {
	[TS_AT_MOST] = relation_rows,  [TS_AT_LEAST] = relation_rows, [TS_BETWEEN] = relation_rows,
	[TS_OF_PAPER] = relation_rows, [TS_RISES_WITH] = rising_row,  [TS_GROWS] = change_rows,
	[TS_STEADY] = change_rows,
};

static void report_relations(ts_report *report, const ts_paper_table *table, const ts_paper_line *lines, u32 n)
{
	sheet s = {.columns = {{0}}};
	u32 k = 0;
	add_column(&s, &k, "relation", "relation", false);
	head_columns(&s, &k, table);
	add_column(&s, &k, "bound", "must be", false);
	add_column(&s, &k, "here", "here", true);
	add_column(&s, &k, "paper", "paper", true);
	add_column(&s, &k, "verdict", "verdict", false);
	s.table = ts_table_begin("relations", "What the paper claims", s.columns);
	json_t *timed = json_array();
	for (const ts_paper_relation *r = table->relations; r->text != NULL; r++) {
		rows_of_kind[r->kind](&s.table, table, r, lines, n);
		if (!table->figures[r->figure].timed && !table->figures[r->cause].timed) continue;
		json_array_append_new(timed, ts_text_json(r->text));
		s.table.timed = true;
	}
	ts_report_value(report, "timed_relations", timed);
	if (s.table.n_cells == 0) return;
	ts_report_table(report, &s.table);
}

void ts_paper_report(ts_report *report, const ts_paper_table *table, const ts_paper_line *lines, u32 n)
{
	for (const ts_paper_part *part = table->parts; part->key != NULL; part++)
		report_part(report, table, part, lines, n);
	if (table->relations != NULL) report_relations(report, table, lines, n);
}

static void report_spreads(ts_report *report, const ts_paper_table *table, const ts_paper_line *lines, u32 n,
                           bool timed)
{
	static const ts_column columns[] = {{"figure", "figure", false}, TS_SPREAD_COLUMNS};
	sheet s = {.columns = {{0}}};
	u32 k = 0;
	head_columns(&s, &k, table);
	memcpy(s.columns + k, columns, sizeof columns);
	s.table = ts_table_begin(timed ? "milliseconds_over_frames" : "over_frames", "", s.columns);
	s.table.timed = timed;
	s.table.silent = true;
	for (u32 i = 0; i < n; i++) {
		for (u32 f = 0; table->figures[f].key != NULL; f++) {
			const ts_frame_spread *spread = &lines[i].over[f];
			if (table->figures[f].timed != timed || spread->n == 0) continue;
			head_cells(&s.table, table, lines[i].scene, lines[i].objects);
			ts_table_text(&s.table, table->figures[f].key);
			ts_frame_spread_cells(&s.table, spread, lines[i].here[f], 3);
		}
	}
	ts_report_table(report, &s.table);
}

void ts_paper_report_frames(ts_report *report, const ts_paper_table *table, const ts_paper_line *lines, u32 n)
{
	report_spreads(report, table, lines, n, false);
	report_spreads(report, table, lines, n, true);
}

/* Cases and how they ended. */
#include "cli/reports/outcomes.h"
#include <stdarg.h>
#include <string.h>
#include "output/json/text.h"

enum { WHY = 2048, LINE = 2 * WHY };

static const char *const words[TS_N_OUTCOMES] = {
	[TS_PASSED] = "passed", [TS_LEFT_OUT] = "skipped", [TS_KNOWN] = "known",
	[TS_FAILED] = "failed", [TS_BROKEN] = "error",
};

static const char *text_of(const json_t *row, const char *key) { return json_string_value(json_object_get(row, key)); }

/* TS_N_OUTCOMES: no outcome has that name. */
static ts_outcome outcome_of(const json_t *row)
{
	const char *word = text_of(row, "outcome");
	u32 outcome = 0;
	while (outcome < TS_N_OUTCOMES && (word == NULL || strcmp(word, words[outcome]) != 0)) outcome++;
	return (ts_outcome)outcome;
}

ts_status ts_outcomes_begin(ts_outcomes *o, const char *key, const char *class_name)
{
	*o = (ts_outcomes){.key = key, .class_name = class_name, .rows = json_array(), .seconds = json_array()};
	o->failed = o->rows == NULL || o->seconds == NULL;
	return ts_outcomes_check(o);
}

ts_status ts_outcomes_read(ts_outcomes *o, const char *key, const char *class_name, json_t *rows, json_t *seconds)
{
	size_t i, k;
	json_t *row, *line;
	*o =
		(ts_outcomes){.key = key, .class_name = class_name, .rows = json_incref(rows), .seconds = json_incref(seconds)};
	bool good = json_is_array(rows) && json_array_size(seconds) == json_array_size(rows);
	json_array_foreach (rows, i, row) {
		good &= text_of(row, key) != NULL && text_of(row, "verdict") != NULL && text_of(row, "why") != NULL;
		good &= outcome_of(row) != TS_N_OUTCOMES && json_is_array(json_object_get(row, "lines"));
		json_array_foreach (json_object_get(row, "lines"), k, line) good &= json_is_string(line);
	}
	return good ? TS_OK : ts_fail("its cases are not as touchstone writes them");
}

void ts_outcomes_add(ts_outcomes *o, const char *name, const char *verdict, ts_outcome outcome, const char *why,
                     double seconds)
{
	json_t *row = json_pack("{s:o, s:s, s:s, s:o, s:[]}", o->key, ts_text_json(name), "verdict", verdict, "outcome",
	                        words[outcome], "why", ts_text_json(why), "lines");
	o->failed |= json_array_append_new(o->rows, row) != 0;
	o->failed |= json_array_append_new(o->seconds, json_real(seconds)) != 0;
}

static json_t *last(const ts_outcomes *o) { return json_array_get(o->rows, json_array_size(o->rows) - 1); }

void ts_outcomes_line(ts_outcomes *o, const char *line)
{
	o->failed |= json_array_append_new(json_object_get(last(o), "lines"), ts_text_json(line)) != 0;
}

void ts_outcomes_value(ts_outcomes *o, const char *key, json_t *value)
{
	o->failed |= json_object_set_new(last(o), key, value) != 0;
}

u32 ts_outcomes_count(const ts_outcomes *o, ts_outcome outcome)
{
	size_t i;
	json_t *row;
	u32 n = 0;
	json_array_foreach (o->rows, i, row) n += outcome_of(row) == outcome;
	return n;
}

ts_status ts_outcomes_check(const ts_outcomes *o) { return o->failed ? ts_fail("the cases: out of memory") : TS_OK; }

void ts_outcomes_end(ts_outcomes *o)
{
	json_decref(o->rows);
	json_decref(o->seconds);
	*o = (ts_outcomes){.rows = NULL};
}

/* "known: reason", "missing". */
static void say_why(char *text, size_t bytes, const json_t *row)
{
	const char *why = text_of(row, "why");
	snprintf(text, bytes, "%s%s%s", text_of(row, "verdict"), why[0] != 0 ? ": " : "", why);
}

void ts_outcomes_lines(ts_report *report, const ts_outcomes *o)
{
	size_t i, k;
	json_t *row, *line;
	json_array_foreach (o->rows, i, row) {
		void (*put)(ts_report *, const char *, ...) = outcome_of(row) >= TS_FAILED ? ts_report_failure : ts_report_line;
		const json_t *lines = json_object_get(row, "lines");
		const char *why = text_of(row, "why"), *first = json_string_value(json_array_get(lines, 0));
		put(report, "%-10s %s%s%s%s%s", text_of(row, "verdict"), text_of(row, o->key), why[0] != 0 ? "  " : "", why,
		    first != NULL ? "  " : "", first != NULL ? first : "");
		json_array_foreach (lines, k, line) {
			if (k > 0) put(report, "%12s%s", "", json_string_value(line));
		}
	}
}

/* Prints one line, whatever the texts hold. */
__attribute__((format(printf, 2, 3))) static void put_line(FILE *out, const char *format, ...)
{
	char line[LINE];
	va_list arguments;
	va_start(arguments, format);
	vsnprintf(line, sizeof line, format, arguments);
	va_end(arguments);
	ts_line_clean(line);
	fprintf(out, "%s\n", line);
}

void ts_outcomes_tap(const ts_outcomes *o, const char *relaxed, FILE *out)
{
	size_t i, k;
	json_t *row, *line;
	if (relaxed[0] != 0) put_line(out, "# relaxed: %s", relaxed);
	json_array_foreach (o->rows, i, row) {
		char why[WHY] = "";
		ts_outcome outcome = outcome_of(row);
		const char *mark = outcome == TS_LEFT_OUT ? " # SKIP "
		                   : outcome == TS_KNOWN  ? " # TO"
		                                            "DO "
		                                          : "";
		if (mark[0] != 0) say_why(why, sizeof why, row);
		put_line(out, "%sok %u - %s%s%s", outcome < TS_KNOWN ? "" : "not ", (unsigned)i + 1, text_of(row, o->key), mark,
		         why);
		json_array_foreach (json_object_get(row, "lines"), k, line) put_line(out, "# %s", json_string_value(line));
	}
	fprintf(out, "1..%u\n", (unsigned)json_array_size(o->rows));
}

static void put_end(ts_junit *junit, const json_t *row)
{
	static const ts_junit_outcome ends[TS_N_OUTCOMES] = {
		[TS_LEFT_OUT] = TS_JUNIT_SKIPPED,
		[TS_KNOWN] = TS_JUNIT_SKIPPED,
		[TS_FAILED] = TS_JUNIT_FAILURE,
		[TS_BROKEN] = TS_JUNIT_ERROR,
	};
	char why[WHY];
	size_t k;
	json_t *line;
	ts_outcome outcome = outcome_of(row);
	const char *type = outcome >= TS_FAILED ? text_of(row, "verdict") : NULL;
	say_why(why, sizeof why, row);
	if (outcome == TS_LEFT_OUT || outcome == TS_KNOWN) ts_junit_say(junit, ends[outcome], NULL, why);
	json_array_foreach (json_object_get(row, "lines"), k, line) {
		if (outcome != TS_PASSED) ts_junit_say(junit, ends[outcome], type, json_string_value(line));
	}
}

void ts_outcomes_junit(const ts_outcomes *o, ts_junit *junit)
{
	size_t i;
	json_t *row;
	json_array_foreach (o->rows, i, row) {
		ts_junit_case(junit, o->class_name, text_of(row, o->key), json_number_value(json_array_get(o->seconds, i)));
		put_end(junit, row);
		ts_junit_case_end(junit);
	}
}

/* Escapes text, so that it stays in its cell and is no markup. */
static void put_marked(FILE *out, const char *before, const char *text, const char *behind)
{
	fputs(before, out);
	for (; *text != 0; text++) {
		unsigned char c = (unsigned char)*text;
		if (strchr("\\`*_[]<>|&~#", c) != NULL) fputc('\\', out);
		fputc(c < 0x20 || c == 0x7f ? '?' : c, out);
	}
	fputs(behind, out);
}

void ts_outcomes_markdown(const ts_outcomes *o, const char *command, const char *relaxed, FILE *out)
{
	size_t i;
	json_t *row;
	bool head = false;
	const u32 n[] = {ts_outcomes_count(o, TS_PASSED), ts_outcomes_count(o, TS_KNOWN),
	                 ts_outcomes_count(o, TS_LEFT_OUT)};
	const u32 failed = (u32)json_array_size(o->rows) - n[0] - n[1] - n[2];
	fprintf(out, "### touchstone %s\n\n%u passed, %u failed, %u known, %u skipped\n", command, (unsigned)n[0],
	        (unsigned)failed, (unsigned)n[1], (unsigned)n[2]);
	if (relaxed[0] != 0) put_marked(out, "\nRelaxed: ", relaxed, "\n");
	json_array_foreach (o->rows, i, row) {
		const char *line = json_string_value(json_array_get(json_object_get(row, "lines"), 0));
		char why[WHY];
		if (outcome_of(row) == TS_PASSED) continue;
		if (!head) fprintf(out, "\n| %s | verdict | |\n| --- | --- | --- |\n", o->key);
		head = true;
		say_why(why, sizeof why, row);
		put_marked(out, "| ", text_of(row, o->key), " | ");
		put_marked(out, "", why, " | ");
		put_marked(out, "", line != NULL ? line : "", " |\n");
	}
}

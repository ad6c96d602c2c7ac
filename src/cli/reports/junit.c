/* JUnit XML: the cases first, then the suite, which counts them, around them. */
#include "cli/reports/junit.h"
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>
#include "output/json/text.h"

static const char *const elements[] = {
	[TS_JUNIT_SKIPPED] = "skipped",
	[TS_JUNIT_FAILURE] = "failure",
	[TS_JUNIT_ERROR] = "error",
};

/* U+FFFE and U+FFFF, which are UTF-8 but no characters of XML. */
static bool is_no_character(const char *c)
{
	return strncmp(c, "\xef\xbf\xbe", 3) == 0 || strncmp(c, "\xef\xbf\xbf", 3) == 0;
}

static void put_character(const char *c, FILE *out)
{
	switch (*c) {
	case '&': fputs("&amp;", out); break;
	case '<': fputs("&lt;", out); break;
	case '>': fputs("&gt;", out); break;
	case '"': fputs("&quot;", out); break;
	default: fputc((unsigned char)*c < 0x20 || *c == 0x7f ? '?' : *c, out);
	}
}

static void put(ts_junit *j, const char *text, FILE *out)
{
	json_t *valid = ts_text_json(text);
	j->failed |= valid == NULL;
	for (const char *c = valid != NULL ? json_string_value(valid) : ""; *c != 0; c++) {
		bool none = is_no_character(c);
		put_character(none ? "?" : c, out);
		if (none) c += 2;
	}
	json_decref(valid);
}

static void put_attribute(ts_junit *j, const char *name, const char *value, FILE *out)
{
	fprintf(out, " %s=\"", name);
	put(j, value, out);
	fputs("\"", out);
}

ts_status ts_junit_begin(ts_junit *j, const char *path, const char *suite)
{
	*j = (ts_junit){.path = path, .suite = suite};
	return ts_file_text_begin(&j->cases, path);
}

void ts_junit_case(ts_junit *j, const char *classname, const char *name, double seconds)
{
	j->outcome = TS_JUNIT_PASSED;
	fputs("  <testcase", j->cases.out);
	put_attribute(j, "classname", classname, j->cases.out);
	put_attribute(j, "name", name, j->cases.out);
	fprintf(j->cases.out, " time=\"%.6f\">", seconds);
}

void ts_junit_say(ts_junit *j, ts_junit_outcome outcome, const char *type, const char *line)
{
	FILE *out = j->cases.out;
	if (j->outcome != TS_JUNIT_PASSED) {
		fputs("\n", out);
	} else {
		j->outcome = outcome;
		fprintf(out, "<%s", elements[outcome]);
		put_attribute(j, "message", line, out);
		if (type != NULL) put_attribute(j, "type", type, out);
		fputs(">", out);
	}
	put(j, line, out);
}

void ts_junit_case_end(ts_junit *j)
{
	if (j->outcome != TS_JUNIT_PASSED) fprintf(j->cases.out, "</%s>", elements[j->outcome]);
	fputs("</testcase>\n", j->cases.out);
	j->n[j->outcome]++;
}

static void put_suite(ts_junit *j, const char *relaxations, double seconds, FILE *out)
{
	char host[256] = "", when[32] = "";
	time_t began = time(NULL) - (time_t)seconds;
	struct tm utc;
	u32 tests = 0;
	for (u32 i = 0; i < TS_N_JUNIT_OUTCOMES; i++) tests += j->n[i];
	if (gethostname(host, sizeof host - 1) != 0 || host[0] == 0) strcpy(host, "localhost");
	if (gmtime_r(&began, &utc) != NULL) strftime(when, sizeof when, "%Y-%m-%dT%H:%M:%S", &utc);
	fputs("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite", out);
	put_attribute(j, "name", j->suite, out);
	fprintf(out, " tests=\"%u\" failures=\"%u\" errors=\"%u\" skipped=\"%u\"", (unsigned)tests,
	        (unsigned)j->n[TS_JUNIT_FAILURE], (unsigned)j->n[TS_JUNIT_ERROR], (unsigned)j->n[TS_JUNIT_SKIPPED]);
	fprintf(out, " time=\"%.6f\" timestamp=\"%s\"", seconds, when);
	put_attribute(j, "hostname", host, out);
	fputs(">\n", out);
	if (relaxations[0] == 0) return;
	fputs("  <properties><property name=\"relaxations\"", out);
	put_attribute(j, "value", relaxations, out);
	fputs("/></properties>\n", out);
}

ts_status ts_junit_end(ts_junit *j, const char *relaxations, double seconds)
{
	ts_file_text whole;
	if (ts_file_text_close(&j->cases, j->path) != TS_OK) return TS_ERROR;
	ts_status status = ts_file_text_begin(&whole, j->path);
	if (status == TS_OK) {
		put_suite(j, relaxations, seconds, whole.out);
		fwrite(j->cases.text, 1, j->cases.bytes, whole.out);
		fputs("</testsuite>\n", whole.out);
		if (j->failed) ts_file_text_drop(&whole);
		status = j->failed ? ts_fail("%s: out of memory", j->path) : ts_file_text_replace(&whole, j->path);
	}
	free(j->cases.text);
	return status;
}

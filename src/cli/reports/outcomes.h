/* Outcomes of the cases of a judging command: rows of its report, which TAP and JUnit XML print too; and all output
 * that is made of them. */
#ifndef TS_CLI_REPORTS_OUTCOMES_H
#define TS_CLI_REPORTS_OUTCOMES_H
#include <jansson.h>
#include "cli/line/cli.h"
#include "cli/reports/junit.h"
#include "kernels/base/compat.h"
#include "model/core.h"
#include "study/results/table.h"

typedef enum {
	TS_PASSED,
	TS_LEFT_OUT, /* not judged, for a reason */
	TS_KNOWN,    /* differs as a baseline says */
	TS_FAILED,
	TS_BROKEN, /* could not be judged, although it should */
	TS_N_OUTCOMES,
} ts_outcome;

/* Rows are {KEY: name, "verdict": a word, "outcome": "passed", "skipped", "known", "failed" or "error", "why": the
 * reason or "", "lines": the lines about it}. */
typedef struct {
	const char *key;        /* "case" or "stage" */
	const char *class_name; /* in JUnit XML */
	json_t *rows, *seconds; /* times of the rows */
	bool failed;            /* out of memory */
} ts_outcomes;

ts_status ts_outcomes_begin(ts_outcomes *outcomes, const char *key, const char *class_name);
/* Takes rows that were read, which may hold anything, and the time of each. End by ts_outcomes_end, also on failure. */
ts_status ts_outcomes_read(ts_outcomes *outcomes, const char *key, const char *class_name, json_t *rows,
                           json_t *seconds);
/* Appends a case, which the calls that follow describe. */
void ts_outcomes_add(ts_outcomes *outcomes, const char *name, const char *verdict, ts_outcome outcome, const char *why,
                     double seconds);
void ts_outcomes_line(ts_outcomes *outcomes, const char *line);
void ts_outcomes_value(ts_outcomes *outcomes, const char *key, json_t *value);
u32 ts_outcomes_count(const ts_outcomes *outcomes, ts_outcome outcome);
ts_status ts_outcomes_check(const ts_outcomes *outcomes);
void ts_outcomes_end(ts_outcomes *outcomes);

/* Reports the lines of each case; those of cases that did not pass as failures. */
void ts_outcomes_lines(ts_report *report, const ts_outcomes *outcomes);
/* What was relaxed, unless it is "", and the cases, in Test Anything Protocol. */
void ts_outcomes_tap(const ts_outcomes *outcomes, const char *relaxed, FILE *out);
/* The counts, and a table of the cases that did not pass, in Markdown. */
void ts_outcomes_markdown(const ts_outcomes *outcomes, const char *command, const char *relaxed, FILE *out);
void ts_outcomes_junit(const ts_outcomes *outcomes, ts_junit *junit);

enum { TS_RELAXED_TEXT = 1100 };

/* All relaxations as they were typed, with control characters replaced by '?'. The text is part of the verdict; "" if
 * there are none. */
void ts_relaxed_text(char text[TS_RELAXED_TEXT], const ts_cli *cli);

/* The output of a judging command: as text or JSON, as TAP, as JUnit XML, and as a folder of results. */
typedef struct {
	const char *command; /* "compare" */
	const ts_outcomes *outcomes;
	const char *relaxed; /* relaxations; "" none */
	json_t *cases;       /* names of the cases of all shards; NULL: there are no shards */
	ts_status status;    /* with which the command will end */
	void (*report)(ts_report *report, const void *user);
	bool lines;                          /* the report has the lines of the outcomes */
	ts_status (*draw)(const void *user); /* pictures into the folder of -o; NULL: none */
	/* Writes the page of --report, of both sides and of the report as JSON; NULL: there is no page. */
	ts_status (*show)(const ts_cli *cli, const char *json, const void *user);
	const void *user;
} ts_outcomes_output;
/* Writes all output that cli asks for. `print`: also prints the report, unless it was printed as it came. */
ts_status ts_outcomes_report(ts_cli *cli, const ts_outcomes_output *output, bool print);
/* Writes the file of --junit if nothing was judged, by TS_ERROR or TS_SKIPPED; the latter as TAP too. */
void ts_outcomes_report_failed(const ts_cli *cli, const char *command, ts_status status);

#endif

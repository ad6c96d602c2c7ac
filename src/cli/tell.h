/* The output of a judging command: as text or JSON, as TAP, as JUnit XML, and as a folder of results. */
#ifndef TS_CLI_TELL_H
#define TS_CLI_TELL_H
#include "cli/cli.h"
#include "cli/outcomes.h"
#include "study/table.h"

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

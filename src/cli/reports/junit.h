/* JUnit XML for continuous integration: one suite of cases (tests/cli/junit.xsd). */
#ifndef TS_CLI_REPORTS_JUNIT_H
#define TS_CLI_REPORTS_JUNIT_H
#include "kernels/base/compat.h"
#include "output/file.h"

/* The outcome of a case. */
typedef enum {
	TS_JUNIT_PASSED,
	TS_JUNIT_SKIPPED,
	TS_JUNIT_FAILURE,
	TS_JUNIT_ERROR,
	TS_N_JUNIT_OUTCOMES,
} ts_junit_outcome;

/* A suite that is being written. It must not be moved. Texts may have any bytes: those that XML cannot hold are shown
 * as \xHH or '?'. */
typedef struct {
	const char *path, *suite;
	ts_file_text cases;
	ts_junit_outcome outcome; /* of the case that is open */
	u32 n[TS_N_JUNIT_OUTCOMES];
	bool failed; /* out of memory */
} ts_junit;

/* Begins a suite of that name. After a failure there is nothing to end. */
ts_status ts_junit_begin(ts_junit *junit, const char *path, const char *suite);
/* Opens a case that passes unless ts_junit_say follows. */
void ts_junit_case(ts_junit *junit, const char *classname, const char *name, double seconds);
/* Adds a line to the open case. The first line is the message, and sets the outcome; `type` is a word for the outcome,
 * NULL if the case was skipped. */
void ts_junit_say(ts_junit *junit, ts_junit_outcome outcome, const char *type, const char *line);
void ts_junit_case_end(ts_junit *junit);
/* Writes the file, whole or not at all, and releases the suite, also on failure. `relaxations` become a property of the
 * suite; "" none. `seconds` is the time of the suite. */
ts_status ts_junit_end(ts_junit *junit, const char *relaxations, double seconds);

#endif

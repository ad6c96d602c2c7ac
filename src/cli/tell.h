/* What a command that judges says: as text or JSON, as TAP, as JUnit XML, and as a folder of results. */
#ifndef TS_CLI_TELL_H
#define TS_CLI_TELL_H
#include "client.h"
#include "../study/table.h"
#include "outcomes.h"

typedef struct {
	const char *command; /* "compare" */
	const ts_outcomes *outcomes;
	const char *relaxed; /* relaxations; "" none */
	json_t *cases;       /* names of all cases, those of other shards too; NULL: there are no shards */
	ts_status status;    /* that the command will end with */
	void (*report)(ts_report *report, const void *user);
	bool lines;                          /* the report has the lines of the outcomes */
	ts_status (*draw)(const void *user); /* pictures into the folder of -o; NULL: none */
	/* Both sides, and what was said of them as JSON, into the page of --report; NULL: there is none. */
	ts_status (*show)(ts_html *page, const char *said, const void *user);
	const void *user;
} ts_telling;
/* Says all that cli asks for. Whether the report is printed, with `print`, or was, as it came. */
ts_status ts_tell(ts_cli *cli, const ts_telling *telling, bool print);
/* Writes the file of --junit where nothing was judged. */
void ts_tell_failed(const ts_cli *cli, const char *command);
#endif

/* The report of `replay`, as text and as JSON. */
#ifndef TS_CLI_REPLAY_REPORT_H
#define TS_CLI_REPLAY_REPORT_H
#include "cli/client.h"
#include "study/results/table.h"

/* A stage that was replayed. */
typedef struct {
	const char *stage;
	u32 number;
	ts_status status;      /* TS_OK same, TS_DIFFERENT, TS_ERROR */
	ts_verdicts *verdicts; /* NULL of TS_ERROR */
	char error[1024];      /* of TS_ERROR */
} ts_replayed;

/* Begins the report with the traces; candidate may be NULL. */
void ts_replay_report_begin(ts_report *report, ts_trace *reference, ts_trace *candidate);
/* Reports a line per output. */
void ts_replay_report_outputs(ts_report *report, const ts_replayed *replayed);
/* Reports a line for the stage: same, the first difference, or the reason why it could not be replayed. */
void ts_replay_report_stage(ts_report *report, const ts_replayed *replayed);

#endif

/* What `replay` prints, as text and as JSON. */
#ifndef TS_CLI_REPLAY_REPORT_H
#define TS_CLI_REPLAY_REPORT_H
#include "../replay/judge.h"
#include "../study/table.h"

enum { TS_MAX_OUTPUTS = 6 };

/* A stage that was replayed. */
typedef struct {
	const ts_stage *stage;
	ts_status status; /* TS_OK same, TS_DIFFERENT, TS_ERROR */
	ts_judged judged[TS_MAX_OUTPUTS];
	u32 n_judged;
	char error[1024]; /* of TS_ERROR */
} ts_replayed;

/* Which traces; candidate may be NULL. */
void ts_replay_report_begin(ts_report *report, const ts_trace *reference, const ts_trace *candidate);
/* A line an output. */
void ts_replay_report_outputs(ts_report *report, const ts_replayed *replayed, const ts_pipeline *pipeline);
/* A line for the stage: same, what first differs, or why it could not be replayed. */
void ts_replay_report_stage(ts_report *report, const ts_replayed *replayed, const ts_pipeline *pipeline);

#endif

/* A comparison of traces or buffers, and what is said of it in each form. The files that include this header ask the
 * library by its public headers. */
#ifndef TS_CLI_COMPARE_H
#define TS_CLI_COMPARE_H
#include "client.h"
#include "../study/table.h"
#include "outcomes.h"

/* Two sides, and how they were judged. All NULL before that. */
typedef struct {
	ts_context *context;
	ts_trace *reference, *candidate;
	const ts_trace_info *of; /* the reference's */
	ts_compare_options options;
	ts_verdicts *verdicts;
} ts_compared;

/* Judges. TS_OK: all is the same; TS_DIFFERENT; TS_ERROR. */
ts_status ts_compared_judge(ts_compared *compared);
/* Closes all that is open. */
void ts_compared_end(ts_compared *compared);
/* The place of a buffer among the verdicts; NULL: none is of it. */
const ts_verdict_info *ts_compared_find(const ts_compared *compared, const char *buffer, size_t *place);

/* A row a buffer, the verdict, the line of the first divergence, and where stages were given the candidate's inputs all
 * that differ; as text and as JSON. relaxed: as ts_relaxed_text has it. */
void ts_compare_report(ts_report *report, const ts_compared *compared, const char *relaxed);
/* Part of it as text: the verdicts of the stages, if they were given the candidate's inputs. */
void ts_compare_stages(ts_report *report, const ts_compared *compared);
/* Lines of the differences behind the first of a buffer, as far as they are listed. */
void ts_compare_more(ts_report *report, const ts_compared *compared, size_t place, const char *indent);
/* A uniquely named case a stage: it passes if all that differs is known, and fails if that differs no more. */
typedef struct ts_compare_lists ts_compare_lists;
void ts_compare_outcomes(ts_outcomes *outcomes, const ts_compared *compared, const ts_compare_lists *lists);

/* Writes BUFFER.png into the folder of -o for each buffer of rows and columns that is unlike, and for each cube where a
 * buffer of texels is unlike BUFFER-cube-R.png: the faces +X, -X, +Y, -Y, +Z, -Z side by side, levels of a mip map one
 * below the other. White is what differs. Cubes are drawn only where the reference has cube_size.face. */
ts_status ts_compare_draw(const ts_compared *compared);

#endif

/* A comparison of traces, buffers or images, and what is said of it in each form. The files that include this header
 * ask the library by its public headers. */
#ifndef TS_CLI_COMPARE_H
#define TS_CLI_COMPARE_H
#include "cli/client.h"
#include "cli/reports/outcomes.h"
#include "study/results/table.h"

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
/* The verdict on a buffer, and its index; NULL: there is none. */
const ts_verdict_info *ts_compared_find(const ts_compared *compared, const char *buffer, size_t *place);

/* Reports a row per buffer, the verdict and the line of the first divergence; if stages were given the candidate's
 * inputs, of each that differs; as text and as JSON. relaxed: the text of ts_relaxed_text. */
void ts_compare_report(ts_report *report, const ts_compared *compared, const char *relaxed);
/* Reports, as text, the verdicts of the stages, if they were given the candidate's inputs. */
void ts_compare_stages(ts_report *report, const ts_compared *compared);
/* Reports the listed differences of a buffer after the first, a line each. */
void ts_compare_more(ts_report *report, const ts_compared *compared, size_t place, const char *indent);
/* A uniquely named case a stage: it passes if all that differs is known, and fails if that differs no more. */
typedef struct ts_compare_lists ts_compare_lists;
void ts_compare_outcomes(ts_outcomes *outcomes, const ts_compared *compared, const ts_compare_lists *lists);

/* Writes to the folder of -o BUFFER.png for each buffer of rows and columns that differs, and BUFFER-cube-R.png for
 * each cube in which a buffer of texels differs: the faces +X, -X, +Y, -Y, +Z, -Z side by side, levels of a mip map one
 * below the other. Elements that differ are white. Cubes are drawn only if the reference has cube_size.face. */
ts_status ts_compare_draw(const ts_compared *compared);

/* Compares the image files cli->arguments, value by value, with the relaxations and tolerances of cli. Reports the
 * number of values and pixels that differ, the first of them, the greatest difference and the root mean square of all.
 * A picture of display values (PNG, JPEG) and one of linear radiance (EXR) are compared only with --exposure, as
 * display values. */
ts_status ts_compare_images(ts_cli *cli);

#endif

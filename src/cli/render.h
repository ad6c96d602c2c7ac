/* One `render`: its runs and their pictures. */
#ifndef TS_CLI_RENDER_H
#define TS_CLI_RENDER_H
#include <touchstone/image.h>
#include "cli/line/cli.h"
#include "study/asked/job.h"
#include "study/asked/methods.h"
#include "study/asked/truths.h"
#include "study/measure.h"
#include "study/results/table.h"
#include "study/trace.h"

enum { TS_MAX_PAIRS = 256, TS_MAX_SHOWN = TS_MAX_METHODS + TS_MAX_TRUTHS };

/* Two pictures that were compared. */
typedef struct {
	const ts_picture *reference, *image;
	ts_metrics all, reflective;         /* over the image and, if there is a mask, over its reflective pixels */
	double flicker, reflective_flicker; /* over the same, mirrors in both frames; NaN: there is no frame before */
	ts_light_metrics light;             /* over all pixels except the sky's */
	bool parted;                        /* there are triangles of light: these are set */
	ts_light_metrics near, elsewhere;
	const char *share; /* cause of the error: "method", "sampling", "both" or "" */
	const u8 *chosen;  /* pixels that give the estimates, if the truth was made in part; NULL: no estimates */
} ts_pair;

typedef struct {
	const ts_job *job;
	const char *effect;
	const char *folder; /* of its files: "", or a name that ends in "/" */
	ts_scene *scene;
	ts_estimate estimate;
	const ts_pipeline *methods[TS_MAX_METHODS];
	u32 n_methods;
	ts_measure measures[TS_MAX_METHODS];
	ts_stage_pictures stages[TS_MAX_METHODS];
	ts_tracing tracings[TS_MAX_METHODS];
	ts_trace_shared shared;               /* by the traces */
	ts_history histories[TS_MAX_METHODS]; /* of a sequence of frames */
	ts_picture pictures[TS_MAX_METHODS];  /* as methods */
	ts_picture truths[TS_MAX_TRUTHS];     /* by the table of truths; those not asked for are empty */
	const ts_picture *mirrors;            /* a picture with the reflective pixels; NULL: the effect has none */
	const u8 *mirrors_still;              /* reflective in this frame and the one before; NULL: there was none */
	ts_pair pairs[TS_MAX_PAIRS];
	u32 n_pairs;
} ts_render;

/* Runs the methods that have no picture yet, and makes the truths that are missing. */
ts_status ts_render_make(ts_render *render);
/* Compares all pictures. Fails without memory. */
ts_status ts_render_compare(ts_render *render);
/* Releases the pictures; the scene and the histories stay. */
void ts_render_clear(ts_render *render);
/* Opens the scene, if it is not open, and refuses runs that need too much memory. */
ts_status ts_render_open(ts_render *render);
/* Calls `with` with a render of the job, whose methods are known. */
ts_status ts_render_with(const ts_job *job, ts_status (*with)(ts_render *render, void *user), void *user);
/* Sets the exposure so that 95 % of the pixels that see a surface in frame 0, by the first method, are at most 0.8
 * of the brightest that is displayed (exposure.c). */
ts_status ts_exposure_choose(ts_job *job);
/* Renders a series: of the job's frames, of the combinations of its sweep, or of both. */
ts_status ts_render_series(ts_cli *cli);
/* Whether files are to be written, traces alone among them; and where. */
bool ts_render_writes(const ts_job *job);
bool ts_render_traces(const ts_job *job);
const char *ts_render_output(const ts_job *job);

/* Whether the job's scene depends on the parameter. */
bool ts_render_scene_reads(const ts_job *job, const char *param);

/* The i-th picture of TS_MAX_SHOWN, methods before truths; ts_render_shown: NULL if it was not made. */
ts_picture *ts_render_picture(ts_render *render, u32 i);
const ts_picture *ts_render_shown(const ts_render *render, u32 i);
/* The number of pictures that are asked for; and the index of one among them. */
u32 ts_render_count(const ts_render *render);
u32 ts_render_place(const ts_render *render, u32 i);
/* The name of picture i, whether it was made or not. */
void ts_render_name(char *name, size_t bytes, const ts_render *render, u32 i);

/* Makes the truths that are asked for and start from a run of this method. */
ts_status ts_render_truths_of(ts_render *render, const ts_pipeline *method, ts_run *run);
/* Makes the truths that are still missing, by a run of their own. */
ts_status ts_render_truths_rest(ts_render *render);
/* Bits of the truths that the scene does not have, or that are left out because of their work; prints a line for
 * each. */
u32 ts_render_truths_absent(const ts_render *render);
void ts_render_truths_missing(const ts_render *render, ts_report *report);
/* The method from whose run the truth starts: the first chosen one, otherwise the first of the effect; NULL: none. */
const ts_pipeline *ts_render_truth_method(const ts_render *render, const ts_truth_kind *kind);
/* The factor of brightness of pictures of differences: 8, for indirect light 4, as in SSAGH's figure 8. */
int ts_render_difference_scale(const ts_render *render);
/* Writes all pictures by ts_folder_file. */
ts_status ts_render_write(ts_render *render);
/* Reports the tables, and the figures in them. */
void ts_render_report_head(const ts_render *render, ts_report *report);
void ts_render_report_body(const ts_render *render, ts_report *report);
/* The rows of the table of pictures for one frame. */
void ts_render_report_pictures(const ts_render *render, ts_table *table);
/* The page of --report. The check refuses it if there are no pictures, or it is in the folder that a later --force
 * replaces; the write makes it from the folder that was written. */
ts_status ts_render_page_check(const ts_job *job);
ts_status ts_render_page(const ts_cli *cli);
/* Prints a line if the picture shows none of the mirrors or is nearly black, with options to try. */
void ts_render_advise(const ts_render *render);

#endif

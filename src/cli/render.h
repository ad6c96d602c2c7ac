/* One `render`: what was run and what came of it. */
#ifndef TS_CLI_RENDER_H
#define TS_CLI_RENDER_H
#include <touchstone/image.h>
#include "../study/job.h"
#include "../study/measure.h"
#include "../study/methods.h"
#include "../study/table.h"
#include "../study/trace.h"
#include "../study/truths.h"
#include "cli.h"

enum { TS_MAX_PAIRS = 256, TS_MAX_SHOWN = TS_MAX_METHODS + TS_MAX_TRUTHS };

/* Two pictures that were compared. */
typedef struct {
	const ts_picture *reference, *image;
	ts_metrics all, reflective;         /* over the image and, if there is a mask, over its reflective pixels */
	double flicker, reflective_flicker; /* over the same, but mirrors in both frames; NaN: no frame was before */
	ts_light_metrics light;             /* over all pixels but the sky's */
	bool parted;                        /* there are triangles of light: these are set */
	ts_light_metrics near, elsewhere;
	const char *share; /* whose error this is: "method", "sampling", "both" or "" */
	const u8 *chosen;  /* pixels by which these are estimates, as a truth was made in part; NULL: they are not */
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
	ts_picture truths[TS_MAX_TRUTHS];     /* as that table; those not asked for are empty */
	const ts_picture *mirrors;            /* one that knows the reflective pixels; NULL: the effect has none */
	const u8 *mirrors_still;              /* those in the frame before as well; NULL: there was none */
	ts_pair pairs[TS_MAX_PAIRS];
	u32 n_pairs;
} ts_render;

/* Runs the methods that have no picture yet, and makes the truths that are missing. */
ts_status ts_render_make(ts_render *render);
/* Compares all that have pictures. Fails without memory. */
ts_status ts_render_compare(ts_render *render);
/* Releases the pictures; the scene and the histories stay. */
void ts_render_clear(ts_render *render);
/* Opens the scene, if there is none, and refuses what needs too much memory. */
ts_status ts_render_open(ts_render *render);
/* A render of the job whose methods are known, passed to `with`. */
ts_status ts_render_with(const ts_job *job, ts_status (*with)(ts_render *render, void *user), void *user);
/* Sets the exposure so that 95 % of the pixels that see a surface in frame 0, by the first method, are at most 0.8
 * of the brightest that is displayed (exposure.c). */
ts_status ts_exposure_choose(ts_job *job);
/* Several: of the job's frames, of the combinations of its sweep, or of both. */
ts_status ts_render_series(ts_cli *cli);
/* Whether files are to be written, traces alone among them; and where. */
bool ts_render_writes(const ts_job *job);
bool ts_render_traces(const ts_job *job);
const char *ts_render_output(const ts_job *job);

/* Whether the job's scene depends on the parameter. */
bool ts_render_scene_reads(const ts_job *job, const char *param);

/* The i-th picture of TS_MAX_SHOWN, methods before truths; and the same, or NULL if it was not made. */
ts_picture *ts_render_picture(ts_render *render, u32 i);
const ts_picture *ts_render_shown(const ts_render *render, u32 i);
/* How many are asked for; and the place of one among them. */
u32 ts_render_count(const ts_render *render);
u32 ts_render_place(const ts_render *render, u32 i);
/* Its name, whether it was made or not. */
void ts_render_name(char *name, size_t bytes, const ts_render *render, u32 i);

/* Makes the truths asked for that start from a run of this method, if it is the one to start from. */
ts_status ts_render_truths_of(ts_render *render, const ts_pipeline *method, ts_run *run);
/* Makes those that are still missing, by a run of their own. */
ts_status ts_render_truths_rest(ts_render *render);
/* Bits of those that the scene has none of, or that are left out because of their work; and a line for each. */
u32 ts_render_truths_absent(const ts_render *render);
void ts_render_truths_missing(const ts_render *render, ts_report *report);
/* The method that the truth starts from: the first chosen one, else the first of the effect; NULL: from none. */
const ts_pipeline *ts_render_truth_method(const ts_render *render, const ts_truth_kind *kind);
/* Pictures of differences are so many times as bright: 8, of indirect light 4, as in SSAGH's figure 8. */
int ts_render_difference_scale(const ts_render *render);
/* Writes all pictures by ts_folder_file. */
ts_status ts_render_write(ts_render *render);
/* The tables, and the figures they are made of. */
void ts_render_report_head(const ts_render *render, ts_report *report);
void ts_render_report_body(const ts_render *render, ts_report *report);
/* The rows of the table of pictures that tell of one frame. */
void ts_render_report_pictures(const ts_render *render, ts_table *table);
/* The page of --report: refused where there are no pictures, or within the folder that a later --force replaces; and
 * written, of the folder that was. */
ts_status ts_render_page_check(const ts_job *job);
ts_status ts_render_page(const ts_cli *cli);
/* A line where the picture shows none of the mirrors or is nearly black, with what to try. */
void ts_render_advise(const ts_render *render);

#endif

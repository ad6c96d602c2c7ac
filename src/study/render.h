/* A render: methods and truths of an effect that are run in turn, their pictures, and how these compare. */
#ifndef TS_STUDY_RENDER_H
#define TS_STUDY_RENDER_H
#include <touchstone/image.h>
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
	const ts_scene *scene;
	ts_scene *own; /* the scene, where ts_render_open opened it */
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
/* Finds the job's methods; *render must be zero. */
ts_status ts_render_begin(ts_render *render, const ts_job *job);
/* Releases what a render holds, whether or not it was begun. */
void ts_render_end(ts_render *render);
/* Calls `with` with a render that is begun. */
ts_status ts_render_with(const ts_job *job, ts_status (*with)(ts_render *render, void *user), void *user);
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
enum { TS_MISSING_LINE = 4096 };
void ts_render_truth_missing(char *line, size_t bytes, const ts_render *render, u32 truth);
void ts_render_truths_missing(const ts_render *render, ts_report *report);
/* The method from whose run the truth starts: the first chosen one, otherwise the first of the effect; NULL: none. */
const ts_pipeline *ts_render_truth_method(const ts_render *render, const ts_truth_kind *kind);

#endif

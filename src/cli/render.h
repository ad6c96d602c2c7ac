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

enum { TS_MAX_PAIRS = 256 };

/* Two pictures that were compared. */
typedef struct {
	const ts_picture *reference, *image;
	ts_metrics all, reflective; /* over the image and, if there is a mask, over its reflective pixels */
	ts_light_metrics light;     /* over all pixels but the sky's */
	bool parted;                /* there are triangles of light: these are set */
	ts_light_metrics near, elsewhere;
	const char *share; /* whose error this is: "method", "sampling", "both" or "" */
} ts_pair;

typedef struct {
	const ts_job *job;
	const char *effect;
	ts_scene *scene;
	ts_estimate estimate;
	const ts_pipeline *methods[TS_MAX_METHODS];
	u32 n_methods;
	ts_measure measures[TS_MAX_METHODS];
	ts_stage_pictures stages[TS_MAX_METHODS];
	ts_tracing tracings[TS_MAX_METHODS];
	ts_picture pictures[TS_MAX_METHODS]; /* as methods */
	ts_picture truths[TS_MAX_TRUTHS];    /* as that table; those not asked for are empty */
	u8 *mask;                            /* 1: a reflective pixel; NULL: the effect has none */
	u64 n_reflective;
	ts_pair pairs[TS_MAX_PAIRS];
	u32 n_pairs;
} ts_render;

/* Makes the truths asked for that start from a run of this method, if it is the one to start from. */
ts_status ts_render_truths_of(ts_render *render, const ts_pipeline *method, ts_run *run);
/* Makes those that are still missing, by a run of their own. */
ts_status ts_render_truths_rest(ts_render *render);
/* A line for each that the scene has none of. */
void ts_render_truths_missing(const ts_render *render, ts_report *report);
/* Pictures of differences are so many times as bright: 8, of indirect light 4, as in SSAGH's figure 8. */
int ts_render_difference_scale(const ts_render *render);
/* Writes all pictures by ts_folder_file. */
ts_status ts_render_write(ts_render *render);
/* The tables, and the figures they are made of. */
void ts_render_report_head(const ts_render *render, ts_report *report);
void ts_render_report_body(const ts_render *render, ts_report *report);

#endif

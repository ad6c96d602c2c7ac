/* A pipeline: a method of a paper applied to an effect, an ordered list of stages. */
#ifndef TS_PIPELINES_PIPELINE_H
#define TS_PIPELINES_PIPELINE_H
#include "../model/shape.h"
#include "stage.h"

typedef struct {
	const char *name;     /* as in render EFFECT */
	const char *doc;      /* what its pictures show, for help */
	bool mirrors;         /* the eye sees mirrors that show cubes; scenes get added reflectors */
	ts_buffer_id seen;    /* keys of what the eye sees, a triangle or a surfel, TS_EMPTY where it is nothing */
	u32 difference_scale; /* of pictures of differences between methods */
	const char *lower;    /* what takes most memory beside the image, in a message */
} ts_effect;

/* NULL: there is none of that name. */
const ts_effect *ts_effect_find(const char *name);

/* When points are stored: see the parameter `points.buffered`. */
enum { TS_STORED_ANYHOW, TS_STORED_BY_DEFAULT, TS_STORED_IF_ASKED };

typedef struct ts_step {
	const char *stage;
	const struct ts_step *run; /* instead of a stage: steps that several methods share, ended as a pipeline's */
	u32 least_bounces;         /* runs only if so many bounces are followed */
	bool only_traced;          /* runs only for a trace: later stages do without what it makes */
	bool only_margins; /* of ts_pipeline_steps: the margin of the stage before, run only if run->margins asks for it */
	bool only_ordered; /* points that arrive in any order do without */
	u32 stored;        /* TS_STORED_*: runs only if points are */
	bool (*only_if)(const ts_params *params); /* NULL: whatever the parameters are */
	bool (*spares)(const ts_params *params);  /* the stage does not read `spared`, though it may; NULL: never */
	ts_buffer_id spared;
	bool unnumbered; /* in traces it has the number of the step before, so that those behind keep theirs */
	bool each_batch; /* neighbours with this mark run for one batch after the other */
} ts_step;

typedef void ts_planner(ts_plan *plan, const ts_params *params, const ts_counts *counts, const ts_request *request);

/* Sizes, batches and memory that a run is expected to need. */
typedef struct {
	ts_sizes sizes; /* batched: of one batch */
	u64 batches;    /* as many like that */
	u64 work;       /* bytes that stages take beside buffers */
} ts_expected;

typedef struct ts_pipeline {
	const char *name; /* as in --method */
	const ts_effect *effect;
	const char *paper;
	const char *doc;
	const ts_step *steps; /* as written, ended by a step without stage and run; read ts_pipeline_steps */
	ts_planner *plan;     /* makes the default plan its own; may be NULL */
	/* Sets what of `expected` neither the scene has nor the parameters give. */
	void (*expect)(ts_expected *expected, const ts_scene *scene, const ts_params *params);
	bool only_named;   /* runs only where --method names it: it takes long, or is a variant */
	const char *lower; /* as of its effect; NULL: that */
	struct {
		const char *param, *value;
	} sets; /* a parameter that is this to the method, whatever was typed; or NULL */
} ts_pipeline;

/* All pipelines, those of an effect beside each other, ended by NULL. The effect of the first is meant where none is
 * named. */
const ts_pipeline *const *ts_pipelines(void);
const ts_pipeline *ts_pipeline_find(const char *effect, const char *name);

/* The steps of a row of the table, ended by one without a stage: runs of steps in their place, and behind each stage
 * its margin, like it in all but its name. Other pipelines have neither runs nor margins. */
const ts_step *ts_pipeline_steps(const ts_pipeline *pipeline);
/* The first method of the effect, NULL: of any, that makes all of the buffers, ended by TS_N_BUFFERS; NULL: none
 * does. */
const ts_pipeline *ts_pipeline_making(const char *effect, const ts_buffer_id *ids);
bool ts_pipeline_makes(const ts_pipeline *pipeline, const ts_buffer_id *ids);
/* What the eye sees in a run, by the keys that its effect names; *n pixels. */
const u64 *ts_pipeline_seen(const ts_run *run, u64 *n);
/* A step's stage reads the buffer. */
bool ts_pipeline_reads(const ts_pipeline *pipeline, ts_buffer_id id);

/* The parameters as the method takes them: what it sets itself is no longer what was typed. */
ts_params ts_pipeline_params(const ts_pipeline *pipeline, const ts_params *typed);
/* What follows from parameters and counts. Request NULL: nothing. */
void ts_plan_make(ts_plan *plan, const ts_pipeline *pipeline, const ts_params *typed, const ts_counts *counts,
                  const ts_request *request);
/* Makes the run's plan and its one batch of all units. Counts, of what a trace holds; NULL: of the run's scene, before
 * the first stage. */
void ts_pipeline_plan(const ts_pipeline *pipeline, ts_run *run, const ts_counts *counts, const ts_request *request);
/* Before a run. */
ts_expected ts_pipeline_expect(const ts_pipeline *pipeline, const ts_scene *scene, const ts_params *typed);

/* Runs every step; refused if the pipeline draws surfels (a stage of it reads them) and the scene has none, or if it
 * draws triangles and the scene has surfels only. A buffer lives until its last reader if run->lean is set, else to the
 * end. */
ts_status ts_pipeline_run(const ts_pipeline *pipeline, ts_run *run);

/* True if the step is taken with these parameters, by a run that is traced or is not. */
bool ts_pipeline_takes(const ts_step *step, const ts_params *params, bool traced);

/* A step that is taken with these parameters, by a run that is traced, reads the buffer. */
bool ts_pipeline_needs(const ts_step *step, const ts_params *params, ts_buffer_id id);

/* The step that makes a buffer; NULL: none. */
const ts_step *ts_pipeline_maker(const ts_pipeline *pipeline, ts_buffer_id id);
/* Bytes of a buffer of its shape in records.def; 2^63 if that is unknown or more. */
u64 ts_pipeline_bytes(ts_buffer_id id, const ts_sizes *sizes);
/* Estimated peak of the frame's buffers and of work memory in bytes, before running, without what only a trace has;
 * `lean` as in ts_run. */
u64 ts_pipeline_estimate(const ts_pipeline *pipeline, const ts_scene *scene, const ts_params *params, bool lean);

#endif

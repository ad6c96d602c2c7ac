/* A pipeline: a method of a paper applied to an effect, an ordered list of stages. */
#ifndef TS_METHODS_PIPELINE_H
#define TS_METHODS_PIPELINE_H
#include "methods/stage.h"
#include "model/shape.h"

typedef struct {
	const char *name;     /* as in render EFFECT */
	const char *doc;      /* a phrase for help */
	bool mirrors;         /* the eye sees mirrors that show cubes; scenes get added reflectors */
	ts_buffer_id seen;    /* keys of the triangles or surfels that the eye sees, TS_EMPTY where there is none */
	u32 difference_scale; /* of pictures of differences between methods */
	const char *lower;    /* parameters to lower if memory is short, for a message */
} ts_effect;

/* The effect of that name, or NULL. */
const ts_effect *ts_effect_find(const char *name);

/* Conditions for storing points: see the parameter `points.buffered`. */
enum { TS_STORED_ANYHOW, TS_STORED_BY_DEFAULT, TS_STORED_IF_ASKED };

typedef struct ts_step {
	const char *stage;
	const struct ts_step *run; /* instead of a stage: steps that several methods share, ended as a pipeline's */
	u32 least_bounces;         /* runs only if at least this many bounces are followed */
	bool only_traced;          /* runs only for a trace: later stages do not need its outputs */
	bool only_margins; /* of ts_pipeline_steps: the margin of the stage before, run only if run->margins asks for it */
	bool only_ordered; /* does not run if points arrive in any order */
	u32 stored;        /* TS_STORED_*: runs only if points are */
	bool (*only_if)(const ts_params *params); /* NULL: with any parameters */
	bool (*spares)(const ts_params *params);  /* whether the stage leaves `spared` unread; NULL: never */
	ts_buffer_id spared;
	bool unnumbered; /* in traces it has the number of the step before, so that later steps keep theirs */
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
	/* Sets the members of `expected` that neither the scene nor the parameters give. */
	void (*expect)(ts_expected *expected, const ts_scene *scene, const ts_params *params);
	bool only_named;   /* runs only where --method names it: it takes long, or is a variant */
	const char *lower; /* like that of the effect; NULL: that of the effect */
	struct {
		const char *param, *value;
	} sets; /* a parameter of stages and the value that it always has for the method; or NULL. Scenes are made before */
} ts_pipeline;

/* All pipelines, grouped by effect, ended by NULL. The effect of the first is the default. */
const ts_pipeline *const *ts_pipelines(void);
const ts_pipeline *ts_pipeline_find(const char *effect, const char *name);

/* The steps of a row of the table, ended by a step without a stage: runs of steps are expanded, and each stage is
 * followed by its margin, whose step differs only in the name. Other pipelines have neither runs nor margins. */
const ts_step *ts_pipeline_steps(const ts_pipeline *pipeline);
/* The first method of the effect (NULL: of any effect) that makes all the buffers, ended by TS_N_BUFFERS; NULL: none
 * does. */
const ts_pipeline *ts_pipeline_making(const char *effect, const ts_buffer_id *ids);
bool ts_pipeline_makes(const ts_pipeline *pipeline, const ts_buffer_id *ids);
/* The keys that a run's eye sees, in the buffer that its effect names; *n: number of pixels. */
const u64 *ts_pipeline_seen(const ts_run *run, u64 *n);
/* Whether a step's stage reads the buffer. */
bool ts_pipeline_reads(const ts_pipeline *pipeline, ts_buffer_id id);

/* The parameters as the method reads them: with the value that it sets itself. */
ts_params ts_pipeline_params(const ts_pipeline *pipeline, const ts_params *typed);
/* Makes a plan from parameters and counts. request may be NULL. */
void ts_plan_make(ts_plan *plan, const ts_pipeline *pipeline, const ts_params *typed, const ts_counts *counts,
                  const ts_request *request);
/* Makes the run's parameters those of ts_pipeline_params, its plan, and one batch of all units. counts: those of a
 * trace; NULL: those of the run's scene, before the first stage. */
void ts_pipeline_plan(const ts_pipeline *pipeline, ts_run *run, const ts_counts *counts, const ts_request *request);
/* The expectation before a run. */
ts_expected ts_pipeline_expect(const ts_pipeline *pipeline, const ts_scene *scene, const ts_params *typed);

/* Runs every step; refused if the pipeline draws surfels (a stage of it reads them) and the scene has none, or if it
 * draws triangles and the scene has surfels only. A buffer lives until its last reader if run->lean is set, otherwise
 * to the end. */
ts_status ts_pipeline_run(const ts_pipeline *pipeline, ts_run *run);

/* Whether the step is taken with these parameters, by a run that is traced or not. */
bool ts_pipeline_takes(const ts_step *step, const ts_params *params, bool traced);

/* Whether a traced run with these parameters takes the step, and the step reads the buffer. */
bool ts_pipeline_needs(const ts_step *step, const ts_params *params, ts_buffer_id id);

/* The step that makes a buffer; NULL: none. */
const ts_step *ts_pipeline_maker(const ts_pipeline *pipeline, ts_buffer_id id);
/* Bytes of a buffer by its shape in records.def; 2^63 if they are unknown or more. */
u64 ts_pipeline_bytes(ts_buffer_id id, const ts_sizes *sizes);
/* The estimated peak of the frame's buffers and of work memory, in bytes, before a run, without the buffers of traces;
 * `lean` as in ts_run. */
u64 ts_pipeline_estimate(const ts_pipeline *pipeline, const ts_scene *scene, const ts_params *typed, bool lean);

#endif

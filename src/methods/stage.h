/* A stage: one GPU pass, a pure function from buffers and parameters to buffers. */
#ifndef TS_METHODS_STAGE_H
#define TS_METHODS_STAGE_H
#include "backends/backend.h"
#include "methods/plan.h"
#include "model/shape.h"
#include "scene/scene.h"

typedef struct {
	const char *name;
	i64 value;
} ts_counter;
typedef struct {
	const char *stage;
	double seconds;
} ts_timing;
enum { TS_MAX_COUNTERS = 64, TS_MAX_TIMINGS = 128 };

typedef struct ts_run ts_run;

/* State from one frame to the next: the sizes of the cubes after frame `frame`. The caller owns it, and runs frame
 * after frame with one method, one scene and the same parameters except `frame`, which grows. Zero-initialise; release
 * n by free(). */
typedef struct {
	u32 *n; /* NULL: no frame was run */
	u32 frame, n_cubes;
} ts_history;

/* The way to compute a run. Only `arrival` changes a result: the order of the points and, at ties, the point that
 * wins. */
typedef struct {
	u32 threads;         /* of the C backend */
	bool no_fast_paths;  /* the C backend takes no fast paths */
	ts_backend *backend; /* NULL: the C backend; otherwise it outlives the run */
	bool arrival;        /* points are appended as they come, not in the order of the pieces */
} ts_how;

typedef struct {
	const char *name;
	const char *kind;                     /* map, emit or scatter */
	const ts_launch *const *launches;     /* ended by NULL; NULL: none */
	const ts_buffer_id *looks_at, *makes; /* by its host code; ended by TS_N_BUFFERS; NULL: none */
	ts_status (*run)(ts_run *run);
	const char *margin_of; /* of a margin: the stage whose decisions it judges; NULL: the stage is no margin */
	const char *paper;
	const char *doc;
} ts_stage;

/* Lists for those members. */
#define TS_LAUNCHES(...) ((const ts_launch *const[]){__VA_ARGS__, NULL})
#define TS_BUFFERS(...) ((const ts_buffer_id[]){__VA_ARGS__, TS_N_BUFFERS})

/* Called after every stage, whose outputs are in run->frame. */
typedef ts_status (*ts_stage_hook)(const ts_run *run, const ts_stage *stage, void *user);

struct ts_run {
	const ts_scene *scene;
	ts_params params;                   /* as typed: read only */
	ts_plan plan;                       /* made from them; read only from the first stage on */
	const struct ts_pipeline *pipeline; /* whose plan it is; NULL: the default one */
	ts_c_backend c;
	ts_backend *backend;     /* NULL: c */
	bool arrival;            /* see ts_how */
	u32 first_unit, n_units; /* the batch that stages work on: all units, unless a step runs by batches */
	bool traced;             /* also the stages that only traces need */
	bool margins;            /* also the stages of margins */
	bool lean;               /* a buffer lives until its last reader; digests and replays need all buffers */
	bool keep[TS_N_BUFFERS]; /* buffers that stay even so */
	bool asked;              /* elements that no stage reads may be left out of buffers that do not stay */
	bool made[TS_N_BUFFERS]; /* by the stage that runs */
	ts_frame frame;
	ts_sizes sizes; /* of the scene, and what stages counted */
	ts_counter counters[TS_MAX_COUNTERS];
	u32 n_counters;
	ts_timing timings[TS_MAX_TIMINGS];
	u32 n_timings;
	ts_history *history; /* read and written; NULL: the sizes of the frames before are computed again */
	ts_stage_hook hook;
	void *hook_user;
};

/* Starts a run on the C backend: the scene's arrays become the frame's first buffers. */
void ts_run_begin(ts_run *run, const ts_scene *scene, const ts_params *params, u32 threads);
void ts_run_how(ts_run *run, const ts_how *how);
/* Releases the frame. */
void ts_run_end(ts_run *run);
/* Runs one stage: times it, calls the hook, names the stage in the message of a failure. */
ts_status ts_run_stage(ts_run *run, const ts_stage *stage);
const ts_backend *ts_run_backend(const ts_run *run);
ts_backend *ts_run_backend_of(ts_run *run);
/* Adds to a counter by name. */
void ts_run_count(ts_run *run, const char *name, i64 value);
/* The value of the counter of that name; 0: there is none. */
i64 ts_run_counter(const ts_run *run, const char *name);
i64 ts_counter_of(const ts_counter *counters, u32 n, const char *name);

/* Sizes of records.def (sizes.c). A run has those of the scene and those that stages counted; the others are computed
 * when they are asked for, for the batch if batched. TS_UNKNOWN if a size is neither there nor computable. */
void ts_run_set_size(ts_run *run, ts_dim dim, u64 n);
u64 ts_run_size(const ts_run *run, ts_dim dim);
/* Computes the sizes that are still unknown, for all batches. */
void ts_sizes_give(ts_sizes *sizes, const ts_run *run);
/* Sets the sizes of a scene. */
void ts_sizes_scene(ts_sizes *sizes, const ts_scene *scene);
/* Sets n cubes and the off-screen views that are their faces. */
void ts_sizes_cubes(ts_sizes *sizes, u64 n);

/* The run's backend at work: see backend.h. */
ts_status ts_run_fill(ts_run *run, ts_buffer_id id, u8 byte);
/* Makes a buffer of zeros, for data that mostly stay zero. */
void *ts_run_zeros(ts_run *run, ts_buffer_id id, u32 n_dims, const u64 *shape);
/* Turns the counts of a buffer with a SUM row into exclusive prefix sums, in place; the size of the row is known then.
 * The total must stay below 2^32 - 1. */
ts_status ts_run_scan(ts_run *run, ts_buffer_id id, u64 *total);

/* Makes a buffer for the host to write, by its shape; NULL with the message set. */
void *ts_run_make(ts_run *run, ts_buffer_id id);

/* Launches (launch.c). The pointers of a launch are set by its kernel's rows and its own bindings. Buffers that it
 * writes are made, by their shapes in records.def, if this stage has not made them yet; the first batch makes them for
 * all batches, unless the shape has batched sizes. Pointers that are not bound are NULL; pointers to lent memory stay
 * as the stage set them. */
ts_status ts_launch_fill(ts_run *run, const ts_launch *launch, void *args, size_t bytes);
/* Runs items [0, n) with arguments that were filled. */
ts_status ts_launch_items(ts_run *run, const ts_launch *launch, const void *args, u64 n);
/* Does what a traversal that begins with n pairs and launches the kernel over all its pairs does, without the
 * traversal; source: its arguments. False if the backend cannot. */
bool ts_launch_at_once(ts_run *run, const ts_launch *launch, const void *source, const void *args, u64 n);
/* Fills the arguments and runs the items. */
ts_status ts_launch_run(ts_run *run, const ts_launch *launch, void *args, size_t bytes, u64 n);
/* Fills arguments for callers that evaluate a kernel's functions: only the buffers that it reads are bound, and nothing
 * is made. */
ts_status ts_launch_ask(const ts_run *run, const ts_launch *launch, void *args, size_t bytes);
#define TS_ASK(run, launch, args) ts_launch_ask(run, launch, args, sizeof *(args))
#define TS_FILL(run, launch, args) ts_launch_fill(run, launch, args, sizeof *(args))
#define TS_RUN(run, launch, args, n) ts_launch_run(run, launch, args, sizeof *(args), n)
/* Makes a buffer that a launch writes, `more` elements longer than its shape; ts_launch_cut cuts these off again. */
ts_status ts_launch_make(ts_run *run, const ts_launch *launch, const char *name, u32 more);
/* Lets the next filling of the launch make its outputs again, since sizes have changed. */
void ts_launch_make_again(ts_run *run, const ts_launch *launch);
void ts_launch_cut(ts_run *run, const ts_launch *launch, const char *name, u32 less);
/* Whether elements that no stage reads may be left out of a buffer that the launch writes. */
bool ts_launch_spares(const ts_run *run, const ts_launch *launch, const char *name);
/* Turns counts that a launch wrote into exclusive prefix sums, in place, and sets the size of the SUM row of
 * records.def. The total must stay below 2^32 - 1. */
ts_status ts_launch_sum(ts_run *run, const ts_launch *launch, const char *name, u64 *total);

/* All stages, in the order of pipelines, ended by NULL. */
const ts_stage *const *ts_stages(void);
const ts_stage *ts_stage_find(const char *name);
/* The stage of the margins of this stage's decisions, which runs right after it if margins are asked for; NULL: there
 * is none. */
const ts_stage *ts_stage_margin(const ts_stage *stage);
/* The buffers that a stage's launches and host code read, except those that they make, in the order of records.def; and
 * the buffers that they write, in the order of the launches. Ended by TS_N_BUFFERS. Buffers of a step that was not
 * taken are not there. */
const ts_buffer_id *ts_stage_inputs(const ts_stage *stage);
const ts_buffer_id *ts_stage_outputs(const ts_stage *stage);
bool ts_stage_reads(const ts_stage *stage, ts_buffer_id id);
bool ts_stage_writes(const ts_stage *stage, ts_buffer_id id);

#endif

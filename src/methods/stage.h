/* A stage: one GPU pass, a pure function from buffers and parameters to buffers. */
#ifndef TS_STAGES_STAGE_H
#define TS_STAGES_STAGE_H
#include "../backends/backend.h"
#include "../model/shape.h"
#include "../scene/scene.h"
#include "plan.h"

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

/* What one frame leaves the next: the sizes of the cubes after frame `frame`. Owned by whoever runs frame after frame
 * with one method, one scene and the same parameters but `frame`, which grows; zero-initialise, release n by free(). */
typedef struct {
	u32 *n; /* NULL: no frame was run */
	u32 frame, n_cubes;
} ts_history;

/* What computes a run. Only `arrival` changes a result: the order of the points and, where they tie, what is seen. */
typedef struct {
	u32 threads;         /* of the C backend */
	bool no_fast_paths;  /* it takes none */
	ts_backend *backend; /* NULL: the C backend; else outlives the run */
	bool arrival;        /* points are appended as they come, not in the order of the pieces */
} ts_how;

typedef struct {
	const char *name;
	const char *kind;                     /* map, emit or scatter */
	const ts_launch *const *launches;     /* ended by NULL; NULL: none */
	const ts_buffer_id *looks_at, *makes; /* what its host code does beside; ended by TS_N_BUFFERS; NULL: nothing */
	ts_status (*run)(ts_run *run);
	const char *margin_of; /* of a margin: the stage whose decisions it is about; NULL: it is none */
	const char *paper;
	const char *doc;
} ts_stage;

/* Lists for those members. */
#define TS_LAUNCHES(...) ((const ts_launch *const[]){__VA_ARGS__, NULL})
#define TS_BUFFERS(...) ((const ts_buffer_id[]){__VA_ARGS__, TS_N_BUFFERS})

/* Called after every stage, with what it wrote in run->frame. */
typedef ts_status (*ts_stage_hook)(const ts_run *run, const ts_stage *stage, void *user);

struct ts_run {
	const ts_scene *scene;
	ts_params params;                   /* as typed: read only */
	ts_plan plan;                       /* what follows from them: read only from the first stage on */
	const struct ts_pipeline *pipeline; /* whose plan it is; NULL: the default one */
	ts_c_backend c;
	ts_backend *backend;     /* NULL: c */
	bool arrival;            /* see ts_how */
	u32 first_unit, n_units; /* the batch that stages work on: all, but where a step goes by batches */
	bool traced;             /* also the stages that only traces need */
	bool margins;            /* also the stages that say how near the decisions were */
	bool lean;               /* a buffer lives until its last reader; digests and replays want all of them */
	bool keep[TS_N_BUFFERS]; /* even so, these stay */
	bool asked;              /* what nobody reads may be left out of buffers that do not stay */
	bool made[TS_N_BUFFERS]; /* by the stage that runs */
	ts_frame frame;
	ts_sizes sizes; /* of the scene, and what stages counted */
	ts_counter counters[TS_MAX_COUNTERS];
	u32 n_counters;
	ts_timing timings[TS_MAX_TIMINGS];
	u32 n_timings;
	ts_history *history; /* read and written; NULL: the frames before are replayed */
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

/* Sizes of records.def (sizes.c). A run has those of the scene and what stages counted; the others are computed when
 * they are asked for, of the batch if batched. TS_UNKNOWN where neither is there. */
void ts_run_set_size(ts_run *run, ts_dim dim, u64 n);
u64 ts_run_size(const ts_run *run, ts_dim dim);
/* Computes what is still unknown, of all batches. */
void ts_sizes_give(ts_sizes *sizes, const ts_run *run);
/* Sets what a scene has. */
void ts_sizes_scene(ts_sizes *sizes, const ts_scene *scene);
/* Sets n cubes and the off-screen views that are their faces. */
void ts_sizes_cubes(ts_sizes *sizes, u64 n);

/* The run's backend at work: see backend.h. */
ts_status ts_run_fill(ts_run *run, ts_buffer_id id, u8 byte);
/* Makes a buffer of zeros, for what mostly stays zero. */
void *ts_run_zeros(ts_run *run, ts_buffer_id id, u32 n_dims, const u64 *shape);
/* Counts to the sums before each, in place, of a buffer with a SUM row, whose size is then known. The total must
 * stay below 2^32 - 1. */
ts_status ts_run_scan(ts_run *run, ts_buffer_id id, u64 *total);

/* Makes what the host writes, by its shape; NULL with the message set. */
void *ts_run_make(ts_run *run, ts_buffer_id id);

/* What launches need (launch.c). A launch's pointers are set by its kernel's rows and by what it binds otherwise;
 * what it writes is made, by its shape in records.def, where this stage has not made it yet: of all batches by the
 * first, unless its shape has batched sizes. Pointers that it does not bind are NULL; those to lent memory stay as
 * the stage set them. */
ts_status ts_launch_fill(ts_run *run, const ts_launch *launch, void *args, size_t bytes);
/* Runs items [0, n) with arguments that were filled. */
ts_status ts_launch_items(ts_run *run, const ts_launch *launch, const void *args, u64 n);
/* The same over all pairs of a traversal that begins with n, whose arguments are `source`, without that; false where
 * the backend does not. */
bool ts_launch_at_once(ts_run *run, const ts_launch *launch, const void *source, const void *args, u64 n);
/* Filled, then run. */
ts_status ts_launch_run(ts_run *run, const ts_launch *launch, void *args, size_t bytes, u64 n);
/* As a filling, for who asks what a kernel would answer: only what it reads is bound, and nothing is made. */
ts_status ts_launch_ask(const ts_run *run, const ts_launch *launch, void *args, size_t bytes);
#define TS_ASK(run, launch, args) ts_launch_ask(run, launch, args, sizeof *(args))
#define TS_FILL(run, launch, args) ts_launch_fill(run, launch, args, sizeof *(args))
#define TS_RUN(run, launch, args, n) ts_launch_run(run, launch, args, sizeof *(args), n)
/* Makes what a launch writes, `more` elements longer than its shape says; and cuts that off again. */
ts_status ts_launch_make(ts_run *run, const ts_launch *launch, const char *name, u32 more);
/* The next filling of the launch makes its outputs once more, for sizes have changed. */
void ts_launch_make_again(ts_run *run, const ts_launch *launch);
void ts_launch_cut(ts_run *run, const ts_launch *launch, const char *name, u32 less);
/* What nobody reads may be left out of a buffer that the launch writes. */
bool ts_launch_spares(const ts_run *run, const ts_launch *launch, const char *name);
/* Counts to the sums before each, in place, and the size that SUM of records.def names; it must stay below 2^32 - 1. */
ts_status ts_launch_sum(ts_run *run, const ts_launch *launch, const char *name, u64 *total);

/* All stages, in the order of pipelines, ended by NULL. */
const ts_stage *const *ts_stages(void);
const ts_stage *ts_stage_find(const char *name);
/* The stage that says how near the decisions of this one were, and runs right behind it where margins are asked for;
 * NULL: it has none. */
const ts_stage *ts_stage_margin(const ts_stage *stage);
/* What its launches and its host code read, but what they make, in the order of records.def; and what they write, in
 * that of the launches. Ended by TS_N_BUFFERS; those of a step that was not taken are not there. */
const ts_buffer_id *ts_stage_inputs(const ts_stage *stage);
const ts_buffer_id *ts_stage_outputs(const ts_stage *stage);
bool ts_stage_reads(const ts_stage *stage, ts_buffer_id id);
bool ts_stage_writes(const ts_stage *stage, ts_buffer_id id);

#endif

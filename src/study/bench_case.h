/* A case: one scene with one number of mirrors or lights, run by several methods in turn. */
#ifndef TS_STUDY_BENCH_CASE_H
#define TS_STUDY_BENCH_CASE_H
#include "study/asked/job.h"
#include "study/figure.h"
#include "study/measure.h"

enum { TS_BENCH_VARIANTS = 24 }; /* at most */

typedef enum {
	TS_TIMED,
	TS_ONCE,  /* one run */
	TS_FIRST, /* one run, at the first frame, which stands for all frames; no image */
	TS_ALONE, /* timed, with one thread */
	TS_LONG,  /* one run, left out where methods that take long are */
} ts_bench_runs;

/* A method with parameters of its own, beside the typed ones. */
typedef struct {
	const char *method;
	const char *set; /* "NAME=VALUE,..." */
	bool seen;       /* its image is kept */
	ts_bench_runs runs;
	const char *name; /* in its table */
} ts_bench_variant;

typedef struct {
	const ts_job *job;
	const char *effect;
	const ts_bench_variant *variants; /* ended by one without a method */
	u32 n_variants;
	const ts_truth_kind *judge; /* the truth that images are compared with; NULL: none */
	bool rays;                  /* in runs whose image is kept, judge texels and shadows by rays */
	const char *spec;           /* of the scene */
	ts_scene *scene;
	ts_params params;
	const ts_pipeline *methods[TS_BENCH_VARIANTS]; /* NULL: there is none */
	ts_measure measures[TS_BENCH_VARIANTS];        /* of the last run */
	ts_history histories[TS_BENCH_VARIANTS];       /* of the frames before */
	ts_picture images[TS_BENCH_VARIANTS], truth;   /* of the first run of the frame */
	u8 *before[TS_BENCH_VARIANTS];                 /* srgb of the images of the frame before */
	u32 sampled;                                   /* surfels to sample from scenes without surfels; 0: none */
	bool begun;                                    /* a frame was run */
	bool hurried;                                  /* methods that take long are left out, as if there were none */
	double (*look)(const ts_run *run);             /* a figure that the table computes of buffers; NULL: none */
	double looked[TS_BENCH_VARIANTS];              /* its results, in the first run of variants whose image is kept */
} ts_bench_case;

/* Opens the scene; refuses a case that would need too much memory. Before, the members up to `rays` must be set and all
 * others zero. The case may be closed whether or not it was opened. */
ts_status ts_bench_case_open(ts_bench_case *c, const char *spec, const ts_params *params);
/* Does run 0, 1, ... of every variant. Run 0 also makes the truth, and releases the pictures of the frame before. The
 * parameter `frame` may be set before the call; successive frames keep their history. */
ts_status ts_bench_case_run(ts_bench_case *c, u32 run);
void ts_bench_case_close(ts_bench_case *c);
/* What figures are of. */
ts_figure_source ts_bench_case_source(const ts_bench_case *c);
/* The parameters of a variant. */
ts_status ts_bench_case_params(ts_params *params, const ts_bench_case *c, u32 variant);
/* ts_bench_set sets all parameters of "NAME=VALUE,..."; the other function only those that have their defaults, unless
 * the job has them by --set or the list `but` sets them. */
ts_status ts_bench_set(ts_params *params, const char *set);
ts_status ts_bench_set_defaults(ts_params *params, const ts_job *job, const char *set, const char *but);

#endif

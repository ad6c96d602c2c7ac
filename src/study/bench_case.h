/* One scene with one number of mirrors or lights, by several methods that take turns. */
#ifndef TS_CLI_BENCH_CASE_H
#define TS_CLI_BENCH_CASE_H
#include "job.h"
#include "measure.h"

enum { TS_BENCH_VARIANTS = 24 }; /* at most */

typedef enum {
	TS_TIMED,
	TS_ONCE,  /* one run */
	TS_FIRST, /* one run of the first frame, which stands for all; not seen */
	TS_ALONE, /* timed, of one thread */
	TS_LONG,  /* one run, left out where methods that take long are */
} ts_bench_runs;

/* A method with what is set for it, beside what was typed. */
typedef struct {
	const char *method;
	const char *set; /* "NAME=VALUE,..." */
	bool seen;       /* its image is kept */
	ts_bench_runs runs;
} ts_bench_variant;

typedef struct {
	const ts_job *job;
	const char *effect;
	const ts_bench_variant *variants; /* ended by one without a method */
	u32 n_variants;
	const ts_truth_kind *judge; /* the truth that images are compared with; NULL: none */
	bool rays;                  /* count what rays say of texels and shadows, in runs whose image is kept */
	const char *spec;           /* of the scene */
	ts_scene *scene;
	ts_params params;
	const ts_pipeline *methods[TS_BENCH_VARIANTS]; /* NULL: there is none */
	ts_measure measures[TS_BENCH_VARIANTS];        /* of the last run */
	ts_history histories[TS_BENCH_VARIANTS];       /* of the frames before */
	ts_picture images[TS_BENCH_VARIANTS], truth;   /* of the first run of the frame */
	u32 sampled;                                   /* surfels that scenes without some are sampled to; 0: none */
	bool begun;                                    /* a frame was run */
	bool hurried;                                  /* methods that take long are left out, as if there were none */
	double (*look)(const ts_run *run);             /* what the table asks of buffers; NULL: nothing */
	double looked[TS_BENCH_VARIANTS];              /* its answers, of the first run of variants whose image is kept */
} ts_bench_case;

/* Opens the scene, and refuses what would need too much memory. A case whose first members, up to `rays`, are set and
 * the others zero may be closed whether or not it was opened. */
ts_status ts_bench_case_open(ts_bench_case *c, const char *spec, const ts_params *params);
/* Run 0, 1, ... of every variant; run 0 also makes the truth, and gives the pictures of the frame before back. The
 * parameter `frame` may be set before: frames that follow each other go on from the one before. */
ts_status ts_bench_case_run(ts_bench_case *c, u32 run);
void ts_bench_case_close(ts_bench_case *c);
/* The parameters of a variant. */
ts_status ts_bench_case_params(ts_params *params, const ts_bench_case *c, u32 variant);
/* Sets "NAME=VALUE,...": all, or those parameters that have their defaults. */
ts_status ts_bench_set(ts_params *params, const char *set);
ts_status ts_bench_set_defaults(ts_params *params, const char *set);

#endif

/* Running a method and keeping what is worth telling: pictures, times, counters, sizes. */
#ifndef TS_CLI_MEASURE_H
#define TS_CLI_MEASURE_H
#include "../pipelines/pipeline.h"
#include "../trace/write.h"
#include "stage_pictures.h"

/* An image as radiance and as displayed, of the eye's size. */
typedef struct {
	char name[24];   /* "epr", "truth-a", ... */
	f32 *radiance;
	u8 *srgb;
	double seconds;  /* that it took */
	u64 n_hits, n_missed; /* of truth A: its rays that hit something, and EPR's look-ups that are empty there */
} ts_picture;

/* What a run told. */
typedef struct {
	const ts_pipeline *method;
	double seconds;
	ts_counter counters[TS_MAX_COUNTERS];
	u32 n_counters;
	ts_timing timings[TS_MAX_TIMINGS];
	u32 n_timings;
	u64 elements[TS_N_BUFFERS]; /* made in all batches together */
	u64 bytes[TS_N_BUFFERS];    /* at once, the largest batch */
	u64 peak_bytes;
	double mean_diameter;       /* texels a side of the cubes in sight, mean */
	u32 n_in_sight;
	ts_stage_pictures *pictures; /* NULL: none are taken */
	const ts_trace_options *trace; /* NULL: none is written */
	const char *viewer;            /* folder of the output for copies for viewers; NULL: none */
	ts_trace_writer *writer;
} ts_measure;

/* Truths are made of what a run left: called with the run still open. */
typedef ts_status (*ts_measure_after)(ts_run *run, void *user);

/* Runs `method` and measures it into *measure, of which only `pictures`, `trace` and `viewer` are read. `after`, which may
 * be NULL, is called behind the last stage. Prints progress. */
ts_status ts_measure_run(ts_measure *measure, const ts_pipeline *method, const ts_scene *scene, const ts_params *params,
                         const ts_how *how, ts_measure_after after, void *user);

/* NULL if that was not counted, or that stage did not run. */
const ts_counter *ts_measure_counter(const ts_measure *measure, const char *name);
const ts_timing *ts_measure_timing(const ts_measure *measure, const char *stage);
/* Shading operations, the paper's measure of work. */
i64 ts_measure_shading(const ts_measure *measure);

/* Copies image.radiance and image.srgb of the run. Released by ts_picture_free, also on failure. */
ts_status ts_picture_take(ts_picture *picture, const char *name, const ts_run *run);
/* Makes a picture of radiance, which it takes over. */
ts_status ts_picture_make(ts_picture *picture, const char *name, f32 *radiance, const ts_params *params);
void ts_picture_free(ts_picture *picture);

/* Truths A, B (TS_TRUTH_* of cli.h) of an EPR run, into *picture; afterwards the run's image is the truth's. */
ts_status ts_picture_truth(ts_picture *picture, u32 truth, ts_run *run);
/* Truth C. */
ts_status ts_picture_truth_c(ts_picture *picture, const ts_scene *scene, const ts_params *params, u32 threads);

/* Bytes that a run of these methods, with truth C if `truths` has it, is estimated to need at its peak; refused with
 * one line beyond three quarters of the machine's memory. */
ts_status ts_measure_estimate(u64 *bytes, const ts_pipeline *const *methods, u32 n_methods, u32 truths,
                              const ts_scene *scene, const ts_params *params);

#endif

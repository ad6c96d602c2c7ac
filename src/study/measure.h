/* Runs a method and keeps pictures, times, counters and sizes. */
#ifndef TS_STUDY_MEASURE_H
#define TS_STUDY_MEASURE_H
#include "methods/pipeline.h"
#include "study/notes.h"
#include "study/picture.h"
#include "study/stage_pictures.h"
#include "trace/write.h"
#include "truth/texels.h"

/* Takes the buffers that families look at after a run: lists ended by NULL, each ended by TS_N_BUFFERS. They must
 * stay. */
void ts_measure_keeps_use(const ts_buffer_id *const *ids);

/* A parameter to lower where a run would need too much memory, for methods that make a buffer. */
typedef struct {
	ts_buffer_id buffer;
	const char *param;
	u64 (*bytes)(const ts_params *params);
} ts_lower_rule;

/* Takes the rules of all families: lists ended by NULL, each ended by a row without `param`. They must stay. */
void ts_measure_lowers_use(const ts_lower_rule *const *rules);

/* The measurements of a run. */
typedef struct {
	const ts_pipeline *method;
	double seconds;
	ts_counter counters[TS_MAX_COUNTERS];
	u32 n_counters;
	ts_timing timings[TS_MAX_TIMINGS];
	u32 n_timings;
	u64 moved[TS_MAX_TIMINGS];  /* bytes of buffers that each stage read, without textures, and wrote, once each */
	u64 elements[TS_N_BUFFERS]; /* made in all batches together */
	u64 bytes[TS_N_BUFFERS];    /* at once, the largest batch */
	u64 peak_bytes;
	double mean_diameter; /* texels a side of the cubes in sight, mean */
	u32 n_in_sight;
	ts_stage_pictures *pictures;   /* NULL: none are taken */
	const ts_trace_options *trace; /* NULL: none is written */
	const char *viewer;            /* folder of the output for copies for viewers; NULL: none */
	bool rays;                     /* judge off-screen texels by rays */
	ts_truth *tree;                /* for these rays, during the run */
	ts_texel_counts texels;
	bool whole;               /* also make and count buffers that no stage reads */
	ts_history *history;      /* of earlier frames; NULL: none */
	bool notes;               /* take the notes of families */
	char note[TS_NOTE_CHARS]; /* "": nothing */
	ts_trace_writer *writer;
} ts_measure;

/* Makes truths from the buffers of a run, which is still open. */
typedef ts_status (*ts_measure_after)(ts_run *run, void *user);

/* Runs `method` and measures it into *measure, of which only `pictures`, `trace`, `viewer`, `rays`, `history`,
 * `notes` and `whole` are read. `after`, which may be NULL, is called behind the last stage. Prints progress. */
ts_status ts_measure_run(ts_measure *measure, const ts_pipeline *method, const ts_scene *scene, const ts_params *params,
                         const ts_how *how, ts_measure_after after, void *user);

/* Makes the process keep freed memory from now on, whichever thread freed it, as a renderer keeps its buffers: memory
 * from reading the scene serves the first frame, and that of a frame the next. Touching fresh pages costs up to a third
 * of the time of a large frame. */
void ts_measure_keep_memory(void);
/* Touches so many bytes of free memory, so that the next frame meets no fresh pages although others used its memory
 * meanwhile. */
void ts_measure_touch_memory(u64 bytes);
/* Returns free memory to the system; the next frame meets fresh pages. Without this, memory that Embree freed stays
 * between the frames' buffers and grows for dozens of frames. */
void ts_measure_return_memory(void);

/* The counter of that name; NULL if it was not counted, or its stage did not run. */
const ts_counter *ts_measure_counter(const ts_measure *measure, const char *name);
const ts_timing *ts_measure_timing(const ts_measure *measure, const char *stage);
/* Shading operations, the paper's measure of work. */
i64 ts_measure_shading(const ts_measure *measure);

/* Bytes that the process holds, with the scene's arrays, and bytes that a run is estimated to need at its peak beside
 * them. */
typedef struct {
	u64 held, run;
} ts_estimate;
/* What a run leaves: bytes of the pictures that stay until its end, and bytes that writing them takes then. */
typedef struct {
	u64 pictures, writing;
} ts_leaves;
/* Estimates runs of these methods, one after the other, with the truths `truths` (bits of rows of ts_truths), after the
 * scene was opened. leaves: NULL, nothing. Refuses with one line what is beyond three quarters of the machine's
 * memory. */
ts_status ts_measure_estimate(ts_estimate *estimate, const ts_pipeline *const *methods, u32 n_methods, u32 truths,
                              const ts_scene *scene, const ts_params *params, const ts_leaves *leaves);

#endif

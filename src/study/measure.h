/* Running a method and keeping what is worth telling: pictures, times, counters, sizes. */
#ifndef TS_CLI_MEASURE_H
#define TS_CLI_MEASURE_H
#include "../methods/pipeline.h"
#include "../trace/write.h"
#include "../truth/texels.h"
#include "notes.h"
#include "picture.h"
#include "stage_pictures.h"

/* Takes the buffers that families look at after a run: lists ended by NULL, each ended by TS_N_BUFFERS. They must
 * stay. */
void ts_measure_keeps_use(const ts_buffer_id *const *ids);

/* A parameter that alone sets how much memory methods that make a buffer take for something. */
typedef struct {
	ts_buffer_id buffer;
	const char *param;
	u64 (*bytes)(const ts_params *params);
} ts_lower_rule;

/* Takes the rules of all families: lists ended by NULL, each ended by a row without `param`. They must stay. */
void ts_measure_lowers_use(const ts_lower_rule *const *rules);

/* What a run told. */
typedef struct {
	const ts_pipeline *method;
	double seconds;
	ts_counter counters[TS_MAX_COUNTERS];
	u32 n_counters;
	ts_timing timings[TS_MAX_TIMINGS];
	u32 n_timings;
	u64 moved[TS_MAX_TIMINGS];  /* bytes of what each stage read, but for textures, and wrote, once each */
	u64 elements[TS_N_BUFFERS]; /* made in all batches together */
	u64 bytes[TS_N_BUFFERS];    /* at once, the largest batch */
	u64 peak_bytes;
	double mean_diameter; /* texels a side of the cubes in sight, mean */
	u32 n_in_sight;
	ts_stage_pictures *pictures;   /* NULL: none are taken */
	const ts_trace_options *trace; /* NULL: none is written */
	const char *viewer;            /* folder of the output for copies for viewers; NULL: none */
	bool rays;                     /* count what rays through the off-screen texels say of them */
	ts_truth *tree;                /* of those rays, while the run lasts */
	ts_texel_counts texels;
	bool whole;               /* also make what nobody reads, and count it */
	ts_history *history;      /* of the frames before; NULL: none */
	bool notes;               /* take the notes of families */
	char note[TS_NOTE_CHARS]; /* "": nothing */
	ts_trace_writer *writer;
} ts_measure;

/* Truths are made of what a run left: called with the run still open. */
typedef ts_status (*ts_measure_after)(ts_run *run, void *user);

/* Runs `method` and measures it into *measure, of which only `pictures`, `trace`, `viewer`, `rays`, `history`,
 * `notes` and `whole` are read. `after`, which may be NULL, is called behind the last stage. Prints progress. */
ts_status ts_measure_run(ts_measure *measure, const ts_pipeline *method, const ts_scene *scene, const ts_params *params,
                         const ts_how *how, ts_measure_after after, void *user);

/* From then on freed memory serves what comes next, as a renderer's buffers do: what reading a scene leaves the first
 * frame, and what that leaves the others, whichever thread freed it. Fresh pages cost up to a third of a large frame to
 * touch. */
void ts_measure_keep_memory(void);
/* Touches so many bytes of what is free, so that the next frame has no fresh pages though others had its memory. */
void ts_measure_touch_memory(u64 bytes);
/* Returns what is free to the system, for the price of fresh pages in the next frame. What Embree leaves lies between
 * the frames' buffers, and would grow for dozens of frames. */
void ts_measure_return_memory(void);

/* NULL if that was not counted, or that stage did not run. */
const ts_counter *ts_measure_counter(const ts_measure *measure, const char *name);
const ts_timing *ts_measure_timing(const ts_measure *measure, const char *stage);
/* Shading operations, the paper's measure of work. */
i64 ts_measure_shading(const ts_measure *measure);

/* Bytes that the process holds, the scene's arrays among them, and that a run is estimated to need at its peak
 * beside. */
typedef struct {
	u64 held, run;
} ts_estimate;
/* Of a run of these methods with the truths of `truths` (bits of rows of ts_truths), after the scene was opened;
 * refused with one line beyond three quarters of the machine's memory. */
ts_status ts_measure_estimate(ts_estimate *estimate, const ts_pipeline *const *methods, u32 n_methods, u32 truths,
                              const ts_scene *scene, const ts_params *params);

#endif

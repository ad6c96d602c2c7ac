/* What is asked of a render or a measurement: what it shows, how it runs, and what it leaves. */
#ifndef TS_CLI_JOB_H
#define TS_CLI_JOB_H
#include "../methods/stage.h"
#include "shard.h"

enum { TS_MAX_SWEEPS = 8, TS_SWEEP_TEXT = 48, TS_MAX_MIRRORS = 64 };

/* Parameters of which several values were said: every combination is rendered. */
typedef struct {
	char name[TS_SWEEP_TEXT];
	const char *values; /* separated by commas */
	u32 n;
} ts_swept;
typedef struct {
	ts_swept swept[TS_MAX_SWEEPS];
	u32 n;
} ts_sweep;

enum { TS_LAST_FRAME = 100000 }; /* that the parameter `frame` may name */

/* Frames first, first + step, ... up to last. */
typedef struct {
	u32 first, last, step; /* step 0: none were said */
} ts_frames;

/* Files and text. */
typedef struct {
	const char *dir; /* NULL: not said */
	bool force;      /* replace what an earlier run wrote there */
	bool no_images;
	bool json;  /* one object instead of text */
	bool quiet; /* only failures are told, as text */
	bool trace, margins, viewer;
	bool self_contained, compress; /* traces, too */
	const char *trace_only, *crop; /* NULL: all; either is a trace, too */
	const char *report;            /* a page; NULL: none */
} ts_output;

/* Strings are NULL if nothing was said. */
typedef struct {
	const char *program;                    /* its name */
	const ts_backend_kind *const *backends; /* that it has, the reference first, ended by NULL */
	const char *effect;
	const char *method; /* names */
	bool judged;        /* by the truths of the names `truth`, or by all */
	const char *truth;
	u32 truths; /* of a render: what these are, bits of rows of ts_truths */
	ts_params params;
	bool set[TS_N_PARAMS]; /* by --set */
	bool exposed;          /* the exposure follows from frame 0 */
	bool sized, mirrored;  /* the parameters' size was said; how many mirrors */
	bool framed;           /* the parameter `frame` was said */
	ts_sweep sweep;
	ts_frames frames;
	ts_shard shard;               /* cases that are worked on */
	const char *scenes, *objects; /* specs, of a render one; objects of a table */
	ts_scene_options scene;       /* its points are these */
	f32 eye[3], target[3], lamp[3], mirrors[TS_MAX_MIRRORS][4];
	u32 runs;   /* of which the median is taken; 0: as the table has it */
	ts_how how; /* its backend is opened before */
	const ts_backend_kind *backend;
	ts_backend_options device;        /* of the backend */
	bool backend_named, device_named; /* they were said */
	bool require;                     /* the device must be there */
	bool busy;                        /* time also on a busy machine */
	double open_s;                    /* that opening it took, its arithmetic checked */
	ts_output output;
	char *const *typed; /* the options, as a process of its own takes them */
	u32 n_typed;
} ts_job;

#endif

/* What the options ask of a render or a measurement: what to show, how to run, what to write. */
#ifndef TS_STUDY_ASKED_JOB_H
#define TS_STUDY_ASKED_JOB_H
#include "methods/stage.h"
#include "scene/places.h"
#include "study/asked/shard.h"

enum { TS_MAX_SWEEPS = 8, TS_SWEEP_TEXT = 48 };

/* Parameters for which several values were typed: every combination is rendered. */
typedef struct {
	char name[TS_SWEEP_TEXT];
	const char *values; /* separated by commas */
	u32 n;
} ts_swept;
typedef struct {
	ts_swept swept[TS_MAX_SWEEPS];
	u32 n;
} ts_sweep;

enum { TS_LAST_FRAME = 100000 }; /* greatest value of the parameter `frame` */

/* Frames first, first + step, ... up to last. */
typedef struct {
	u32 first, last, step; /* step 0: --frames was not typed */
} ts_frames;

/* Output: files and text. */
typedef struct {
	const char *dir; /* NULL: not typed */
	bool force;      /* replace what an earlier run wrote there */
	bool no_images;
	bool json;  /* one object instead of text */
	bool quiet; /* text has failures only */
	bool trace, margins, viewer;
	bool self_contained, compress; /* traces, too */
	const char *trace_only, *crop; /* NULL: all; either is a trace, too */
	const char *report;            /* a page; NULL: none */
	struct json_t **tree;          /* where a table's report goes, a new reference; NULL: it is printed */
} ts_output;

/* A job. Strings are NULL if the option was not typed. */
typedef struct {
	const char *program;                    /* its name */
	const ts_backend_kind *const *backends; /* of the program, the reference first, ended by NULL */
	const char *effect;
	const char *method; /* names */
	bool judged;        /* compared with the truths that `truth` names, or with all */
	const char *truth;
	u32 truths; /* of a render: those truths, as bits of rows of ts_truths */
	ts_params params;
	bool set[TS_N_PARAMS]; /* by --set */
	bool exposed;          /* the exposure is computed from frame 0 */
	bool sized, mirrored;  /* the size was typed; the number of mirrors was typed */
	bool framed;           /* the parameter `frame` was typed */
	ts_sweep sweep;
	ts_frames frames;
	ts_shard shard;               /* cases that are worked on */
	const char *scenes, *objects; /* specs, of a render one; objects of a table */
	ts_places scene;
	u32 runs;   /* runs of which the median is taken; 0: the table's number */
	ts_how how; /* its backend is open */
	const ts_backend_kind *backend;
	ts_backend_options device;        /* of the backend */
	bool backend_named, device_named; /* they were typed */
	bool require;                     /* the device must be there */
	bool busy;                        /* time also on a busy machine */
	double open_s;                    /* seconds that opening the backend and checking its arithmetic took */
	ts_output output;
	char *const *typed; /* the options, to start a process with the same ones */
	u32 n_typed;
} ts_job;

#endif

/* What the tables of `bench` share. */
#ifndef TS_CLI_BENCH_H
#define TS_CLI_BENCH_H
#include "job.h"
#include "measure.h"
#include "plot.h"
#include "table.h"

enum { TS_BENCH_OBJECTS = 1000 }; /* at most */

/* Sorts them. */
double ts_median(double *values, u32 n);
/* What a report opens with: size, where all rows have the same, frame, threads; program and parameters. */
void ts_bench_head(ts_report *report, const ts_job *job, bool sized);

/* Calls `each` for the scenes of --scene, else for the list `scenes` and those of the files `models` in the folder
 * TS_SCENES that are there; a line says which are not. `models` may be NULL. */
typedef ts_status ts_bench_scene(void *user, const char *spec);
ts_status ts_bench_scenes(const ts_job *job, const char *scenes, const char *models, ts_report *report,
                          ts_bench_scene *each, void *user);

/* The path of a file in the folder TS_SCENES; false: it cannot be read there. */
bool ts_bench_model(char *path, size_t bytes, const char *file);

/* Does the work of a table into a report. */
typedef ts_status ts_bench_work(const ts_job *job, ts_report *report, const void *user);
/* Prints the report; with -o also writes it to that folder, with every table as KEY.csv. */
ts_status ts_bench_with_report(const ts_job *job, ts_bench_work *work, const void *user);
/* Writes a plot to that folder. */
ts_status ts_bench_plot(const char *name, const ts_plot *plot);

typedef struct ts_paper_table ts_paper_table;

/* A table: a paper's, or what `run` measures. */
typedef struct {
	const char *name, *doc;
	const char *without; /* names of options that say nothing here, separated by blanks */
	const char *takes;   /* of the only ones that say something; NULL: all others */
	const ts_paper_table *paper;
	ts_status (*run)(const ts_job *job);
	u32 runs;          /* unless the job says how many; 0: three */
	const char *brief; /* the options of a run that takes seconds, separated by blanks; NULL: none */
	bool quiet;        /* it refuses a busy machine, but for --busy */
} ts_bench_row;

/* The options that a table of a paper, whose methods and truths are its own, and one without files ignore. */
#define TS_BENCH_BY_ITSELF "method truth"
#define TS_BENCH_FILES "output force"

/* The table of what must hold of a bench that is no ts_paper_table, called "relations" as those of papers' are: a row
 * each. `paper` may be NAN, and `because` is said where it does not hold. */
ts_table ts_bench_relations_begin(void);
typedef struct {
	const char *text, *bound;
	double here, paper;
	int decimals;
	bool holds;
	const char *because;
} ts_bench_relation;
void ts_bench_relation_add(ts_table *table, const ts_bench_relation *relation);

/* Takes the tables of all families: lists ended by NULL, each ended by a row without a name. The rows must stay. */
void ts_benches_use(const ts_bench_row *const *rows);
/* All of them in that order, then those of backends, ended by NULL. */
const ts_bench_row *const *ts_benches(void);
ts_status ts_bench_run(const ts_bench_row *row, const ts_job *job);
/* As `list benches` prints them. */
ts_table ts_bench_list(void);

/* Tables of a file each. */
ts_status ts_bench_backends(const ts_job *job);
ts_status ts_bench_start(const ts_job *job);
ts_status ts_bench_speed(const ts_job *job);
/* The one truth of an effect that --truth names, or that of the name `unless` without it; NULL: "none". */
ts_status ts_bench_truth(const ts_truth_kind **judge, const ts_job *job, const char *effect, const char *unless);

/* The one frame that these measure: --scene and --objects name one each. */
const char *ts_bench_frame_spec(const ts_job *job);
ts_status ts_bench_frame_params(ts_params *params, const ts_job *job);
/* The same with one --method, or the first of all. */
typedef struct {
	const ts_pipeline *method;
	ts_scene *scene;
	ts_params params;
} ts_bench_frame;
/* A frame that is zero at first may be closed whether or not it was opened. */
ts_status ts_bench_frame_open(ts_bench_frame *frame, const ts_job *job);
ts_status ts_bench_frame_run(const ts_bench_frame *frame, const ts_how *how, ts_measure *measure);
void ts_bench_frame_close(ts_bench_frame *frame);
/* A line of text, and figures of the JSON object. */
void ts_bench_frame_report(const ts_bench_frame *frame, ts_report *report);

/* How many 64-bit atomic minima a second reach random texels of a buffer of that size; four in five of them lower their
 * texel: the kernel bench_min. */
ts_status ts_bench_atomics(double *a_second, const ts_how *how, u64 bytes);

/* What the table `start` tells, in seconds. */
typedef struct {
	double open;  /* the backend: the driver's compiler parses the kernels, and the arithmetic is checked */
	double first; /* frame: each kernel is compiled for the device as it is first launched */
	double next;  /* frame */
} ts_bench_started;
/* The same measured in a process of its own, on a device of a backend. `set`: "VARIABLE=value" of its environment, or
 * NULL. */
ts_status ts_bench_start_apart(ts_bench_started *started, const ts_job *job, const char *backend, u32 device,
                               char *set);
/* Rows of a table of these columns, from `open` on. */
#define TS_BENCH_STARTED_COLUMNS \
	{"open_s", "open, s", true}, {"first_s", "first frame, s", true}, { "next_s", "next frame, s", true }
void ts_bench_started_cells(ts_table *table, const ts_bench_started *started);

#endif

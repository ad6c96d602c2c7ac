/* Shared by the tables of `bench`. */
#ifndef TS_STUDY_BENCH_H
#define TS_STUDY_BENCH_H
#include "study/asked/job.h"
#include "study/measure.h"
#include "study/plot.h"
#include "study/results/table.h"

enum { TS_BENCH_OBJECTS = 1000 }; /* at most */

/* The median of n values, which are sorted in place. */
double ts_median(double *values, u32 n);
/* Refuses truths in part. */
ts_status ts_bench_check(const ts_job *job, const char *table);
/* Opens a report: size, if `sized` (all rows have the same), frame, threads, program and parameters. */
void ts_bench_head(ts_report *report, const ts_job *job, bool sized);

/* Calls `each` for the scenes of --scene; without --scene for the list `scenes` and for the files of the list `models`
 * that the folder TS_SCENES has. A line names missing files. `models` may be NULL. */
typedef ts_status ts_bench_scene(void *user, const char *spec);
ts_status ts_bench_scenes(const ts_job *job, const char *scenes, const char *models, ts_report *report,
                          ts_bench_scene *each, void *user);

/* Writes the path of a file in the folder TS_SCENES; false: the file cannot be read. */
bool ts_bench_model(char *path, size_t bytes, const char *file);

/* Measures a table and writes it to a report. */
typedef ts_status ts_bench_work(const ts_job *job, ts_report *report, const void *user);
/* Prints the report of `work`; with -o also writes it to that folder, with each table as KEY.csv. */
ts_status ts_bench_with_report(const ts_job *job, ts_bench_work *work, const void *user);
/* Writes a plot to the folder of -o. */
ts_status ts_bench_plot(const char *name, const ts_plot *plot);

typedef struct ts_paper_table ts_paper_table;
typedef struct ts_speed_of ts_speed_of;

/* A table of `bench`: one of a paper, one of speed, or one that `run` measures. */
typedef struct {
	const char *name, *doc;
	const char *without; /* names of options that the table refuses, separated by blanks */
	const char *takes;   /* of the only ones that say something; NULL: all others */
	const ts_paper_table *paper;
	const ts_speed_of *const *speed; /* ended by NULL */
	ts_status (*run)(const ts_job *job);
	u32 runs;          /* unless the job says how many; 0: three */
	const char *brief; /* the options of a run that takes seconds, separated by blanks; NULL: none */
	bool quiet;        /* the table refuses a busy machine, unless --busy is given */
} ts_bench_row;

/* The options that a table of a paper, whose methods and truths are its own, and one without files ignore. */
#define TS_BENCH_BY_ITSELF "method truth"
#define TS_BENCH_FILES "output force"

/* Classes of causes, with which `because` of a relation begins: our reading or reconstruction of the paper; scenes,
 * sizes or settings that are not the paper's; what a processor pays for and a GPU does not, or the reverse; and claims
 * that do not hold of every scene. The setting that shows the cause stands behind "; see ". */
#define TS_OURS "ours: "
#define TS_ELSEWHERE "asked elsewhere: "
#define TS_GPU "a GPU's cost: "
#define TS_NOT_ALWAYS "not in general: "
bool ts_bench_has_class(const char *because);

/* The table "relations" of a bench that is no ts_paper_table: a row for each relation that must hold. `paper` may be
 * NAN; `because` is printed where the relation does not hold. */
ts_table ts_bench_relations_begin(void);
typedef struct {
	const char *text, *bound;
	double here, paper;
	int decimals;
	bool holds;
	const char *because;
} ts_bench_relation;
void ts_bench_relation_add(ts_table *table, const ts_bench_relation *relation);

/* Tables of a file each. */
ts_status ts_bench_backends(const ts_job *job);
ts_status ts_bench_start(const ts_job *job);
/* The one truth of an effect that --truth names; without --truth the one named `unless`; NULL for "none". */
ts_status ts_bench_truth(const ts_truth_kind **judge, const ts_job *job, const char *effect, const char *unless);

/* The one frame of benches that measure one: --scene and --objects must name one each. */
const char *ts_bench_frame_spec(const ts_job *job);
ts_status ts_bench_frame_params(ts_params *params, const ts_job *job);
/* One frame by one method: that of --method, or the first of all. */
typedef struct {
	const ts_pipeline *method;
	ts_scene *scene;
	ts_params params;
} ts_bench_frame;
/* A frame that is zero at first may be closed whether or not it was opened. */
ts_status ts_bench_frame_open(ts_bench_frame *frame, const ts_job *job);
ts_status ts_bench_frame_run(const ts_bench_frame *frame, const ts_how *how, ts_measure *measure);
void ts_bench_frame_close(ts_bench_frame *frame);
/* Reports the frame as a line of text and as figures of the JSON object. */
void ts_bench_frame_report(const ts_bench_frame *frame, ts_report *report);

/* Figures of the table `start`, in seconds. */
typedef struct {
	double open;  /* opening the backend: the driver's compiler parses the kernels, and the arithmetic is checked */
	double first; /* frame: each kernel is compiled for the device as it is first launched */
	double next;  /* frame */
} ts_bench_started;
/* Measures these figures in a process of its own, on a device of a backend. `set`: "VARIABLE=value" for that process's
 * environment, or NULL. */
ts_status ts_bench_start_apart(ts_bench_started *started, const ts_job *job, const char *backend, u32 device,
                               char *set);
/* Rows of a table of these columns, from `open` on. */
#define TS_BENCH_STARTED_COLUMNS \
	{"open_s", "open, s", true}, {"first_s", "first frame, s", true}, { "next_s", "next frame, s", true }
void ts_bench_started_cells(ts_table *table, const ts_bench_started *started);

#endif

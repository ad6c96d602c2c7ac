/* Shared by the files of `bench speed`. A row is one timed thing, measured run after run; before and after each run it
 * is checked whether the machine is quiet. */
#ifndef TS_STUDY_SPEED_WORK_H
#define TS_STUDY_SPEED_WORK_H
#include "study/bench.h"
#include "study/busy.h"
#include "study/speed.h"
#include "study/speed_limits.h"
#include "truth/bare.h"

/* Whether the machine is quiet: other processes leave the processors idle, and a fixed loop takes no longer than its
 * best time (busy.c). */
typedef struct {
	u32 threads;
	double best;    /* seconds of the loop */
	ts_busy before; /* reading before the row */
	bool slow;      /* the loop was slow before the row */
	u32 n_busy;     /* rows that were not quiet, counting those measured again */
	bool anyway;    /* nothing counts as quiet, and nothing is measured again */
} ts_quiet;

/* Calibrates, prints the limits, and fails on a busy machine, unless `anyway`. */
ts_status ts_quiet_begin(ts_quiet *quiet, ts_report *report, u32 threads, bool anyway);
void ts_quiet_before(ts_quiet *quiet);
/* Whether the machine was quiet since the reading before the row. */
bool ts_quiet_after(ts_quiet *quiet);

/* Values of a frame: its timings, the whole frame, and the time of a truth's rays for its views, 0 if there were
 * none. */
enum { TS_SPEED_WHOLE = TS_MAX_TIMINGS, TS_SPEED_CASTS, TS_SPEED_VALUES };

typedef struct {
	ts_status (*measure)(double *values, void *of);
	void *of;
	u32 n_values;
	double *values; /* n_values of each run */
	bool *quiet;    /* each run */
	double spent;   /* seconds so far */
} ts_speed_row;

ts_status ts_speed_row_begin(ts_speed_row *row, u32 n_values, u32 runs);
/* Measures a row for a run, again until the machine is quiet, at most three times; a row that took long already repeats
 * the values of the run before instead. */
ts_status ts_speed_row_run(ts_speed_row *row, u32 run, ts_quiet *quiet);
void ts_speed_row_end(ts_speed_row *row);

/* A figure over the runs: the median of the quiet runs, or of all if none was quiet; and the spread of these runs, in %
 * of the median. NAN: there are none. */
typedef struct {
	double median, spread;
	bool quiet;
} ts_speed_value;
/* The text of a column: "busy", or "". */
const char *ts_speed_state(const ts_speed_value *value);
ts_speed_value ts_speed_sum(const double *values, const bool *quiet, u32 runs);
/* The ts_speed_value of one value of a row. */
ts_speed_value ts_speed_row_value(const ts_speed_row *row, u32 value, u32 runs);

typedef struct {
	const ts_pipeline *method;
	ts_speed_set *set;
	ts_measure last, whole; /* whole: of a run before the others, with all counters */
	double casts;           /* the last value of the last run */
	ts_speed_row row;
	u64 bytes; /* that a run takes */
} ts_speed_frame;

/* An open scene with its methods, and the rays and points that they are compared with (speed_set.c). */
struct ts_speed_set {
	char name[48];
	ts_scene *scene;
	ts_params params;
	ts_how how;
	u32 n_frames, n_runs;
	ts_speed_frame frame[TS_SPEED_METHODS];
	bool wants_rays, wants_points;
	ts_bare *bare; /* NULL before the first frame, or if no rays are wanted */
	ts_limit_points points;
	u64 face_bytes; /* of an off-screen view of the mean side */
	ts_speed_row rays, drawn, minima;
};

/* What `set` asks of a job: of `only`, NULL: of all, of these methods. `set` stays where it is, is zero before, and is
 * closed also on failure. TS_SKIPPED, with the message set: there is no memory for it. */
ts_status ts_speed_set_open(ts_speed_set *set, const char *spec, const ts_speed_scene *of, const ts_job *job, u32 runs);
ts_status ts_speed_set_run(ts_speed_set *set, u32 run, ts_quiet *quiet);
void ts_speed_set_close(ts_speed_set *set);

/* The rows of the machine's limits. */
enum { TS_SPEED_SIZES = 3 };
extern const u32 ts_speed_mib[TS_SPEED_SIZES];
typedef struct {
	ts_speed_row minima[TS_SPEED_SIZES], stream;
	u32 threads;
} ts_speed_machine;

typedef struct {
	const ts_job *job;
	const ts_speed_of *const *lists; /* ended by NULL */
	ts_report *report;
	ts_quiet quiet;
	u32 n_runs;
	ts_speed_machine machine;
	ts_speed_set *sets;
	u32 n_sets;
} ts_speed;

/* speed_machine.c: what the machine is, and its limits as rows. */
void ts_speed_machine_print(const ts_speed *speed);
ts_status ts_speed_machine_begin(ts_speed_machine *machine, u32 threads, u32 runs);
ts_status ts_speed_machine_run(ts_speed_machine *machine, u32 run, ts_quiet *quiet);
void ts_speed_machine_end(ts_speed_machine *machine);
/* speed_tables.c */
void ts_speed_print_limits(const ts_speed *speed);
void ts_speed_print_stages(const ts_speed *speed);
void ts_speed_print_figures(const ts_speed *speed);
/* speed_figure.c: the value of a figure of these names over the runs. */
ts_speed_value ts_speed_figure_value(const ts_speed *speed, const ts_speed_of *of, const ts_speed_figure *figure);
/* speed_growth.c: measures and prints. */
ts_status ts_speed_print_growths(ts_speed *speed);
/* Whether --scene has the name, or was not typed. */
bool ts_speed_wants(const ts_job *job, const char *name);

#endif

/* `bench backends`: columns, shared by the files that fill and print them. */
#ifndef TS_STUDY_BENCH_BACKENDS_H
#define TS_STUDY_BENCH_BACKENDS_H
#include "study/bench.h"

enum { TS_BENCH_DEVICES = 3, TS_BENCH_COLUMNS = 2 + TS_BENCH_DEVICES, TS_BENCH_ATOMICS = 3 };
/* Rows of samples: the stages in the order of ts_measure.timings, the whole frame, the atomic limits. */
enum { TS_BENCH_ALL = TS_MAX_TIMINGS, TS_BENCH_LIMIT, TS_BENCH_ROWS = TS_BENCH_LIMIT + TS_BENCH_ATOMICS };

/* A backend, or the C backend with some threads. */
typedef struct {
	char name[16]; /* "c2", "opencl0" */
	char device[288], platform[128];
	const ts_backend_kind *kind;
	u32 index; /* of the device */
	ts_how how;
	bool own; /* closing the column closes its backend */
	ts_measure last;
	double *samples[TS_BENCH_ROWS]; /* one a run: seconds, or for limits offers a second */
} ts_bench_column;

typedef struct {
	const ts_job *job;
	ts_report *report;
	ts_bench_frame frame;
	u32 n_runs;
	ts_bench_column column[TS_BENCH_COLUMNS];
	u32 n_columns, reference; /* reference: index of the C column that devices are compared with, the last C column */
	json_t *notes;
	double *samples;
} ts_bench_table;

extern const u32 ts_bench_limit_mib[TS_BENCH_ATOMICS];

/* bench_columns.c: opens the C columns and every device found, or the device of --device. A found device that cannot be
 * measured gets a note; TS_SKIPPED: there is no device as typed. To be closed also on failure. */
ts_status ts_bench_columns_open(ts_bench_table *table);
void ts_bench_columns_close(ts_bench_table *table);
/* Closes a column that could not run the frame, and notes why. False where that is an error: for C, for a device that
 * was typed, and with --require. */
bool ts_bench_column_leave_out(ts_bench_table *table, u32 index);
/* Adds a line below the tables. */
void ts_bench_note(ts_bench_table *table, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* bench_tables.c */
void ts_bench_print_columns(const ts_bench_table *table);
void ts_bench_print_times(const ts_bench_table *table);
void ts_bench_print_rates(const ts_bench_table *table);
/* bench_build.c: measures and prints. */
ts_status ts_bench_print_builds(ts_bench_table *table);

#endif

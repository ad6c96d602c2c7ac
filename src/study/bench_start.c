/* `bench start`: the time until a backend's first frames; also in a process of its own, where nothing is loaded or
 * compiled yet. */
#include <fcntl.h>
#include <spawn.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include "model/json/read.h"
#include "study/bench.h"

extern char **environ;

static const ts_column columns[] = {{"backend", "backend", false}, TS_BENCH_STARTED_COLUMNS, {0}};

void ts_bench_started_cells(ts_table *table, const ts_bench_started *started)
{
	ts_table_real(table, started->open, 3);
	ts_table_real(table, started->first, 3);
	ts_table_real(table, started->next, 3);
}

static ts_status measure(ts_bench_started *started, const ts_bench_frame *frame, const ts_job *job)
{
	ts_measure m;
	double *next = ts_alloc(job->runs, sizeof *next, "the times");
	if (next == NULL) return TS_ERROR;
	ts_status status = ts_bench_frame_run(frame, &job->how, &m);
	*started = (ts_bench_started){.open = job->open_s, .first = m.seconds};
	for (u32 i = 0; status == TS_OK && i < job->runs; i++) {
		status = ts_bench_frame_run(frame, &job->how, &m);
		next[i] = m.seconds;
	}
	if (status == TS_OK) started->next = ts_median(next, job->runs);
	free(next);
	return status;
}

static ts_status report(const ts_bench_started *started, const ts_bench_frame *frame, const ts_job *job)
{
	ts_report r;
	ts_report_begin(&r, job->output.json);
	ts_bench_head(&r, job, true);
	ts_bench_frame_report(frame, &r);
	ts_table table = ts_table_begin("start", "Start", columns);
	table.timed = true;
	ts_table_text(&table, job->backend->name);
	ts_bench_started_cells(&table, started);
	ts_report_table(&r, &table);
	return ts_report_end(&r);
}

ts_status ts_bench_start(const ts_job *job)
{
	ts_bench_frame frame = {.scene = NULL};
	ts_bench_started started;
	ts_status status = ts_bench_frame_open(&frame, job);
	if (status == TS_OK) status = measure(&started, &frame, job);
	if (status == TS_OK) status = report(&started, &frame, job);
	ts_bench_frame_close(&frame);
	return status;
}

/* The typed arguments, for this backend. */
static void child_arguments(char **to, const ts_job *job, char *backend, char *device)
{
	u32 n = 0, n_options = job->n_typed;
	if (n_options > 0 && strcmp(job->typed[n_options - 1], "--") == 0) n_options--;
	to[n++] = "touchstone";
	to[n++] = "bench";
	for (u32 i = 0; i < n_options; i++) to[n++] = job->typed[i];
	char *const own[] = {"--backend", backend, "--device", device, "--runs", "1", "--json", "start", NULL};
	memcpy(to + n, own, sizeof own);
}

static void child_environment(char **to, char *set)
{
	u32 n = 0;
	size_t name_bytes = set != NULL ? strcspn(set, "=") + 1 : 0;
	for (char **each = environ; *each != NULL; each++) {
		if (set == NULL || strncmp(*each, set, name_bytes) != 0) to[n++] = *each;
	}
	if (set != NULL) to[n++] = set;
	to[n] = NULL;
}

static ts_status run_child(char **arguments, char **environment, FILE *out)
{
	posix_spawn_file_actions_t actions;
	pid_t child;
	int status = 1;
	if (posix_spawn_file_actions_init(&actions) != 0) return ts_fail("bench start: no memory for a process");
	posix_spawn_file_actions_adddup2(&actions, fileno(out), STDOUT_FILENO);
	posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
	int failed = posix_spawn(&child, "/proc/self/exe", &actions, NULL, arguments, environment);
	posix_spawn_file_actions_destroy(&actions);
	bool ended = failed == 0 && waitpid(child, &status, 0) == child && status == 0;
	return ended ? TS_OK : ts_fail("bench start: failed in a process of its own; run it by itself to see why");
}

static ts_status read_times(ts_bench_started *started, FILE *out)
{
	char text[1 << 16];
	rewind(out);
	json_t *root = ts_json_read(text, fread(text, 1, sizeof text, out), false, "bench start");
	if (root == NULL && ts_error_kind() == TS_KIND_MEMORY) return TS_ERROR;
	json_t *row = json_array_get(json_object_get(root, "start"), 0);
	started->open = json_number_value(json_object_get(row, "open_s"));
	started->first = json_number_value(json_object_get(row, "first_s"));
	started->next = json_number_value(json_object_get(row, "next_s"));
	json_decref(root);
	return started->next > 0 ? TS_OK : ts_fail("bench start: a process of its own told no times");
}

ts_status ts_bench_start_apart(ts_bench_started *started, const ts_job *job, const char *backend, u32 device, char *set)
{
	char name[32], number[16];
	size_t n_environment = 0;
	snprintf(name, sizeof name, "%s", backend);
	snprintf(number, sizeof number, "%u", (unsigned)device);
	while (environ[n_environment] != NULL) n_environment++;
	char **arguments = ts_alloc(job->n_typed + 12, sizeof *arguments, "arguments");
	char **environment = ts_alloc(n_environment + 2, sizeof *environment, "environment");
	FILE *out = tmpfile();
	ts_status status = arguments != NULL && environment != NULL ? TS_OK : TS_ERROR;
	if (out == NULL) status = ts_fail("a temporary file: cannot be made; the disk may be full");
	if (status == TS_OK) {
		child_arguments(arguments, job, name, number);
		child_environment(environment, set);
		status = run_child(arguments, environment, out);
	}
	if (status == TS_OK) status = read_times(started, out);
	if (out != NULL) fclose(out);
	free(arguments);
	free(environment);
	return status;
}

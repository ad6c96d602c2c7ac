/* From argv to a command and an exit code; every failure becomes one line on standard error. */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "backends/wide.h"
#include "cli/line/cli.h"
#include "cli/line/worker.h"
#include "output/file.h"
#include "vectors/vectors.h"

const ts_command *ts_cli_find(const char *name)
{
	for (const ts_command *c = ts_command_table; c->name != NULL; c++) {
		if (strcmp(c->name, name) == 0) return c;
	}
	return NULL;
}

const ts_command *ts_cli_require(const char *name)
{
	const ts_command *found = ts_cli_find(name);
	ts_nearest nearest = ts_nearest_begin(name);
	for (const ts_command *c = ts_command_table; c->name != NULL; c++) ts_nearest_offer(&nearest, c->name);
	if (found == NULL) {
		char lists[64];
		snprintf(lists, sizeof lists, "%s help", ts_program);
		ts_fail("no command \"%s\"%s", name, ts_nearest_hint(&nearest, lists));
	}
	return found;
}

ts_status ts_judging_check(const ts_cli *cli)
{
	if (cli->judging.tap && cli->job.output.json) return ts_fail("--tap, --json: both print; choose one");
	if (cli->job.output.force && cli->job.output.dir == NULL) return ts_fail("--force: only with -o DIR");
	return TS_OK;
}

/* A typed command. It is never copied: the scene that it requests points into the job. */
typedef struct {
	const ts_command *command; /* NULL: all is done */
	ts_cli cli;
} task;

static ts_status read_task(task *t, int argc, char **argv)
{
	if (argc < 2) return ts_fail("no command; \"%s help\" lists all", ts_program);
	if (strcmp(argv[1], "--version") == 0) {
		printf("%s %s, commit %s\n", ts_program, TS_VERSION, ts_commit());
		return TS_OK;
	}
	if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0) {
		ts_help_print(NULL);
		return TS_OK;
	}
	const ts_command *command = t->command = ts_cli_require(argv[1]);
	ts_status status = command != NULL ? ts_cli_parse(&t->cli, command, argc - 1, argv + 1) : TS_ERROR;
	if (status != TS_OK) return status;
	if (t->cli.given[TS_OPTION_HELP]) {
		ts_help_print(command);
		t->command = NULL;
		return TS_OK;
	}
	if (t->cli.job.sweep.n > 0 && strcmp(command->name, "render") != 0) {
		return ts_fail("--set %s=%s: one value; only render takes lists", t->cli.job.sweep.swept[0].name,
		               t->cli.job.sweep.swept[0].values);
	}
	return TS_OK;
}

static void report_failure(const task *t, ts_status status)
{
	if (t->command != NULL && t->command->failed != NULL) t->command->failed(&t->cli, status);
}

/* Prints why there is no result, reports the failure to the command, and returns the exit code. */
static int end(const task *t, ts_status status)
{
	if (status != TS_ERROR && ts_file_print("", 0) != TS_OK) status = TS_ERROR;
	if (status == TS_ERROR || status == TS_SKIPPED) {
		fprintf(stderr, "%s: %s\n", ts_program, ts_error_message());
		report_failure(t, status);
	}
	return (int)status;
}

/* Drivers start programs by name; without a PATH, PoCL finds no linker and aborts. */
static void require_path(void)
{
	char path[256];
	if (getenv("PATH") == NULL && confstr(_CS_PATH, path, sizeof path) <= sizeof path) setenv("PATH", path, 1);
}

/* Opens the job's backend, unless it is that in C. A device that breaks the numeric contract is refused, except with
 * --inexact. */
static ts_status open_backend(ts_job *job)
{
	const ts_backend_kind *kind = job->backend;
	if (kind->open == NULL) return TS_OK;
	double begin = ts_seconds();
	ts_status status = kind->open(&job->how.backend, &job->device);
	if (status == TS_OK) status = ts_vectors_verify(job->how.backend, job->device.inexact);
	job->open_s = ts_seconds() - begin;
	return status == TS_SKIPPED && job->require ? TS_ERROR : status;
}

static int run(void *user)
{
	task *t = user;
	ts_cli *cli = &t->cli;
	require_path();
	if (cli->job.output.quiet) ts_listen(&(ts_listener){.line = NULL});
	ts_status status = ts_lanes_choose();
	if (status == TS_OK) status = open_backend(&cli->job); /* before there are threads: asking for devices forks */
	if (status == TS_OK && ts_command_takes(t->command, TS_OPTION_THREADS)) {
		u32 *n = &cli->job.how.threads;
		ts_threads_limit(*n);
		*n = ts_threads_all();
	}
	if (status == TS_SKIPPED && t->command->says_skipped) {
		snprintf(cli->no_device, sizeof cli->no_device, "%s", ts_error_message());
		status = TS_OK;
	}
	if (status == TS_OK) status = t->command->run(cli);
	if (cli->job.how.backend != NULL) cli->job.how.backend->close(cli->job.how.backend);
	return end(t, status);
}

/* A worker that could not report how it ended leaves the message to this process. The worker itself returns here,
 * too. */
static int run_worker(task *t)
{
	const pid_t own = getpid();
	ts_fail("%s", "");
	size_t kept = t->command->kept;
	if (kept > 0 && (t->cli.steps = ts_worker_memory(kept)) == NULL) return end(t, ts_fail("no memory for the worker"));
	int code = ts_worker_run(run, t, t->cli.steps, t->cli.worker.seconds, t->cli.worker.mib);
	if (getpid() == own && code == TS_ERROR && ts_error_message()[0] != 0) report_failure(t, TS_ERROR);
	return code;
}

int ts_cli_main(int argc, char **argv)
{
	/* A file-size limit fails the write instead of ending the process. */
	signal(SIGXFSZ, SIG_IGN);
	ts_cli_listen();
	task t = {.command = NULL};
	ts_status status = read_task(&t, argc, argv);
	if (status != TS_OK || t.command == NULL) return end(&t, status);
	if (!t.cli.worker.none) return run_worker(&t);
	if (t.cli.worker.seconds == 0 && t.cli.worker.mib == 0) return run(&t);
	return end(&t, ts_fail("--timeout, --memory: limits of the worker; leave --no-worker out"));
}

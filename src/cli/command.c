/* From argv to a command and an exit code; every failure becomes one line on standard error. */
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include "cli.h"

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
		ts_fail("no command \"%s\"; the nearest is %s, and \"%s help\" lists all", name, nearest.best, ts_program);
	}
	return found;
}

static ts_status run_with_backend(ts_cli *cli, const ts_command *command)
{
	ts_status status = ts_backend_open(&cli->job);
	if (status == TS_OK) status = command->run(cli);
	if (cli->job.how.backend != NULL) cli->job.how.backend->close(cli->job.how.backend);
	return status;
}

static ts_status run(int argc, char **argv)
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
	const ts_command *command = ts_cli_require(argv[1]);
	if (command == NULL) return TS_ERROR;
	ts_cli cli;
	ts_status status = ts_cli_parse(&cli, command, argc - 1, argv + 1);
	if (status == TS_OK && ts_cli_given(&cli, TS_OPT(HELP))) {
		ts_help_print(command);
	} else if (status == TS_OK && cli.job.sweep.n > 0 && strcmp(command->name, "render") != 0) {
		status = ts_fail("--set %s=%s: one value; only render takes lists", cli.job.sweep.swept[0].name,
		                 cli.job.sweep.swept[0].values);
	} else if (status == TS_OK) {
		status = run_with_backend(&cli, command);
	}
	return status;
}

int ts_cli_main(int argc, char **argv)
{
	/* A file-size limit shall fail the write, not end the process. */
	signal(SIGXFSZ, SIG_IGN);
	ts_status status = run(argc, argv);
	if ((fflush(stdout) != 0 || ferror(stdout)) && status != TS_ERROR) {
		status = ts_fail("standard output: cannot write; the disk may be full");
	}
	if (status == TS_ERROR || status == TS_SKIPPED) fprintf(stderr, "%s: %s\n", ts_program, ts_error_message());
	return (int)status;
}

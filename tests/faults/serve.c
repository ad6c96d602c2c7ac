/* One process for each case, forked when all libraries are loaded and main has not begun. In the current folder,
 * `before` holds what the command finds where it runs, in `work`. It runs undisturbed first: that makes `after`, and
 * `said`. Then a case is good if the command
 *   ends as it did undisturbed, having left and printed the same; or
 *   ends with 2, its last line on standard error naming the cause, or saying TOUCHSTONE_FAULT_SAYS, and everything
 *   being as it was before, or complete; but no interruption ends a command; or
 *   is ended by a library that says one of TOUCHSTONE_FAULT_ENDS, of which "no end" is that it waits.
 * Bad cases are lines `bad N: WHY`, the last line is `TRIED BAD`. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#include "tests/faults/fault.h"
#include "tests/faults/tree.h"

enum { LIMIT_MS = 30000, MAX_WHY = 2 * TS_MAX_PATH };

static struct {
	ts_fault_kind kind;
	bool on;
	int usual; /* the exit code of the undisturbed command */
	char why[MAX_WHY];
} serve;

static void redirect(int to, const char *path)
{
	int file = open(path, to == 0 ? O_RDONLY : O_WRONLY | O_CREAT | O_TRUNC, 0666);
	if (file < 0 || dup2(file, to) != to) _exit(3);
	close(file);
}

static void begin_case(long at)
{
	setpgid(0, 0);
	redirect(0, "/dev/null");
	redirect(1, "stdout");
	redirect(2, "stderr");
	if (chdir("work") != 0) _exit(3);
	ts_fault_arm(serve.kind, serve.on, at);
}

/* How it ended, as wait tells it; -1: not in time. No process that it made may outlive it. */
static int wait_for(pid_t child, bool *left)
{
	int status = -1;
	struct pollfd end = {.fd = (int)syscall(SYS_pidfd_open, child, 0), .events = POLLIN};
	bool ended = end.fd >= 0 && poll(&end, 1, LIMIT_MS) == 1;
	if (!ended) kill(-child, SIGKILL);
	waitpid(child, &status, 0);
	*left = kill(-child, SIGKILL) == 0;
	close(end.fd);
	return ended ? status : -1;
}

static void last_line(const char *path, char *line)
{
	size_t bytes = 0;
	char *text = ts_tree_read(path, &bytes);
	while (bytes > 0 && text[bytes - 1] == '\n') text[--bytes] = 0;
	const char *from = bytes > 0 ? strrchr(text, '\n') : NULL;
	snprintf(line, TS_MAX_PATH, "%s", from != NULL ? from + 1 : bytes > 0 ? text : "");
	free(text);
}

/* The same trees, but for what is said to be left. */
static bool is_tree(const char *name)
{
	size_t n;
	char *errors = ts_tree_read("stderr", &n);
	ts_tree_told(errors);
	bool same = ts_tree_same(name, "work", serve.why);
	ts_tree_told(NULL);
	free(errors);
	return same;
}

static bool as_undisturbed(void)
{
	size_t n, m;
	char *said = ts_tree_read("said", &n), *stdout_ = ts_tree_read("stdout", &m);
	bool same = ts_tree_same_words(said, stdout_);
	free(said);
	free(stdout_);
	if (!same) snprintf(serve.why, MAX_WHY, "stdout: other text");
	return same && is_tree("after");
}

/* One of the texts of a variable, with bars between them. */
static bool is_said(const char *line, const char *variable)
{
	const char *says = getenv(variable);
	while (says != NULL && *says != 0) {
		size_t n = strcspn(says, "|");
		if (memmem(line, strlen(line), says, n) != NULL) return true;
		says += n + (says[n] == '|');
	}
	return false;
}

/* Where a library ended the run, it says why in lines above ours. */
static bool names_the_cause(const char *line)
{
	const ts_fault_row *row = &ts_fault_rows[serve.kind];
	if (row->error == 0) return false;
	size_t n;
	char *errors = ts_tree_read("stderr", &n);
	bool library = strstr(line, "a library ended") != NULL || strstr(line, "by signal 6") != NULL;
	const char *in = library && errors != NULL ? errors : line;
	bool named = strstr(in, row->cause) != NULL || strstr(in, strerror(row->error)) != NULL;
	free(errors);
	return named;
}

/* What it wrote may be complete when a later call fails. Libraries may abort, but nothing may crash. */
static bool failed_well(const char *line)
{
	bool crashed = strstr(line, "by signal") != NULL && strstr(line, "by signal 6") == NULL;
	bool told = is_said(line, "TOUCHSTONE_FAULT_SAYS") || (names_the_cause(line) && !crashed);
	if (strncmp(line, "touchstone: ", 12) == 0 && told) {
		return is_tree("after") || is_tree("before");
	}
	snprintf(serve.why, MAX_WHY, "exit 2, not for the cause: %s", line);
	return false;
}

static bool ended_by_library(void)
{
	size_t n;
	char *errors = ts_tree_read("stderr", &n);
	bool ended = is_said(errors, "TOUCHSTONE_FAULT_ENDS");
	free(errors);
	return ended;
}

static bool is_good(int status, bool left)
{
	char line[TS_MAX_PATH];
	last_line("stderr", line);
	serve.why[0] = 0;
	if (left) {
		snprintf(serve.why, MAX_WHY, "a process is left");
	} else if (status == -1 && is_said("no end", "TOUCHSTONE_FAULT_ENDS")) {
		return true;
	} else if (status == -1) {
		snprintf(serve.why, MAX_WHY, "no end in %d s", LIMIT_MS / 1000);
	} else if ((WIFSIGNALED(status) || WEXITSTATUS(status) != serve.usual) && ended_by_library()) {
		return true;
	} else if (WIFSIGNALED(status)) {
		snprintf(serve.why, MAX_WHY, "signal %d: %s", WTERMSIG(status), line);
	} else if (WEXITSTATUS(status) == serve.usual) {
		return as_undisturbed();
	} else if (WEXITSTATUS(status) == 2 && serve.kind != TS_INTERRUPT) {
		return failed_well(line);
	} else {
		snprintf(serve.why, MAX_WHY, "exit %d: %s", WEXITSTATUS(status), line);
	}
	return false;
}

/* Returns true in the process of the case, whose fault is armed; else the case has ended. */
static bool run_case(long at, int *status, bool *left)
{
	ts_tree_remove("work");
	ts_tree_copy("before", "work");
	pid_t child = fork();
	if (child < 0) exit(3);
	if (child == 0) {
		begin_case(at);
		return true;
	}
	*status = wait_for(child, left);
	return false;
}

/* Twice, to know that it does the same. */
static bool run_undisturbed(void)
{
	int status;
	bool left;
	for (int i = 0; i < 2; i++) {
		if (run_case(0, &status, &left)) return true;
		bool could = WIFEXITED(status) && WEXITSTATUS(status) <= 1 && !left;
		serve.usual = WEXITSTATUS(status);
		if (could && i == 0) {
			if (rename("work", "after") != 0 || rename("stdout", "said") != 0) exit(3);
		} else if (!could || !is_good(status, left)) {
			if (!could) last_line("stderr", serve.why);
			printf("bad 0: undisturbed, status %d: %s\n1 1\n", status, serve.why);
			exit(1);
		}
	}
	return false;
}

void ts_serve(const char *cases)
{
	long first = 1, step = 1, last = 0, tried = 0, bad = 0;
	const char *range = ts_fault_parse(cases, &serve.kind, &serve.on);
	if (range == NULL || sscanf(range, "%ld:%ld:%ld", &first, &step, &last) < 1 || step < 1) exit(3);
	unsetenv("TOUCHSTONE_FAULTS");
	ts_tree_remove("after");
	if (run_undisturbed()) return;
	for (long at = first; last == 0 || at <= last; at += step) {
		int status;
		bool left;
		if (run_case(at, &status, &left)) return;
		if (!ts_fault_was()) break;
		tried++;
		if (is_good(status, left)) continue;
		bad++;
		printf("bad %ld: %s\n", at, serve.why);
		fflush(stdout);
	}
	printf("%ld %ld\n", tried, bad);
	fflush(stdout);
	exit(bad > 0);
}

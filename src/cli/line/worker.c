/* Two processes: the worker, and its parent, which waits; and those that the worker starts. */
#define _GNU_SOURCE
#include "cli/line/worker.h"
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include "cli/line/cli.h"
#include "output/left.h"

/* Signals meant for the command, which dies of them. */
static const int passed_on[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE};
enum { N_PASSED_ON = sizeof passed_on / sizeof *passed_on };

/* How the worker ended, in shared memory. */
typedef struct {
	volatile bool ended;
	volatile int code;
} word;

typedef struct {
	int status; /* from waitpid */
	bool late;
} end;

static bool is_passed_on(int number)
{
	for (int i = 0; i < N_PASSED_ON; i++) {
		if (passed_on[i] == number) return true;
	}
	return false;
}

static sigset_t awaited(void)
{
	sigset_t set;
	sigemptyset(&set);
	sigaddset(&set, SIGCHLD);
	for (int i = 0; i < N_PASSED_ON; i++) sigaddset(&set, passed_on[i]);
	return set;
}

/* `set` must be blocked. */
static end wait_for(pid_t worker, const sigset_t *set, const ts_steps *steps, uint32_t seconds)
{
	end e = {.late = false};
	while (waitpid(worker, &e.status, WNOHANG) != worker) {
		double left = steps->began + seconds - ts_seconds();
		struct timespec time = {left > 0 ? (time_t)left : 0, left > 0 ? (long)(1e9 * (left - (time_t)left)) : 0};
		int number = sigtimedwait(set, NULL, seconds != 0 && !e.late ? &time : &(struct timespec){3600, 0});
		if (is_passed_on(number)) kill(worker, number);
		e.late |= seconds != 0 && ts_seconds() >= steps->began + seconds;
		if (e.late) kill(worker, SIGKILL);
	}
	return e;
}

/* Where the kernel lists this process's children. */
static const char *const children = "/proc/thread-self/children";

/* What the worker starts comes to this process when the worker ends. Not where there are children that somebody else
 * started before this program: theirs would come, too. */
static bool adopt(void)
{
	FILE *list = fopen(children, "r");
	bool none = list != NULL && fgetc(list) == EOF;
	if (list != NULL) fclose(list);
	return none && prctl(PR_SET_CHILD_SUBREAPER, 1) == 0;
}

/* Ends what a lost worker has started, and what that has. */
static void end_adopted(void)
{
	do {
		long child;
		FILE *list = fopen(children, "r");
		if (list == NULL) return;
		while (fscanf(list, "%ld", &child) == 1) kill((pid_t)child, SIGKILL);
		fclose(list);
	} while (waitpid(-1, NULL, 0) > 0);
}

static int say(const char *format, ...) __attribute__((format(printf, 1, 2)));
static int say(const char *format, ...)
{
	va_list arguments;
	va_start(arguments, format);
	ts_fail_v(format, arguments);
	va_end(arguments);
	fprintf(stderr, "%s%s: %s\n", isatty(STDERR_FILENO) ? "\r\033[K" : "", ts_program, ts_error_message());
	return TS_ERROR;
}

static bool has_used_its_seconds(void)
{
	struct rlimit limit;
	struct rusage used;
	if (getrlimit(RLIMIT_CPU, &limit) != 0 || getrusage(RUSAGE_CHILDREN, &used) != 0) return false;
	return limit.rlim_max != RLIM_INFINITY &&
	       (rlim_t)(used.ru_utime.tv_sec + used.ru_stime.tv_sec) + 1 >= limit.rlim_max;
}

/* Why the worker was lost; "": it was not, or somebody sent it a signal. */
static void find_why(char *why, size_t room, end e, const word *ending, uint32_t seconds)
{
	int number = WIFSIGNALED(e.status) ? WTERMSIG(e.status) : 0;
	why[0] = 0;
	if (e.late) {
		snprintf(why, room, "stopped after %u s, as --timeout asks", (unsigned)seconds);
	} else if (number == 0 && !(ending->ended && WEXITSTATUS(e.status) == ending->code)) {
		snprintf(why, room, "a library ended the run with exit code %d, for want of memory or threads",
		         WEXITSTATUS(e.status));
	} else if (number == SIGKILL && has_used_its_seconds()) {
		snprintf(why, room, "the run was killed at its limit of processor time (ulimit -t)");
	} else if (number == SIGKILL) {
		snprintf(why, room, "the run was killed, as systems do where memory ends");
	} else if (number != 0 && !is_passed_on(number)) {
		snprintf(why, room, "the run ended by signal %d, %s, perhaps for want of memory or threads", number,
		         strsignal(number));
	}
}

/* The worker's exit code, or the signal that killed it. */
static int conclude(end e, const word *ending)
{
	if (WIFEXITED(e.status)) return ending->code;
	int number = WTERMSIG(e.status);
	sigset_t own;
	sigemptyset(&own);
	sigaddset(&own, number);
	signal(number, SIG_DFL);
	raise(number);
	sigprocmask(SIG_UNBLOCK, &own, NULL);
	return TS_ERROR;
}

static int work_alone(int (*work)(void *user), void *user, word *ending, uint32_t mib)
{
	const rlim_t bytes = (rlim_t)mib << 20;
	if (mib != 0 && setrlimit(RLIMIT_AS, &(struct rlimit){bytes, bytes}) != 0) {
		return say("--memory %u: %s", (unsigned)mib, strerror(errno));
	}
	int code = work(user);
	ending->code = code;
	ending->ended = true;
	return code;
}

void *ts_worker_memory(size_t bytes)
{
	void *memory = mmap(NULL, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
	return memory != MAP_FAILED ? memory : NULL;
}

int ts_worker_run(int (*work)(void *user), void *user, ts_steps *steps, uint32_t seconds, uint32_t mib)
{
	char why[sizeof steps->why] = "";
	word *ending = ts_worker_memory(sizeof *ending);
	if (steps == NULL) steps = ts_worker_memory(sizeof *steps);
	if (ending == NULL || steps == NULL || ts_left_share() != TS_OK)
		return say("no memory for what two processes share");
	sigset_t before, set = awaited();
	const bool adopts = adopt();
	pid_t parent = getpid(), worker;
	sigprocmask(SIG_BLOCK, &set, &before);
	do {
		memcpy(steps->why, why, sizeof why);
		steps->lost_s = ts_seconds() - steps->began;
		steps->at_work = ending->ended = false;
		steps->began = ts_seconds();
		worker = fork();
		if (worker <= 0) break;
		end e = wait_for(worker, &set, steps, seconds);
		if (adopts && !ending->ended) end_adopted();
		ts_left_clear();
		find_why(why, sizeof why, e, ending, seconds);
		if (why[0] == 0) return conclude(e, ending);
	} while (steps->at_work);
	if (worker > 0) return say("%s; no result", why);
	sigprocmask(SIG_SETMASK, &before, NULL);
	if (worker < 0) return say("cannot start a process: %s; --no-worker does without", strerror(errno));
	prctl(PR_SET_PDEATHSIG, SIGKILL);
	if (getppid() != parent) raise(SIGKILL);
	return work_alone(work, user, ending, mib);
}

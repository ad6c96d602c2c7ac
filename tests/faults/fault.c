/* What fails, and when. */
#define _GNU_SOURCE
#include "tests/faults/fault.h"
#include <dlfcn.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

/* clang-format off */
const ts_fault_row ts_fault_rows[TS_N_KINDS] = {
	[TS_MEMORY] = {"memory", ENOMEM, "memory"},
	[TS_OWN] = {"own", ENOMEM, "memory"},
	[TS_LOAD] = {"load", ENOMEM, "memory"},
	[TS_MAP] = {"map", ENOMEM, "memory"},
	[TS_THREAD] = {"thread", EAGAIN, "threads"},
	[TS_PROCESS] = {"process", EAGAIN, "Resource temporarily unavailable"},
	[TS_OPEN] = {"open", EMFILE, "Too many open files"},
	[TS_READ] = {"read", EIO, "Input/output error"},
	[TS_WRITE] = {"write", ENOSPC, "No space left on device"},
	[TS_SHORT] = {"short", 0, NULL},
	[TS_INTERRUPT] = {"interrupt", EINTR, NULL},
	[TS_FSYNC] = {"fsync", EIO, "Input/output error"},
	[TS_RENAME] = {"rename", EIO, "Input/output error"},
	[TS_UNLINK] = {"unlink", EIO, "Input/output error"},
	[TS_MKDIR] = {"mkdir", ENOSPC, "No space left on device"},
	[TS_LOCK] = {"lock", ENOLCK, "No locks available"},
	[TS_KILL] = {"kill", 0, NULL},
};
/* clang-format on */

static struct {
	ts_fault_kind kind;
	bool armed, on;
	long at;
} fault;

/* What processes share. */
static struct {
	long count;
	bool hit;
} * seen;

const char *ts_fault_parse(const char *text, ts_fault_kind *kind, bool *on)
{
	size_t n = strcspn(text, "+:");
	for (int i = 0; i < TS_N_KINDS; i++) {
		if (strlen(ts_fault_rows[i].name) != n || strncmp(text, ts_fault_rows[i].name, n) != 0) continue;
		*kind = i;
		*on = text[n] == '+';
		return text + n + *on + (text[n + *on] == ':');
	}
	fprintf(stderr, "fault: no such kind: %s\n", text);
	return NULL;
}

void ts_fault_arm(ts_fault_kind kind, bool on, long at)
{
	seen->count = 0;
	seen->hit = false;
	fault.kind = kind;
	fault.on = on;
	fault.at = at;
	ts_calls_watch(kind);
	fault.armed = getenv("TOUCHSTONE_FAULT_WAITS") == NULL;
}

void ts_fault_begin(void) { fault.armed = true; }

void ts_fault_end(void) { fault.armed = false; }

bool ts_fault_watches(ts_fault_kind kind) { return fault.armed && kind == fault.kind; }

bool ts_fault_is(ts_fault_kind kind)
{
	if (!ts_fault_watches(kind)) return false;
	long n = __atomic_add_fetch(&seen->count, 1, __ATOMIC_RELAXED);
	if (n != fault.at && !(fault.on && fault.at > 0 && n > fault.at)) return false;
	seen->hit = true;
	errno = ts_fault_rows[kind].error;
	return true;
}

bool ts_fault_was(void) { return seen->hit; }

__attribute__((destructor)) static void write_count(void)
{
	const char *path = getenv("TOUCHSTONE_FAULT_COUNT");
	if (seen == NULL || path == NULL) return;
	fault.armed = false;
	FILE *file = fopen(path, "w");
	if (file == NULL) return;
	fprintf(file, "%ld\n", seen->count);
	fclose(file);
}

static int (*command)(int, char **, char **);

static int begin(int argc, char **argv, char **environment)
{
	const char *cases = getenv("TOUCHSTONE_FAULTS"), *one = getenv("TOUCHSTONE_FAULT");
	ts_fault_kind kind;
	bool on;
	seen = mmap(NULL, sizeof *seen, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
	if (seen == MAP_FAILED) abort();
	unsetenv("LD_PRELOAD");
	if (cases != NULL) {
		ts_serve(cases);
	} else if (one != NULL) {
		const char *at = ts_fault_parse(one, &kind, &on);
		if (at == NULL) return 2;
		ts_fault_arm(kind, on, atol(at));
	}
	return command(argc, argv, environment);
}

int __libc_start_main(int (*main)(int, char **, char **), int argc, char **argv, void (*init)(void), void (*fini)(void),
                      void (*end)(void), void *stack)
{
	__typeof__(&__libc_start_main) next = (__typeof__(&__libc_start_main))dlsym(RTLD_NEXT, "__libc_start_main");
	command = main;
	return next(begin, argc, argv, init, fini, end, stack);
}

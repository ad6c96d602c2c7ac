/* Faults from outside: a library to be preloaded, in which the N-th call of a kind fails, in the command or in any
 * library below it, counted from the begin of main over all threads and processes of the command. Linux on x86-64.
 *   TOUCHSTONE_FAULT=KIND:N        that call fails; with KIND+ so do all after it; with 0 all are counted only; of the
 *                                  kind `kill`, the calls that change the disk, the process dies instead
 *   TOUCHSTONE_FAULT_MOVES=yes     and the file system cannot exchange folders
 *   TOUCHSTONE_FAULT_WAITS=yes     calls count between ts_fault_begin and ts_fault_end alone
 *   TOUCHSTONE_FAULT_COUNT=FILE    how many there were, written at the end
 *   TOUCHSTONE_FAULTS=KIND:N:STEP:LAST  runs the command for N, N + STEP, ... until none is left, or LAST (serve.c) */
#ifndef TS_TESTS_FAULTS_FAULT_H
#define TS_TESTS_FAULTS_FAULT_H
#include <stdbool.h>

typedef enum {
	TS_MEMORY,
	TS_OWN,
	TS_LOAD,
	TS_MAP,
	TS_THREAD,
	TS_PROCESS,
	TS_OPEN,
	TS_READ,
	TS_WRITE,
	TS_SHORT,
	TS_INTERRUPT,
	TS_FSYNC,
	TS_RENAME,
	TS_UNLINK,
	TS_MKDIR,
	TS_LOCK,
	TS_KILL,
	TS_N_KINDS
} ts_fault_kind;

/* A kind, its error (0: none), and what a message of it must say. */
typedef struct {
	const char *name;
	int error;
	const char *cause;
} ts_fault_row;

extern const ts_fault_row ts_fault_rows[TS_N_KINDS];

/* What fails, of `KIND[+]:...`; what follows the colon, or NULL if there is no such kind. */
const char *ts_fault_parse(const char *text, ts_fault_kind *kind, bool *on);
/* From here on calls count. */
void ts_fault_arm(ts_fault_kind kind, bool on, long at);
/* With TOUCHSTONE_FAULT_WAITS the command itself says from where to where they count. */
void ts_fault_begin(void);
void ts_fault_end(void);
/* Whether calls of the kind count. */
bool ts_fault_watches(ts_fault_kind kind);
/* Counts a call of the kind; whether it is to fail, with errno set. */
bool ts_fault_is(ts_fault_kind kind);
/* Whether a call has failed since it was armed. */
bool ts_fault_was(void);

/* System calls of a kind come by here first, those of libraries and of the C library itself too. */
void ts_calls_watch(ts_fault_kind kind);

/* Runs the cases, one process each. Returns in those; the process itself ends with 1 if any was bad. */
void ts_serve(const char *cases);

#endif

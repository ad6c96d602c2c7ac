/* Errors, memory, threads and messages, for all folders. */
#ifndef TS_MODEL_CORE_H
#define TS_MODEL_CORE_H
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

#define TS_DOTTED_TEXT(a, b, c) #a "." #b "." #c
#define TS_DOTTED(a, b, c) TS_DOTTED_TEXT(a, b, c)
#define TS_VERSION TS_DOTTED(TS_VERSION_MAJOR, TS_VERSION_MINOR, TS_VERSION_PATCH)
/* The version of the numeric contract, reference/CONTRACT.md. */
#define TS_CONTRACT_VERSION 1

/* Sets this thread's message to one line (by ts_line_clean) and returns TS_ERROR. A line that ends with the last
 * message tells more of that failure and keeps its kind; any other is of TS_KIND_ARGUMENT. */
ts_status ts_fail(const char *format, ...) __attribute__((format(printf, 1, 2)));
ts_status ts_fail_v(const char *format, va_list arguments);
/* As ts_fail, of a kind. */
ts_status ts_fail_as(ts_kind kind, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* Returns status. If that is a failure of TS_KIND_ARGUMENT, the failure is now of another kind. */
ts_status ts_blame(ts_status status, ts_kind kind);
/* As ts_fail, for data from outside that cannot be accepted: with other data the call would succeed. */
ts_status ts_refuse(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* Whether ts_refuse set this thread's last message. */
bool ts_refused(void);

/* Whether an argument of a public function is NULL; the message names the function and the argument. */
#define TS_LACKS(argument) ts_lacks(__func__, #argument, argument)
bool ts_lacks(const char *function, const char *name, const void *argument);

/* Makes one line of any text that is to be printed: control characters, C0 and the C1 of UTF-8, could break the line or
 * drive the terminal; each of their bytes becomes '?'. */
void ts_line_clean(char *text);

/* count * size bytes; NULL with the message set if that overflows or there is no memory. Zero bytes give a valid
 * pointer. `what` names the contents in the message. */
void *ts_alloc(size_t count, size_t size, const char *what);
void *ts_alloc_zero(size_t count, size_t size, const char *what);
/* Asks for large pages for memory that is used throughout: fewer page faults at first writes, fewer page-table walks at
 * random writes. */
void ts_memory_large_pages(void *memory, size_t bytes);
/* Grows *array (of *capacity elements) to hold at least `need`, at least doubling. */
ts_status ts_grow(void **array, size_t *capacity, size_t need, size_t size, const char *what);

/* Bytes of this process in memory: those of files, such as libraries, and allocated ones that are not released. */
uint64_t ts_memory_used(void);
/* As ts_memory_used, with released bytes that the process keeps. */
uint64_t ts_memory_resident(void);
/* Memory that this process can have, in bytes: of the machine, of its control group, and what its own limits (ulimit -v
 * and -d) had left when this was asked first. */
uint64_t ts_memory_total(void);
/* Bytes that one run may use: three quarters of ts_memory_total. */
uint64_t ts_memory_limit(void);

/* Verifies that this process computes as the numeric contract says (rule 8): 0, or a bit per failing primitive. */
unsigned ts_selftest(void);
/* As ts_selftest; fails with a message that names the failing primitives. */
ts_status ts_selftest_require(void);
/* As ts_selftest_require, on so many threads, which must be ready (ts_threads_ready). */
ts_status ts_selftest_require_on(uint32_t threads);

/* Receives messages and progress, and may cancel long work. A member that is NULL is not called. */
typedef struct {
	void (*line)(void *user, const char *text); /* `text`: a line without its end */
	void (*progress)(void *user, const char *label, uint64_t done, uint64_t total);
	int (*cancelled)(void *user); /* not 0: the running work is to fail */
	void *user;
} ts_listener;
/* Sets the listener of this thread, at first one without functions. Returns the listener before. */
ts_listener ts_listen(const ts_listener *listener);
/* Whether this thread's listener cancels the running work: asks it, unless it has said so since ts_listen. */
bool ts_cancelled(void);
/* Fails if this thread's listener has cancelled the running work; asks nobody. */
ts_status ts_go_on(void);
/* The work of this thread, for the threads of a loop; NULL if nobody can cancel it. */
typedef struct ts_stop ts_stop;
ts_stop *ts_stop_here(void);
/* Whether that work is cancelled: then the items of a loop that are left are skipped. Only the thread of ts_stop_here
 * asks its listener, every few milliseconds; it costs little beside an item. */
bool ts_stopped(ts_stop *stop);
/* Sends the listener one line, cleaned by ts_line_clean. */
void ts_say(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* Progress of long work: done of total. Ends with done == total. */
void ts_progress(const char *label, uint64_t done, uint64_t total);

/* The most threads that anything may ask for. */
enum { TS_MOST_THREADS = 1024 };
/* Makes up to `wanted` threads ready, this one among them, and returns how many there are, at least 1; a line says so
 * where they are fewer. One in the child of a fork by a thread that had others: it goes on without them. */
uint32_t ts_threads_ready(uint32_t wanted);
/* The processors of this machine. */
uint32_t ts_processors(void);
/* The most threads that ts_threads_all gives this thread; 0, as at first: one a processor. Returns the one before. */
uint32_t ts_threads_limit(uint32_t most);
/* As ts_threads_ready, with as many threads as that allows. */
uint32_t ts_threads_all(void);

/* As ts_threads_ready; until ts_floats_give these threads compute without traps, whatever their host has set, and this
 * one sets no exceptions in its host's environment. Holds nest. */
uint32_t ts_floats_hold(uint32_t threads);
/* Gives these threads the environments that they had. */
void ts_floats_give(void);

/* The commit that the program was built from, with "-dirty" behind it if its source was changed since; or "unknown". */
const char *ts_commit(void);

/* Seconds of a monotonic clock. */
double ts_seconds(void);

#ifdef __cplusplus
}
#endif
#endif

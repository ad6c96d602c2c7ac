/* Errors, memory, what is said: what every folder needs. */
#ifndef TS_CORE_CORE_H
#define TS_CORE_CORE_H
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

#define TS_VERSION "0.1.0"
/* Of the numeric contract, reference/CONTRACT.md. */
#define TS_CONTRACT_VERSION 1

/* Sets this thread's message to one line (by ts_line_clean) and returns TS_ERROR. */
ts_status ts_fail(const char *format, ...) __attribute__((format(printf, 1, 2)));
ts_status ts_fail_v(const char *format, va_list arguments);
/* The same where data from outside is to blame: nothing failed, and other data would do. */
ts_status ts_refuse(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* Whether this thread's last failure was such a refusal. */
bool ts_refused(void);

/* Whether an argument of a public function is NULL; the message names both. */
#define TS_LACKS(argument) ts_lacks(__func__, #argument, argument)
bool ts_lacks(const char *function, const char *name, const void *argument);

/* Makes one line of any text that is to be printed: control characters, C0 and the C1 of UTF-8, could break the line or
 * drive the terminal; each of their bytes becomes '?'. */
void ts_line_clean(char *text);

/* count * size bytes; NULL with the message set if that overflows or there is no memory. Zero bytes give a valid
 * pointer. `what` names the contents in the message. */
void *ts_alloc(size_t count, size_t size, const char *what);
void *ts_alloc_zero(size_t count, size_t size, const char *what);
/* Asks for large pages, for memory that is touched all over: fewer faults where it is first written, fewer walks where
 * it is written at random. */
void ts_memory_large_pages(void *memory, size_t bytes);
/* Grows *array (of *capacity elements) to hold at least `need`, at least doubling. */
ts_status ts_grow(void **array, size_t *capacity, size_t need, size_t size, const char *what);

/* All of a regular file, which is untrusted, and a 0 behind it, by free(). NULL with the message set: it cannot be
 * read, or is larger than a third of the machine's memory. */
char *ts_input_read(size_t *bytes, const char *path);

/* Bytes that this process has in memory: of files, such as libraries, and what it allocated, without what it
 * released. */
uint64_t ts_memory_used(void);
/* The same with what it released and keeps. */
uint64_t ts_memory_resident(void);
/* Memory that this process can have, in bytes: of the machine, of its control group, and what its own limits (ulimit -v
 * and -d) had left when this was asked first. */
uint64_t ts_memory_total(void);
/* What one run may use of it: three quarters. */
uint64_t ts_memory_limit(void);

/* Verifies that this process computes as the numeric contract says (rule 8): 0, or a bit per failing primitive. */
unsigned ts_selftest(void);
/* The same as a status with a message that names the primitives. */
ts_status ts_selftest_require(void);
/* The same of so many threads, which must be ready. */
ts_status ts_selftest_require_on(uint32_t threads);

/* Who hears what is said beside results and failures, and may end what takes long. NULL: nobody. */
typedef struct {
	void (*line)(void *user, const char *text); /* without its end */
	void (*progress)(void *user, const char *label, uint64_t done, uint64_t total);
	int (*cancelled)(void *user); /* not 0: what runs is to fail */
	void *user;
} ts_listener;
/* Of this thread; without it nothing is heard. Returns who listened before. */
ts_listener ts_listen(const ts_listener *listener);
/* Whether the listener wants no more of what runs. */
bool ts_cancelled(void);
/* One line, by ts_line_clean. */
void ts_say(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* Progress of long work: done of total. Ends with done == total. */
void ts_progress(const char *label, uint64_t done, uint64_t total);

/* The most threads that anything may ask for. */
enum { TS_MOST_THREADS = 1024 };
/* So many of these threads, at least 1, can be had, this one among them; says so where they are fewer. */
uint32_t ts_threads_ready(uint32_t wanted);
/* The same of one a processor. */
uint32_t ts_threads_all(void);

/* The commit that the program was built from, with "-dirty" behind it if its source was changed since; or "unknown". */
const char *ts_commit(void);

/* Seconds of a monotonic clock. */
double ts_seconds(void);

#ifdef __cplusplus
}
#endif
#endif

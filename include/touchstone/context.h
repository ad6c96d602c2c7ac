/* A context: what computes, and who hears of it. */
#ifndef TOUCHSTONE_CONTEXT_H
#define TOUCHSTONE_CONTEXT_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef struct ts_context ts_context;

/* Options of a context. Only `bytes` must be set; 0 is the default of each other member. */
typedef struct {
	size_t bytes;        /* sizeof(ts_context_options) */
	const char *backend; /* a name of ts_backend_at; NULL: "c" */
	uint32_t device;     /* of that backend, from 0 */
	uint32_t threads;    /* of the backend "c", at most 1024; 0: one a processor. They never change a result */
	int no_fast_paths;   /* not 0: the backend "c" takes none; they never change a result either */
	void *user;          /* handed to the calls below, which may be NULL and must not call the library */
	void (*say)(void *user, const char *line); /* a line without its end, beside results and failures */
	void (*progress)(void *user, const char *label, uint64_t done, uint64_t total); /* ends with done == total */
	int (*cancelled)(void *user); /* asked between stages and between groups of rays; not 0: what runs fails soon */
} ts_context_options;

/* Opens a context; options NULL: all defaults. The options are copied, strings too. Release it by ts_context_close;
 * NULL on failure. TS_SKIPPED: there is no device of that backend. TS_ERROR: a device, or this process, whose
 * arithmetic breaks the numeric contract, is refused. */
TS_API ts_status ts_context_open(ts_context **context, const ts_context_options *options);

/* Releases a context, behind all traces that it made; NULL is allowed. */
TS_API void ts_context_close(ts_context *context);

/* Backend i of all that this library was built with, from 0; NULL behind the last. */
TS_API const char *ts_backend_at(size_t i);

/* "0.1.0": of the library that runs, which may be newer than these headers. */
TS_API const char *ts_version(void);

#ifdef __cplusplus
}
#endif
#endif

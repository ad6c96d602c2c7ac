/* SPDX-License-Identifier: Apache-2.0 */
/* A context: the backend that computes, and the functions that hear of the work. */
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
	uint32_t threads;    /* of the backend "c", at most 1024; 0: one per processor. They never change a result */
	int no_fast_paths;   /* not 0: the backend "c" takes no fast paths, which never change a result either */
	void *user;          /* passed to the functions below. They may be NULL. They must return: neither exceptions nor
	                      * longjmp may leave them, and they must not call the library. Where one does, functions with
	                      * a context fail on this thread: at once, or from then on where it never returned */
	void (*say)(void *user, const char *line); /* a line without its end, beside results and failures */
	void (*progress)(void *user, const char *label, uint64_t done, uint64_t total); /* ends with done == total */
	int (*cancelled)(void *user); /* asked by the thread that called, every few ms while the backend "c" or the
	                               * processor works, and between stages of the others; not 0: the call fails soon,
	                               * by TS_KIND_CANCELLED */
} ts_context_options;

/* Opens a context. The options are copied, strings too.
 * In: options NULL: all defaults.
 * Out: *context is to be released by ts_context_close; NULL on failure.
 * Returns: TS_SKIPPED if there is no device of that backend, TS_ERROR if the arithmetic of the device, or of this
 * process, breaks the numeric contract. */
TS_API ts_status ts_context_open(ts_context **context, const ts_context_options *options);

/* Releases a context. Release all traces that it made before; NULL is allowed. */
TS_API void ts_context_close(ts_context *context);

/* Backend i, from 0, of those that this library was built with; NULL behind the last. */
TS_API const char *ts_backend_at(size_t i);

/* A device of a backend. Only `bytes` must be set before. */
typedef struct {
	size_t bytes; /* sizeof(ts_device_info) */
	char name[128];
	int rounded;           /* not 0: divides and takes roots with correct rounding */
	int denormals;         /* not 0: keeps them; exact either way */
	int atomics;           /* not 0: has atomics of 64 bits */
	uint64_t memory, most; /* bytes in all; of one buffer */
} ts_device_info;

/* Describes device i of a backend, from 0. TS_SKIPPED: it has no more, or no driver is there. TS_ERROR: a driver is
 * there and fails, as where memory ends. */
TS_API ts_status ts_device_at(ts_device_info *device, const char *backend, uint32_t i);

/* The version of the library that runs, "0.1.0", which may be newer than these headers. */
TS_API const char *ts_version(void);

#ifdef __cplusplus
}
#endif
#endif

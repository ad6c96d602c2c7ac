/* SPDX-License-Identifier: Apache-2.0 */
/* How every function of the library reports success and failure. */
#ifndef TOUCHSTONE_STATUS_H
#define TOUCHSTONE_STATUS_H
#ifdef __cplusplus
extern "C" {
#endif

/* Marks every function of these headers, and nothing else: what the shared library exports. */
#if defined(__GNUC__)
#define TS_API __attribute__((visibility("default")))
#else
#define TS_API
#endif

/* The version of these headers; ts_version() is that of the library. */
#define TS_VERSION_MAJOR 0
#define TS_VERSION_MINOR 1
#define TS_VERSION_PATCH 0

/* Also the exit codes of the command. */
typedef enum {
	TS_OK = 0,        /* same, or done */
	TS_DIFFERENT = 1, /* compared and different */
	TS_ERROR = 2,     /* failed; ts_error_message() says what, where, and what would be right */
	TS_SKIPPED = 77,  /* an optional backend is absent, or does not open */
} ts_status;

/* Kinds of failures. A program that acts on a failure asks for its kind, and not for the words of its message. */
typedef enum {
	TS_KIND_NONE,      /* nothing has failed */
	TS_KIND_ARGUMENT,  /* what the call was given, or its combination: any failure that is none of the following */
	TS_KIND_FILE,      /* a file or folder is absent, or cannot be read or written */
	TS_KIND_FORMAT,    /* the contents of a file, or of bytes in memory that stand for one */
	TS_KIND_MEMORY,    /* the memory that the work needs is not there, or is more than the work may use */
	TS_KIND_DEVICE,    /* the device or its driver is absent, failed, or breaks the numeric contract */
	TS_KIND_LIBRARY,   /* a library that is opened when it is needed, such as Embree, is absent */
	TS_KIND_CANCELLED, /* the context's `cancelled` said so */
} ts_kind;

/* The last failure of this thread as one line without a line end; "" if there was none.
 * The text belongs to the library and lives until the thread's next failure. */
TS_API const char *ts_error_message(void);

/* The kind of that failure. */
TS_API ts_kind ts_error_kind(void);

#ifdef __cplusplus
}
#endif
#endif

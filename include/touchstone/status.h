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
	TS_SKIPPED = 77,  /* an optional backend is absent */
} ts_status;

/* The last failure of this thread as one line without a line end; "" if there was none.
 * The text belongs to the library and lives until the thread's next failure. */
TS_API const char *ts_error_message(void);

#ifdef __cplusplus
}
#endif
#endif

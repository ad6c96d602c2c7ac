/* Goldens: what a method made of a scene when somebody looked at it and accepted it. A folder holds the digests of all
 * buffers, the small ones as they are, the parameters, a picture, and the reasons (CONTRIBUTING, Goldens). */
#ifndef TOUCHSTONE_GOLDEN_H
#define TOUCHSTONE_GOLDEN_H
#include <stddef.h>
#include <touchstone/context.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

/* How a golden was found. Only `bytes` must be set before; strings are empty where there is nothing to say. */
typedef struct {
	size_t bytes; /* sizeof(ts_golden_judged) */
	char effect[64], method[64], scene[64];
	char stage[64], buffer[64]; /* the first that differs; both "" where none does, or the picture does */
	char text[512];             /* what differs: file, element, both values */
} ts_golden_judged;

/* Runs again what a golden is of, which its params.txt says, and compares all that it holds. TS_OK: all is the same.
 * TS_DIFFERENT. TS_ERROR: a file is missing or is none of a golden. Files are untrusted. */
TS_API ts_status ts_golden_check(ts_context *context, ts_golden_judged *judged, const char *folder);

#ifdef __cplusplus
}
#endif
#endif

/* SPDX-License-Identifier: Apache-2.0 */
/* Goldens: results of a method on a scene that a person looked at and accepted. A golden is a folder of the digests of
 * all buffers, the small buffers themselves, the parameters, a picture, and the reasons (CONTRIBUTING, Goldens). */
#ifndef TOUCHSTONE_GOLDEN_H
#define TOUCHSTONE_GOLDEN_H
#include <stddef.h>
#include <touchstone/context.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

/* The verdict on a golden. Only `bytes` must be set before; strings without content are "". */
typedef struct {
	size_t bytes; /* sizeof(ts_golden_judged) */
	char effect[64], method[64], scene[200];
	char stage[64], buffer[64]; /* the first that differs; both "" if none does, or only the picture */
	char text[512];             /* what differs: file, element, both values */
} ts_golden_judged;

/* Runs the method of a golden again, by its params.txt, and compares the results with its files, which are untrusted. A
 * scene's file is found by its path from the folder that the golden's folder stands in.
 * Returns: TS_OK if all are the same; TS_DIFFERENT; TS_ERROR if a file is missing, or is no file of a golden. */
TS_API ts_status ts_golden_check(ts_context *context, ts_golden_judged *judged, const char *folder);

#ifdef __cplusplus
}
#endif
#endif

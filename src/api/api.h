/* What the functions of the public API share. Each enters its context, so that this thread's lines and progress are
 * heard by the context's host, and leaves it. */
#ifndef TS_API_API_H
#define TS_API_API_H
#include <touchstone/context.h>
#include "../methods/pipeline.h"

struct ts_context {
	ts_how how;
	ts_listener listener;
};

/* Hands the engines the rows of all families, once. */
void ts_api_ready(void);

/* Fails where this process no longer computes as the numeric contract says. */
ts_status ts_api_enter(const ts_context *context);
void ts_api_leave(void);

/* Finds a method by names that a caller gave; NULL with the message set. */
const ts_pipeline *ts_api_method(const char *effect, const char *method);
/* Finds a buffer by a name that a caller gave. */
ts_status ts_api_buffer(ts_buffer_id *id, const char *name);

/* Whether a caller's struct to be filled, of so many bytes, has room for ours. */
ts_status ts_api_room(size_t bytes, size_t our_bytes, const char *type);

/* Copies a caller's struct of options, `type`. NULL: nothing. TS_ERROR: its size is none, or it sets what this library
 * does not know. Where a struct grows, callers of the older one stop short of our_bytes: then its first size is the
 * least. */
ts_status ts_api_options(void *ours, size_t our_bytes, const void *options, const char *type);

#endif

/* Helpers of the functions of the public API. Each function enters its context, so that the context's host receives
 * this thread's lines and progress, and leaves it at its end. */
#ifndef TS_API_API_H
#define TS_API_API_H
#include <sys/types.h>
#include <touchstone/context.h>
#include "methods/pipeline.h"
#include "vectors/vectors.h"

/* The words of a primitive, in one block that `in` begins, with room for those of any. */
typedef struct {
	const ts_vector *vector; /* NULL: of none */
	u32 *in, *out;
} ts_api_words;

struct ts_context {
	ts_how how;
	const ts_backend_kind *kind;
	ts_listener listener;
	pid_t process;      /* that opened it */
	ts_api_words words; /* of the primitive that was asked for last */
};

/* Hands the engines the rows of all families, once. */
void ts_api_ready(void);

/* Enters the context. Fails if this process no longer computes by the numeric contract. */
ts_status ts_api_enter(const ts_context *context);
/* As ts_api_enter, for what this thread computes alone: the others are not asked how they compute. */
ts_status ts_api_enter_alone(const ts_context *context);
void ts_api_leave(void);

/* Fails unless there is an effect of a name that a caller gave. */
ts_status ts_api_effect(const char *effect);
/* Finds a method by names that a caller gave; NULL with the message set. */
const ts_pipeline *ts_api_method(const char *effect, const char *method);
/* Finds a buffer by a name that a caller gave. */
ts_status ts_api_buffer(ts_buffer_id *id, const char *name);

/* Fails unless a caller's struct of `bytes` bytes, which is to be filled, has room for its first version's least_bytes;
 * our_bytes are those of ours. */
ts_status ts_api_room(size_t bytes, size_t least_bytes, size_t our_bytes, const char *type);

/* Copies a caller's struct of options, whose name is `type`; NULL copies nothing. TS_ERROR: its size is none that this
 * library knows, or it sets a member that this library does not know. When a struct grows, older callers pass less than
 * our_bytes; the least size that is accepted is that of its first version. */
ts_status ts_api_options(void *ours, size_t our_bytes, const void *options, const char *type);

#endif

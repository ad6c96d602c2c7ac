/* What is said beside results and failures, as lines of text. */
#ifndef TS_TESTS_MODEL_SAID_H
#define TS_TESTS_MODEL_SAID_H
#include <string.h>
#include "model/core.h"

static char said_text[4096];

static inline void said_line(void *user, const char *line)
{
	(void)user;
	size_t used = strlen(said_text);
	snprintf(said_text + used, sizeof said_text - used, "%s\n", line);
}

static inline void said_begin(void)
{
	said_text[0] = 0;
	ts_listen(&(ts_listener){.line = said_line});
}

/* All that was said since. */
static inline const char *said_end(void)
{
	ts_listen(&(ts_listener){.line = NULL});
	return said_text;
}

#endif

/* How a call ended, as a test wants it. */
#ifndef TS_TESTS_STATUS_H
#define TS_TESTS_STATUS_H
#include <touchstone/status.h>
#include "tests/model/test.h"

static inline void require(ts_status status)
{
	if (status != TS_OK) fail_msg("%s", ts_error_message());
}

/* Fails unless the last message is one line that has these words. */
static inline void says(const char *words)
{
	const char *message = ts_error_message();
	if (strstr(message, words) == NULL) fail_msg("\"%s\" does not say \"%s\"", message, words);
	assert_null(strchr(message, '\n'));
}

static inline void refused(ts_status status, const char *words)
{
	assert_int_equal(status, TS_ERROR);
	says(words);
}

#endif

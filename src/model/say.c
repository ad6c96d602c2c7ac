/* What is said beside results and failures goes to the thread's listener; a library prints nothing. */
#include <stdio.h>
#include "core.h"

enum { LINE_BYTES = 1024 };

static _Thread_local ts_listener listener;

ts_listener ts_listen(const ts_listener *to)
{
	const ts_listener before = listener;
	listener = *to;
	return before;
}

void ts_say(const char *format, ...)
{
	char text[LINE_BYTES];
	if (listener.line == NULL) return;
	va_list arguments;
	va_start(arguments, format);
	vsnprintf(text, sizeof text, format, arguments);
	va_end(arguments);
	ts_line_clean(text);
	listener.line(listener.user, text);
}

void ts_progress(const char *label, uint64_t done, uint64_t total)
{
	if (listener.progress != NULL) listener.progress(listener.user, label, done, total);
}

bool ts_cancelled(void) { return listener.cancelled != NULL && listener.cancelled(listener.user) != 0; }

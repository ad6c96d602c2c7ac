/* One line a failure, kept by thread. */
#include <stdio.h>
#include <string.h>
#include "core.h"

enum { MESSAGE_BYTES = 1024 };

static _Thread_local char message[MESSAGE_BYTES];
static _Thread_local bool refused;

/* A cut message ends with three dots, not inside a character. */
static void mark_cut(char *text)
{
	size_t end = MESSAGE_BYTES - 4;
	while (end > 0 && ((unsigned char)text[end] & 0xc0) == 0x80) end--;
	memcpy(text + end, "...", 4);
}

ts_status ts_fail_v(const char *format, va_list arguments)
{
	/* The arguments may point into the last message. */
	char text[MESSAGE_BYTES];
	int length = vsnprintf(text, sizeof text, format, arguments);
	if (length < 0) {
		strcpy(text, "a message could not be formatted");
	} else if (length >= MESSAGE_BYTES) {
		mark_cut(text);
	}
	ts_line_clean(text);
	memcpy(message, text, sizeof text);
	refused = false;
	return TS_ERROR;
}

ts_status ts_fail(const char *format, ...)
{
	va_list arguments;
	va_start(arguments, format);
	ts_status status = ts_fail_v(format, arguments);
	va_end(arguments);
	return status;
}

ts_status ts_refuse(const char *format, ...)
{
	va_list arguments;
	va_start(arguments, format);
	ts_status status = ts_fail_v(format, arguments);
	va_end(arguments);
	refused = true;
	return status;
}

bool ts_lacks(const char *function, const char *name, const void *argument)
{
	return argument == NULL && ts_fail("%s: %s is NULL; it must point to something", function, name) != TS_OK;
}

bool ts_refused(void) { return refused; }

const char *ts_error_message(void) { return message; }

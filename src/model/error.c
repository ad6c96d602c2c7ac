/* Errors: the last message and its kind, for each thread; and untrusted text on its way out. */
#include <stdio.h>
#include <string.h>
#include "model/core.h"

enum { MESSAGE_BYTES = 1024 };

static _Thread_local char message[MESSAGE_BYTES];
static _Thread_local ts_kind kind = TS_KIND_NONE;
static _Thread_local bool refused;

/* A cut message ends with three dots, not inside a character. */
static void mark_cut(char *text)
{
	size_t end = MESSAGE_BYTES - 4;
	while (end > 0 && ((unsigned char)text[end] & 0xc0) == 0x80) end--;
	memcpy(text + end, "...", 4);
}

static bool ends_with_message(const char *text)
{
	size_t n = strlen(text), inner = strlen(message);
	return inner > 0 && n >= inner && strcmp(text + n - inner, message) == 0;
}

/* `of` is TS_KIND_NONE where the call gives no kind. */
static ts_status fail(ts_kind of, const char *format, va_list arguments)
{
	/* The arguments may point into the last message, which fits whole beside as many other characters. */
	char text[2 * MESSAGE_BYTES];
	int length = vsnprintf(text, sizeof text, format, arguments);
	if (length < 0) strcpy(text, "a message could not be formatted");
	ts_line_clean(text);
	if (of != TS_KIND_NONE) {
		kind = of;
	} else if (!ends_with_message(text)) {
		kind = TS_KIND_ARGUMENT;
	}
	if (length >= MESSAGE_BYTES) mark_cut(text);
	memcpy(message, text, sizeof message);
	refused = false;
	return TS_ERROR;
}

ts_status ts_fail_v(const char *format, va_list arguments) { return fail(TS_KIND_NONE, format, arguments); }

ts_status ts_fail(const char *format, ...)
{
	va_list arguments;
	va_start(arguments, format);
	ts_status status = fail(TS_KIND_NONE, format, arguments);
	va_end(arguments);
	return status;
}

ts_status ts_fail_as(ts_kind of, const char *format, ...)
{
	va_list arguments;
	va_start(arguments, format);
	ts_status status = fail(of, format, arguments);
	va_end(arguments);
	return status;
}

ts_status ts_blame(ts_status status, ts_kind of)
{
	if ((status == TS_ERROR || status == TS_SKIPPED) && kind == TS_KIND_ARGUMENT) kind = of;
	return status;
}

ts_status ts_refuse(const char *format, ...)
{
	va_list arguments;
	va_start(arguments, format);
	ts_status status = fail(TS_KIND_FORMAT, format, arguments);
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

ts_kind ts_error_kind(void) { return kind; }

void ts_line_clean(char *text)
{
	for (unsigned char *c = (unsigned char *)text; *c != 0; c++) {
		bool c1 = c[0] == 0xc2 && c[1] >= 0x80 && c[1] <= 0x9f;
		if (c1) c[1] = '?';
		if (c1 || *c < 0x20 || *c == 0x7f) *c = '?';
	}
}

/* Messages besides results and failures go to the thread's listener; a library prints nothing. */
#include <stdatomic.h>
#include <stdio.h>
#include <time.h>
#include "model/core.h"

enum { LINE_BYTES = 1024, ASK_MS = 5 };

struct ts_stop {
	atomic_bool cancelled;
	int64_t asked_ms; /* the last time that the listener was asked */
};

static _Thread_local ts_listener listener;
static _Thread_local ts_stop own;

/* The cheapest clock. */
static int64_t now_ms(void)
{
	struct timespec now;
#ifdef CLOCK_MONOTONIC_COARSE
	clock_gettime(CLOCK_MONOTONIC_COARSE, &now);
#else
	clock_gettime(CLOCK_MONOTONIC, &now);
#endif
	return (int64_t)now.tv_sec * 1000 + now.tv_nsec / 1000000;
}

ts_listener ts_listen(const ts_listener *to)
{
	const ts_listener before = listener;
	listener = *to;
	own.cancelled = false;
	own.asked_ms = now_ms();
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

bool ts_cancelled(void)
{
	if (listener.cancelled == NULL || own.cancelled) return own.cancelled;
	own.cancelled = listener.cancelled(listener.user) != 0;
	own.asked_ms = now_ms();
	return own.cancelled;
}

ts_status ts_go_on(void) { return own.cancelled ? ts_fail_as(TS_KIND_CANCELLED, "cancelled") : TS_OK; }

ts_stop *ts_stop_here(void) { return listener.cancelled != NULL ? &own : NULL; }

bool ts_stopped(ts_stop *stop)
{
	if (stop == NULL) return false;
	if (stop == &own && now_ms() - own.asked_ms >= ASK_MS) return ts_cancelled();
	return atomic_load_explicit(&stop->cancelled, memory_order_relaxed);
}

/* The first failure of many threads: see first_error.h. */
#include "truth/first_error.h"
#include <stdio.h>

void ts_first_error_begin(ts_first_error *error)
{
	pthread_mutex_init(&error->lock, NULL);
	error->text[0] = 0;
}

void ts_first_error_end(ts_first_error *error) { pthread_mutex_destroy(&error->lock); }

void ts_first_error_keep(ts_first_error *error, int code, const char *text)
{
	pthread_mutex_lock(&error->lock);
	if (error->text[0] == 0)
		snprintf(error->text, sizeof error->text, "error %d, %s", code, text != NULL ? text : "no text");
	pthread_mutex_unlock(&error->lock);
}

const char *ts_first_error_text(ts_first_error *error)
{
	pthread_mutex_lock(&error->lock);
	const char *text = error->text[0] != 0 ? error->text : NULL;
	pthread_mutex_unlock(&error->lock);
	return text;
}

/* Keeps the first of several failures, which may come from several threads at once. */
#ifndef TS_TRUTH_FIRST_ERROR_H
#define TS_TRUTH_FIRST_ERROR_H
#include <pthread.h>

typedef struct {
	pthread_mutex_t lock;
	char text[160]; /* "" until there is one */
} ts_first_error;

/* Starts without an error. Released by ts_first_error_end. */
void ts_first_error_begin(ts_first_error *error);
void ts_first_error_end(ts_first_error *error);

/* Keeps the code and the text (may be NULL), cut to what fits, unless there is an error already. From any thread. */
void ts_first_error_keep(ts_first_error *error, int code, const char *text);

/* The error as one text, or NULL if there is none. It stays as it is until ts_first_error_end. From any thread. */
const char *ts_first_error_text(ts_first_error *error);

#endif

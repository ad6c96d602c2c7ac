/* Why jansson returned NULL. Jansson has no error code for memory that ends while it reads: it leaves the line at -1,
 * or calls a string that it could not store an invalid token. So set errno to 0 before json_load*, and call ts_json_why
 * after it. */
#ifndef TS_MODEL_JSON_H
#define TS_MODEL_JSON_H
#include <errno.h>
#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

enum { TS_JSON_WHY = 256 };

static inline bool ts_json_no_memory(const json_error_t *error) { return errno == ENOMEM || error->line < 0; }

/* A clause for a message. */
static inline const char *ts_json_why(char why[TS_JSON_WHY], const json_error_t *error)
{
	if (ts_json_no_memory(error))
		snprintf(why, TS_JSON_WHY, "out of memory");
	else
		snprintf(why, TS_JSON_WHY, "line %d, column %d: %s; JSON is expected", error->line, error->column, error->text);
	return why;
}

/* Whether a value is a whole number from low to high, in *n; 3.0 is as good as 3. */
static inline bool ts_json_whole(json_int_t *n, const json_t *value, json_int_t low, json_int_t high)
{
	double x = json_number_value(value);
	if (!json_is_number(value) || !(x >= (double)low && x <= (double)high)) return false;
	*n = json_is_integer(value) ? json_integer_value(value) : (json_int_t)x;
	return (double)*n == x && *n >= low && *n <= high;
}

#endif

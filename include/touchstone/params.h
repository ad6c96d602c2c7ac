/* SPDX-License-Identifier: Apache-2.0 */
/* Parameters: the settings of a run, each by its name; ts_param_at walks the table of all. */
#ifndef TOUCHSTONE_PARAMS_H
#define TOUCHSTONE_PARAMS_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

typedef struct ts_params ts_params;

/* Makes a set of parameters, all at their defaults. Fails only without memory.
 * Out: *params is to be released by ts_params_free; NULL on failure. */
TS_API ts_status ts_params_make(ts_params **params);

/* Makes a copy, on the same terms. */
TS_API ts_status ts_params_copy(ts_params **copy, const ts_params *params);

/* Releases a set of parameters; NULL is allowed. Scenes and traces keep copies of their own. */
TS_API void ts_params_free(ts_params *params);

/* Sets one parameter from text, as in --set name=value. On failure params is unchanged and the message names
 * the parameter, the value and the range. */
TS_API ts_status ts_params_set(ts_params *params, const char *name, const char *value);

/* Writes the value of a parameter as text that ts_params_set reads back to the same bits. 64 bytes hold every value.
 * Fails if text_bytes do not hold this value, or there is no such parameter. */
TS_API ts_status ts_params_get(const ts_params *params, const char *name, char *text, size_t text_bytes);

/* One parameter. Numbers are decimal text. */
typedef struct {
	const char *name;
	const char *kind; /* "u32", "f32" or "enum" */
	const char *def, *min, *max;
	const char *unit;
	const char *choices; /* "a|b" of an enum, otherwise "" */
	const char *source;  /* paper and section, or "" */
	const char *help;
} ts_param_info;

/* Parameter i, from 0; NULL behind the last. */
TS_API const ts_param_info *ts_param_at(size_t i);

#ifdef __cplusplus
}
#endif
#endif

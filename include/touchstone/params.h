/* Parameters: what a run can be told. params.def lists them. */
#ifndef TOUCHSTONE_PARAMS_H
#define TOUCHSTONE_PARAMS_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

/* The library's own tests build it with TS_RECORD_PARAMS: then its sources can read members by one accessor only. */
#ifdef TS_RECORD_PARAMS
#define TS_PARAM_MEMBER(field) by_TS_PARAM_only_##field
#else
#define TS_PARAM_MEMBER(field) field
#endif
#define PARAM_U32(field, name, def, min, max, unit, source, help) uint32_t TS_PARAM_MEMBER(field);
#define PARAM_F32(field, name, def, min, max, unit, source, help) float TS_PARAM_MEMBER(field);
#define PARAM_ENUM(field, name, def, choices, source, help) uint32_t TS_PARAM_MEMBER(field);
typedef struct {
#include <touchstone/params.def>
} ts_params;

#define CHOICES(...) enum { __VA_ARGS__ };
#include <touchstone/params.def>

/* One row of params.def, for programs that list parameters. Numbers are decimal text as written there. */
typedef struct {
	const char *name;
	const char *kind; /* "u32", "f32" or "enum" */
	const char *def, *min, *max;
	const char *unit;
	const char *choices; /* "a|b" of an enum, else "" */
	const char *source;  /* paper and section, or "" */
	const char *help;
} ts_param_info;

/* The table; *n receives its length. */
TS_API const ts_param_info *ts_param_table(size_t *n);

/* Sets every parameter to its default. */
TS_API void ts_params_default(ts_params *params);

/* Sets one parameter from text, as in --set name=value. On failure params is unchanged and the message names
 * the parameter, the value and the range. */
TS_API ts_status ts_params_set(ts_params *params, const char *name, const char *value);

/* Writes the value of table row `row` as text that ts_params_set reads back to the same bits. */
TS_API void ts_params_format(const ts_params *params, size_t row, char *text, size_t text_bytes);

/* Every parameter lies in its range; for a struct that was not filled by ts_params_set. */
TS_API ts_status ts_params_check(const ts_params *params);

#ifdef __cplusplus
}
#endif
#endif

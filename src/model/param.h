/* The struct of all parameters, and how sources read and set a member of it.
 *
 * A build with TS_RECORD_PARAMS notes which code reads which parameter (tests/record/record.c). In that build the
 * members have other names, so that code that reads one without TS_PARAM does not compile. */
#ifndef TS_MODEL_PARAM_H
#define TS_MODEL_PARAM_H
#include <stddef.h>
#include <touchstone/params.h>

#ifdef TS_RECORD_PARAMS
#define TS_PARAM_MEMBER(field) by_TS_PARAM_only_##field
#else
#define TS_PARAM_MEMBER(field) field
#endif
#define PARAM_U32(field, name, def, min, max, unit, source, help) uint32_t TS_PARAM_MEMBER(field);
#define PARAM_F32(field, name, def, min, max, unit, source, help) float TS_PARAM_MEMBER(field);
#define PARAM_ENUM(field, name, def, choices, source, help) uint32_t TS_PARAM_MEMBER(field);
struct ts_params {
#include "model/params.def"
};

#define CHOICES(...) enum { __VA_ARGS__ };
#include "model/params.def"

enum { TS_N_PARAMS = sizeof(ts_params) / sizeof(uint32_t) };

#ifdef __cplusplus
extern "C" {
#endif

/* The table of TS_N_PARAMS rows; *n receives its length. */
const ts_param_info *ts_param_table(size_t *n);

/* Sets every parameter to its default. */
void ts_params_default(ts_params *params);

/* Writes the value of table row `row` as text that ts_params_set reads back to the same bits. */
void ts_params_format(const ts_params *params, size_t row, char *text, size_t text_bytes);

/* Fails unless every parameter lies in its range; for a struct that was not filled by ts_params_set. */
ts_status ts_params_check(const ts_params *params);

#ifdef __cplusplus
}
#endif

#define TS_PARAM_SET(params, field, value) ((void)((params)->TS_PARAM_MEMBER(field) = (value)))

/* Evaluates the expression and notes its reads for the reader `name`. kind: stage, size, scene, truth, or the effect of
 * a method. name NULL: nobody reads. */
#ifdef TS_RECORD_PARAMS
void ts_record_read(size_t offset);
void ts_record_begin(const char *kind, const char *name);
void ts_record_end(void);
#define TS_PARAM(params, field) \
	(ts_record_read(offsetof(ts_params, TS_PARAM_MEMBER(field))), (params)->TS_PARAM_MEMBER(field))
#define TS_PARAM_READER(kind, name, ...) (ts_record_begin(kind, name), (__VA_ARGS__), ts_record_end())
#else
#define TS_PARAM(params, field) ((params)->field)
#define TS_PARAM_READER(kind, name, ...) ((void)(kind), (void)(name), (__VA_ARGS__))
#endif

#endif

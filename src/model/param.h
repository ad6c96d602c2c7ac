/* How sources read and set a member of ts_params.
 *
 * A build with TS_RECORD_PARAMS notes who reads which (tests/record/record.c), and refuses whatever does without
 * TS_PARAM: there the members have other names. */
#ifndef TS_CORE_PARAM_H
#define TS_CORE_PARAM_H
#include <stddef.h>
#include <touchstone/params.h>

enum { TS_N_PARAMS = sizeof(ts_params) / sizeof(uint32_t) };

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

/* How sources read and set a member of ts_params. */
#ifndef TS_CORE_PARAM_H
#define TS_CORE_PARAM_H
#include <touchstone/params.h>

#define TS_PARAM(params, field) ((params)->field)
#define TS_PARAM_SET(params, field, value) ((void)((params)->field = (value)))

#endif

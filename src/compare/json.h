/* The result of a comparison as JSON. */
#ifndef TS_COMPARE_JSON_H
#define TS_COMPARE_JSON_H
#include <jansson.h>
#include "compare/compare.h"

/* Both sides, the first divergence, and each buffer that differs with its first differences; a new reference, or NULL
 * without memory. */
json_t *ts_compare_json(const ts_comparison *comparison, const ts_trace *reference, const ts_trace *candidate);

#endif

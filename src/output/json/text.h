/* Text of files as JSON. For a terminal use ts_line_clean. */
#ifndef TS_OUTPUT_JSON_TEXT_H
#define TS_OUTPUT_JSON_TEXT_H
#include <jansson.h>
#ifdef __cplusplus
extern "C" {
#endif

/* A JSON string of any bytes: UTF-8 stays as it is; in other text, bytes above 127 become \xHH. NULL when out of
 * memory. */
json_t *ts_text_json(const char *text);

#ifdef __cplusplus
}
#endif
#endif

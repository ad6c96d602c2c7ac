/* Text of files as JSON, and JSON as text, where memory may end. For a terminal use ts_line_clean. */
#ifndef TS_OUTPUT_JSON_TEXT_H
#define TS_OUTPUT_JSON_TEXT_H
#include <jansson.h>
#ifdef __cplusplus
extern "C" {
#endif

/* A JSON string of any bytes: UTF-8 stays as it is; in other text, bytes above 127 become \xHH. NULL when out of
 * memory. */
json_t *ts_text_json(const char *text);
/* What was made, or NULL, and it is released, where some of it could not be put in. */
json_t *ts_json_made(json_t *made, int failed);
/* As json_dumps, which can lose the name of a member; NULL with the message set, behind `what` and a colon, when out of
 * memory. */
char *ts_json_text(const json_t *value, size_t flags, const char *what);

#ifdef __cplusplus
}
#endif
#endif

/* JSON (RFC 8259) that is untrusted, as values of jansson. Jansson's own reader goes on where memory ends: it leaves
 * out letters of a text, or reads and writes beyond its end. */
#ifndef TS_MODEL_JSON_READ_H
#define TS_MODEL_JSON_READ_H
#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif

enum { TS_JSON_DEPTH = 64 }; /* of lists and objects in each other, at most */

/* The value of a text of n bytes. Objects have no name twice; zero bytes are allowed in strings where `zeros` says so,
 * not in names. NULL with the message set, behind `what` and a colon unless it is "": where the text is wrong; of
 * TS_KIND_MEMORY, that memory ended. */
json_t *ts_json_read(const char *text, size_t n, bool zeros, const char *what);

/* Whether a value is a whole number from low to high, in *n; 3.0 is as good as 3. */
bool ts_json_whole(json_int_t *n, const json_t *value, json_int_t low, json_int_t high);

#ifdef __cplusplus
}
#endif
#endif

/* Where in a buffer an element lies, in words: "pixel (12, 40)", "triangle 812", "reflector 3, face +Y, texel (7, 9)";
 * of depth maps "view 5, texel (7, 9)", of a light's cubes "sample 3, face +Y, texel (7, 9)"; "pixel (12, 40), light
 * 1". */
#ifndef TS_TRACE_WHERE_H
#define TS_TRACE_WHERE_H
#include "trace/read.h"

enum { TS_WHERE_TEXT = 128 };

/* Describes the place of an element of a size that a family counts; false: it cannot. */
typedef struct {
	ts_dim of;
	bool (*where)(char *text, const ts_trace *reference, ts_buffer_id id, u64 index);
	void (*key)(char *text, u64 key); /* describes a record of a set by its key; NULL: the elements are no set */
} ts_where_rule;

/* Takes the rules of all families: lists ended by NULL, each ended by a row without `where`. They must stay. */
void ts_where_use(const ts_where_rule *const *rules);
/* For rules. Copies element `index` of a buffer of the reference; false if the element is missing or cannot be read. */
bool ts_where_fetch(const ts_trace *reference, ts_buffer_id id, u64 index, void *to);

/* Describes where an element of the reference lies, as far as the reference has the buffers that are needed. TS_ERROR
 * with the message set: such a buffer cannot be read. */
ts_status ts_where(char text[TS_WHERE_TEXT], const ts_trace *reference, ts_buffer_id id, u64 element);
/* "key (piece 812, x 5, y 3)" of a record of a set, by its key. */
void ts_where_key(char text[TS_WHERE_TEXT], ts_buffer_id id, u64 key);
/* "+X" of face 0, and so on to "-Z" of face 5. */
const char *ts_where_face(u32 face);

#endif

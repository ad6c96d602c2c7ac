/* The numbers behind the header of a PLY file, one after the other, in all three formats. */
#ifndef TS_SCENE_PLY_BODY_H
#define TS_SCENE_PLY_BODY_H
#include "scene/ply/header.h"

typedef struct {
	ts_ply_format format;
	const char *at, *end; /* a NUL stands at the end */
} ts_ply_body;

/* Both functions return NULL, or what is wrong with the value: part of a message, to follow the value's name.
 * Reads the next number, which in a text file may be beyond the range of its type. */
const char *ts_ply_number(ts_ply_body *body, ts_ply_type type, double *value);
/* Skips the next value of a property: a number or a list of numbers. */
const char *ts_ply_skip(ts_ply_body *body, const ts_ply_property *property);

/* Whether a number is in the range of its type; a number of a binary file always is. */
bool ts_ply_holds(ts_ply_type type, double value);

#endif

/* The numbers behind the header of a PLY file, one after the other, in all three formats. */
#ifndef TS_SCENE_PLY_BODY_H
#define TS_SCENE_PLY_BODY_H
#include "header.h"

typedef struct {
	ts_ply_format format;
	const char *at, *end; /* a NUL stands at the end */
} ts_ply_body;

/* Both return NULL, or what is wrong with the value: part of a line, for behind its name.
 * The next number, which text may write beyond the range of its type. */
const char *ts_ply_number(ts_ply_body *body, ts_ply_type type, double *value);
/* Passes over the next value of a property: a number, or a list of them. */
const char *ts_ply_skip(ts_ply_body *body, const ts_ply_property *property);

/* Whether a number is one of its type: what is binary is by its bytes. */
bool ts_ply_holds(ts_ply_type type, double value);

#endif

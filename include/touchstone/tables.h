/* SPDX-License-Identifier: Apache-2.0 */
/* Tables of all methods, their stages, buffers, and fields of records. Each function walks a table from 0; NULL behind
 * its last row. Rows live as long as the program. */
#ifndef TOUCHSTONE_TABLES_H
#define TOUCHSTONE_TABLES_H
#include <stddef.h>
#include <stdint.h>
#include <touchstone/status.h>
#ifdef __cplusplus
extern "C" {
#endif

/* A method of a paper that makes an effect. */
typedef struct {
	const char *effect, *name; /* as in `render EFFECT --method NAME` */
	const char *paper, *doc;
	int only_named; /* not 0: the command runs it only where --method names it */
} ts_method_info;
TS_API const ts_method_info *ts_method_at(size_t i);

/* A stage: one GPU pass, a pure function from buffers and parameters to buffers. */
typedef struct {
	const char *name;
	const char *kind;      /* map, emit or scatter */
	const char *margin_of; /* the stage whose decisions this one measures; NULL: none */
	const char *paper, *doc;
	int has_kernels; /* not 0: items of kernels make what it makes, and can be explained */
} ts_stage_info;
TS_API const ts_stage_info *ts_stage_at(size_t i);

/* Stage i of a method, in the order in which the stages run; a margin stands behind its stage. NULL also if there is no
 * such method. */
TS_API const ts_stage_info *ts_method_stage(const char *effect, const char *method, size_t i);

/* The number of that stage in names of files; 0: there is no such stage. */
TS_API uint32_t ts_method_stage_number(const char *effect, const char *method, size_t i);

/* Buffer i that a stage reads, and buffer i that the stage makes; NULL behind the last, or if there is no such stage.
 * Buffers that a run leaves out by its parameters are listed, too. */
TS_API const char *ts_stage_input(const char *stage, size_t i);
TS_API const char *ts_stage_output(const char *stage, size_t i);

/* A buffer: an array of one to four dimensions, in C order. */
typedef struct {
	const char *name;     /* "stage.buffer", or "scene.buffer" */
	const char *element;  /* a scalar (f32, u8, u32, u64) or a record of records.def */
	size_t element_bytes; /* of one element */
	const char *shape;    /* its dimensions by name, as records.def writes them: "height width 3" */
	const char *order;    /* sequence, set or multiset */
	const char *key;      /* of a set: the buffer that holds its keys; otherwise "" */
	const char *doc;
} ts_buffer_info;
TS_API const ts_buffer_info *ts_buffer_at(size_t i);
/* Not 0 if its first dimensions are the rows and columns of the eye's pixels or of their samples. */
TS_API int ts_buffer_is_image(const char *name);

/* A size that shapes of buffers are of. */
typedef struct {
	const char *name, *noun, *doc; /* noun: one of what it counts */
} ts_size_info;
TS_API const ts_size_info *ts_size_at(size_t i);

/* A field of a record. The fields of one record stand together. */
typedef struct {
	const char *record, *type, *name; /* type: f32, i32, u32 or u64 */
	uint32_t count;                   /* components */
	const char *doc;
} ts_field_info;
TS_API const ts_field_info *ts_field_at(size_t i);

#ifdef __cplusplus
}
#endif
#endif

/* The record of an item of a kernel while it is computed. scripts/explained writes the kernels as C that computes the
 * same bits and calls these functions at each parameter, variable, result, decision, store and title. One thread
 * records at a time. */
#ifndef TS_EXPLAIN_TOLD_H
#define TS_EXPLAIN_TOLD_H
#include "model/frame.h"

typedef enum {
	TS_TOLD_f32,
	TS_TOLD_i32,
	TS_TOLD_u32,
	TS_TOLD_i64,
	TS_TOLD_u64,
	TS_TOLD_u8,
	TS_TOLD_bool,
	TS_TOLD_pointer,
} ts_told_scalar;

/* A number within a value: ".x", "[2].y", or "" for the whole value. */
typedef struct {
	const char *path;
	size_t offset;
	ts_told_scalar scalar;
} ts_told_leaf;

typedef struct {
	const char *name; /* as C writes it */
	size_t bytes;
	u32 n;
	const ts_told_leaf *leaf;
} ts_told_type;

typedef enum {
	TS_TOLD_CALL,   /* of a function; the lines that follow are inside the call, until its end */
	TS_TOLD_VALUE,  /* a parameter or a variable has it */
	TS_TOLD_RESULT, /* the function returns it */
	TS_TOLD_TEST,   /* a decision */
	TS_TOLD_STORE,  /* is stored in a buffer */
	TS_TOLD_TITLE,  /* the title of the paragraph that follows */
} ts_told_how;

/* A place in the text of the kernels, and what is recorded there. */
typedef struct {
	ts_told_how how;
	const char *file; /* below src/kernels */
	u32 line;
	bool left;                /* for VALUE: other paragraphs read it, or the function was given a pointer to it */
	const char *text;         /* the name, the function, the condition, the target of the store, or the title */
	const ts_told_type *type; /* NULL for calls, tests and titles */
} ts_told_site;

/* One recorded line. */
typedef struct {
	const ts_told_site *site;
	u32 depth;      /* calls around it */
	bool yes;       /* for TEST: the decision */
	const void *at; /* for STORE: the address in a buffer */
	size_t value;   /* where its bytes begin in ts_telling.bytes */
} ts_told_line;

/* The recorded lines. Zero-initialise; release `lines` and `bytes` by free(). */
typedef struct {
	bool listens;
	bool primitives;     /* also record functions that belong to no kernel, not only their stores */
	u64 most;            /* lines that are kept */
	u64 n_more;          /* further lines, which are not kept */
	const u8 *from, *to; /* bytes of a buffer */
	bool stored;         /* something was stored there */
	size_t stores;       /* the last line that stored there, if it is kept */
	ts_told_line *lines;
	size_t n_lines, line_capacity;
	u8 *bytes;
	size_t n_bytes, byte_capacity;
	u32 depth, hidden;
	bool failed; /* no memory; the message is set */
} ts_telling;

/* Until the next call of this function, lines are recorded in `telling`. */
void ts_told_to(ts_telling *telling);

void ts_told_call(const ts_told_site *site);
void ts_told_end(void);
void ts_told(const ts_told_site *site, const void *value);
bool ts_told_test(const ts_told_site *site, bool yes);
void ts_told_title(const ts_told_site *site);

/* False in a build that was made with DEVICES= and can tell nothing. */
extern const bool ts_told_here;
/* Runs one item of a kernel, args as those of a launch. */
void ts_told_item(u32 kernel, const void *args, u64 item);

#endif

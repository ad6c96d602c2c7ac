/* The outline of an explanation: each title once, however often its paragraph runs, and under it the last value of each
 * name that the paragraph leaves. What is called in a paragraph stands under it. Stores need no title. */
#ifndef TS_EXPLAIN_OUTLINE_H
#define TS_EXPLAIN_OUTLINE_H
#include "explain/explain.h"

/* In place of an entry: the root, which is above what stands under no title; and none. */
#define TS_OUTLINE_ROOT SIZE_MAX
#define TS_OUTLINE_NONE (SIZE_MAX - 1)

/* A title, or a value. */
typedef struct {
	size_t launch, number; /* of the last line that it stands for */
	size_t under;          /* the entry of a title, or the root */
	u64 times;             /* lines that it stands for */
} ts_outlined;

typedef struct {
	const ts_explanation *of; /* must outlive the outline */
	ts_outlined *entry;
	size_t n, capacity;
} ts_outline;

/* Release by ts_outline_end, also after a failure. */
ts_status ts_outline_make(ts_outline *outline, const ts_explanation *of);
void ts_outline_end(ts_outline *outline);

const ts_told_line *ts_outline_line(const ts_outline *outline, size_t entry);
bool ts_outline_is_title(const ts_outline *outline, size_t entry);
/* The entry of a launch under `under` for lines like this one: of the same title, or of a value with the same name. */
size_t ts_outline_find(const ts_outline *outline, size_t launch, size_t under, const ts_told_line *line);
/* The next entry of that launch under `under`, a title or a value, behind `entry`; ROOT: the first. At the end NONE. */
size_t ts_outline_next(const ts_outline *outline, size_t launch, size_t under, bool title, size_t entry);

#endif

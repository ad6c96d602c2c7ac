/* Which lines an outline has. */
#include "explain/outline.h"
#include <assert.h>
#include <stdlib.h>
#include "model/core.h"

/* The entries of the titles that lines of each depth stand under; ROOT: of a function whose first title is to come. */
enum { DEEP = 64 };
typedef struct {
	size_t at[DEEP];
} titles;

static size_t innermost(const titles *t, u32 depth)
{
	while (depth > 0 && t->at[depth] == TS_OUTLINE_ROOT) depth--;
	return t->at[depth];
}

const ts_told_line *ts_outline_line(const ts_outline *outline, size_t entry)
{
	return &outline->of->telling.lines[outline->entry[entry].number];
}

bool ts_outline_is_title(const ts_outline *outline, size_t entry)
{
	return ts_outline_line(outline, entry)->site->how == TS_TOLD_TITLE;
}

static bool is_alike(const ts_told_line *a, const ts_told_line *b)
{
	if (a->site == b->site) return a->depth == b->depth;
	return a->site->how == b->site->how && a->site->how != TS_TOLD_TITLE && a->depth == b->depth &&
	       strcmp(a->site->text, b->site->text) == 0;
}

size_t ts_outline_find(const ts_outline *outline, size_t launch, size_t under, const ts_told_line *line)
{
	for (size_t i = 0; i < outline->n; i++) {
		const ts_outlined *entry = &outline->entry[i];
		bool here = entry->launch == launch && entry->under == under;
		if (here && is_alike(ts_outline_line(outline, i), line)) return i;
	}
	return TS_OUTLINE_NONE;
}

size_t ts_outline_next(const ts_outline *outline, size_t launch, size_t under, bool title, size_t entry)
{
	for (size_t i = entry == TS_OUTLINE_ROOT ? 0 : entry + 1; i < outline->n; i++) {
		bool here = outline->entry[i].launch == launch && outline->entry[i].under == under;
		if (here && ts_outline_is_title(outline, i) == title) return i;
	}
	return TS_OUTLINE_NONE;
}

/* *entry: that of the line, which is its last now. */
static ts_status add(size_t *entry, ts_outline *o, size_t launch, size_t under, size_t number)
{
	void **entries = (void **)&o->entry;
	*entry = ts_outline_find(o, launch, under, &o->of->telling.lines[number]);
	if (*entry == TS_OUTLINE_NONE) {
		if (ts_grow(entries, &o->capacity, o->n + 1, sizeof *o->entry, "an outline") != TS_OK) return TS_ERROR;
		*entry = o->n++;
		o->entry[*entry] = (ts_outlined){.launch = launch, .under = under};
	}
	o->entry[*entry].number = number;
	o->entry[*entry].times++;
	return TS_OK;
}

/* Whether the paragraph around a line leaves its value; titled: the paragraph is of the line's own function. */
static bool is_left(const ts_explanation *e, const ts_told_line *line, bool titled)
{
	if (!ts_explain_has_value(e, line)) return false;
	return line->site->how == TS_TOLD_STORE || line->site->left || (line->site->how == TS_TOLD_RESULT && titled);
}

static ts_status take(ts_outline *o, titles *t, size_t launch, size_t number)
{
	const ts_told_line *line = &o->of->telling.lines[number];
	u32 depth = line->depth;
	size_t entry, under = innermost(t, depth);
	assert(depth + 1 < DEEP);
	if (line->site->how == TS_TOLD_CALL) t->at[depth + 1] = TS_OUTLINE_ROOT;
	if (line->site->how == TS_TOLD_TITLE) {
		under = depth > 0 ? innermost(t, depth - 1) : TS_OUTLINE_ROOT;
		return add(&t->at[depth], o, launch, under, number);
	}
	bool counts = under != TS_OUTLINE_ROOT || line->site->how == TS_TOLD_STORE;
	bool left = counts && is_left(o->of, line, under == t->at[depth]);
	return left ? add(&entry, o, launch, under, number) : TS_OK;
}

ts_status ts_outline_make(ts_outline *outline, const ts_explanation *of)
{
	*outline = (ts_outline){.of = of};
	for (size_t launch = 0; launch < of->n_launches; launch++) {
		const ts_explained_launch *l = &of->launch[launch];
		titles t;
		for (u32 depth = 0; depth < DEEP; depth++) t.at[depth] = TS_OUTLINE_ROOT;
		for (size_t i = 0; i < l->n_lines; i++) {
			if (take(outline, &t, launch, l->first_line + i) != TS_OK) return TS_ERROR;
		}
	}
	return TS_OK;
}

void ts_outline_end(ts_outline *outline)
{
	free(outline->entry);
	*outline = (ts_outline){.n = 0};
}

/* The ground truths that families have registered, and those that --truth names. */
#include "study/asked/truths.h"
#include <assert.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>
#include "study/asked/words.h"

static const ts_truth_kind *table[TS_MAX_TRUTHS + 1];

void ts_truths_use(const ts_truth_kind *const *kinds)
{
	u32 n = 0;
	for (; *kinds != NULL; kinds++) {
		for (const ts_truth_kind *kind = *kinds; kind->name != NULL; kind++) {
			assert(n < TS_MAX_TRUTHS);
			table[n++] = kind;
		}
	}
	table[n] = NULL;
}

const ts_truth_kind *const *ts_truths(void) { return table; }

bool ts_truth_starts_from(const ts_truth_kind *kind, const ts_pipeline *method)
{
	return kind->needs != NULL && ts_pipeline_makes(method, kind->needs);
}

const ts_truth_kind *ts_truths_one(const char *name, const char *effect)
{
	for (const ts_truth_kind *const *row = ts_truths(); *row != NULL; row++) {
		const ts_truth_kind *kind = *row;
		if (strcasecmp(name, kind->name) == 0 && (effect == NULL || ts_words_have(kind->effects, effect))) return kind;
	}
	return NULL;
}

u32 ts_truth_bit(const ts_truth_kind *kind)
{
	u32 t = 0;
	while (ts_truths()[t] != kind) t++;
	return 1u << t;
}

void ts_truths_list(char *text, size_t bytes, const char *effect, const char *last)
{
	const char *names[TS_MAX_TRUTHS];
	u32 n = 0;
	for (const ts_truth_kind *const *kind = ts_truths(); *kind != NULL; kind++) {
		if (ts_words_have((*kind)->effects, effect)) names[n++] = (*kind)->name;
	}
	text[0] = 0;
	for (u32 i = 0; i < n; i++) {
		size_t used = strlen(text);
		const char *between = i == 0 ? "" : i + 1 < n ? ", " : last;
		snprintf(text + used, bytes - used, "%s%s", between, names[i]);
	}
}

static ts_status refuse(const char *name, const char *effect)
{
	char names[256];
	ts_truths_list(names, sizeof names, effect, " and ");
	const char *are = strstr(names, " and ") != NULL ? "are" : "is";
	return ts_fail("--truth %s: no truth of %s; there %s %s, or none", name, effect, are, names);
}

ts_status ts_truths_find(u32 *truths, const char *effect, const char *names)
{
	char item[16];
	*truths = 0;
	if (names != NULL && strcmp(names, "all") == 0) names = NULL;
	for (const ts_truth_kind *const *kind = ts_truths(); names == NULL && *kind != NULL; kind++) {
		if (ts_words_have((*kind)->effects, effect)) *truths |= ts_truth_bit(*kind);
	}
	if (names == NULL || strcmp(names, "none") == 0) return TS_OK;
	while (ts_words_item(&names, item, sizeof item)) {
		const ts_truth_kind *kind = ts_truths_one(item, effect);
		if (kind == NULL) return refuse(item, effect);
		*truths |= ts_truth_bit(kind);
	}
	return TS_OK;
}

bool ts_truths_named(const char *text)
{
	char item[16];
	bool any = text[0] != 0;
	while (any && text != NULL && ts_words_item(&text, item, sizeof item)) any = ts_truths_one(item, NULL) != NULL;
	return any;
}

/* Old names. */
#include "renamed.h"
#include <assert.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>
#include "core.h"

enum { MOST_ROWS = 512 };

#define RENAMED(kind, old, now) {TS_NAME_##kind, old, now},
static const ts_renamed table[] = {
#include "renamed.def"
	{0},
};

static const ts_renamed *rows = table;
static atomic_bool said[MOST_ROWS];

void ts_renamed_use(const ts_renamed *other)
{
	rows = other != NULL ? other : table;
	for (size_t i = 0; i < MOST_ROWS; i++) said[i] = false;
}

static const ts_renamed *find(ts_name_kind kind, const char *name)
{
	for (const ts_renamed *row = rows; row->old != NULL; row++) {
		if (row->kind == kind && strcmp(row->old, name) == 0) return row;
	}
	return NULL;
}

const char *ts_name_now(ts_name_kind kind, const char *name)
{
	const ts_renamed *row = find(kind, name);
	return row != NULL ? row->now : name;
}

const char *ts_name_typed(ts_name_kind kind, const char *name)
{
	const ts_renamed *row = find(kind, name);
	if (row == NULL) return name;
	assert(row - rows < MOST_ROWS);
	if (!atomic_exchange(&said[row - rows], true)) {
		ts_say("%s is now called %s; the old name works until 0.2", row->old, row->now);
	}
	return row->now;
}

/* Who reads which parameter, of a command that is built with TS_RECORD_PARAMS: at its end it adds lines
 * KIND NAME PARAMETER to the file that TS_RECORD names. A read is noted for the innermost reader, and for the truth
 * around it, which counts as its own what it runs. But sizes are asked all at once, wanted or not: theirs are theirs
 * alone. */
#include <assert.h>
#include <omp.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "model/param.h"

enum { MOST_READERS = 256, MOST_DEPTH = 16 };

typedef struct {
	const char *kind, *name;
	bool reads[TS_N_PARAMS];
} reader;
static reader readers[MOST_READERS];
static int n_readers;
static reader *stack[MOST_DEPTH]; /* NULL: nobody */
static int depth;

static void write_all(void)
{
	const char *path = getenv("TS_RECORD");
	FILE *file = path != NULL ? fopen(path, "a") : NULL;
	size_t n;
	const ts_param_info *params = ts_param_table(&n);
	for (int i = 0; file != NULL && i < n_readers; i++) {
		for (size_t p = 0; p < n; p++) {
			if (readers[i].reads[p]) fprintf(file, "%s %s %s\n", readers[i].kind, readers[i].name, params[p].name);
		}
	}
	if (file != NULL) fclose(file);
}

static reader *find(const char *kind, const char *name)
{
	for (int i = 0; i < n_readers; i++) {
		if (strcmp(readers[i].kind, kind) == 0 && strcmp(readers[i].name, name) == 0) return &readers[i];
	}
	if (n_readers == 0) atexit(write_all);
	assert(n_readers < MOST_READERS);
	readers[n_readers] = (reader){.kind = kind, .name = name};
	return &readers[n_readers++];
}

/* Threads of a loop read for who started it. */
void ts_record_begin(const char *kind, const char *name)
{
	if (omp_in_parallel()) return;
	assert(depth < MOST_DEPTH);
	stack[depth++] = kind != NULL ? find(kind, name) : NULL;
}

void ts_record_end(void) { depth -= !omp_in_parallel(); }

static bool is(const reader *r, const char *kind) { return r != NULL && strcmp(r->kind, kind) == 0; }

void ts_record_read(size_t offset)
{
	reader *by = depth > 0 ? stack[depth - 1] : NULL;
	if (by == NULL) return;
	by->reads[offset / 4] = true;
	for (int i = 0; i < depth && !is(by, "size"); i++) {
		if (is(stack[i], "truth")) stack[i]->reads[offset / 4] = true;
	}
}

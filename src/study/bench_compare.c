/* The paper's rows beside ours. */
#include <ctype.h>
#include <math.h>
#include <string.h>
#include "study/bench_paper.h"

/* Whether `text` begins with `prefix`, in any case. */
static bool begins(const char *text, const char *prefix)
{
	for (; *prefix != 0; text++, prefix++) {
		if (tolower((unsigned char)*text) != *prefix) return false;
	}
	return true;
}

static bool is_builtin(const char *scene, const char *name)
{
	size_t n = strlen(name);
	return strncmp(scene, name, n) == 0 && (scene[n] == 0 || scene[n] == ':');
}

static bool is_scene(const ts_paper_row *row, const char *spec)
{
	const char *slash = strrchr(spec, '/');
	const char *file = slash != NULL ? slash + 1 : spec;
	return strchr(file, '.') != NULL ? begins(file, row->file) : is_builtin(spec, row->builtin);
}

static const ts_paper_row *find(const ts_paper_table *table, const char *spec, u32 objects)
{
	const ts_paper_row *row = table->rows;
	while (row->name != NULL && (row->objects != objects || !is_scene(row, spec))) row++;
	return row->name != NULL ? row : NULL;
}

static const ts_paper_row *nearest(const ts_paper_table *table, double triangles)
{
	const ts_paper_row *best = table->rows;
	for (const ts_paper_row *row = best; row->name != NULL; row++) {
		if (fabs(log(row->figures[0] / triangles)) < fabs(log(best->figures[0] / triangles))) best = row;
	}
	return best;
}

void ts_paper_compare(ts_paper_line *line, const ts_paper_table *table, const char *spec)
{
	line->row = table->by_triangles ? nearest(table, line->here[0]) : find(table, spec, line->objects);
	for (u32 i = 0; i < TS_BENCH_FIGURES; i++) {
		double printed = line->row != NULL ? line->row->figures[i] : 0;
		line->paper[i] = printed != 0 ? printed : NAN;
	}
	ts_bench_derive(line->paper, NULL, table->figures);
}

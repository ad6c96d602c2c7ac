/* Finds what a name in an expression stands for. */
#include "study/figure_name.h"
#include <string.h>
#include "study/asked/words.h"

u32 ts_name_variant(const ts_name_scope *scope, const char *name, size_t n)
{
	for (u32 i = 0; i < scope->n_variants; i++)
		if (strncmp(scope->variants[i], name, n) == 0 && scope->variants[i][n] == 0) return i;
	return TS_NONE;
}

static bool is_buffer(const char *name)
{
	u32 id = 0;
	while (id < TS_N_BUFFERS && strcmp(ts_buffer_table[id].name, name) != 0) id++;
	return id < TS_N_BUFFERS;
}

bool ts_name_is_param(const char *name)
{
	size_t n, i = 0;
	const ts_param_info *table = ts_param_table(&n);
	while (i < n && strcmp(table[i].name, name) != 0) i++;
	return i < n;
}

/* A stage, or a list, whose items are then the object. */
static bool is_stages(ts_figure *figure, const ts_name_scope *scope)
{
	for (u32 i = 0; i < scope->n_lists; i++) {
		if (strcmp(scope->lists[i].name, figure->what) != 0) continue;
		figure->what = scope->lists[i].items;
		return true;
	}
	return ts_stage_find(figure->what) != NULL;
}

static u32 find_image(const ts_name_scope *scope, const char *name)
{
	for (u32 t = 0; scope->truths[t] != NULL; t++)
		if (strcmp(scope->truths[t], name) == 0) return TS_FIGURE_TRUTHS + t;
	return ts_name_variant(scope, name, strlen(name));
}

/* Why there is no such object; NULL: there is. */
static const char *find_object(ts_figure *figure, const ts_name_scope *scope)
{
	const char *name = figure->what;
	switch (figure->row->object) {
	case TS_FIGURE_OF_STAGES: return is_stages(figure, scope) ? NULL : "no stage, and no list of stages";
	case TS_FIGURE_OF_BUFFERS:
		return is_stages(figure, scope) || is_buffer(name) ? NULL : "no buffer, no stage, and no list of stages";
	case TS_FIGURE_OF_PARAM: return ts_name_is_param(name) ? NULL : "no parameter";
	case TS_FIGURE_OF_IMAGE:
		figure->other = find_image(scope, name);
		return figure->other != TS_NONE ? NULL : "no variant, and no truth";
	default: return NULL; /* counters are known when a method has run */
	}
}

/* Whether a name is the row's; then *object is what stands behind the row's name. */
static bool is_row(const ts_figure_row *row, const char *name, const char **object)
{
	size_t n = strlen(row->name);
	if (strncmp(row->name, name, n) != 0) return false;
	bool alone = row->object == TS_FIGURE_ALONE;
	*object = alone ? name + n : name + n + 1;
	return alone ? name[n] == 0 : name[n] == '.' && name[n + 1] != 0;
}

ts_status ts_name_find(ts_figure *figure, const ts_name_scope *scope, const char *name)
{
	const char *behind = strchr(name, '.'), *why;
	u32 variant = behind != NULL ? ts_name_variant(scope, name, (size_t)(behind - name)) : TS_NONE;
	*figure = (ts_figure){.variant = variant};
	for (figure->row = ts_figure_rows; figure->row->name != NULL; figure->row++) {
		bool of_case = figure->row->of_case;
		if (!of_case && variant == TS_NONE) continue;
		if (!is_row(figure->row, of_case ? name : behind + 1, &figure->what)) continue;
		why = find_object(figure, scope);
		return why == NULL ? TS_OK : ts_fail("%s is %s", figure->what, why);
	}
	if (variant == TS_NONE) return ts_fail("%s: no figure or variant above begins so", name);
	return ts_fail("%s: a variant has no such figure; `touchstone list figures` lists all", name);
}

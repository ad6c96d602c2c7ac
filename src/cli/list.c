/* `list WHAT`: the program's own tables, so never stale. */
#include <string.h>
#include "../model/frame.h"
#include "../methods/pipeline.h"
#include "../study/bench.h"
#include "cli.h"
#include "../study/methods.h"
#include "../study/reads.h"
#include "../study/truths.h"
#include "../vectors/vectors.h"

static const ts_column stage_columns[] = {{"name", "stage", false},
                                          {"kind", "kind", false},
                                          {"paper", "paper", false},
                                          {"doc", "what", false},
                                          {"writes", "writes", false},
                                          {"reads", "reads", false},
                                          {0}};
static const ts_column buffer_columns[] = {{"name", "buffer", false},
                                           {"element", "element", false},
                                           {"bytes", "bytes", true},
                                           {"shape", "shape", false},
                                           {"order", "order", false},
                                           {"doc", "what", false},
                                           {0}};
static const ts_column size_columns[] = {
	{"name", "size", false}, {"noun", "one of them", false}, {"doc", "what", false}, {0}};
static const ts_column param_columns[] = {{"name", "parameter", false},
                                          {"default", "default", false},
                                          {"range", "range", false},
                                          {"unit", "unit", false},
                                          {"source", "source", false},
                                          {"doc", "what", false},
                                          {0}};
static const ts_column method_columns[] = {{"name", "method", false},
                                           {"effect", "effect", false},
                                           {"runs", "runs", false},
                                           {"paper", "paper", false},
                                           {"doc", "what", false},
                                           {"stages", "stages", false},
                                           {0}};
static const ts_column truth_columns[] = {{"name", "truth", false},
                                          {"effects", "effects", false},
                                          {"doc", "what its picture shows", false},
                                          {"share", "error of the", false},
                                          {"against", "against", false},
                                          {"against_share", "error of the", false},
                                          {0}};
static const ts_column backend_columns[] = {
	{"name", "backend", false},         {"index", "device", true},          {"device", "name", false},
	{"rounded", "divide, root", false}, {"denormals", "denormals", false},  {"atomics", "64-bit atomics", false},
	{"memory_mib", "MiB", true},        {"most_mib", "MiB a buffer", true}, {0}};
static const ts_column vector_columns[] = {
	{"name", "vector", false}, {"rule", "rule", false}, {"kind", "kind", false}, {"doc", "what comes out", false}, {0}};
static const ts_column plain_columns[] = {{"name", "name", false}, {"doc", "what", false}, {0}};

/* The methods whose table it is; none: of all. */
typedef struct {
	const ts_pipeline *methods[TS_MAX_METHODS];
	u32 n_methods;
} ts_listed;

static void cell_buffers(ts_table *table, const ts_buffer_id *ids)
{
	char text[1024] = "";
	for (u32 i = 0; ids[i] != TS_N_BUFFERS; i++) {
		size_t used = strlen(text);
		snprintf(text + used, sizeof text - used, "%s%s", i > 0 ? " " : "", ts_buffer_table[ids[i]].name);
	}
	ts_table_text(table, text);
}

static ts_table list_stages(void)
{
	ts_table table = ts_table_begin("stages", "", stage_columns);
	for (const ts_stage *const *at = ts_stages(); *at != NULL; at++) {
		const ts_stage *s = *at;
		ts_table_text(&table, s->name);
		ts_table_text(&table, s->kind);
		ts_table_text(&table, s->paper);
		ts_table_text(&table, s->doc);
		cell_buffers(&table, ts_stage_outputs(s));
		cell_buffers(&table, ts_stage_inputs(s));
	}
	return table;
}

static ts_table list_buffers(void)
{
	ts_table table = ts_table_begin("buffers", "", buffer_columns);
	for (int i = 0; i < TS_N_BUFFERS; i++) {
		const ts_buffer_info *b = &ts_buffer_table[i];
		char order[96];
		snprintf(order, sizeof order, "%s%s%s", b->order, b->key[0] != 0 ? " by " : "", b->key);
		ts_table_text(&table, b->name);
		ts_table_text(&table, b->element);
		ts_table_count(&table, (i64)b->element_bytes);
		ts_table_text(&table, b->shape);
		ts_table_text(&table, order);
		ts_table_text(&table, b->doc);
	}
	return table;
}

static ts_table list_sizes(void)
{
	ts_table table = ts_table_begin("sizes", "", size_columns);
	for (u32 dim = 0; dim < TS_N_DIMS; dim++) {
		ts_table_text(&table, ts_dim_table[dim].name);
		ts_table_text(&table, ts_dim_table[dim].noun);
		ts_table_text(&table, ts_dim_table[dim].doc);
	}
	return table;
}

/* One of these methods reads it, or the scene that they show. */
static bool is_read(const ts_listed *of, const char *param)
{
	bool read = of->n_methods == 0 || ts_reads_scene(param);
	for (u32 i = 0; i < of->n_methods && !read; i++) read = ts_reads_method(of->methods[i], NULL, param);
	return read;
}

static ts_table list_params(const ts_listed *of)
{
	size_t n;
	const ts_param_info *p = ts_param_table(&n);
	ts_table table = ts_table_begin("params", "", param_columns);
	ts_params defaults;
	ts_params_default(&defaults);
	for (size_t row = 0; row < n; row++, p++) {
		char value[64], range[128];
		if (!is_read(of, p->name)) continue;
		ts_params_format(&defaults, row, value, sizeof value);
		snprintf(range, sizeof range, "%s to %s", p->min, p->max);
		ts_table_text(&table, p->name);
		ts_table_text(&table, value);
		ts_table_text(&table, p->choices[0] != 0 ? p->choices : range);
		ts_table_text(&table, p->unit);
		ts_table_text(&table, p->source);
		ts_table_text(&table, p->help);
	}
	return table;
}

static void cell_steps(ts_table *table, const ts_step *steps)
{
	char text[1024] = "";
	for (const ts_step *step = steps; step->stage != NULL; step++) {
		size_t used = strlen(text);
		snprintf(text + used, sizeof text - used, "%s%s", used > 0 ? " " : "", step->stage);
	}
	ts_table_text(table, text);
}

static ts_table list_methods(void)
{
	ts_table table = ts_table_begin("methods", "", method_columns);
	for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) {
		const ts_pipeline *p = *at;
		ts_table_text(&table, p->name);
		ts_table_text(&table, p->effect->name);
		ts_table_text(&table, p->only_named ? "if named" : "by default");
		ts_table_text(&table, p->paper);
		ts_table_text(&table, p->doc);
		cell_steps(&table, ts_pipeline_steps(p));
	}
	return table;
}

static ts_table list_truths(void)
{
	ts_table table = ts_table_begin("truths", "", truth_columns);
	for (const ts_truth_kind *const *kind = ts_truths(); *kind != NULL; kind++) {
		ts_table_text(&table, (*kind)->name);
		ts_table_text(&table, (*kind)->effects);
		ts_table_text(&table, (*kind)->doc);
		ts_table_text(&table, (*kind)->share);
		ts_table_text(&table, (*kind)->against);
		ts_table_text(&table, (*kind)->against_share);
	}
	return table;
}

static ts_table list_scenes(void)
{
	const ts_builtin_info *b;
	ts_table table = ts_table_begin("scenes", "", plain_columns);
	for (size_t i = 0; (b = ts_builtin_at(i)) != NULL; i++) {
		ts_table_text(&table, b->name);
		ts_table_text(&table, b->doc);
	}
	return table;
}

static ts_table list_backends(void)
{
	ts_table table = ts_table_begin("backends", "", backend_columns);
	for (u32 b = 0; ts_backend_kinds[b] != NULL; b++) {
		ts_device devices[TS_MAX_DEVICES];
		u32 n = ts_backend_kinds[b]->devices(devices);
		for (u32 i = 0; i < n; i++) {
			ts_table_text(&table, ts_backend_kinds[b]->name);
			ts_table_count(&table, i);
			ts_table_text(&table, devices[i].name);
			ts_table_text(&table, devices[i].rounded ? "exact" : "not exact");
			ts_table_text(&table, devices[i].denormals ? "kept" : "flushed");
			ts_table_text(&table, devices[i].atomics ? "yes" : "no");
			ts_table_count(&table, devices[i].memory >> 20);
			ts_table_count(&table, devices[i].most >> 20);
		}
	}
	return table;
}

static ts_table list_vectors(void)
{
	ts_table table = ts_table_begin("vectors", "", vector_columns);
	for (u32 i = 0; i < ts_vectors_count(); i++) {
		ts_vector_place at = ts_vectors_place(i);
		ts_table_text(&table, at.vector->name);
		ts_table_text(&table, at.vector->rule);
		ts_table_text(&table, at.composed ? "composite" : "primitive");
		ts_table_text(&table, at.vector->doc);
	}
	return table;
}

static const struct {
	const char *name;
	ts_table (*make)(void);
	ts_table (*make_of)(const ts_listed *of); /* instead: of methods */
} lists[] = {
	{"stages", list_stages, NULL},    {"buffers", list_buffers, NULL},   {"sizes", list_sizes, NULL},
	{"params", NULL, list_params},    {"methods", list_methods, NULL},   {"truths", list_truths, NULL},
	{"scenes", list_scenes, NULL},    {"backends", list_backends, NULL}, {"vectors", list_vectors, NULL},
	{"benches", ts_bench_list, NULL},
};

enum { N_LISTS = sizeof lists / sizeof lists[0] };

static ts_status unknown(const char *name)
{
	char names[128] = "";
	ts_nearest nearest = ts_nearest_begin(name);
	for (size_t i = 0; i < N_LISTS; i++) {
		size_t used = strlen(names);
		const char *between = i == 0 ? "" : i + 1 < N_LISTS ? ", " : " and ";
		snprintf(names + used, sizeof names - used, "%s%s", between, lists[i].name);
		ts_nearest_offer(&nearest, lists[i].name);
	}
	return ts_fail("list: no table \"%s\"%s; there are %s", name, ts_nearest_hint(&nearest, NULL), names);
}

/* Methods of the names and the effect that were said; none: of all. */
static ts_status find_methods(ts_listed *of, const ts_job *job)
{
	of->n_methods = 0;
	if (job->effect != NULL) return ts_methods_find(of->methods, &of->n_methods, job->effect, job->method);
	char item[32];
	for (const char *names = job->method; ts_words_item(&names, item, sizeof item);) {
		u32 before = of->n_methods;
		for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) {
			if (strcmp((*at)->name, item) != 0) continue;
			if (of->n_methods == TS_MAX_METHODS)
				return ts_fail("list params: more than %d methods; say --effect", TS_MAX_METHODS);
			of->methods[of->n_methods++] = *at;
		}
		if (of->n_methods == before) return ts_fail("list params: no method \"%s\"; see: list methods", item);
	}
	return TS_OK;
}

static ts_status print_list(size_t i, const ts_job *job)
{
	ts_listed of;
	ts_report report;
	bool of_methods = job->method != NULL || job->effect != NULL;
	if (of_methods && lists[i].make_of == NULL) return ts_fail("list %s: takes no --method or --effect", lists[i].name);
	if (find_methods(&of, job) != TS_OK) return TS_ERROR;
	ts_report_begin(&report, job->output.json);
	ts_table table = lists[i].make_of != NULL ? lists[i].make_of(&of) : lists[i].make();
	ts_report_table(&report, &table);
	return ts_report_end(&report);
}

ts_status ts_list_command(ts_cli *cli)
{
	for (size_t i = 0; i < N_LISTS; i++) {
		if (strcmp(lists[i].name, cli->arguments[0]) == 0) return print_list(i, &cli->job);
	}
	return unknown(cli->arguments[0]);
}

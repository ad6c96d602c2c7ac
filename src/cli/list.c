/* `list WHAT`: the program's own tables, so never stale; of all rows, of one NAME, or of a pattern. */
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>
#include "cli/client.h"
#include "study/asked/methods.h"
#include "study/asked/reads.h"
#include "study/figure.h"
#include "study/speed.h"
#include "study/tables/tables.h"

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
static const ts_column param_columns[] = {
	{"name", "parameter", false},  {"default", "default", false},     {"range", "range", false},
	{"unit", "unit", false},       {"source", "source", false},       {"doc", "what", false},
	{"methods", "methods", false}, /* this and what follows: only for a single parameter */
	{"stages", "stages", false},   {"others", "read also by", false}, {0}};
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
static const ts_column figure_columns[] = {{"name", "figure", false},
                                           {"unit", "unit", false},
                                           {"differs", "between runs", false},
                                           {"doc", "what", false},
                                           {0}};
static const ts_column plain_columns[] = {{"name", "name", false}, {"doc", "what", false}, {0}};

/* The methods whose table to list; none: all. The name or pattern of the rows; NULL: all. */
typedef struct {
	const ts_pipeline *methods[TS_MAX_METHODS];
	u32 n_methods;
	const char *name;
} ts_listed;

enum { CELL = 4096, READERS = 3 };

/* Adds a name to others that blanks separate. */
static void add_name(char text[CELL], const char *name)
{
	size_t used = strlen(text);
	snprintf(text + used, CELL - used, "%s%s", used > 0 ? " " : "", name);
}

static void cell_buffers(ts_table *table, const char *stage, const char *(*at)(const char *stage, size_t i))
{
	char text[CELL] = "";
	const char *name;
	for (size_t i = 0; (name = at(stage, i)) != NULL; i++) add_name(text, name);
	ts_table_text(table, text);
}

static ts_table list_stages(void)
{
	const ts_stage_info *s;
	ts_table table = ts_table_begin("stages", "", stage_columns);
	for (size_t i = 0; (s = ts_stage_at(i)) != NULL; i++) {
		ts_table_text(&table, s->name);
		ts_table_text(&table, s->kind);
		ts_table_text(&table, s->paper);
		ts_table_text(&table, s->doc);
		cell_buffers(&table, s->name, ts_stage_output);
		cell_buffers(&table, s->name, ts_stage_input);
	}
	return table;
}

static ts_table list_buffers(void)
{
	const ts_buffer_info *b;
	ts_table table = ts_table_begin("buffers", "", buffer_columns);
	for (size_t i = 0; (b = ts_buffer_at(i)) != NULL; i++) {
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
	const ts_size_info *size;
	ts_table table = ts_table_begin("sizes", "", size_columns);
	for (size_t i = 0; (size = ts_size_at(i)) != NULL; i++) {
		ts_table_text(&table, size->name);
		ts_table_text(&table, size->noun);
		ts_table_text(&table, size->doc);
	}
	return table;
}

/* Whether one of these methods, or the scene that they show, reads a parameter. */
static bool is_read(const ts_listed *of, const char *param)
{
	bool read = of->n_methods == 0 || ts_reads_scene(param);
	for (u32 i = 0; i < of->n_methods && !read; i++) read = ts_reads_method(of->methods[i], NULL, param);
	return read;
}

/* Adds a parameter's readers: methods of any effect, stages, the scene, and truths. */
static void cell_readers(ts_table *table, const char *param)
{
	char methods[CELL] = "", stages[CELL] = "", others[CELL] = "";
	const ts_stage_info *stage;
	const ts_truth_info *truth;
	const ts_method_info *m;
	for (size_t i = 0; (m = ts_method_at(i)) != NULL; i++) {
		if (ts_reads_named(m->effect, m->name, param) && !ts_words_have(methods, m->name)) add_name(methods, m->name);
	}
	for (size_t i = 0; (stage = ts_stage_at(i)) != NULL; i++) {
		if (ts_reads("stage", stage->name, param)) add_name(stages, stage->name);
	}
	if (ts_reads_scene(param)) add_name(others, "scene");
	for (size_t i = 0; (truth = ts_truth_at(i)) != NULL; i++) {
		if (ts_reads("truth", truth->name, param)) add_name(others, truth->name);
	}
	ts_table_text(table, methods);
	ts_table_text(table, stages);
	ts_table_text(table, others);
}

static ts_table list_params(const ts_listed *of)
{
	const ts_param_info *p;
	ts_table table = ts_table_begin("params", "", param_columns);
	ts_params *defaults;
	if (of->name == NULL) table.n_columns -= READERS;
	table.failed |= ts_params_make(&defaults) != TS_OK;
	for (size_t i = 0; (p = ts_param_at(i)) != NULL && !table.failed; i++) {
		char value[64], range[128];
		if (!is_read(of, p->name)) continue;
		table.failed |= ts_params_get(defaults, p->name, value, sizeof value) != TS_OK;
		snprintf(range, sizeof range, "%s to %s", p->min, p->max);
		ts_table_text(&table, p->name);
		ts_table_text(&table, value);
		ts_table_text(&table, p->choices[0] != 0 ? p->choices : range);
		ts_table_text(&table, p->unit);
		ts_table_text(&table, p->source);
		ts_table_text(&table, p->help);
		if (of->name != NULL) cell_readers(&table, p->name);
	}
	ts_params_free(defaults);
	return table;
}

static void cell_stages(ts_table *table, const ts_method_info *method)
{
	char text[CELL] = "";
	const ts_stage_info *stage;
	for (size_t i = 0; (stage = ts_method_stage(method->effect, method->name, i)) != NULL; i++) {
		add_name(text, stage->name);
	}
	ts_table_text(table, text);
}

static ts_table list_methods(void)
{
	const ts_method_info *m;
	ts_table table = ts_table_begin("methods", "", method_columns);
	for (size_t i = 0; (m = ts_method_at(i)) != NULL; i++) {
		ts_table_text(&table, m->name);
		ts_table_text(&table, m->effect);
		ts_table_text(&table, m->only_named ? "if named" : "by default");
		ts_table_text(&table, m->paper);
		ts_table_text(&table, m->doc);
		cell_stages(&table, m);
	}
	return table;
}

static ts_table list_truths(void)
{
	const ts_truth_info *t;
	ts_table table = ts_table_begin("truths", "", truth_columns);
	for (size_t i = 0; (t = ts_truth_at(i)) != NULL; i++) {
		ts_table_text(&table, t->name);
		ts_table_text(&table, t->effects);
		ts_table_text(&table, t->doc);
		ts_table_text(&table, t->share);
		ts_table_text(&table, t->against);
		ts_table_text(&table, t->against_share);
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

static void row_device(ts_table *table, const char *backend, u32 i, const ts_device_info *device)
{
	ts_table_text(table, backend);
	ts_table_count(table, i);
	ts_table_text(table, device->name);
	ts_table_text(table, device->rounded ? "exact" : "not exact");
	ts_table_text(table, device->denormals ? "kept" : "flushed");
	ts_table_text(table, device->atomics ? "yes" : "no");
	ts_table_count(table, (i64)(device->memory >> 20));
	ts_table_count(table, (i64)(device->most >> 20));
}

static ts_table list_backends(void)
{
	const char *name;
	ts_table table = ts_table_begin("backends", "", backend_columns);
	for (size_t b = 0; (name = ts_backend_at(b)) != NULL; b++) {
		ts_device_info device = {.bytes = sizeof device};
		ts_status status;
		for (u32 i = 0; (status = ts_device_at(&device, name, i)) == TS_OK; i++) {
			row_device(&table, name, i, &device);
			device = (ts_device_info){.bytes = sizeof device};
		}
		if (status == TS_ERROR) ts_say("%s", ts_error_message());
	}
	return table;
}

static ts_table list_vectors(void)
{
	const ts_vector_info *v;
	ts_table table = ts_table_begin("vectors", "", vector_columns);
	for (size_t i = 0; (v = ts_vector_at(i)) != NULL; i++) {
		ts_table_text(&table, v->name);
		ts_table_text(&table, v->rule);
		ts_table_text(&table, v->composed ? "composite" : "primitive");
		ts_table_text(&table, v->doc);
	}
	return table;
}

static void figure_row(ts_table *table, const char *name, const char *unit, bool timed, const char *doc)
{
	ts_table_text(table, name);
	ts_table_text(table, unit);
	ts_table_text(table, timed ? "differs" : "same");
	ts_table_text(table, doc);
}

static ts_table list_figures(void)
{
	static const char *const objects[] = {"", ".COUNTER", ".STAGES", ".BUFFERS", ".PARAMETER", ".IMAGE"};
	ts_table table = ts_table_begin("figures", "", figure_columns);
	for (const ts_figure_row *row = ts_figure_rows; row->name != NULL; row++) {
		char name[64];
		snprintf(name, sizeof name, "%s%s%s", row->of_case ? "" : "VARIANT.", row->name, objects[row->object]);
		figure_row(&table, name, row->unit, row->timed, row->doc);
	}
	for (const ts_speed_own *own = ts_speed_owns; own->name != NULL; own++) {
		char name[64];
		snprintf(name, sizeof name, "FRAME.%s", own->name);
		figure_row(&table, name, own->unit, own->unit[0] != 0, own->doc);
	}
	return table;
}

static const struct {
	const char *name;
	ts_table (*make)(void);
	ts_table (*make_of)(const ts_listed *of); /* instead, where methods matter */
} lists[] = {
	{"stages", list_stages, NULL},     {"buffers", list_buffers, NULL},   {"sizes", list_sizes, NULL},
	{"params", NULL, list_params},     {"methods", list_methods, NULL},   {"truths", list_truths, NULL},
	{"scenes", list_scenes, NULL},     {"backends", list_backends, NULL}, {"vectors", list_vectors, NULL},
	{"benches", ts_tables_list, NULL}, {"figures", list_figures, NULL},
};

enum { N_LISTS = sizeof lists / sizeof lists[0] };

static ts_status unknown(const char *name)
{
	char names[160] = "";
	ts_nearest nearest = ts_nearest_begin(name);
	for (size_t i = 0; i < N_LISTS; i++) {
		size_t used = strlen(names);
		const char *between = i == 0 ? "" : i + 1 < N_LISTS ? ", " : " and ";
		snprintf(names + used, sizeof names - used, "%s%s", between, lists[i].name);
		ts_nearest_offer(&nearest, lists[i].name);
	}
	return ts_fail("list: no table \"%s\"%s; there are %s", name, ts_nearest_hint(&nearest, NULL), names);
}

/* Adds the methods of that name, of any effect. */
static ts_status add_methods(ts_listed *of, const char *name)
{
	u32 n, before = of->n_methods;
	const ts_method_info *m;
	const ts_pipeline *found[TS_MAX_METHODS];
	for (size_t i = 0; (m = ts_method_at(i)) != NULL; i++) {
		if (strcmp(m->name, name) != 0) continue;
		if (of->n_methods == TS_MAX_METHODS)
			return ts_fail("list params: more than %d methods; say --effect", TS_MAX_METHODS);
		if (ts_methods_find(found, &n, m->effect, name) != TS_OK) return TS_ERROR;
		of->methods[of->n_methods++] = found[0];
	}
	return of->n_methods > before ? TS_OK : ts_fail("list params: no method \"%s\"; see: list methods", name);
}

/* Finds methods by the given names and effect; none: all. */
static ts_status find_methods(ts_listed *of, const ts_job *job)
{
	char item[32];
	ts_status status = TS_OK;
	if (job->effect != NULL) return ts_methods_find(of->methods, &of->n_methods, job->effect, job->method);
	for (const char *names = job->method; status == TS_OK && ts_words_item(&names, item, sizeof item);) {
		status = add_methods(of, item);
	}
	return status;
}

/* The terminal's width, or that of `help` without one. */
static u32 terminal_width(void)
{
	struct winsize size;
	return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

/* Keeps the rows that match a name or a pattern. */
static ts_status keep(ts_table *table, const char *name)
{
	char all[64];
	ts_nearest nearest = ts_nearest_begin(name);
	for (size_t i = 0; i < table->n_cells; i += table->n_columns) ts_nearest_offer(&nearest, table->cells[i].text);
	snprintf(all, sizeof all, "list %s", table->key);
	const char *hint = ts_nearest_hint(&nearest, all);
	ts_table_keep(table, name);
	table->apart = terminal_width();
	if (table->n_cells > 0 || table->failed) return TS_OK;
	return ts_fail("%s: no \"%.60s\"%s", all, name, hint);
}

static ts_status print_list(size_t i, const ts_job *job, const char *name)
{
	ts_listed of = {.name = name};
	ts_report report;
	bool of_methods = job->method != NULL || job->effect != NULL;
	if (of_methods && lists[i].make_of == NULL) return ts_fail("list %s: takes no --method or --effect", lists[i].name);
	if (find_methods(&of, job) != TS_OK) return TS_ERROR;
	ts_table table = lists[i].make_of != NULL ? lists[i].make_of(&of) : lists[i].make();
	if (name != NULL && keep(&table, name) != TS_OK) {
		ts_table_end(&table);
		return TS_ERROR;
	}
	ts_report_begin(&report, job->output.json);
	ts_report_table(&report, &table);
	return ts_report_end(&report);
}

ts_status ts_list_command(ts_cli *cli)
{
	for (size_t i = 0; i < N_LISTS; i++) {
		if (strcmp(lists[i].name, cli->arguments[0]) == 0) {
			return print_list(i, &cli->job, cli->n_arguments > 1 ? cli->arguments[1] : NULL);
		}
	}
	return unknown(cli->arguments[0]);
}

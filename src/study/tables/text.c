/* Reads tables. */
#include "study/tables/text.h"
#include <ctype.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include "study/asked/reads.h"
#include "study/asked/truths.h"
#include "study/asked/words.h"
#include "study/tables/reader.h"

static const ts_table_code *const *all_codes;

void ts_table_codes_use(const ts_table_code *const *codes) { all_codes = codes; }

static u32 variant(ts_table_reader *r)
{
	const char *word = ts_cursor_word(&r->c, "a variant");
	ts_name_scope scope = ts_table_scope(r);
	u32 at = ts_name_variant(&scope, word, strlen(word));
	if (at == TS_NONE) ts_cursor_wrong(&r->c, word, "no variant \"%s\" above", word);
	return at != TS_NONE ? at : 0;
}

static const ts_table_code *code(ts_table_reader *r, bool look)
{
	static const ts_table_code none = {0};
	const char *word = ts_cursor_word(&r->c, "a name");
	for (const ts_table_code *const *list = all_codes; *list != NULL; list++) {
		for (const ts_table_code *row = *list; row->name != NULL; row++)
			if (strcmp(row->name, word) == 0 && (row->look != NULL) == look) return row;
	}
	ts_cursor_wrong(&r->c, word, "nothing computes \"%s\"", word);
	return &none;
}

/* Of any effect. */
static bool is_method(const char *name)
{
	const ts_pipeline *const *all = ts_pipelines();
	while (*all != NULL && strcmp((*all)->name, name) != 0) all++;
	return *all != NULL;
}

const char *ts_take_effect(ts_table_reader *r)
{
	const char *effect = ts_cursor_word(&r->c, "an effect");
	if (ts_effect_find(effect) == NULL)
		ts_cursor_wrong(&r->c, effect, "no effect \"%s\"; `touchstone list methods` lists all", effect);
	return effect;
}

static void take_effect(ts_table_reader *r) { r->t->paper.effect = ts_take_effect(r); }

/* What a variant may not set: it has the row's size and scene. Truths are whole. */
static const char *why_not(const char *param, bool of_variant)
{
	bool size = strcmp(param, "width") == 0 || strcmp(param, "height") == 0;
	if (strcmp(param, "truth.rays") == 0) return "tables judge by whole truths";
	if (of_variant && size) return "variants have the size of their row";
	if (of_variant && ts_reads_scene(param)) return "variants have the scene of their row";
	return NULL;
}

void ts_check_set(ts_table_reader *r, const char *list, bool of_variant)
{
	char item[128];
	ts_params params;
	ts_params_default(&params);
	for (const char *items = list; ts_words_item(&items, item, sizeof item);) {
		char *value = strchr(item, '=');
		if (value != NULL) *value = 0;
		if (value == NULL) {
			ts_cursor_wrong(&r->c, list, "\"%s\": NAME=VALUE,... is expected", item);
		} else if (ts_params_set(&params, item, value + 1) != TS_OK) {
			ts_cursor_wrong(&r->c, list, "%s", ts_error_message());
		} else if (why_not(item, of_variant) != NULL) {
			ts_cursor_wrong(&r->c, list, "%s: %s", item, why_not(item, of_variant));
		}
	}
}

static void take_option(ts_table_reader *r, ts_bench_variant *v, const char *word)
{
	static const char *const runs[] = {"timed", "once", "first", "alone", "long"};
	for (u32 k = 0; k < sizeof runs / sizeof *runs; k++) {
		if (strcmp(runs[k], word) != 0) continue;
		v->runs = (ts_bench_runs)k;
		return;
	}
	if (strcmp(word, "seen") == 0) {
		v->seen = true;
	} else if (strchr(word, '=') != NULL) {
		if (v->set[0] != 0) ts_cursor_wrong(&r->c, word, "\"%s\": all that is set is one list, with commas", word);
		ts_check_set(r, word, true);
		v->set = word;
	} else {
		ts_cursor_wrong(&r->c, word, "\"%s\": seen, once, first, alone, long or NAME=VALUE,... is expected", word);
	}
}

/* `variant NAME = METHOD [seen] [once|first|alone|long] [NAME=VALUE,...]` */
static void take_variant(ts_table_reader *r)
{
	ts_one_table *t = r->t;
	const char *name = ts_cursor_key(&r->c, "a name");
	ts_name_scope scope = ts_table_scope(r);
	if (ts_name_variant(&scope, name, strlen(name)) != TS_NONE)
		ts_cursor_wrong(&r->c, name, "the variant \"%s\" stands above", name);
	ts_cursor_expect(&r->c, "=");
	ts_bench_variant v = {.method = ts_cursor_word(&r->c, "a method"), .set = "", .name = name};
	if (!is_method(v.method))
		ts_cursor_wrong(&r->c, v.method, "no method \"%s\"; `touchstone list methods` lists all", v.method);
	while (!ts_cursor_ended(&r->c)) take_option(r, &v, ts_cursor_more(&r->c));
	u32 at = ts_take_next(r, &t->n_variants, TS_BENCH_VARIANTS, "variants");
	t->names[at] = name;
	t->variants[at] = v;
}

/* `objects HEAD PARAMETER|size LIST [MOST]` */
static void take_objects(ts_table_reader *r)
{
	ts_paper_table *paper = &r->t->paper;
	paper->objects_head = ts_cursor_name(&r->c, "a column's head");
	const char *param = ts_cursor_word(&r->c, "a parameter, or \"size\"");
	bool sizes = strcmp(param, "size") == 0;
	paper->objects_param = sizes ? NULL : param;
	if (!sizes && !ts_name_is_param(param)) ts_cursor_wrong(&r->c, param, "no parameter \"%s\"", param);
	paper->objects = ts_cursor_word(&r->c, "values");
	if (!ts_cursor_ended(&r->c)) paper->most = ts_cursor_count(&r->c, TS_NONE - 1);
	if (r->c.status == TS_OK && ts_paper_check_objects(paper, paper->objects) != TS_OK)
		ts_cursor_wrong(&r->c, paper->objects, "%s", ts_error_message());
}

/* `picture NAME = VARIANT` */
static void take_picture(ts_table_reader *r)
{
	ts_paper_picture picture = {.name = ts_cursor_name(&r->c, "a name")};
	ts_cursor_expect(&r->c, "=");
	picture.variant = variant(r);
	bool ours = strncmp(picture.name, "difference-", 11) == 0 || strncmp(picture.name, "truth-", 6) == 0;
	if (ours) ts_cursor_wrong(&r->c, picture.name, "\"%s\": such pictures are written beside", picture.name);
	for (u32 i = 0; i < r->t->n_pictures; i++)
		if (strcmp(r->t->pictures[i].name, picture.name) == 0)
			ts_cursor_wrong(&r->c, picture.name, "the picture \"%s\" stands above", picture.name);
	r->t->pictures[ts_take_next(r, &r->t->n_pictures, MOST_PICTURES, "pictures")] = picture;
	r->t->paper.pictures = r->t->pictures;
}

/* `plot "ACROSS" "UP" [rising] FIGURE CURVE...` */
static void take_plot(ts_table_reader *r)
{
	ts_paper_plot *plot = &r->t->plot;
	u32 n = 0;
	plot->x_axis = ts_cursor_word(&r->c, "a title");
	plot->y_axis = ts_cursor_word(&r->c, "a title");
	const char *word = ts_cursor_word(&r->c, "a figure");
	plot->rises = strcmp(word, "rising") == 0;
	plot->x = plot->rises ? ts_take_key(r) : ts_take_key_of(r, word);
	do {
		u8 curve = ts_take_key(r);
		plot->curves[ts_take_next(r, &n, TS_PLOT_CURVES, "curves")] = curve;
	} while (!ts_cursor_ended(&r->c));
	plot->curves[n] = TS_NO_FIGURE;
	r->t->paper.plot = plot;
}

/* `brief [OPTIONS]`: a run by them takes seconds. */
static void take_brief(ts_table_reader *r) { r->t->row.brief = ts_cursor_rest(&r->c, NULL); }

static void take_look(ts_table_reader *r) { r->t->paper.look = code(r, true)->look; }

/* `work NAME`: code measures the whole table. */
static void take_work(ts_table_reader *r)
{
	r->t->row.run = code(r, false)->work;
	r->t->row.paper = NULL;
}

/* `nearest FIGURE`: the paper's row is the one nearest in this figure. */
static void take_nearest(ts_table_reader *r) { r->t->paper.nearest = ts_take_key(r); }

/* `stages NAME = ITEM,...`, for all tables below. */
static void take_stages(ts_table_reader *r)
{
	char item[64];
	ts_named_list list = {.name = ts_cursor_key(&r->c, "a name")};
	for (u32 i = 0; i < r->texts->n_lists; i++)
		if (strcmp(r->texts->lists[i].name, list.name) == 0)
			ts_cursor_wrong(&r->c, list.name, "the list \"%s\" stands above", list.name);
	ts_cursor_expect(&r->c, "=");
	list.items = ts_cursor_word(&r->c, "stages");
	for (const char *items = list.items; ts_words_item(&items, item, sizeof item);)
		if (ts_stage_find(item) == NULL) ts_cursor_wrong(&r->c, list.items, "no stage \"%s\"", item);
	r->texts->lists[ts_take_next(r, &r->texts->n_lists, MOST_LISTS, "lists of stages")] = list;
}

/* `shows PAPER "PLACE" "WHAT" in TABLE ["CLAIM|..."]`, or `not "WHY"` */
static void take_shows(ts_table_reader *r)
{
	ts_claim claim = {.paper = ts_cursor_word(&r->c, "a paper")};
	claim.place = ts_cursor_word(&r->c, "a place");
	claim.shows = ts_cursor_word(&r->c, "what is shown");
	const char *word = ts_cursor_word(&r->c, "\"in\" or \"not\"");
	if (strcmp(word, "in") == 0) {
		claim.bench = ts_cursor_name(&r->c, "a table");
		if (!ts_cursor_ended(&r->c)) claim.rows = ts_cursor_more(&r->c);
	} else if (strcmp(word, "not") == 0) {
		claim.cannot = ts_cursor_word(&r->c, "a reason");
	} else {
		ts_cursor_wrong(&r->c, word, "\"%s\": \"in\" or \"not\" is expected", word);
	}
	r->texts->claims[ts_take_next(r, &r->texts->n_claims, MOST_CLAIMS, "of these")] = claim;
}

/* What the table above lacks, or why it cannot be measured; NULL: nothing. */
static const char *fault_of(const ts_one_table *t)
{
	u32 truths;
	bool judged = false;
	const ts_paper_table *paper = &t->paper;
	if (t->n_variants == 0) return "it has no \"variant\"";
	if (t->n_parts == 0) return "it has no \"part\"";
	if (paper->effect == NULL) return "it has no \"effect\"";
	if (paper->scenes == NULL && paper->models == NULL) return "it has no \"scenes\"";
	for (u32 i = 0; i < t->n_parts; i++)
		if (t->parts[i].figures[0] == TS_NO_FIGURE) return "a part has no figure";
	for (u32 i = 0; i < t->n_variants; i++)
		if (ts_pipeline_find(paper->effect, t->variants[i].method) == NULL) return "a variant is of another effect";
	for (u32 i = 0; i < t->n_measured; i++)
		judged |= t->measured[i].row->object == TS_FIGURE_OF_IMAGE && t->measured[i].other >= TS_FIGURE_TRUTHS;
	if (paper->judge == NULL) return judged ? "a figure is to the truth, and it has no \"truth\"" : NULL;
	return ts_truths_find(&truths, paper->effect, paper->judge) == TS_OK ? NULL : ts_error_message();
}

static void end_table(ts_table_reader *r)
{
	const ts_one_table *t = r->t;
	const char *fault = t != NULL && t->row.run == NULL && r->c.status == TS_OK ? fault_of(t) : NULL;
	if (fault != NULL) ts_cursor_wrong(&r->c, r->c.begin, "the table \"%s\" above: %s", t->row.name, fault);
}

/* `table NAME` */
static void take_table(ts_table_reader *r)
{
	ts_table_texts *texts = r->texts;
	end_table(r);
	const char *name = ts_cursor_name(&r->c, "a name");
	for (u32 i = 0; i < texts->n_tables; i++)
		if (strcmp(texts->tables[i]->row.name, name) == 0)
			ts_cursor_wrong(&r->c, name, "the table \"%s\" stands above", name);
	ts_one_table *t = ts_alloc_zero(1, sizeof *t, "a table");
	u32 at = ts_take_next(r, &texts->n_tables, MOST_TABLES, "tables");
	if (t == NULL || r->c.status != TS_OK) {
		free(t);
		r->c.status = TS_ERROR;
		return;
	}
	t->paper = (ts_paper_table){.name = name,
	                            .title = name,
	                            .set = "",
	                            .defaults = "",
	                            .alone_set = "",
	                            .nearest = TS_NO_FIGURE,
	                            .variants = t->variants,
	                            .figures = t->figures,
	                            .measured = t->measured,
	                            .parts = t->parts,
	                            .relations = t->relations,
	                            .rows = t->rows};
	t->row = (ts_bench_row){.name = name, .doc = "", .without = TS_BENCH_BY_ITSELF, .paper = &t->paper};
	r->t = texts->tables[at] = t;
}

/* Lines of a key with a text behind it, one that sets parameters, a number, or nothing. */
enum { A_TEXT, A_SET, A_COUNT, A_FLAG };
static const struct {
	const char *key;
	u32 kind;
	size_t at;
} fields[] = {
	{"title", A_TEXT, offsetof(ts_one_table, paper.title)},
	{"doc", A_TEXT, offsetof(ts_one_table, row.doc)},
	{"refuses", A_TEXT, offsetof(ts_one_table, row.without)},
	{"takes", A_TEXT, offsetof(ts_one_table, row.takes)},
	{"scenes", A_TEXT, offsetof(ts_one_table, paper.scenes)},
	{"models", A_TEXT, offsetof(ts_one_table, paper.models)},
	{"alone", A_TEXT, offsetof(ts_one_table, paper.alone)},
	{"alone_set", A_SET, offsetof(ts_one_table, paper.alone_set)},
	{"set", A_SET, offsetof(ts_one_table, paper.set)},
	{"defaults", A_SET, offsetof(ts_one_table, paper.defaults)},
	{"size", A_SET, offsetof(ts_one_table, paper.size)},
	{"note", A_TEXT, offsetof(ts_one_table, paper.note)},
	{"truth", A_TEXT, offsetof(ts_one_table, paper.judge)},
	{"surfels", A_COUNT, offsetof(ts_one_table, paper.sampled)},
	{"long_to", A_COUNT, offsetof(ts_one_table, paper.most_long)},
	{"timed", A_FLAG, offsetof(ts_one_table, paper.timed)},
	{"rays", A_FLAG, offsetof(ts_one_table, paper.rays)},
	{"own_camera", A_FLAG, offsetof(ts_one_table, paper.own_camera)},
};

/* Other lines; the first need no table. */
static const struct {
	const char *key;
	void (*take)(ts_table_reader *r);
	bool once; /* in a table */
} lines_of[] = {
	{"table", take_table, false},     {"stages", take_stages, false},    {"shows", take_shows, false},
	{"frame", ts_take_frame, false},  {"speed", ts_take_speed, false},   {"growth", ts_take_growth, false},
	{"variant", take_variant, false}, {"figure", ts_take_figure, false}, {"part", ts_take_part, false},
	{"claim", ts_take_claim, false},  {"picture", take_picture, false},  {"objects", take_objects, true},
	{"look", take_look, true},        {"work", take_work, true},         {"nearest", take_nearest, true},
	{"paper", ts_take_paper, true},   {"plot", take_plot, true},         {"brief", take_brief, true},
	{"effect", take_effect, true},
};
enum { WITHOUT_TABLE = 6 };

#define N(rows) (sizeof(rows) / sizeof *(rows))

/* A line that a table has once; lines are numbered, those of `lines_of` behind those of `fields`. */
static void take_once(ts_table_reader *r, const char *key, size_t line)
{
	if ((r->t->taken >> line & 1) != 0) ts_cursor_wrong(&r->c, key, "\"%s\" stands above, too", key);
	r->t->taken |= 1ull << line;
}

/* Whether the key is one of `fields`. */
static bool take_field(ts_table_reader *r, const char *key)
{
	size_t i = 0;
	while (i < N(fields) && strcmp(key, fields[i].key) != 0) i++;
	if (i == N(fields)) return false;
	take_once(r, key, i);
	void *at = (char *)r->t + fields[i].at;
	if (fields[i].kind == A_FLAG) {
		*(bool *)at = true;
	} else if (fields[i].kind == A_COUNT) {
		*(u32 *)at = ts_cursor_count(&r->c, TS_NONE - 1);
	} else {
		const char *text = *(const char **)at = ts_cursor_rest(&r->c, "a text");
		if (fields[i].kind == A_SET) ts_check_set(r, text, false);
	}
	return true;
}

static void take_line(ts_table_reader *r)
{
	const char *key = ts_cursor_more(&r->c);
	size_t i = 0;
	r->indented = TS_IN_NOTHING;
	while (i < N(lines_of) && strcmp(key, lines_of[i].key) != 0) i++;
	if (r->t == NULL && i >= WITHOUT_TABLE) {
		ts_cursor_wrong(&r->c, key, "\"table\", \"stages\", \"shows\", \"frame\", \"speed\" or \"growth\" is expected");
	} else if (i < N(lines_of)) {
		if (lines_of[i].once) take_once(r, key, N(fields) + i);
		lines_of[i].take(r);
	} else if (!take_field(r, key)) {
		ts_cursor_wrong(&r->c, key, "no key \"%s\"", key);
	}
}

static void take_indented(ts_table_reader *r)
{
	switch (r->indented) {
	case TS_IN_PART: ts_add_to_part(r); break;
	case TS_IN_ROWS: ts_add_to_paper(r); break;
	default: ts_cursor_wrong(&r->c, r->c.at, "an indented line belongs to a part or the paper's rows");
	}
}

static void read_line(ts_table_reader *r)
{
	size_t n = strlen(r->c.begin);
	while (n > 0 && isspace((unsigned char)r->c.begin[n - 1])) r->c.begin[--n] = 0;
	r->c.at = r->c.begin;
	if (ts_cursor_ended(&r->c) || *r->c.at == '#') return;
	if (r->c.at == r->c.begin) {
		take_line(r);
	} else {
		take_indented(r);
	}
	ts_cursor_end(&r->c);
}

static ts_status read_lines(ts_table_reader *r)
{
	for (char *end = r->c.begin; r->c.status == TS_OK && end != NULL; r->c.begin = end) {
		end = strchr(r->c.begin, '\n');
		if (end != NULL) *end++ = 0;
		r->c.number++;
		read_line(r);
		if (end == NULL) end_table(r);
	}
	return r->c.status;
}

ts_status ts_table_texts_read(ts_table_texts **texts, const char *text, const char *path)
{
	size_t bytes = strlen(text) + 1;
	ts_table_texts *made = *texts = ts_alloc_zero(1, sizeof *made, path);
	if (made == NULL) return TS_ERROR;
	made->text = ts_alloc(3 * bytes, 1, path);
	ts_status status = made->text != NULL ? TS_OK : TS_ERROR;
	if (status == TS_OK) {
		ts_table_reader r = {.c = {.path = path, .begin = memcpy(made->text, text, bytes)}, .texts = made};
		made->names = made->text + bytes;
		made->speed = (ts_speed_of){made->scenes, made->figures, made->growths, made->speed_names, 0};
		status = read_lines(&r);
	}
	if (status == TS_OK) return TS_OK;
	ts_table_texts_free(made);
	*texts = NULL;
	return TS_ERROR;
}

const ts_bench_row *ts_table_texts_at(const ts_table_texts *texts, u32 i)
{
	return i < texts->n_tables ? &texts->tables[i]->row : NULL;
}

const ts_claim *ts_table_texts_claims(const ts_table_texts *texts) { return texts->claims; }

const ts_speed_of *ts_table_texts_speed(const ts_table_texts *texts) { return &texts->speed; }

void ts_table_texts_free(ts_table_texts *texts)
{
	if (texts == NULL) return;
	for (u32 i = 0; i < texts->n_tables; i++) free(texts->tables[i]);
	free(texts->text);
	free(texts);
}

/* Explanations as lines and as objects. */
#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include "explain/explain.h"
#include "output/json/text.h"
#include "trace/emitted/emit.h"

enum { PLACE = 64, MARGIN = 30, LINE = TS_TOLD_TEXT + 256 };

/* Lines of text; without memory one is missing, and `failed` set. */
typedef struct {
	json_t *lines;
	bool failed;
} report;

__attribute__((format(printf, 2, 3))) static void say(report *to, const char *format, ...)
{
	char text[LINE];
	va_list arguments;
	va_start(arguments, format);
	vsnprintf(text, sizeof text, format, arguments);
	va_end(arguments);
	ts_line_clean(text);
	to->failed |= json_array_append_new(to->lines, ts_text_json(text)) != 0;
}

static void show_where(char text[PLACE], const ts_told_line *line)
{
	snprintf(text, PLACE, "%s:%u", line->site->file, (unsigned)line->site->line);
}

/* mark: which of two traces has the line, or a blank; other: as in ts_explain_text. */
static void print_line(report *to, char mark, const ts_explanation *e, size_t number, const ts_explanation *other)
{
	char text[TS_TOLD_TEXT], where[PLACE];
	const ts_told_line *line = &e->telling.lines[number];
	show_where(where, line);
	ts_explain_text(text, e, number, other);
	say(to, "%c%5zu %-*s%*s%s", mark, number + 1, MARGIN, where, 2 * (int)line->depth, "", text);
}

static bool has_item(const ts_explained_launch *launch) { return launch->item < launch->n; }

static void print_launch(report *to, const ts_explanation *e, size_t i)
{
	const ts_explained_launch *launch = &e->launch[i];
	char items[64] = "";
	if (has_item(launch)) snprintf(items, sizeof items, ", item %" PRIu64, launch->item);
	say(to, "launch %zu of %zu, kernel %s%s of %" PRIu64 " items", i + 1, e->n_launches, ts_kernel_name(launch->kernel),
	    items, launch->n);
}

static void print_stores(report *to, const ts_told_what *what)
{
	const ts_question *q = what->question;
	if (q->subject != TS_EXPLAIN_ELEMENT) return;
	say(to, "line %zu stores %s:%" PRIu64, what->a->telling.stores + 1, ts_buffer_table[q->buffer].name, q->element);
}

/* Prints launches that have an item; all if no question names one. */
static void print_one(report *to, const ts_explanation *e)
{
	for (size_t i = 0; i < e->n_launches; i++) {
		const ts_explained_launch *launch = &e->launch[i];
		if (!has_item(launch) && e->telling.n_lines > 0) continue;
		print_launch(to, e, i);
		for (size_t k = 0; k < launch->n_lines; k++) print_line(to, ' ', e, launch->first_line + k, NULL);
	}
}

/* Prints a line that both have at the same place once, or both lines. */
static void print_beside(report *to, const ts_told_what *what, size_t number)
{
	if (ts_explain_is_same(what->a, what->b, number)) {
		print_line(to, ' ', what->a, number, NULL);
	} else {
		print_line(to, '<', what->a, number, what->b);
		print_line(to, '>', what->b, number, what->a);
	}
}

static void print_both(report *to, const ts_told_what *what)
{
	size_t i = 0;
	for (; ts_explain_is_beside(what->a, what->b, i); i++) print_beside(to, what, i);
	if (i < what->a->telling.n_lines || i < what->b->telling.n_lines) say(to, "from here on they go different ways:");
	for (size_t k = i; k < what->a->telling.n_lines; k++) print_line(to, '<', what->a, k, NULL);
	for (size_t k = i; k < what->b->telling.n_lines; k++) print_line(to, '>', what->b, k, NULL);
}

static void print_first(report *to, const ts_told_what *what, size_t number)
{
	say(to, "< is %s, > is %s; the first line that differs is", what->trace->dir, what->other->dir);
	if (ts_explain_is_beside(what->a, what->b, number)) {
		print_beside(to, what, number);
		return;
	}
	if (number < what->a->telling.n_lines) print_line(to, '<', what->a, number, NULL);
	if (number < what->b->telling.n_lines) print_line(to, '>', what->b, number, NULL);
}

static json_t *scalar_json(const ts_told_leaf *leaf, const u8 *at)
{
	u32 word;
	u64 wide;
	if (leaf->scalar == TS_TOLD_bool || leaf->scalar == TS_TOLD_u8)
		return leaf->scalar == TS_TOLD_u8 ? json_integer(*at) : json_boolean(*at != 0);
	if (leaf->scalar == TS_TOLD_i64 || leaf->scalar == TS_TOLD_u64) {
		memcpy(&wide, at, 8);
		return leaf->scalar == TS_TOLD_i64 ? json_integer((json_int_t)wide) : json_sprintf("%016" PRIx64, wide);
	}
	memcpy(&word, at, 4);
	if (leaf->scalar == TS_TOLD_i32) return json_integer((i32)word);
	if (leaf->scalar == TS_TOLD_u32) return json_integer(word);
	bool finite = (word & 0x7f800000u) != 0x7f800000u;
	return json_pack("{s:o, s:o}", "value", finite ? json_real((double)ts_u2f(word)) : json_null(), "bits",
	                 json_sprintf("%08" PRIx32, word));
}

/* The value, unless a part of it failed; then NULL, and the value is released. */
static json_t *whole(json_t *value, int failed)
{
	if (failed == 0) return value;
	json_decref(value);
	return NULL;
}

static json_t *value_json(const ts_explanation *e, const ts_told_line *line)
{
	char text[TS_VALUE_TEXT];
	json_t *value = json_object();
	int failed = 0;
	for (u32 i = 0; i < line->site->type->n; i++) {
		const ts_told_leaf *leaf = &line->site->type->leaf[i];
		const u8 *at = e->telling.bytes + line->value + leaf->offset;
		ts_explain_number(text, e, line, leaf);
		failed |= json_object_set_new(value, leaf->path,
		                              leaf->scalar == TS_TOLD_pointer ? json_string(text) : scalar_json(leaf, at));
	}
	return whole(value, failed);
}

static json_t *line_json(const ts_explanation *e, const ts_told_line *line)
{
	static const char *const hows[] = {"call", "value", "result", "test", "store"};
	char place[TS_VALUE_TEXT];
	const ts_told_site *site = line->site;
	json_t *o = json_pack("{s:s, s:i, s:i, s:s, s:s}", "file", site->file, "line", (int)site->line, "depth",
	                      (int)line->depth, "how", hows[site->how], "text", site->text);
	int failed = 0;
	ts_explain_place(place, e, line);
	if (site->how == TS_TOLD_STORE) failed |= json_object_set_new(o, "to", json_string(place));
	if (site->how == TS_TOLD_TEST) failed |= json_object_set_new(o, "value", json_boolean(line->yes));
	if (!ts_explain_has_value(e, line)) return whole(o, failed);
	failed |= json_object_set_new(o, "type", json_string(site->type->name));
	failed |= json_object_set_new(o, "value", value_json(e, line));
	return whole(o, failed);
}

static json_t *launches_json(const ts_explanation *e)
{
	json_t *launches = json_array();
	int failed = 0;
	for (size_t i = 0; i < e->n_launches; i++) {
		const ts_explained_launch *launch = &e->launch[i];
		json_t *lines = json_array();
		for (size_t k = 0; k < launch->n_lines; k++) {
			failed |= json_array_append_new(lines, line_json(e, &e->telling.lines[launch->first_line + k]));
		}
		json_t *item = has_item(launch) ? json_integer((json_int_t)launch->item) : json_null();
		json_t *o = json_pack("{s:s, s:I, s:o, s:o}", "kernel", ts_kernel_name(launch->kernel), "items",
		                      (json_int_t)launch->n, "item", item, "lines", lines);
		failed |= json_array_append_new(launches, o);
	}
	return whole(launches, failed);
}

static json_t *first_json(const ts_told_what *what, bool differ, size_t number)
{
	if (!differ) return json_null();
	const ts_telling *a = &what->a->telling, *b = &what->b->telling;
	return json_pack("{s:I, s:o, s:o}", "line", (json_int_t)number + 1, "trace",
	                 number < a->n_lines ? line_json(what->a, &a->lines[number]) : json_null(), "other",
	                 number < b->n_lines ? line_json(what->b, &b->lines[number]) : json_null());
}

json_t *ts_explain_json(const ts_told_what *what)
{
	size_t number = 0;
	const ts_trace *inputs = what->inputs, *other = what->other;
	u64 more = what->a->telling.n_more + (what->b != NULL ? what->b->telling.n_more : 0);
	json_t *root = json_pack("{s:o, s:o, s:o, s:s}", "trace", ts_text_json(what->trace->dir), "inputs",
	                         inputs != NULL ? ts_text_json(inputs->dir) : json_null(), "other",
	                         other != NULL ? ts_text_json(other->dir) : json_null(), "stage", what->stage->name);
	int failed = root == NULL;
	if (what->question->subject == TS_EXPLAIN_ELEMENT) {
		failed |= json_object_set_new(root, "stores", json_integer((json_int_t)what->a->telling.stores + 1));
	}
	failed |= json_object_set_new(root, "launches", launches_json(what->a));
	if (what->b != NULL) {
		bool differ = ts_explain_differ(&number, what->a, what->b);
		failed |= json_object_set_new(root, "other_launches", launches_json(what->b));
		failed |= json_object_set_new(root, "first_difference", first_json(what, differ, number));
	}
	failed |= json_object_set_new(root, "more_lines", json_integer((json_int_t)more));
	return whole(root, failed);
}

json_t *ts_explain_lines(const ts_told_what *what)
{
	report text = {.lines = json_array()}, *to = &text;
	size_t number = 0;
	bool differ = what->b != NULL && ts_explain_differ(&number, what->a, what->b);
	u64 more = what->a->telling.n_more;
	u32 place = ts_emit_number(what->trace->pipeline, ts_stage_outputs(what->stage)[0]);
	say(to, "stage %02u %s of %s", (unsigned)place, what->stage->name, what->trace->dir);
	if (differ) print_first(to, what, number);
	if (what->b != NULL) {
		if (!differ) say(to, "the same lines in %s", what->other->dir);
		print_both(to, what);
	} else {
		print_stores(to, what);
		print_one(to, what->a);
	}
	if (more > 0) say(to, "%" PRIu64 " more lines; a larger number of lines keeps them", more);
	return whole(text.lines, text.failed);
}

/* Explanations as lines and as objects. */
#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include "explain/outline.h"
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
	} else {
		if (number < what->a->telling.n_lines) print_line(to, '<', what->a, number, NULL);
		if (number < what->b->telling.n_lines) print_line(to, '>', what->b, number, NULL);
	}
	const ts_told_site *title = ts_explain_parting(what->a, what->b);
	say(to, "they part in: %s", title != NULL ? title->text : "no paragraph with a title");
}

/* An entry of one of two outlines, or the root, or none. */
typedef struct {
	const ts_outline *of;
	size_t at;
	char mark;
} side;

static bool is_there(side s) { return s.at != TS_OUTLINE_NONE; }

/* The entry behind `s` that stands under `under`; behind the root the first. */
static side next(side s, side under, size_t launch, bool titles)
{
	s.at = ts_outline_next(s.of, launch, under.at, titles, s.at);
	return s;
}

static side first(side under, size_t launch, bool titles)
{
	return next((side){under.of, TS_OUTLINE_ROOT, under.mark}, under, launch, titles);
}

/* The entry for the same lines on the other side, under `under`. */
static side twin(side s, side under)
{
	under.at = ts_outline_find(under.of, s.of->entry[s.at].launch, under.at, ts_outline_line(s.of, s.at));
	return under;
}

/* With a twin only what differs, unless they stand for other numbers of lines. */
static void show_entry(char text[LINE], side s, side other)
{
	const ts_outlined *entry = &s.of->entry[s.at], *beside = is_there(other) ? &other.of->entry[other.at] : NULL;
	bool alike = beside != NULL && beside->times == entry->times;
	ts_explain_full_text(text, s.of->of, entry->number, alike ? other.of->of : NULL, alike ? beside->number : 0);
	size_t used = strlen(text);
	const char *format = ts_outline_is_title(s.of, s.at) ? " (%" PRIu64 " times)" : ", the last of %" PRIu64;
	bool counts = ts_outline_is_title(s.of, s.at) || ts_outline_line(s.of, s.at)->site->how == TS_TOLD_STORE;
	if (counts && entry->times > 1) snprintf(text + used, LINE - used, format, entry->times);
}

static u32 titles_above(side s)
{
	u32 n = 0;
	for (size_t at = s.at; s.of->entry[at].under != TS_OUTLINE_ROOT; at = s.of->entry[at].under) n++;
	return n;
}

static void print_entry(report *to, char mark, side s, side other)
{
	char text[LINE], where[PLACE];
	show_where(where, ts_outline_line(s.of, s.at));
	show_entry(text, s, other);
	say(to, "%c%5zu %-*s%*s%s", mark, s.of->entry[s.at].number + 1, MARGIN, where, 2 * (int)titles_above(s), "", text);
}

/* An entry, or two that are twins: once if they are the same. */
static void print_entries(report *to, side a, side b)
{
	char left[LINE], right[LINE];
	bool both = is_there(a) && is_there(b);
	if (both) {
		show_entry(left, a, b);
		show_entry(right, b, a);
	}
	if (both && strcmp(left, right) == 0) {
		print_entry(to, ' ', a, (side){.at = TS_OUTLINE_NONE});
		return;
	}
	if (is_there(a)) print_entry(to, a.mark, a, b);
	if (is_there(b)) print_entry(to, b.mark, b, a);
}

/* What stands under an entry, or under twins: values, then titles; what the second side has alone comes last. */
static void print_under(report *to, size_t launch, side a, side b)
{
	for (u32 titles = 0; titles < 2; titles++) {
		for (side s = first(a, launch, titles); is_there(s); s = next(s, a, launch, titles)) {
			print_entries(to, s, twin(s, b));
			print_under(to, launch, s, twin(s, b));
		}
		for (side s = first(b, launch, titles); is_there(s); s = next(s, b, launch, titles)) {
			if (is_there(twin(s, a))) continue;
			print_entries(to, twin(s, a), s);
			print_under(to, launch, twin(s, a), s);
		}
	}
}

/* outline: of a and b; the second empty if there is no b. */
static void print_outline(report *to, const ts_told_what *what, const ts_outline outline[2])
{
	bool two = what->b != NULL;
	const side a = {&outline[0], TS_OUTLINE_ROOT, two ? '<' : ' '};
	const side b = {&outline[1], two ? TS_OUTLINE_ROOT : TS_OUTLINE_NONE, '>'};
	for (size_t i = 0; i < what->a->n_launches; i++) {
		if (!has_item(&what->a->launch[i]) && what->a->telling.n_lines > 0) continue;
		print_launch(to, what->a, i);
		print_under(to, i, a, b);
	}
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
	return ts_json_made(value, failed);
}

static json_t *line_json(const ts_explanation *e, const ts_told_line *line)
{
	static const char *const hows[] = {"call", "value", "result", "test", "store", "title"};
	char place[TS_VALUE_TEXT];
	const ts_told_site *site = line->site;
	json_t *o = json_pack("{s:s, s:i, s:i, s:s, s:s}", "file", site->file, "line", (int)site->line, "depth",
	                      (int)line->depth, "how", hows[site->how], "text", site->text);
	int failed = 0;
	ts_explain_place(place, e, line);
	if (site->how == TS_TOLD_STORE) failed |= json_object_set_new(o, "to", json_string(place));
	if (site->how == TS_TOLD_TEST) failed |= json_object_set_new(o, "value", json_boolean(line->yes));
	if (!ts_explain_has_value(e, line)) return ts_json_made(o, failed);
	failed |= json_object_set_new(o, "type", json_string(site->type->name));
	failed |= json_object_set_new(o, "value", value_json(e, line));
	return ts_json_made(o, failed);
}

/* Adds what stands under an entry of an outline, in the order of its text. */
static int add_entries(json_t *lines, const ts_outline *outline, size_t launch, size_t under)
{
	int failed = 0;
	for (u32 titles = 0; titles < 2; titles++) {
		size_t i = ts_outline_next(outline, launch, under, titles, TS_OUTLINE_ROOT);
		for (; i != TS_OUTLINE_NONE; i = ts_outline_next(outline, launch, under, titles, i)) {
			json_t *line = line_json(outline->of, ts_outline_line(outline, i));
			failed |= json_object_set_new(line, "number", json_integer((json_int_t)outline->entry[i].number + 1));
			failed |= json_object_set_new(line, "times", json_integer((json_int_t)outline->entry[i].times));
			failed |= json_array_append_new(lines, line);
			failed |= add_entries(lines, outline, launch, i);
		}
	}
	return failed;
}

static int add_lines(json_t *lines, const ts_explanation *e, const ts_explained_launch *launch)
{
	int failed = 0;
	for (size_t k = 0; k < launch->n_lines; k++) {
		failed |= json_array_append_new(lines, line_json(e, &e->telling.lines[launch->first_line + k]));
	}
	return failed;
}

/* outline: NULL for all lines. */
static json_t *launches_json(const ts_explanation *e, const ts_outline *outline)
{
	json_t *launches = json_array();
	int failed = 0;
	for (size_t i = 0; i < e->n_launches; i++) {
		const ts_explained_launch *launch = &e->launch[i];
		json_t *lines = json_array();
		failed |= outline != NULL ? add_entries(lines, outline, i, TS_OUTLINE_ROOT) : add_lines(lines, e, launch);
		json_t *item = has_item(launch) ? json_integer((json_int_t)launch->item) : json_null();
		json_t *o = json_pack("{s:s, s:I, s:o, s:o}", "kernel", ts_kernel_name(launch->kernel), "items",
		                      (json_int_t)launch->n, "item", item, "lines", lines);
		failed |= json_array_append_new(launches, o);
	}
	return ts_json_made(launches, failed);
}

static json_t *first_json(const ts_told_what *what, bool differ, size_t number)
{
	if (!differ) return json_null();
	const ts_telling *a = &what->a->telling, *b = &what->b->telling;
	const ts_told_site *title = ts_explain_parting(what->a, what->b);
	return json_pack("{s:I, s:s?, s:o, s:o}", "line", (json_int_t)number + 1, "title",
	                 title != NULL ? title->text : NULL, "trace",
	                 number < a->n_lines ? line_json(what->a, &a->lines[number]) : json_null(), "other",
	                 number < b->n_lines ? line_json(what->b, &b->lines[number]) : json_null());
}

static json_t *objects(const ts_told_what *what, const ts_outline outline[2])
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
	failed |= json_object_set_new(root, "launches", launches_json(what->a, what->outline ? &outline[0] : NULL));
	if (what->b != NULL) {
		bool differ = ts_explain_differ(&number, what->a, what->b);
		failed |=
			json_object_set_new(root, "other_launches", launches_json(what->b, what->outline ? &outline[1] : NULL));
		failed |= json_object_set_new(root, "first_difference", first_json(what, differ, number));
	}
	failed |= json_object_set_new(root, "more_lines", json_integer((json_int_t)more));
	return ts_json_made(root, failed);
}

static json_t *lines(const ts_told_what *what, const ts_outline outline[2])
{
	report text = {.lines = json_array()}, *to = &text;
	size_t number = 0;
	bool differ = what->b != NULL && ts_explain_differ(&number, what->a, what->b);
	u64 more = what->a->telling.n_more;
	u32 place = ts_emit_number(what->trace->pipeline, ts_stage_outputs(what->stage)[0]);
	say(to, "stage %02u %s of %s", (unsigned)place, what->stage->name, what->trace->dir);
	if (differ) print_first(to, what, number);
	if (what->b != NULL && !differ) say(to, "the same lines in %s", what->other->dir);
	if (what->b == NULL) print_stores(to, what);
	if (what->outline) {
		print_outline(to, what, outline);
	} else if (what->b != NULL) {
		print_both(to, what);
	} else {
		print_one(to, what->a);
	}
	if (more > 0) say(to, "%" PRIu64 " more lines; a larger number of lines keeps them", more);
	return ts_json_made(text.lines, text.failed);
}

/* An answer, with outlines if it takes them; without memory NULL. */
static json_t *answer(const ts_told_what *what, json_t *make(const ts_told_what *what, const ts_outline outline[2]))
{
	ts_outline outline[2] = {{.n = 0}, {.n = 0}};
	bool made = !what->outline || (ts_outline_make(&outline[0], what->a) == TS_OK &&
	                               (what->b == NULL || ts_outline_make(&outline[1], what->b) == TS_OK));
	json_t *answer = made ? make(what, outline) : NULL;
	for (u32 i = 0; i < 2; i++) ts_outline_end(&outline[i]);
	return answer;
}

json_t *ts_explain_json(const ts_told_what *what) { return answer(what, objects); }

json_t *ts_explain_lines(const ts_told_what *what) { return answer(what, lines); }

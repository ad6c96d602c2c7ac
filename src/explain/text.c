/* Recorded lines, in words. */
#include <inttypes.h>
#include <stdio.h>
#include "explain/explain.h"
#include "kernels/base/compat.h"

static bool is_counter(const ts_frame *frame, const void *at)
{
	const u8 *begin = (const u8 *)frame->tally;
	return (const u8 *)at >= begin && (const u8 *)at < begin + sizeof frame->tally;
}

/* The element at an address: "points.piece:3"; or what else it is. */
static void show_place(char text[TS_VALUE_TEXT], const ts_frame *frame, const void *at)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_buffer *buffer = &frame->buffer[id];
		const u8 *begin = buffer->data;
		if (!buffer->made || (const u8 *)at < begin || (const u8 *)at >= begin + buffer->bytes) continue;
		u64 element = (u64)((const u8 *)at - begin) / ts_buffer_table[id].element_bytes;
		snprintf(text, TS_VALUE_TEXT, "%s:%" PRIu64, ts_buffer_table[id].name, element);
		return;
	}
	snprintf(text, TS_VALUE_TEXT, "%s",
	         at == NULL              ? "NULL"
	         : is_counter(frame, at) ? "a counter"
	                                 : "memory of the stage");
}

void ts_explain_number(char text[TS_VALUE_TEXT], const ts_explanation *explanation, const ts_told_line *line,
                       const ts_told_leaf *leaf)
{
	const u8 *at = explanation->telling.bytes + line->value + leaf->offset;
	const void *to;
	u32 word;
	u64 wide;
	switch (leaf->scalar) {
	case TS_TOLD_pointer:
		memcpy(&to, at, sizeof to);
		show_place(text, &explanation->load->run.frame, to);
		return;
	case TS_TOLD_bool: snprintf(text, TS_VALUE_TEXT, *at != 0 ? "yes" : "no"); return;
	case TS_TOLD_u8: snprintf(text, TS_VALUE_TEXT, "%u (%02x)", (unsigned)*at, (unsigned)*at); return;
	case TS_TOLD_i64:
		memcpy(&wide, at, 8);
		snprintf(text, TS_VALUE_TEXT, "%" PRId64, (i64)wide);
		return;
	case TS_TOLD_u64:
		memcpy(&wide, at, 8);
		snprintf(text, TS_VALUE_TEXT, "%" PRIu64 " (%" PRIx64 ")", wide, wide);
		return;
	default: break;
	}
	memcpy(&word, at, 4);
	if (leaf->scalar == TS_TOLD_f32) {
		snprintf(text, TS_VALUE_TEXT, "%.9g (%08" PRIx32 ")", (double)ts_u2f(word), word);
	} else if (leaf->scalar == TS_TOLD_i32) {
		snprintf(text, TS_VALUE_TEXT, "%" PRId32, (i32)word);
	} else {
		snprintf(text, TS_VALUE_TEXT, "%" PRIu32 " (%" PRIx32 ")", word, word);
	}
}

bool ts_explain_has_value(const ts_explanation *explanation, const ts_told_line *line)
{
	bool stores = line->site->how == TS_TOLD_STORE;
	return line->site->type != NULL && !(stores && is_counter(&explanation->load->run.frame, line->at));
}

void ts_explain_place(char text[TS_VALUE_TEXT], const ts_explanation *explanation, const ts_told_line *line)
{
	text[0] = 0;
	if (line->site->how == TS_TOLD_STORE) show_place(text, &explanation->load->run.frame, line->at);
}

/* The line of that number, or an earlier one with the same long value. */
static size_t earlier(const ts_explanation *e, size_t number)
{
	enum { SHORT = 4, LINES_BACK = 1000 };
	const ts_told_line *line = &e->telling.lines[number];
	const ts_told_type *type = line->site->type;
	if (type == NULL || type->n <= SHORT) return number;
	for (size_t i = number < LINES_BACK ? 0 : number - LINES_BACK;; i++) {
		const ts_told_line *before = &e->telling.lines[i];
		const u8 *bytes = e->telling.bytes;
		bool same = before->site->type == type && memcmp(bytes + before->value, bytes + line->value, type->bytes) == 0;
		if (same) return i; /* at the latest, the line itself */
	}
}

/* Long values leave out pointers that the launch does not bind. */
static bool is_shown(const ts_told_type *type, const ts_told_leaf *leaf, const char *value)
{
	return type->n == 1 || leaf->scalar != TS_TOLD_pointer || strcmp(value, "NULL") != 0;
}

static void add_numbers(char text[TS_TOLD_TEXT], const ts_explanation *e, size_t number, const ts_explanation *other,
                        size_t beside)
{
	const ts_told_line *line = &e->telling.lines[number];
	const ts_told_type *type = line->site->type;
	char value[TS_VALUE_TEXT], others[TS_VALUE_TEXT];
	size_t used = strlen(text);
	const char *apart = "";
	for (u32 i = 0; i < type->n && used < TS_TOLD_TEXT - 2 * TS_VALUE_TEXT; i++) {
		const ts_told_leaf *leaf = &type->leaf[i];
		ts_explain_number(value, e, line, leaf);
		if (other != NULL) ts_explain_number(others, other, &other->telling.lines[beside], leaf);
		if (!is_shown(type, leaf, value) || (other != NULL && strcmp(value, others) == 0)) continue;
		used += (size_t)snprintf(text + used, TS_TOLD_TEXT - used, "%s %s%s%s", apart, leaf->path,
		                         leaf->path[0] != 0 ? " " : "", value);
		apart = ",";
	}
}

void ts_explain_full_text(char text[TS_TOLD_TEXT], const ts_explanation *explanation, size_t number,
                          const ts_explanation *other, size_t beside)
{
	const ts_told_line *line = &explanation->telling.lines[number];
	const ts_told_site *site = line->site;
	char place[TS_VALUE_TEXT];
	ts_explain_place(place, explanation, line);
	if (site->how == TS_TOLD_CALL) {
		snprintf(text, TS_TOLD_TEXT, "%s()", site->text);
	} else if (site->how == TS_TOLD_TITLE) {
		snprintf(text, TS_TOLD_TEXT, "-- %s", site->text);
	} else if (site->how == TS_TOLD_TEST) {
		snprintf(text, TS_TOLD_TEXT, "%s? %s", site->text, line->yes ? "yes" : "no");
	} else if (!ts_explain_has_value(explanation, line)) {
		snprintf(text, TS_TOLD_TEXT, "%s, %s", site->text, place);
	} else {
		snprintf(text, TS_TOLD_TEXT, "%s%s%s%s", site->text, place[0] != 0 ? ", " : "", place,
		         site->how == TS_TOLD_RESULT ? "" : " =");
		add_numbers(text, explanation, number, other, beside);
	}
}

void ts_explain_text(char text[TS_TOLD_TEXT], const ts_explanation *explanation, size_t number,
                     const ts_explanation *other)
{
	size_t before = other == NULL ? earlier(explanation, number) : number;
	if (before == number) {
		ts_explain_full_text(text, explanation, number, other, number);
	} else {
		snprintf(text, TS_TOLD_TEXT, "%s as in line %zu", explanation->telling.lines[number].site->text, before + 1);
	}
}

bool ts_explain_is_beside(const ts_explanation *a, const ts_explanation *b, size_t number)
{
	if (number >= a->telling.n_lines || number >= b->telling.n_lines) return false;
	const ts_told_line *left = &a->telling.lines[number], *right = &b->telling.lines[number];
	return left->site == right->site && left->depth == right->depth;
}

bool ts_explain_is_same(const ts_explanation *a, const ts_explanation *b, size_t number)
{
	char left[TS_TOLD_TEXT], right[TS_TOLD_TEXT];
	if (!ts_explain_is_beside(a, b, number)) return false;
	ts_explain_text(left, a, number, b);
	ts_explain_text(right, b, number, a);
	return strcmp(left, right) == 0;
}

bool ts_explain_differ(size_t *number, const ts_explanation *a, const ts_explanation *b)
{
	size_t n_a = a->telling.n_lines, n_b = b->telling.n_lines;
	size_t n = n_a > n_b ? n_a : n_b;
	*number = 0;
	while (*number < n && ts_explain_is_same(a, b, *number)) ++*number;
	return *number < n;
}

/* The title that a line stands under, if need be of the function that calls its own; NULL: none. */
static const ts_told_site *title_of(const ts_explanation *e, size_t number)
{
	const ts_told_line *lines = e->telling.lines;
	u32 depth = lines[number].depth;
	for (size_t i = number; i-- > 0;) {
		if (lines[i].depth > depth) continue;
		if (lines[i].site->how == TS_TOLD_TITLE) return lines[i].site;
		depth = lines[i].depth;
	}
	return NULL;
}

/* Whether a line may be where two part: no parameter, and nothing that stays in its paragraph. */
static bool counts(const ts_explanation *e, size_t number)
{
	const ts_told_site *site = e->telling.lines[number].site;
	return site->how != TS_TOLD_VALUE || site->left;
}

const ts_told_site *ts_explain_parting(const ts_explanation *a, const ts_explanation *b)
{
	size_t i = 0;
	for (; ts_explain_is_beside(a, b, i); i++) {
		const ts_told_site *title = counts(a, i) && !ts_explain_is_same(a, b, i) ? title_of(a, i) : NULL;
		if (title != NULL) return title;
	}
	const ts_explanation *longer = i < a->telling.n_lines ? a : b;
	return i < longer->telling.n_lines ? title_of(longer, i) : NULL;
}

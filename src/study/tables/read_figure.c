/* Reads figures and the parts that show them. */
#include <ctype.h>
#include <string.h>
#include "study/asked/words.h"
#include "study/tables/reader.h"

ts_name_scope ts_table_scope(const ts_table_reader *r)
{
	static const char *const truths[] = {"truth", NULL};
	return (ts_name_scope){r->t->names, truths, r->t->n_variants, r->texts->lists, r->texts->n_lists, true};
}

u32 ts_take_next(ts_table_reader *r, u32 *n, u32 most, const char *what)
{
	if (*n == most) ts_cursor_wrong(&r->c, r->c.begin, "more than %u %s", (unsigned)most, what);
	return r->c.status == TS_OK ? (*n)++ : 0;
}

static u32 find_figure(const ts_one_table *t, const char *key, size_t n)
{
	for (u32 i = 0; i < t->n_figures; i++)
		if (strncmp(t->figures[i].key, key, n) == 0 && t->figures[i].key[n] == 0) return i;
	return TS_NONE;
}

u8 ts_take_key_of(ts_table_reader *r, const char *word)
{
	u32 at = find_figure(r->t, word, strlen(word));
	if (at != TS_NONE) return (u8)at;
	ts_nearest nearest = ts_nearest_begin(word);
	for (u32 i = 0; i < r->t->n_figures; i++) ts_nearest_offer(&nearest, r->t->figures[i].key);
	ts_cursor_wrong(&r->c, word, "no figure \"%s\" above%s", word, ts_nearest_hint(&nearest, NULL));
	return 0;
}

u8 ts_take_key(ts_table_reader *r) { return ts_take_key_of(r, ts_cursor_word(&r->c, "a figure")); }

static bool is_same(const ts_figure *a, const ts_figure *b)
{
	return a->row == b->row && a->variant == b->variant && a->other == b->other && strcmp(a->what, b->what) == 0;
}

/* The index of a measured figure, which is added unless it is known. */
static ts_status measured(ts_table_reader *r, const char *name, u32 *index)
{
	ts_one_table *t = r->t;
	ts_name_scope scope = ts_table_scope(r);
	ts_figure f;
	u32 k = 0;
	if (ts_name_find(&f, &scope, name) != TS_OK) return TS_ERROR;
	while (k < t->n_measured && !is_same(&t->measured[k], &f)) k++;
	if (k == TS_BENCH_MEASURED) return ts_fail("more than %d figures are measured", TS_BENCH_MEASURED);
	t->measured[k] = f;
	t->n_measured += k == t->n_measured;
	*index = k;
	return TS_OK;
}

char *ts_keep_name(ts_table_reader *r, const char *text, size_t n)
{
	char *name = memcpy(r->texts->names, text, n);
	name[n] = 0;
	r->texts->names += n + 1;
	return name;
}

/* A name in an expression. */
static ts_status term_of(void *user, const char *text, size_t n, ts_term *term)
{
	ts_table_reader *r = user;
	*term = (ts_term){.kind = TS_TERM_FIGURE, .at = find_figure(r->t, text, n)};
	if (term->at != TS_NONE) return TS_OK;
	term->kind = TS_TERM_MEASURED;
	return measured(r, ts_keep_name(r, text, n), &term->at);
}

static void mark(const ts_one_table *t, ts_bench_figure *f)
{
	for (const ts_term *term = f->terms; term < f->terms + f->n_terms; term++) {
		f->measured |= term->kind == TS_TERM_MEASURED;
		f->timed |= term->kind == TS_TERM_MEASURED && t->measured[term->at].row->timed;
		f->timed |= term->kind == TS_TERM_FIGURE && t->figures[term->at].timed;
	}
}

int ts_take_decimals(ts_table_reader *r)
{
	const char *word = ts_cursor_word(&r->c, "decimals");
	if (strcmp(word, "whole") == 0) return TS_WHOLE;
	if (isdigit((unsigned char)word[0]) && word[1] == 0) return word[0] - '0';
	ts_cursor_wrong(&r->c, word, "\"%s\": decimals are 0 to 9, or \"whole\"", word);
	return 0;
}

/* `KEY "HEAD" DECIMALS = EXPRESSION`, behind its key. */
static void define(ts_table_reader *r, const char *key)
{
	ts_one_table *t = r->t;
	const char *at;
	if (find_figure(t, key, strlen(key)) != TS_NONE) ts_cursor_wrong(&r->c, key, "the figure \"%s\" stands above", key);
	ts_bench_figure f = {.key = key, .head = ts_cursor_word(&r->c, "a column's head")};
	f.decimals = ts_take_decimals(r);
	if (strlen(f.head) > TS_PAPER_HEAD)
		ts_cursor_wrong(&r->c, f.head, "a head has at most %d characters", TS_PAPER_HEAD);
	ts_cursor_expect(&r->c, "=");
	const char *expression = ts_cursor_rest(&r->c, "an expression");
	if (r->c.status != TS_OK) return;
	f.terms = t->terms + t->n_terms;
	f.n_terms = MOST_TERMS - t->n_terms;
	if (ts_expression_read(t->terms + t->n_terms, &f.n_terms, expression, &at, term_of, r) != TS_OK) {
		ts_cursor_wrong(&r->c, at, "%s", ts_error_message());
		return;
	}
	t->n_terms += f.n_terms;
	mark(t, &f);
	t->figures[ts_take_next(r, &t->n_figures, TS_BENCH_FIGURES, "figures")] = f;
}

/* `figure KEY ...`: one that no part shows. */
void ts_take_figure(ts_table_reader *r) { define(r, ts_cursor_key(&r->c, "a key")); }

/* Keys that a report has beside parts. */
#define OF_REPORTS \
	"program version backend device threads params frames machine variants relations timed_relations over_frames " \
	"milliseconds_over_frames files shard times report"

/* `part KEY "TITLE"`, and below it its figures. */
void ts_take_part(ts_table_reader *r)
{
	ts_one_table *t = r->t;
	ts_paper_part part = {.key = ts_cursor_name(&r->c, "a key")};
	part.title = ts_cursor_word(&r->c, "a title");
	if (ts_words_have(OF_REPORTS, part.key) || strncmp(part.key, "times-", 6) == 0)
		ts_cursor_wrong(&r->c, part.key, "\"%s\" is a key of every report", part.key);
	for (u32 i = 0; i < t->n_parts; i++)
		if (strcmp(t->parts[i].key, part.key) == 0)
			ts_cursor_wrong(&r->c, part.key, "the part \"%s\" stands above", part.key);
	part.figures[0] = TS_NO_FIGURE;
	t->parts[ts_take_next(r, &t->n_parts, MOST_PARTS, "parts")] = part;
	r->indented = TS_IN_PART;
}

/* The key of a figure above, or a whole one. */
void ts_add_to_part(ts_table_reader *r)
{
	ts_paper_part *part = &r->t->parts[r->t->n_parts - 1];
	const char *key = ts_cursor_key(&r->c, "a figure");
	u32 n = 0;
	while (part->figures[n] != TS_NO_FIGURE) n++;
	bool is_head = r->t->paper.objects_head != NULL && strcmp(key, r->t->paper.objects_head) == 0;
	if (is_head || strcmp(key, "scene") == 0 || strcmp(key, "source") == 0)
		ts_cursor_wrong(&r->c, key, "\"%s\" is the key of a row's beginning", key);
	if (n == TS_PAPER_COLUMNS) ts_cursor_wrong(&r->c, key, "more than %u figures of a part", (unsigned)n);
	if (!ts_cursor_ended(&r->c)) define(r, key);
	if (r->c.status != TS_OK) return;
	part->figures[n] = ts_take_key_of(r, key);
	part->figures[n + 1] = TS_NO_FIGURE;
}

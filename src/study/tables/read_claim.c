/* Reads what must hold, and what the paper prints. */
#include <math.h>
#include <string.h>
#include "study/tables/reader.h"

/* `at most N`, `at least N`, `from N to N`, `rises|falls with FIGURE`, `grows N`, `steady N` */
static void take_bound(ts_table_reader *r, ts_paper_relation *c)
{
	const char *word = ts_cursor_word(&r->c, "a bound");
	if (strcmp(word, "at") == 0) {
		word = ts_cursor_word(&r->c, "\"most\" or \"least\"");
		c->kind = strcmp(word, "most") == 0 ? TS_AT_MOST : TS_AT_LEAST;
		if (c->kind == TS_AT_LEAST && strcmp(word, "least") != 0)
			ts_cursor_wrong(&r->c, word, "\"most\" or \"least\" is expected");
		*(c->kind == TS_AT_MOST ? &c->high : &c->low) = ts_cursor_number(&r->c);
	} else if (strcmp(word, "from") == 0) {
		c->kind = TS_BETWEEN;
		c->low = ts_cursor_number(&r->c);
		ts_cursor_expect(&r->c, "to");
		c->high = ts_cursor_number(&r->c);
	} else if (strcmp(word, "rises") == 0 || strcmp(word, "falls") == 0) {
		c->kind = TS_RISES_WITH;
		c->falls = *word == 'f';
		ts_cursor_expect(&r->c, "with");
		c->low = ts_take_key(r);
	} else if (strcmp(word, "grows") == 0) {
		c->kind = TS_GROWS;
		c->low = ts_cursor_number(&r->c);
	} else if (strcmp(word, "steady") == 0) {
		c->kind = TS_STEADY;
		c->high = ts_cursor_number(&r->c);
	} else {
		ts_cursor_wrong(&r->c, word, "\"%s\": at most, at least, from, rises, falls, grows or steady is expected",
		                word);
	}
}

/* `[else REASON]` */
static const char *reason(ts_table_reader *r, const char *word)
{
	if (*word == 0) return "";
	if (strcmp(word, "else") != 0)
		ts_cursor_wrong(&r->c, word, "\"%s\": where, beside, else or nothing is expected", word);
	const char *text = ts_cursor_rest(&r->c, "a reason");
	if (strlen(text) > TS_PAPER_REASON)
		ts_cursor_wrong(&r->c, text, "a reason has at most %d characters", TS_PAPER_REASON);
	return text;
}

/* `claim "TEXT" FIGURE BOUND [of paper] [where FIGURE from N to N] [beside FIGURE] [else REASON]` */
void ts_take_claim(ts_table_reader *r)
{
	ts_paper_relation c = {.text = ts_cursor_word(&r->c, "a text"), .given = TS_NO_FIGURE};
	c.figure = c.cause = ts_take_key(r);
	take_bound(r, &c);
	const char *word = ts_cursor_more(&r->c);
	if (strcmp(word, "of") == 0 && c.kind == TS_BETWEEN) {
		c.kind = TS_OF_PAPER;
		ts_cursor_expect(&r->c, "paper");
		word = ts_cursor_more(&r->c);
	}
	if (strcmp(word, "where") == 0) {
		c.given = ts_take_key(r);
		ts_cursor_expect(&r->c, "from");
		c.least = ts_cursor_number(&r->c);
		ts_cursor_expect(&r->c, "to");
		c.most = ts_cursor_number(&r->c);
		word = ts_cursor_more(&r->c);
	}
	if (strcmp(word, "beside") == 0) {
		c.cause = ts_take_key(r);
		word = ts_cursor_more(&r->c);
	}
	c.because = reason(r, word);
	r->t->relations[ts_take_next(r, &r->t->n_relations, MOST_RELATIONS, "claims")] = c;
}

/* `paper FIGURE...`: the columns of the rows below. */
void ts_take_paper(ts_table_reader *r)
{
	ts_one_table *t = r->t;
	t->n_printed = 0;
	while (!ts_cursor_ended(&r->c)) {
		u8 at = ts_take_key(r);
		t->printed[ts_take_next(r, &t->n_printed, TS_BENCH_FIGURES, "columns")] = at;
	}
	r->indented = TS_IN_ROWS;
}

/* `SCENE BUILT-IN FILE OBJECTS VALUE...`; `-` is a value that is not printed. */
void ts_add_to_paper(ts_table_reader *r)
{
	ts_one_table *t = r->t;
	ts_paper_row row = {.name = ts_cursor_word(&r->c, "a scene")};
	row.builtin = ts_cursor_word(&r->c, "a built-in scene");
	row.file = ts_cursor_word(&r->c, "the beginning of a file's name");
	row.objects = ts_cursor_count(&r->c, TS_NONE - 1);
	for (u32 i = 0; i < TS_BENCH_FIGURES; i++) row.figures[i] = NAN;
	for (u32 k = 0; k < t->n_printed; k++) {
		if (!ts_cursor_ended(&r->c) && strcspn(r->c.at, " \t") == 1 && *r->c.at == '-') {
			r->c.at++;
		} else {
			row.figures[t->printed[k]] = ts_cursor_number(&r->c);
		}
	}
	t->rows[ts_take_next(r, &t->n_rows, MOST_ROWS, "rows")] = row;
}

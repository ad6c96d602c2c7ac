/* Expressions over figures. */
#include "study/expression.h"
#include <ctype.h>
#include <math.h>
#include <string.h>
#include "model/decimal.h"

typedef struct {
	const char *at;
	ts_term *terms;
	u32 n, room, depth, nested;
	ts_expression_name *name;
	void *user;
} reading;

static void skip(reading *r)
{
	while (*r->at == ' ' || *r->at == '\t') r->at++;
}

static bool takes(reading *r, char c)
{
	skip(r);
	if (*r->at != c) return false;
	r->at++;
	return true;
}

static bool is_name(char c) { return isalnum((unsigned char)c) || c == '.' || c == '_'; }

static size_t name_length(const char *text)
{
	size_t n = 0;
	while (is_name(text[n])) n++;
	return n;
}

static bool takes_word(reading *r, const char *word)
{
	skip(r);
	size_t n = strlen(word);
	if (name_length(r->at) != n || strncmp(r->at, word, n) != 0) return false;
	r->at += n;
	return true;
}

/* A value is one more on the stack, an operator one less. */
static ts_status add(reading *r, ts_term term)
{
	r->depth += term.kind <= TS_TERM_FIGURE ? 1 : (u32)-1;
	if (r->n == r->room || r->depth > TS_EXPRESSION_DEPTH) return ts_fail("the expression is too long");
	r->terms[r->n++] = term;
	return TS_OK;
}

static ts_status read_name(reading *r)
{
	ts_term term = {.kind = TS_TERM_FIGURE};
	skip(r);
	size_t n = name_length(r->at);
	if (n == 0) return ts_fail(*r->at == 0 ? "a figure is missing" : "no figure; a name or a number is expected");
	if (r->name(r->user, r->at, n, &term) != TS_OK) return TS_ERROR;
	r->at += n;
	return add(r, term);
}

static ts_status read_number(reading *r)
{
	char *end;
	double number = ts_strtod(r->at, &end);
	if (end == r->at || is_name(*end) || !isfinite(number)) return ts_fail("no number");
	r->at = end;
	return add(r, (ts_term){.kind = TS_TERM_NUMBER, .number = number});
}

static ts_status expect(reading *r, char c) { return takes(r, c) ? TS_OK : ts_fail("a '%c' is missing", c); }

static ts_status read_growth(reading *r)
{
	if (expect(r, '(') != TS_OK || read_name(r) != TS_OK || expect(r, ',') != TS_OK || read_name(r) != TS_OK ||
	    expect(r, ')') != TS_OK)
		return TS_ERROR;
	const ts_term *of = &r->terms[r->n - 2];
	if (of[0].kind != TS_TERM_FIGURE || of[1].kind != TS_TERM_FIGURE)
		return ts_fail("growth() takes figures of the table, not what is measured");
	return add(r, (ts_term){.kind = TS_TERM_GROWTH});
}

static ts_status read_sum(reading *r);

static ts_status read_value(reading *r)
{
	if (takes(r, '(')) {
		if (++r->nested > TS_EXPRESSION_DEPTH) return ts_fail("the expression is too long");
		ts_status status = read_sum(r);
		r->nested--;
		return status == TS_OK ? expect(r, ')') : status;
	}
	if (takes_word(r, "growth")) return read_growth(r);
	return isdigit((unsigned char)*r->at) ? read_number(r) : read_name(r);
}

/* Operands with one of two operators between them, from left to right. */
static ts_status read_chain(reading *r, ts_status (*operand)(reading *r), const char *signs,
                            const ts_term_kind kinds[2])
{
	ts_status status = operand(r);
	while (status == TS_OK) {
		u32 k = takes(r, signs[0]) ? 0 : takes(r, signs[1]) ? 1 : 2;
		if (k == 2) return TS_OK;
		status = operand(r);
		if (status == TS_OK) status = add(r, (ts_term){.kind = kinds[k]});
	}
	return status;
}

static ts_status read_product(reading *r)
{
	return read_chain(r, read_value, "*/", (const ts_term_kind[]){TS_TERM_MULTIPLY, TS_TERM_DIVIDE});
}

static ts_status read_sum(reading *r)
{
	return read_chain(r, read_product, "+-", (const ts_term_kind[]){TS_TERM_ADD, TS_TERM_SUBTRACT});
}

ts_status ts_expression_read(ts_term *terms, u32 *n, const char *text, const char **at, ts_expression_name *name,
                             void *user)
{
	reading r = {.at = text, .terms = terms, .room = *n, .name = name, .user = user};
	ts_status status = read_sum(&r);
	skip(&r);
	if (status == TS_OK && *r.at != 0)
		status = ts_fail("'%c' is not expected", isprint((unsigned char)*r.at) ? *r.at : '?');
	*at = r.at;
	*n = r.n;
	return status;
}

static double growth(const ts_term *of, const ts_expression_values *v)
{
	if (v->before == NULL) return NAN;
	u32 a = of[0].at, b = of[1].at;
	double e = log(v->figures[a] / v->before[a]) / log(v->figures[b] / v->before[b]);
	return isfinite(e) ? e : NAN;
}

static double apply(ts_term_kind kind, double a, double b)
{
	switch (kind) {
	case TS_TERM_ADD: return a + b;
	case TS_TERM_SUBTRACT: return a - b;
	case TS_TERM_MULTIPLY: return a * b;
	default: return b != 0 ? a / b : NAN;
	}
}

double ts_expression_value(const ts_term *terms, u32 n, const ts_expression_values *values)
{
	double stack[TS_EXPRESSION_DEPTH + 1];
	u32 top = 0;
	for (u32 i = 0; i < n; i++) {
		const ts_term *t = &terms[i];
		switch (t->kind) {
		case TS_TERM_NUMBER: stack[top++] = t->number; break;
		case TS_TERM_MEASURED: stack[top++] = values->measured[t->at]; break;
		case TS_TERM_FIGURE: stack[top++] = values->figures[t->at]; break;
		default:
			top--;
			stack[top - 1] =
				t->kind == TS_TERM_GROWTH ? growth(t - 2, values) : apply(t->kind, stack[top - 1], stack[top]);
		}
	}
	return stack[0];
}

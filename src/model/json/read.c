/* JSON, read. What a text's strings hold stands in one block, which is as long as the text. */
#include "model/json/read.h"
#include <errno.h>
#include <float.h>
#include <stdlib.h>
#include <string.h>
#include "model/core.h"
#include "model/decimal.h"

typedef struct {
	const char *text;
	size_t n, at;
	char *block;
	size_t used;
	unsigned depth;
	bool zeros;
	const char *problem; /* NULL: memory ended */
} reader;

static json_t *read_value(reader *r);

static json_t *wrong(reader *r, const char *problem)
{
	if (r->problem == NULL) r->problem = problem;
	return NULL;
}

static char peek(reader *r)
{
	while (r->at < r->n && r->text[r->at] != 0 && strchr(" \t\r\n", r->text[r->at]) != NULL) r->at++;
	return r->at < r->n ? r->text[r->at] : 0;
}

static bool takes(reader *r, char c)
{
	bool is = peek(r) == c && r->at < r->n;
	r->at += is;
	return is;
}

/* Four hexadecimal digits; -1: they are none. */
static long read_unit(reader *r)
{
	static const char digits[] = "0123456789abcdef0123456789ABCDEF";
	long unit = 0;
	for (int i = 0; i < 4; i++) {
		const char *digit = r->at < r->n && r->text[r->at] != 0 ? strchr(digits, r->text[r->at]) : NULL;
		if (digit == NULL) return -1;
		unit = 16 * unit + (digit - digits) % 16;
		r->at++;
	}
	return unit;
}

static void put_code(reader *r, long code)
{
	char *to = r->block + r->used;
	int more = code < 0x80 ? 0 : code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
	static const unsigned char first[4] = {0, 0xc0, 0xe0, 0xf0};
	to[0] = (char)(first[more] | code >> 6 * more);
	for (int i = 1; i <= more; i++) to[i] = (char)(0x80 | (code >> 6 * (more - i) & 0x3f));
	r->used += 1 + (size_t)more;
}

/* What follows a backslash. */
static bool read_escape(reader *r)
{
	static const char letters[] = "\"\\/bfnrt", codes[] = "\"\\/\b\f\n\r\t";
	const char letter = r->at < r->n ? r->text[r->at++] : 0, *known = letter != 0 ? strchr(letters, letter) : NULL;
	if (known != NULL) r->block[r->used++] = codes[known - letters];
	if (known != NULL || letter != 'u') return known != NULL;
	long code = read_unit(r);
	bool pair = code >= 0xd800 && code < 0xdc00;
	if (pair && r->n - r->at >= 2 && r->text[r->at] == '\\' && r->text[r->at + 1] == 'u') {
		r->at += 2;
		long low = read_unit(r);
		code = low >= 0xdc00 && low < 0xe000 ? 0x10000 + ((code - 0xd800) << 10) + (low - 0xdc00) : -1;
	}
	if (code < 0 || (code >= 0xd800 && code < 0xe000) || (code == 0 && !r->zeros)) return false;
	put_code(r, code);
	return true;
}

/* In the block, with a zero behind; NULL: the text is wrong. */
static const char *read_string(reader *r, size_t *length)
{
	const size_t begin = r->used;
	r->at++;
	while (r->at < r->n && r->text[r->at] != '"') {
		unsigned char c = (unsigned char)r->text[r->at++];
		if (c < 0x20) {
			r->at--;
			return wrong(r, "a control character in a string"), NULL;
		}
		if (c != '\\') {
			r->block[r->used++] = (char)c;
		} else if (!read_escape(r)) {
			return wrong(r, "no such escape"), NULL;
		}
	}
	if (r->at == r->n) return wrong(r, "a string without an end"), NULL;
	r->at++;
	*length = r->used - begin;
	r->block[r->used++] = 0;
	return r->block + begin;
}

/* Jansson takes UTF-8 alone. */
static json_t *read_text(reader *r)
{
	size_t length;
	const char *string = read_string(r, &length);
	errno = 0;
	json_t *text = string != NULL ? json_stringn(string, length) : NULL;
	return text != NULL || errno == ENOMEM ? text : wrong(r, "a string that is not UTF-8");
}

static bool read_digits(reader *r)
{
	size_t begin = r->at;
	while (r->at < r->n && r->text[r->at] >= '0' && r->text[r->at] <= '9') r->at++;
	return r->at > begin;
}

/* Takes one character of these. */
static bool skip(reader *r, const char *any)
{
	bool is = r->at < r->n && r->text[r->at] != 0 && strchr(any, r->text[r->at]) != NULL;
	r->at += is;
	return is;
}

/* Moves behind a number. */
static bool read_form(reader *r, bool *whole)
{
	skip(r, "-");
	bool good = skip(r, "0") || read_digits(r), part = good && skip(r, ".");
	if (part) good = read_digits(r);
	bool power = good && skip(r, "eE");
	if (power) skip(r, "+-");
	*whole = !part && !power;
	return good && (!power || read_digits(r));
}

static json_t *read_number(reader *r)
{
	const char *begin = r->text + r->at;
	char *copy = r->block + r->used, *end;
	bool whole;
	if (!read_form(r, &whole)) return wrong(r, "no value");
	size_t length = (size_t)(r->text + r->at - begin);
	memcpy(copy, begin, length);
	copy[length] = 0;
	errno = 0;
	if (whole) {
		long long n = strtoll(copy, &end, 10);
		return errno == ERANGE ? wrong(r, "too large an integer") : json_integer(n);
	}
	double x = ts_strtod(copy, &end);
	if (x > DBL_MAX || x < -DBL_MAX) return wrong(r, "too large a number");
	return end != copy ? json_real(x) : NULL;
}

static json_t *read_list(reader *r)
{
	json_t *list = json_array(), *item;
	r->at++;
	if (list == NULL || takes(r, ']')) return list;
	while ((item = read_value(r)) != NULL && json_array_append_new(list, item) == 0) {
		if (takes(r, ']')) return list;
		if (!takes(r, ',')) {
			wrong(r, "',' or ']' is missing");
			break;
		}
	}
	json_decref(list);
	return NULL;
}

static bool read_member(reader *r, json_t *object)
{
	size_t length;
	if (peek(r) != '"') return wrong(r, "a name in quotes is missing") != NULL;
	const char *name = read_string(r, &length);
	if (name == NULL) return false;
	if (strlen(name) != length) return wrong(r, "a zero byte in a name") != NULL;
	if (json_object_get(object, name) != NULL) return wrong(r, "a duplicate name") != NULL;
	if (!takes(r, ':')) return wrong(r, "':' is missing") != NULL;
	json_t *value = read_value(r);
	errno = 0;
	if (value == NULL || json_object_set_new(object, name, value) == 0) return value != NULL;
	return errno == ENOMEM ? false : wrong(r, "a name that is not UTF-8") != NULL;
}

static json_t *read_object(reader *r)
{
	json_t *object = json_object();
	r->at++;
	if (object == NULL || takes(r, '}')) return object;
	while (read_member(r, object)) {
		if (takes(r, '}')) return object;
		if (!takes(r, ',')) {
			wrong(r, "',' or '}' is missing");
			break;
		}
	}
	json_decref(object);
	return NULL;
}

static bool is_word(reader *r, const char *word)
{
	size_t n = strlen(word);
	bool is = r->n - r->at >= n && memcmp(r->text + r->at, word, n) == 0;
	if (is) r->at += n;
	return is;
}

static json_t *read_value(reader *r)
{
	char c = peek(r);
	if (c == '"') return read_text(r);
	if (is_word(r, "true")) return json_true();
	if (is_word(r, "false")) return json_false();
	if (is_word(r, "null")) return json_null();
	if (c != '[' && c != '{') return read_number(r);
	if (r->depth == TS_JSON_DEPTH) return wrong(r, "nested more than 64 deep");
	r->depth++;
	json_t *value = c == '[' ? read_list(r) : read_object(r);
	r->depth--;
	return value;
}

static void say_where(const reader *r, const char *what)
{
	size_t line = 1, column = 1;
	for (size_t i = 0; i < r->at && i < r->n; i++) {
		column = r->text[i] == '\n' ? 1 : column + 1;
		line += r->text[i] == '\n';
	}
	ts_fail("%s%sline %zu, column %zu: %s; JSON is expected", what, what[0] != 0 ? ": " : "", line, column, r->problem);
}

json_t *ts_json_read(const char *text, size_t n, bool zeros, const char *what)
{
	reader r = {.text = text, .n = n, .zeros = zeros, .block = ts_alloc(n + 1, 1, what)};
	if (r.block == NULL) return NULL;
	json_t *value = read_value(&r);
	if (value != NULL && (peek(&r), r.at < r.n)) {
		json_decref(value);
		value = wrong(&r, "more than one value");
	}
	free(r.block);
	if (value != NULL) return value;
	if (r.problem != NULL) {
		say_where(&r, what);
	} else {
		ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", what);
	}
	return NULL;
}

bool ts_json_whole(json_int_t *n, const json_t *value, json_int_t low, json_int_t high)
{
	double x = json_number_value(value);
	if (!json_is_number(value) || !(x >= (double)low && x <= (double)high)) return false;
	*n = json_is_integer(value) ? json_integer_value(value) : (json_int_t)x;
	return (double)*n == x && *n >= low && *n <= high;
}

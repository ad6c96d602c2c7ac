/* Headers of .npy files. */
#include "output/npy.h"
#include <assert.h>
#include <ctype.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include "output/file.h"

enum { PREFIX = 10, ALIGNMENT = 64, MOST_DIGITS = 20 };

size_t ts_npy_header(char header[TS_NPY_HEADER], const char *descr, u32 n_dims, const u64 *shape)
{
	char dims[TS_MAX_DIMS * (MOST_DIGITS + 2) + 1] = "";
	size_t used = 0;
	for (u32 i = 0; i < n_dims; i++) {
		used += (size_t)snprintf(dims + used, sizeof dims - used, "%s%" PRIu64, i == 0 ? "" : ", ", shape[i]);
	}
	int n = snprintf(header + PREFIX, TS_NPY_HEADER - PREFIX,
	                 "{'descr': %s, 'fortran_order': False, 'shape': (%s%s), }", descr, dims, n_dims == 1 ? "," : "");
	assert(n > 0 && n < TS_NPY_HEADER - PREFIX);
	size_t bytes = (PREFIX + (size_t)n + 1 + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
	assert(bytes <= TS_NPY_HEADER);
	memset(header + PREFIX + n, ' ', bytes - PREFIX - (size_t)n);
	header[bytes - 1] = '\n';
	size_t text = bytes - PREFIX;
	const unsigned char prefix[PREFIX] = {0x93, 'N', 'U', 'M', 'P', 'Y', 1, 0, text & 0xff, text >> 8 & 0xff};
	memcpy(header, prefix, PREFIX);
	return bytes;
}

/* A part of the header's text. */
typedef struct {
	const char *at, *end;
} span;

static void skip_blanks(span *s)
{
	while (s->at < s->end && isspace((unsigned char)*s->at)) s->at++;
}

static bool take(span *s, char c)
{
	skip_blanks(s);
	if (s->at == s->end || *s->at != c) return false;
	s->at++;
	return true;
}

/* A Python literal, up to a comma, colon or closing bracket of its surroundings. */
static span take_literal(span *s)
{
	skip_blanks(s);
	span literal = {s->at, s->at};
	char quote = 0;
	for (u32 depth = 0; s->at < s->end; s->at++) {
		char c = *s->at;
		if (quote != 0) {
			quote = c == quote ? 0 : quote;
		} else if (c == '\'' || c == '"') {
			quote = c;
		} else if (strchr("([{", c) != NULL && c != 0) {
			depth++;
		} else if (depth == 0 && c != 0 && strchr(",:)]}", c) != NULL) {
			break;
		} else if (c != 0 && strchr(")]}", c) != NULL) {
			depth--;
		}
	}
	literal.end = s->at;
	return literal;
}

/* Equal except for blanks outside of quotes, the kind of quotes, and the byte order of single bytes. */
static bool same_literal(span a, span b)
{
	bool quoted = false;
	for (;;) {
		if (!quoted) {
			skip_blanks(&a);
			skip_blanks(&b);
		}
		if (a.at == a.end || b.at == b.end) return a.at == a.end && b.at == b.end;
		char x = *a.at == '"' ? '\'' : *a.at, y = *b.at == '"' ? '\'' : *b.at;
		bool order = y == '|' && (x == '<' || x == '>' || x == '=');
		if (x != y && !order) return false;
		quoted ^= x == '\'';
		a.at++;
		b.at++;
	}
}

static span text_of(const char *text) { return (span){text, text + strlen(text)}; }

/* "(3, 4)", "(3,)": 1 to TS_MAX_DIMS whole numbers. */
static bool parse_shape(span s, u32 *n_dims, u64 shape[TS_MAX_DIMS])
{
	bool comma = false;
	*n_dims = 0;
	if (!take(&s, '(')) return false;
	while (!take(&s, ')')) {
		u64 n = 0;
		skip_blanks(&s);
		if (*n_dims == TS_MAX_DIMS || s.at == s.end || !isdigit((unsigned char)*s.at)) return false;
		for (; s.at < s.end && isdigit((unsigned char)*s.at); s.at++) {
			u64 digit = (u64)(*s.at - '0');
			if (n > (UINT64_MAX - digit) / 10) return false;
			n = n * 10 + digit;
		}
		shape[(*n_dims)++] = n;
		bool more = take(&s, ',');
		if (!more && (s.at == s.end || *s.at != ')')) return false;
		comma |= more;
	}
	skip_blanks(&s);
	return s.at == s.end && comma; /* "(3)" is a number */
}

typedef struct {
	span descr, order, shape;
} header_text;

static bool parse_dict(span s, header_text *h)
{
	*h = (header_text){{NULL, NULL}, {NULL, NULL}, {NULL, NULL}};
	if (!take(&s, '{')) return false;
	while (!take(&s, '}')) {
		span key = take_literal(&s);
		if (!take(&s, ':')) return false;
		span value = take_literal(&s);
		span *to = same_literal(key, text_of("'descr'"))           ? &h->descr
		           : same_literal(key, text_of("'fortran_order'")) ? &h->order
		           : same_literal(key, text_of("'shape'"))         ? &h->shape
		                                                           : NULL;
		if (to == NULL || to->at != NULL || value.at == value.end) return false;
		*to = value;
		if (!take(&s, ',') && (s.at == s.end || *s.at != '}')) return false;
	}
	skip_blanks(&s);
	return s.at == s.end && h->descr.at != NULL && h->order.at != NULL && h->shape.at != NULL;
}

/* The text of the header, without the prefix; false if the file is no .npy or ends within it. */
static bool find_text(const char *head, size_t head_bytes, span *text)
{
	if (head_bytes < PREFIX || memcmp(head, "\x93NUMPY", 6) != 0) return false;
	const unsigned char *raw = (const unsigned char *)head;
	if (raw[6] < 1 || raw[6] > 3 || raw[7] != 0) return false;
	size_t prefix = raw[6] == 1 ? PREFIX : PREFIX + 2;
	if (head_bytes < prefix) return false;
	size_t n = raw[8] | (size_t)raw[9] << 8;
	if (raw[6] != 1) n |= (size_t)raw[10] << 16 | (size_t)raw[11] << 24;
	*text = (span){head + prefix, head + prefix + n};
	return n <= head_bytes - prefix;
}

ts_status ts_npy_parse(ts_npy *npy, const char *path, const char *head, size_t head_bytes, u64 file_bytes,
                       const char *descr, size_t element_bytes)
{
	span text;
	header_text h;
	if (!find_text(head, head_bytes, &text) || !parse_dict(text, &h)) {
		return ts_fail("%s: not a .npy file of version 1 to 3 with a header below %d bytes", path, TS_NPY_HEADER);
	}
	if (!same_literal(h.descr, text_of(descr))) {
		ptrdiff_t n = h.descr.end - h.descr.at;
		return ts_fail("%s: dtype %.*s; %s would be right", path, (int)(n > 400 ? 400 : n), h.descr.at, descr);
	}
	if (!same_literal(h.order, text_of("False"))) return ts_fail("%s: Fortran order; C order would be right", path);
	u64 bytes;
	if (!parse_shape(h.shape, &npy->n_dims, npy->shape) || !ts_shape_count(&npy->n, npy->n_dims, npy->shape) ||
	    !ts_shape_count(&bytes, 2, (u64[]){npy->n, element_bytes})) {
		return ts_fail("%s: its shape is not 1 to %d whole numbers whose product a file can hold", path, TS_MAX_DIMS);
	}
	npy->data_at = (u64)(text.end - head);
	u64 held = file_bytes > npy->data_at ? file_bytes - npy->data_at : 0;
	if (held == bytes) return TS_OK;
	return ts_fail("%s: %" PRIu64 " bytes of data; its shape needs %" PRIu64, path, held, bytes);
}

ts_status ts_npy_write(const char *path, const char *header, size_t header_bytes, const void *data, size_t bytes)
{
	ts_file file;
	if (ts_file_begin(&file, path) != TS_OK) return TS_ERROR;
	if (ts_file_put(&file, header, header_bytes) == TS_OK && ts_file_put(&file, data, bytes) == TS_OK) {
		return ts_file_end(&file);
	}
	ts_file_drop(&file);
	return TS_ERROR;
}

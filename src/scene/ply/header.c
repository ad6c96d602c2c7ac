/* The lines of a PLY header, from "ply" to "end_header". */
#include "scene/ply/header.h"
#include <float.h>
#include <stdio.h>
#include <string.h>
#include "kernels/base/num.h"
#include "model/core.h"
#include "model/input.h"

const ts_ply_kind ts_ply_kinds[TS_PLY_TYPES] = {
	[TS_PLY_I8] = {{"char", "int8"}, 1, INT8_MIN, INT8_MAX},
	[TS_PLY_U8] = {{"uchar", "uint8"}, 1, 0, UINT8_MAX},
	[TS_PLY_I16] = {{"short", "int16"}, 2, INT16_MIN, INT16_MAX},
	[TS_PLY_U16] = {{"ushort", "uint16"}, 2, 0, UINT16_MAX},
	[TS_PLY_I32] = {{"int", "int32"}, 4, INT32_MIN, INT32_MAX},
	[TS_PLY_U32] = {{"uint", "uint32"}, 4, 0, UINT32_MAX},
	[TS_PLY_I64] = {{"int64", "long", "longlong", "int64_t"}, 8, INT64_MIN, 0x1p63},
	[TS_PLY_U64] = {{"uint64", "ulong", "ulonglong", "uint64_t"}, 8, 0, 0x1p64},
	[TS_PLY_F16] = {{"float16", "half"}, 2, -65504, 65504},
	[TS_PLY_F32] = {{"float", "float32"}, 4, -(double)FLT_MAX, (double)FLT_MAX},
	[TS_PLY_F64] = {{"double", "float64"}, 8, -DBL_MAX, DBL_MAX},
};

enum { MOST_WORDS = 5 };
_Static_assert(TS_PLY_ELEMENTS == 64 && TS_PLY_PROPERTIES == 1024 && TS_PLY_LINES == 100000, "the messages say so");

typedef struct {
	const char *at, *end;
	bool is_lone; /* lines end in a \r alone */
	u32 number, n_words;
	char word[MOST_WORDS][TS_PLY_NAME]; /* long words are cut: no keyword is as long */
} line;

static bool is_end(const line *l) { return l->at == l->end || *l->at == '\n' || *l->at == '\r'; }

static bool is_gap(const line *l) { return *l->at == ' ' || *l->at == '\t'; }

/* All lines end as the first one does: after a lone \r a \n would be the first byte of the points. */
static void end_line(line *l)
{
	bool is_return = l->at < l->end && *l->at == '\r';
	l->at += l->at < l->end;
	bool is_pair = is_return && !l->is_lone && l->at < l->end && *l->at == '\n';
	l->at += is_pair;
	if (l->number == 1) l->is_lone = is_return && !is_pair;
}

/* Ends at \n, \r\n or \r. False at the end of the file. */
static bool next_line(line *l)
{
	l->number++;
	l->n_words = 0;
	if (l->at == l->end) return false;
	while (!is_end(l)) {
		const char *word = l->at;
		while (!is_end(l) && !is_gap(l)) l->at++;
		size_t n = (size_t)(l->at - word);
		if (n > 0 && l->n_words < MOST_WORDS)
			snprintf(l->word[l->n_words], TS_PLY_NAME, "%.*s", (int)(n < TS_PLY_NAME ? n : TS_PLY_NAME - 1), word);
		l->n_words += n > 0;
		while (!is_end(l) && is_gap(l)) l->at++;
	}
	end_line(l);
	return true;
}

static bool is(const line *l, u32 k, const char *word) { return k < l->n_words && strcmp(l->word[k], word) == 0; }

static bool is_comment(const line *l) { return l->n_words == 0 || is(l, 0, "comment") || is(l, 0, "obj_info"); }

static bool read_format(ts_ply_header *h, const line *l)
{
	static const char *const formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};
	for (u32 i = 0; i < 3; i++) {
		h->format = (ts_ply_format)i;
		if (is(l, 0, "format") && is(l, 1, formats[i]) && is(l, 2, "1.0") && l->n_words == 3) return true;
	}
	return false;
}

static bool read_count(u64 *count, const char *text)
{
	*count = 0;
	size_t digits = strspn(text, "0123456789");
	for (size_t i = 0; i < digits && digits <= 18; i++) *count = *count * 10 + (u64)(text[i] - '0');
	return digits > 0 && digits <= 18 && text[digits] == '\0';
}

static bool is_points(const ts_ply_element *e) { return strcmp(e->name, "vertex") == 0; }

const ts_ply_element *ts_ply_header_points(const ts_ply_header *header)
{
	return &header->element[header->n_elements - 1];
}

static const char *read_element(ts_ply_header *h, const line *l)
{
	u64 n;
	if (l->n_words != 3 || !read_count(&n, l->word[2])) return "write element NAME COUNT";
	h->more = h->n_elements > 0 && is_points(ts_ply_header_points(h));
	if (h->more) return NULL;
	if (h->n_elements == TS_PLY_ELEMENTS) return "more than 63 elements before vertex";
	ts_ply_element *e = &h->element[h->n_elements++];
	*e = (ts_ply_element){.n = n, .first = h->n_properties};
	memcpy(e->name, l->word[1], sizeof e->name);
	return NULL;
}

static bool read_type(ts_ply_type *type, const char *name)
{
	for (u32 t = 0; t < TS_PLY_TYPES; t++) {
		*type = (ts_ply_type)t;
		for (u32 k = 0; k < 4 && ts_ply_kinds[t].name[k] != NULL; k++)
			if (strcmp(name, ts_ply_kinds[t].name[k]) == 0) return true;
	}
	return false;
}

static const char *read_property(ts_ply_header *h, const line *l)
{
	bool is_list = is(l, 1, "list");
	if (l->n_words != (is_list ? 5 : 3)) return "write property TYPE NAME or property list TYPE TYPE NAME";
	if (h->n_properties == TS_PLY_PROPERTIES) return "more than 1024 properties up to those of vertex";
	ts_ply_element *e = &h->element[h->n_elements - 1];
	ts_ply_property *p = &h->property[h->n_properties];
	*p = (ts_ply_property){.is_list = is_list};
	if (!read_type(&p->type, l->word[is_list ? 3 : 1]) || !read_type(&p->length, l->word[is_list ? 2 : 1]))
		return "no such type; there are char, uchar, short, ushort, int, uint, int64, uint64, float and double";
	if (is_list && p->length >= TS_PLY_F16) return "the first type of a list, that of its length, must be an integer";
	memcpy(p->name, l->word[is_list ? 4 : 2], sizeof p->name);
	for (u32 i = e->first; i < h->n_properties; i++)
		if (strcmp(p->name, h->property[i].name) == 0) return "a second property of this name";
	e->bytes += h->format == TS_PLY_ASCII ? 2 : ts_ply_kinds[p->length].bytes;
	e->n_properties++;
	h->n_properties++;
	return NULL;
}

/* Reads a line between the format and end_header; returns NULL, or what is wrong. */
static const char *read_line(ts_ply_header *h, const line *l)
{
	if (is_comment(l)) return NULL;
	if (is(l, 0, "element")) return read_element(h, l);
	if (!is(l, 0, "property")) return "begins with none of comment, obj_info, element, property and end_header";
	if (h->n_elements == 0) return "a property before the first element";
	return h->more ? NULL : read_property(h, l);
}

/* The next line that is not a comment; false with what is wrong. */
static bool next_word(line *l, const char **fault)
{
	do {
		if (l->number == TS_PLY_LINES)
			*fault = "more than 100000 lines without end_header";
		else if (!next_line(l))
			*fault = "the header has no end_header";
	} while (*fault == NULL && is_comment(l));
	return *fault == NULL;
}

static const char *read_lines(ts_ply_header *header, line *l)
{
	const char *fault = NULL;
	if (!next_line(l) || !is(l, 0, "ply") || l->n_words != 1) return "a PLY file begins with a line \"ply\"";
	if (!next_word(l, &fault)) return fault;
	if (!read_format(header, l)) return "write format ascii, binary_little_endian or binary_big_endian, and 1.0";
	while (fault == NULL && next_word(l, &fault) && !is(l, 0, "end_header")) fault = read_line(header, l);
	return fault;
}

/* Elements without properties have no bytes, however many there are. */
static bool fits(const ts_ply_header *h, ts_build *build, const char *path, size_t n_bytes)
{
	size_t room = n_bytes - h->begin + (h->format == TS_PLY_ASCII); /* no blank need follow the last number */
	for (const ts_ply_element *e = h->element; e < h->element + h->n_elements; e++) {
		if (e->bytes > 0 && e->n > room / e->bytes)
			ts_build_fail(build, "%s: element %s: %llu of at least %zu bytes each do not fit in a file of %zu bytes",
			              path, e->name, (unsigned long long)e->n, e->bytes, n_bytes);
		if (ts_build_failed(build)) return false;
		room -= e->bytes * e->n;
	}
	const ts_ply_element *points = h->n_elements > 0 ? ts_ply_header_points(h) : NULL;
	if (points == NULL || !is_points(points) || points->n_properties == 0 || points->n == 0)
		ts_build_fail(build, "%s: no points: element vertex is absent or empty", path);
	else if (points->n >= TS_NONE)
		ts_build_fail(build, "%s: %llu points; at most %u can be read", path, (unsigned long long)points->n,
		              TS_NONE - 1);
	return !ts_build_failed(build);
}

bool ts_ply_header_read(ts_ply_header *header, ts_build *build, const char *path, const char *file, size_t n)
{
	line l = {.at = file + ts_text_mark(file, n), .end = file + n};
	*header = (ts_ply_header){.n_elements = 0};
	const char *fault = read_lines(header, &l);
	if (fault != NULL) ts_build_fail(build, "%s: line %u: %s", path, l.number, fault);
	header->begin = (size_t)(l.at - file);
	return fault == NULL && fits(header, build, path, n);
}

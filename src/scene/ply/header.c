/* The lines of a PLY header, from "ply" to "end_header". */
#include "header.h"
#include <stdio.h>
#include <string.h>
#include "../../kernels/base/num.h"

const u32 ts_ply_bytes[TS_PLY_TYPES] = {1, 1, 2, 2, 4, 4, 4, 8};

static const char *const types[][2] = {
	[TS_PLY_I8] = {"char", "int8"},      [TS_PLY_U8] = {"uchar", "uint8"},     [TS_PLY_I16] = {"short", "int16"},
	[TS_PLY_U16] = {"ushort", "uint16"}, [TS_PLY_I32] = {"int", "int32"},      [TS_PLY_U32] = {"uint", "uint32"},
	[TS_PLY_F32] = {"float", "float32"}, [TS_PLY_F64] = {"double", "float64"},
};

enum { MOST_WORDS = 5, MOST_LINES = 1000 };

typedef struct {
	const char *at, *end;
	u32 number, n_words;
	char word[MOST_WORDS][TS_PLY_NAME]; /* what is too long is cut: no keyword is */
} line;

/* Ends at \n, \r\n or \r. False at the end of the file. */
static bool next_line(line *l)
{
	l->number++;
	l->n_words = 0;
	if (l->at >= l->end) return false;
	while (l->at < l->end && *l->at != '\n' && *l->at != '\r') {
		while (l->at < l->end && (*l->at == ' ' || *l->at == '\t')) l->at++;
		size_t n = 0;
		const char *word = l->at;
		while (l->at<l->end && * l->at> ' ') l->at++, n++;
		if (n == 0 && l->at < l->end && *l->at != '\n' && *l->at != '\r') l->at++, n++;
		if (n == 0) continue;
		if (l->n_words < MOST_WORDS)
			snprintf(l->word[l->n_words], TS_PLY_NAME, "%.*s", (int)(n < TS_PLY_NAME ? n : TS_PLY_NAME - 1), word);
		l->n_words++;
	}
	bool pair = l->end - l->at >= 2 && l->at[0] == '\r' && l->at[1] == '\n';
	l->at += pair ? 2 : l->at < l->end;
	return true;
}

static bool is(const line *l, u32 k, const char *word) { return k < l->n_words && strcmp(l->word[k], word) == 0; }

static bool read_format(ts_ply_header *h, const line *l)
{
	static const char *const formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};
	for (u32 i = 0; i < 3; i++) {
		h->format = (ts_ply_format)i;
		if (is(l, 1, formats[i]) && is(l, 2, "1.0") && l->n_words == 3) return true;
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

static const char *read_property(ts_ply_header *h, const line *l)
{
	if (is(l, 1, "list")) return "a list is no property of a point";
	if (l->n_words != 3) return "write property TYPE NAME";
	if (h->n_properties == TS_PLY_PROPERTIES) return "more than 64 properties";
	ts_ply_property *p = &h->property[h->n_properties];
	for (u32 t = 0; t < TS_PLY_TYPES; t++) {
		if (!is(l, 1, types[t][0]) && !is(l, 1, types[t][1])) continue;
		for (u32 i = 0; i < h->n_properties; i++)
			if (is(l, 2, h->property[i].name)) return "a second property of this name";
		*p = (ts_ply_property){.type = (ts_ply_type)t};
		memcpy(p->name, l->word[2], sizeof p->name);
		h->stride += h->format == TS_PLY_ASCII ? 2 : ts_ply_bytes[t];
		h->n_properties++;
		return NULL;
	}
	return "no such type; there are char, uchar, short, ushort, int, uint, float and double";
}

/* What a line between the format and end_header says; NULL, or what is wrong with it. */
static const char *read_line(ts_ply_header *h, const line *l, u64 *count, u32 *n_elements)
{
	if (is(l, 0, "comment") || is(l, 0, "obj_info") || l->n_words == 0) return NULL;
	if (is(l, 0, "element")) {
		u64 n;
		if (l->n_words != 3 || !read_count(&n, l->word[2])) return "write element NAME COUNT";
		if ((*n_elements)++ > 0) return NULL;
		*count = n;
		return is(l, 1, "vertex") ? NULL : "the first element must be vertex";
	}
	if (!is(l, 0, "property")) return "begins with none of comment, obj_info, element, property and end_header";
	if (*n_elements == 0) return "a property before the first element";
	return *n_elements == 1 ? read_property(h, l) : NULL;
}

static bool fits(ts_ply_header *h, ts_build *build, const char *path, u64 count, size_t n_bytes)
{
	u64 room = n_bytes - h->begin + (h->format == TS_PLY_ASCII); /* the last number needs no blank behind it */
	if (h->n_properties == 0 || count == 0)
		ts_build_fail(build, "%s: no points: element vertex is absent or empty", path);
	else if (count > room / h->stride || count >= TS_NONE)
		ts_build_fail(build, "%s: %llu points of at least %zu bytes do not fit in the %zu bytes behind the header",
		              path, (unsigned long long)count, h->stride, n_bytes - h->begin);
	h->n = (u32)count;
	return !ts_build_failed(build);
}

bool ts_ply_header_read(ts_ply_header *header, ts_build *build, const char *path, const char *file, size_t n)
{
	line l = {.at = file, .end = file + n};
	u64 count = 0;
	u32 n_elements = 0;
	const char *fault = NULL;
	*header = (ts_ply_header){.n = 0};
	if (!next_line(&l) || !is(&l, 0, "ply") || l.n_words != 1) fault = "a PLY file begins with a line \"ply\"";
	if (fault == NULL && (!next_line(&l) || !is(&l, 0, "format") || !read_format(header, &l)))
		fault = "write format ascii, binary_little_endian or binary_big_endian, and 1.0";
	while (fault == NULL) {
		if (l.number > MOST_LINES || !next_line(&l))
			fault = "the header has no end_header";
		else if (is(&l, 0, "end_header"))
			break;
		else
			fault = read_line(header, &l, &count, &n_elements);
	}
	if (fault != NULL) ts_build_fail(build, "%s: line %u: %s", path, l.number, fault);
	header->begin = (size_t)(l.at - file);
	header->more = n_elements > 1;
	return fault == NULL && fits(header, build, path, count, n);
}

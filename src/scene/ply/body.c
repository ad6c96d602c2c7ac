/* Numbers of PLY files: text, and words in either order. */
#include "scene/ply/body.h"
#include <math.h>
#include "model/decimal.h"

static const char at_end[] = "is missing: the file ends before it";

static double half_of(u32 word)
{
	u32 exponent = word >> 10 & 31, part = word & 1023;
	double size = (exponent == 0 ? part : (u64)(1024 + part) << (exponent - 1)) * 0x1p-24;
	if (exponent == 31) size = part == 0 ? INFINITY : NAN;
	return word >> 15 & 1 ? -size : size;
}

static double number_of_bytes(const unsigned char bytes[8], ts_ply_type type)
{
	union {
		u64 word;
		double f64;
	} wide = {.word = 0};
	union {
		u32 word;
		f32 f32;
	} narrow;
	for (u32 k = 0; k < ts_ply_kinds[type].bytes; k++) wide.word |= (u64)bytes[k] << 8 * k;
	narrow.word = (u32)wide.word;
	switch (type) {
	case TS_PLY_I64: return (double)(i64)wide.word;
	case TS_PLY_F16: return half_of((u32)wide.word);
	case TS_PLY_I8: return (double)(int8_t)wide.word;
	case TS_PLY_I16: return (double)(int16_t)wide.word;
	case TS_PLY_I32: return (double)(int32_t)wide.word;
	case TS_PLY_F32: return (double)narrow.f32;
	case TS_PLY_F64: return wide.f64;
	default: return (double)wide.word;
	}
}

static const char *read_binary(ts_ply_body *body, ts_ply_type type, double *value)
{
	unsigned char bytes[8];
	u32 n = ts_ply_kinds[type].bytes;
	if ((size_t)(body->end - body->at) < n) return at_end;
	for (u32 k = 0; k < n; k++) bytes[body->format == TS_PLY_BIG ? n - 1 - k : k] = (unsigned char)body->at[k];
	body->at += n;
	*value = number_of_bytes(bytes, type);
	return NULL;
}

static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

static const char *read_ascii(ts_ply_body *body, double *value)
{
	while (is_blank(*body->at)) body->at++;
	if (body->at == body->end) return at_end;
	char *end;
	*value = ts_strtod(body->at, &end);
	bool good = end != body->at && end <= body->end && (is_blank(*end) || end == body->end);
	body->at = end;
	return good ? NULL : "is no number";
}

const char *ts_ply_number(ts_ply_body *body, ts_ply_type type, double *value)
{
	return body->format == TS_PLY_ASCII ? read_ascii(body, value) : read_binary(body, type, value);
}

bool ts_ply_holds(ts_ply_type type, double value)
{
	const ts_ply_kind *kind = &ts_ply_kinds[type];
	bool whole = !(value > -0x1p53 && value < 0x1p53) || value == (double)(i64)value;
	return value >= kind->least && value <= kind->most && (type >= TS_PLY_F16 || whole);
}

static const char *skip_list(ts_ply_body *body, const ts_ply_property *list)
{
	double length, ignored;
	const char *fault = ts_ply_number(body, list->length, &length);
	if (fault != NULL) return fault;
	if (!ts_ply_holds(list->length, length) || length < 0.0)
		return "has no length; a whole number of its type, not below 0, would be right";
	u64 n = (u64)length, bytes = n * ts_ply_kinds[list->type].bytes;
	if (body->format == TS_PLY_ASCII) {
		for (u64 i = 0; i < n && fault == NULL; i++) fault = read_ascii(body, &ignored);
		return fault;
	}
	if (bytes > (size_t)(body->end - body->at)) return at_end;
	body->at += bytes;
	return NULL;
}

const char *ts_ply_skip(ts_ply_body *body, const ts_ply_property *property)
{
	double ignored;
	return property->is_list ? skip_list(body, property) : ts_ply_number(body, property->type, &ignored);
}

/* Points of a PLY file as surfels: an own reader, which trusts no count. Properties: x y z, and nx ny nz, and red green
 * blue, and radius or the half-axes u_x u_y u_z v_x v_y v_z; the others are ignored. */
#include <errno.h>
#include <float.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../../model/core.h"
#include "../numbers.h"
#include "../neighbours.h"
#include "header.h"
#include "../sources.h"
#include "../srgb_table.h"
#include "../surfel.h"

typedef struct {
	f32 centre[3], normal[3], colour[3], u[3], v[3], radius;
} point;
#define AT(field) (offsetof(point, field) / sizeof(f32))

/* What is known, in groups that a file has whole or not at all. */
enum { CENTRE, NORMAL, COLOUR, AXES, RADIUS, N_GROUPS };
static const struct {
	const char *name;
	u32 group;
	size_t at;
} fields[] = {
	{"x", CENTRE, AT(centre)},      {"y", CENTRE, AT(centre) + 1},     {"z", CENTRE, AT(centre) + 2},
	{"nx", NORMAL, AT(normal)},     {"ny", NORMAL, AT(normal) + 1},    {"nz", NORMAL, AT(normal) + 2},
	{"red", COLOUR, AT(colour)},    {"green", COLOUR, AT(colour) + 1}, {"blue", COLOUR, AT(colour) + 2},
	{"u_x", AXES, AT(u)},           {"u_y", AXES, AT(u) + 1},          {"u_z", AXES, AT(u) + 2},
	{"v_x", AXES, AT(v)},           {"v_y", AXES, AT(v) + 1},          {"v_z", AXES, AT(v) + 2},
	{"radius", RADIUS, AT(radius)},
};
enum { N_FIELDS = sizeof fields / sizeof *fields };

typedef struct {
	ts_build *build;
	const char *path;
	ts_ply_header header;
	u32 field[TS_PLY_PROPERTIES]; /* of each property; TS_NONE: ignored */
	bool has[N_GROUPS];
	char *file;
	const char *at, *end;
} reader;

static void choose_fields(reader *in)
{
	u32 found[N_GROUPS] = {0}, whole[N_GROUPS] = {0};
	for (u32 i = 0; i < in->header.n_properties; i++) {
		in->field[i] = TS_NONE;
		for (u32 f = 0; f < N_FIELDS; f++)
			if (strcmp(fields[f].name, in->header.property[i].name) == 0) in->field[i] = f;
		if (in->field[i] != TS_NONE)
			found[fields[in->field[i]].group]++;
		else
			ts_build_note(in->build, "the property \"%s\" of points is ignored", in->header.property[i].name);
	}
	for (u32 f = 0; f < N_FIELDS; f++) whole[fields[f].group]++;
	for (u32 f = 0; f < N_FIELDS; f++) {
		u32 group = fields[f].group;
		in->has[group] = found[group] == whole[group];
		if (found[group] > 0 && !in->has[group])
			ts_build_fail(in->build, "%s: of the properties with \"%s\" %u are there; it takes %u", in->path,
			              fields[f].name, found[group], whole[group]);
	}
	if (!in->has[CENTRE]) ts_build_fail(in->build, "%s: points need the properties x, y and z", in->path);
	if (!in->has[NORMAL] && !in->has[AXES])
		ts_build_fail(in->build, "%s: points need normals, nx, ny and nz, or half-axes, u_x to v_z", in->path);
	if (in->header.more) ts_build_note(in->build, "elements behind the points are ignored");
}

/* Colours of a byte are sRGB-coded, as everywhere; of a float linear. */
static void check_colours(reader *in)
{
	for (u32 i = 0; i < in->header.n_properties; i++) {
		const ts_ply_property *p = &in->header.property[i];
		bool is_colour = in->field[i] != TS_NONE && fields[in->field[i]].group == COLOUR;
		if (is_colour && p->type != TS_PLY_U8 && p->type != TS_PLY_F32 && p->type != TS_PLY_F64)
			ts_build_fail(in->build, "%s: the property %s must be uchar or float", in->path, p->name);
	}
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
	for (u32 k = 0; k < ts_ply_bytes[type]; k++) wide.word |= (u64)bytes[k] << 8 * k;
	narrow.word = (u32)wide.word;
	switch (type) {
	case TS_PLY_I8: return (double)(int8_t)wide.word;
	case TS_PLY_I16: return (double)(int16_t)wide.word;
	case TS_PLY_I32: return (double)(int32_t)wide.word;
	case TS_PLY_F32: return (double)narrow.f32;
	case TS_PLY_F64: return wide.f64;
	default: return (double)wide.word;
	}
}

/* The file has the bytes: the header was checked against them. */
static double read_binary(reader *in, ts_ply_type type)
{
	unsigned char bytes[8];
	u32 n = ts_ply_bytes[type];
	for (u32 k = 0; k < n; k++) bytes[in->header.format == TS_PLY_BIG ? n - 1 - k : k] = (unsigned char)in->at[k];
	in->at += n;
	return number_of_bytes(bytes, type);
}

static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/* The file ends in a NUL of ours. False where there is no number. */
static bool read_ascii(reader *in, double *value)
{
	while (is_blank(*in->at)) in->at++;
	char *end;
	*value = strtod(in->at, &end);
	bool good = end != in->at && end <= in->end && (is_blank(*end) || end == in->end);
	in->at = end;
	return good;
}

/* What is written as text is held to its type, as what is binary is by its bytes. */
static void check_number(reader *in, u32 i, const ts_ply_property *p, double value)
{
	static const struct {
		double least, most;
	} of[TS_PLY_TYPES] = {[TS_PLY_I8] = {INT8_MIN, INT8_MAX},
	                      [TS_PLY_U8] = {0, UINT8_MAX},
	                      [TS_PLY_I16] = {INT16_MIN, INT16_MAX},
	                      [TS_PLY_U16] = {0, UINT16_MAX},
	                      [TS_PLY_I32] = {INT32_MIN, INT32_MAX},
	                      [TS_PLY_U32] = {0, UINT32_MAX},
	                      [TS_PLY_F32] = {-(double)FLT_MAX, (double)FLT_MAX},
	                      [TS_PLY_F64] = {-DBL_MAX, DBL_MAX}};
	bool whole = p->type < TS_PLY_F32;
	if (value >= of[p->type].least && value <= of[p->type].most && (!whole || value == floor(value))) return;
	ts_build_fail(in->build, "%s: point %u: %s is %g; a %snumber from %g to %g would be right", in->path, i, p->name,
	              value, whole ? "whole " : "", of[p->type].least, of[p->type].most);
}

static f32 colour_of(reader *in, u32 i, const ts_ply_property *p, double value)
{
	if (!(value >= 0.0))
		ts_build_fail(in->build, "%s: point %u: %s is %g; it must not be below 0", in->path, i, p->name, value);
	if (ts_build_failed(in->build)) return 0.0f;
	return p->type == TS_PLY_U8 ? (f32)ts_srgb_linear[(u32)value] / 65535.0f : ts_number(value);
}

static point read_point(reader *in, u32 i)
{
	point p = {.colour = {1.0f, 1.0f, 1.0f}};
	f32 record[sizeof p / sizeof(f32)];
	memcpy(record, &p, sizeof p);
	for (u32 k = 0; k < in->header.n_properties && !ts_build_failed(in->build); k++) {
		const ts_ply_property *property = &in->header.property[k];
		u32 f = in->field[k];
		double value = 0.0;
		if (in->header.format != TS_PLY_ASCII)
			value = read_binary(in, property->type);
		else if (!read_ascii(in, &value))
			ts_build_fail(in->build, "%s: point %u: %s is no number", in->path, i, property->name);
		if (f == TS_NONE) continue;
		if (!isfinite(value)) ts_build_fail(in->build, "%s: point %u: %s is not finite", in->path, i, property->name);
		check_number(in, i, property, value);
		record[fields[f].at] = fields[f].group == COLOUR ? colour_of(in, i, property, value) : ts_number(value);
	}
	memcpy(&p, record, sizeof p);
	return p;
}

static void add(reader *in, u32 i, const point *p, f32 radius)
{
	ts_surfel s = {.u = {p->u[0], p->u[1], p->u[2]}, .v = {p->v[0], p->v[1], p->v[2]}};
	const char *fault = in->has[AXES] ? ts_surfel_ellipse(&s, in->has[NORMAL] ? p->normal : NULL)
	                                  : ts_surfel_circle(&s, p->normal, radius);
	memcpy(s.centre, p->centre, sizeof s.centre);
	memcpy(s.colour, p->colour, sizeof s.colour);
	if (fault != NULL) ts_build_fail(in->build, "%s: point %u: %s", in->path, i, fault);
	ts_build_surfel(in->build, &s);
}

/* Points whose neighbours are all in the same place have no size and are left out. */
static void add_sized(reader *in, const point *points, const f32 *distance)
{
	u32 n_lost = 0;
	for (u32 i = 0; i < in->header.n && !ts_build_failed(in->build); i++) {
		if (distance[i] > 0.0f)
			add(in, i, &points[i], distance[i]);
		else
			n_lost++;
	}
	if (n_lost > 0)
		ts_build_note(in->build, "%u points are not drawn: their neighbours are all in the same place", n_lost);
}

/* Radii by the neighbours, of which all must be known first. */
static void give_sizes(reader *in, u32 neighbours)
{
	u32 n = in->header.n;
	point *points = ts_alloc(n, sizeof *points, "points");
	ts_v3 *centres = ts_alloc(n, sizeof *centres, "points");
	f32 *distance = ts_alloc(n, sizeof *distance, "radii of points");
	bool good = points != NULL && centres != NULL && distance != NULL;
	for (u32 i = 0; good && i < n && !ts_build_failed(in->build); i++) {
		points[i] = read_point(in, i);
		centres[i] = ts_load3(points[i].centre);
	}
	good = good && !ts_build_failed(in->build) && ts_neighbours_distance(distance, centres, n, neighbours) == TS_OK;
	if (good)
		add_sized(in, points, distance);
	else
		ts_build_fail(in->build, "%s", ts_error_message());
	free(points);
	free(centres);
	free(distance);
}

static void add_all(reader *in, u32 neighbours)
{
	if (!in->has[AXES] && !in->has[RADIUS]) {
		give_sizes(in, neighbours);
		return;
	}
	for (u32 i = 0; i < in->header.n && !ts_build_failed(in->build); i++) {
		point p = read_point(in, i);
		if (!ts_build_failed(in->build)) add(in, i, &p, p.radius);
	}
}

/* Numbers have a decimal point, whatever the host program's locale. */
static void add_points(reader *in, u32 neighbours)
{
	locale_t c = newlocale(LC_NUMERIC_MASK, "C", (locale_t)0);
	if (c == (locale_t)0) {
		ts_build_fail(in->build, "%s: out of memory", in->path);
		return;
	}
	locale_t before = uselocale(c);
	add_all(in, neighbours);
	uselocale(before);
	freelocale(c);
}

/* All of a file, with a NUL behind it. */
static char *file_read(ts_build *build, const char *path, size_t *n)
{
	FILE *file = fopen(path, "rb");
	char *text = NULL;
	long size = file != NULL && fseek(file, 0, SEEK_END) == 0 ? ftell(file) : -1;
	if (size < 0 || fseek(file, 0, SEEK_SET) != 0)
		ts_build_fail(build, "%s: %s", path, strerror(errno));
	else if ((u64)size > ts_memory_total() / 3)
		ts_build_fail(build, "%s: %ld bytes are more than a third of this machine's memory", path, size);
	else if ((text = ts_alloc((size_t)size + 1, 1, "a file")) == NULL)
		ts_build_fail(build, "%s", ts_error_message());
	else if (fread(text, 1, (size_t)size, file) != (size_t)size)
		ts_build_fail(build, "%s: cannot be read", path);
	if (text != NULL) text[size] = '\0';
	if (file != NULL) fclose(file);
	*n = text != NULL ? (size_t)size : 0;
	return text;
}

void ts_ply_load(ts_build *build, const char *path, u32 neighbours)
{
	reader in = {.build = build, .path = path};
	size_t n;
	in.file = file_read(build, path, &n);
	if (!ts_build_failed(build) && ts_ply_header_read(&in.header, build, path, in.file, n)) {
		in.at = in.file + in.header.begin;
		in.end = in.file + n;
		choose_fields(&in);
		if (!ts_build_failed(build)) check_colours(&in);
		if (!ts_build_failed(build)) add_points(&in, neighbours);
	}
	free(in.file);
}

/* Points of a PLY file as surfels: a reader of our own, which trusts no count. Properties: x y z, and nx ny nz, and red
 * green blue, and radius or the half-axes u_x u_y u_z v_x v_y v_z; the others are ignored. Missing normals and radii
 * are estimated from the neighbours. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "model/core.h"
#include "scene/gltf/numbers.h"
#include "scene/neighbours.h"
#include "scene/normals.h"
#include "scene/ply/body.h"
#include "scene/sources.h"
#include "scene/srgb_table.h"
#include "scene/surfel.h"

typedef struct {
	f32 centre[3], normal[3], colour[3], u[3], v[3], radius;
} point;
#define AT(field) (offsetof(point, field) / sizeof(f32))

/* Known properties, in groups that a file has whole or not at all. */
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
	u32 n, n_properties;             /* of the points */
	const ts_ply_property *property; /* of the points */
	u32 field[TS_PLY_PROPERTIES];    /* of each property; TS_NONE: ignored */
	bool has[N_GROUPS];
	ts_ply_body body;
} reader;

static u32 field_of(reader *in, const ts_ply_property *p)
{
	for (u32 f = 0; f < N_FIELDS; f++) {
		if (strcmp(fields[f].name, p->name) != 0) continue;
		if (p->is_list) ts_build_fail(in->build, "%s: the property %s must not be a list", in->path, p->name);
		return f;
	}
	ts_build_note(in->build, "the property \"%s\" of points is ignored", p->name);
	return TS_NONE;
}

static void choose_fields(reader *in)
{
	u32 found[N_GROUPS] = {0}, whole[N_GROUPS] = {0};
	for (u32 i = 0; i < in->n_properties; i++) {
		in->field[i] = field_of(in, &in->property[i]);
		if (in->field[i] != TS_NONE) found[fields[in->field[i]].group]++;
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
		ts_build_note(in->build, "points have no normals: they are estimated by the points around each");
	if (in->header.n_elements > 1) ts_build_note(in->build, "elements before the points are ignored");
	if (in->header.more) ts_build_note(in->build, "elements behind the points are ignored");
}

/* Integer colours are sRGB-coded, as everywhere; float ones linear. */
static void check_colours(reader *in)
{
	for (u32 i = 0; i < in->n_properties; i++) {
		const ts_ply_property *p = &in->property[i];
		bool is_colour = in->field[i] != TS_NONE && fields[in->field[i]].group == COLOUR;
		if (is_colour && p->type != TS_PLY_U8 && p->type != TS_PLY_U16 && p->type < TS_PLY_F32)
			ts_build_fail(in->build, "%s: the property %s must be uchar, ushort or float", in->path, p->name);
	}
}

/* A number in text must fit its type, as a binary number always does. */
static void check_number(reader *in, u32 i, const ts_ply_property *p, double value)
{
	const ts_ply_kind *kind = &ts_ply_kinds[p->type];
	if (!isfinite(value))
		ts_build_fail(in->build, "%s: point %u: %s is not finite", in->path, i, p->name);
	else if (!ts_ply_holds(p->type, value))
		ts_build_fail(in->build, "%s: point %u: %s is %g; a %snumber from %g to %g would be right", in->path, i,
		              p->name, value, p->type < TS_PLY_F32 ? "whole " : "", kind->least, kind->most);
}

/* The 65536 codes of 16 bits: 257 steps from each code of 8 bits to the next. */
static f32 decoded(u32 code)
{
	u32 low = code / 257, part = code % 257;
	u32 rise = part > 0 ? ts_srgb_linear[low + 1] - ts_srgb_linear[low] : 0;
	f32 value = (f32)ts_srgb_linear[low] + (f32)(rise * part) / 257.0f;
	return value / 65535.0f;
}

static f32 colour_of(reader *in, u32 i, const ts_ply_property *p, double value)
{
	if (!(value >= 0.0))
		ts_build_fail(in->build, "%s: point %u: %s is %g; it must not be below 0", in->path, i, p->name, value);
	if (ts_build_failed(in->build)) return 0.0f;
	if (p->type >= TS_PLY_F32) return ts_number(value);
	return decoded(p->type == TS_PLY_U8 ? 257 * (u32)value : (u32)value);
}

static void skip_record(reader *in, const ts_ply_element *e, u64 i)
{
	const char *fault = NULL;
	for (u32 k = e->first; k < e->first + e->n_properties && fault == NULL; k++) {
		const ts_ply_property *p = &in->header.property[k];
		fault = ts_ply_skip(&in->body, p);
		if (fault != NULL)
			ts_build_fail(in->build, "%s: %s %llu: %s %s", in->path, e->name, (unsigned long long)i, p->name, fault);
	}
}

static void skip_to_points(reader *in)
{
	for (const ts_ply_element *e = in->header.element; e < ts_ply_header_points(&in->header); e++) {
		u64 n = e->n_properties > 0 ? e->n : 0;
		for (u64 i = 0; i < n && !ts_build_failed(in->build); i++) skip_record(in, e, i);
	}
}

static point read_point(reader *in, u32 i)
{
	point p = {.colour = {1.0f, 1.0f, 1.0f}};
	f32 record[sizeof p / sizeof(f32)];
	memcpy(record, &p, sizeof p);
	for (u32 k = 0; k < in->n_properties && !ts_build_failed(in->build); k++) {
		const ts_ply_property *property = &in->property[k];
		u32 f = in->field[k];
		double value = 0.0;
		const char *fault =
			f == TS_NONE ? ts_ply_skip(&in->body, property) : ts_ply_number(&in->body, property->type, &value);
		if (fault != NULL) ts_build_fail(in->build, "%s: point %u: %s %s", in->path, i, property->name, fault);
		if (f == TS_NONE) continue;
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

typedef struct {
	point *points;
	ts_v3 *centres, *normals;
	f32 *radii;
} cloud;

/* Points whose neighbours give no size or no normal are left out. */
static void add_estimated(reader *in, cloud *c)
{
	u32 n_same = 0, n_line = 0;
	for (u32 i = 0; i < in->n && !ts_build_failed(in->build); i++) {
		point *p = &c->points[i];
		if (!in->has[RADIUS]) p->radius = c->radii[i];
		if (!in->has[NORMAL]) ts_store3(p->normal, c->normals[i]);
		bool is_same = !in->has[RADIUS] && p->radius == 0.0f;
		bool is_line = !is_same && !in->has[NORMAL] && ts_length(c->normals[i]) == 0.0f;
		n_same += is_same;
		n_line += is_line;
		if (!is_same && !is_line) add(in, i, p, p->radius);
	}
	if (n_same > 0)
		ts_build_note(in->build, "%u points are not drawn: their neighbours are all in the same place", n_same);
	if (n_line > 0)
		ts_build_note(in->build, "%u points are not drawn: they are on a line with their neighbours", n_line);
}

static bool fits_in_memory(reader *in)
{
	u64 bytes = sizeof(point) + 2 * sizeof(ts_v3) + sizeof(f32) + (in->has[NORMAL] ? 0 : TS_NORMALS_BYTES);
	if (in->n > ts_memory_total() / 3 / bytes) {
		ts_build_about(in->build, TS_KIND_MEMORY);
		ts_build_fail(in->build, "%s: %u points take more than a third of this machine's memory", in->path, in->n);
	}
	if (!in->has[NORMAL] && in->n > TS_NORMALS_MOST)
		ts_build_fail(in->build, "%s: %u points without normals; at most %u can be estimated", in->path, in->n,
		              TS_NORMALS_MOST);
	return !ts_build_failed(in->build);
}

/* Estimates normals and radii from the neighbours, once all points are known. */
static void estimate(reader *in, cloud *c, u32 neighbours)
{
	if (c->points == NULL || c->centres == NULL || c->normals == NULL || c->radii == NULL) {
		ts_build_adopt(in->build);
		return;
	}
	for (u32 i = 0; i < in->n && !ts_build_failed(in->build); i++) {
		c->points[i] = read_point(in, i);
		c->centres[i] = ts_load3(c->points[i].centre);
	}
	if (ts_build_failed(in->build)) return;
	ts_status status = TS_OK;
	if (!in->has[RADIUS]) status = ts_neighbours_distance(c->radii, c->centres, in->n, neighbours);
	if (!in->has[NORMAL] && status == TS_OK) status = ts_normals_estimate(c->normals, c->centres, in->n);
	if (status == TS_OK)
		add_estimated(in, c);
	else
		ts_build_adopt(in->build);
}

static void add_cloud(reader *in, u32 neighbours)
{
	if (!fits_in_memory(in)) return;
	cloud c = {.points = ts_alloc(in->n, sizeof *c.points, "points"),
	           .centres = ts_alloc(in->n, sizeof *c.centres, "points"),
	           .normals = ts_alloc(in->n, sizeof *c.normals, "normals of points"),
	           .radii = ts_alloc(in->n, sizeof *c.radii, "radii of points")};
	estimate(in, &c, neighbours);
	free(c.points);
	free(c.centres);
	free(c.normals);
	free(c.radii);
}

static void add_all(reader *in, u32 neighbours)
{
	if (!in->has[AXES] && !(in->has[RADIUS] && in->has[NORMAL])) {
		add_cloud(in, neighbours);
		return;
	}
	for (u32 i = 0; i < in->n && !ts_build_failed(in->build); i++) {
		point p = read_point(in, i);
		if (!ts_build_failed(in->build)) add(in, i, &p, p.radius);
	}
}

static void read_all(reader *in, u32 neighbours)
{
	skip_to_points(in);
	add_all(in, neighbours);
}

/* A copy like the result of ts_input_read. */
static char *copied(size_t *n, const ts_scene_file *from)
{
	char *copy = ts_alloc(from->n_bytes + 1, 1, from->name);
	if (copy == NULL) return NULL;
	memcpy(copy, from->bytes, from->n_bytes);
	copy[from->n_bytes] = 0;
	*n = from->n_bytes;
	return copy;
}

void ts_ply_load(ts_build *build, const ts_scene_file *from, u32 neighbours)
{
	reader in = {.build = build, .path = from->name};
	size_t n;
	ts_build_about(build, TS_KIND_FORMAT);
	char *file = from->bytes != NULL ? copied(&n, from) : ts_input_read(&n, from->name);
	if (file == NULL) ts_build_adopt(build);
	if (file != NULL && ts_ply_header_read(&in.header, build, in.path, file, n)) {
		const ts_ply_element *points = ts_ply_header_points(&in.header);
		in.n = (u32)points->n;
		in.n_properties = points->n_properties;
		in.property = &in.header.property[points->first];
		in.body = (ts_ply_body){.format = in.header.format, .at = file + in.header.begin, .end = file + n};
		choose_fields(&in);
		if (!ts_build_failed(build)) check_colours(&in);
		if (!ts_build_failed(build)) read_all(&in, neighbours);
	}
	free(file);
}

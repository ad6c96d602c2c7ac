/* Points of a PLY file as surfels: a reader of our own, which trusts no count. Properties: x y z, and nx ny nz, and red
 * green blue, and radius or the half-axes u_x u_y u_z v_x v_y v_z; the others are ignored. Missing normals and radii
 * are estimated from the neighbours. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "model/core.h"
#include "model/input.h"
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

/* What other programs call red, green and blue: read where all three are there, the first such row, and no property
 * has these names. */
static const char *const colours[][3] = {
	{"diffuse_red", "diffuse_green", "diffuse_blue"}, /* PMVS, OpenSfM */
	{"r", "g", "b"},
	{"vertex_red", "vertex_green", "vertex_blue"},
};
enum { N_COLOURS = sizeof colours / sizeof *colours };

typedef struct {
	ts_build *build;
	const char *path;
	ts_ply_header header;
	u32 n, n_properties;             /* of the points */
	const ts_ply_property *property; /* of the points */
	u32 field[TS_PLY_PROPERTIES];    /* of each property; TS_NONE: ignored */
	bool has[N_GROUPS];
	ts_ply_body body;
	const char *const *colour_names; /* NULL: red, green and blue */
	double middle[3];                /* is subtracted from the centres */
	double codes; /* of colours that are neither uchar nor ushort: the code of 1; 0: they are linear */
	u32 n_left, n_clamped;
	char left[128]; /* the first point that is left out, and why */
} reader;

/* Values of a point, as the file has them. */
typedef struct {
	double value[N_FIELDS];
} record;

static double least(double a, double b) { return a < b ? a : b; }
static double most(double a, double b) { return a > b ? a : b; }
static double nearest(double x) { return (double)(i64)(x < 0.0 ? x - 0.5 : x + 0.5); }

static u32 field_of(reader *in, const ts_ply_property *p)
{
	for (u32 f = 0; f < N_FIELDS; f++) {
		bool is_other = fields[f].group == COLOUR && in->colour_names != NULL;
		const char *name = is_other ? in->colour_names[fields[f].at - AT(colour)] : fields[f].name;
		if (strcmp(name, p->name) != 0) continue;
		if (p->is_list) ts_build_fail(in->build, "%s: the property %s must not be a list", in->path, p->name);
		return f;
	}
	ts_build_note(in->build, "the property \"%s\" of points is ignored", p->name);
	return TS_NONE;
}

static bool is_there(const reader *in, const char *name)
{
	bool there = false;
	for (u32 i = 0; i < in->n_properties; i++) there |= strcmp(in->property[i].name, name) == 0;
	return there;
}

static void choose_colours(reader *in)
{
	if (is_there(in, "red") || is_there(in, "green") || is_there(in, "blue")) return;
	for (u32 k = 0; k < N_COLOURS && in->colour_names == NULL; k++) {
		const char *const *names = colours[k];
		if (is_there(in, names[0]) && is_there(in, names[1]) && is_there(in, names[2])) in->colour_names = names;
	}
}

static void choose_fields(reader *in)
{
	choose_colours(in);
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

/* A number in text must fit its type, as a binary number always does. */
static void check_number(reader *in, u32 i, const ts_ply_property *p, double value)
{
	const ts_ply_kind *kind = &ts_ply_kinds[p->type];
	if (isfinite(value) && !ts_ply_holds(p->type, value))
		ts_build_fail(in->build, "%s: point %u: %s is %g; a %snumber from %g to %g would be right", in->path, i,
		              p->name, value, p->type < TS_PLY_F16 ? "whole " : "", kind->least, kind->most);
}

/* The 65536 codes of 16 bits: 257 steps from each code of 8 bits to the next. */
static f32 decoded(u32 code)
{
	u32 low = code / 257, part = code % 257;
	u32 rise = part > 0 ? ts_srgb_linear[low + 1] - ts_srgb_linear[low] : 0;
	f32 value = (f32)ts_srgb_linear[low] + (f32)(rise * part) / 257.0f;
	return value / 65535.0f;
}

/* Of uchar and ushort, and of other numbers that go as far, colours are sRGB-coded, as everywhere; floats are
 * linear. */
static f32 colour_of(reader *in, const ts_ply_property *p, double value)
{
	if (p->type == TS_PLY_U8) return decoded(257 * (u32)value);
	if (p->type == TS_PLY_U16) return decoded((u32)value);
	double share = in->codes > 0.0 ? value / in->codes : value, clamped = least(most(share, 0.0), 1.0);
	in->n_clamped += clamped != share;
	return in->codes > 0.0 ? decoded((u32)(clamped * 65535.0 + 0.5)) : ts_number(clamped);
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

static record read_record(reader *in, u32 i)
{
	record r = {{0.0}};
	for (u32 k = 0; k < in->n_properties && !ts_build_failed(in->build); k++) {
		const ts_ply_property *property = &in->property[k];
		u32 f = in->field[k];
		const char *fault =
			f == TS_NONE ? ts_ply_skip(&in->body, property) : ts_ply_number(&in->body, property->type, &r.value[f]);
		if (fault != NULL) ts_build_fail(in->build, "%s: point %u: %s %s", in->path, i, property->name, fault);
		if (f != TS_NONE && fault == NULL) check_number(in, i, property, r.value[f]);
	}
	return r;
}

static void leave_out(reader *in, u32 i, const char *name, const char *fault)
{
	if (in->n_left++ == 0) snprintf(in->left, sizeof in->left, "point %u: %s%s", i, name, fault);
}

/* False, noted, if a number that is read is not finite. */
static bool take_record(reader *in, u32 i, const record *r, point *p)
{
	f32 numbers[sizeof *p / sizeof(f32)];
	*p = (point){.colour = {1.0f, 1.0f, 1.0f}};
	memcpy(numbers, p, sizeof *p);
	for (u32 k = 0; k < in->n_properties; k++) {
		u32 f = in->field[k];
		if (f == TS_NONE || !in->has[fields[f].group]) continue;
		double value = r->value[f];
		if (!isfinite(value)) {
			leave_out(in, i, in->property[k].name, " is not finite");
			return false;
		}
		if (fields[f].group == CENTRE) value -= in->middle[fields[f].at - AT(centre)];
		numbers[fields[f].at] = fields[f].group == COLOUR ? colour_of(in, &in->property[k], value) : ts_number(value);
	}
	memcpy(p, numbers, sizeof *p);
	for (u32 k = 0; k < 3; k++) {
		if (ts_abs(p->centre[k]) <= TS_COORDINATE_LIMIT) continue;
		leave_out(in, i, "", "a coordinate is beyond 16777216");
		return false;
	}
	return true;
}

/* Reads the next point that can be drawn; false: it is left out. */
static bool read_point(reader *in, u32 i, point *p)
{
	record r = read_record(in, i);
	return !ts_build_failed(in->build) && take_record(in, i, &r, p);
}

static void add(reader *in, u32 i, const point *p, f32 radius, bool both_sides)
{
	ts_surfel s = {.u = {p->u[0], p->u[1], p->u[2]}, .v = {p->v[0], p->v[1], p->v[2]}};
	const char *fault = in->has[AXES] ? ts_surfel_ellipse(&s, in->has[NORMAL] ? p->normal : NULL)
	                                  : ts_surfel_circle(&s, p->normal, radius);
	memcpy(s.centre, p->centre, sizeof s.centre);
	memcpy(s.colour, p->colour, sizeof s.colour);
	if (fault != NULL) {
		leave_out(in, i, "", fault);
		return;
	}
	ts_build_surfel(in->build, &s);
	ts_surfel_turn(&s);
	if (both_sides) ts_build_surfel(in->build, &s);
}

typedef struct {
	point *points;
	ts_v3 *centres, *normals;
	f32 *radii;
	u8 *guessed;
	u32 *index, n; /* in the file */
} cloud;

/* Points whose neighbours give no size or no normal are left out. */
static void add_estimated(reader *in, cloud *c)
{
	u32 n_same = 0, n_line = 0, n_guessed = 0;
	for (u32 i = 0; i < c->n && !ts_build_failed(in->build); i++) {
		point *p = &c->points[i];
		if (!in->has[RADIUS]) p->radius = c->radii[i];
		if (!in->has[NORMAL]) ts_store3(p->normal, c->normals[i]);
		bool is_same = !in->has[RADIUS] && p->radius == 0.0f;
		bool is_line = !is_same && !in->has[NORMAL] && ts_length(c->normals[i]) == 0.0f;
		bool both = !is_line && !in->has[NORMAL] && c->guessed[i] != 0;
		n_same += is_same;
		n_line += is_line;
		n_guessed += !is_same && both;
		if (!is_same && !is_line) add(in, c->index[i], p, p->radius, both);
	}
	if (n_same > 0)
		ts_build_note(in->build, "%u points are not drawn: their neighbours are all in the same place", n_same);
	if (n_line > 0)
		ts_build_note(in->build, "%u points are not drawn: they are on a line with their neighbours", n_line);
	if (n_guessed > 0)
		ts_build_note(in->build, "%u points are of sheets, whose front is not known: they are seen from both sides",
		              n_guessed);
}

static bool fits_in_memory(reader *in)
{
	u64 bytes =
		sizeof(point) + 2 * sizeof(ts_v3) + sizeof(f32) + sizeof(u32) + 1 + (in->has[NORMAL] ? 0 : TS_NORMALS_BYTES);
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
	if (c->points == NULL || c->centres == NULL || c->normals == NULL || c->radii == NULL || c->index == NULL ||
	    c->guessed == NULL) {
		ts_build_adopt(in->build);
		return;
	}
	for (u32 i = 0; i < in->n && !ts_build_failed(in->build); i++) {
		if (!read_point(in, i, &c->points[c->n])) continue;
		c->centres[c->n] = ts_load3(c->points[c->n].centre);
		c->index[c->n++] = i;
	}
	if (ts_build_failed(in->build)) return;
	ts_status status = TS_OK;
	if (!in->has[RADIUS]) status = ts_neighbours_distance(c->radii, c->centres, c->n, neighbours);
	if (!in->has[NORMAL] && status == TS_OK) status = ts_normals_estimate(c->normals, c->guessed, c->centres, c->n);
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
	           .radii = ts_alloc(in->n, sizeof *c.radii, "radii of points"),
	           .guessed = ts_alloc(in->n, 1, "points"),
	           .index = ts_alloc(in->n, sizeof *c.index, "points")};
	estimate(in, &c, neighbours);
	free(c.points);
	free(c.centres);
	free(c.normals);
	free(c.radii);
	free(c.guessed);
	free(c.index);
}

static void add_all(reader *in, u32 neighbours)
{
	if (!in->has[AXES] && !(in->has[RADIUS] && in->has[NORMAL])) {
		add_cloud(in, neighbours);
		return;
	}
	for (u32 i = 0; i < in->n && !ts_build_failed(in->build); i++) {
		point p;
		if (read_point(in, i, &p)) add(in, i, &p, p.radius, false);
	}
}

/* What the points say together, which one alone does not. */
typedef struct {
	double low[3], high[3];
	double most; /* of colours */
	u32 n_placed, n_bright, n_normals, n_radii;
} overview;

enum { DOUBTFUL = 2 }; /* no albedo is as great */
#define FARTHEST 1e9   /* no place on Earth has a greater coordinate, in metres or in feet */

/* Of a type that does not say what its numbers mean. */
static bool is_loose_colour(const reader *in, u32 property)
{
	u32 f = in->field[property];
	ts_ply_type type = in->property[property].type;
	return f != TS_NONE && fields[f].group == COLOUR && type != TS_PLY_U8 && type != TS_PLY_U16;
}

static void look_at(reader *in, overview *o, const record *r)
{
	const double *x = r->value, *n = x + 3, radius = x[N_FIELDS - 1];
	double brightest = 0.0;
	if (fabs(x[0]) < FARTHEST && fabs(x[1]) < FARTHEST && fabs(x[2]) < FARTHEST) {
		for (u32 k = 0; k < 3; k++) {
			o->low[k] = o->n_placed > 0 ? least(o->low[k], x[k]) : x[k];
			o->high[k] = o->n_placed > 0 ? most(o->high[k], x[k]) : x[k];
		}
		o->n_placed++;
	}
	for (u32 i = 0; i < in->n_properties; i++)
		if (is_loose_colour(in, i) && isfinite(x[in->field[i]])) brightest = most(brightest, x[in->field[i]]);
	o->most = most(o->most, brightest);
	o->n_bright += brightest > DOUBTFUL;
	o->n_normals += fabs(n[0]) + fabs(n[1]) + fabs(n[2]) > 0.0;
	o->n_radii += radius < 0.0 || radius > 0.0;
}

static bool is_whole_colour(const reader *in)
{
	for (u32 i = 0; i < in->n_properties; i++)
		if (is_loose_colour(in, i) && in->property[i].type < TS_PLY_F16) return true;
	return false;
}

/* Numbers that are not those of an albedo are codes, if most points say so. */
static void choose_codes(reader *in, const overview *o)
{
	bool whole = is_whole_colour(in);
	if (!in->has[COLOUR] || (!whole && o->n_bright <= in->n / 2)) return;
	in->codes = o->most <= 255.0 ? 255.0 : 65535.0;
	if (!whole) ts_build_note(in->build, "colours of floats up to %g are read as codes of %g", o->most, in->codes);
}

#define FAR 65536.0 /* from here on 1/128 is lost */

/* Centres that binary32 would move, as they are far from the origin for their extent, are counted from a middle. */
static void choose_middle(reader *in, const overview *o)
{
	double extent = 0.0, far = 0.0, step = 1.0;
	for (u32 k = 0; k < 3; k++) {
		extent = most(extent, o->high[k] - o->low[k]);
		far = most(far, least(fabs(o->low[k]), fabs(o->high[k])));
	}
	if (!(far > FAR && far > extent)) return;
	while (step < extent) step *= 10.0;
	for (u32 k = 0; k < 3; k++) in->middle[k] = step * nearest((o->low[k] / 2.0 + o->high[k] / 2.0) / step);
	ts_build_origin(in->build, in->middle);
	ts_build_note(in->build, "the points are far from the origin: %.17g, %.17g, %.17g is subtracted", in->middle[0],
	              in->middle[1], in->middle[2]);
}

static void drop(reader *in, u32 group, u32 n, const char *what)
{
	if (!in->has[group] || n > 0) return;
	in->has[group] = false;
	ts_build_note(in->build, "all %s are 0: they are estimated by the points around each", what);
}

static void choose(reader *in, const overview *o)
{
	drop(in, NORMAL, o->n_normals, "normals");
	drop(in, RADIUS, o->n_radii, "radii");
	choose_codes(in, o);
	choose_middle(in, o);
}

static void read_all(reader *in, u32 neighbours)
{
	overview o = {.n_placed = 0};
	skip_to_points(in);
	const ts_ply_body first = in->body;
	for (u32 i = 0; i < in->n && !ts_build_failed(in->build); i++) {
		record r = read_record(in, i);
		look_at(in, &o, &r);
	}
	if (ts_build_failed(in->build)) return;
	choose(in, &o);
	in->body = first;
	add_all(in, neighbours);
	if (in->n_left == in->n) ts_build_fail(in->build, "%s: no point can be drawn; %s", in->path, in->left);
	if (in->n_left > 0) ts_build_note(in->build, "%u points are left out, the first: %s", in->n_left, in->left);
	if (in->n_clamped > 0) ts_build_note(in->build, "%u colours outside 0 to 1 are read as 0 or 1", in->n_clamped);
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

/* Reads a PLY file whole, and only the head of any other, which the reader of headers refuses. */
static char *read_file(size_t *n, const char *path)
{
	char head[16];
	if (ts_input_head(n, head, sizeof head, path) != TS_OK) return NULL;
	const size_t mark = ts_text_mark(head, *n);
	if (*n >= mark + 3 && memcmp(head + mark, "ply", 3) == 0) return ts_input_read(n, path, TS_INPUT_ANY);
	return copied(n, &(ts_scene_file){.name = path, .bytes = head, .n_bytes = *n});
}

void ts_ply_load(ts_build *build, const ts_scene_file *from, u32 neighbours)
{
	reader in = {.build = build, .path = from->name};
	size_t n;
	ts_build_about(build, TS_KIND_FORMAT);
	char *file = from->bytes != NULL ? copied(&n, from) : read_file(&n, from->name);
	if (file == NULL) ts_build_adopt(build);
	if (file != NULL && ts_ply_header_read(&in.header, build, in.path, file, n)) {
		const ts_ply_element *points = ts_ply_header_points(&in.header);
		in.n = (u32)points->n;
		in.n_properties = points->n_properties;
		in.property = &in.header.property[points->first];
		in.body = (ts_ply_body){.format = in.header.format, .at = file + in.header.begin, .end = file + n};
		choose_fields(&in);
		if (!ts_build_failed(build)) read_all(&in, neighbours);
	}
	free(file);
}

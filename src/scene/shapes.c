/* Shapes of the added reflectors (METHODS 4): profiles in a half plane, turned about an axis. */
#include <assert.h>
#include "kernels/base/vec.h"
#include "scene/sources.h"

#define MAX_ROWS 64

/* One point of a profile: distance from the axis, height, and the normal. */
typedef struct {
	f32 r, y, normal_r, normal_y;
} point;

/* A profile runs upwards along the outside of the solid, with the solid to its left. */
typedef struct {
	point points[MAX_ROWS];
	u32 n, segments;
	bool closed;  /* a ring: the last point joins the first */
	bool upright; /* the axis is z instead of y */
	f32 radius;
	u32 material;
} profile;

static u32 add_vertex(ts_build *build, const profile *p, const point *at, u32 segment)
{
	f32 turns = (f32)segment / (f32)p->segments;
	f32 c = ts_cos_turn(turns), s = ts_sin_turn(turns);
	ts_v3 position = ts_scale(ts_v3_make(at->r * c, at->y, at->r * s), p->radius);
	ts_v3 normal = ts_v3_make(at->normal_r * c, at->normal_y, at->normal_r * s);
	if (p->upright) {
		position = ts_v3_make(position.x, -position.z, position.y);
		normal = ts_v3_make(normal.x, -normal.z, normal.y);
	}
	ts_vertex vertex = {.colour = {1.0f, 1.0f, 1.0f, 1.0f}};
	ts_store3(vertex.position, position);
	ts_store3(vertex.normal, normal);
	return ts_build_vertex(build, &vertex);
}

/* The first vertex of a row and its number of vertices: one at the axis. */
typedef struct {
	u32 first, n;
} row;

static u32 corner(row r, u32 segment) { return r.first + segment % r.n; }

static void join(ts_build *build, const profile *p, row low, row high)
{
	for (u32 k = 0; k < p->segments; k++) {
		if (low.n > 1) ts_build_triangle(build, corner(low, k), corner(high, k), corner(low, k + 1), p->material);
		if (high.n > 1) ts_build_triangle(build, corner(low, k + 1), corner(high, k), corner(high, k + 1), p->material);
	}
}

static void revolve(ts_build *build, const profile *p)
{
	row rows[MAX_ROWS];
	assert(p->n <= MAX_ROWS);
	for (u32 j = 0; j < p->n; j++) {
		rows[j].n = p->points[j].r > 0.0f ? p->segments : 1;
		rows[j].first = add_vertex(build, p, &p->points[j], 0);
		for (u32 k = 1; k < rows[j].n; k++) add_vertex(build, p, &p->points[j], k);
	}
	for (u32 j = 1; j < p->n; j++) join(build, p, rows[j - 1], rows[j]);
	if (p->closed) join(build, p, rows[p->n - 1], rows[0]);
}

static void sphere(ts_build *build, profile *p)
{
	p->n = 32;
	p->segments = 32;
	for (u32 j = 0; j < p->n; j++) {
		f32 turns = (f32)j / (f32)(2 * (p->n - 1));
		f32 r = ts_sin_turn(turns), y = -ts_cos_turn(turns);
		p->points[j] = (point){r, y, r, y};
	}
	p->points[0] = (point){0.0f, -1.0f, 0.0f, -1.0f};
	p->points[p->n - 1] = (point){0.0f, 1.0f, 0.0f, 1.0f};
	revolve(build, p);
}

/* Height 1.5 times the width: 0.6 and 0.8 put the rims on the unit ball. The caps have normals of their own. */
static void cylinder(ts_build *build, profile *p)
{
	const f32 wide = 0.6f, high = 0.8f;
	p->segments = 64;
	p->n = 2;
	p->points[0] = (point){0.0f, -high, 0.0f, -1.0f};
	p->points[1] = (point){wide, -high, 0.0f, -1.0f};
	revolve(build, p);
	p->points[0] = (point){wide, high, 0.0f, 1.0f};
	p->points[1] = (point){0.0f, high, 0.0f, 1.0f};
	revolve(build, p);
	p->n = 15;
	for (u32 j = 0; j < p->n; j++) {
		f32 up = (f32)j / (f32)(p->n - 1);
		p->points[j] = (point){wide, (up + up - 1.0f) * high, 1.0f, 0.0f};
	}
	p->points[0].y = -high;
	p->points[p->n - 1].y = high;
	revolve(build, p);
}

static void torus(ts_build *build, profile *p)
{
	const f32 ring = 0.6875f, tube = 0.3125f;
	p->n = 20;
	p->segments = 48;
	p->closed = true;
	p->upright = true;
	for (u32 j = 0; j < p->n; j++) {
		f32 turns = (f32)j / (f32)p->n;
		f32 c = ts_cos_turn(turns), s = ts_sin_turn(turns);
		p->points[j] = (point){ring + tube * c, tube * s, c, s};
	}
	revolve(build, p);
}

/* Catmull-Rom between b and c; *slope receives the derivative. */
static f32 spline(f32 a, f32 b, f32 c, f32 d, f32 t, f32 *slope)
{
	f32 k1 = c - a;
	f32 k2 = 2.0f * a - 5.0f * b + 4.0f * c - d;
	f32 k3 = 3.0f * (b - c) + d - a;
	*slope = 0.5f * (k1 + t * (2.0f * k2 + 3.0f * t * k3));
	return b + 0.5f * t * (k1 + t * (k2 + t * k3));
}

/* A vase with a lid. The profile is mirrored at the axis beyond its ends, so it meets the axis at a right angle. */
static void lathe(ts_build *build, profile *p)
{
	enum { KNOTS = 12, STEPS = 4 };
	static const f32 knots[KNOTS][2] = {
		{-0.34f, -0.92f}, {0.0f, -0.92f}, {0.34f, -0.92f}, {0.64f, -0.64f}, {0.72f, -0.23f}, {0.58f, 0.17f},
		{0.33f, 0.42f},   {0.3f, 0.6f},   {0.4f, 0.77f},   {0.28f, 0.92f},  {0.0f, 0.97f},   {-0.28f, 0.92f},
	};
	p->segments = 28;
	p->n = (KNOTS - 3) * STEPS + 1;
	for (u32 j = 0; j < p->n; j++) {
		u32 k = j / STEPS < KNOTS - 4 ? j / STEPS : KNOTS - 4;
		f32 t = (f32)(j - k * STEPS) / (f32)STEPS;
		f32 slope_r, slope_y;
		f32 r = spline(knots[k][0], knots[k + 1][0], knots[k + 2][0], knots[k + 3][0], t, &slope_r);
		f32 y = spline(knots[k][1], knots[k + 1][1], knots[k + 2][1], knots[k + 3][1], t, &slope_y);
		p->points[j] = (point){r, y, slope_y, -slope_r};
	}
	p->points[0] = (point){0.0f, knots[1][1], 0.0f, -1.0f};
	p->points[p->n - 1] = (point){0.0f, knots[KNOTS - 2][1], 0.0f, 1.0f};
	revolve(build, p);
}

void ts_shape_add(ts_build *build, u32 shape, f32 radius, u32 material)
{
	profile p = {.radius = radius, .material = material};
	switch (shape) {
	case TS_SHAPE_SPHERE: sphere(build, &p); break;
	case TS_SHAPE_CYLINDER: cylinder(build, &p); break;
	case TS_SHAPE_TORUS: torus(build, &p); break;
	case TS_SHAPE_LATHE: lathe(build, &p); break;
	default: ts_build_fail(build, "shape %u is not known; sphere, cylinder, torus and lathe are", shape);
	}
}

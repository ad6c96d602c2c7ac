/* The hall of a scene: how far the eye and the added reflectors may go (view.h has the reasons). A wall stops level
 * rays both at eye height and above furniture; a fan of rays decides, so that one post does not. */
#include <stdlib.h>
#include "kernels/base/scene.h"
#include "model/core.h"
#include "scene/build_parts.h"

#define N_HEIGHTS 2
static const f32 heights[N_HEIGHTS] = {0.35f, 0.6f}; /* of the box, above its floor */
enum { N_RAYS = 9, RANK = 2 };                       /* the distance along a fan is its third smallest */
#define SLOPE 0.03125f                               /* between the rays of a fan: 7 degrees to either side */
#define NEAREST 0.0625f                              /* of half the box: nearer things are furniture */
#define KEPT 0.95f                                   /* of the distance to a wall */
#define UNLIMITED 4611686018427387904.0f

/* A triangle cut at one of the heights: a line seen from above, x and z. */
typedef struct {
	f32 a[2], b[2], normal[2];
	u32 height;
	bool two_sided;
} cut;

typedef struct {
	cut *cuts;
	size_t n, capacity;
	f32 low[2], high[2]; /* of the box */
	f32 middle[2];       /* where the rays start */
} slice;

static void point_at(f32 to[2], ts_v3 a, ts_v3 b, f32 y)
{
	f32 share = (y - a.y) / (b.y - a.y);
	to[0] = a.x + (b.x - a.x) * share;
	to[1] = a.z + (b.z - a.z) * share;
}

/* False if the triangle does not reach from below y to above it. */
static bool cut_at(cut *c, const ts_v3 p[3], f32 y)
{
	bool above[3] = {p[0].y >= y, p[1].y >= y, p[2].y >= y};
	u32 alone = above[0] == above[1] ? 2 : above[0] == above[2] ? 1 : 0;
	if (above[0] == above[1] && above[1] == above[2]) return false;
	point_at(c->a, p[alone], p[(alone + 1) % 3], y);
	point_at(c->b, p[alone], p[(alone + 2) % 3], y);
	return true;
}

/* Static triangles that are not masked, as leaves and glass are. */
static const ts_triangle *wall_at(const ts_scene *scene, u32 i, u32 *flags)
{
	const ts_triangle *t = &scene->triangles[i];
	*flags = t->material < scene->n_materials ? scene->materials[t->material].flags : 0;
	for (u32 k = 0; k < 3; k++)
		if (t->vertex[k] >= scene->n_vertices || !ts_build_is_own(scene, scene->vertices[t->vertex[k]].object))
			return NULL;
	return *flags & TS_MASKED ? NULL : t;
}

static bool slice_make(ts_build *build, slice *s, const f32 levels[N_HEIGHTS])
{
	const ts_scene *scene = build->scene;
	for (u32 i = 0; i < scene->n_triangles && !ts_build_failed(build); i++) {
		u32 flags;
		const ts_triangle *t = wall_at(scene, i, &flags);
		if (!t) continue;
		ts_v3 p[3];
		for (u32 k = 0; k < 3; k++) p[k] = ts_load3(scene->vertices[t->vertex[k]].position);
		for (u32 h = 0; h < N_HEIGHTS; h++) {
			cut c = {.height = h, .two_sided = flags & TS_DOUBLE_SIDED};
			if (!cut_at(&c, p, levels[h])) continue;
			ts_v3 n = ts_cross(ts_sub(p[1], p[0]), ts_sub(p[2], p[0]));
			c.normal[0] = n.x;
			c.normal[1] = n.z;
			s->cuts = ts_build_room(build, s->cuts, s->n, 1, &s->capacity, sizeof c, "walls");
			if (build->failed) return false;
			s->cuts[s->n++] = c;
		}
	}
	return true;
}

/* Shortens those rays of one fan that the cut stops. way is 1 or -1 along the axis. */
static void stop(f32 distance[N_RAYS], const slice *s, const cut *c, u32 axis, f32 way, f32 least)
{
	u32 other = 1 - axis;
	f32 a = (c->a[axis] - s->middle[axis]) * way, b = (c->b[axis] - s->middle[axis]) * way;
	f32 across_a = c->a[other] - s->middle[other], across_b = c->b[other] - s->middle[other];
	if (ts_max(a, b) < least) return;
	for (u32 k = 0; k < N_RAYS; k++) {
		f32 slope = ((f32)k - (f32)(N_RAYS / 2)) * SLOPE;
		f32 side_a = across_a - a * slope, side_b = across_b - b * slope;
		bool faces = c->two_sided || c->normal[axis] * way + c->normal[other] * slope < 0.0f;
		if (!faces || (side_a < 0.0f) == (side_b < 0.0f)) continue;
		f32 along = a + (b - a) * (side_a / (side_a - side_b));
		if (along >= least && along < distance[k]) distance[k] = along;
	}
}

/* The distance to the wall. */
static f32 wall_distance(const slice *s, u32 axis, f32 way)
{
	f32 distance[N_HEIGHTS][N_RAYS];
	f32 least = (s->high[axis] - s->low[axis]) * (0.5f * NEAREST);
	for (u32 k = 0; k < N_RAYS; k++)
		for (u32 h = 0; h < N_HEIGHTS; h++) distance[h][k] = UNLIMITED;
	for (size_t i = 0; i < s->n; i++) stop(distance[s->cuts[i].height], s, &s->cuts[i], axis, way, least);
	f32 sorted[N_RAYS];
	for (u32 k = 0; k < N_RAYS; k++) {
		f32 stopped = distance[0][k];
		for (u32 h = 1; h < N_HEIGHTS; h++) stopped = ts_max(stopped, distance[h][k]);
		u32 place = k;
		for (; place > 0 && sorted[place - 1] > stopped; place--) sorted[place] = sorted[place - 1];
		sorted[place] = stopped;
	}
	return sorted[RANK];
}

/* From the middle down and up the axis: to the wall, or to the side of the box where a step has passed the walls. */
static void measure(const slice *s, u32 axis, f32 *down, f32 *up)
{
	*down = ts_min(s->middle[axis] - s->low[axis], wall_distance(s, axis, -1.0f));
	*up = ts_min(s->high[axis] - s->middle[axis], wall_distance(s, axis, 1.0f));
}

/* A hall has four walls. */
static bool is_enclosed(const slice *s)
{
	for (u32 axis = 0; axis < 2; axis++)
		if (wall_distance(s, axis, -1.0f) == UNLIMITED || wall_distance(s, axis, 1.0f) == UNLIMITED) return false;
	return true;
}

/* Moves halfway between the walls, along x and z in turn, because a step along one may reveal other walls along the
 * other. */
static void settle(slice *s)
{
	f32 down, up;
	for (u32 step = 0; step < 4; step++) {
		measure(s, step & 1, &down, &up);
		s->middle[step & 1] = s->middle[step & 1] + (up - down) * 0.5f;
	}
}

static void take_hall(ts_scene *scene, const slice *s)
{
	f32 down, up;
	for (u32 axis = 0; axis < 2; axis++) {
		measure(s, axis, &down, &up);
		f32 half = ts_min(down, up) * KEPT;
		scene->info.hall_min[axis] = ts_put(s->middle[axis] - half);
		scene->info.hall_max[axis] = ts_put(s->middle[axis] + half);
	}
}

void ts_build_walls(ts_build *build)
{
	ts_scene *scene = build->scene;
	const f32 *low = scene->info.box_min, *high = scene->info.box_max;
	slice s = {.low = {low[0], low[2]}, .high = {high[0], high[2]}};
	f32 levels[N_HEIGHTS];
	for (u32 h = 0; h < N_HEIGHTS; h++) levels[h] = low[1] + (high[1] - low[1]) * heights[h];
	for (u32 axis = 0; axis < 2; axis++) {
		scene->info.hall_min[axis] = s.low[axis];
		scene->info.hall_max[axis] = s.high[axis];
		s.middle[axis] = (s.low[axis] + s.high[axis]) * 0.5f;
	}
	if (slice_make(build, &s, levels) && is_enclosed(&s)) {
		settle(&s);
		take_hall(scene, &s);
	}
	free(s.cuts);
}

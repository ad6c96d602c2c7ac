/* The tree: boxes split at the middle of their triangles' middles; each node holds a range of `order`. */
#include "scene/rays.h"
#include <stdlib.h>
#include "kernels/base/closest.h"
#include "kernels/base/scene.h"
#include "model/core.h"
#include "scene/lamp.h"

enum { LEAF = 4, DEEPEST = 64 };
#define STEEPEST 1099511627776.0f /* greatest inverse of a direction's component */

typedef struct {
	ts_v3 low, high;
	u32 first, n; /* in order; n 0: an inner node whose children are first and first + 1 */
} node;

struct ts_rays {
	const ts_scene *scene;
	u32 *order;
	node *nodes;
	u32 n_nodes;
	ts_stop *stop;
};

static ts_v3 corner(const ts_scene *scene, u32 triangle, u32 k)
{
	return ts_load3(scene->vertices[scene->triangles[triangle].vertex[k]].position);
}

static bool stands(const ts_scene *scene, u32 triangle)
{
	for (u32 k = 0; k < 3; k++) {
		u32 index = scene->triangles[triangle].vertex[k];
		if (index >= scene->n_vertices || scene->objects[scene->vertices[index].object].period != 0) return false;
		const f32 *p = scene->vertices[index].position;
		if (ts_max(ts_max(ts_abs(p[0]), ts_abs(p[1])), ts_abs(p[2])) > TS_COORDINATE_LIMIT) return false;
	}
	return true;
}

static f32 along(ts_v3 p, u32 axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

ts_v3 ts_rays_normal(const ts_rays *rays, u32 triangle)
{
	ts_v3 a = corner(rays->scene, triangle, 0);
	return ts_normalize(
		ts_cross(ts_sub(corner(rays->scene, triangle, 1), a), ts_sub(corner(rays->scene, triangle, 2), a)));
}

/* Twice the middle of a triangle's box. */
static ts_v3 middle_of(const ts_scene *scene, u32 triangle)
{
	ts_v3 a = corner(scene, triangle, 0), b = corner(scene, triangle, 1), c = corner(scene, triangle, 2);
	return ts_add(ts_min3(ts_min3(a, b), c), ts_max3(ts_max3(a, b), c));
}

/* Sets the node's box; *low and *high receive the box of the middles. */
static void bound(node *of, ts_v3 *low, ts_v3 *high, const ts_rays *rays)
{
	for (u32 i = 0; i < of->n; i++) {
		u32 triangle = rays->order[of->first + i];
		ts_v3 middle = middle_of(rays->scene, triangle);
		*low = i == 0 ? middle : ts_min3(*low, middle);
		*high = i == 0 ? middle : ts_max3(*high, middle);
		for (u32 k = 0; k < 3; k++) {
			ts_v3 p = corner(rays->scene, triangle, k);
			of->low = i == 0 && k == 0 ? p : ts_min3(of->low, p);
			of->high = i == 0 && k == 0 ? p : ts_max3(of->high, p);
		}
	}
}

/* Moves the triangles below the middle to the front; returns their number, or half of all if that would be none or
 * all. */
static u32 part(ts_rays *rays, const node *of, ts_v3 low, ts_v3 high)
{
	ts_v3 wide = ts_sub(high, low);
	u32 axis = wide.x >= wide.y && wide.x >= wide.z ? 0 : wide.y >= wide.z ? 1 : 2, n = 0;
	f32 at = (along(low, axis) + along(high, axis)) * 0.5f;
	u32 *order = rays->order + of->first;
	for (u32 i = 0; i < of->n; i++) {
		u32 triangle = order[i];
		if (along(middle_of(rays->scene, triangle), axis) >= at) continue;
		order[i] = order[n];
		order[n++] = triangle;
	}
	return n > 0 && n < of->n ? n : of->n / 2;
}

static void split(ts_rays *rays, u32 index, u32 depth)
{
	ts_v3 low = ts_v3_make(0.0f, 0.0f, 0.0f), high = low;
	node *of = &rays->nodes[index];
	bound(of, &low, &high, rays);
	if (of->n <= LEAF || ts_stopped(rays->stop)) return;
	u32 n = depth < DEEPEST / 2 ? part(rays, of, low, high) : of->n / 2, child = rays->n_nodes;
	rays->nodes[child] = (node){.first = of->first, .n = n};
	rays->nodes[child + 1] = (node){.first = of->first + n, .n = of->n - n};
	rays->n_nodes += 2;
	of->first = child;
	of->n = 0;
	split(rays, child, depth + 1);
	split(rays, child + 1, depth + 1);
}

ts_rays *ts_rays_new(const ts_scene *scene)
{
	ts_rays *rays = ts_alloc_zero(1, sizeof *rays, "a tree of triangles");
	if (rays == NULL) return NULL;
	u32 n = scene->n_triangles, n_standing = 0;
	rays->scene = scene;
	rays->stop = ts_stop_here();
	rays->order = ts_alloc((size_t)n + 1, sizeof *rays->order, "a tree of triangles");
	rays->nodes = ts_alloc((size_t)n * 2 + 1, sizeof *rays->nodes, "a tree of triangles");
	if (rays->order == NULL || rays->nodes == NULL) {
		ts_rays_free(rays);
		return NULL;
	}
	for (u32 i = 0; i < n; i++) {
		if (stands(scene, i)) rays->order[n_standing++] = i;
	}
	rays->nodes[0] = (node){.n = n_standing};
	rays->n_nodes = n_standing > 0 ? 1 : 0;
	if (n_standing > 0) split(rays, 0, 0);
	if (ts_go_on() == TS_OK) return rays;
	ts_rays_free(rays);
	return NULL;
}

void ts_rays_free(ts_rays *rays)
{
	if (rays == NULL) return;
	free(rays->order);
	free(rays->nodes);
	free(rays);
}

static f32 inverse(f32 x)
{
	f32 least = 1.0f / STEEPEST;
	return ts_abs(x) < least ? (x < 0.0f ? -STEEPEST : STEEPEST) : 1.0f / x;
}

/* Whether the ray enters the box before `most`. */
static bool meets(const node *box, ts_v3 from, ts_v3 slope, f32 most)
{
	ts_v3 a = ts_mul(ts_sub(box->low, from), slope), b = ts_mul(ts_sub(box->high, from), slope);
	ts_v3 in = ts_min3(a, b), out = ts_max3(a, b);
	f32 first = ts_max(ts_max(in.x, in.y), ts_max(in.z, 0.0f)),
		last = ts_min(ts_min(out.x, out.y), ts_min(out.z, most));
	return first <= last * 1.0000005f;
}

static u32 flags_of(const ts_scene *scene, u32 triangle)
{
	u32 material = scene->triangles[triangle].material;
	return material < scene->n_materials ? scene->materials[material].flags : 0;
}

static bool is_seen(const ts_scene *scene, u32 triangle, f32 facing)
{
	u32 flags = flags_of(scene, triangle);
	return (flags & TS_MASKED) == 0 && (facing > 0.0f || (flags & TS_DOUBLE_SIDED) != 0);
}

/* The distance (Möller and Trumbore 1997), or `most` where the ray misses or, unless all are asked for, meets the
 * back. */
static f32 strike(const ts_scene *scene, u32 triangle, ts_v3 from, ts_v3 way, f32 most, bool all)
{
	ts_v3 a = corner(scene, triangle, 0);
	ts_v3 ab = ts_sub(corner(scene, triangle, 1), a), ac = ts_sub(corner(scene, triangle, 2), a);
	ts_v3 p = ts_cross(way, ac);
	f32 facing = ts_flush(ts_dot(ab, p));
	if (facing == 0.0f || (!all && !is_seen(scene, triangle, facing))) return most;
	ts_v3 to = ts_sub(from, a), q = ts_cross(to, ab);
	f32 u = ts_dot(to, p) / facing, v = ts_dot(way, q) / facing, t = ts_dot(ac, q) / facing;
	return u >= 0.0f && v >= 0.0f && u + v <= 1.0f && t > 0.0f && t < most ? t : most;
}

static u32 cast(f32 *distance, const ts_rays *rays, ts_v3 from, ts_v3 way, f32 most, bool all)
{
	u32 stack[DEEPEST * 2], n = 0, hit = TS_NONE;
	ts_v3 slope = ts_v3_make(inverse(way.x), inverse(way.y), inverse(way.z));
	*distance = most;
	if (rays->n_nodes > 0 && !ts_stopped(rays->stop)) stack[n++] = 0;
	while (n > 0) {
		const node *at = &rays->nodes[stack[--n]];
		if (!meets(at, from, slope, *distance)) continue;
		if (at->n == 0) {
			stack[n++] = at->first;
			stack[n++] = at->first + 1;
		}
		for (u32 i = 0; i < at->n; i++) {
			u32 triangle = rays->order[at->first + i];
			f32 t = strike(rays->scene, triangle, from, way, *distance, all);
			if (t < *distance) hit = triangle;
			*distance = t;
		}
	}
	return hit;
}

u32 ts_rays_cast(f32 *distance, const ts_rays *rays, ts_v3 from, ts_v3 way, f32 most)
{
	return cast(distance, rays, from, way, most, false);
}

ts_v3 ts_rays_way(u32 i, u32 n)
{
	f32 y = 1.0f - (2.0f * (f32)i + 1.0f) / (f32)n, r = ts_sqrt(ts_max(1.0f - y * y, 0.0f));
	f32 turns = TS_GOLDEN_TURN * (f32)i;
	return ts_normalize(ts_v3_make(r * ts_cos_turn(turns), y, r * ts_sin_turn(turns)));
}

bool ts_rays_is_inside(const ts_rays *rays, ts_v3 p)
{
	enum { WAYS = 14 };
	u32 n_behind = 0;
	for (u32 i = 0; i < WAYS; i++) {
		f32 distance;
		ts_v3 way = ts_rays_way(i, WAYS);
		u32 hit = cast(&distance, rays, p, way, TS_RAYS_FAR, true);
		if (hit == TS_NONE || (flags_of(rays->scene, hit) & TS_DOUBLE_SIDED) != 0) continue;
		ts_v3 a = corner(rays->scene, hit, 0);
		ts_v3 normal = ts_cross(ts_sub(corner(rays->scene, hit, 1), a), ts_sub(corner(rays->scene, hit, 2), a));
		n_behind += ts_dot(normal, way) > 0.0f;
	}
	return n_behind * 2 > WAYS;
}

bool ts_rays_free_between(const ts_rays *rays, ts_v3 from, ts_v3 to)
{
	ts_v3 way = ts_sub(to, from);
	f32 distance, length = ts_length(way);
	return ts_rays_cast(&distance, rays, from, ts_normalize(way), length * 0.99609375f) == TS_NONE;
}

static f32 outside(f32 x, f32 low, f32 high) { return ts_max(ts_max(low - x, x - high), 0.0f); }

static f32 apart(const node *box, ts_v3 p)
{
	return ts_length(ts_v3_make(outside(p.x, box->low.x, box->high.x), outside(p.y, box->low.y, box->high.y),
	                            outside(p.z, box->low.z, box->high.z)));
}

f32 ts_rays_clearance(const ts_rays *rays, ts_v3 p, f32 most)
{
	u32 stack[DEEPEST * 2], n = 0;
	if (rays->n_nodes > 0) stack[n++] = 0;
	while (n > 0) {
		const node *at = &rays->nodes[stack[--n]];
		if (apart(at, p) >= most) continue;
		if (at->n == 0) {
			stack[n++] = at->first;
			stack[n++] = at->first + 1;
		}
		for (u32 i = 0; i < at->n; i++) {
			u32 t = rays->order[at->first + i];
			ts_v3 near = ts_k_closest_on_triangle(p, corner(rays->scene, t, 0), corner(rays->scene, t, 1),
			                                      corner(rays->scene, t, 2));
			most = ts_min(most, ts_length(ts_sub(near, p)));
		}
	}
	return most;
}

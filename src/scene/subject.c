/* Rooms and things. A point is in a room if most rays that do not fall end at the front of a wall, and falling ones at
 * a floor; the room is the subject if about as much of the scene is visible in it as from outside. */
#include "kernels/base/scene.h"
#include "model/core.h"
#include "scene/build.h"
#include "scene/sources.h"
#include "scene/view.h"

enum { N_COLUMNS = 64, N_CROPS = 6 };
#define FLAT 0.03125f /* of the box's height: a column this low is ground */
#define SMALL 0.25f   /* of the whole box's area: only a thing this small is cut out of its ground */
enum { N_MARKS = 128, N_WAYS = 64, N_OUTSIDE = 8, N_FAN = 9, RANK = 2, N_WIDE = 9, N_HIGH = 5 };
#define LOWEST_WAY (-0.25f)
#define ENCLOSED 0.6f      /* of the rays */
#define WORTH 0.5f         /* of the share that is visible from outside */
#define NEAREST 0.0078125f /* clearance of an eye, of half the diagonal of the hall */
#define LEVEL 0.99f        /* y of a floor's normal */
#define STEP 0.02f         /* between floors of one height, of half the box */
#define SLOPE 0.03125f
#define KEPT 0.95f

/* Limits of the scene above each column of the ground. */
typedef struct {
	f32 low[N_COLUMNS * N_COLUMNS], high[N_COLUMNS * N_COLUMNS];
} columns;

static bool box_of(ts_v3 *low, ts_v3 *high, const ts_scene *scene, u32 triangle)
{
	for (u32 k = 0; k < 3; k++) {
		u32 index = scene->triangles[triangle].vertex[k];
		if (index >= scene->n_vertices || !ts_build_is_own(scene, scene->vertices[index].object)) return false;
		ts_v3 p = ts_load3(scene->vertices[index].position);
		*low = k == 0 ? p : ts_min3(*low, p);
		*high = k == 0 ? p : ts_max3(*high, p);
	}
	return true;
}

static u32 column_at(f32 x, f32 low, f32 high)
{
	f32 at = (x - low) / (high - low) * (f32)N_COLUMNS;
	return (u32)ts_clamp(at, 0.0f, (f32)N_COLUMNS - 1.0f);
}

static void fill_columns(columns *c, const ts_info *info, const ts_scene *scene)
{
	const f32 *low = info->box_min, *high = info->box_max;
	ts_stop *stop = ts_stop_here();
	for (u32 i = 0; i < N_COLUMNS * N_COLUMNS; i++) {
		c->low[i] = high[1];
		c->high[i] = low[1];
	}
	for (u32 i = 0; i < scene->n_triangles && !ts_stopped(stop); i++) {
		ts_v3 a, b;
		if (!box_of(&a, &b, scene, i)) continue;
		if (b.x < low[0] || a.x > high[0] || b.z < low[2] || a.z > high[2]) continue;
		u32 x0 = column_at(a.x, low[0], high[0]), x1 = column_at(b.x, low[0], high[0]);
		u32 z0 = column_at(a.z, low[2], high[2]), z1 = column_at(b.z, low[2], high[2]);
		for (u32 z = z0; z <= z1; z++) {
			for (u32 x = x0; x <= x1; x++) {
				u32 at = z * N_COLUMNS + x;
				c->low[at] = ts_min(c->low[at], a.y);
				c->high[at] = ts_max(c->high[at], b.y);
			}
		}
	}
}

/* Shrinks the box to the columns that are not flat; false if all are. */
static bool crop(ts_info *info, const columns *c)
{
	u32 first[2] = {N_COLUMNS, N_COLUMNS}, last[2] = {0, 0};
	f32 least = (info->box_max[1] - info->box_min[1]) * FLAT, low = info->box_max[1], high = info->box_min[1];
	for (u32 i = 0; i < N_COLUMNS * N_COLUMNS; i++) {
		if (!(c->high[i] - c->low[i] > least)) continue;
		u32 at[2] = {i % N_COLUMNS, i / N_COLUMNS};
		for (u32 k = 0; k < 2; k++) {
			first[k] = at[k] < first[k] ? at[k] : first[k];
			last[k] = at[k] > last[k] ? at[k] : last[k];
		}
		low = ts_min(low, c->low[i]);
		high = ts_max(high, c->high[i]);
	}
	if (first[0] > last[0]) return false;
	for (u32 k = 0; k < 2; k++) {
		f32 from = info->box_min[2 * k], step = (info->box_max[2 * k] - from) * (1.0f / (f32)N_COLUMNS);
		info->box_min[2 * k] = ts_put(from + step * (f32)first[k]);
		info->box_max[2 * k] = ts_put(from + step * (f32)(last[k] + 1));
	}
	info->box_min[1] = ts_put(low);
	info->box_max[1] = ts_put(high);
	return true;
}

static f32 area(const ts_info *info)
{
	return (info->box_max[0] - info->box_min[0]) * (info->box_max[2] - info->box_min[2]);
}

void ts_subject_crop(ts_info *info, const ts_scene *scene)
{
	ts_info cropped = *info;
	columns c;
	for (u32 i = 0; i < N_CROPS && area(&cropped) > 0.0f; i++) {
		f32 before = area(&cropped);
		fill_columns(&c, &cropped, scene);
		if (!crop(&cropped, &c)) return;
		if (area(&cropped) > before * 0.9f) break;
	}
	if (area(&cropped) < area(info) * SMALL) *info = cropped;
}

/* A triangle's middle, and its normal; zero if it is seen from both sides. */
typedef struct {
	ts_v3 at, normal;
} mark;

typedef struct {
	const ts_rays *rays;
	const ts_scene *scene;
	ts_params first; /* parameters of frame 0 */
	mark marks[2 * N_MARKS];
	u32 n_marks;
	f32 outside; /* the greatest share of the marks that is visible from outside */
} finder;

static bool is_in(ts_v3 p, const ts_info *info)
{
	const f32 *a = info->box_min, *b = info->box_max;
	return p.x >= a[0] && p.x <= b[0] && p.y >= a[1] && p.y <= b[1] && p.z >= a[2] && p.z <= b[2];
}

/* False if the triangle is not in the box. */
static bool mark_of(mark *m, f32 *size, const finder *f, const ts_info *info, u32 triangle)
{
	ts_v3 a, b, p[3];
	if (!box_of(&a, &b, f->scene, triangle)) return false;
	const ts_triangle *t = &f->scene->triangles[triangle];
	u32 flags = t->material < f->scene->n_materials ? f->scene->materials[t->material].flags : 0;
	for (u32 k = 0; k < 3; k++) p[k] = ts_load3(f->scene->vertices[t->vertex[k]].position);
	ts_v3 normal = ts_cross(ts_sub(p[1], p[0]), ts_sub(p[2], p[0]));
	m->at = ts_scale(ts_add(ts_add(p[0], p[1]), p[2]), 1.0f / 3.0f);
	m->normal = flags & TS_DOUBLE_SIDED ? ts_v3_make(0.0f, 0.0f, 0.0f) : normal;
	*size = ts_length(normal);
	return *size > 0.0f && is_in(m->at, info);
}

/* Half of the marks evenly by number, half by area. */
static void make_marks(finder *f, const ts_info *info)
{
	f32 whole = 0.0f, size, sum = 0.0f, next = 0.5f;
	u32 n = 0, seen = 0;
	mark m;
	ts_stop *stop = ts_stop_here();
	f->n_marks = 0;
	for (u32 i = 0; i < f->scene->n_triangles && !ts_stopped(stop); i++) {
		if (!mark_of(&m, &size, f, info, i)) continue;
		whole = whole + size;
		n++;
	}
	for (u32 i = 0; i < f->scene->n_triangles && n > 0 && !ts_stopped(stop); i++) {
		if (!mark_of(&m, &size, f, info, i)) continue;
		u64 before = (u64)seen * N_MARKS / n, after = (u64)(seen + 1) * N_MARKS / n;
		seen++;
		if (after > before && f->n_marks < 2 * N_MARKS) f->marks[f->n_marks++] = m;
		sum = sum + size / whole * (f32)N_MARKS;
		if (sum < next) continue;
		next = sum + 1.0f;
		if (f->n_marks < 2 * N_MARKS) f->marks[f->n_marks++] = m;
	}
}

/* The share of the marks that is visible from p. */
static f32 share_from(const finder *f, ts_v3 p)
{
	u32 n = 0;
	for (u32 i = 0; i < f->n_marks; i++) {
		const mark *m = &f->marks[i];
		bool faces = ts_dot(m->normal, m->normal) == 0.0f || ts_dot(m->normal, ts_sub(p, m->at)) > 0.0f;
		n += faces && ts_rays_free_between(f->rays, p, m->at);
	}
	return f->n_marks > 0 ? (f32)n / (f32)f->n_marks : 0.0f;
}

static f32 share_from_outside(const finder *f, const ts_info *info)
{
	ts_space box = ts_view_box(info);
	f32 most = 0.0f;
	for (u32 k = 0; k < N_OUTSIDE; k++) {
		f32 turns = (f32)k / (f32)N_OUTSIDE;
		ts_v3 way = ts_normalize(ts_v3_make(ts_sin_turn(turns), 0.35f, ts_cos_turn(turns)));
		most = ts_max(most, share_from(f, ts_mad(box.middle, way, 2.5f * ts_length(box.half))));
	}
	return most;
}

/* Two-sided surfaces count only from their front: from within, the skin of a thing is a back. */
static bool is_enclosed(const finder *f, ts_v3 p)
{
	u32 n = 0, n_hits = 0;
	for (u32 i = 0; i < N_WAYS; i++) {
		f32 distance;
		ts_v3 way = ts_rays_way(i, N_WAYS);
		if (way.y < LOWEST_WAY) continue;
		n++;
		u32 hit = ts_rays_cast(&distance, f->rays, p, way, TS_RAYS_FAR);
		n_hits += hit != TS_NONE && ts_dot(ts_rays_normal(f->rays, hit), way) < 0.0f;
	}
	return (f32)n_hits >= (f32)n * ENCLOSED;
}

static f32 least_clearance(const ts_info *info) { return ts_length(ts_view_hall(info).half) * NEAREST; }

static bool is_clear(const finder *f, ts_v3 p, f32 least)
{
	return ts_rays_clearance(f->rays, p, least) >= least && !ts_rays_is_inside(f->rays, p);
}

static ts_view eye_of(const finder *f, const ts_info *info)
{
	ts_view view;
	ts_view_eye(&view, info, &f->first);
	return view;
}

/* Whether the circling eye of frame 0 stands free in a room that shows enough. */
static bool is_good_eye(const finder *f, const ts_info *info)
{
	ts_v3 eye = ts_load3(eye_of(f, info).eye);
	return is_clear(f, eye, least_clearance(info)) && is_enclosed(f, eye) && share_from(f, eye) >= f->outside * WORTH;
}

static bool sees(const finder *f, const ts_view *view, ts_v3 p)
{
	f32 depth;
	return ts_view_holds(view, p, 0.0f, &depth) && ts_rays_free_between(f->rays, ts_load3(view->eye), p);
}

/* Whether a chosen camera sees marks in the middle of the hall. */
static bool is_in_sight(const finder *f, const ts_info *info)
{
	ts_view view = eye_of(f, info);
	ts_space hall = ts_view_hall(info);
	u32 n = 0;
	for (u32 i = 0; i < 9; i++) {
		f32 x = (f32)(i % 3) - 1.0f, z = (f32)(i / 3) - 1.0f;
		n += sees(f, &view,
		          ts_v3_make(hall.middle.x + x * 0.4f * hall.half.x, hall.middle.y - 0.25f * hall.half.y,
		                     hall.middle.z + z * 0.4f * hall.half.z));
	}
	return n >= 2;
}

static bool is_good_hall(const finder *f, const ts_info *info)
{
	if (ts_view_is_open(info) || !is_enclosed(f, ts_view_hall(info).middle)) return false;
	return info->circles == TS_CIRCLES_NOT ? is_in_sight(f, info) : is_good_eye(f, info);
}

/* Whether some of nine falling rays end at one height on level ground. */
static bool has_floor(const finder *f, ts_v3 p, const ts_info *info)
{
	ts_space box = ts_view_box(info);
	f32 apart = ts_min(box.half.x, box.half.z) * 0.15f, height[N_FAN];
	u32 n = 0, most = 0;
	for (u32 k = 0; k < N_FAN; k++) {
		f32 distance;
		ts_v3 from = ts_v3_make(p.x + ((f32)(k % 3) - 1.0f) * apart, p.y, p.z + ((f32)(k / 3) - 1.0f) * apart);
		u32 hit = ts_rays_cast(&distance, f->rays, from, ts_v3_make(0.0f, -1.0f, 0.0f), TS_RAYS_FAR);
		if (hit != TS_NONE && ts_abs(ts_rays_normal(f->rays, hit).y) > LEVEL) height[n++] = distance;
	}
	for (u32 i = 0; i < n; i++) {
		u32 alike = 0;
		for (u32 k = 0; k < n; k++) alike += ts_abs(height[i] - height[k]) <= box.half.y * STEP;
		most = alike > most ? alike : most;
	}
	return most >= 3;
}

typedef struct {
	ts_v3 at;
	f32 score;
} place;

/* Keeps p if it is in a room and better than the best so far. */
static void offer(place *best, const finder *f, ts_v3 p, f32 unit, const ts_info *info)
{
	f32 clear = ts_rays_clearance(f->rays, p, unit);
	if (clear < unit * 0.03125f || ts_rays_is_inside(f->rays, p) || !is_enclosed(f, p)) return;
	if (!has_floor(f, p, info)) return;
	f32 share = share_from(f, p), score = share + ts_min(clear / unit, 0.5f) * 0.25f;
	if (share < f->outside * WORTH || score <= best->score) return;
	*best = (place){p, score};
}

static void search_box(place *best, const finder *f, const ts_info *info)
{
	ts_space box = ts_view_box(info);
	f32 unit = ts_min(ts_min(box.half.x, box.half.y), box.half.z);
	for (u32 i = 0; i < N_WIDE * N_HIGH * N_WIDE; i++) {
		f32 x = (f32)(i % N_WIDE) - (f32)(N_WIDE / 2), y = (f32)(i / N_WIDE % N_HIGH) - (f32)(N_HIGH / 2);
		f32 z = (f32)(i / (N_WIDE * N_HIGH)) - (f32)(N_WIDE / 2);
		ts_v3 at = ts_v3_make(x * 2.0f / (f32)N_WIDE, y * 2.0f / (f32)N_HIGH, z * 2.0f / (f32)N_WIDE);
		offer(best, f, ts_add(box.middle, ts_mul(at, box.half)), unit, info);
	}
}

/* Searches along the rays of a chosen camera. */
static void search_view(place *best, const finder *f, const ts_info *info)
{
	ts_view view = eye_of(f, info);
	ts_v3 eye = ts_load3(view.eye);
	ts_space box = ts_view_box(info);
	f32 most = 2.0f * ts_length(box.half), unit = ts_min(ts_min(box.half.x, box.half.y), box.half.z);
	for (u32 i = 0; i < 45; i++) {
		f32 distance, x = ((f32)(i % 5) + 0.5f) / 5.0f, y = ((f32)(i / 5 % 3) + 0.5f) / 3.0f;
		ts_v3 way = ts_view_way(&view, x * (f32)view.width, y * (f32)view.height);
		ts_rays_cast(&distance, f->rays, eye, way, most);
		offer(best, f, ts_mad(eye, way, distance * (0.35f + 0.2f * (f32)(i / 15))), unit, info);
	}
}

static void put_in_order(f32 *sorted, u32 n, f32 x)
{
	for (; n > 0 && sorted[n - 1] > x; n--) sorted[n] = sorted[n - 1];
	sorted[n] = x;
}

/* The distance up or down: the median of nine rays, or the lower of two floors. */
static f32 height_from(const finder *f, ts_v3 p, f32 way, f32 most, f32 apart, u32 rank)
{
	f32 sorted[N_FAN], distance;
	for (u32 k = 0; k < N_FAN; k++) {
		ts_v3 from = ts_v3_make(p.x + ((f32)(k % 3) - 1.0f) * apart, p.y, p.z + ((f32)(k / 3) - 1.0f) * apart);
		ts_rays_cast(&distance, f->rays, from, ts_v3_make(0.0f, way, 0.0f), most);
		put_in_order(sorted, k, distance);
	}
	return sorted[rank];
}

/* The third smallest of nine distances, each the longer of two heights', as in build_walls.c. */
static f32 wall_from(const finder *f, const ts_info *room, ts_v3 p, u32 axis, f32 way, f32 most)
{
	f32 sorted[N_FAN], height = room->box_max[1] - room->box_min[1];
	for (u32 k = 0; k < N_FAN; k++) {
		f32 slope = ((f32)k - (f32)(N_FAN / 2)) * SLOPE, longest = 0.0f;
		ts_v3 to = axis == 0 ? ts_v3_make(way, 0.0f, slope) : ts_v3_make(slope, 0.0f, way);
		ts_v3 unit = ts_normalize(to);
		for (u32 h = 0; h < 2; h++) {
			f32 distance;
			ts_v3 from = ts_v3_make(p.x, room->box_min[1] + height * (h == 0 ? 0.35f : 0.6f), p.z);
			ts_rays_cast(&distance, f->rays, from, unit, most);
			longest = ts_max(longest, distance * ts_abs(axis == 0 ? unit.x : unit.z));
		}
		put_in_order(sorted, k, ts_min(longest, most));
	}
	return sorted[RANK];
}

/* The room about p: floor and ceiling, then walls, halfway between which the middle settles. */
static void take_room(ts_info *info, const finder *f, ts_v3 p)
{
	ts_info whole = *info;
	ts_space box = ts_view_box(&whole);
	f32 most = 2.0f * ts_max(box.half.x, box.half.z), apart = ts_rays_clearance(f->rays, p, box.half.y) * 0.5f;
	f32 down = height_from(f, p, -1.0f, p.y - whole.box_min[1], apart, N_FAN - 2);
	f32 up = height_from(f, p, 1.0f, whole.box_max[1] - p.y, apart, N_FAN / 2);
	info->box_min[1] = ts_put(p.y - down);
	info->box_max[1] = ts_put(p.y + up);
	for (u32 step = 0; step < 6; step++) {
		u32 axis = step & 1, k = 2 * axis;
		f32 *at = axis == 0 ? &p.x : &p.z;
		f32 less = ts_min(wall_from(f, info, p, axis, -1.0f, most), *at - whole.box_min[k]);
		f32 more = ts_min(wall_from(f, info, p, axis, 1.0f, most), whole.box_max[k] - *at);
		f32 half = ts_min(less, more) * KEPT;
		info->box_min[k] = ts_put(*at - less);
		info->box_max[k] = ts_put(*at + more);
		info->hall_min[axis] = ts_put(*at - half);
		info->hall_max[axis] = ts_put(*at + half);
		if (step < 4) *at = *at + (more - less) * 0.5f;
	}
}

/* The free distance in that direction: the mean of a fan as wide as the image. */
static f32 depth_along(const finder *f, ts_v3 p, f32 turns, f32 most)
{
	f32 sum = 0.0f, distance;
	for (u32 k = 0; k < N_FAN; k++) {
		f32 at = turns + ((f32)k - (f32)(N_FAN / 2)) * 0.015625f;
		ts_v3 way = ts_normalize(ts_v3_make(ts_cos_turn(at), -0.0625f, ts_sin_turn(at)));
		ts_rays_cast(&distance, f->rays, p, way, most);
		sum = sum + distance;
	}
	return sum;
}

/* Puts the eye at p, looking where the free distance is greatest. */
static void stand_at(ts_info *info, const finder *f, ts_v3 p)
{
	f32 best = -1.0f, most = 4.0f * ts_length(ts_view_box(info).half);
	ts_v3 target = p;
	for (u32 k = 0; k < 16; k++) {
		f32 turns = (f32)k / 16.0f, depth = depth_along(f, p, turns, most);
		if (depth <= best) continue;
		best = depth;
		target = ts_add(p, ts_v3_make(ts_cos_turn(turns), -0.0625f, ts_sin_turn(turns)));
	}
	info->circles = TS_CIRCLES_NOT;
	ts_store3(info->eye, p);
	ts_view_aim(info->right, info->up, info->back, p, target);
}

/* Shrinks the hall until the eye stands free; if that fails the eye stands at p. */
static void free_the_eye(ts_info *info, const finder *f, ts_v3 p)
{
	ts_info tried = *info;
	for (u32 round = 0; round < 8; round++) {
		if (is_good_eye(f, &tried)) {
			*info = tried;
			return;
		}
		for (u32 axis = 0; axis < 2; axis++) {
			f32 inset = (tried.hall_max[axis] - tried.hall_min[axis]) * 0.0625f;
			tried.hall_min[axis] = ts_put(tried.hall_min[axis] + inset);
			tried.hall_max[axis] = ts_put(tried.hall_max[axis] - inset);
		}
	}
	stand_at(info, f, p);
}

static void leave_open(ts_info *info)
{
	for (u32 axis = 0; axis < 2; axis++) {
		info->hall_min[axis] = info->box_min[2 * axis];
		info->hall_max[axis] = info->box_max[2 * axis];
	}
	if (info->circles != TS_CIRCLES_NOT) info->circles = TS_CIRCLES_OUTSIDE;
}

void ts_subject_find(ts_info *info, const ts_rays *rays, const ts_scene *scene, const ts_params *params)
{
	finder f = {.rays = rays, .scene = scene, .first = *params};
	bool fixed = info->circles == TS_CIRCLES_NOT;
	place best = {.score = -1.0f};
	TS_PARAM_SET(&f.first, frame, 0);
	if (TS_PARAM(params, eye_distance) == TS_EYE_OUTSIDE) TS_PARAM_SET(&f.first, eye_distance, TS_EYE_FAR);
	if (!fixed) info->circles = TS_CIRCLES_ROOM;
	make_marks(&f, info);
	f.outside = share_from_outside(&f, info);
	if (is_good_hall(&f, info)) return;
	if (fixed)
		search_view(&best, &f, info);
	else
		search_box(&best, &f, info);
	if (best.score < 0.0f) {
		leave_open(info);
		return;
	}
	take_room(info, &f, best.at);
	if (!fixed) free_the_eye(info, &f, best.at);
}

/* Fast path of the visibility of cubes, with the same bits: triangles side by side, cube by cube. The axes of a face
 * are the world's except for sign and order, so nothing needs products. */
#include <string.h>
#include "backends/fast.h"
#include "backends/wide.h"
#include "kernels/raster/visibility.h"

enum { LANES = 128, AXES = 3 };

/* Limits of all corners. */
typedef struct {
	f32 least[AXES], most[AXES];
} extent;

/* Triangles: corners a, b, c, and normals. */
typedef struct {
	extent all;
	u32 n, object[LANES], two_sided[LANES], degenerate[LANES];
	f32 corner[3 * AXES][LANES], normal[AXES][LANES];
} batch;

/* What a cube may see of the triangles: corners from its centre, and bits of faces. */
typedef struct {
	f32 corner[3 * AXES][LANES];
	u32 shown[LANES], faces[LANES];
} sight;

static void take(batch *b, u32 lane, const ts_arrays *scene, u32 triangle)
{
	ts_corners t = ts_k_corners(scene, triangle);
	const ts_v3 corner[3] = {t.a, t.b, t.c};
	for (u32 k = 0; k < 3; k++) {
		b->corner[k * AXES][lane] = corner[k].x;
		b->corner[k * AXES + 1][lane] = corner[k].y;
		b->corner[k * AXES + 2][lane] = corner[k].z;
	}
	b->normal[0][lane] = t.n.x;
	b->normal[1][lane] = t.n.y;
	b->normal[2][lane] = t.n.z;
	b->object[lane] = ts_k_object_of(scene, triangle);
	b->two_sided[lane] = ts_k_is_two_sided(scene, triangle) ? 1 : 0;
	b->degenerate[lane] = ts_k_is_degenerate(t.n) ? 1 : 0;
}

static extent extent_of(const batch *b)
{
	extent e;
	for (u32 axis = 0; axis < AXES; axis++) {
		f32 least = b->corner[axis][0], most = least;
		for (u32 k = axis; k < 3 * AXES; k += AXES) {
			for (u32 i = 0; i < b->n; i++) {
				least = ts_min(least, b->corner[k][i]);
				most = ts_max(most, b->corner[k][i]);
			}
		}
		e.least[axis] = least;
		e.most[axis] = most;
	}
	return e;
}

/* From a cube's centre: as differences are rounded monotonically, no corner is beyond the limits. */
static extent extent_from(const extent *of, const f32 centre[3])
{
	extent e;
	for (u32 axis = 0; axis < AXES; axis++) {
		e.least[axis] = of->least[axis] - centre[axis];
		e.most[axis] = of->most[axis] - centre[axis];
	}
	return e;
}

/* All triangles are outside one plane of the face's frustum. */
static bool is_outside(const extent *e, u32 axis, f32 sign, f32 near)
{
	u32 x = (axis + 1) % AXES, y = (axis + 2) % AXES;
	f32 ahead = sign > 0.0f ? e->most[axis] : -e->least[axis];
	return e->least[x] > ahead || -e->most[x] > ahead || e->least[y] > ahead || -e->most[y] > ahead || near > ahead;
}

/* No triangle is outside a plane of the face's frustum. */
static bool is_inside(const extent *e, u32 axis, f32 sign, f32 near)
{
	u32 x = (axis + 1) % AXES, y = (axis + 2) % AXES;
	f32 ahead = sign > 0.0f ? e->least[axis] : -e->most[axis];
	return e->most[x] <= ahead && -e->least[x] <= ahead && e->most[y] <= ahead && -e->least[y] <= ahead &&
	       near <= ahead;
}

/* Finds which triangles the cube may show at all, by those faces, like ts_k_may_show. */
TS_WIDE(void, find_shown, (sight *restrict to, const batch *restrict b, u32 n, ts_v3 centre, u32 object, u32 faces),
        (to, b, n, centre, object, faces))
{
	for (u32 i = 0; i < n; i++) {
		ts_v3 a = ts_v3_make(centre.x - b->corner[0][i], centre.y - b->corner[1][i], centre.z - b->corner[2][i]);
		f32 towards = ts_flush(ts_dot(ts_v3_make(b->normal[0][i], b->normal[1][i], b->normal[2][i]), a));
		u32 facing = (towards > 0.0f ? 1u : 0u) | b->two_sided[i];
		to->shown[i] = facing & (b->object[i] != object ? 1u : 0u) & (b->degenerate[i] ^ 1u);
		to->faces[i] = to->shown[i] * faces;
	}
}

/* Corners from a cube's centre. */
TS_WIDE(void, turn_to_cube, (sight *restrict to, const batch *restrict b, u32 n, ts_v3 centre), (to, b, n, centre))
{
	for (u32 i = 0; i < n; i++) {
		for (u32 k = 0; k < 3 * AXES; k += AXES) {
			to->corner[k][i] = b->corner[k][i] - centre.x;
			to->corner[k + 1][i] = b->corner[k + 1][i] - centre.y;
			to->corner[k + 2][i] = b->corner[k + 2][i] - centre.z;
		}
	}
}

static inline u32 all_above(f32 a, f32 b, f32 c, f32 x, f32 y, f32 z)
{
	return (a > x ? 1u : 0u) & (b > y ? 1u : 0u) & (c > z ? 1u : 0u);
}

/* ts_k_outside_plane for a face that looks along an axis, forwards or back. */
TS_WIDE(void, look, (sight *restrict to, u32 n, u32 axis, f32 sign, f32 near, u32 bit), (to, n, axis, sign, near, bit))
{
	const f32 *x = to->corner[(axis + 1) % AXES], *y = to->corner[(axis + 2) % AXES], *z = to->corner[axis];
	for (u32 i = 0; i < n; i++) {
		f32 ax = x[i], bx = x[AXES * LANES + i], cx = x[2 * AXES * LANES + i];
		f32 ay = y[i], by = y[AXES * LANES + i], cy = y[2 * AXES * LANES + i];
		f32 az = z[i] * sign, bz = z[AXES * LANES + i] * sign, cz = z[2 * AXES * LANES + i] * sign;
		u32 out = all_above(ax, bx, cx, az, bz, cz) | all_above(-ax, -bx, -cx, az, bz, cz);
		out |= all_above(ay, by, cy, az, bz, cz) | all_above(-ay, -by, -cy, az, bz, cz);
		out |= all_above(near, near, near, az, bz, cz);
		to->faces[i] |= (to->shown[i] & (out ^ 1u)) * bit;
	}
}

static void see(sight *s, const batch *b, const ts_face *cube)
{
	static const f32 sign[2] = {1.0f, -1.0f};
	extent e = extent_from(&b->all, cube->centre);
	u32 all = 0, some = 0;
	for (u32 face = 0; face < 6; face++) {
		if (is_outside(&e, face / 2, sign[face % 2], cube->near)) continue;
		*(is_inside(&e, face / 2, sign[face % 2], cube->near) ? &all : &some) |= 1u << face;
	}
	find_shown(s, b, b->n, ts_load3(cube->centre), cube->object, all);
	if (some != 0) turn_to_cube(s, b, b->n, ts_load3(cube->centre));
	for (u32 face = 0; face < 6; face++) {
		if ((some >> face & 1) != 0) look(s, b->n, face / 2, sign[face % 2], cube->near, 1u << face);
	}
}

static void put_bits(u64 *words, u32 n_words, u32 r, const sight *s, u32 n)
{
	u32 shift = r * 6 & 63;
	words += r * 6 >> 6;
	for (u32 i = 0; i < n; i++, words += n_words) {
		words[0] |= (u64)s->faces[i] << shift;
		if (shift > 58) words[1] |= (u64)s->faces[i] >> (64 - shift);
	}
}

static void see_part(const ts_visibility_args *args, u32 first, u32 n)
{
	batch b;
	sight s;
	u64 *words = args->bits + (u64)first * args->n_words;
	b.n = n;
	for (u32 i = 0; i < n; i++) take(&b, i, &args->scene, first + i);
	b.all = extent_of(&b);
	memset(words, 0, (size_t)n * args->n_words * sizeof *words);
	for (u32 r = 0; r < args->n_cubes; r++) {
		if (args->cubes[r].n == 0) continue;
		see(&s, &b, &args->cubes[r]);
		put_bits(words, args->n_words, r, &s, n);
	}
}

/* Only for the rule by faces, not the one by corners in sight. */
bool ts_c_fast_visibility(const void *of, u64 n, u32 threads)
{
	const ts_visibility_args *args = of;
	if (args->vertex_mode != 0) return false;
	ts_stop *stop = ts_stop_here();
#pragma omp parallel for schedule(dynamic, 4) num_threads(threads)
	for (i64 first = 0; first < (i64)n; first += LANES) {
		if (ts_stopped(stop)) continue;
		see_part(args, (u32)first, (i64)n - first < LANES ? (u32)((i64)n - first) : LANES);
	}
	return true;
}

#include "backends/selftest.h"

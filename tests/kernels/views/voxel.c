/* Voxels that triangles touch, against another way to tell: a triangle meets a box if one of its edges does, or if one
 * of the box's edges meets it; in integers, so without doubt. The root cube and its lattice; Morton codes, bit by
 * bit. */
#include <stdlib.h>
#include <string.h>
#include "kernels/views/voxel.h"
#include "tests/kernels/seeded.h"
#include "tests/kernels/small.h"

enum { N_TRIANGLES = 3000, N_LARGE = 400, N_ROOTS = 2000, LEVELS = 3, SIDE = 1 << LEVELS, STEPS = SIDE * TS_VOXEL };

typedef struct {
	i64 c[3];
} point;

/* part / whole, whole > 0 */
typedef struct {
	i64 part, whole;
} ratio;

static bool less(ratio a, ratio b) { return a.part * b.whole < b.part * a.whole; }

/* A segment meets a closed box: where it enters the last slab is not behind where it leaves the first. */
static bool segment_meets(const point *p, const point *q, const i64 voxel[3])
{
	ratio from = {0, 1}, to = {1, 1};
	for (u32 k = 0; k < 3; k++) {
		i64 low = voxel[k] * TS_VOXEL - p->c[k], high = low + TS_VOXEL, d = q->c[k] - p->c[k];
		if (d == 0 && (low > 0 || high < 0)) return false;
		if (d == 0) continue;
		ratio enters = d > 0 ? (ratio){low, d} : (ratio){-high, -d};
		ratio leaves = d > 0 ? (ratio){high, d} : (ratio){-low, -d};
		if (less(from, enters)) from = enters;
		if (less(leaves, to)) to = leaves;
	}
	return !less(to, from);
}

/* Twice the area of p, q, r seen along the axis behind u and v. */
static i64 area(const point *p, const point *q, const point *r, u32 u, u32 v)
{
	return (q->c[u] - p->c[u]) * (r->c[v] - p->c[v]) - (q->c[v] - p->c[v]) * (r->c[u] - p->c[u]);
}

/* An edge of a box along axis w meets a triangle; a triangle that is seen edge-on is left to the other edges. */
static bool edge_meets(const point t[3], const point *low, u32 w)
{
	u32 u = (w + 1) % 3, v = (w + 2) % 3;
	i64 whole = area(&t[0], &t[1], &t[2], u, v);
	i64 part[3] = {area(low, &t[1], &t[2], u, v), area(low, &t[2], &t[0], u, v), area(low, &t[0], &t[1], u, v)};
	if (whole == 0) return false;
	__int128 at = 0;
	for (u32 k = 0; k < 3; k++) {
		if (whole > 0 ? part[k] < 0 : part[k] > 0) return false;
		at += (__int128)part[k] * (t[k].c[w] - low->c[w]);
	}
	if (whole < 0) at = -at;
	return at >= 0 && at <= (__int128)(whole < 0 ? -whole : whole) * TS_VOXEL;
}

static bool meets(const point t[3], const i64 voxel[3])
{
	for (u32 k = 0; k < 3; k++) {
		if (segment_meets(&t[k], &t[(k + 1) % 3], voxel)) return true;
	}
	for (u32 edge = 0; edge < 12; edge++) {
		u32 w = edge / 4;
		point low = {{voxel[0] * TS_VOXEL, voxel[1] * TS_VOXEL, voxel[2] * TS_VOXEL}};
		low.c[(w + 1) % 3] += (edge & 1) != 0 ? TS_VOXEL : 0;
		low.c[(w + 2) % 3] += (edge & 2) != 0 ? TS_VOXEL : 0;
		if (edge_meets(t, &low, w)) return true;
	}
	return false;
}

/* Corners that lie anywhere, near each other, on faces of voxels, in a plane across an axis, on a line, or in a
 * point. */
static void fill(point t[3], u32 kind, i64 steps, i64 near)
{
	i64 grid = kind % 3 == 1 ? TS_VOXEL : kind % 3 == 2 ? TS_VOXEL / 2 : 1;
	u32 flat = below(3);
	for (u32 k = 0; k < 3; k++) {
		for (u32 axis = 0; axis < 3; axis++) {
			i64 q = below((u32)steps + 1);
			if (k > 0 && kind % 2 == 1) q = t[0].c[axis] + (i64)below((u32)(2 * near + 1)) - near;
			q = q < 0 ? 0 : q > steps ? steps : q;
			t[k].c[axis] = q / grid * grid;
			if (kind % 7 == 3 && axis == flat) t[k].c[axis] = t[0].c[axis];
		}
	}
	for (u32 axis = 0; kind % 11 == 5 && axis < 3; axis++) {
		t[1].c[axis] = t[0].c[axis] + (t[2].c[axis] - t[0].c[axis]) / 2;
		t[2].c[axis] = 2 * t[1].c[axis] - t[0].c[axis];
	}
	if (kind % 11 == 7) t[2] = t[1];
	if (kind % 33 == 18) t[1] = t[0];
}

static ts_i3 corner(const point *p) { return ts_i3_make((i32)p->c[0], (i32)p->c[1], (i32)p->c[2]); }

static ts_touch touch_of(const point t[3], i32 last)
{
	return ts_k_touch(corner(&t[0]), corner(&t[1]), corner(&t[2]), last);
}

/* What the loops of the kernel ask of one voxel. */
static bool touches(const ts_touch *t, const i64 voxel[3])
{
	ts_i3 p = ts_k_turned(ts_i3_make((i32)voxel[0], (i32)voxel[1], (i32)voxel[2]), t->turn);
	if (p.y < t->box[1].first || p.y > t->box[1].last) return false;
	ts_range row = ts_k_touch_row(t, p.y), column = ts_k_touch_column(t, p.x, p.y);
	return p.x >= row.first && p.x <= row.last && p.z >= column.first && p.z <= column.last &&
	       ts_k_touch_voxel(t, p.x, p.y, p.z);
}

static void compare(const ts_touch *touch, const point t[3], const i64 voxel[3], u32 counts[2])
{
	bool right = meets(t, voxel);
	counts[right]++;
	if (touches(touch, voxel) == right) return;
	fail_msg("(%d %d %d) (%d %d %d) (%d %d %d), voxel %d %d %d: %d", (int)t[0].c[0], (int)t[0].c[1], (int)t[0].c[2],
	         (int)t[1].c[0], (int)t[1].c[1], (int)t[1].c[2], (int)t[2].c[0], (int)t[2].c[1], (int)t[2].c[2],
	         (int)voxel[0], (int)voxel[1], (int)voxel[2], !right);
}

/* Triangles of few steps about a corner of eight voxels: the plane passes it, or misses it by the least there is. */
static void corner_triangles_touch_the_right_voxels(void **state)
{
	(void)state;
	u32 counts[2] = {0, 0};
	for (u32 i = 0; i < 20 * N_TRIANGLES; i++) {
		point t[3];
		i64 at = 1 + below(SIDE - 1);
		for (u32 k = 0; k < 9; k++) t[k / 3].c[k % 3] = at * TS_VOXEL + (i64)below(7) - 3;
		ts_touch touch = touch_of(t, SIDE - 1);
		for (i64 v = 0; v < 8; v++) compare(&touch, t, (i64[]){at - v % 2, at - v / 2 % 2, at - v / 4}, counts);
	}
	assert_true(counts[0] > 10000 && counts[1] > 10000);
}

static void every_voxel_of_small_lattices_is_right(void **state)
{
	(void)state;
	u32 counts[2] = {0, 0};
	for (u32 i = 0; i < N_TRIANGLES; i++) {
		point t[3];
		fill(t, i, STEPS, i % 4 < 2 ? 40 : 700);
		ts_touch touch = touch_of(t, SIDE - 1);
		for (i64 v = 0; v < SIDE * SIDE * SIDE; v++) {
			compare(&touch, t, (i64[]){v % SIDE, v / SIDE % SIDE, v / SIDE / SIDE}, counts);
		}
	}
	assert_true(counts[0] > 100000 && counts[1] > 30000);
}

/* Voxels about points of triangles of every size in the largest lattice, whose numbers are as large as they get. */
static void voxels_of_the_largest_lattice_are_right(void **state)
{
	(void)state;
	enum { SIDE_LARGE = 2048 };
	u32 counts[2] = {0, 0};
	for (u32 i = 0; i < N_LARGE; i++) {
		point t[3];
		fill(t, i, (i64)SIDE_LARGE * TS_VOXEL, 300 << i % 10);
		ts_touch touch = touch_of(t, SIDE_LARGE - 1);
		for (u32 n = 0; n < 200; n++) {
			ts_v3 w = random_weights();
			i64 voxel[3];
			for (u32 k = 0; k < 3; k++) {
				f32 p = ts_blend1(w, (f32)t[0].c[k], (f32)t[1].c[k], (f32)t[2].c[k]);
				voxel[k] = (i64)(p / TS_VOXEL) + (i64)below(3) - 1;
				voxel[k] = voxel[k] < 0 ? 0 : voxel[k] > SIDE_LARGE - 1 ? SIDE_LARGE - 1 : voxel[k];
			}
			compare(&touch, t, voxel, counts);
		}
	}
	assert_true(counts[0] > 10000 && counts[1] > 10000);
}

/* All triangles whose corners are places of a lattice of two voxels a side, at halves of a voxel. */
static void lattice_triangles_touch_the_right_voxels(void **state)
{
	(void)state;
	u32 counts[2] = {0, 0};
	for (u32 i = 0; i < 27 * 27 * 27; i++) {
		point t[3];
		for (u32 k = 0, rest = i; k < 9; k++, rest /= 3)
			t[k / 3].c[k % 3] = (i64)(rest % 3) * (TS_VOXEL / 2) + TS_VOXEL;
		ts_touch touch = touch_of(t, 3);
		for (i64 v = 0; v < 64; v++) compare(&touch, t, (i64[]){v % 4, v / 4 % 4, v / 16}, counts);
	}
	assert_true(counts[0] > 0 && counts[1] > 0);
}

/* The kernel itself: its mask has just the voxels that some triangle meets; triangles without area have none. */
static void the_mask_has_just_the_voxels_met(void **state)
{
	(void)state;
	static small_scene s;
	static point corners[N_TRIANGLES][3];
	ts_root root = {.side = SIDE};
	u64 mask[3 + SIDE * SIDE * SIDE / 64];
	for (u32 world = 0; world < 60; world++) {
		small_clear(&s);
		memset(mask, 0, sizeof mask);
		for (u32 i = 0; i < 4; i++) {
			point *t = corners[i];
			fill(t, world * 4 + i, STEPS, 300);
			ts_v3 p[3];
			for (u32 k = 0; k < 3; k++) {
				p[k] = ts_v3_make((f32)t[k].c[0] / TS_VOXEL, (f32)t[k].c[1] / TS_VOXEL, (f32)t[k].c[2] / TS_VOXEL);
			}
			small_add(&s, p[0], p[1], p[2], 0, 0);
		}
		ts_voxel_args args = {.scene = small_arrays(&s), .root = &root, .mask = mask, .levels = LEVELS};
		for (u32 i = s.n_triangles; i-- > 0;) ts_k_voxel_item(&args, i);
		for (u64 code = 0; code < SIDE * SIDE * SIDE; code++) {
			ts_i3 v = ts_k_unmorton(code);
			bool right = false;
			for (u32 i = 0; i < s.n_triangles; i++) {
				ts_corners t = ts_k_corners(&args.scene, i);
				right |= !ts_k_is_degenerate(t.n) && meets(corners[i], (i64[]){v.x, v.y, v.z});
			}
			assert_int_equal((mask[3 + code / 64] >> (code % 64)) & 1, right);
		}
	}
}

/* The point of a triangle that is nearest to p, as weights of its corners, in double precision: where the plane's is
 * outside, the nearest of the edges'. */
static void nearest_of(const double3 t[3], double3 p, double w[3])
{
	double3 n = d3_cross(d3_sub(t[1], t[0]), d3_sub(t[2], t[0])), d = d3_sub(p, t[0]);
	double least = 1e30, whole = d3_dot(n, n);
	w[1] = d3_dot(d3_cross(d, d3_sub(t[2], t[0])), n) / whole;
	w[2] = d3_dot(d3_cross(d3_sub(t[1], t[0]), d), n) / whole;
	w[0] = 1 - w[1] - w[2];
	if (w[0] >= 0 && w[1] >= 0 && w[2] >= 0) return;
	for (u32 k = 0; k < 3; k++) {
		double3 a = t[k], e = d3_sub(t[(k + 1) % 3], a);
		double along = fmin(fmax(d3_dot(d3_sub(p, a), e) / d3_dot(e, e), 0), 1);
		double far = d3_length(d3_sub(p, d3_mad(a, e, along)));
		if (!(far < least)) continue;
		least = far;
		w[k] = 1 - along;
		w[(k + 1) % 3] = along;
		w[(k + 2) % 3] = 0;
	}
}

/* A masked triangle is in the voxels that it meets and whose middle it is opaque next to; opacity runs across it. */
static void masked_triangles_mark_where_they_are_opaque(void **state)
{
	(void)state;
	static small_scene s;
	static const double opacity[3] = {1, 0.25, 0};
	ts_root root = {.side = SIDE};
	u32 counts[3] = {0, 0, 0};
	for (u32 world = 0; world < 400; world++) {
		point t[3];
		ts_v3 p[3];
		double3 corners[3];
		u64 mask[3 + SIDE * SIDE * SIDE / 64];
		memset(mask, 0, sizeof mask);
		small_clear(&s);
		fill(t, 2 * world, STEPS, 300);
		for (u32 k = 0; k < 3; k++) {
			p[k] = ts_v3_make((f32)t[k].c[0] / TS_VOXEL, (f32)t[k].c[1] / TS_VOXEL, (f32)t[k].c[2] / TS_VOXEL);
			corners[k] = d3_of(p[k]);
		}
		small_add(&s, p[0], p[1], p[2], 1, 0);
		s.materials[1].flags = TS_MASKED;
		for (u32 k = 0; k < 3; k++) s.vertices[k].colour[3] = (f32)opacity[k];
		ts_voxel_args args = {.scene = small_arrays(&s), .root = &root, .mask = mask, .levels = LEVELS};
		if (ts_k_is_degenerate(ts_k_corners(&args.scene, 0).n)) continue;
		ts_k_voxel_item(&args, 0);
		for (u64 code = 0; code < SIDE * SIDE * SIDE; code++) {
			double w[3];
			ts_i3 v = ts_k_unmorton(code);
			bool marked = ((mask[3 + code / 64] >> (code % 64)) & 1) != 0;
			nearest_of(corners, (double3){v.x + 0.5, v.y + 0.5, v.z + 0.5}, w);
			double opaque = w[0] * opacity[0] + w[1] * opacity[1] + w[2] * opacity[2];
			bool met = meets(t, (i64[]){v.x, v.y, v.z});
			if (!met) assert_false(marked);
			if (!met || fabs(opaque - 0.5) < 1e-3) continue;
			counts[opaque < 0.5]++;
			counts[2] += marked != (opaque > 0.5);
		}
	}
	assert_true(counts[0] > 2000 && counts[1] > 2000);
	assert_int_equal(counts[2], 0);
}

static ts_root root_of(const ts_vertex *vertices, u32 n, bool backwards)
{
	ts_root root;
	u32 least[6];
	memset(least, 0xff, sizeof least);
	ts_octree_root_args args = {.vertices = vertices, .least = least, .root = &root};
	for (u32 i = 0; i < n; i++) ts_k_octree_root_least_item(&args, backwards ? n - 1 - i : i);
	ts_k_octree_root_item(&args, 0);
	return root;
}

/* Every vertex is inside by at least a half voxel of the finest lattice, wherever the scene is; and snapping moves it
 * by little more than half a step. */
static void the_root_holds_every_vertex(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_ROOTS; i++) {
		ts_vertex vertices[5];
		f32 far = (f32)exp2((double)uniform(-20, 23)), size = far * (f32)exp2((double)uniform(-22, 0));
		ts_v3 middle = ts_scale(uniform3(-1, 1), far);
		u32 n = 1 + below(5);
		for (u32 k = 0; k < n; k++) ts_store3(vertices[k].position, ts_mad(middle, uniform3(-1, 1), size));
		ts_root root = root_of(vertices, n, false), again = root_of(vertices, n, true);
		assert_memory_equal(&root, &again, sizeof root);
		for (u32 k = 0; k < n; k++) {
			ts_i3 q = ts_k_root_place(&root, 11, ts_load3(vertices[k].position));
			i32 snapped[3] = {q.x, q.y, q.z};
			for (u32 axis = 0; axis < 3; axis++) {
				double exact =
					((double)vertices[k].position[axis] - (double)root.lower[axis]) * 524288 / (double)root.side;
				assert_true(exact > 128 && exact < 524288 - 128);
				assert_near(snapped[axis], exact, 0.6);
			}
		}
	}
}

/* A scene of a single place, and none. */
static void an_empty_scene_has_a_unit_root(void **state)
{
	(void)state;
	ts_vertex origin = {.pad = 0};
	assert_true(root_of(&origin, 1, false).side == 1);
	ts_root none = root_of(NULL, 0, false);
	assert_true(none.side == 1 && none.lower[0] == -0.5f);
}

static void morton_codes_are_right_bit_by_bit(void **state)
{
	(void)state;
	for (u32 i = 0; i < 100000; i++) {
		ts_i3 p = ts_i3_make((i32)below(2048), (i32)below(2048), (i32)below(2048));
		u64 code = 0;
		for (u32 b = 0; b < 11; b++) {
			code |= (u64)(p.x >> b & 1) << (3 * b) | (u64)(p.y >> b & 1) << (3 * b + 1) |
			        (u64)(p.z >> b & 1) << (3 * b + 2);
		}
		ts_i3 back = ts_k_unmorton(code);
		assert_true(ts_k_morton(p) == code && back.x == p.x && back.y == p.y && back.z == p.z);
		u64 word = (u64)bits() << 32 | bits();
		u32 n = 0;
		for (u32 b = 0; b < 64; b++) n += word >> b & 1;
		assert_int_equal(ts_k_count_bits(word), n);
	}
	assert_int_equal(ts_k_count_bits(0), 0);
	assert_int_equal(ts_k_count_bits(TS_EMPTY), 64);
}

/* Narrowing, against looking at every number. */
static void narrowing_keeps_just_the_numbers_inside(void **state)
{
	(void)state;
	for (u32 i = 0; i < 100000; i++) {
		ts_range r = {below(8), 0};
		r.last = r.first + below(10) - 1;
		i64 step = (i64)below(9) - 4, low = (i64)below(60) - 30, high = low + below(20);
		ts_range found = ts_k_narrow(r, step, low, high);
		for (i64 k = r.first; k <= r.last; k++) {
			assert_int_equal(k >= found.first && k <= found.last, step * k >= low && step * k <= high);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(corner_triangles_touch_the_right_voxels),
		seeded_test(every_voxel_of_small_lattices_is_right),
		seeded_test(voxels_of_the_largest_lattice_are_right),
		cmocka_unit_test(lattice_triangles_touch_the_right_voxels),
		seeded_test(the_mask_has_just_the_voxels_met),
		seeded_test(the_root_holds_every_vertex),
		seeded_test(masked_triangles_mark_where_they_are_opaque),
		cmocka_unit_test(an_empty_scene_has_a_unit_root),
		seeded_test(morton_codes_are_right_bit_by_bit),
		seeded_test(narrowing_keeps_just_the_numbers_inside),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

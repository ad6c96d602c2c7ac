/* Coverage: every triangle and every edge-sharing pair of a small lattice; snapping, boxes, and orthographic views. */
#include <stdlib.h>
#include "kernels/raster/clip.h"
#include "kernels/raster/raster.h"
#include "tests/kernels/seeded.h"

/* Lattice points are half pixels apart: every second one is a pixel's centre. Pixels of [-1, 3]^2 hold them all. */
enum { SIDE = 7, N_POINTS = SIDE * SIDE, N_PIXELS = 25 };

static ts_snapped point(u32 k) { return (ts_snapped){(i32)(k % SIDE) * 128, (i32)(k / SIDE) * 128}; }
static i32 centre(i32 pixel) { return pixel * 256 + 128; }

/* The pixels a triangle covers, a bit each. */
static u32 coverage(ts_snapped a, ts_snapped b, ts_snapped c)
{
	u32 mask = 0;
	ts_setup t = ts_k_setup(a, b, c);
	if (t.area == 0) return 0;
	for (i32 k = 0; k < N_PIXELS; k++) {
		ts_edges e = ts_k_edges(&t, centre(k % 5 - 1), centre(k / 5 - 1));
		mask |= (u32)ts_k_covers(&t, &e) << k;
	}
	return mask;
}

static i64 side(ts_snapped a, ts_snapped b, i64 x, i64 y) { return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x); }

/* The top-left rule without edges' names: what holds a centre pushed a hair to the right, and a hair's hair down, which
 * lies on no edge. All coordinates times 2^20; one unit is too little to cross an edge that the centre is not on. */
static bool holds(ts_snapped a, ts_snapped b, ts_snapped c, i32 x, i32 y)
{
	i64 px = (i64)x * 1048576 + 1024, py = (i64)y * 1048576 + 1;
	ts_snapped v[3] = {{a.x << 20, a.y << 20}, {b.x << 20, b.y << 20}, {c.x << 20, c.y << 20}};
	u32 n_left = 0, n_right = 0;
	for (u32 k = 0; k < 3; k++) {
		ts_snapped p = v[k], q = v[(k + 1) % 3];
		i64 e = ((i64)q.x - p.x) * (py - p.y) - ((i64)q.y - p.y) * (px - p.x);
		n_left += e > 0;
		n_right += e < 0;
	}
	return n_left == 3 || n_right == 3;
}

/* Every ordered triangle: coverage is the perturbed centre's, in every order and winding. */
static void every_triangle_covers_its_perturbed_centres(void **state)
{
	(void)state;
	u32 n_triangles = 0;
	for (u32 k = 0; k < N_POINTS * N_POINTS * N_POINTS; k++) {
		ts_snapped a = point(k / N_POINTS / N_POINTS), b = point(k / N_POINTS % N_POINTS), c = point(k % N_POINTS);
		u32 expected = 0;
		n_triangles += side(a, b, c.x, c.y) > 0;
		for (i32 p = 0; p < N_PIXELS; p++) {
			expected |= (u32)holds(a, b, c, centre(p % 5 - 1), centre(p / 5 - 1)) << p;
		}
		if (coverage(a, b, c) == expected) continue;
		print_error("(%d %d) (%d %d) (%d %d) covers %x, not %x\n", a.x, a.y, b.x, b.y, c.x, c.y, coverage(a, b, c),
		            expected);
		fail();
	}
	assert_int_equal(n_triangles, 52800);
}

/* Pixels whose centre is on the open segment. */
static u32 crossed(ts_snapped a, ts_snapped b)
{
	u32 mask = 0;
	for (i32 k = 0; k < N_PIXELS; k++) {
		i64 x = centre(k % 5 - 1), y = centre(k / 5 - 1);
		bool between = (x - a.x) * (x - b.x) + (y - a.y) * (y - b.y) < 0;
		mask |= (u32)(between && side(a, b, x, y) == 0) << k;
	}
	return mask;
}

/* Every pair on the two sides of every edge, run both ways: no pixel twice, and each centre on the edge once. */
static void every_pair_covers_its_edge_once(void **state)
{
	(void)state;
	u32 n_pairs = 0, n_twice = 0, n_never = 0, left[N_POINTS], right[N_POINTS];
	for (u32 k = 0; k < N_POINTS * N_POINTS; k++) {
		ts_snapped a = point(k / N_POINTS), b = point(k % N_POINTS);
		u32 n_left = 0, n_right = 0;
		for (u32 c = 0; c < N_POINTS; c++) {
			i64 e = side(a, b, point(c).x, point(c).y);
			if (e > 0) left[n_left++] = coverage(a, b, point(c));
			if (e < 0) right[n_right++] = coverage(a, b, point(c));
		}
		u32 edge = crossed(a, b);
		for (u32 p = 0; p < n_left * n_right; p++) {
			u32 one = left[p / n_right], other = right[p % n_right];
			n_pairs++;
			n_twice += (one & other) != 0;
			n_never += (edge & ~(one | other)) != 0;
		}
	}
	assert_int_equal(n_pairs, 864704);
	assert_int_equal(n_twice, 0);
	assert_int_equal(n_never, 0);
}

/* In the whole range of snapping. */
static ts_snapped anywhere(void)
{
	i32 x = (i32)below(16777215) - 8388607;
	return (ts_snapped){x, (i32)below(16777215) - 8388607};
}

/* A turned triangle has positive area, its edges sum to it everywhere, and it knows where its corners came from. */
static void setup_turns_triangles_to_positive_area(void **state)
{
	(void)state;
	for (u32 i = 0; i < 100000; i++) {
		ts_snapped v[3];
		for (u32 k = 0; k < 3; k++) v[k] = anywhere();
		ts_setup t = ts_k_setup(v[0], v[1], v[2]);
		ts_snapped p = anywhere();
		ts_edges e = ts_k_edges(&t, p.x, p.y);
		assert_true(t.area == llabs(side(v[0], v[1], v[2].x, v[2].y)));
		assert_true(e.e[0] + e.e[1] + e.e[2] == t.area);
		for (u32 k = 0; k < 3; k++) {
			assert_true(llabs(e.e[k]) <= 1LL << 49);
			assert_memory_equal(&t.v[k], &v[t.from[k]], sizeof t.v[k]);
			ts_edges at = ts_k_edges(&t, t.v[k].x, t.v[k].y);
			assert_true(at.e[k] == t.area);
		}
		assert_int_equal(1u << t.from[0] | 1u << t.from[1] | 1u << t.from[2], 7);
	}
}

static void snapping_rounds_to_the_nearest_step(void **state)
{
	(void)state;
	for (u32 i = 0; i < 100000; i++) {
		ts_v2 p = {uniform(-40000, 40000), uniform(-40000, 40000)};
		ts_snapped s = ts_k_snap(p);
		assert_int_equal(s.x, (i32)fmax(fmin(rint(256 * (double)p.x), 8388607), -8388607));
		assert_int_equal(s.y, (i32)fmax(fmin(rint(256 * (double)p.y), 8388607), -8388607));
	}
}

/* The box holds just the pixels whose centre is within the half size of the corners' box. */
static void boxes_hold_just_the_pixels_within_reach(void **state)
{
	(void)state;
	const i32 half_sizes[] = {0, 128, 129};
	for (u32 i = 0; i < 30000; i++) {
		ts_snapped v[5];
		u32 n = 1 + below(5);
		i32 h = half_sizes[i % 3], x0 = 9999, x1 = -9999, y0 = 9999, y1 = -9999;
		for (u32 k = 0; k < n; k++) {
			v[k] = (ts_snapped){(i32)below(1537) - 768, (i32)below(1537) - 768};
			x0 = v[k].x < x0 ? v[k].x : x0;
			x1 = v[k].x > x1 ? v[k].x : x1;
			y0 = v[k].y < y0 ? v[k].y : y0;
			y1 = v[k].y > y1 ? v[k].y : y1;
		}
		ts_box box = ts_k_touched_box(v, n, h);
		for (i32 p = -6; p < 6; p++) {
			assert_true((p >= box.x0 && p <= box.x1) == (centre(p) >= x0 - h && centre(p) <= x1 + h));
			assert_true((p >= box.y0 && p <= box.y1) == (centre(p) >= y0 - h && centre(p) <= y1 + h));
		}
	}
	ts_camera_k view = {.width = 7, .height = 5};
	ts_box met = ts_k_box_meet(ts_k_view_box(&view), (ts_box){-3, 2, 4, 9});
	assert_true(met.x0 == 0 && met.y0 == 2 && met.x1 == 4 && met.y1 == 4);
}

/* An orthographic view: the projection is a multiple of the place on its axes, whatever the depth; out of sight is what
 * its box does not reach; and a fragment shows what the ray through its pixel meets. */
static void orthographic_views_project_by_multiples(void **state)
{
	(void)state;
	const ts_camera_k view = {.right = {1, 0, 0},
	                          .up = {0, 1, 0},
	                          .back = {0, 0, 1},
	                          .focal = 8,
	                          .near = 0.5f,
	                          .width = 64,
	                          .height = 32,
	                          .orthographic = 1};
	u32 n_seen = 0, n_outside = 0;
	for (u32 i = 0; i < 3000; i++) {
		ts_v3 v[3];
		for (u32 k = 0; k < 3; k++) v[k] = ts_v3_make(uniform(-9, 9), uniform(-9, 9), uniform(-8, 1));
		ts_polygon p = ts_k_polygon(&view, v[0], v[1], v[2]);
		double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
		for (u32 k = 0; k < 3; k++) {
			const double at[3] = {32 + 8 * (double)v[k].x, 16 - 8 * (double)v[k].y, -(double)v[k].z};
			ts_v2 q = ts_k_project(&view, &p.corner[k]);
			assert_true(fabs((double)q.x - at[0]) <= 1e-5 && fabs((double)q.y - at[1]) <= 1e-5);
			for (u32 a = 0; a < 3; a++) low[a] = fmin(low[a], at[a]), high[a] = fmax(high[a], at[a]);
		}
		bool outside = high[0] < 0 || high[1] < 0 || low[0] > 64 || low[1] > 32 || high[2] < 0.5;
		assert_true(ts_k_is_outside(&view, &p) == outside);
		n_outside += outside;
		if (outside || low[2] < 0.5) continue;
		ts_snapped s[3];
		for (u32 k = 0; k < 3; k++) s[k] = ts_k_snap(ts_k_project(&view, &p.corner[k]));
		ts_setup setup = ts_k_setup(s[0], s[1], s[2]);
		if (setup.area < 1 << 18) continue;
		for (i32 k = 0; k < 64 * 32; k += 7) {
			ts_edges e = ts_k_edges(&setup, centre(k % 64), centre(k / 64));
			if (!ts_k_covers(&setup, &e)) continue;
			ts_fragment f = ts_k_fragment_parallel(&setup, &e, &p.corner[0], &p.corner[1], &p.corner[2]);
			double3 n = d3_cross(d3_sub(d3_of(v[1]), d3_of(v[0])), d3_sub(d3_of(v[2]), d3_of(v[0])));
			double x = (k % 64 + 0.5 - 32) / 8, y = (16 - k / 64 - 0.5) / 8;
			double z = (n.x * (x - (double)v[0].x) + n.y * (y - (double)v[0].y)) / n.z - (double)v[0].z;
			double slope = 1 + hypot(n.x, n.y) / fabs(n.z);
			double3 at = d3_blend(f.w, d3_of(v[0]), d3_of(v[1]), d3_of(v[2]));
			assert_true(fabs((double)f.z - z) <= 2e-3 * slope);
			assert_true(fabs(at.x - x) <= 2e-3 && fabs(at.y - y) <= 2e-3 && fabs(at.z + (double)f.z) <= 1e-5);
			n_seen++;
		}
	}
	assert_true(n_seen > 10000 && n_outside > 100);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(every_triangle_covers_its_perturbed_centres), seeded_test(every_pair_covers_its_edge_once),
		seeded_test(setup_turns_triangles_to_positive_area),      seeded_test(snapping_rounds_to_the_nearest_step),
		seeded_test(boxes_hold_just_the_pixels_within_reach),     seeded_test(orthographic_views_project_by_multiples),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Conservative covers: their exact counts over all places within a pixel, and nothing missed of the triangle before
 * snapping. */
#include <stdlib.h>
#include "kernels/raster/cover.h"
#include "tests/kernels/seeded.h"

static i32 common_divisor(i32 a, i32 b)
{
	a = abs(a);
	b = abs(b);
	while (b != 0) {
		i32 r = a % b;
		a = b;
		b = r;
	}
	return a;
}

static u32 n_touched(const ts_cover *c)
{
	u32 n = 0;
	for (i32 j = c->touched.y0; j <= c->touched.y1; j++) {
		for (i32 i = c->touched.x0; i <= c->touched.x1; i++) n += ts_k_touches(c, i, j);
	}
	return n;
}

static ts_cover cover(const ts_snapped *v, u32 n, i32 dx, i32 dy, i32 half_size)
{
	ts_cover c = {.n = n};
	for (u32 k = 0; k < n; k++) c.v[k] = (ts_snapped){v[k].x + dx, v[k].y + dy};
	ts_k_cover_finish(&c, half_size);
	return c;
}

/* Pixels touched, summed over all 256 x 256 places of a polygon within a pixel, are the lattice points of polygon plus
 * square: by Pick's theorem its area, half its border and 1. The mean is A + k (w + h) + k^2, k = 2 half sizes. */
static void judge_count(const ts_snapped *v, u32 n, i32 half_size)
{
	i64 twice_area = 0, border = 8 * half_size, total = 0;
	i32 x0 = v[0].x, x1 = v[0].x, y0 = v[0].y, y1 = v[0].y;
	for (u32 k = 0; k < n; k++) {
		ts_snapped a = v[k], b = v[(k + 1) % n];
		twice_area += (i64)a.x * b.y - (i64)b.x * a.y;
		border += common_divisor(b.x - a.x, b.y - a.y);
		x0 = a.x < x0 ? a.x : x0;
		x1 = a.x > x1 ? a.x : x1;
		y0 = a.y < y0 ? a.y : y0;
		y1 = a.y > y1 ? a.y : y1;
	}
	for (i32 place = 0; place < 65536; place++) {
		ts_cover c = cover(v, n, place & 255, place >> 8, half_size);
		total += n_touched(&c);
	}
	i64 w = x1 - x0, h = y1 - y0, twice_sum = llabs(twice_area) + 4 * half_size * (w + h) + 8 * half_size * half_size;
	assert_true(2 * total == twice_sum + border + 2);
	double k = half_size / 128.0, mean = llabs(twice_area) / 131072.0 + k * (double)(w + h) / 256 + k * k;
	assert_near(total / 65536.0, mean, (double)(border + 2) / 131072);
}

static void covers_count_what_the_area_says(void **state)
{
	(void)state;
	for (u32 i = 0; i < 12; i++) {
		i32 size = 16 << i % 6;
		ts_snapped v[3];
		for (u32 k = 0; k < 3; k++) v[k] = (ts_snapped){(i32)below((u32)size), (i32)below((u32)size)};
		judge_count(v, 3, 128);
		judge_count(v, 3, 129);
	}
}

/* Without area: a point, a segment; with more corners: a hexagon, both ways round. */
static void points_segments_and_hexagons_count_right(void **state)
{
	(void)state;
	const ts_snapped point_[3] = {{5, 7}, {5, 7}, {5, 7}};
	const ts_snapped segment[3] = {{0, 0}, {600, 200}, {300, 100}};
	const ts_snapped hexagon[6] = {{100, 0}, {500, 30}, {620, 200}, {410, 420}, {90, 400}, {0, 230}};
	const ts_snapped turned[6] = {{0, 230}, {90, 400}, {410, 420}, {620, 200}, {500, 30}, {100, 0}};
	judge_count(point_, 3, 128);
	judge_count(segment, 3, 129);
	judge_count(hexagon, 6, 128);
	judge_count(hexagon, 6, 129);
	judge_count(turned, 6, 129);
}

typedef struct {
	double x, y;
} place;

/* How far two convex shapes are apart along a direction; not positive if they may meet. */
static double gap(const place *t, place c, double nx, double ny)
{
	double t0 = 1e9, t1 = -1e9, reach = 0.5 * (fabs(nx) + fabs(ny)), at = c.x * nx + c.y * ny;
	for (u32 k = 0; k < 3; k++) {
		t0 = fmin(t0, t[k].x * nx + t[k].y * ny);
		t1 = fmax(t1, t[k].x * nx + t[k].y * ny);
	}
	return fmax(t0 - (at + reach), at - reach - t1);
}

/* The closed pixel and the triangle before snapping have a point in common: no separating axis. */
static bool really_touches(const place *t, i32 i, i32 j)
{
	place c = {i + 0.5, j + 0.5};
	if (gap(t, c, 1, 0) > 0 || gap(t, c, 0, 1) > 0) return false;
	for (u32 k = 0; k < 3; k++) {
		place a = t[k], b = t[(k + 1) % 3];
		if (gap(t, c, a.y - b.y, b.x - a.x) > 0) return false;
	}
	return true;
}

/* With half size 129 nothing that the unsnapped triangle touches is missed; 128 does miss some, so this can see. */
static void nothing_touched_is_missed(void **state)
{
	(void)state;
	u32 n_missed[2] = {0}, n_touched_really = 0;
	for (u32 n = 0; n < 200000; n++) {
		f32 size = ldexpf(1, (int)below(6) - 2), x = uniform(-100, 100), y = uniform(-100, 100);
		place t[3];
		ts_snapped v[3];
		for (u32 k = 0; k < 3; k++) {
			ts_v2 p = {x + uniform(-size, size), y + uniform(-size, size)};
			t[k] = (place){p.x, p.y};
			v[k] = ts_k_snap(p);
		}
		ts_cover c[2] = {cover(v, 3, 0, 0, 128), cover(v, 3, 0, 0, 129)};
		for (i32 j = c[1].touched.y0 - 1; j <= c[1].touched.y1 + 1; j++) {
			for (i32 i = c[1].touched.x0 - 1; i <= c[1].touched.x1 + 1; i++) {
				if (!really_touches(t, i, j)) continue;
				n_touched_really++;
				for (u32 h = 0; h < 2; h++) {
					ts_box box = c[h].touched;
					bool inside = i >= box.x0 && i <= box.x1 && j >= box.y0 && j <= box.y1;
					n_missed[h] += !inside || !ts_k_touches(&c[h], i, j);
				}
			}
		}
	}
	assert_true(n_touched_really > 1000000);
	assert_true(n_missed[0] > 0 && n_missed[0] < n_touched_really / 1000);
	assert_int_equal(n_missed[1], 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(covers_count_what_the_area_says),
		seeded_test(points_segments_and_hexagons_count_right),
		seeded_test(nothing_touched_is_missed),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

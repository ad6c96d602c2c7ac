/* Clipping and interpolation: what is left of a triangle before the near plane, equal bits along shared edges, and
 * fragments that see what a ray in double precision sees. */
#include "kernels/raster/clip.h"
#include "kernels/raster/raster.h"
#include "tests/kernels/seeded.h"
#include "tests/whole.h"

enum { N = 30000 };

static const ts_camera_k eye = {
	.right = {1, 0, 0},
	.up = {0, 1, 0},
	.back = {0, 0, 1},
	.focal = 400,
	.near = 0.5f,
	.width = 640,
	.height = 480,
};

static double3 at(const ts_corner *c) { return (double3){c->x, c->y, -c->z}; }

static double area(double3 a, double3 b, double3 c) { return d3_length(d3_cross(d3_sub(b, a), d3_sub(c, a))) / 2; }

static double polygon_area(const ts_polygon *p)
{
	double sum = 0;
	for (u32 k = 2; k < p->n; k++) sum += area(at(&p->corner[0]), at(&p->corner[k - 1]), at(&p->corner[k]));
	return sum;
}

/* Share of a triangle's area before depth `near`, by similar triangles: one corner before, or one behind. */
static double share_before(const double *z, double near)
{
	double before = 1, behind = 1;
	u32 n_before = 0;
	for (u32 k = 0; k < 3; k++) {
		n_before += z[k] >= near;
		for (u32 m = 0; m < 3; m++) {
			if (m == k) continue;
			if (z[k] >= near && z[m] < near) before *= (z[k] - near) / (z[k] - z[m]);
			if (z[k] < near && z[m] >= near) behind *= (near - z[k]) / (z[m] - z[k]);
		}
	}
	return n_before == 0 ? 0 : n_before == 1 ? before : n_before == 2 ? 1 - behind : 1;
}

static void clipping_leaves_what_is_before_near(void **state)
{
	(void)state;
	u32 n_cut = 0;
	for (u32 i = 0; i < N; i++) {
		ts_v3 v[3] = {uniform3(-2, 2), uniform3(-2, 2), uniform3(-2, 2)};
		double z[3] = {-(double)v[0].z, -(double)v[1].z, -(double)v[2].z};
		double whole = area(d3_of(v[0]), d3_of(v[1]), d3_of(v[2]));
		ts_polygon p = ts_k_polygon(&eye, v[0], v[1], v[2]);
		ts_k_clip(&p, ts_k_near_plane(&eye), eye.near);
		assert_true(p.n == 0 || p.n == 3 || p.n == 4);
		n_cut += p.n == 4;
		assert_near(polygon_area(&p), share_before(z, eye.near) * whole, 1e-5);
		for (u32 k = 0; k < p.n; k++) {
			const ts_corner *c = &p.corner[k];
			assert_true(c->z >= eye.near);
			assert_true(c->w.x >= 0 && c->w.y >= 0 && c->w.z >= 0);
			assert_near(d3_dot(d3_of(c->w), (double3){1, 1, 1}), 1, 3e-7);
			assert_true(d3_distance(at(c), d3_blend(c->w, d3_of(v[0]), d3_of(v[1]), d3_of(v[2]))) <= 3e-6);
		}
	}
	assert_true(n_cut > N / 10);
}

/* Two triangles at an edge get its cuts with the same bits, whichever way round each runs (rule 16). */
static void both_sides_cut_an_edge_alike(void **state)
{
	(void)state;
	u32 n_shared = 0;
	for (u32 i = 0; i < N; i++) {
		ts_v3 a = uniform3(-2, 2), b = uniform3(-2, 2);
		if ((a.z <= -eye.near) == (b.z <= -eye.near)) continue;
		ts_polygon p = ts_k_polygon(&eye, a, b, uniform3(-2, 2)), q = ts_k_polygon(&eye, b, a, uniform3(-2, 2));
		ts_k_clip(&p, ts_k_near_plane(&eye), eye.near);
		ts_k_clip(&q, ts_k_near_plane(&eye), eye.near);
		u32 n_same = 0;
		for (u32 k = 0; k < p.n * q.n; k++) {
			const ts_corner *c = &p.corner[k / q.n], *d = &q.corner[k % q.n];
			if (c->w.z != 0 || d->w.z != 0 || c->w.x == 1 || c->w.y == 1) continue;
			n_same += same_bits(c->x, d->x) && same_bits(c->y, d->y) && same_bits(c->z, d->z) &&
			          same_bits(c->w.x, d->w.y) && same_bits(c->w.y, d->w.x);
		}
		n_shared++;
		assert_int_equal(n_same, 1);
	}
	assert_true(n_shared > N / 5);
}

/* Whatever the triangle, at most eight corners, all within the range of snapping but for the rounding of cuts, and none
 * before the near plane. */
static void clipped_corners_stay_within_snapping_range(void **state)
{
	(void)state;
	u32 most = 0;
	for (u32 i = 0; i < N; i++) {
		f32 size = ldexpf(1, (int)below(24));
		ts_polygon p = ts_k_polygon(&eye, uniform3(-size, size), uniform3(-size, size), uniform3(-size, size));
		ts_k_clip_to_range(&eye, &p);
		assert_true(p.n == 0 || (p.n >= 3 && p.n <= TS_MAX_CORNERS));
		most = p.n > most ? p.n : most;
		for (u32 k = 0; k < p.n; k++) {
			ts_v2 xy = ts_k_project(&eye, &p.corner[k]);
			assert_true(p.corner[k].z >= eye.near);
			assert_true(ts_abs(xy.x) <= 32783 && ts_abs(xy.y) <= 32783);
		}
	}
	assert_true(most >= 5);
}

/* A triangle with a point in the picture is never outside; one that keeps off it by a plane is. */
static void no_triangle_in_sight_is_outside(void **state)
{
	(void)state;
	const f32 off[6][3] = {{9, 0, -4}, {-9, 0, -4}, {0, 9, -4}, {0, -9, -4}, {0, 0, 1}, {0, 0, -0.4f}};
	u32 n_outside = 0;
	for (u32 i = 0; i < N; i++) {
		ts_v3 v[3] = {uniform3(-4, 4), uniform3(-4, 4), uniform3(-4, 4)};
		ts_polygon p = ts_k_polygon(&eye, v[0], v[1], v[2]);
		bool outside = ts_k_is_outside(&eye, &p);
		n_outside += outside;
		for (u32 k = 0; k < 30 && outside; k++) {
			double3 q = d3_blend(random_weights(), d3_of(v[0]), d3_of(v[1]), d3_of(v[2]));
			bool inside = -q.z > 0.5 + 1e-6 && fabs(q.x) < -q.z * 0.8 - 1e-6 && fabs(q.y) < -q.z * 0.6 - 1e-6;
			assert_false(inside);
		}
	}
	assert_true(n_outside > N / 10 && n_outside < N);
	for (u32 k = 0; k < 6; k++) {
		ts_v3 to = ts_load3(off[k]);
		ts_v3 d = ts_v3_make(0, 0, 0.05f), e = ts_v3_make(0.05f, 0, 0);
		ts_polygon p = ts_k_polygon(&eye, to, ts_add(to, d), ts_add(to, e));
		assert_true(ts_k_is_outside(&eye, &p));
	}
}

typedef struct {
	ts_polygon p;
	ts_setup setup;
	bool is_whole;
} drawn;

static drawn random_drawn(void)
{
	drawn d;
	ts_v3 v[3];
	for (u32 k = 0; k < 3; k++) {
		f32 z = uniform(1, 4);
		v[k] = ts_v3_make(uniform(-0.7f, 0.7f) * z, uniform(-0.5f, 0.5f) * z, -z);
	}
	d.p = ts_k_polygon(&eye, v[0], v[1], v[2]);
	ts_k_clip_to_range(&eye, &d.p);
	d.is_whole = d.p.n == 3;
	d.setup = ts_k_setup(ts_k_snap(ts_k_project(&eye, &d.p.corner[0])), ts_k_snap(ts_k_project(&eye, &d.p.corner[1])),
	                     ts_k_snap(ts_k_project(&eye, &d.p.corner[2])));
	return d;
}

/* A covered pixel of the triangle, at random; false if none was found. */
static bool random_fragment(const drawn *d, i32 *i, i32 *j, ts_fragment *f)
{
	for (u32 k = 0; k < 50; k++) {
		*i = (i32)below(640);
		*j = (i32)below(480);
		ts_edges e = ts_k_edges(&d->setup, *i * 256 + 128, *j * 256 + 128);
		if (d->setup.area == 0 || !ts_k_covers(&d->setup, &e)) continue;
		*f = ts_k_fragment(&d->setup, &e, &d->p.corner[0], &d->p.corner[1], &d->p.corner[2]);
		return true;
	}
	return false;
}

/* The point a fragment names projects back to within the snap of its pixel's centre, at the depth it names. */
static void fragments_project_back_to_their_pixel(void **state)
{
	(void)state;
	u32 n_judged = 0;
	for (u32 n = 0; n < N; n++) {
		drawn d = random_drawn();
		ts_fragment f;
		i32 i, j;
		assert_true(d.is_whole);
		if (!random_fragment(&d, &i, &j, &f)) continue;
		n_judged++;
		double3 p = d3_blend(f.w, at(&d.p.corner[0]), at(&d.p.corner[1]), at(&d.p.corner[2]));
		assert_true(f.w.x >= 0 && f.w.y >= 0 && f.w.z >= 0);
		assert_near(d3_dot(d3_of(f.w), (double3){1, 1, 1}), 1, 1e-6);
		assert_near(f.z, -p.z, 4e-6);
		assert_near(320 + 400 * p.x / -p.z, i + 0.5, 1 / 512.0 + 3e-4);
		assert_near(240 - 400 * p.y / -p.z, j + 0.5, 1 / 512.0 + 3e-4);
	}
	assert_true(n_judged > N / 2);
}

/* Weights of the ray through the pixel's centre, from the areas of the three triangles around its hit. */
static void fragments_see_what_the_ray_sees(void **state)
{
	(void)state;
	u32 n_judged = 0;
	for (u32 n = 0; n < N; n++) {
		drawn d = random_drawn();
		ts_fragment f;
		i32 i, j;
		if (d.setup.area < 2LL * 65536 * 20000 || !random_fragment(&d, &i, &j, &f)) continue;
		double3 a = at(&d.p.corner[0]), b = at(&d.p.corner[1]), c = at(&d.p.corner[2]);
		double3 normal = d3_cross(d3_sub(b, a), d3_sub(c, a));
		double3 ray = {(i + 0.5 - 320) / 400, (240 - j - 0.5) / 400, -1};
		if (fabs(d3_dot(d3_unit(normal), d3_unit(ray))) < 0.3) continue;
		n_judged++;
		double3 q = d3_scale(ray, d3_dot(normal, a) / d3_dot(normal, ray));
		double nn = d3_dot(normal, normal);
		assert_near(f.w.x, d3_dot(d3_cross(d3_sub(b, q), d3_sub(c, q)), normal) / nn, 2e-4);
		assert_near(f.w.y, d3_dot(d3_cross(d3_sub(c, q), d3_sub(a, q)), normal) / nn, 2e-4);
		assert_near(f.w.z, d3_dot(d3_cross(d3_sub(a, q), d3_sub(b, q)), normal) / nn, 2e-4);
		assert_near(f.z, -q.z, 2e-4 * -q.z);
	}
	assert_true(n_judged > N / 10);
}

/* A view from anywhere: the corner's coordinates along the view's own axes. */
static void corners_stand_on_the_views_axes(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_v3 back = direction(), right = ts_normalize(ts_cross(direction(), back)), up = ts_cross(back, right);
		ts_view record = {.focal = 100, .near = 0.25f, .width = 64, .height = 32};
		ts_v3 from = uniform3(-9, 9), p = uniform3(-9, 9);
		ts_store3(record.eye, from);
		ts_store3(record.right, right);
		ts_store3(record.up, up);
		ts_store3(record.back, back);
		ts_camera_k view = ts_k_view(&record);
		ts_corner c = ts_k_to_view(&view, p);
		double3 back_again = d3_mad(d3_of(from), d3_of(right), c.x);
		back_again = d3_mad(d3_mad(back_again, d3_of(up), c.y), d3_of(back), -(double)c.z);
		assert_true(d3_distance(back_again, d3_of(p)) <= 2e-5);
		if (c.z < 0.25f) continue;
		ts_v2 xy = ts_k_project(&view, &c);
		assert_near(xy.x, 32 + 100.0 * c.x / c.z, 1e-4 * (1 + fabs(xy.x)));
		assert_near(xy.y, 16 - 100.0 * c.y / c.z, 1e-4 * (1 + fabs(xy.y)));
	}
}

/* Edge-on triangles in a plane of the snapping range change sides by rounding at every corner; the polygon stays
 * bounded. */
static void edge_on_triangles_stay_bounded(void **state)
{
	(void)state;
	const ts_camera_k face = {
		.right = {1, 0, 0},
		.up = {0, 1, 0},
		.back = {0, 0, 1},
		.focal = 256,
		.near = 0.01f,
		.width = 512,
		.height = 512,
	};
	n_random = 0;
	u32 n_bounded = 0, n = whole_or(200, 40) * N;
	for (u32 i = 0; i < n; i++) {
		ts_v3 corner[3];
		f32 slope = (32767.0f - 256.0f) / 256.0f;
		for (u32 k = 0; k < 3; k++) {
			f32 x = uniform(-160, 160);
			corner[k] = ts_v3_make(x, uniform(-220, 220), uniform(0, 1) < 0.5 ? -x / slope : x / slope);
		}
		ts_polygon p = ts_k_polygon(&face, corner[0], corner[1], corner[2]);
		ts_k_clip_to_range(&face, &p);
		assert_true(p.n <= TS_MAX_CORNERS);
		n_bounded += p.n > 4;
	}
	assert_true(n_bounded > 0);
	const ts_v3 known[3] = {
		{0x1.14061p7f, 0x1.66d714p7f, 0x1.69ad42p0f},
		{-0x1.0c06dep7f, -0x1.36b26p7f, -0x1.39272p0f},
		{0x1.2fcd84p6f, -0x1.be37dcp7f, -0x1.c1bedcp0f},
	};
	for (u32 k = 0; k < 8; k++) {
		ts_camera_k turned = face;
		turned.back = ts_v3_make(0, 0, (k & 1) != 0 ? 1 : -1);
		turned.right = ts_v3_make((k & 2) != 0 ? 1 : -1, 0, 0);
		turned.up = ts_v3_make(0, (k & 4) != 0 ? 1 : -1, 0);
		ts_polygon p = ts_k_polygon(&turned, known[0], known[1], known[2]);
		ts_k_clip_to_range(&turned, &p);
		assert_true(p.n <= TS_MAX_CORNERS);
	}
}

/* Rule 16: a side below 2^-100 counts as 0, which is inside; so a corner that close before a plane is not cut off. */
static void a_tiny_side_counts_as_inside(void **state)
{
	(void)state;
	const ts_plane left = {1, 0, 0, 0};
	for (i32 e = -126; e <= -90; e++) {
		ts_corner outside = {.x = (f32)-ldexp(1, e), .z = 1};
		ts_polygon p = {.corner = {{.x = 1, .z = 1}, {.x = 1, .y = 1, .z = 1}, outside}, .n = 3};
		assert_true(ts_k_plane_side(&left, &outside) == (e < -100 ? 0 : outside.x));
		ts_k_clip(&p, left, 0);
		assert_int_equal(p.n, e < -100 ? 3 : 4);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(edge_on_triangles_stay_bounded), seeded_test(clipping_leaves_what_is_before_near),
		seeded_test(both_sides_cut_an_edge_alike),        seeded_test(clipped_corners_stay_within_snapping_range),
		seeded_test(no_triangle_in_sight_is_outside),     seeded_test(fragments_project_back_to_their_pixel),
		seeded_test(fragments_see_what_the_ray_sees),     seeded_test(corners_stand_on_the_views_axes),
		cmocka_unit_test(a_tiny_side_counts_as_inside),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

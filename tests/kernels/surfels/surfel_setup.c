/* Surfels in a view against rays cast into their planes in double precision: plane coordinates, depth, bounds that
 * hold every covered pixel where those of point sprites do not, and what is not drawn at all. */
#include "kernels/surfels/fragment.h"
#include "kernels/surfels/surfel_setup.h"
#include "tests/kernels/seeded.h"

enum { WIDTH = 96, HEIGHT = 54 };

static ts_camera_k camera(bool parallel)
{
	ts_camera_k view = {.focal = parallel ? 40 : 48, .near = 0.01f, .width = WIDTH, .height = HEIGHT};
	view.orthographic = parallel;
	view.back = direction();
	view.right = ts_normalize(ts_cross(direction(), view.back));
	view.up = ts_cross(view.back, view.right);
	view.eye = uniform3(-2, 2);
	return view;
}

static ts_filter filter_of(f32 sigma, bool botsch)
{
	return (ts_filter){.botsch = botsch,
	                   .per_sigma2 = sigma > 0 ? 1 / (sigma * sigma) : 0,
	                   .reach = sigma,
	                   .fall = 2,
	                   .object2 = 0.25f,
	                   .screen2 = 0.25f};
}

/* Somewhere before the camera, of any size up to what reaches its plane. */
static ts_surfel surfel_of(const ts_camera_k *view, f32 largest)
{
	ts_surfel s;
	f32 z = uniform(0.5f, 8), x = uniform(-1.1f, 1.1f) * z, y = uniform(-0.7f, 0.7f) * z;
	f32 size = largest * powf(2, uniform(-9, 0)), thin = uniform(0.1f, 1);
	ts_v3 n = direction(), u = ts_normalize(ts_cross(n, direction())), v = ts_cross(n, u);
	ts_v3 p = ts_add(ts_add(ts_scale(view->right, x), ts_scale(view->up, y)), ts_scale(view->back, -z));
	ts_store3(s.centre, ts_add(view->eye, p));
	ts_store3(s.u, ts_scale(u, size));
	ts_store3(s.v, ts_scale(v, size * thin));
	ts_store3(s.colour, ts_v3_make(1, 1, 1));
	return s;
}

typedef struct {
	double a, b, z, slant;
} hit3;

/* The ray through (x, y) of the image into the plane of the surfel, whose view-space axes are given: a (v x d) . u */
static hit3 cast(const ts_camera_k *view, const ts_disc_frame *f, double x, double y)
{
	double i = (x - view->width / 2.0) / view->focal, j = (view->height / 2.0 - y) / view->focal;
	bool parallel = view->orthographic != 0;
	double3 u = d3_of(f->u), v = d3_of(f->v), n = d3_cross(u, v), far = {f->c.x, f->c.y, f->c.z};
	double3 c = d3_mad(d3_mad(far, u, -(double)f->a), v, -(double)f->b);
	double3 from = {parallel ? i : 0, parallel ? j : 0, 0}, way = {parallel ? 0 : i, parallel ? 0 : j, 1};
	double t = d3_dot(d3_sub(c, from), n) / d3_dot(way, n);
	double3 d = d3_sub(d3_mad(from, way, t), c);
	double uu = d3_dot(u, u), vv = d3_dot(v, v), uv = d3_dot(u, v), det = uu * vv - uv * uv;
	double du = d3_dot(d, u), dv = d3_dot(d, v);
	double slant = fabs(d3_dot(way, n)) / (d3_length(way) * d3_length(n));
	return (hit3){(du * vv - dv * uv) / det, (dv * uu - du * uv) / det, t, slant};
}

static bool is_inside(const hit3 *hit, double near) { return hit->z >= near && hit->a * hit->a + hit->b * hit->b <= 1; }

enum { SURFELS = 3000 };

static void plane_coordinates_are_those_of_rays(void **state)
{
	(void)state;
	u32 n = 0;
	double worst = 0, grazing = 0, deepest = 0;
	for (u32 i = 0; i < SURFELS; i++) {
		ts_disc disc;
		ts_camera_k view = camera(i % 4 == 0);
		ts_filter filter = filter_of(1, false);
		ts_surfel surfel = surfel_of(&view, 1);
		if (ts_k_disc(&disc, &view, &filter, &surfel) != TS_DISC_DRAWN) continue;
		ts_disc_frame frame = ts_k_disc_frame(&view, &filter, &surfel);
		for (i32 y = disc.low[1]; y <= disc.high[1]; y++) {
			for (i32 x = disc.low[0]; x <= disc.high[0]; x++) {
				hit3 truth = cast(&view, &frame, x + 0.5, y + 0.5);
				ts_v2 d = ts_k_disc_offset(&disc, x, y);
				ts_disc_hit hit = ts_k_disc_hit(&disc, view.near, d.x, d.y);
				if (!is_inside(&truth, view.near)) continue;
				double off = fmax(fabs(hit.a - truth.a), fabs(hit.b - truth.b));
				worst = fmax(worst, truth.slant > 0.5 ? off : 0);
				grazing = fmax(grazing, off * truth.slant);
				deepest = fmax(deepest, fabs(hit.z - truth.z) / truth.z);
				n++;
			}
		}
	}
	print_message("# %u fragments: (a, b) within %.2g, %.2g / cosine; depth within %.2g\n", n, worst, grazing, deepest);
	assert_true(n > 20000);
	assert_true(worst < 1e-6);
	assert_true(grazing <
	            1e-6); /* the rounding of a ray itself moves where it meets the plane by as much as it leans */
	assert_true(deepest < 1e-5);
}

/* Pixels inside the ellipse beside the box. */
static u32 missed(const ts_camera_k *view, const ts_disc *disc, const ts_disc_frame *frame)
{
	u32 n = 0;
	for (i32 y = 0; y < HEIGHT; y++) {
		for (i32 x = 0; x < WIDTH; x++) {
			hit3 truth = cast(view, frame, x + 0.5, y + 0.5);
			bool held = x >= disc->low[0] && x <= disc->high[0] && y >= disc->low[1] && y <= disc->high[1];
			n += is_inside(&truth, view->near) && !held;
		}
	}
	return n;
}

static void bounds_hold_every_covered_pixel(void **state)
{
	(void)state;
	u32 n_missed[2] = {0, 0}, n_surfels[2] = {0, 0}, n_drawn = 0;
	for (u32 i = 0; i < SURFELS; i++) {
		ts_camera_k view = camera(i % 4 == 0);
		ts_surfel surfel = surfel_of(&view, 8); /* some reach the eye's plane */
		for (u32 botsch = 0; botsch < 2; botsch++) {
			ts_disc disc;
			ts_filter filter = filter_of(0, botsch);
			ts_disc_frame frame = ts_k_disc_frame(&view, &filter, &surfel);
			if (ts_k_disc(&disc, &view, &filter, &surfel) != TS_DISC_DRAWN) continue;
			u32 pixels = missed(&view, &disc, &frame);
			n_missed[botsch] += pixels;
			n_surfels[botsch] += pixels != 0;
			n_drawn++;
		}
	}
	print_message("# of %u surfels the squares of %u miss %u pixels\n", n_drawn / 2, n_surfels[1], n_missed[1]);
	assert_int_equal(n_missed[0], 0);
	assert_true(n_surfels[1] > n_drawn / 2 / 50);
}

/* Boxes hold no column that is farther than a sixteenth of a pixel, and what rounding adds, from the ellipse. */
static void bounds_are_tight_around_the_ellipse(void **state)
{
	(void)state;
	for (u32 i = 0; i < SURFELS; i++) {
		ts_disc disc;
		ts_camera_k view = camera(false);
		ts_filter filter = filter_of(0, false);
		ts_surfel surfel = surfel_of(&view, 0.4f);
		ts_disc_frame frame = ts_k_disc_frame(&view, &filter, &surfel);
		if (ts_k_disc(&disc, &view, &filter, &surfel) != TS_DISC_DRAWN) continue;
		double least = 1e9, most = -1e9;
		for (u32 k = 0; k < 256; k++) {
			double t = k * (2 * 3.14159265358979 / 256), a = cos(t), b = sin(t);
			double z = frame.c.z + a * frame.u.z + b * frame.v.z;
			double x = WIDTH / 2.0 + view.focal * (frame.c.x + a * frame.u.x + b * frame.v.x) / z;
			least = fmin(least, x);
			most = fmax(most, x);
		}
		assert_true(disc.low[0] >= fmin(fmax(floor(least - 0.5625), 0), WIDTH - 1));
		assert_true(disc.high[0] <= fmax(fmin(floor(most + 0.5625), WIDTH - 1), 0));
	}
}

typedef struct {
	u32 drawn, inside, outside;
} crossings;

/* What crosses the near plane is drawn where rays meet it behind that, and nowhere else. */
static void check_crossing(crossings *n, const ts_camera_k *view, const ts_filter *filter, const ts_surfel *surfel)
{
	ts_disc disc;
	ts_filter unmoved = {.filter = TS_FILTER_SCREEN};
	ts_disc_frame frame = ts_k_disc_frame(view, &unmoved, surfel);
	u32 fate = ts_k_disc(&disc, view, filter, surfel);
	if (fate == TS_DISC_TURNED || frame.c.z >= view->near) return;
	n->drawn += fate == TS_DISC_DRAWN;
	double3 c = {frame.c.x, frame.c.y, frame.c.z}, across = d3_cross(d3_of(frame.u), d3_of(frame.v));
	double away = fabs(d3_dot(c, across)) / d3_length(across),
		   size = d3_length(d3_of(frame.u)); /* of the plane; of it */
	for (u32 i = 0; i < WIDTH * HEIGHT; i++) {
		i32 x = (i32)(i % WIDTH), y = (i32)(i / WIDTH);
		hit3 truth = cast(view, &frame, x + 0.5, y + 0.5);
		double r2 = truth.a * truth.a + truth.b * truth.b, near = (double)view->near;
		bool held = x >= disc.low[0] && x <= disc.high[0] && y >= disc.low[1] && y <= disc.high[1];
		if (truth.slant * away < 1e-3 * size || fabs(r2 - 1) < 1e-2 || fabs(truth.z - near) < 1e-2 * near) continue;
		ts_surfel_fragment f = ts_k_surfel_fragment(&disc, filter, view->near, x, y);
		bool inside = is_inside(&truth, near);
		assert_true(held ? f.inside == inside && f.covers == inside : !inside);
		*(inside ? &n->inside : &n->outside) += 1;
		if (!inside) continue;
		double rounding = 1e-5 * fmax(size / away, 1) / truth.slant;
		assert_true(fabs((double)f.z - truth.z) < rounding * truth.z);
		assert_true(fabs((double)f.exponent - r2 * (double)filter->fall) < rounding);
	}
}

static void surfels_across_the_near_plane_are_clipped(void **state)
{
	(void)state;
	crossings n = {0, 0, 0};
	for (u32 i = 0; i < SURFELS; i++) {
		ts_camera_k view = camera(i % 4 == 0);
		ts_filter filter = filter_of(1, i % 8 == 1);
		filter.filter = i % 3 == 0 ? TS_FILTER_OBJECT : TS_FILTER_MIN;
		view.near = i % 5 == 0 ? 0.5f : 0.01f;
		ts_surfel surfel = surfel_of(&view, 16);
		ts_v3 beside = ts_mad(ts_scale(view.right, uniform(-2, 2)), view.up, uniform(-2, 2));
		ts_store3(surfel.centre, ts_mad(ts_add(view.eye, beside), view.back, uniform(-0.5f, 2)));
		check_crossing(&n, &view, &filter, &surfel);
	}
	print_message("# %u drawn, in %u pixels and not in %u\n", n.drawn, n.inside, n.outside);
	assert_true(n.drawn > 200 && n.inside > 20000);
}

/* A round floor of radius 4, on which the eye stands, 1 above its centre: a row of pixels is f / (y - H/2) away. */
static void floors_are_as_deep_as_their_rows(void **state)
{
	(void)state;
	u32 n = 0;
	ts_disc disc;
	ts_camera_k view = {.right = {1, 0, 0},
	                    .up = {0, 1, 0},
	                    .back = {0, 0, 1},
	                    .eye = {0, 1, 0},
	                    .focal = 48,
	                    .near = 0.01f,
	                    .width = WIDTH,
	                    .height = HEIGHT};
	ts_filter filter = filter_of(1, false);
	const ts_surfel surfel = {.u = {0, 0, 4}, .v = {4, 0, 0}};
	assert_int_equal(ts_k_disc(&disc, &view, &filter, &surfel), TS_DISC_DRAWN);
	assert_int_equal(disc.flags, TS_DISC_CROSSES);
	for (i32 y = disc.low[1]; y <= disc.high[1]; y++) {
		for (i32 x = disc.low[0]; x <= disc.high[0]; x++) {
			double z = 48 / (y + 0.5 - HEIGHT / 2), across = (x + 0.5 - WIDTH / 2) / 48 * z;
			ts_surfel_fragment f = ts_k_surfel_fragment(&disc, &filter, view.near, x, y);
			assert_int_equal(f.covers, z > 0 && across * across + z * z <= 16);
			n += f.covers;
			if (f.covers) assert_true(fabs((double)f.z - z) < 1e-5 * z);
		}
	}
	print_message("# %u pixels of a floor\n", n);
	assert_true(disc.high[1] == HEIGHT - 1 && disc.low[0] == 0 && disc.high[0] == WIDTH - 1 && n > WIDTH * HEIGHT / 8);
	filter.filter = TS_FILTER_SCREEN;
	assert_int_equal(ts_k_disc(&disc, &view, &filter, &surfel), TS_DISC_BEFORE);
	filter.filter = TS_FILTER_EWA;
	assert_int_equal(ts_k_disc(&disc, &view, &filter, &surfel), TS_DISC_BEFORE);
}

/* The products of the centre's place are exact: against double, which holds 48 bits. */
static void products_of_the_place_are_exact(void **state)
{
	(void)state;
	for (u32 i = 0; i < 100000; i++) {
		f32 a = uniform(-4096, 4096), b = uniform(-4096, 4096) * powf(2, (f32)below(40) - 20);
		ts_v2 p = ts_k_product(a, b);
		assert_true((double)p.x + (double)p.y == (double)a * (double)b);
		assert_true(p.x == a * b);
	}
}

static u32 fate(const ts_camera_k *view, ts_v3 centre, ts_v3 u, ts_v3 v, ts_disc *disc)
{
	ts_surfel s = {.colour = {1, 1, 1}};
	ts_filter filter = filter_of(1, false);
	ts_store3(s.centre, centre);
	ts_store3(s.u, u);
	ts_store3(s.v, v);
	return ts_k_disc(disc, view, &filter, &s);
}

static void each_surfel_meets_its_fate(void **state)
{
	(void)state;
	ts_disc disc;
	ts_camera_k view = {.right = {1, 0, 0},
	                    .up = {0, 1, 0},
	                    .back = {0, 0, 1},
	                    .focal = 48,
	                    .near = 0.01f,
	                    .width = WIDTH,
	                    .height = HEIGHT};
	ts_v3 x = {0.1f, 0, 0}, y = {0, 0.1f, 0}, z = {0, 0, 0.1f}, p = {0, 0, -2};
	assert_int_equal(fate(&view, p, x, y, &disc), TS_DISC_DRAWN);
	assert_int_equal(disc.flags, 0);
	assert_int_equal(fate(&view, p, y, x, &disc), TS_DISC_TURNED);
	assert_true(disc.high[0] < disc.low[0]);
	assert_int_equal(fate(&view, p, x, z, &disc),
	                 TS_DISC_TURNED); /* edge-on: the normal is at a right angle to the ray */
	assert_int_equal(fate(&view, ts_v3_make(0, 0, 2), y, x, &disc), TS_DISC_BEFORE);
	assert_int_equal(fate(&view, ts_v3_make(5, 0, -2), x, y, &disc), TS_DISC_BESIDE);
	assert_int_equal(fate(&view, ts_v3_make(1e7f, 0, -2), x, y, &disc), TS_DISC_BESIDE);
	ts_v3 lean = {0, 1e-8f, 0.1f}; /* all but edge-on: its centre counts */
	assert_int_equal(fate(&view, p, x, ts_v3_make(0, lean.y, -lean.z), &disc), TS_DISC_DRAWN);
	assert_int_equal(disc.flags, TS_DISC_FLAT);
	ts_filter filter = filter_of(1, false);
	ts_surfel_fragment f = ts_k_surfel_fragment(&disc, &filter, view.near, disc.pixel[0], disc.pixel[1]);
	assert_true(f.covers && !f.inside && f.z == disc.depth);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(plane_coordinates_are_those_of_rays), seeded_test(bounds_hold_every_covered_pixel),
		seeded_test(bounds_are_tight_around_the_ellipse), seeded_test(surfels_across_the_near_plane_are_clipped),
		seeded_test(floors_are_as_deep_as_their_rows),    seeded_test(products_of_the_place_are_exact),
		seeded_test(each_surfel_meets_its_fate),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

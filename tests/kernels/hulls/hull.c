/* From triangles of light to pixels: their shape, which box lights a pixel, and interpolation on planes, where it
 * is exact; truths in double precision that share no formula with the kernels. */
#include <stdlib.h>
#include "kernels/hulls/corner.h"
#include "kernels/hulls/direct.h"
#include "kernels/hulls/hull.h"
#include "kernels/raster/patch.h"
#include "tests/kernels/seeded.h"

enum { N = 3000, GRID = 96, TEXELS = GRID * GRID, BLOCKS = 9, MOST_BOXES = 400, WIDTH = 150, HEIGHT = 70 };

/* Area, place, plane, sides and winding of random patches. */
static void patches_have_their_area_place_and_plane(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_patch patch;
		ts_v3 p = uniform3(-9, 9), n = direction();
		if (i < 6) n = ts_v3_make(i / 2 == 0 ? 1.0f : 0, i / 2 == 1 ? 1.0f : 0, i / 2 == 2 ? 1.0f : 0);
		if (i % 2 != 0) n = ts_neg(n);
		f32 area = uniform(0.001f, 4);
		ts_k_patch_corners(&patch, p, n, area);
		double3 a = d3_of(ts_load3(patch.a)), b = d3_of(ts_load3(patch.b)), c = d3_of(ts_load3(patch.c));
		double3 middle = d3_scale(d3_add(d3_add(a, b), c), 1.0 / 3), cross = d3_cross(d3_sub(b, a), d3_sub(c, a));
		assert_near(d3_length(cross) / 2, area, 2e-5 * (1 + area));
		assert_near(d3_distance(middle, d3_of(p)), 0, 2e-6);
		assert_near(d3_dot(d3_unit(cross), d3_of(n)), 1, 1e-5);
		assert_near(d3_distance(a, b), d3_distance(b, c), 4e-6);
		assert_near(d3_distance(a, b), d3_distance(c, a), 4e-6);
	}
}

/* A view along -back; orthographic or not. */
static ts_camera_k random_camera(u32 orthographic)
{
	ts_camera_k view = {.eye = uniform3(-2, 2),
	                    .back = direction(),
	                    .width = 16,
	                    .height = 16,
	                    .near = 0.0078125f,
	                    .orthographic = orthographic};
	view.right = ts_normalize(ts_cross(direction(), view.back));
	view.up = ts_cross(view.back, view.right);
	view.focal = uniform(8, 20);
	return view;
}

/* What a texel sees of a plane fills the texel: corners of its square, projected along its rays onto the plane. */
static void a_texels_area_is_what_it_sees(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_camera_k view = random_camera(i % 2);
		view.focal = view.focal * 16; /* small texels, whose own perspective does not count */
		double x = uniform(-60, 60), y = uniform(-60, 60), z = uniform(0.5f, 8);
		double3 corner[4], right = d3_of(view.right), up = d3_of(view.up), back = d3_of(view.back), p, way;
		for (u32 k = 0; k < 5; k++) {
			double u = x + (k == 4 ? 0 : k % 2 - 0.5), v = y + (k == 4 ? 0 : k / 2 - 0.5);
			double3 at = d3_add(d3_scale(right, u / view.focal), d3_scale(up, v / view.focal));
			double3 from = d3_add(d3_of(view.eye), i % 2 != 0 ? at : d3_scale(at, 0));
			way = i % 2 != 0 ? d3_scale(back, -1) : d3_sub(at, back);
			p = d3_mad(from, way, z);
			if (k < 4) corner[k] = p;
		}
		ts_v3 n = direction();
		double cosine = -d3_dot(d3_of(n), d3_unit(way));
		if (cosine < 0.2) continue;
		for (u32 k = 0; k < 4; k++) {
			double3 along = i % 2 != 0 ? back : d3_sub(corner[k], d3_of(view.eye));
			double t = d3_dot(d3_of(n), d3_sub(p, corner[k])) / d3_dot(d3_of(n), along);
			corner[k] = d3_mad(corner[k], along, t);
		}
		double area = d3_length(d3_cross(d3_sub(corner[3], corner[0]), d3_sub(corner[2], corner[1]))) / 2;
		ts_v3 at = ts_v3_make((f32)p.x, (f32)p.y, (f32)p.z);
		assert_near(ts_k_texel_area(&view, at, (f32)cosine), area, 2e-3 * area);
	}
}

static ts_segment random_box(void)
{
	u32 x = below(GRID), y = below(GRID), block = ts_k_block_of(GRID, x, y);
	f32 nearest = uniform(0.5f, 0.95f);
	ts_segment box = {.low = {x, y}, .nearest = nearest, .farthest = nearest + uniform(0, 0.1f), .label = block * 1024};
	for (u32 k = 0; k < 2; k++) box.high[k] = box.low[k] + below(32 - box.low[k] % 32);
	return box;
}

/* Boxes of the blocks, some of which have none, and their offsets. */
typedef struct {
	ts_segment boxes[MOST_BOXES];
	u32 offset[TEXELS + 1], n;
} hulls;

static void random_hulls(hulls *h, u32 most)
{
	h->n = 0;
	for (u32 label = 0; label < TEXELS; label++) {
		h->offset[label] = h->n;
		bool has = label % 1024 < most && (label / 1024 * 7 + most) % 3 != 0 && below(2) == 0;
		if (!has || h->n == MOST_BOXES) continue;
		ts_segment box = random_box();
		u32 block = label / 1024, x = block % 3 * 32, y = block / 3 * 32;
		for (u32 k = 0; k < 2; k++) {
			u32 first = k == 0 ? x : y;
			box.low[k] = first + below(32);
			box.high[k] = box.low[k] + below(first + 32 - box.low[k]);
		}
		box.label = label;
		if (below(4) == 0 && h->n > 0) { /* as thick as another */
			box.nearest = h->boxes[h->n - 1].nearest;
			box.farthest = h->boxes[h->n - 1].farthest;
		}
		h->boxes[h->n++] = box;
	}
	h->offset[TEXELS] = h->n;
}

/* METHODS 11 by sorting reasons: how far the block is, whether the box covers, how the depth fits. */
static u32 choose(const hulls *h, ts_grid_place at, bool robust, f32 step)
{
	u32 best = TS_NONE, best_class = 0;
	f32 best_measure = 0, slack = step * (1 - at.depth);
	for (u32 b = 0; b < h->n; b++) {
		const ts_segment *box = &h->boxes[b];
		i32 block = (i32)(box->label / 1024), dx = abs(block % 3 - (i32)(at.x / 32)),
			dy = abs(block / 3 - (i32)(at.y / 32));
		bool covers = at.x >= box->low[0] && at.x <= box->high[0] && at.y >= box->low[1] && at.y <= box->high[1];
		bool holds = at.depth >= box->nearest && at.depth <= box->farthest;
		f32 gap = holds ? 0 : at.depth < box->nearest ? box->nearest - at.depth : at.depth - box->farthest;
		u32 class = covers && holds ? 0 : covers && gap <= slack ? 1 : covers ? 2 : 3 + (u32)(dx > dy ? dx : dy);
		f32 measure = class < 2 ? box->farthest - box->nearest : gap;
		bool better = best == TS_NONE || class < best_class || (class == best_class && measure < best_measure);
		if (!better || (!robust && class != 0)) continue;
		best = b;
		best_class = class;
		best_measure = measure;
	}
	return best;
}

static void the_choice_of_boxes_follows_its_reasons(void **state)
{
	(void)state;
	static hulls h;
	u32 n_held = 0, n_far = 0;
	for (u32 i = 0; i < 300; i++) {
		random_hulls(&h, i % 40);
		ts_choice_args args = {.offset = h.offset, .boxes = h.boxes, .grid = GRID, .step = uniform(0, 0.1f)};
		for (u32 k = 0; k < 200; k++) {
			ts_grid_place at = {below(GRID), below(GRID), uniform(0.45f, 1)};
			args.robust = 0;
			u32 held = ts_k_choose_box(&args, at);
			assert_int_equal(held, choose(&h, at, false, args.step));
			args.robust = 1;
			u32 box = ts_k_choose_box(&args, at);
			/* Equals of blocks at one distance go by blocks, which the rings go through in order. */
			assert_int_equal(box, choose(&h, at, true, args.step));
			assert_true((box == TS_NONE) == (h.n == 0) && (held == TS_NONE || held == box));
			n_held += held != TS_NONE;
			n_far += box != TS_NONE && h.boxes[box].label / 1024 != ts_k_block_of(GRID, at.x, at.y);
		}
	}
	assert_true(n_held > 1000 && n_far > 1000);
}

/* On a plane a number that is linear in space is interpolated exactly: corners where the plane meets the rays of the
 * pixels that show the texels at the corners, at a pixel the plane's point on its ray. Beyond the corners nothing
 * changes. */
static void interpolation_is_exact_on_planes(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		f32 focal = uniform(60, 200), near = 0.0625f;
		ts_segment box = random_box();
		const u32 rectangle = i % 2;
		ts_moment corners[4];
		ts_v3 n = direction();
		double3 point[4], normal = d3_of(n);
		double d = uniform(1, 5), low[2], high[2];
		const double pixels[2] = {WIDTH, HEIGHT};
		for (u32 k = 0; k < 2; k++) {
			low[k] = floor((box.low[k] + 0.5) * pixels[k] / GRID) + 0.5;
			double end = rectangle != 0 ? fmin(box.high[k] + 1, GRID - 1) : box.high[k];
			high[k] = floor((end + 0.5) * pixels[k] / GRID) + 0.5;
		}
		bool seen = true;
		for (u32 k = 0; k < 4; k++) {
			double x = k % 2 != 0 ? high[0] : low[0], y = k / 2 != 0 ? high[1] : low[1];
			double3 way = {(x - WIDTH / 2.0) / focal, (HEIGHT / 2.0 - y) / focal, -1};
			double z = d / d3_dot(normal, way);
			seen = seen && z > 0.2 && z < 100;
			point[k] = d3_scale(way, z);
			corners[k] = (ts_moment){.depth = (f32)(1 - near / z)};
		}
		if (!seen) continue;
		ts_hull_args args = {.choice = {.boxes = &box, .grid = GRID}, .moments = corners};
		args.width = WIDTH;
		args.height = HEIGHT;
		args.rectangle = rectangle;
		for (u32 k = 0; k < 10; k++) {
			u32 x = below(WIDTH), y = below(HEIGHT);
			ts_shares shares = ts_k_box_shares(&args, 0, x, y);
			double px = fmin(fmax(x + 0.5, low[0]), high[0]), py = fmin(fmax(y + 0.5, low[1]), high[1]), sum = 0;
			double3 way = {(px - WIDTH / 2.0) / focal, (HEIGHT / 2.0 - py) / focal, -1}, found = {0};
			double3 right = d3_scale(way, d / d3_dot(normal, way));
			for (u32 c = 0; c < 4; c++) {
				found = d3_mad(found, point[c], shares.of[c]);
				assert_true(shares.of[c] >= 0);
				sum += shares.of[c];
			}
			assert_near(sum, 1, 1e-6);
			assert_true(d3_distance(found, right) <= 2e-3 * d3_length(right));
			assert_true(shares.of[1] == 0 || shares.of[2] == 0);
		}
	}
}

/* Light falls off towards corners without light by their share, and no faster or slower: a corner without light has no
 * sharpness of its own. */
static void a_dark_corner_has_no_sharpness(void **state)
{
	(void)state;
	u32 n_lit = 0;
	for (u32 i = 0; i < N; i++) {
		ts_lobes corner[4];
		ts_shares shares = {{uniform(0, 1), uniform(0, 1), uniform(0, 1), uniform(0, 1)}};
		f32 lambda = expf(uniform(-3, 8)), share = 0;
		ts_v3 phi = direction();
		for (u32 k = 0; k < 4; k++) {
			bool lit = below(2) == 0;
			share += lit ? shares.of[k] : 0;
			corner[k].mu[1] = lit ? 5 : 0;
			corner[k].lambda[1] = lit ? lambda : 1;
			ts_store3(corner[k].phi + 3, lit ? phi : ts_v3_make(0, 0, 0));
		}
		ts_sg g = ts_k_lobe_of_lobes(corner, &shares, 1);
		assert_near(g.mu, 5 * share, 1e-5);
		assert_near(g.lambda, share > 0 ? lambda : 1, 1e-6f * lambda);
		n_lit += share > 0;
	}
	assert_true(n_lit > N / 2 && n_lit < N);
}

/* One small light far away: four corners at one place, and a pixel there. Every way to integrate but SG's gives M F. */
static void one_far_light_is_as_direct(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_patch patch = {.pad = 0};
		ts_v3 p = uniform3(-1, 1), way = direction(), n = direction();
		f32 far = uniform(8, 20), cosine = ts_dot(way, n);
		ts_k_patch_corners(&patch, ts_mad(p, way, far), ts_neg(way), uniform(0.001f, 0.01f));
		ts_store3(patch.exitance, ts_v3_make(3, 1, 0));
		ts_gathered sum = {.w = ts_v3_make(0, 0, 0)};
		sum.red = sum.green = sum.blue = sum.w;
		ts_k_gather(&sum, &patch, p, true);
		ts_gpixel pixel;
		f32 direct[3];
		ts_k_gpixel_store(&pixel, p, 0.5f, n, sum.w);
		ts_direct_args whole = {.pixels = &pixel, .patches = &patch, .irradiance = direct, .n_patches = 1};
		ts_k_direct_item(&whole, 0);
		ts_sg g = ts_k_fit(sum.w.x, sum.red, i % 2);
		static const u32 ways[] = {TS_COSINE_OURS, TS_COSINE_CONSTANT, TS_COSINE_QUADRATURE};
		ts_hull_args args = {.cosine = ways[i % 3]};
		f32 e = ts_k_lobe_irradiance(&args, &g, n);
		if (cosine > 0.1f) assert_near(e, direct[0], 0.02 * direct[0]);
		if (cosine < -0.1f) assert_true(direct[0] == 0 && e < 1e-6f);
		assert_true(direct[1] <= direct[0] && direct[2] == 0 && ts_k_fit(sum.w.z, sum.blue, 0).mu == 0);
	}
}

/* Whatever is printed, what is stored is a number from +0 on. */
static void whatever_is_stored_is_a_number(void **state)
{
	(void)state;
	for (u32 i = 0; i < 20000; i++) {
		ts_hull_args args = {.cosine = i % 4, .printed = i / 4 % 2};
		ts_sg g = ts_sg_make(uniform(0, 10), ts_u2f(0x30000000u + below(0x17c35000u)), direction());
		g.lambda = ts_min(g.lambda, 1e5f);
		f32 e = ts_k_lobe_irradiance(&args, &g, i % 5 == 0 ? g.phi : i % 5 == 1 ? ts_neg(g.phi) : direction());
		assert_true(e >= 0 && e < 1e30f && ts_f2u(e) != 0x80000000u);
	}
	ts_hull_args args = {.printed = 1};
	ts_sg even = ts_sg_make(1, 1e-25f, ts_v3_make(0, 0, 1));
	assert_true(ts_k_lobe_irradiance(&args, &even, ts_v3_make(0, 1, 0)) == 0);
	args.printed = 0;
	assert_near(ts_k_lobe_irradiance(&args, &even, ts_v3_make(0, 1, 0)), 1, 1e-5);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(patches_have_their_area_place_and_plane), seeded_test(a_texels_area_is_what_it_sees),
		seeded_test(the_choice_of_boxes_follows_its_reasons), seeded_test(interpolation_is_exact_on_planes),
		seeded_test(a_dark_corner_has_no_sharpness),          seeded_test(one_far_light_is_as_direct),
		seeded_test(whatever_is_stored_is_a_number),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Corners of boxes: the pixels that they are at, their places where those show something else, what they gather there
 * from triangles of light, and the lobes of it. Truths in double precision share no formula with the kernels. */
#include <string.h>
#include "kernels/hulls/corner.h"
#include "kernels/hulls/corner_lobes.h"
#include "kernels/raster/gbuffer.h"
#include "tests/kernels/hulls/form_factor_truth.h"
#include "tests/kernels/hulls/room.h"

enum { N = 3000, GRID = 96, WIDTH = 150, HEIGHT = 70, N_PATCHES = 7, N_WORLDS = 200, PARTS = 4 };

/* The second of two boxes, of all columns of a small grid over images that are larger, smaller and no multiple of it;
 * places are columns and rows of pixels. An image with no more pixels than texels has its own borders at the grid's. */
static void check_pixels(u32 width, u32 height, u32 rectangle)
{
	enum { SIDE = 32, MOST = 100 * 90 };
	static ts_gpixel pixels[MOST];
	const ts_view view = {.focal = 1, .width = width, .height = height, .near = 0.125f};
	for (u32 i = 0; i < width * height; i++) {
		pixels[i] = (ts_gpixel){.position = {(f32)(i % width), (f32)(i / width), 0}, .depth = 0.5f};
	}
	for (u32 pair = 0; pair < SIDE * SIDE; pair++) {
		u32 left = pair % SIDE, right = pair / SIDE, top = below(SIDE), bottom = top + below(SIDE - top);
		if (right < left) continue;
		const ts_segment boxes[2] = {
			{.low = {right, bottom}, .high = {left, top}, .nearest = 0.5f, .farthest = 0.5f},
			{.low = {left, top}, .high = {right, bottom}, .nearest = 0.5f, .farthest = 0.5f},
		};
		ts_moment m[8];
		ts_corner_args args = {.view = &view, .pixels = pixels, .boxes = boxes, .moments = m, .grid = SIDE};
		args.rectangle = rectangle;
		double last = right, lowest = bottom;
		if (rectangle != 0) {
			last = fmin(right + 1, SIDE - 1);
			lowest = fmin(bottom + 1, SIDE - 1);
		}
		for (u32 k = 4; k < 8; k++) {
			ts_k_corner_item(&args, k);
			double column = floor(((k % 2 == 0 ? left : last) + 0.5) * width / SIDE);
			double row = floor(((k < 6 ? top : lowest) + 0.5) * height / SIDE);
			assert_true(m[k].position[0] == (f32)column && m[k].position[1] == (f32)row && m[k].depth == 0.5f);
			if (width <= SIDE && left == 0 && k % 2 == 0) assert_true(m[k].position[0] == 0);
			if (width <= SIDE && right == SIDE - 1 && k % 2 == 1) assert_true(m[k].position[0] == (f32)(width - 1));
		}
	}
}

static void corners_stand_at_their_pixels(void **state)
{
	(void)state;
	static const u32 sizes[][2] = {{1, 1}, {32, 32}, {33, 31}, {7, 90}, {100, 54}};
	for (u32 i = 0; i < sizeof sizes / sizeof *sizes; i++) {
		for (u32 rectangle = 0; rectangle < 2; rectangle++) check_pixels(sizes[i][0], sizes[i][1], rectangle);
	}
}

/* A G-buffer of random depths, and a box in it. */
typedef struct {
	ts_view view;
	ts_gpixel pixels[WIDTH * HEIGHT];
	ts_patch patches[N_PATCHES];
	ts_segment box;
} world;

static void random_view(ts_view *view)
{
	ts_v3 back = direction(), right = ts_normalize(ts_cross(direction(), back));
	*view = (ts_view){.focal = uniform(60, 200), .width = WIDTH, .height = HEIGHT, .near = 0.0625f};
	ts_store3(view->eye, uniform3(-2, 2));
	ts_store3(view->right, right);
	ts_store3(view->up, ts_cross(back, right));
	ts_store3(view->back, back);
}

/* One in four reaches the border of the screen. */
static void random_box(ts_segment *box)
{
	*box = (ts_segment){.nearest = uniform(0.5f, 0.95f)};
	box->farthest = box->nearest + uniform(0, 0.1f) * (1 - box->nearest);
	for (u32 k = 0; k < 2; k++) {
		box->low[k] = below(4) == 0 ? 0 : below(GRID);
		box->high[k] = below(4) == 0 ? GRID - 1 : box->low[k] + below(GRID - box->low[k]);
	}
}

static void random_world(world *w, bool sky)
{
	const ts_v3 zero = ts_v3_make(0, 0, 0);
	random_view(&w->view);
	random_box(&w->box);
	ts_camera_k view = ts_k_view(&w->view);
	for (u32 i = 0; i < WIDTH * HEIGHT; i++) {
		f32 depth = sky || below(9) == 0 ? 1 : below(2) == 0 ? uniform(0.6f, 0.97f) : w->box.nearest;
		ts_v3 p = depth < 1 ? ts_k_pixel_point(&view, i % WIDTH, i / WIDTH, depth) : zero;
		ts_k_gpixel_store(&w->pixels[i], p, depth, depth < 1 ? direction() : zero, zero);
	}
	memset(w->patches, 0, sizeof w->patches); /* the last stays empty */
	for (u32 k = 0; k < N_PATCHES - 1; k++) {
		ts_v3 p = uniform3(-3, 3), n = direction();
		ts_k_patch_corners(&w->patches[k], p, n, uniform(0.01f, 2));
		ts_store3(w->patches[k].exitance, k == 5 ? ts_v3_make(1, 0, 0) : uniform3(0, 2));
	}
}

/* The corner is the pixel's point, or lies on its ray in the middle of the box. Returns whether it was moved there. */
static bool check_place(const world *w, const ts_moment *m, u32 corner)
{
	const ts_segment *box = &w->box;
	u32 x = corner % 2 != 0 ? box->high[0] : box->low[0], y = corner / 2 != 0 ? box->high[1] : box->low[1];
	double column = floor((x + 0.5) * WIDTH / GRID), row = floor((y + 0.5) * HEIGHT / GRID);
	const ts_gpixel *pixel = &w->pixels[(u32)row * WIDTH + (u32)column];
	bool inside = pixel->depth >= box->nearest && pixel->depth <= box->farthest;
	if (inside) {
		assert_memory_equal(m->position, pixel->position, sizeof m->position);
		assert_true(m->depth == pixel->depth);
		return false;
	}
	double3 d = d3_sub(d3_of(ts_load3(m->position)), d3_of(ts_load3(w->view.eye)));
	double z = -d3_dot(d, d3_of(ts_load3(w->view.back)));
	assert_near(m->depth, ((double)box->nearest + (double)box->farthest) / 2, 1e-7);
	assert_near(z, w->view.near / (1 - (double)m->depth), 1e-4 * z);
	assert_near(WIDTH / 2.0 + w->view.focal * d3_dot(d, d3_of(ts_load3(w->view.right))) / z, column + 0.5, 1e-2);
	assert_near(HEIGHT / 2.0 - w->view.focal * d3_dot(d, d3_of(ts_load3(w->view.up))) / z, row + 0.5, 1e-2);
	return true;
}

/* Projected areas, each a third from every vertex, of what faces the corner. */
static void check_light(const ts_patch *patches, u32 n_patches, const ts_moment *m)
{
	double sum[3] = {0}, way[9] = {0};
	double3 p = d3_of(ts_load3(m->position));
	for (u32 k = 0; k < n_patches; k++) {
		const ts_patch *light = &patches[k];
		double3 to[3] = {d3_sub(d3_of(ts_load3(light->a)), p), d3_sub(d3_of(ts_load3(light->b)), p),
		                 d3_sub(d3_of(ts_load3(light->c)), p)};
		double height = -d3_dot(d3_of(ts_load3(light->normal)), to[0]);
		double side = d3_distance(to[0], to[1]), facing = side > 0 ? fmin(4 * height / side - 0.25, 1) : 0;
		if (!(facing > 0)) continue;
		double omega = facing * ff_solid(to[0], to[1], to[2]);
		for (u32 c = 0; c < 3; c++) {
			double share = light->exitance[c] * omega;
			sum[c] += share;
			for (u32 v = 0; v < 3; v++) {
				double3 u = d3_unit(to[v]);
				way[3 * c] += share / 3 * u.x;
				way[3 * c + 1] += share / 3 * u.y;
				way[3 * c + 2] += share / 3 * u.z;
			}
		}
	}
	for (u32 c = 0; c < 3; c++) assert_near(m->sum[c], sum[c], 1e-5 + 1e-5 * sum[c]);
	for (u32 c = 0; c < 9; c++) assert_near(m->direction[c], way[c], 1e-5 + 1e-5 * sum[c / 3]);
}

/* Random worlds, one in four all sky. */
static void corners_gather_what_faces_them(void **state)
{
	(void)state;
	static world w;
	u32 n_lit = 0, n_moved = 0, n_sky = 0;
	for (u32 i = 0; i < N_WORLDS; i++) {
		random_world(&w, i % 4 == 0);
		ts_moment moments[4];
		ts_corner_args args = {.view = &w.view,
		                       .pixels = w.pixels,
		                       .patches = w.patches,
		                       .boxes = &w.box,
		                       .moments = moments,
		                       .n_patches = N_PATCHES,
		                       .grid = GRID};
		for (u32 k = 0; k < 4; k++) {
			ts_k_corner_item(&args, k);
			bool moved = check_place(&w, &moments[k], k);
			check_light(w.patches, N_PATCHES, &moments[k]);
			n_lit += moments[k].sum[1] > 0;
			n_moved += moved;
			n_sky += moved && i % 4 == 0;
		}
	}
	assert_true(n_lit > 600 && n_moved > 300 && n_moved < 700);
	assert_int_equal(n_sky, N_WORLDS / 4 * 4);
}

/* A box holds its least and its greatest depth, and not the next number beyond. */
static void a_box_holds_its_extreme_depths(void **state)
{
	(void)state;
	ts_view view = {.focal = 100, .width = 1, .height = 1, .near = 0.25f, .back = {0, 0, 1}};
	const ts_segment box = {.nearest = 0.5f, .farthest = 0.75f};
	const f32 depths[] = {0.5f, 0.75f, ts_u2f(ts_f2u(0.5f) - 1), ts_u2f(ts_f2u(0.75f) + 1), 1};
	for (u32 i = 0; i < 5; i++) {
		ts_moment m;
		const ts_gpixel pixel = {.position = {7, 8, 9}, .depth = depths[i]};
		ts_corner_args args = {.view = &view, .pixels = &pixel, .boxes = &box, .moments = &m, .grid = 32};
		ts_k_corner_item(&args, 0);
		ts_v3 right = i < 2 ? ts_v3_make(7, 8, 9) : ts_v3_make(0, 0, -0.25f / (1 - 0.625f));
		assert_true(m.depth == (i < 2 ? depths[i] : 0.625f));
		assert_near(d3_distance(d3_of(ts_load3(m.position)), d3_of(right)), 0, 1e-7);
	}
}

/* Boxes of the last depths before the sky, some of which end at the sky: the middle has a point, in the box. */
static void the_deepest_boxes_have_a_point_inside(void **state)
{
	(void)state;
	const ts_view view = {.focal = 100, .width = 1, .height = 1, .near = 0.25f, .back = {0, 0, 1}};
	const ts_gpixel pixel = {.depth = 0.5f};
	for (u32 pair = 0; pair < 16 * 16; pair++) {
		u32 far = pair % 16, near = pair / 16; /* in steps of 2^-24 before the sky */
		if (near == 0 || far > near) continue;
		const ts_segment box = {.nearest = 1 - ldexpf((f32)near, -24), .farthest = 1 - ldexpf((f32)far, -24)};
		ts_moment m;
		ts_corner_args args = {.view = &view, .pixels = &pixel, .boxes = &box, .moments = &m, .grid = 32};
		ts_k_corner_item(&args, 0);
		double steps = ldexp(1 - (double)m.depth, 24);
		assert_true(m.depth < 1 && m.depth >= box.nearest && m.depth <= box.farthest);
		assert_true(fabs(steps - (near + far) / 2.0) <= 0.5);
		assert_true(m.position[2] == (f32)(-0.25 / (1 - (double)m.depth)));
	}
}

static ts_moment gather_by(const ts_patch *patches, u64 n_patches, ts_v3 p, u32 paper)
{
	ts_moment m;
	const ts_corner_args args = {.patches = patches, .n_patches = n_patches, .paper = paper};
	ts_k_gather_all(&m, &args, (ts_box_corner){p, 0.5f});
	return m;
}

static ts_moment gather(const ts_patch *patches, u64 n_patches, ts_v3 p) { return gather_by(patches, n_patches, p, 0); }

/* Heights above the plane in 64ths of a side: none up to 4, then more and more, all from 20 on. By the paper all above
 * 0. */
static void corners_count_what_faces_them_enough(void **state)
{
	(void)state;
	for (i32 step = -64; step <= 64; step++) {
		for (u32 size = 0; size < 8; size++) {
			f32 side = ldexpf(1, (i32)size - 6), height = (f32)step / 64 * side;
			const ts_patch patch = {.b = {side, 0, 0}, .c = {0, side, 0}, .normal = {0, 0, 1}, .exitance = {1, 2, 4}};
			f32 x = side * uniform(-1, 1), y = side * uniform(-1, 1);
			ts_v3 p = ts_v3_make(x, y, height);
			double3 to[3] = {d3_sub((double3){0, 0, 0}, d3_of(p)), d3_sub((double3){side, 0, 0}, d3_of(p)),
			                 d3_sub((double3){0, side, 0}, d3_of(p))};
			double counts = fmin(fmax((step - 4) / 16.0, 0), 1), omega = ff_solid(to[0], to[1], to[2]);
			ts_moment m = gather(&patch, 1, p), paper = gather_by(&patch, 1, p, 1);
			for (u32 c = 0; c < 3; c++) {
				assert_near(m.sum[c], (1 << c) * counts * omega, 4e-6 * (1 << c));
				assert_near(paper.sum[c], (1 << c) * (step > 0 ? omega : 0), 4e-6 * (1 << c));
			}
			assert_true((m.sum[0] > 0) == (step > 4) && (paper.sum[0] > 0) == (step > 0));
		}
	}
}

/* In a room that shines on all sides a corner sees it under 4 pi, and from the middle none of its directions more. */
static void corners_see_all_of_a_lit_room(void **state)
{
	(void)state;
	ts_patch walls[12 * PARTS * PARTS];
	u64 n = sizeof walls / sizeof *walls;
	room_make(walls, PARTS, ts_v3_make(3, 1, 0.25f));
	for (u32 i = 0; i < 200; i++) {
		ts_v3 p = i == 0 ? ts_v3_make(0, 0, 0) : uniform3(-0.84f, 0.84f); /* 5/16 of a side of 1/2 from walls */
		ts_moment m = gather(walls, n, p);
		assert_near(m.sum[0], 12 * ff_pi, 1e-4);
		assert_near(m.sum[1], 4 * ff_pi, 4e-5);
		assert_near(m.sum[2], ff_pi, 1e-5);
		for (u32 k = 0; k < 9 && i == 0; k++) assert_near(m.direction[k], 0, 1e-5);
	}
}

/* Sums are those of what each triangle sends alone, in their order and in no other. */
static void sums_add_in_order_of_the_triangles(void **state)
{
	(void)state;
	u32 n_others = 0;
	for (u32 i = 0; i < N; i++) {
		static const u32 n = 5;
		ts_patch patches[5];
		ts_v3 p = uniform3(-1, 1);
		f32 sum[12] = {0}, back[12] = {0};
		for (u32 k = 0; k < n; k++) {
			ts_v3 way = direction();
			ts_v3 at = ts_mad(p, way, uniform(1, 3));
			ts_k_patch_corners(&patches[k], at, ts_neg(way), uniform(0.01f, 1));
			ts_store3(patches[k].exitance, uniform3(0, 2));
		}
		for (u32 k = 0; k < n; k++) {
			ts_moment next = gather(&patches[k], 1, p), last = gather(&patches[n - 1 - k], 1, p);
			for (u32 c = 0; c < 12; c++) {
				sum[c] = sum[c] + (c < 3 ? next.sum[c] : next.direction[c - 3]);
				back[c] = back[c] + (c < 3 ? last.sum[c] : last.direction[c - 3]);
			}
		}
		ts_moment all = gather(patches, n, p);
		assert_memory_equal(all.sum, sum, sizeof all.sum);
		assert_memory_equal(all.direction, sum + 3, sizeof all.direction);
		n_others += memcmp(sum, back, sizeof sum) != 0;
	}
	assert_true(n_others > N / 2);
}

/* The lobe holds all of the light; by vmf its mean direction is that of the light. Nothing lights with nothing. */
static void the_lobe_holds_all_of_the_light(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		f32 r = i % 3 == 0   ? uniform(0, 1)
		        : i % 3 == 1 ? 1 - uniform(0, 0.001f)
		                     : uniform(0, 0.01f),
			m = uniform(0.01f, 50);
		ts_v3 way = direction();
		ts_sg g = ts_k_fit(m, ts_scale(way, r * m), i % 2);
		double lambda = g.lambda, whole = 2 * ff_pi / lambda * -expm1(-2 * lambda);
		assert_true(g.lambda > 0 && g.lambda <= 100100 && g.mu > 0);
		assert_near(g.mu * whole, m, 3e-6 * m);
		if (r > 1e-5f) assert_near(ts_dot(g.phi, way), 1, 1e-5);
		double mean = 1 / tanh(lambda) - 1 / lambda;
		if (i % 2 != 0 && r > 0.01f) assert_near(mean, ts_min(r, 0.99999f), 1e-5);
		if (i % 2 == 0) assert_near(lambda / (1 + lambda), ts_min(r, 0.99999f), 1e-6);
	}
	for (u32 vmf = 0; vmf < 2; vmf++) {
		ts_sg dark = ts_k_fit(0, ts_v3_make(0, 0, 0), vmf), even = ts_k_fit(2, ts_v3_make(0, 1e-8f, 0), vmf);
		assert_true(dark.mu == 0 && dark.lambda == 1 && ts_length(dark.phi) == 0);
		assert_true(ts_length(even.phi) == 0);
		assert_near(even.mu, 2 / (4 * ff_pi), 1e-6);
	}
}

/* A lobe for each colour, of that one's light alone, for each corner. */
static void each_colour_has_its_own_lobe(void **state)
{
	(void)state;
	enum { CORNERS = 8 };
	ts_moment moments[CORNERS];
	for (u32 i = 0; i < 500; i++) {
		ts_lobes lobes[CORNERS];
		const u32 dark = i % 3, vmf = i / 3 % 2;
		for (u32 k = 0; k < CORNERS; k++) {
			moments[k] = (ts_moment){.depth = 0.5f};
			for (u32 c = 0; c < 3; c++) {
				f32 m = c == dark ? 0 : uniform(0.01f, 50);
				moments[k].sum[c] = m;
				ts_v3 way = direction();
				ts_store3(moments[k].direction + 3 * c, ts_scale(way, uniform(0.01f, 0.99f) * m));
			}
		}
		memset(lobes, 0xff, sizeof lobes);
		ts_corner_lobes_args args = {.moments = moments, .lobes = lobes, .vmf = vmf};
		for (u32 k = CORNERS; k-- > 0;) ts_k_corner_lobes_item(&args, k);
		for (u32 k = 0; k < 3 * CORNERS; k++) {
			u32 c = k % 3;
			const ts_moment *moment = &moments[k / 3];
			const ts_lobes *lobe = &lobes[k / 3];
			double3 way = d3_of(ts_load3(moment->direction + 3 * c)), phi = d3_of(ts_load3(lobe->phi + 3 * c));
			double m = moment->sum[c], lambda = lobe->lambda[c];
			assert_int_equal(lobe->pad, 0);
			if (c == dark) {
				assert_true(lobe->mu[c] == 0 && lobe->lambda[c] == 1 && d3_length(phi) == 0);
				continue;
			}
			double mean = vmf != 0 ? 1 / tanh(lambda) - 1 / lambda : lambda / (1 + lambda);
			assert_near(mean, d3_length(way) / m, 1e-5);
			assert_near(lobe->mu[c] * 2 * ff_pi / lambda * -expm1(-2 * lambda), m, 3e-6 * m);
			assert_near(d3_distance(phi, d3_unit(way)), 0, 1e-6);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(corners_stand_at_their_pixels),        seeded_test(corners_gather_what_faces_them),
		seeded_test(a_box_holds_its_extreme_depths),       seeded_test(the_deepest_boxes_have_a_point_inside),
		seeded_test(corners_count_what_faces_them_enough), seeded_test(corners_see_all_of_a_lit_room),
		seeded_test(sums_add_in_order_of_the_triangles),   seeded_test(the_lobe_holds_all_of_the_light),
		seeded_test(each_colour_has_its_own_lobe),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Scattering: where a point lands, that nothing depends on the order or on storing the points, and the codes of depth
 * and colour against their formulas (METHODS 9 and 10). */
#include "tests/kernels/points/views.h"

enum { N_VIEWS = 70, N_TEXELS = 64 * 64 };
enum { STRIDE = 1000003 }; /* a prime, more than there are points */

/* Points and what they land in. */

static u32 texels[2][N_VIEWS * N_TEXELS];

/* Looking at about the middle of the mesh, or past it. */
static void random_views(ts_offscreen *views, u32 n)
{
	u64 offset = 0;
	for (u32 v = 0; v < n; v++) {
		ts_v3 back = unit3(), eye = uniform3(-2, 2);
		eye = ts_mad(eye, back, uniform(0, 8));
		u32 parallel = random_bits() % 3 == 0, px = 1 + random_bits() % 64;
		f32 reach = parallel != 0 ? uniform(1, 6) : uniform(0.3f, 1.5f), near = uniform_power(-7, 0);
		views[v] = view_from(eye, back, reach, px, near, parallel);
		views[v].offset = offset;
		offset += (u64)views[v].width * views[v].height;
	}
}

/* A point alone, in front of one view. Returns the texel that it was written to, or -1. */
static i64 land(const ts_offscreen *view, ts_v3 p, u32 *depth)
{
	u64 bits[2] = {1, 0}, key = 0;
	i64 tally[3] = {0}, at = -1;
	ts_piece piece = {.path = 1};
	ts_point point = {.length = 1};
	ts_store3(point.centre, p);
	ts_scatter_args args = {.views = view,
	                        .bits = bits,
	                        .depths = texels[0],
	                        .n_points = &tally[0],
	                        .n_scatters = &tally[1],
	                        .n_writes = &tally[2],
	                        .n_views = 1,
	                        .n_words = 2,
	                        .from = {.pieces = &piece, .keys = &key, .points = &point}};
	memset(texels[0], 0xff, sizeof(u32) * N_TEXELS);
	ts_k_scatter_item(&args, 0);
	for (u32 k = 0; k < view->width * view->height; k++) {
		if (texels[0][k] == TS_NONE) continue;
		assert_true(at == -1);
		at = k;
		*depth = texels[0][k];
	}
	assert_true(tally[0] == 1 && tally[1] == 1 && tally[2] == (at >= 0));
	return at;
}

static bool is_near_whole(double x) { return fabs(x - rint(x)) < 1e-4; }

/* One texel, the floor of the projection, with its axial depth; before the near plane and beside the image none. */
static void a_point_lands_in_one_texel(void **state)
{
	(void)state;
	u32 n_landed = 0, n_before = 0, n_beside = 0;
	n_random = 0;
	for (u32 i = 0; i < 20000; i++) {
		ts_offscreen view;
		u32 depth = 0;
		random_views(&view, 1);
		ts_v3 p = uniform3(-4, 4);
		d3_place at = view_place(&view, d3_of(p));
		if (is_near_whole(at.x) || is_near_whole(at.y) || fabs(at.z - view.near) < 1e-5) continue;
		bool in = at.x > 0 && at.y > 0 && at.x < view.width && at.y < view.height;
		i64 expected = at.z > view.near && in ? (i64)floor(at.y) * view.width + (i64)floor(at.x) : -1;
		assert_true(land(&view, p, &depth) == expected);
		if (expected >= 0) assert_true(fabs(ts_u2f(depth) - at.z) <= 1e-5 * (1 + at.z));
		n_landed += expected >= 0;
		n_before += at.z < view.near;
		n_beside += at.z > view.near && !in;
	}
	assert_true(n_landed > 3000 && n_before > 1000 && n_beside > 1000);
}

/* Left and upper borders belong to a texel, right and lower ones to the next; the near plane is in sight. */
static void left_and_upper_borders_belong_to_texels(void **state)
{
	(void)state;
	u32 depth;
	ts_offscreen view = {.right = {1, 0, 0},
	                     .up = {0, 1, 0},
	                     .back = {0, 0, 1},
	                     .width = 4,
	                     .height = 4,
	                     .focal = 2,
	                     .near = 0.5f,
	                     .reach = {1, 1}};
	for (u32 k = 0; k <= 4; k++) {
		f32 x = (f32)k / 2 - 1;
		assert_true(land(&view, ts_v3_make(x, 0.75f, -1), &depth) == (k < 4 ? (i64)k : -1));
		assert_true(land(&view, ts_v3_make(-0.75f, -x, -1), &depth) == (k < 4 ? 4 * (i64)k : -1));
	}
	assert_true(land(&view, ts_v3_make(0.125f, 0.125f, -0.5f), &depth) == 6 && ts_u2f(depth) == 0.5f);
	assert_true(land(&view, ts_v3_make(0, 0, -0.499999970197677612304687f), &depth) == -1);
}

/* Order, storage and the minimum. */

static void random_mesh(mesh *m, ts_offscreen *views, i64 *n_capped)
{
	mesh_begin(m);
	random_views(views, N_VIEWS);
	for (u32 k = 0; k < MESH_TRIANGLES; k++) {
		ts_v3 corner[3];
		random_corners(corner, 4, 0.01f, 1);
		u32 t = mesh_triangle(m, corner[0], corner[1], corner[2], k % 5, 0);
		for (u32 w = 0; w < 2; w++) {
			u64 high = random_bits();
			m->bits[t * 2 + w] = high << 32 | random_bits();
		}
		m->bits[t * 2 + 1] &= (1UL << (N_VIEWS - 64)) - 1;
		for (u32 v = 0; v < 3; v++) {
			for (u32 c = 0; c < 3; c++) m->vertices[t * 3 + v].colour[c] = uniform(0, 1);
		}
	}
	mesh_split(m, views_density(m, views, N_VIEWS, TS_RATE_PAPER, n_capped));
	/* Enough for many to meet, and quick. */
	for (u32 i = 0; i < m->n_pieces; i++) m->scale[i] = ts_min(m->scale[i] * 0.25f, 12);
}

static void clear(u32 *to) { memset(to, 0xff, sizeof texels[0]); }

static void scatter_points(const ts_scatter_args *args, u32 n, u32 order)
{
	for (u32 i = 0; i < n; i++) {
		u32 p = order == 0 ? i : order == 1 ? n - 1 - i : (u32)((u64)i * STRIDE % n);
		ts_k_scatter_item(args, p);
	}
}

static u32 n_filled(const u32 *of)
{
	u32 n = 0;
	for (u32 k = 0; k < N_VIEWS * N_TEXELS; k++) n += of[k] != TS_NONE;
	return n;
}

/* Depths or colours: the same bits and counts from stored points in any order, and from points made on the spot. */
static void stored_points_scatter_as_fresh_ones_do(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < 12; i++) {
		mesh m;
		static ts_offscreen views[N_VIEWS];
		i64 n_capped = 0, tally[2][3] = {{0}};
		ts_points_args how = {.half_size = i % 3 == 0 ? 128 : i % 3 == 1 ? 129 : 0, .snap = i & 1};
		random_mesh(&m, views, &n_capped);
		mesh_make_points(&m, how);
		for (u32 colours = 0; colours < 2; colours++) {
			ts_scatter_args stored = views_scatter(&m, views, N_VIEWS, how, tally[0]);
			ts_scatter_args made = views_scatter(&m, views, N_VIEWS, how, tally[1]);
			memset(tally, 0, sizeof tally);
			*(colours != 0 ? &stored.colours : &stored.depths) = texels[0];
			*(colours != 0 ? &made.colours : &made.depths) = texels[1];
			made.from.points = NULL;
			clear(texels[1]);
			for (u32 p = m.n_pieces; p-- > 0;) ts_k_scatter_pieces_item(&made, p);
			assert_true(n_filled(texels[1]) > 1000 && m.n_points < STRIDE);
			for (u32 order = 0; order < 3; order++) {
				clear(texels[0]);
				memset(tally[0], 0, sizeof tally[0]);
				scatter_points(&stored, m.n_points, order);
				assert_memory_equal(texels[0], texels[1], sizeof texels[0]);
				assert_memory_equal(tally[0], tally[1], sizeof tally[0]);
				assert_true(tally[0][0] == m.n_points && tally[0][2] <= tally[0][1]);
			}
		}
		mesh_clear(&m);
	}
}

/* A batch of views alone gives what they give among all; views without a triangle's bit get nothing of it. */
static void batches_give_what_all_views_give(void **state)
{
	(void)state;
	n_random = 0;
	mesh m;
	static ts_offscreen views[N_VIEWS];
	i64 n_capped = 0, tally[3] = {0};
	random_mesh(&m, views, &n_capped);
	mesh_make_points(&m, (ts_points_args){.half_size = 129, .snap = 1});
	ts_scatter_args args = views_scatter(&m, views, N_VIEWS, (ts_points_args){.half_size = 129, .snap = 1}, tally);
	args.depths = texels[0];
	clear(texels[0]);
	scatter_points(&args, m.n_points, 0);
	for (u32 first = 0; first < N_VIEWS; first += args.n_views) {
		args.n_views = first + 13 < N_VIEWS ? 13 : N_VIEWS - first;
		args.first_view = first;
		args.depths = texels[1] + views[first].offset;
		clear(texels[1]);
		scatter_points(&args, m.n_points, 0);
		const ts_offscreen *last = &views[first + args.n_views - 1];
		u64 n = last->offset + (u64)last->width * last->height - views[first].offset;
		assert_memory_equal(args.depths, texels[0] + views[first].offset, n * sizeof(u32));
	}
	args.first_view = 0;
	args.n_views = N_VIEWS;
	memset(m.bits, 0, sizeof m.bits);
	clear(texels[1]);
	scatter_points(&args, m.n_points, 0);
	assert_int_equal(n_filled(texels[1]), 0);
	mesh_clear(&m);
}

/* A depth map holds the least depth of the points that fall into each texel, found again in double precision. */
static void depth_maps_hold_the_least_depth(void **state)
{
	(void)state;
	n_random = 0;
	mesh m;
	static ts_offscreen views[N_VIEWS];
	static double least[N_VIEWS * N_TEXELS];
	i64 n_capped = 0, tally[3] = {0};
	u32 n_wrong = 0, n_seen = 0;
	random_mesh(&m, views, &n_capped);
	mesh_make_points(&m, (ts_points_args){.half_size = 129, .snap = 1});
	ts_scatter_args args = views_scatter(&m, views, N_VIEWS, (ts_points_args){.half_size = 129, .snap = 1}, tally);
	args.depths = texels[0];
	clear(texels[0]);
	scatter_points(&args, m.n_points, 0);
	for (u32 k = 0; k < N_VIEWS * N_TEXELS; k++) least[k] = INFINITY;
	for (u64 k = 0; k < (u64)m.n_points * N_VIEWS; k++) {
		const ts_offscreen *view = &views[k % N_VIEWS];
		const ts_point *point = &m.points[k / N_VIEWS];
		if (!ts_k_offscreen_bit(m.bits + m.pieces[point->piece].triangle * 2, (u32)(k % N_VIEWS))) continue;
		d3_place at = view_place(view, d3_load(point->centre));
		if (at.z < view->near || at.x < 0 || at.y < 0 || at.x >= view->width || at.y >= view->height) continue;
		double *texel = &least[view->offset + (u64)at.y * view->width + (u64)at.x];
		*texel = fmin(*texel, at.z);
	}
	for (u32 k = 0; k < N_VIEWS * N_TEXELS; k++) {
		bool empty = texels[0][k] == TS_NONE;
		n_seen += !empty;
		n_wrong +=
			empty != isinf(least[k]) || (!empty && fabs(ts_u2f(texels[0][k]) - least[k]) > 1e-5 * (1 + least[k]));
	}
	assert_true(n_seen > 1000 && n_wrong <= n_seen / 1000); /* points on the border of two texels */
	mesh_clear(&m);
}

/* Codes. */

/* near 2^(20 q / 8191): where code q begins. */
static double code_begins(double near, double q) { return near * exp2(20 * q / 8191); }

/* Every code's range is that of the formula, 0.17 per cent wide, but for the rounding of the logarithm. */
static void depth_codes_have_the_formulas_ranges(void **state)
{
	(void)state;
	n_random = 0;
	f32 nears[] = {1, 0.0078125f, 0.3f, 100};
	for (u32 n = 0; n < 4; n++) {
		f32 near = nears[n];
		assert_int_equal(ts_k_depth_code(near, near), 0);
		assert_int_equal(ts_k_depth_code(near * 0.5f, near), 0);
		assert_int_equal(ts_k_depth_code(0, near), 0);
		assert_int_equal(ts_k_depth_code(near * 1048576.0f, near), 8190);
		assert_int_equal(ts_k_depth_code(near * 4294967296.0f, near), 8190);
		for (u32 i = 0; i < 50000; i++) {
			f32 d = near * uniform_power(0, 20);
			u32 q = ts_k_depth_code(d, near);
			assert_true(q <= 8190);
			assert_true(d >= code_begins(near, q) * (1 - 2e-6));
			if (q < 8190) assert_true(d < code_begins(near, q + 1) * (1 + 2e-6));
		}
	}
}

/* Never falling from one float to the next, about every step. */
static void depth_codes_rise_with_depth(void **state)
{
	(void)state;
	for (u32 q = 1; q <= 8190; q++) {
		u32 middle = ts_f2u((f32)code_begins(1, q)), before = 0;
		for (u32 u = middle - 24; u <= middle + 24; u++) {
			u32 code = ts_k_depth_code(ts_u2f(u), 1);
			assert_true(code >= before && (code == q || code == q - 1));
			before = code;
		}
		assert_int_equal(before, q);
	}
}

/* There and back: half a step of the square root, 6-7-6; white and more is white, and the code is never that of
 * empty. */
static void colour_codes_read_back_within_half_steps(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 i = 0; i < 50000; i++) {
		f32 exposure = uniform_power(-4, 4);
		ts_v3 c = ts_scale(uniform3(0, i % 2 == 0 ? 1 : 0.01f), 1.25f / exposure);
		u32 code = ts_k_colour_code(c, exposure);
		ts_v3 back = ts_k_colour_radiance(code, exposure);
		assert_true(code < 1u << 19 && (8190u << 19 | code) < TS_NONE);
		const double from[3] = {c.x, c.y, c.z}, to[3] = {back.x, back.y, back.z}, most[3] = {63, 127, 63};
		for (u32 k = 0; k < 3; k++) {
			double was = sqrt(fmin(from[k] * exposure, 1)), is = sqrt(to[k] * exposure);
			assert_true(fabs(was - is) <= 0.5 / most[k] + 1e-6);
		}
		assert_int_equal(ts_k_colour_code(back, exposure), code);
	}
	assert_int_equal(ts_k_colour_code(ts_v3_make(0, 0, 0), 1), 0);
	assert_int_equal(ts_k_colour_code(ts_v3_make(1, 1, 1), 1), (1u << 19) - 1);
	assert_int_equal(ts_k_colour_code(ts_v3_make(1e30f, 2, 1e9f), 1024), (1u << 19) - 1);
	assert_int_equal(ts_k_colour_code(ts_v3_make(-1, -2, -3), 1), 0);
	assert_int_equal(ts_k_colour_code(ts_v3_make(1, 0, 0), 1), 63u << 13);
	assert_int_equal(ts_k_colour_code(ts_v3_make(0, 1, 0), 1), 127u << 6);
	assert_int_equal(ts_k_colour_code(ts_v3_make(0, 0, 1), 1), 63);
}

/* Of two triangles the nearer one's colour stays, whatever it is: depth counts before colour. */
static void the_nearer_colour_stays(void **state)
{
	(void)state;
	for (u32 order = 0; order < 2; order++) {
		mesh m;
		mesh_begin(&m);
		for (u32 k = 0; k < 2; k++) {
			f32 z = k == 0 ? -2 : -3;
			u32 t = mesh_triangle(&m, ts_v3_make(-9, -9, z), ts_v3_make(9, -9, z), ts_v3_make(0, 9, z), 1, 0);
			m.bits[t * 2] = 1;
			for (u32 v = 0; v < 3; v++) m.vertices[t * 3 + v].colour[0] = k == 0 ? 1 : 0;
		}
		ts_offscreen view = {.right = {1, 0, 0},
		                     .up = {0, 1, 0},
		                     .back = {0, 0, 1},
		                     .width = 16,
		                     .height = 16,
		                     .focal = 8,
		                     .near = 0.5f,
		                     .reach = {1, 1},
		                     .object = TS_NONE};
		i64 n_capped = 0, tally[3] = {0};
		mesh_split(&m, views_density(&m, &view, 1, TS_RATE_WATERTIGHT, &n_capped));
		mesh_align(&m);
		ts_scatter_args args = views_scatter(&m, &view, 1, (ts_points_args){.half_size = 129, .snap = 1}, tally);
		args.colours = texels[0];
		clear(texels[0]);
		for (u32 i = 0; i < m.n_pieces; i++) ts_k_scatter_pieces_item(&args, order == 0 ? i : m.n_pieces - 1 - i);
		for (u32 k = 0; k < 256; k++) {
			ts_v3 colour = ts_k_colour_radiance(texels[0][k] & 0x7ffffu, 1);
			assert_true(texels[0][k] != TS_NONE && colour.x > 0.9f);
			assert_true(code_begins(0.5, texels[0][k] >> 19) < 3.5);
		}
		mesh_clear(&m);
	}
}

/* How many points. */

/* With the centroid on a sample a triangle much smaller than a texel makes one point (FIGURES 1). */
static void a_tiny_triangle_makes_one_point(void **state)
{
	(void)state;
	n_random = 0;
	i64 points = 0;
	for (u32 i = 0; i < 200; i++) {
		mesh m;
		i64 n_capped = 0;
		mesh_begin(&m);
		ts_offscreen view = view_from(ts_v3_make(0, 0, 0), ts_v3_make(0, 0, 1), 1, 64, 0.0078125f, 0);
		for (u32 k = 0; k < MESH_TRIANGLES; k++) {
			ts_v3 middle = ts_v3_make(uniform(-2, 2), uniform(-2, 2), uniform(-8, -3)), corner[3];
			for (u32 c = 0; c < 3; c++) corner[c] = ts_mad(middle, uniform3(-1, 1), 0.0005f * -middle.z);
			mesh_triangle(&m, corner[0], corner[1], corner[2], 1, 0);
			m.bits[k * 2] = 1;
		}
		mesh_split(&m, views_density(&m, &view, 1, TS_RATE_WATERTIGHT, &n_capped));
		mesh_points(&m, 129, 0);
		assert_int_equal(m.n_pieces, MESH_TRIANGLES);
		points += m.n_points;
		mesh_clear(&m);
	}
	assert_true(points >= 200 * MESH_TRIANGLES && (double)points <= 1.001 * 200 * MESH_TRIANGLES);
}

/* Without conservative sampling the centroid is still a sample: no piece is without a point. */
static void no_piece_is_without_a_point(void **state)
{
	(void)state;
	n_random = 0;
	u32 n_pieces = 0, n_without = 0;
	for (u32 i = 0; i < 400; i++) {
		mesh m;
		mesh_begin(&m);
		for (u32 k = 0; k < MESH_TRIANGLES; k++) {
			ts_v3 corner[3];
			random_corners(corner, 4, 0.001f, 4);
			if (is_degenerate(corner)) continue;
			mesh_triangle(&m, corner[0], corner[1], corner[2], 1, 0);
		}
		mesh_whole(&m, uniform_power(-3, 3));
		mesh_points(&m, 0, 0);
		for (u32 p = 0; p < m.n_pieces; p++) n_without += m.count[p + 1] == m.count[p];
		n_pieces += m.n_pieces;
		mesh_clear(&m);
	}
	assert_true(n_pieces > 10000 && n_without == 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_point_lands_in_one_texel),
		cmocka_unit_test(left_and_upper_borders_belong_to_texels),
		cmocka_unit_test(stored_points_scatter_as_fresh_ones_do),
		cmocka_unit_test(batches_give_what_all_views_give),
		cmocka_unit_test(depth_maps_hold_the_least_depth),
		cmocka_unit_test(depth_codes_have_the_formulas_ranges),
		cmocka_unit_test(depth_codes_rise_with_depth),
		cmocka_unit_test(colour_codes_read_back_within_half_steps),
		cmocka_unit_test(the_nearer_colour_stays),
		cmocka_unit_test(a_tiny_triangle_makes_one_point),
		cmocka_unit_test(no_piece_is_without_a_point),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Shadows from depth maps: the bias is the depth that its formula says, a plane does not shadow itself, what is behind
 * another is in its shadow, and where a map says nothing there is light (METHODS 10). */
#include "kernels/raster/depth_map.h"
#include "kernels/raster/eye.h"
#include "kernels/raster/shadow_test.h"
#include "tests/kernels/points/views.h"

enum { N = 4000, SIZE = 64, EYE = 48 };

static u32 depths[24 * SIZE * SIZE];

static ts_offscreen random_view(u32 orthographic)
{
	ts_v3 eye = uniform3(-1, 1), back = unit3();
	return view_from(eye, back, orthographic != 0 ? 2 : uniform(0.3f, 1), SIZE, 0.0078125f, orthographic);
}

/* A plane in sight: a point of it, and its normal. */
static ts_receiver random_plane(const ts_offscreen *view)
{
	f32 z = uniform(0.5f, 8), wide = 0.9f * view->reach[0] * (view->orthographic != 0 ? 1 : z);
	ts_receiver r = {.n = unit3(), .seen = true};
	r.p = ts_mad(ts_load3(view->eye), ts_load3(view->back), -z);
	r.p = ts_mad(r.p, ts_load3(view->right), uniform(-wide, wide));
	r.p = ts_mad(r.p, ts_load3(view->up), uniform(-wide, wide));
	return r;
}

/* |cos| of the normal to the way that the view's ray goes there. */
static double facing(const ts_offscreen *view, const ts_receiver *at)
{
	d3 way = d3_unit(d3_sub(d3_load(view->eye), d3_of(at->p)));
	return fabs(d3_dot(d3_of(at->n), view->orthographic != 0 ? d3_load(view->back) : way));
}

/* Axial depth of the plane at a place of the image. */
static double plane_depth(const ts_offscreen *view, const ts_receiver *at, double x, double y)
{
	d3_ray ray = view_ray(view, x, y);
	d3 n = d3_of(at->n);
	return d3_dot(n, d3_sub(d3_of(at->p), ray.from)) / d3_dot(n, ray.way);
}

/* Texels of width and of slope: z / f, or 1 / f; and the difference of the plane's depth from texel to texel. */
static void the_bias_follows_its_formula(void **state)
{
	(void)state;
	n_random = 0;
	u32 n_steep = 0;
	for (u32 i = 0; i < N; i++) {
		ts_offscreen view = random_view(i & 1);
		ts_camera_k camera = ts_k_offscreen(&view);
		ts_receiver at = random_plane(&view);
		d3_place place = view_place(&view, d3_of(at.p));
		ts_shadow_test_args width = {.bias = 1}, slope = {.slope = 1}, both = {.bias = 3, .slope = 2};
		double w = ts_k_shadow_bias(&width, &camera, &at, (f32)place.z);
		double s = ts_k_shadow_bias(&slope, &camera, &at, (f32)place.z);
		double sum = ts_k_shadow_bias(&both, &camera, &at, (f32)place.z);
		assert_true(fabs(w - (view.orthographic != 0 ? 1 : place.z) / view.focal) <= 1e-5 * w);
		assert_true(fabs(sum - 3 * w - 2 * s) <= 1e-5 * sum);
		if (facing(&view, &at) < 0.02) continue;
		double step = 1e-4;
		double x = plane_depth(&view, &at, place.x + step, place.y) - plane_depth(&view, &at, place.x - step, place.y);
		double y = plane_depth(&view, &at, place.x, place.y + step) - plane_depth(&view, &at, place.x, place.y - step);
		double expected = hypot(x, y) / (2 * step);
		assert_true(fabs(s - expected) <= 2e-3 * expected + 1e-6);
		n_steep += s > 2 * w;
	}
	assert_true(n_steep > N / 10);
}

static ts_shadow_test_args arguments(f32 bias, f32 slope)
{
	return (ts_shadow_test_args){.depths = depths, .bias = bias, .slope = slope};
}

/* The plane as MVR draws it into the view's depth map. */
static void draw_plane(const ts_offscreen *view, const ts_receiver *at)
{
	mesh m;
	mesh_begin(&m);
	ts_v3 aside = ts_normalize(ts_cross(at->n, unit3())), across = ts_cross(at->n, aside);
	ts_v3 a = ts_mad(at->p, aside, 64), b = ts_mad(at->p, aside, -32);
	mesh_triangle(&m, a, ts_mad(b, across, 64), ts_mad(b, across, -64), 1, 0);
	ts_depth_map_args args = {.scene = mesh_arrays(&m), .views = view, .depths = depths, .n_views = 1};
	memset(depths, 0xff, sizeof(u32) * SIZE * SIZE);
	ts_k_depth_map_item(&args, 0);
}

/* With the default bias no point of a plane is in its own shadow, up to the slope where the bias ends; without bias
 * about half of them are; what is far enough behind is, with the bias. */
static void no_plane_shadows_itself(void **state)
{
	(void)state;
	n_random = 0;
	u32 n_points = 0, n_without = 0, n_behind = 0;
	for (u32 i = 0; i < N / 4; i++) {
		ts_offscreen view = random_view(i % 4 == 0);
		ts_receiver plane = random_plane(&view);
		ts_camera_k camera = ts_k_offscreen(&view);
		ts_shadow_test_args with = arguments(1, 1.5f), without = arguments(0, 0);
		draw_plane(&view, &plane);
		for (u32 k = 0; k < 40; k++) {
			double x = uniform(0, SIZE), y = uniform(0, SIZE), z = plane_depth(&view, &plane, x, y);
			d3_ray ray = view_ray(&view, x, y);
			d3 p = d3_mad(ray.from, ray.way, z), behind = d3_mad(ray.from, ray.way, z + 0.5);
			ts_receiver at = {.p = {(f32)p.x, (f32)p.y, (f32)p.z}, .n = plane.n, .seen = true};
			if (!(z > 2 * (double)view.near && z < 24) || facing(&view, &at) < 0.016) continue;
			n_points++;
			assert_true(ts_k_reaches(&with, &view, &at, 0));
			n_without += !ts_k_reaches(&without, &view, &at, 0);
			double bias = ts_k_shadow_bias(&with, &camera, &at, (f32)z);
			at.p = ts_v3_make((f32)behind.x, (f32)behind.y, (f32)behind.z);
			if (bias > 0.05 || depths[(u32)y * SIZE + (u32)x] == TS_NONE) continue;
			n_behind++;
			assert_false(ts_k_reaches(&with, &view, &at, 0));
		}
	}
	assert_true(n_points > 4 * N && n_behind > N / 4);
	assert_true(n_without > n_points / 4 && n_without < n_points * 3 / 4);
}

/* Before the near plane, beside the map and in an empty texel; with cubes the map has no beside. */
static void unknown_places_of_the_map_are_lit(void **state)
{
	(void)state;
	ts_offscreen view = {.right = {1, 0, 0},
	                     .up = {0, 1, 0},
	                     .back = {0, 0, 1},
	                     .width = 4,
	                     .height = 4,
	                     .focal = 2,
	                     .near = 0.5f,
	                     .reach = {1, 1}};
	ts_shadow_test_args args = arguments(1, 1), cubes = args;
	cubes.cubes = 1;
	ts_receiver in = {.p = {0.25f, 0.25f, -4}, .n = {0, 0, 1}}, before = in, beside = in;
	before.p.z = -0.25f;
	beside.p.x = 4.5f;
	for (u32 k = 0; k < 16; k++) depths[k] = ts_f2u(1);
	assert_false(ts_k_reaches(&args, &view, &in, 0));
	assert_true(ts_k_reaches(&args, &view, &before, 0));
	assert_true(ts_k_reaches(&args, &view, &beside, 0));
	assert_false(ts_k_reaches(&cubes, &view, &beside, 0));
	depths[1 * 4 + 2] = TS_NONE;
	assert_true(ts_k_reaches(&args, &view, &in, 0));
	assert_false(ts_k_reaches(&cubes, &view, &beside, 0));
	depths[1 * 4 + 3] = TS_NONE;
	assert_true(ts_k_reaches(&cubes, &view, &beside, 0));
	view.offset = 1000;
	depths[6 + 20] = ts_f2u(5);
	assert_true(ts_k_reaches(&args, &view, &in, 980));
	depths[6 + 20] = ts_f2u(1.5f);
	assert_false(ts_k_reaches(&args, &view, &in, 980));
}

/* A floor and a wall as an eye sees them, some of it nothing. */
static u32 look(mesh *m, u64 keys[EYE * EYE])
{
	mesh_begin(m);
	m->view = (ts_view){.focal = EYE / 2,
	                    .right = {1, 0, 0},
	                    .width = EYE,
	                    .up = {0, 1, 0},
	                    .height = EYE,
	                    .back = {0, 0, 1},
	                    .near = 0.0078125f};
	mesh_triangle(m, ts_v3_make(-9, -1, 0), ts_v3_make(9, -1, 0), ts_v3_make(0, -1, -20), 1, 0);
	mesh_triangle(m, ts_v3_make(-3, -2, -5), ts_v3_make(3, -2, -5), ts_v3_make(0, 3, -5), 1, 0);
	ts_eye_args eye = {.scene = mesh_arrays(m), .view = &m->view, .texels = keys};
	u32 n = 0;
	memset(keys, 0xff, EYE * EYE * sizeof *keys);
	for (u32 t = 0; t < m->n_triangles; t++) ts_k_eye_item(&eye, t);
	for (u32 k = 0; k < EYE * EYE; k++) n += keys[k] != TS_EMPTY;
	return n;
}

static void cube_views(ts_offscreen views[6], ts_v3 centre, u64 offset, u32 light)
{
	ts_face cube = {.n = SIZE, .near = 0.0078125f};
	ts_store3(cube.centre, centre);
	for (u32 face = 0; face < 6; face++) {
		ts_camera_k camera = ts_k_cube_view(&cube, face);
		views[face] = (ts_offscreen){.focal = camera.focal,
		                             .near = camera.near,
		                             .width = SIZE,
		                             .height = SIZE,
		                             .reach = {1, 1},
		                             .offset = offset + face * SIZE * SIZE,
		                             .light = light};
		ts_store3(views[face].eye, camera.eye);
		ts_store3(views[face].right, camera.right);
		ts_store3(views[face].up, camera.up);
		ts_store3(views[face].back, camera.back);
	}
}

/* Of a cube one face counts: darkening the faces one by one takes each pixel's light just once a cube. */
static void one_face_of_a_cube_counts(void **state)
{
	(void)state;
	n_random = 0;
	mesh m;
	static u64 keys[EYE * EYE];
	static u32 lit[EYE * EYE], sum[EYE * EYE];
	ts_offscreen views[18];
	u32 n_seen = look(&m, keys);
	for (u32 c = 0; c < 3; c++) cube_views(views + 6 * c, uniform3(-1, 1), 777 + c * 6 * SIZE * SIZE, 0);
	ts_shadow_test_args args = {.scene = mesh_arrays(&m),
	                            .view = &m.view,
	                            .depth_triangle = keys,
	                            .views = views,
	                            .depths = depths,
	                            .lit = lit,
	                            .first_view = 6,
	                            .n_views = 12,
	                            .n_lamps = 1,
	                            .cubes = 1};
	for (u32 face = 0; face <= 6; face++) {
		memset(depths, 0xff, sizeof depths);
		memset(lit, 0, sizeof lit);
		for (u32 c = 0; c < 2 && face < 6; c++) {
			for (u32 k = 0; k < SIZE * SIZE; k++) depths[(6 * c + face) * SIZE * SIZE + k] = ts_f2u(0.0078125f);
		}
		for (u32 k = 0; k < EYE * EYE; k++) {
			ts_k_shadow_test_item(&args, k);
			if (face == 6) assert_int_equal(lit[k], keys[k] != TS_EMPTY ? 2 : 0);
			if (face < 6 && keys[k] != TS_EMPTY) sum[k] += 2 - lit[k];
		}
	}
	for (u32 k = 0; k < EYE * EYE; k++) assert_int_equal(sum[k], keys[k] != TS_EMPTY ? 2 : 0);
	assert_true(n_seen > EYE * EYE / 4 && n_seen < EYE * EYE);
}

/* Every view adds to its own light's count; batches add up to the whole. */
static void each_view_counts_for_its_own_light(void **state)
{
	(void)state;
	n_random = 0;
	mesh m;
	static u64 keys[EYE * EYE];
	static u32 whole[EYE * EYE * 3], parts[EYE * EYE * 3];
	ts_offscreen views[24];
	look(&m, keys);
	for (u32 v = 0; v < 24; v++) {
		views[v] = view_from(uniform3(-1, 1), unit3(), uniform(0.5f, 2), SIZE, 0.0078125f, v & 1);
		views[v].offset = v * SIZE * SIZE;
		views[v].light = v % 3;
	}
	for (u32 k = 0; k < 24 * SIZE * SIZE; k++) depths[k] = random_bits() % 4 == 0 ? TS_NONE : ts_f2u(uniform(0.01f, 8));
	ts_shadow_test_args args = {.scene = mesh_arrays(&m),
	                            .view = &m.view,
	                            .depth_triangle = keys,
	                            .views = views,
	                            .depths = depths,
	                            .lit = whole,
	                            .n_views = 24,
	                            .n_lamps = 3,
	                            .bias = 1,
	                            .slope = 1.5f};
	for (u32 k = 0; k < EYE * EYE; k++) ts_k_shadow_test_item(&args, k);
	args.lit = parts;
	for (args.first_view = 0; args.first_view < 24; args.first_view += args.n_views) {
		args.n_views = args.first_view < 20 ? 5 : 4;
		args.depths = depths + views[args.first_view].offset;
		for (u32 k = 0; k < EYE * EYE; k++) ts_k_shadow_test_item(&args, k);
	}
	assert_memory_equal(whole, parts, sizeof whole);
	u64 sum = 0;
	for (u32 k = 0; k < EYE * EYE * 3; k++) {
		assert_true(whole[k] <= (keys[k / 3] != TS_EMPTY ? 8u : 0u));
		sum += whole[k];
	}
	assert_true(sum > EYE * EYE);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(the_bias_follows_its_formula),       cmocka_unit_test(no_plane_shadows_itself),
		cmocka_unit_test(unknown_places_of_the_map_are_lit),  cmocka_unit_test(one_face_of_a_cube_counts),
		cmocka_unit_test(each_view_counts_for_its_own_light),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Depth maps against rays in double precision: orthographic and perspective views, what a view leaves out, masks and
 * their footprints; a batch, and nothing beside it; the same in every order. */
#include "kernels/raster/depth_map.h"
#include "tests/kernels/raster/sight.h"

enum { SIZE = 32, N_TEXELS = SIZE * SIZE * 3 / 4, N_VIEWS = 6, FIRST = 1, N_BATCH = 4, N_SOUPS = 24, N_TRIANGLES = 24 };

static small_scene scene;
static ts_offscreen views[N_VIEWS];
static u32 depths[N_BATCH * N_TEXELS];

/* Views that leave out object 0, object 1 or nothing, and one without size. */
static void make_views(u32 without_size)
{
	u64 offset = 1000;
	for (u32 v = 0; v < N_VIEWS; v++) {
		views[v] = random_view(SIZE, below(2));
		views[v].object = v % 3 < 2 ? v % 3 : TS_NONE;
		views[v].width = v == without_size ? 0 : views[v].width;
		views[v].offset = offset;
		offset += views[v].width * views[v].height;
	}
}

static ts_depth_map_args batch(void)
{
	return (ts_depth_map_args){
		.scene = small_arrays(&scene), .views = views, .depths = depths, .first_view = FIRST, .n_views = N_BATCH};
}

static void check_view(const ts_offscreen *view, u32 n_decided[2], u32 n_seen[2])
{
	ts_camera_k camera = ts_k_offscreen(view);
	const u32 *drawn = depths + (view->offset - views[FIRST].offset);
	for (u32 i = 0; i < view->width * view->height; i++) {
		sight s;
		if (!is_decided(&scene, &camera, view->object, i, &s)) continue;
		n_decided[view->orthographic]++;
		n_seen[view->orthographic] += s.at.triangle != TS_NONE;
		assert_true((drawn[i] == TS_NONE) == (s.at.triangle == TS_NONE));
		if (drawn[i] != TS_NONE) assert_depth(ts_u2f(drawn[i]), &s);
	}
}

static void depth_maps_hold_what_rays_meet(void **state)
{
	(void)state;
	u32 n_texels[2] = {0}, n_decided[2] = {0}, n_seen[2] = {0};
	for (u32 n = 0; n < N_SOUPS; n++) {
		small_soup(&scene, N_TRIANGLES);
		make_views(n % N_VIEWS);
		memset(depths, 0xff, sizeof depths);
		ts_depth_map_args args = batch();
		for (u32 t = 0; t < N_TRIANGLES; t++) ts_k_depth_map_item(&args, t);
		for (u32 v = FIRST; v < FIRST + N_BATCH; v++) {
			check_view(&views[v], n_decided, n_seen);
			n_texels[views[v].orthographic] += views[v].width * views[v].height;
		}
		u64 end = views[FIRST + N_BATCH].offset - views[FIRST].offset;
		for (u64 i = end; i < N_BATCH * N_TEXELS; i++) assert_true(depths[i] == TS_NONE);
	}
	for (u32 k = 0; k < 2; k++) assert_true(n_decided[k] > n_texels[k] * 8 / 10 && n_seen[k] > n_decided[k] / 4);
}

static void depth_maps_ignore_the_order(void **state)
{
	(void)state;
	static u32 forward[N_BATCH * N_TEXELS];
	for (u32 n = 0; n < N_SOUPS; n++) {
		small_soup(&scene, N_TRIANGLES);
		make_views(TS_NONE);
		ts_depth_map_args args = batch();
		memset(depths, 0xff, sizeof depths);
		for (u32 t = 0; t < N_TRIANGLES; t++) ts_k_depth_map_item(&args, t);
		memcpy(forward, depths, sizeof forward);
		memset(depths, 0xff, sizeof depths);
		for (u32 t = N_TRIANGLES; t-- > 0;) ts_k_depth_map_item(&args, t);
		assert_memory_equal(depths, forward, sizeof forward);
	}
}

/* The footprint by which masks are read: its square is what a pixel would see of the plane if it faced its ray. */
static void masks_are_read_at_pixel_width(void **state)
{
	(void)state;
	u32 n_seen = 0;
	for (u32 n = 0; n < 40 * N_SOUPS; n++) {
		views[0] = random_view(SIZE, n & 1);
		small_soup(&scene, 1);
		scene.triangles[0].material = 1;
		ts_arrays arrays = small_arrays(&scene);
		ts_camera_k view = ts_k_offscreen(&views[0]);
		ts_corners corners = ts_k_corners(&arrays, 0);
		u32 i = below(N_TEXELS);
		sight s;
		if (!is_decided(&scene, &view, TS_NONE, i, &s) || s.at.triangle == TS_NONE) continue;
		sight_ray ray = ray_through(&view, i % SIZE + 0.5, i / SIZE + 0.5);
		double low[2] = {i % SIZE + 0.4375, i / SIZE + 0.4375}, high[2] = {i % SIZE + 0.5625, i / SIZE + 0.5625};
		double3 normal = d3_unit(normal_of(&scene, 0));
		double area = 64 * seen_area(&view, low, high, s.at.p, normal) * d3_length(ray.way);
		ts_fragment f = ts_k_fragment_at(&view, &corners, (i32)(i % SIZE), (i32)(i / SIZE));
		double footprint = ts_k_fragment_footprint(&view, &corners, &f);
		if (fabs(d3_dot(normal, d3_unit(ray.way))) < 0.2) continue;
		n_seen++;
		assert_near(footprint * footprint, area, 0.01 * area);
	}
	assert_true(n_seen > 2 * N_SOUPS);
}

/* Neither a batch without views nor a triangle without area draws. */
static void no_views_and_no_area_draw_nothing(void **state)
{
	(void)state;
	ts_v3 a = ts_v3_make(-2, 0, 0), b = ts_v3_make(2, 0, 0);
	small_clear(&scene);
	scene.materials[0].flags = TS_DOUBLE_SIDED;
	small_add(&scene, a, b, ts_v3_make(0, 2, 0), 0, 2);
	small_add(&scene, a, b, b, 0, 2);
	make_views(TS_NONE);
	memset(depths, 0xff, sizeof depths);
	ts_depth_map_args args = batch();
	ts_k_depth_map_item(&args, 1);
	args.views = NULL;
	args.n_views = 0;
	ts_k_depth_map_item(&args, 0);
	for (u32 i = 0; i < N_BATCH * N_TEXELS; i++) assert_true(depths[i] == TS_NONE);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(depth_maps_hold_what_rays_meet),
		seeded_test(depth_maps_ignore_the_order),
		seeded_test(masks_are_read_at_pixel_width),
		seeded_test(no_views_and_no_area_draw_nothing),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

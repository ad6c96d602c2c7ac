/* The eye's view against a ray caster in double precision: meshes without gaps or overlaps, a floor through the near
 * plane, ties, order, sides, masks. */
#include "kernels/raster/eye.h"
#include "tests/kernels/raster/sight.h"

enum { WIDTH = 64, HEIGHT = 48, N_PIXELS = WIDTH * HEIGHT };

static const ts_view eye = {
	.focal = 64,
	.right = {1, 0, 0},
	.width = WIDTH,
	.up = {0, 1, 0},
	.height = HEIGHT,
	.back = {0, 0, 1},
	.near = 0.25f,
};

static small_scene scene;
static u64 texels[N_PIXELS];

static void clear(u64 *buffer, u32 n)
{
	for (u32 i = 0; i < n; i++) buffer[i] = TS_EMPTY;
}

static void draw_all(void)
{
	ts_eye_args args = {.scene = small_arrays(&scene), .view = &eye, .texels = texels};
	clear(texels, N_PIXELS);
	for (u32 t = 0; t < scene.n_triangles; t++) ts_k_eye_item(&args, t);
}

static f32 depth(u64 key) { return ts_u2f((u32)(key >> 32)); }

/* The point at depth z that is seen at (x, y) of the image. */
static ts_v3 behind_pixel(f32 x, f32 y, f32 z)
{
	return ts_v3_make((x - WIDTH / 2) * z / 64, (HEIGHT / 2 - y) * z / 64, -z);
}

enum { CELLS = 8 };

/* A bent mesh over the whole image and beyond; exact: flat, with corners on half-pixels. */
static void make_mesh(bool exact)
{
	ts_v3 v[CELLS + 1][CELLS + 1];
	for (u32 i = 0; i <= CELLS; i++) {
		for (u32 j = 0; j <= CELLS; j++) {
			f32 x = (f32)i * 10 - 8 + uniform(-3, 3), y = (f32)j * 8 - 8 + uniform(-2.5f, 2.5f);
			v[i][j] = exact ? behind_pixel(floorf(2 * x) / 2, floorf(2 * y) / 2, 1) : behind_pixel(x, y, uniform(1, 3));
		}
	}
	small_clear(&scene);
	for (u32 k = 0; k < CELLS * CELLS; k++) {
		u32 i = k / CELLS, j = k % CELLS;
		ts_v3 a = v[i][j], b = v[i + 1][j], c = v[i + 1][j + 1], d = v[i][j + 1];
		if (bits() & 1) {
			small_add(&scene, a, b, c, 0, 0);
			small_add(&scene, c, a, d, 0, 0);
		} else {
			small_add(&scene, d, b, c, 0, 0);
			small_add(&scene, d, a, b, 0, 0);
		}
	}
}

static void meshes_have_no_gaps_and_no_overlaps(void **state)
{
	(void)state;
	static u8 n_drawn[N_PIXELS];
	for (u32 n = 0; n < 60; n++) {
		make_mesh(n % 2 == 0);
		memset(n_drawn, 0, sizeof n_drawn);
		ts_arrays arrays = small_arrays(&scene);
		ts_camera_k view = ts_k_view(&eye);
		for (u32 t = 0; t < scene.n_triangles; t++) {
			ts_corners corners = ts_k_corners(&arrays, t);
			clear(texels, N_PIXELS);
			const ts_band whole = ts_k_band(0, 0);
			ts_target target = ts_k_keys(texels);
			ts_k_draw(&arrays, &view, &corners, t, &whole, &target);
			for (u32 i = 0; i < N_PIXELS; i++) n_drawn[i] = (u8)(n_drawn[i] + (texels[i] != TS_EMPTY));
		}
		for (u32 i = 0; i < N_PIXELS; i++) {
			if (n_drawn[i] != 1) print_error("mesh %u: pixel (%u, %u) %u times\n", n, i % WIDTH, i / WIDTH, n_drawn[i]);
			assert_int_equal(n_drawn[i], 1);
		}
	}
}

/* A floor one unit below the eye, from far behind it to the horizon: depth focal / (y - H/2). */
static void a_floor_reaches_the_horizon(void **state)
{
	(void)state;
	const f32 e = 4096;
	small_clear(&scene);
	small_add(&scene, ts_v3_make(-e, -1, e), ts_v3_make(e, -1, e), ts_v3_make(e, -1, -e), 0, 0);
	small_add(&scene, ts_v3_make(-e, -1, e), ts_v3_make(e, -1, -e), ts_v3_make(-e, -1, -e), 0, 0);
	draw_all();
	for (u32 i = 0; i < N_PIXELS; i++) {
		f32 below_horizon = (f32)(i / WIDTH) + 0.5f - HEIGHT / 2;
		assert_true((texels[i] != TS_EMPTY) == (below_horizon > 0));
		if (below_horizon <= 0) continue;
		assert_near(depth(texels[i]) * below_horizon / 64, 1, 0.02 / below_horizon);
	}
}

static ts_v3 anywhere(void)
{
	f32 z = uniform(-1, 4);
	return ts_v3_make(uniform(-2, 2), uniform(-2, 2), -z);
}

static void make_soup(u32 n)
{
	small_clear(&scene);
	scene.materials[1].flags = TS_DOUBLE_SIDED;
	for (u32 i = 0; i < n; i++) small_add(&scene, anywhere(), anywhere(), anywhere(), bits() & 1, 0);
}

static void pixels_show_what_rays_meet(void **state)
{
	(void)state;
	ts_camera_k view = ts_k_view(&eye);
	u32 n_decided = 0, n_seen = 0;
	for (u32 n = 0; n < 16; n++) {
		make_soup(20);
		draw_all();
		for (u32 i = 0; i < N_PIXELS; i++) {
			sight s;
			if (!is_decided(&scene, &view, TS_NONE, i, &s)) continue;
			n_decided++;
			n_seen += s.at.triangle != TS_NONE;
			assert_int_equal((u32)texels[i], s.at.triangle);
			if (s.at.triangle != TS_NONE) assert_depth(depth(texels[i]), &s);
		}
	}
	assert_true(n_decided > 16 * N_PIXELS * 8 / 10 && n_seen > n_decided / 4);
}

/* The buffer is the same in every order of drawing; of equal triangles the first is seen. */
static void the_order_of_drawing_changes_nothing(void **state)
{
	(void)state;
	static u64 forward[N_PIXELS];
	for (u32 n = 0; n < 30; n++) {
		make_soup(40);
		for (u32 t = 0; t < 40; t++) {
			const ts_vertex *v = &scene.vertices[3 * t];
			small_add(&scene, ts_load3(v[0].position), ts_load3(v[1].position), ts_load3(v[2].position),
			          scene.triangles[t].material, 0);
		}
		draw_all();
		memcpy(forward, texels, sizeof forward);
		ts_eye_args args = {.scene = small_arrays(&scene), .view = &eye, .texels = texels};
		clear(texels, N_PIXELS);
		for (u32 k = 0; k < 80; k++) ts_k_eye_item(&args, n % 2 == 0 ? 79 - k : k * 37 % 80);
		assert_memory_equal(texels, forward, sizeof forward);
		for (u32 i = 0; i < N_PIXELS; i++) assert_true(texels[i] == TS_EMPTY || (u32)texels[i] < 40);
	}
}

/* Depth is stored without -0, denormals or NaN, and computing the fragment again gives the same bits. */
static void fragments_made_again_have_the_same_bits(void **state)
{
	(void)state;
	for (u32 n = 0; n < 30; n++) {
		make_soup(20);
		draw_all();
		ts_arrays arrays = small_arrays(&scene);
		ts_camera_k view = ts_k_view(&eye);
		for (i32 i = 0; i < N_PIXELS; i++) {
			if (texels[i] == TS_EMPTY) continue;
			ts_corners t = ts_k_corners(&arrays, (u32)texels[i]);
			ts_fragment f = ts_k_fragment_at(&view, &t, i % WIDTH, i / WIDTH);
			assert_int_equal(ts_f2u(f.z), (u32)(texels[i] >> 32));
			assert_true(f.z > 0.24f && same_bits(ts_put(f.z), f.z));
		}
	}
}

static u32 n_drawn(void)
{
	u32 n = 0;
	draw_all();
	for (u32 i = 0; i < N_PIXELS; i++) n += texels[i] != TS_EMPTY;
	return n;
}

/* Seen from behind only if double-sided; not where the alpha is below the cutoff; never without area. */
static void backs_and_masks_are_left_out(void **state)
{
	(void)state;
	ts_v3 a = behind_pixel(10, 10, 2), b = behind_pixel(10, 40, 2), c = behind_pixel(50, 40, 2);
	small_clear(&scene);
	small_add(&scene, a, b, c, 0, 0);
	u32 n_whole = n_drawn();
	assert_near(n_whole, 600, 40);
	small_clear(&scene);
	small_add(&scene, a, c, b, 0, 0);
	assert_int_equal(n_drawn(), 0);
	scene.materials[0].flags = TS_DOUBLE_SIDED;
	assert_int_equal(n_drawn(), n_whole);
	scene.materials[0].flags = TS_DOUBLE_SIDED | TS_MASKED;
	assert_int_equal(n_drawn(), n_whole);
	scene.vertices[0].colour[3] = 0;
	for (u32 k = 1; k < 3; k++) scene.vertices[k].colour[3] = 0;
	assert_int_equal(n_drawn(), 0);
	scene.vertices[1].colour[3] = 1;
	assert_near(n_drawn(), n_whole / 4, 20);
	small_clear(&scene);
	small_add(&scene, a, b, b, 0, 0);
	assert_int_equal(n_drawn(), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(meshes_have_no_gaps_and_no_overlaps),
		seeded_test(a_floor_reaches_the_horizon),
		seeded_test(pixels_show_what_rays_meet),
		seeded_test(the_order_of_drawing_changes_nothing),
		seeded_test(fragments_made_again_have_the_same_bits),
		seeded_test(backs_and_masks_are_left_out),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

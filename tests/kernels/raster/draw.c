/* Drawing against a ray caster in double precision: meshes without gaps or overlaps, a floor through the near plane,
 * ties, order, sides, masks, and the six faces of a cube in a box. */
#include "../small.h"
#include "../../../src/kernels/raster/cube_face.h"
#include "../../../src/kernels/raster/eye.h"

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

static void test_mesh(void **state)
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
			ts_target target = ts_k_keys(texels);
			ts_k_draw(&arrays, &view, &corners, t, &target);
			for (u32 i = 0; i < N_PIXELS; i++) n_drawn[i] = (u8)(n_drawn[i] + (texels[i] != TS_EMPTY));
		}
		for (u32 i = 0; i < N_PIXELS; i++) {
			if (n_drawn[i] != 1) print_error("mesh %u: pixel (%u, %u) %u times\n", n, i % WIDTH, i / WIDTH, n_drawn[i]);
			assert_int_equal(n_drawn[i], 1);
		}
	}
}

/* A floor one unit below the eye, from far behind it to the horizon: depth focal / (y - H/2). */
static void test_floor(void **state)
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

typedef struct {
	double z, next;
	u32 triangle;
} hit;

/* The nearest triangle before the near plane along the ray through (x, y), and the depth of the one behind it. */
static hit cast(double x, double y)
{
	hit h = {INFINITY, INFINITY, TS_NONE};
	double3 ray = {(x - WIDTH / 2) / 64, (HEIGHT / 2 - y) / 64, -1};
	for (u32 t = 0; t < scene.n_triangles; t++) {
		double3 v[3];
		for (u32 k = 0; k < 3; k++) v[k] = d3_of(ts_load3(scene.vertices[3 * t + k].position));
		double3 n = d3_cross(d3_sub(v[1], v[0]), d3_sub(v[2], v[0]));
		if (scene.triangles[t].material == 0 && d3_dot(n, v[0]) >= 0) continue;
		double z = d3_dot(n, v[0]) / d3_dot(n, ray);
		bool inside = z >= eye.near;
		for (u32 k = 0; k < 3; k++) {
			double3 p = d3_scale(ray, z), a = v[k], b = v[(k + 1) % 3];
			inside = inside && d3_dot(d3_cross(d3_sub(b, a), d3_sub(p, a)), n) >= 0;
		}
		if (!inside) continue;
		h.next = fmin(h.next, fmax(z, h.z));
		if (z < h.z) h = (hit){z, h.z, t};
	}
	return h;
}

/* Rays a hundredth of a pixel around the centre agree on what is seen, by a clear margin. */
static bool is_decided(u32 i, hit *h)
{
	double x = i % WIDTH + 0.5, y = i / WIDTH + 0.5;
	*h = cast(x, y);
	bool clear_cut = h->triangle == TS_NONE || (h->next - h->z > 0.01 * h->z && h->z > eye.near * 1.01);
	for (u32 k = 0; k < 4 && clear_cut; k++) {
		clear_cut = cast(x + (k & 1 ? 0.01 : -0.01), y + (k & 2 ? 0.01 : -0.01)).triangle == h->triangle;
	}
	return clear_cut;
}

static void test_soup(void **state)
{
	(void)state;
	u32 n_decided = 0, n_seen = 0;
	for (u32 n = 0; n < 16; n++) {
		make_soup(20);
		draw_all();
		for (u32 i = 0; i < N_PIXELS; i++) {
			hit h;
			if (!is_decided(i, &h)) continue;
			n_decided++;
			n_seen += h.triangle != TS_NONE;
			assert_int_equal((u32)texels[i], h.triangle);
			if (h.triangle != TS_NONE) assert_near(depth(texels[i]), h.z, 0.02 * h.z);
		}
	}
	assert_true(n_decided > 16 * N_PIXELS * 8 / 10 && n_seen > n_decided / 4);
}

/* The buffer is the same in every order of drawing; of equal triangles the first is seen. */
static void test_order(void **state)
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
static void test_again(void **state)
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
static void test_sides_and_masks(void **state)
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

enum { N = 16, FACE = N * N };

/* The walls of a box, seen from inside. */
static void add_box(ts_v3 lo, ts_v3 hi)
{
	for (u32 axis = 0; axis < 3; axis++) {
		for (u32 k = 0; k < 2; k++) {
			f32 v[4][3];
			for (u32 i = 0; i < 4; i++) {
				u32 s = (axis + 1) % 3, t = (axis + 2) % 3;
				v[i][axis] = k == 0 ? (&hi.x)[axis] : (&lo.x)[axis];
				v[i][s] = i & 1 ? (&hi.x)[s] : (&lo.x)[s];
				v[i][t] = i & 2 ? (&hi.x)[t] : (&lo.x)[t];
			}
			small_add(&scene, ts_load3(v[0]), ts_load3(v[1]), ts_load3(v[3]), 1, 0);
			small_add(&scene, ts_load3(v[0]), ts_load3(v[3]), ts_load3(v[2]), 1, 0);
		}
	}
}

/* A box around two cubes: every texel sees the wall that its direction meets, at the closed form's depth; a reflector's
 * own triangle hides the wall in the other's cube only; a cube of no size draws nothing. */
static void test_faces(void **state)
{
	(void)state;
	static u64 buffer[2 * 6 * FACE + 1];
	ts_v3 lo = {-3, -2, -4}, hi = {5, 4, 3};
	ts_face cubes[4] = {{.n = 0},
	                    {.centre = {1, 1, 0}, .n = N, .near = 0.01f, .offset = 600, .object = 1},
	                    {.n = 0},
	                    {.centre = {1, 1, -2}, .n = N, .near = 0.01f, .offset = 600 + 6 * FACE, .object = TS_NONE}};
	small_clear(&scene);
	scene.materials[1].flags = TS_DOUBLE_SIDED;
	add_box(lo, hi);
	u32 own = small_add(&scene, ts_v3_make(-1, -1, -1), ts_v3_make(5, -1, -1), ts_v3_make(-1, 5, -1), 1, 1);
	clear(buffer, sizeof buffer / sizeof buffer[0]);
	ts_cube_face_args args = {
		.scene = small_arrays(&scene),
		.cubes = cubes,
		.texels = buffer,
		.first_cube = 1,
		.n_cubes = 3,
	};
	for (u32 t = 0; t < scene.n_triangles; t++) ts_k_cube_face_item(&args, t);
	u32 n_own = 0;
	for (u32 i = 0; i < 2 * 6 * FACE; i++) {
		u32 k = i / FACE % 6;
		ts_v3 c = ts_load3(cubes[i / FACE < 6 ? 1 : 3].centre);
		ts_v3 d = ts_k_cube_direction(k, (2 * (f32)(i % N) + 1) / N - 1, (2 * (f32)(i / N % N) + 1) / N - 1);
		double z = 1e9;
		for (u32 axis = 0; axis < 3; axis++) {
			double x = (&d.x)[axis], o = (&c.x)[axis];
			z = fmin(z, ((x > 0 ? (double)(&hi.x)[axis] : (double)(&lo.x)[axis]) - o) / x);
		}
		assert_true(buffer[i] != TS_EMPTY);
		n_own += (u32)buffer[i] == own;
		if ((u32)buffer[i] == own) {
			assert_true(i / FACE >= 6 && 1 / d.z > 0 && 1 / d.z < z);
			z = 1 / d.z;
		}
		assert_near(depth(buffer[i]), z, 0.02 * z);
	}
	assert_true(n_own > FACE / 3 && buffer[2 * 6 * FACE] == TS_EMPTY);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(test_mesh),  seeded_test(test_floor),           seeded_test(test_soup),  seeded_test(test_order),
		seeded_test(test_again), seeded_test(test_sides_and_masks), seeded_test(test_faces),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

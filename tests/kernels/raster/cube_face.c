/* Cube faces against rays in double precision: a soup of triangles in a batch of cubes, and a box in closed form. */
#include "kernels/raster/cube_face.h"
#include "tests/kernels/raster/sight.h"

enum { N = 16, FACE = N * N, N_SOUPS = 12, N_CUBES = 5, FIRST = 1, N_BATCH = 3, N_TRIANGLES = 24 };

static small_scene scene;
static ts_face cubes[N_CUBES];

/* Cubes that leave out object 0, object 1 or nothing, and one without size. */
static void make_cubes(u32 without_size)
{
	u64 offset = 600;
	for (u32 r = 0; r < N_CUBES; r++) {
		cubes[r] = (ts_face){.n = r == without_size ? 0 : N, .near = 0.25f, .offset = offset};
		ts_store3(cubes[r].centre, uniform3(-1, 1));
		cubes[r].object = r % 3 < 2 ? r % 3 : TS_NONE;
		offset += 6 * cubes[r].n * cubes[r].n;
	}
}

static void check_cube(const ts_face *cube, const u64 *drawn, u32 *n_decided, u32 *n_seen)
{
	for (u32 i = 0; i < 6 * cube->n * cube->n; i++) {
		ts_camera_k view = ts_k_cube_view(cube, i / FACE);
		sight s;
		if (!is_decided(&scene, &view, cube->object, i % FACE, &s)) continue;
		*n_decided += 1;
		*n_seen += s.at.triangle != TS_NONE;
		assert_int_equal((u32)drawn[i], s.at.triangle);
		if (s.at.triangle != TS_NONE) assert_depth(ts_u2f((u32)(drawn[i] >> 32)), &s);
	}
}

/* A batch of some of the cubes; nothing is drawn beside it. */
static void faces_show_what_rays_meet(void **state)
{
	(void)state;
	static u64 buffer[N_BATCH * 6 * FACE];
	u32 n_decided = 0, n_seen = 0, n_texels = 0;
	for (u32 n = 0; n < N_SOUPS; n++) {
		small_soup(&scene, N_TRIANGLES);
		make_cubes(n % N_CUBES);
		memset(buffer, 0xff, sizeof buffer);
		ts_cube_face_args args = {
			.scene = small_arrays(&scene), .cubes = cubes, .texels = buffer, .first_cube = FIRST, .n_cubes = N_BATCH};
		for (u32 t = 0; t < N_TRIANGLES; t++) ts_k_cube_face_item(&args, t);
		for (u32 r = FIRST; r < FIRST + N_BATCH; r++) {
			check_cube(&cubes[r], buffer + (cubes[r].offset - cubes[FIRST].offset), &n_decided, &n_seen);
		}
		u64 end = cubes[FIRST + N_BATCH].offset - cubes[FIRST].offset;
		for (u64 i = end; i < N_BATCH * 6 * FACE; i++) assert_true(buffer[i] == TS_EMPTY);
		n_texels += (u32)end;
	}
	assert_true(n_decided > n_texels * 8 / 10 && n_seen > n_decided / 4);
}

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
static void cubes_see_the_box_around_them(void **state)
{
	(void)state;
	static u64 buffer[2 * 6 * FACE + 1];
	ts_v3 lo = {-3, -2, -4}, hi = {5, 4, 3};
	ts_face around[4] = {{.n = 0},
	                     {.centre = {1, 1, 0}, .n = N, .near = 0.01f, .offset = 600, .object = 1},
	                     {.n = 0},
	                     {.centre = {1, 1, -2}, .n = N, .near = 0.01f, .offset = 600 + 6 * FACE, .object = TS_NONE}};
	small_clear(&scene);
	scene.materials[1].flags = TS_DOUBLE_SIDED;
	add_box(lo, hi);
	u32 own = small_add(&scene, ts_v3_make(-1, -1, -1), ts_v3_make(5, -1, -1), ts_v3_make(-1, 5, -1), 1, 1);
	memset(buffer, 0xff, sizeof buffer);
	ts_cube_face_args args = {
		.scene = small_arrays(&scene),
		.cubes = around,
		.texels = buffer,
		.first_cube = 1,
		.n_cubes = 3,
	};
	for (u32 t = 0; t < scene.n_triangles; t++) ts_k_cube_face_item(&args, t);
	u32 n_own = 0;
	for (u32 i = 0; i < 2 * 6 * FACE; i++) {
		u32 k = i / FACE % 6;
		ts_v3 c = ts_load3(around[i / FACE < 6 ? 1 : 3].centre);
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
		assert_near(ts_u2f((u32)(buffer[i] >> 32)), z, 0.02 * z);
	}
	assert_true(n_own > FACE / 3 && buffer[2 * 6 * FACE] == TS_EMPTY);
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(faces_show_what_rays_meet),
	                                   seeded_test(cubes_see_the_box_around_them)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

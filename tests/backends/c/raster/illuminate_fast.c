/* Fast shading of MVR's faces equals the plain kernel bit for bit: of batches of cubes of any sides, some of which have
 * none, from anywhere; of texels that name what the cube sees there, or triangles at random, or nothing. */
#include "kernels/raster/cube.h"
#include "tests/backends/c/raster/scribble.h"
#include "tests/whole.h"

enum { CUBES = 4, SIDE = 24, TEXELS = CUBES * 6 * SIDE * SIDE };

typedef struct {
	ts_face cubes[CUBES + 1]; /* and one before the batch */
	u64 keys[TEXELS];
	u32 n_texels, n_mip;
} input;

static void draw(input *in, const ts_arrays *scene, const ts_face *cube)
{
	for (u32 face = 0; face < 6; face++) {
		ts_camera_k view = ts_k_cube_view(cube, face);
		const ts_band whole = ts_k_band(0, 0);
		ts_target target = ts_k_keys(in->keys + in->n_texels);
		in->n_texels += cube->n * cube->n;
		for (u32 t = 0; t < scene->n_triangles; t++) {
			ts_corners c = ts_k_corners(scene, t);
			if (!ts_k_is_degenerate(c.n)) ts_k_draw(scene, &view, &c, t, &whole, &target);
		}
	}
}

static void random_input(input *in, const ts_arrays *scene)
{
	u64 offset = in->n_texels = in->n_mip = 0;
	memset(in->keys, 0xff, sizeof in->keys);
	for (u32 r = 0; r <= CUBES; r++) {
		ts_face *cube = &in->cubes[r];
		*cube = (ts_face){.n = below(4) == 0 ? 0 : 1 + below(SIDE), .near = uniform(0.01f, 1), .offset = offset};
		ts_store3(cube->centre, uniform3(-2, 2));
		offset += 6 * cube->n * cube->n;
		if (r == 0) continue;
		draw(in, scene, cube);
		in->n_mip += (u32)ts_k_mip_texels(cube->n, 32);
	}
	scribble(in->keys, TEXELS, scene->n_triangles);
}

static void check(const ts_run *run, u32 n_triangles)
{
	static input in;
	static f32 plain[TEXELS * 8], fast[TEXELS * 8];
	(void)n_triangles;
	u32 start = n_random;
	ts_illuminate_args args = {.scene = ts_run_arrays(run), .cubes = in.cubes, .depth_triangle = in.keys};
	random_input(&in, &args.scene);
	u32 n = below(4) == 0 ? below(in.n_texels + 1) : in.n_texels;
	args.first_cube = 1;
	args.n_cubes = CUBES;
	memset(plain, 0x55, sizeof plain);
	memset(fast, 0x55, sizeof fast);
	args.mip = plain;
	ts_illuminate_args other = args;
	other.mip = fast;
	launch_both(TS_KERNEL_illuminate, ts_c_fast_illuminate, &args, &other, n);
	if (memcmp(plain, fast, sizeof plain) != 0) fail_msg("random %u: %u texels", start, n);
}

static void fast_shading_of_faces_equals_the_kernel(void **state)
{
	(void)state;
	with_run(check, whole_or(60, 25));
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(fast_shading_of_faces_equals_the_kernel)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* MVR's faces: what is shaded, and the mip chain against its definition. */
#include "kernels/raster/illuminate.h"
#include "tests/kernels/points/mesh.h"

enum { MOST = 80 };

static u64 chain_texels(u32 n)
{
	u64 sum = 0;
	for (; n > 0; n /= 2) sum += 6 * (u64)n * n;
	return sum;
}

/* The levels of a cube whose first level is given. */
static void make_levels(f32 *mip, u32 n)
{
	ts_face cube = {.n = n};
	ts_illuminate_args args = {.cubes = &cube, .mip = mip, .n_cubes = 1};
	for (args.level = 1; args.level < ts_k_mip_levels(n); args.level++) {
		u32 size = ts_k_mip_size(n, args.level);
		for (u32 i = 0; i < 6 * size * size; i++) ts_k_mip_item(&args, i);
	}
}

static void a_constant_cube_stays_constant(void **state)
{
	(void)state;
	static const f32 colour[4] = {0.1f, 0.7f, 3, 1};
	for (u32 n = 1; n <= MOST; n++) {
		f32 *mip = mesh_alloc(chain_texels(n) * 4, sizeof *mip);
		for (u32 i = 0; i < 24 * n * n; i++) mip[i] = colour[i % 4];
		make_levels(mip, n);
		for (u64 i = 0; i < chain_texels(n) * 4; i++) assert_true(mip[i] == colour[i % 4]);
		free(mip);
	}
}

/* Each level is the mean of two by two texels of the one before; a last odd row or column has no part in it. Small
 * integers make every mean exact, so at powers of two each level's sum is a quarter of the one before. */
static void each_level_averages_the_one_before(void **state)
{
	(void)state;
	n_random = 0;
	for (u32 n = 1; n <= MOST; n++) {
		f32 *mip = mesh_alloc(chain_texels(n) * 4, sizeof *mip);
		for (u32 i = 0; i < 24 * n * n; i++) mip[i] = (f32)(random_bits() % 512);
		make_levels(mip, n);
		const f32 *above = mip;
		double sum_above = 0;
		for (u32 i = 0; i < 24 * n * n; i++) sum_above += (double)mip[i];
		for (u32 size = n; size > 1; size /= 2) {
			u32 half = size / 2;
			const f32 *level = above + 24 * (u64)size * size;
			double sum = 0;
			for (u32 i = 0; i < 24 * half * half; i++) {
				u32 face = i / (4 * half * half), y = i / (4 * half) % half, x = i / 4 % half, c = i % 4;
				double mean = 0;
				for (u32 k = 0; k < 4; k++) {
					mean += (double)above[((face * size + 2 * y + k / 2) * size + 2 * x + k % 2) * 4 + c] / 4;
				}
				assert_true(fabs((double)level[i] - mean) <= 1e-4);
				sum += (double)level[i];
			}
			if ((n & (n - 1)) == 0) assert_true(sum * 4 == sum_above);
			above = level;
			sum_above = sum;
		}
		free(mip);
	}
}

/* Three cubes in one batch of two, triangles of known colour: each texel shows its triangle's or the background, and
 * those that show a triangle are counted. */
static void texels_show_their_triangle_or_the_background(void **state)
{
	(void)state;
	n_random = 0;
	mesh m;
	mesh_begin(&m);
	mesh_cube(&m, ts_v3_make(0, 0, 0), 0.5f, 9);
	mesh_cube(&m, ts_v3_make(0, 0, 0), 0.5f, 4);
	mesh_cube(&m, ts_v3_make(0, 0, 0), 0.5f, 7);
	for (u32 i = 0; i < 4; i++) {
		m.materials[i].flags = TS_UNLIT;
		m.materials[i].base[0] = (f32)i;
		mesh_triangle(&m, uniform3(-9, 9), uniform3(-9, 9), uniform3(-9, 9), i, 0);
	}
	u32 n = 6 * (16 + 49);
	u64 *keys = mesh_alloc(n, sizeof *keys);
	f32 *mip = mesh_alloc((chain_texels(4) + chain_texels(7)) * 4, sizeof *mip);
	for (u32 i = 0; i < n; i++) {
		u32 choice = random_bits() % 5;
		keys[i] = choice < 4 ? (u64)ts_f2u(1) << 32 | choice : TS_EMPTY;
	}
	ts_illuminate_args args = {
		.scene = mesh_arrays(&m), .cubes = m.cubes, .depth_triangle = keys, .mip = mip, .first_cube = 1, .n_cubes = 2};
	for (u32 i = 0; i < n; i++) ts_k_illuminate_item(&args, i);
	for (u32 i = 0; i < n; i++) {
		const f32 *out = mip + (i < 96 ? i : chain_texels(4) + i - 96) * 4;
		assert_true(ts_abs(out[0] - (keys[i] == TS_EMPTY ? 0.2f : (f32)(u32)keys[i])) <= 1e-3f && out[3] == 1);
	}
	free(keys);
	free(mip);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_constant_cube_stays_constant),
		cmocka_unit_test(each_level_averages_the_one_before),
		cmocka_unit_test(texels_show_their_triangle_or_the_background),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

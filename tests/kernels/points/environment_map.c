/* The copy pass: the colours of the codes in level 0 of every cube's mip chain, the background where there are none. */
#include "kernels/points/environment_map.h"
#include "tests/kernels/seeded.h"

enum { N_CUBES = 3, N_TEXELS = 6 * (16 * 16 + 7 * 7 + 4 * 4), BEFORE = 6 * 5 * 5 };

/* Cube 0 is no part of the batch. */
static const ts_face cubes[1 + N_CUBES] = {
	{.n = 5},
	{.n = 16, .offset = BEFORE},
	{.n = 7, .offset = BEFORE + 6 * 256},
	{.n = 4, .offset = BEFORE + 6 * 305},
};

/* Texels of a cube's chain, level by level. */
static u64 chain_of(u32 n) { return n == 0 ? 0 : 6 * (u64)n * n + chain_of(n / 2); }

static void colours_of_codes_fill_level_zero(void **state)
{
	(void)state;
	static u32 colours[BEFORE + N_TEXELS];
	static f32 mip[4 * 6 * 600];
	const f32 exposures[] = {1, 0.25f, 16};
	for (u32 i = 0; i < 30; i++) {
		ts_environment_map_args args = {.to = {.cubes = cubes, .mip = mip, .first_cube = 1, .n_cubes = N_CUBES},
		                                .colours = colours,
		                                .exposure = exposures[i % 3]};
		for (u32 k = 0; k < BEFORE + N_TEXELS; k++) {
			colours[k] = below(4) == 0 ? TS_NONE : below(8191) << 19 | below(1u << 19);
		}
		for (u32 k = 0; k < sizeof mip / sizeof *mip; k++) mip[k] = -1;
		for (u32 k = 0; k < N_TEXELS; k++) ts_k_environment_map_item(&args, k);
		const f32 *out = mip;
		const u32 *in = colours + BEFORE;
		u64 written = 0;
		for (u32 r = 1; r <= N_CUBES; r++) {
			u32 n = 6 * cubes[r].n * cubes[r].n;
			for (u32 k = 0; k < n; k++, in++) {
				const double background[3] = {0.2, 0.3, 0.5};
				const u32 code[3] = {*in >> 13 & 63, *in >> 6 & 127, *in & 63}, most[3] = {63, 127, 63};
				for (u32 c = 0; c < 3; c++) {
					double root = code[c] / (double)most[c], expected = root * root / (double)args.exposure;
					assert_near(out[4 * k + c], *in == TS_NONE ? background[c] : expected, 1e-6 * (1 + expected));
				}
				assert_true(out[4 * k + 3] == 1);
			}
			for (u64 k = n; k < chain_of(cubes[r].n); k++) assert_true(out[4 * k] == -1 && out[4 * k + 3] == -1);
			out += 4 * chain_of(cubes[r].n);
			written += n;
		}
		assert_true(written == N_TEXELS);
		for (const f32 *rest = out; rest < mip + sizeof mip / sizeof *mip; rest++) assert_true(*rest == -1);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(colours_of_codes_fill_level_zero)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

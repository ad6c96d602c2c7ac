/* Textures against the endless wrapped image they stand for: a double-precision bilinear look-up by the definition of
 * each wrap mode, exact texels at their centres, nothing read outside the image, the level rule at powers of two. */
#include "kernels/base/texture.h"
#include "tests/kernels/small.h"

enum { N = 100000, MAX_SIDE = 16 };

static u64 texels[2 * MAX_SIDE * MAX_SIDE + 64];
static ts_image image;
static ts_slot slot;
static ts_arrays arrays = {.images = &image, .texels = texels};

/* Random texels on every level, opaque; transparent ones around them, which no look-up may meet. */
static void make_image(u32 width, u32 height, bool constant)
{
	u32 n = 32;
	for (u32 k = 0; k < sizeof texels / sizeof texels[0]; k++) texels[k] = 0;
	image = (ts_image){.width = width, .height = height, .first_texel = 32};
	for (u32 w = width, h = height;; w >>= 1, h >>= 1) {
		w = w > 0 ? w : 1;
		h = h > 0 ? h : 1;
		image.n_levels++;
		for (u32 k = 0; k < w * h; k++) {
			texels[n++] = constant ? texel(12345, 1, 65535, 65535) : texel(bits() & 0xffff, bits() & 0xffff, 77, 65535);
		}
		if (w == 1 && h == 1) break;
	}
}

static void set_wrap(u32 s, u32 t)
{
	slot.wrap[0] = s;
	slot.wrap[1] = t;
}

static u32 wrapped(i64 i, i64 n, u32 wrap)
{
	i64 m = ((i % (2 * n)) + 2 * n) % (2 * n);
	if (wrap == TS_CLAMP) return (u32)(i < 0 ? 0 : i >= n ? n - 1 : i);
	if (wrap == TS_REPEAT) return (u32)(m % n);
	return (u32)(m < n ? m : 2 * n - 1 - m);
}

/* A level's first texel, and its size. */
static const u64 *level(u32 l, u32 *width, u32 *height)
{
	const u64 *p = texels + image.first_texel;
	*width = image.width;
	*height = image.height;
	for (u32 k = 0; k < l; k++) {
		p += *width * *height;
		*width = *width > 1 ? *width / 2 : 1;
		*height = *height > 1 ? *height / 2 : 1;
	}
	return p;
}

static double red(u64 t) { return (double)(t & 0xffff) / 65535; }

/* What a bilinear look-up of the endless image gives for red. */
static double bilinear(u32 l, double u, double v)
{
	u32 w, h;
	const u64 *p = level(l, &w, &h);
	double x = u * w - 0.5, y = v * h - 0.5, fx = x - floor(x), fy = y - floor(y);
	u32 x0 = wrapped((i64)floor(x), w, slot.wrap[0]), x1 = wrapped((i64)floor(x) + 1, w, slot.wrap[0]);
	u32 y0 = wrapped((i64)floor(y), h, slot.wrap[1]), y1 = wrapped((i64)floor(y) + 1, h, slot.wrap[1]);
	double top = red(p[y0 * w + x0]) * (1 - fx) + red(p[y0 * w + x1]) * fx;
	return top * (1 - fy) + (red(p[y1 * w + x0]) * (1 - fx) + red(p[y1 * w + x1]) * fx) * fy;
}

static const u32 sizes[][2] = {{16, 16}, {16, 4}, {5, 3}, {1, 1}, {1, 7}, {13, 2}};
enum { N_SIZES = sizeof sizes / sizeof sizes[0] };

static void a_constant_image_reads_constant(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		if (i % 1000 == 0) make_image(sizes[i / 1000 % N_SIZES][0], sizes[i / 1000 % N_SIZES][1], true);
		set_wrap(below(3), below(3));
		ts_v2 uv = {uniform(-1, 1) * ldexpf(1, (int)below(100) - 40), uniform(-3, 3)};
		ts_rgba c = ts_k_texture_sample(&arrays, &slot, uv, below(4096));
		assert_true(c.r == 12345 * 0.00001525902189314365f && c.g == 0.00001525902189314365f);
		assert_true(c.b == 1 && c.a == 1);
	}
}

/* Nothing but the image is read, whatever the coordinates. */
static void nothing_but_the_image_is_read(void **state)
{
	(void)state;
	const f32 special[] = {0,         -0.0f, 1,      -1,      0.5f,   NAN,        INFINITY,
	                       -INFINITY, 1e30f, -1e30f, -1e-10f, 1e-40f, 0.99999994f};
	for (u32 i = 0; i < N; i++) {
		if (i % 1000 == 0) make_image(sizes[i / 1000 % N_SIZES][0], sizes[i / 1000 % N_SIZES][1], false);
		set_wrap(below(3), below(3));
		f32 u = i % 3 == 0 ? special[below(13)] : ts_u2f(bits()), v = i % 3 == 1 ? special[below(13)] : ts_u2f(bits());
		ts_rgba c = ts_k_texture_sample(&arrays, &slot, ts_v2_make(u, v), below(4096));
		assert_true(c.a == 1 && c.b == 77 * 0.00001525902189314365f && c.r >= 0 && c.r <= 1);
	}
}

static void texel_centres_read_their_texel(void **state)
{
	(void)state;
	for (u32 k = 0; k < N_SIZES * 9; k++) {
		make_image(sizes[k / 9][0], sizes[k / 9][1], false);
		set_wrap(k % 3, k / 3 % 3);
		for (u32 l = 0; l < image.n_levels; l++) {
			u32 w, h;
			const u64 *p = level(l, &w, &h);
			for (u32 i = 0; i < w * h; i++) {
				ts_v2 uv = {((f32)(i % w) + 0.5f) / (f32)w, ((f32)(i / w) + 0.5f) / (f32)h};
				ts_rgba c = ts_k_texture_sample(&arrays, &slot, uv, l * 256);
				assert_near(c.r, red(p[i]), 1e-7);
				assert_near(c.g, (double)(p[i] >> 16 & 0xffff) / 65535, 1e-7);
			}
		}
	}
}

/* Fractions of a texel are kept to 1/256, so a result may be off by half of that along each axis. */
static void bilinear_reads_match_double_precision(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		if (i % 1000 == 0) make_image(sizes[i / 1000 % N_SIZES][0], sizes[i / 1000 % N_SIZES][1], false);
		set_wrap(below(3), below(3));
		ts_v2 uv = {uniform(-3, 3), uniform(-3, 3)};
		u32 l = below(image.n_levels);
		assert_near(ts_k_texture_sample(&arrays, &slot, uv, l * 256).r, bilinear(l, uv.x, uv.y), 2.1 / 512);
	}
}

/* Between two levels in proportion; beyond the last, the last. */
static void reads_between_levels_are_in_proportion(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		if (i % 1000 == 0) make_image(sizes[i / 1000 % N_SIZES][0], sizes[i / 1000 % N_SIZES][1], false);
		set_wrap(below(3), below(3));
		ts_v2 uv = {uniform(-3, 3), uniform(-3, 3)};
		u32 lod = below(4096), last = (image.n_levels - 1) * 256, l = lod < last ? lod / 256 : image.n_levels - 1;
		double f = lod < last ? lod % 256 / 256.0 : 0;
		double fine = ts_k_texture_sample(&arrays, &slot, uv, l * 256).r;
		double coarse = ts_k_texture_sample(&arrays, &slot, uv, (l + 1) * 256).r;
		assert_near(ts_k_texture_sample(&arrays, &slot, uv, lod).r, fine * (1 - f) + coarse * f, 0.6 / 65535);
	}
}

/* All 256 x 256 fractions between four texels, and all between two levels, in integers as specified: equal texels keep
 * their value, greatest ones do not overflow. */
static void every_fraction_blends_as_specified(void **state)
{
	(void)state;
	set_wrap(TS_CLAMP, TS_CLAMP);
	for (u32 n = 0; n < 65536; n++) {
		u64 fx = n & 255, fy = n >> 8, t[5];
		make_image(2, 2, false);
		for (u32 k = 0; k < 5; k++) t[k] = n % 3 == 0 ? 65535 : n % 3 == 1 && k > 0 ? t[0] : bits() & 0xffff;
		for (u32 k = 0; k < 5; k++) texels[32 + k] = texel((u32)t[k], 0, 0, 65535);
		u64 sum = (t[0] * (256 - fx) + t[1] * fx) * (256 - fy) + (t[2] * (256 - fx) + t[3] * fx) * fy;
		ts_v2 uv = {0.25f + (f32)fx / 512, 0.25f + (f32)fy / 512};
		f32 r = ts_k_texture_sample(&arrays, &slot, uv, 0).r;
		assert_true(r == (f32)((sum + 32768) >> 16) * 0.00001525902189314365f);
		r = ts_k_texture_sample(&arrays, &slot, ts_v2_make(0.25f, 0.25f), (u32)fx).r;
		assert_true(r == (f32)((t[0] * (256 - fx) + t[4] * fx + 128) >> 8) * 0.00001525902189314365f);
	}
}

/* A footprint of 2^k texels reads level k; the level grows with the footprint and stops at its greatest value. */
static void level_follows_the_footprint(void **state)
{
	(void)state;
	for (i32 k = -20; k <= 15; k++) {
		f32 footprint = ldexpf(1, k - 5);
		assert_int_equal(ts_k_texture_lod(64, 16, footprint, 1, 1), k < 0 ? 0 : 256 * k);
		assert_int_equal(ts_k_texture_lod(64, 16, footprint * 2, 1, 4), k < 0 ? 0 : 256 * k);
		assert_int_equal(ts_k_texture_lod(64, 16, footprint, 0.25f, 0.25f), k < 0 ? 0 : 256 * k);
	}
	u32 before = 0;
	for (f32 footprint = ldexpf(1, -20); footprint < 65536; footprint *= 1.001f) {
		u32 lod = ts_k_texture_lod(64, 16, footprint, 1, 1);
		double exact = fmin(4095, 256 * fmax(0, log2(32 * (double)footprint)));
		assert_true(lod >= before);
		assert_near(lod, exact, 0.51);
		before = lod;
	}
	assert_int_equal(ts_k_texture_lod(64, 16, 1, 0, 1), 0);
	assert_int_equal(ts_k_texture_lod(64, 16, 0, 1, 1), 0);
	assert_int_equal(ts_k_texture_lod(64, 16, ldexpf(1, 60), ldexpf(1, 60), ldexpf(1, -60)), 4095);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(a_constant_image_reads_constant),
		seeded_test(nothing_but_the_image_is_read),
		seeded_test(texel_centres_read_their_texel),
		seeded_test(bilinear_reads_match_double_precision),
		seeded_test(reads_between_levels_are_in_proportion),
		seeded_test(every_fraction_blends_as_specified),
		seeded_test(level_follows_the_footprint),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

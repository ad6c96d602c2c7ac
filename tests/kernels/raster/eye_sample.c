/* Samples of the eye's pixels: the rotated grid; four samples are four pixels of a picture that is four times as wide
 * and high; gradients over the square that a sample stands for; the mean of a pixel's samples. */
#include <stdlib.h>
#include "kernels/points/mirror_pixel.h"
#include "kernels/raster/eye.h"
#include "kernels/raster/image.h"
#include "tests/kernels/small.h"

enum { WIDTH = 32, HEIGHT = 24, N_PIXELS = WIDTH * HEIGHT, SAMPLES = TS_N_EYE_SAMPLES };

static const ts_view eye = {
	.focal = 32,
	.right = {1, 0, 0},
	.width = WIDTH,
	.up = {0, 1, 0},
	.height = HEIGHT,
	.back = {0, 0, 1},
	.near = 0.25f,
};

static small_scene scene;
static u64 keys[SAMPLES * N_PIXELS], fine[16 * N_PIXELS];

static void draw(u64 *texels, const ts_view *view, u32 samples)
{
	ts_eye_args args = {.scene = small_arrays(&scene), .view = view, .texels = texels, .samples = samples};
	for (u32 i = 0; i < samples * view->width * view->height; i++) texels[i] = TS_EMPTY;
	for (u64 i = 0; i < (u64)scene.n_triangles * samples; i++) ts_k_eye_item(&args, i);
}

/* Column and row of a sample in 4 x 4. */
static u32 column(u32 sample) { return (u32)ts_eye_sample[sample][0] / 64; }
static u32 row(u32 sample) { return (u32)ts_eye_sample[sample][1] / 64; }

/* In the middles of cells of 4 x 4, each row and each column once, and in the middle on the whole; the standard sample
 * locations of Vulkan in their order. */
static void the_grid_is_the_standard_rotated_one(void **state)
{
	(void)state;
	static const double standard[SAMPLES][2] = {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};
	u32 columns = 0, rows = 0;
	i32 x = 0, y = 0;
	for (u32 k = 0; k < SAMPLES; k++) {
		assert_true(ts_eye_sample[k][0] == 256 * standard[k][0] && ts_eye_sample[k][1] == 256 * standard[k][1]);
		columns |= 1u << column(k);
		rows |= 1u << row(k);
		x += ts_eye_sample[k][0];
		y += ts_eye_sample[k][1];
	}
	assert_true(columns == 15 && rows == 15 && x == 512 && y == 512);
}

/* Elements of the eye's buffers, and back: one sample's picture after another. */
static void samples_have_their_places_in_the_buffers(void **state)
{
	(void)state;
	for (u32 i = 0; i < SAMPLES * N_PIXELS; i++) {
		ts_eye_place at = ts_k_eye_place(&eye, SAMPLES, i);
		u32 k = i / N_PIXELS;
		assert_true(at.first == k * N_PIXELS && at.first + (u64)at.y * WIDTH + (u64)at.x == i && at.x < WIDTH);
		assert_true(at.view.shift_x == 128 - ts_eye_sample[k][0] && at.view.shift_y == 128 - ts_eye_sample[k][1]);
		assert_true(at.view.side == 0.5f);
	}
	ts_eye_place one = ts_k_eye_place(&eye, 1, N_PIXELS - 1);
	assert_true(one.view.shift_x == 0 && one.view.shift_y == 0 && one.view.side == 1.0f && one.first == 0);
}

/* A corner at depth z that is seen at (x, y) of the image. */
static ts_v3 seen_at(f32 x, f32 y, f32 z)
{
	return ts_v3_make((x - WIDTH / 2) * z / 32, (HEIGHT / 2 - y) * z / 32, -z);
}

/* Triangles of corners anywhere; exact: at pixels' corners at powers of two, so that no picture snaps them. */
static void make_soup(bool exact)
{
	small_clear(&scene);
	for (u32 m = 0; m < 2; m++) scene.materials[m].flags = TS_DOUBLE_SIDED;
	for (u32 t = 0; t < 30; t++) {
		ts_v3 v[3];
		f32 z = exact ? (f32)(1u << below(3)) : 0;
		for (u32 k = 0; k < 3; k++) {
			f32 x = uniform(-8, WIDTH + 8), y = uniform(-8, HEIGHT + 8);
			v[k] = exact ? seen_at(floorf(x), floorf(y), z) : seen_at(x, y, uniform(0.5f, 4));
		}
		small_add(&scene, v[0], v[1], v[2], t & 1, 0);
	}
}

/* How many keys, or triangles alone, differ from those of the picture of 4 x 4 pixels a pixel, which has a pixel where
 * a sample is. */
static u32 n_different(bool depths)
{
	ts_view big = eye;
	big.width *= 4;
	big.height *= 4;
	big.focal *= 4;
	draw(keys, &eye, SAMPLES);
	draw(fine, &big, 1);
	u32 n = 0;
	for (u32 i = 0; i < SAMPLES * N_PIXELS; i++) {
		u32 k = i / N_PIXELS, x = i % WIDTH, y = i % N_PIXELS / WIDTH;
		u64 other = fine[(size_t)(4 * y + row(k)) * big.width + 4 * x + column(k)];
		n += depths ? keys[i] != other : (u32)keys[i] != (u32)other;
	}
	return n;
}

static void samples_are_pixels_of_a_finer_picture(void **state)
{
	(void)state;
	u32 n = 0;
	for (u32 k = 0; k < 20; k++) {
		make_soup(true);
		assert_int_equal(n_different(true), 0);
		make_soup(false);
		n += n_different(false);
	}
	assert_true(n < 20 * SAMPLES * N_PIXELS / 200); /* corners are snapped to 1/256 pixel, and to 1/1024 */
}

/* Of a mirror that faces the eye at depth 2: z / f from pixel to pixel, half of that over a sample's square; its
 * neighbours are those of the same sample. */
static void gradients_span_the_square_of_a_sample(void **state)
{
	(void)state;
	static u32 offset[SAMPLES * N_PIXELS + 1];
	static ts_pixel records[SAMPLES * N_PIXELS];
	small_clear(&scene);
	scene.objects[0].reflector = 0;
	small_add(&scene, seen_at(-200, -200, 2), seen_at(-200, 900, 2), seen_at(900, -200, 2), 0, 0);
	for (u32 samples = 1; samples <= SAMPLES; samples += 3) {
		u32 n = samples * N_PIXELS;
		f32 step = samples == 1 ? 0.0625f : 0.03125f;
		draw(keys, &eye, samples);
		for (u32 i = 0; i <= n; i++) offset[i] = i;
		ts_mirror_pixel_args args = {.scene = small_arrays(&scene),
		                             .view = &eye,
		                             .depth_triangle = keys,
		                             .offset = offset,
		                             .pixels = records,
		                             .samples = samples};
		for (u32 i = 0; i < n; i++) {
			ts_k_mirror_pixel_item(&args, i);
			f32 x = (f32)(i % WIDTH), y = (f32)(i % N_PIXELS / WIDTH);
			x += samples == 1 ? 0.5f : (f32)ts_eye_sample[i / N_PIXELS][0] / 256;
			y += samples == 1 ? 0.5f : (f32)ts_eye_sample[i / N_PIXELS][1] / 256;
			assert_true(records[i].index == i);
			assert_near(records[i].position[0], seen_at(x, y, 2).x, 1e-4);
			assert_near(records[i].position[1], seen_at(x, y, 2).y, 1e-4);
			assert_near(records[i].position_dx[0], step, 1e-4);
			assert_near(records[i].position_dy[1], -step, 1e-4);
		}
	}
}

/* The mean of a pixel's samples in linear light; shown by the gain of what is seen, and without it in the sky. */
static void pixels_show_the_mean_of_their_samples(void **state)
{
	(void)state;
	enum { N = 7 };
	f32 samples[SAMPLES * N * 3], radiance[N * 3];
	u64 seen[SAMPLES * N];
	u8 srgb[N * 3];
	for (u32 n = 0; n < 200; n++) {
		ts_resolve_args args = {.samples = samples,
		                        .depth_triangle = seen,
		                        .radiance = radiance,
		                        .srgb = srgb,
		                        .n_pixels = N,
		                        .exposure = uniform(0.25f, 2),
		                        .gain = n % 2 == 0 ? 1.0f : 8.0f};
		for (u32 i = 0; i < SAMPLES * N * 3; i++) samples[i] = uniform(0, 0.5f);
		for (u32 i = 0; i < SAMPLES * N; i++) seen[i] = below(2) == 0 ? TS_EMPTY : 1;
		for (u32 i = 0; i < N; i++) ts_k_image_resolve_item(&args, i);
		for (u32 i = 0; i < N * 3; i++) {
			double mean = 0, shown = 0;
			for (u32 k = 0; k < SAMPLES; k++) {
				double value = (double)samples[k * N * 3 + i];
				mean += value / SAMPLES;
				shown += value / SAMPLES * (seen[k * N + i / 3] == TS_EMPTY ? 1 : (double)args.gain);
			}
			assert_near(radiance[i], mean, 1e-6);
			assert_true(abs(srgb[i] - (int)ts_srgb_byte((f32)shown * args.exposure)) <= 1);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(the_grid_is_the_standard_rotated_one), seeded_test(samples_have_their_places_in_the_buffers),
		seeded_test(samples_are_pixels_of_a_finer_picture), seeded_test(gradients_span_the_square_of_a_sample),
		seeded_test(pixels_show_the_mean_of_their_samples)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

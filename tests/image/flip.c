/* FLIP by closed forms: equal images, uniform colours, the two that are farthest apart. And what must hold of any two:
 * symmetry, mirroring, transposition, a growing spot, any number of threads. flip.py beside has a second opinion. */
#include <math.h>
#include <omp.h>
#include "image/flip.h"
#include "tests/lcg.h"
#include "tests/model/test.h"
#include "tests/srgb.h"

enum { WIDTH = 37, HEIGHT = 23, N = WIDTH * HEIGHT };

typedef struct {
	uint8_t a[3 * N], b[3 * N];
	float errors[N];
	double mean;
} pair;

static void near(double value, double right, double within) { assert_true(fabs(value - right) <= within); }

static pair *made(void **state)
{
	pair *p = calloc(1, sizeof *p);
	assert_non_null(p);
	*state = p;
	return p;
}

static int release(void **state)
{
	free(*state);
	return 0;
}

static void fill(uint8_t *rgb, uint8_t r, uint8_t g, uint8_t b)
{
	for (int i = 0; i < N; i++) memcpy(rgb + 3 * i, (const uint8_t[3]){r, g, b}, 3);
}

static void scatter(uint8_t *bytes, uint32_t seed)
{
	for (int i = 0; i < 3 * N; i++) bytes[i] = (uint8_t)(lcg_next(&seed) >> 24);
}

static void judge(pair *p, uint32_t width, uint32_t height, double ppd)
{
	assert_int_equal(ts_flip(p->errors, &p->mean, p->a, p->b, width, height, ppd), TS_OK);
	double sum = 0;
	for (int i = 0; i < N; i++) {
		assert_true(p->errors[i] >= 0 && p->errors[i] <= 1.0000001f);
		sum += (double)p->errors[i];
	}
	near(p->mean, sum / N, 1e-7);
}

static void expect_uniform(pair *p, double error)
{
	judge(p, WIDTH, HEIGHT, TS_FLIP_PPD);
	for (int i = 0; i < N; i++) near((double)p->errors[i], error, 3e-5);
}

/* By the L*a*b* of green and blue that tables of sRGB give. */
static double most_apart(void)
{
	const double green[3] = {87.7347, -86.1827 * 0.877347, 83.1793 * 0.877347};
	const double blue[3] = {32.2970, 79.1875 * 0.322970, -107.8602 * 0.322970};
	return pow(green[0] - blue[0] + hypot(green[1] - blue[1], green[2] - blue[2]), 0.7);
}

static double lightness(int code)
{
	double y = (double)srgb_decoded(code / 255.0L);
	return y > 216.0 / 24389 ? 116 * cbrt(y) - 16 : y * 24389 / 27;
}

static void equal_images_have_no_error(void **state)
{
	pair *p = made(state);
	scatter(p->a, 1);
	memcpy(p->b, p->a, sizeof p->b);
	judge(p, WIDTH, HEIGHT, TS_FLIP_PPD);
	for (int i = 0; i < N; i++) assert_true(p->errors[i] == 0.0f);
	assert_true(p->mean == 0);
}

static void green_and_blue_are_farthest_apart(void **state)
{
	pair *p = made(state);
	fill(p->a, 0, 255, 0);
	fill(p->b, 0, 0, 255);
	expect_uniform(p, 1);
}

static void greys_differ_by_their_lightness(void **state)
{
	static const int greys[][2] = {{0, 255}, {0, 1}, {10, 12}, {100, 101}, {128, 160}, {30, 200}};
	pair *p = made(state);
	double most = most_apart();
	for (size_t k = 0; k < sizeof greys / sizeof *greys; k++) {
		double apart = pow(lightness(greys[k][1]) - lightness(greys[k][0]), 0.7) / most;
		fill(p->a, (uint8_t)greys[k][0], (uint8_t)greys[k][0], (uint8_t)greys[k][0]);
		fill(p->b, (uint8_t)greys[k][1], (uint8_t)greys[k][1], (uint8_t)greys[k][1]);
		expect_uniform(p, apart < 0.4 ? 0.95 * apart / 0.4 : 0.95 + 0.05 * (apart - 0.4) / 0.6);
	}
}

/* What flip.py's evaluate gives for these two. */
static void a_second_program_finds_the_same(void **state)
{
	static const int pixels[] = {0, 1, 36, 37, 400, 425, 814, 850};
	static const double ppd[] = {20, 67}, mean[] = {0.843703874, 0.473937442};
	static const double errors[][8] = {
		{0.87172304, 0.9628404, 0.81052225, 0.45494266, 0.62830312, 0.97241348, 0.96369313, 0.7768949},
		{0.58609454, 0.5615559, 0.48193751, 0.405128, 0.42624636, 0.42528381, 0.70179096, 0.64438659}};
	pair *p = made(state);
	scatter(p->a, 2);
	scatter(p->b, 3);
	for (int k = 0; k < 2; k++) {
		judge(p, WIDTH, HEIGHT, ppd[k]);
		near(p->mean, mean[k], 1e-8);
		for (int i = 0; i < 8; i++) near((double)p->errors[pixels[i]], errors[k][i], 1e-7);
	}
}

static void flip_is_symmetric_to_the_bit(void **state)
{
	pair *p = made(state);
	uint8_t kept[3 * N];
	float errors[N];
	scatter(p->a, 2);
	scatter(p->b, 3);
	judge(p, WIDTH, HEIGHT, 20);
	memcpy(errors, p->errors, sizeof errors);
	memcpy(kept, p->a, sizeof kept);
	memcpy(p->a, p->b, sizeof kept);
	memcpy(p->b, kept, sizeof kept);
	judge(p, WIDTH, HEIGHT, 20);
	assert_memory_equal(errors, p->errors, sizeof errors);
}

/* Pixel (x, y) goes to `to`. */
static void move(pair *p, const pair *from, int (*to)(int x, int y))
{
	for (int i = 0; i < N; i++) {
		memcpy(p->a + 3 * to(i % WIDTH, i / WIDTH), from->a + 3 * i, 3);
		memcpy(p->b + 3 * to(i % WIDTH, i / WIDTH), from->b + 3 * i, 3);
	}
}

static int mirrored(int x, int y) { return y * WIDTH + WIDTH - 1 - x; }
static int transposed(int x, int y) { return x * HEIGHT + y; }

static void turned_images_have_turned_errors(void **state)
{
	pair *p = made(state), moved = {.mean = 0};
	scatter(p->a, 4);
	scatter(p->b, 5);
	judge(p, WIDTH, HEIGHT, TS_FLIP_PPD);
	move(&moved, p, mirrored);
	judge(&moved, WIDTH, HEIGHT, TS_FLIP_PPD);
	for (int i = 0; i < N; i++) {
		near((double)p->errors[i], (double)moved.errors[mirrored(i % WIDTH, i / WIDTH)], 1e-6);
	}
	move(&moved, p, transposed);
	judge(&moved, HEIGHT, WIDTH, TS_FLIP_PPD);
	for (int i = 0; i < N; i++) {
		near((double)p->errors[i], (double)moved.errors[transposed(i % WIDTH, i / WIDTH)], 1e-6);
	}
}

static void a_growing_spot_grows_the_error(void **state)
{
	pair *p = made(state);
	double last = 0;
	fill(p->a, 90, 90, 90);
	for (int radius = 0; radius < 10; radius++) {
		fill(p->b, 90, 90, 90);
		for (int i = 0; i < N; i++) {
			int x = i % WIDTH - WIDTH / 2, y = i / WIDTH - HEIGHT / 2;
			if (x * x + y * y <= radius * radius) p->b[3 * i] = 250;
		}
		judge(p, WIDTH, HEIGHT, TS_FLIP_PPD);
		assert_true(p->mean > last);
		last = p->mean;
	}
}

/* A single pixel is seen less from farther away. */
static void a_far_pixel_is_seen_less(void **state)
{
	pair *p = made(state);
	double last = 1;
	fill(p->a, 90, 90, 90);
	fill(p->b, 90, 90, 90);
	p->b[3 * (N / 2)] = 250;
	for (double ppd = 20; ppd < 200; ppd *= 2) {
		judge(p, WIDTH, HEIGHT, ppd);
		assert_true(p->errors[N / 2] < last);
		last = (double)p->errors[N / 2];
	}
}

static void threads_change_no_error(void **state)
{
	pair *p = made(state);
	float errors[N];
	scatter(p->a, 6);
	scatter(p->b, 7);
	omp_set_num_threads(1);
	judge(p, WIDTH, HEIGHT, TS_FLIP_PPD);
	double mean = p->mean;
	memcpy(errors, p->errors, sizeof errors);
	omp_set_num_threads(5);
	judge(p, WIDTH, HEIGHT, TS_FLIP_PPD);
	assert_memory_equal(errors, p->errors, sizeof errors);
	assert_memory_equal(&mean, &p->mean, sizeof mean);
}

/* What is above and below a pixel, farther than the filters reach, does not show: tall images are seen in bands. */
static void rows_far_away_do_not_matter(void **state)
{
	enum { W = 1000, H = 700, REACH = 2, CUT = 46, PPD = 10 };
	(void)state;
	uint8_t *a = malloc(3 * W * H), *b = malloc(3 * W * H);
	float *whole = malloc(W * H * sizeof *whole), *part = malloc(W * (CUT + 2 * REACH) * sizeof *part);
	assert_true(a != NULL && b != NULL && whole != NULL && part != NULL);
	uint32_t seed = 7;
	for (size_t i = 0; i < 3 * W * H; i++) {
		a[i] = (uint8_t)(lcg_next(&seed) >> 24);
		b[i] = (uint8_t)(lcg_next(&seed) >> 24);
	}
	double mean;
	assert_int_equal(ts_flip(whole, &mean, a, b, W, H, PPD), TS_OK);
	for (size_t y = REACH; y + CUT + REACH <= H; y += CUT) {
		const size_t low = 3 * W * (y - REACH);
		assert_int_equal(ts_flip(part, &mean, a + low, b + low, W, CUT + 2 * REACH, PPD), TS_OK);
		assert_memory_equal(whole + W * y, part + W * REACH, W * CUT * sizeof *part);
	}
	free(a);
	free(b);
	free(whole);
	free(part);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test_teardown(equal_images_have_no_error, release),
		cmocka_unit_test_teardown(green_and_blue_are_farthest_apart, release),
		cmocka_unit_test_teardown(greys_differ_by_their_lightness, release),
		cmocka_unit_test_teardown(a_second_program_finds_the_same, release),
		cmocka_unit_test_teardown(flip_is_symmetric_to_the_bit, release),
		cmocka_unit_test_teardown(turned_images_have_turned_errors, release),
		cmocka_unit_test_teardown(a_growing_spot_grows_the_error, release),
		cmocka_unit_test_teardown(a_far_pixel_is_seen_less, release),
		cmocka_unit_test_teardown(threads_change_no_error, release),
		cmocka_unit_test(rows_far_away_do_not_matter),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

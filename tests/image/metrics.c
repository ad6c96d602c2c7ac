/* Image metrics against closed forms, and SSIM against its definition written out window by window. */
#include <math.h>
#include <touchstone/image.h>
#include "tests/lcg.h"
#include "tests/model/test.h"

enum { WIDTH = 83, HEIGHT = 29, PIXELS = WIDTH * HEIGHT };

static uint8_t reference[PIXELS * 3], image[PIXELS * 3], mask[PIXELS];
static uint32_t seed = 1;

static uint32_t next(void) { return lcg_next(&seed) >> 16; }

static int set_up(void **state)
{
	(void)state;
	for (size_t i = 0; i < sizeof reference; i++) {
		reference[i] = (uint8_t)(next() & 255);
		image[i] = (uint8_t)(reference[i] / 2 + (next() & 127));
	}
	for (size_t i = 0; i < PIXELS; i++) mask[i] = next() % 3 == 0;
	return 0;
}

static void assert_close(double a, double b)
{
	if (!(fabs(a - b) <= 1e-9 * fmax(1, fabs(b)))) fail_msg("%.17g is not %.17g", a, b);
}

static double luma(const uint8_t *rgb) { return 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2]; }

/* One window by its definition: weighted means, then central moments. */
static double window(uint32_t x, uint32_t y)
{
	double total = 0, mean[2] = {0}, var[2] = {0}, cov = 0;
	for (int pass = 0; pass < 2; pass++) {
		for (int j = -5; j <= 5; j++) {
			for (int i = -5; i <= 5; i++) {
				size_t at = ((y + (size_t)(j + 5) - 5) * WIDTH + x + (size_t)(i + 5) - 5) * 3;
				double w = exp(-(i * i + j * j) / 4.5), a = luma(reference + at), b = luma(image + at);
				if (pass == 0) {
					total += w;
					mean[0] += w * a;
					mean[1] += w * b;
				} else {
					var[0] += w * (a - mean[0]) * (a - mean[0]) / total;
					var[1] += w * (b - mean[1]) * (b - mean[1]) / total;
					cov += w * (a - mean[0]) * (b - mean[1]) / total;
				}
			}
		}
		for (int k = 0; k < 2 && pass == 0; k++) mean[k] /= total;
	}
	const double c1 = 6.5025, c2 = 58.5225;
	return (2 * mean[0] * mean[1] + c1) * (2 * cov + c2) /
	       ((mean[0] * mean[0] + mean[1] * mean[1] + c1) * (var[0] + var[1] + c2));
}

static void metrics_follow_their_definition(void **state)
{
	(void)state;
	for (int masked = 0; masked < 2; masked++) {
		double squares = 0, similar = 0;
		uint64_t pixels = 0, windows = 0;
		for (uint32_t y = 0; y < HEIGHT; y++) {
			for (uint32_t x = 0; x < WIDTH; x++) {
				size_t at = (size_t)y * WIDTH + x;
				if (masked && !mask[at]) continue;
				pixels++;
				for (size_t c = 3 * at; c < 3 * at + 3; c++) squares += pow(reference[c] - image[c], 2);
				if (x < 5 || y < 5 || x + 5 >= WIDTH || y + 5 >= HEIGHT) continue;
				similar += window(x, y);
				windows++;
			}
		}
		ts_metrics m = ts_metrics_compare(reference, image, masked ? mask : NULL, WIDTH, HEIGHT);
		assert_int_equal(m.pixels, pixels);
		assert_close(m.rmse, sqrt(squares / (double)(3 * pixels)));
		assert_close(m.psnr, 10 * log10(255 * 255 / (squares / (double)(3 * pixels))));
		assert_close(m.ssim, similar / (double)windows);
	}
}

static void equal_images_are_infinitely_alike(void **state)
{
	(void)state;
	ts_metrics m = ts_metrics_compare(reference, reference, NULL, WIDTH, HEIGHT);
	assert_true(m.rmse == 0 && isinf(m.psnr) && m.psnr > 0);
	assert_close(m.ssim, 1);
}

/* Flat images: no variance, so SSIM is the luminance term alone; also where no whole window fits. */
static void flat_images_have_the_luminance_term_alone(void **state)
{
	(void)state;
	static const uint32_t sizes[][2] = {{WIDTH, HEIGHT}, {1, 1}, {7, 20}};
	static const int greys[][2] = {{100, 110}, {1, 3}};
	static uint8_t a[PIXELS * 3], b[PIXELS * 3];
	for (size_t i = 0; i < 6; i++) {
		int x = greys[i / 3][0], y = greys[i / 3][1];
		memset(a, x, sizeof a);
		memset(b, y, sizeof b);
		ts_metrics m = ts_metrics_compare(a, b, NULL, sizes[i % 3][0], sizes[i % 3][1]);
		assert_close(m.rmse, y - x);
		assert_close(m.psnr, 20 * log10(255.0 / (y - x)));
		assert_close(m.ssim, (2 * x * y + 6.5025) / (x * x + y * y + 6.5025));
	}
}

/* What is not judged has no say in RMSE; nothing judged is no difference. */
static void masked_pixels_have_no_say(void **state)
{
	(void)state;
	uint8_t only[PIXELS] = {0};
	only[0] = 1;
	ts_metrics m = ts_metrics_compare(reference, image, only, WIDTH, HEIGHT);
	double squares = 0;
	for (size_t c = 0; c < 3; c++) squares += pow(reference[c] - image[c], 2);
	assert_int_equal(m.pixels, 1);
	assert_close(m.rmse, sqrt(squares / 3));
	assert_true(m.ssim < 1);
	only[0] = 0;
	m = ts_metrics_compare(reference, image, only, WIDTH, HEIGHT);
	assert_true(m.pixels == 0 && m.rmse == 0 && m.ssim == 1);
}

static double relative(const float *light, const float *other, const uint8_t *judged)
{
	return ts_metrics_light(light, other, judged, WIDTH, HEIGHT).relative;
}

/* Light scaled by k is |k - 1| times its root mean square away, by its mean; a constant that is added, by the mean. */
static void scaled_light_is_apart_by_its_scale(void **state)
{
	(void)state;
	static float light[PIXELS * 3], scaled[PIXELS * 3], raised[PIXELS * 3], dark[PIXELS * 3];
	double sum = 0, squares = 0;
	uint64_t n = 0;
	for (size_t i = 0; i < PIXELS * 3; i++) {
		light[i] = reference[i] / 16.0f; /* exact, and so are the others */
		scaled[i] = 1.25f * light[i];
		raised[i] = light[i] + 0.5f;
		if (mask[i / 3]) {
			n++;
			sum += light[i];
			squares += light[i] * light[i];
		} else {
			scaled[i] = raised[i] = -1e6f;
		}
	}
	double mean = sum / (double)n, root = sqrt(squares / (double)n);
	assert_close(relative(light, scaled, mask), 0.25 * root / mean);
	assert_close(relative(light, raised, mask), 0.5 / mean);
	assert_true(relative(light, raised, NULL) > 1e3);
	assert_true(relative(light, light, NULL) == 0);
	assert_true(isinf(relative(dark, light, mask)));
	memset(mask, 0, sizeof mask);
	assert_true(relative(light, scaled, mask) == 0);
}

static int by_size(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;
	return (x > y) - (x < y);
}

/* Beside sorted errors in doubles; of two in the middle the lower is the median. A pixel of light that the reference
 * has not is infinitely wrong. */
static void errors_of_light_match_sorted_ones(void **state)
{
	(void)state;
	static float light[PIXELS * 3], other[PIXELS * 3];
	static double errors[PIXELS];
	for (size_t n_dark = 0; n_dark <= 2000; n_dark += 1000) {
		size_t beyond = 0, n_unlit = 0;
		double squares = 0, unlit = 0, lit = 0;
		for (size_t i = 0; i < PIXELS; i++) {
			double apart = 0, sum = 0;
			for (size_t c = 3 * i; c < 3 * i + 3; c++) {
				light[c] = i < n_dark ? 0 : 1 + (float)(next() & 1023) / 64;
				other[c] = i % 7 == 0 ? light[c] : light[c] + (float)(next() & 255) / 256;
				apart += fabs((double)other[c] - (double)light[c]);
				sum += (double)light[c];
				unlit += i < n_dark ? (double)other[c] : 0;
				squares += pow((double)other[c] - (double)light[c], 2);
			}
			errors[i] = apart > 0 ? apart / sum : 0;
			beyond += errors[i] > 0.1;
			lit += sum;
			n_unlit += i < n_dark && i % 7 != 0;
		}
		qsort(errors, PIXELS, sizeof *errors, by_size);
		ts_light_metrics m = ts_metrics_light(light, other, NULL, WIDTH, HEIGHT);
		double median = errors[(PIXELS - 1) / 2];
		assert_true(isinf(median) ? isinf(m.median) : fabs(m.median - median) <= 1e-7 * median);
		assert_true(isinf(median) == (n_dark == 2000) && median > 0);
		assert_close(m.beyond, (double)beyond / PIXELS);
		assert_close(m.squares, squares);
		assert_int_equal(m.pixels, PIXELS);
		assert_int_equal(m.unlit, n_unlit);
		assert_close(m.given, n_unlit > 0 ? unlit / (double)n_unlit / (lit / PIXELS) : 0);
	}
}

/* Pixels that are not judged count for nothing; of two the better is the median; one that is dark in both is right. */
static void masked_errors_count_for_nothing(void **state)
{
	(void)state;
	const float light[] = {1, 1, 2, 9, 9, 9, 2, 2, 0, 0, 0, 0}, other[] = {1, 1.2f, 2, 0, 0, 0, 2, 2, 2, 0, 0, 0};
	const uint8_t judged[] = {1, 0, 1, 0}, last[] = {0, 0, 0, 1}, none[4] = {0};
	ts_light_metrics m = ts_metrics_light(light, other, judged, 2, 2);
	assert_true(m.pixels == 2 && fabs(m.median - 0.05) < 1e-7 && m.beyond == 0.5);
	m = ts_metrics_light(light, other, last, 2, 2);
	assert_true(m.pixels == 1 && m.median == 0 && m.beyond == 0 && m.relative == 0);
	m = ts_metrics_light(light, other, none, 2, 2);
	assert_true(m.pixels == 0 && m.median == 0 && m.beyond == 0 && m.squares == 0);
}

/* One dark pixel amid light is a crumb in the image, and none in what the image is compared with. */
static void a_lone_dark_pixel_is_a_crumb(void **state)
{
	(void)state;
	float light[75], other[75];
	uint8_t marks[25];
	for (int i = 0; i < 75; i++) light[i] = other[i] = 0.5f;
	assert_int_equal(ts_metrics_crumbs(marks, light, other, 5, 5), 0);
	other[3 * 12 + 1] = 0.35f;
	assert_int_equal(ts_metrics_crumbs(marks, light, other, 5, 5), 1);
	for (int i = 0; i < 25; i++) assert_int_equal(marks[i], i == 12);
	assert_int_equal(ts_metrics_crumbs(NULL, other, light, 5, 5), 0);
	light[3 * 11 + 1] = 0.4f;
	assert_int_equal(ts_metrics_crumbs(marks, light, other, 5, 5), 0);
	for (int c = 0; c < 3; c++) other[c] = 0.7f; /* in a corner, all channels */
	other[3 * 24 + 2] = 0.61f;
	assert_int_equal(ts_metrics_crumbs(marks, light, other, 5, 5), 2);
	light[3 * 5] = light[3 * 5 + 1] = light[3 * 5 + 2] = 0.7f; /* below the corner */
	light[3 * 20 + 2] = 1.0f;                                  /* no neighbour of the last corner */
	assert_int_equal(ts_metrics_crumbs(marks, light, other, 5, 5), 1);
}

/* A border has no neighbour beyond: the last pixel of the row before is none. */
static void a_border_has_no_neighbour_beyond(void **state)
{
	(void)state;
	float light[75], other[75];
	static const struct {
		int x, y, no_neighbour;
	} cases[] = {{0, 2, 9}, {4, 2, 15}, {0, 0, 24}, {4, 4, 0}, {0, 4, 19}, {4, 0, 5}};
	for (int k = 0; k < 6; k++) {
		int at = 3 * (5 * cases[k].y + cases[k].x);
		for (int i = 0; i < 75; i++) light[i] = other[i] = 0.5f;
		other[at] = 0.8f;
		light[3 * cases[k].no_neighbour] = other[3 * cases[k].no_neighbour] = 0.8f;
		assert_int_equal(ts_metrics_crumbs(NULL, light, other, 5, 5), 1);
	}
}

/* An image that changes as much as its reference does not flicker, whichever way it goes; the excess counts, where the
 * mask is set. */
static void only_excess_change_is_flicker(void **state)
{
	(void)state;
	static uint8_t black[PIXELS * 3], later[PIXELS * 3], image_later[PIXELS * 3];
	double squares = 0, judged = 0, n = 0, n_judged = 0;
	set_up(NULL);
	for (size_t i = 0; i < sizeof reference; i++) {
		later[i] = (uint8_t)(next() & 255);
		image_later[i] = (uint8_t)(next() & 255);
		double beyond = fmax(0, fabs((double)image_later[i] - image[i]) - fabs((double)later[i] - reference[i]));
		squares += beyond * beyond;
		n++;
		judged += mask[i / 3] ? beyond * beyond : 0;
		n_judged += mask[i / 3] ? 1 : 0;
	}
	assert_close(ts_metrics_flicker(reference, later, image, image_later, NULL, WIDTH, HEIGHT), sqrt(squares / n));
	assert_close(ts_metrics_flicker(reference, later, image, image_later, mask, WIDTH, HEIGHT),
	             sqrt(judged / n_judged));
	assert_close(ts_metrics_flicker(reference, later, reference, later, NULL, WIDTH, HEIGHT), 0);
	assert_close(ts_metrics_flicker(reference, later, later, reference, NULL, WIDTH, HEIGHT), 0);
	assert_close(ts_metrics_flicker(black, black, black, image, NULL, WIDTH, HEIGHT),
	             ts_metrics_compare(black, image, NULL, WIDTH, HEIGHT).rmse);
	assert_close(ts_metrics_flicker(reference, later, image, image_later, black, WIDTH, HEIGHT), 0);
}

enum { DRAWS = 400 };

/* A better image, and noise about it as what stands for it has. */
static uint8_t better[PIXELS * 3], chosen[PIXELS];

static void make_better(void)
{
	for (size_t i = 0; i < PIXELS; i++) {
		int rare = next() % 16 == 0 ? 40 : 2;
		for (size_t c = 3 * i; c < 3 * i + 3; c++) {
			better[c] = (uint8_t)(reference[c] / 2 + 20 + next() % (uint32_t)rare);
			image[c] = (uint8_t)(better[c] + next() % (uint32_t)rare);
		}
	}
}

static ts_metrics estimate(const uint8_t *of)
{
	const ts_metrics_part part = {reference, image, reference, better, chosen};
	return ts_metrics_estimate(&part, of, WIDTH, HEIGHT);
}

static void an_estimate_of_all_is_exact(void **state)
{
	(void)state;
	make_better();
	memset(chosen, 1, sizeof chosen);
	ts_metrics all = ts_metrics_compare(reference, better, mask, WIDTH, HEIGHT), m = estimate(mask);
	assert_close(m.rmse, all.rmse);
	assert_close(m.psnr, all.psnr);
	assert_int_equal(m.pixels, all.pixels);
	assert_true(m.rmse_error == 0 && isnan(m.ssim));
	memset(chosen, 0, sizeof chosen);
	m = estimate(NULL);
	assert_close(m.rmse, ts_metrics_compare(reference, image, NULL, WIDTH, HEIGHT).rmse);
	assert_true(isnan(m.rmse_error));
}

/* One in eight pixels: over many draws the estimate is right in the mean, and the errors are as large as it says. */
static void an_estimate_is_right_on_average(void **state)
{
	(void)state;
	make_better();
	double rmse = ts_metrics_compare(reference, better, NULL, WIDTH, HEIGHT).rmse, sum = 0, squares = 0, least = 0;
	for (int k = 0; k < DRAWS; k++) {
		for (size_t i = 0; i < PIXELS; i++) chosen[i] = next() % 8 == 0;
		ts_metrics m = estimate(NULL);
		double z = (m.rmse - rmse) / m.rmse_error;
		sum += z;
		squares += z * z;
		least = fmax(least, m.rmse_error / rmse);
	}
	print_message("mean of z %.3f, of its square %.3f, greatest error %.4f\n", sum / DRAWS, squares / DRAWS, least);
	assert_true(fabs(sum / DRAWS) < 0.25);
	assert_true(squares / DRAWS > 0.7 && squares / DRAWS < 1.4);
	assert_true(least > 0 && least < 0.1);
}

/* Six pixels of which three are chosen: the line through what these have, in closed form; and where all of them have
 * the same of the coarse picture the error is still a number. */
static void an_estimate_follows_its_closed_form(void **state)
{
	(void)state;
	static const uint8_t zero[18], here[18] = {[6] = 1, [9] = 1, [12] = 1, [15] = 1}, right[18] = {[6] = 2};
	static const uint8_t three[6] = {1, 1, 1}, same[18] = {1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 3},
						 spread[18] = {[3] = 1, [6] = 2};
	const ts_metrics_part line = {zero, here, zero, right, three}, level = {zero, same, zero, spread, three};
	ts_metrics m = ts_metrics_estimate(&line, NULL, 6, 1);
	assert_close(m.rmse, sqrt((4.0 / 3 + 4 * (4.0 / 6 - 1.0 / 3)) / 3));
	m = ts_metrics_estimate(&level, NULL, 6, 1);
	double mean = 5.0 / 3 + (13.0 / 6 - 1), left = 17 - 25.0 / 3, error = sqrt(left / 6);
	assert_close(m.rmse, sqrt(mean / 3));
	assert_close(m.rmse_error, sqrt(mean / 3 + error / 3) - sqrt(mean / 3));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(metrics_follow_their_definition),
		cmocka_unit_test(equal_images_are_infinitely_alike),
		cmocka_unit_test(flat_images_have_the_luminance_term_alone),
		cmocka_unit_test(masked_pixels_have_no_say),
		cmocka_unit_test(scaled_light_is_apart_by_its_scale),
		cmocka_unit_test(errors_of_light_match_sorted_ones),
		cmocka_unit_test(masked_errors_count_for_nothing),
		cmocka_unit_test(a_lone_dark_pixel_is_a_crumb),
		cmocka_unit_test(a_border_has_no_neighbour_beyond),
		cmocka_unit_test(only_excess_change_is_flicker),
		cmocka_unit_test(an_estimate_of_all_is_exact),
		cmocka_unit_test(an_estimate_is_right_on_average),
		cmocka_unit_test(an_estimate_follows_its_closed_form),
	};
	return cmocka_run_group_tests(tests, set_up, NULL);
}

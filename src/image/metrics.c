/* How far apart two images are (METHODS 17): RMSE and PSNR over 8-bit values, SSIM of Wang et al. 2004 ("Image quality
 * assessment: from error visibility to structural similarity") with its 11 by 11 Gaussian of sigma 1.5 over luma. For
 * light: the RMSE divided by the mean, and crumbs along edges. For frames: their flicker. Sums run left to right, top
 * to bottom. */
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <touchstone/image.h>
#include "model/core.h"

enum { TAPS = 11, REACH = TAPS / 2, BLOCK = 64, SPAN = BLOCK + 2 * REACH, N_SUMS = 5 };

typedef struct {
	const uint8_t *reference, *image, *mask;
	uint32_t width, height;
	double weight[TAPS];
} pair;

/* Over the window: x, y, x x, y y, x y. */
typedef struct {
	double sum[N_SUMS];
} moments;

static double luma(const uint8_t *rgb) { return 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2]; }

static bool is_judged(const pair *p, uint32_t x, uint32_t y) { return !p->mask || p->mask[(size_t)y * p->width + x]; }

static bool fits(uint32_t at, uint32_t size) { return at >= REACH && at + REACH < size; }

/* The column x of windows centred on row y; rows outside the image weigh nothing. */
static moments column(const pair *p, uint32_t x, uint32_t y)
{
	moments m = {{0}};
	double total = 0;
	for (int k = 0; k < TAPS; k++) {
		int64_t row = (int64_t)y + k - REACH;
		if (row < 0 || row >= p->height) continue;
		size_t at = ((size_t)row * p->width + x) * 3;
		double a = luma(p->reference + at), b = luma(p->image + at), w = p->weight[k];
		double term[N_SUMS] = {a, b, a * a, b * b, a * b};
		for (int i = 0; i < N_SUMS; i++) m.sum[i] += w * term[i];
		total += w;
	}
	for (int i = 0; i < N_SUMS; i++) m.sum[i] /= total;
	return m;
}

static double similarity(const pair *p, const moments *columns, uint32_t x)
{
	const double c1 = (0.01 * 255) * (0.01 * 255), c2 = (0.03 * 255) * (0.03 * 255);
	double s[N_SUMS] = {0}, total = 0;
	for (int k = 0; k < TAPS; k++) {
		int64_t at = (int64_t)x + k - REACH;
		if (at < 0 || at >= p->width) continue;
		for (int i = 0; i < N_SUMS; i++) s[i] += p->weight[k] * columns[k].sum[i];
		total += p->weight[k];
	}
	for (int i = 0; i < N_SUMS; i++) s[i] /= total;
	double var_a = s[2] - s[0] * s[0], var_b = s[3] - s[1] * s[1], cov = s[4] - s[0] * s[1];
	return ((2 * s[0] * s[1] + c1) * (2 * cov + c2)) / ((s[0] * s[0] + s[1] * s[1] + c1) * (var_a + var_b + c2));
}

/* Sums over the judged centres of BLOCK columns of row y. */
static void add_block(const pair *p, uint32_t first, uint32_t y, bool whole, double *sum, uint64_t *n)
{
	moments columns[SPAN];
	uint32_t end = first + BLOCK < p->width ? first + BLOCK : p->width;
	for (int i = 0; i < SPAN; i++) {
		int64_t x = (int64_t)first + i - REACH;
		if (x >= 0 && x < p->width) columns[i] = column(p, (uint32_t)x, y);
	}
	for (uint32_t x = first; x < end; x++) {
		if (!is_judged(p, x, y) || (whole && !fits(x, p->width))) continue;
		*sum += similarity(p, columns + (x - first), x);
		++*n;
	}
}

/* Mean over the judged centres: of windows within the image if `whole`, otherwise of all, cut at the border. */
static bool mean_similarity(const pair *p, bool whole, double *mean)
{
	double sum = 0;
	uint64_t n = 0;
	for (uint32_t y = 0; y < p->height; y++) {
		if (whole && !fits(y, p->height)) continue;
		for (uint32_t x = 0; x < p->width; x += BLOCK) add_block(p, x, y, whole, &sum, &n);
	}
	if (n > 0) *mean = sum / (double)n;
	return n > 0;
}

static void set_weights(pair *p)
{
	double total = 0;
	for (int k = 0; k < TAPS; k++) total += p->weight[k] = exp(-(k - REACH) * (k - REACH) / (2 * 1.5 * 1.5));
	for (int k = 0; k < TAPS; k++) p->weight[k] /= total;
}

static ts_metrics compare(const uint8_t *reference, const uint8_t *image, const uint8_t *mask, uint32_t width,
                          uint32_t height)
{
	if (reference == NULL || image == NULL) width = height = 0;
	pair p = {.reference = reference, .image = image, .mask = mask, .width = width, .height = height};
	ts_metrics m = {.ssim = 1};
	uint64_t squares = 0;
	for (uint32_t y = 0; y < height; y++) {
		for (uint32_t x = 0; x < width; x++) {
			if (!is_judged(&p, x, y)) continue;
			size_t at = ((size_t)y * width + x) * 3;
			m.pixels++;
			for (size_t c = at; c < at + 3; c++) {
				int d = reference[c] - image[c];
				squares += (uint64_t)(d * d);
			}
		}
	}
	if (m.pixels > 0) m.rmse = sqrt((double)squares / (3.0 * (double)m.pixels));
	m.psnr = squares > 0 ? 20 * log10(255 / m.rmse) : INFINITY;
	set_weights(&p);
	if (!mean_similarity(&p, true, &m.ssim)) mean_similarity(&p, false, &m.ssim);
	return m;
}

ts_metrics ts_metrics_compare(const uint8_t *reference, const uint8_t *image, const uint8_t *mask, uint32_t width,
                              uint32_t height)
{
	ts_floats_hold(1);
	const ts_metrics found = compare(reference, image, mask, width, height);
	ts_floats_give();
	return found;
}

/* The growth of the square root when its argument grows by `error`. */
static double root_error(double square, double error) { return sqrt(square + error) - sqrt(square); }

static double squares_of(const uint8_t *a, const uint8_t *b)
{
	int sum = 0;
	for (int c = 0; c < 3; c++) sum += (a[c] - b[c]) * (a[c] - b[c]);
	return sum;
}

/* Sums over pixels of squared differences: x of all; x, and y of the better picture, of the chosen pixels. */
typedef struct {
	double n_all, x_all, xx_all, n, x, y, xx, xy, yy;
} pairs;

static void add_all(pairs *p, double x)
{
	p->n_all++;
	p->x_all += x;
	p->xx_all += x * x;
}

static void add_chosen(pairs *p, double x, double y)
{
	p->n++;
	p->x += x;
	p->y += y;
	p->xx += x * x;
	p->xy += x * y;
	p->yy += y * y;
}

/* The regression estimator of the mean of y (Cochran 1977, Sampling Techniques, 7.1): the chosen pixels' mean, moved
 * along y = b x to the mean of x over all. Its error is the residual from the line, with the error of b. Where x varies
 * less among the chosen pixels than among all, y will as well, and the error grows in proportion. */
static double regression(const pairs *p, double *error)
{
	*error = NAN;
	if (p->n == 0) return p->x_all / p->n_all;
	double x = p->x / p->n, y = p->y / p->n, x_all = p->x_all / p->n_all;
	double xx = p->xx - p->n * x * x, xy = p->xy - p->n * x * y, yy = p->yy - p->n * y * y;
	double varies = p->xx_all / p->n_all - x_all * x_all, varies_here = xx / p->n;
	double b = p->n > 2 && xx > 0 ? xy / xx : 1, left = fmax(yy - 2 * b * xy + b * b * xx, 0) / (p->n - 2);
	if (varies_here > 0) left *= fmax(varies / varies_here, 1);
	double apart = xx > 0 ? (x_all - x) * (x_all - x) / xx : 0;
	if (p->n > 2) *error = sqrt(left * ((1 - p->n / p->n_all) / p->n + apart));
	return fmax(y + b * (x_all - x), 0);
}

static bool is_whole(const ts_metrics_part *part)
{
	return part->reference != NULL && part->image != NULL && part->all_reference != NULL && part->all_image != NULL &&
	       part->chosen != NULL;
}

static ts_metrics estimate(const ts_metrics_part *part, const uint8_t *mask, uint32_t width, uint32_t height)
{
	pairs p = {.n = 0};
	ts_metrics m = {.psnr = INFINITY, .ssim = NAN};
	if (part == NULL || !is_whole(part)) return m;
	for (size_t i = 0; i < (size_t)width * height; i++) {
		if (mask && !mask[i]) continue;
		add_all(&p, squares_of(part->reference + 3 * i, part->image + 3 * i));
		if (!part->chosen[i]) continue;
		add_chosen(&p, squares_of(part->reference + 3 * i, part->image + 3 * i),
		           squares_of(part->all_reference + 3 * i, part->all_image + 3 * i));
	}
	m.pixels = (uint64_t)p.n_all;
	if (m.pixels == 0) return m;
	double error, square = regression(&p, &error) / 3;
	m.rmse = sqrt(square);
	m.rmse_error = root_error(square, error / 3);
	if (square > 0) m.psnr = 20 * log10(255 / m.rmse);
	return m;
}

ts_metrics ts_metrics_estimate(const ts_metrics_part *part, const uint8_t *mask, uint32_t width, uint32_t height)
{
	ts_floats_hold(1);
	const ts_metrics found = estimate(part, mask, width, height);
	ts_floats_give();
	return found;
}

double ts_metrics_flicker(const uint8_t *reference_before, const uint8_t *reference, const uint8_t *image_before,
                          const uint8_t *image, const uint8_t *mask, uint32_t width, uint32_t height)
{
	uint64_t squares = 0, n = 0;
	if (reference_before == NULL || reference == NULL || image_before == NULL || image == NULL) return 0;
	for (size_t i = 0; i < (size_t)width * height; i++) {
		if (mask && !mask[i]) continue;
		n++;
		for (size_t c = 3 * i; c < 3 * i + 3; c++) {
			int beyond = abs(image[c] - image_before[c]) - abs(reference[c] - reference_before[c]);
			if (beyond > 0) squares += (uint64_t)(beyond * beyond);
		}
	}
	return n > 0 ? sqrt((double)squares / (3.0 * (double)n)) : 0;
}

/* The error of a pixel of light. */
static float error_of(const float *reference, const float *image)
{
	double apart = 0, light = 0;
	for (int c = 0; c < 3; c++) {
		apart += fabs((double)image[c] - (double)reference[c]);
		light += (double)reference[c];
	}
	return apart > 0 ? (float)(apart / light) : 0;
}

/* Errors are at least 0, so their bits sort like them: the bits of the median are found 8 at a time. */
static double median_error(const float *reference, const float *image, const uint8_t *mask, size_t end, uint64_t n)
{
	uint64_t rank = (n + 1) / 2;
	uint32_t found = 0;
	for (int shift = 24; shift >= 0; shift -= 8) {
		uint64_t count[256] = {0};
		uint32_t bits, at = 0;
		for (size_t i = 0; i < end; i++) {
			float error = !mask || mask[i] ? error_of(reference + 3 * i, image + 3 * i) : 0;
			memcpy(&bits, &error, sizeof bits);
			bool goes_on = (uint64_t)bits >> (shift + 8) == (uint64_t)found >> (shift + 8);
			if ((!mask || mask[i]) && goes_on) count[bits >> shift & 255]++;
		}
		while (count[at] < rank) rank -= count[at++];
		found |= at << shift;
	}
	float median;
	memcpy(&median, &found, sizeof median);
	return (double)median;
}

static double sum_of(const float *light) { return (double)light[0] + (double)light[1] + (double)light[2]; }

/* Sums over the judged pixels. */
typedef struct {
	double reference, unlit; /* the image's light in pixels where the reference has none */
	uint64_t beyond;
} light_sums;

static light_sums add_light(ts_light_metrics *m, const float *reference, const float *image, const uint8_t *mask,
                            size_t end)
{
	light_sums sums = {0};
	for (size_t i = 0; i < end; i++) {
		if (mask && !mask[i]) continue;
		double light = sum_of(reference + 3 * i), other = sum_of(image + 3 * i);
		bool unlit = light <= 0 && other > 0;
		m->pixels++;
		m->unlit += unlit;
		sums.beyond += error_of(reference + 3 * i, image + 3 * i) > 0.1f;
		sums.reference += light;
		sums.unlit += unlit ? other : 0;
		for (size_t c = 3 * i; c < 3 * i + 3; c++) {
			double d = (double)image[c] - (double)reference[c];
			m->squares += d * d;
		}
	}
	return sums;
}

static ts_light_metrics judge_light(const float *reference, const float *image, const uint8_t *mask, uint32_t width,
                                    uint32_t height)
{
	if (reference == NULL || image == NULL) width = height = 0;
	ts_light_metrics m = {0};
	size_t end = (size_t)width * height;
	light_sums sums = add_light(&m, reference, image, mask, end);
	if (m.pixels == 0) return m;
	double n = (double)m.pixels, mean = sums.reference / n;
	m.relative = m.squares > 0 ? sqrt(m.squares / (3 * n)) / (mean / 3) : 0;
	m.median = median_error(reference, image, mask, end, m.pixels);
	m.beyond = (double)sums.beyond / n;
	m.given = m.unlit > 0 ? sums.unlit / (double)m.unlit / mean : 0;
	return m;
}

ts_light_metrics ts_metrics_light(const float *reference, const float *image, const uint8_t *mask, uint32_t width,
                                  uint32_t height)
{
	ts_floats_hold(1);
	const ts_light_metrics found = judge_light(reference, image, mask, width, height);
	ts_floats_give();
	return found;
}

/* Beyond the reference's range in a channel at the pixel and its neighbours. */
static bool is_beyond(const float *reference, const float *image, uint32_t x, uint32_t y, int c, uint32_t width,
                      uint32_t height)
{
	const double margin = 0.1;
	size_t at = ((size_t)y * width + x) * 3 + (size_t)c, row = (size_t)width * 3;
	double value = (double)image[at], least = (double)reference[at], most = least;
	const size_t beside[4] = {x > 0 ? at - 3 : at, x + 1 < width ? at + 3 : at, y > 0 ? at - row : at,
	                          y + 1 < height ? at + row : at};
	for (int i = 0; i < 4; i++) {
		least = fmin(least, (double)reference[beside[i]]);
		most = fmax(most, (double)reference[beside[i]]);
	}
	return value < least - margin || value > most + margin;
}

static uint64_t count_crumbs(uint8_t *marks, const float *reference, const float *image, uint32_t width,
                             uint32_t height)
{
	if (reference == NULL || image == NULL) return 0;
	uint64_t n = 0;
	for (uint32_t y = 0; y < height; y++) {
		for (uint32_t x = 0; x < width; x++) {
			bool crumb = false;
			for (int c = 0; c < 3; c++) crumb |= is_beyond(reference, image, x, y, c, width, height);
			if (marks) marks[(size_t)y * width + x] = crumb;
			n += crumb;
		}
	}
	return n;
}

uint64_t ts_metrics_crumbs(uint8_t *marks, const float *reference, const float *image, uint32_t width, uint32_t height)
{
	ts_floats_hold(1);
	const uint64_t found = count_crumbs(marks, reference, image, width, height);
	ts_floats_give();
	return found;
}

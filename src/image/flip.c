/* LDR-FLIP (flip.h). All filters are products of one along rows and one along columns; the border's pixels are repeated
 * beyond it. An image is seen in bands of rows, each with the rows beside it that the filters reach, so that memory
 * does not grow with its height. */
#include "image/flip.h"
#include <math.h>
#include <stdlib.h>
#include "model/core.h"

enum { MOST_REACH = 136, N_PLANES = 13, LEAST_BAND = 64 };

static const double pi = 3.14159265358979323846;
/* The paper's constants: exponent and bend of colour differences; width of edges in degrees, and their exponent. */
static const double q_c = 0.7, p_c = 0.4, p_t = 0.95, edge_width = 0.082, q_f = 0.5;
/* Linear sRGB to XYZ, from the primaries and the white of IEC 61966-2-1, and back; the white is the sum of a row. */
static const double xyz_of_rgb[3][3] = {
	{0.4123907992659592, 0.357584339383878, 0.1804807884018343},
	{0.2126390058715102, 0.715168678767756, 0.07219231536073371},
	{0.01933081871559182, 0.119194779794626, 0.9505321522496607},
};
static const double rgb_of_xyz[3][3] = {
	{3.240969941904523, -1.537383177570094, -0.4986107602930036},
	{-0.9692436362808797, 1.87596750150772, 0.04155505740717563},
	{0.05563007969699364, -0.2039769588889765, 1.056971514242879},
};

typedef struct {
	int reach;
	double tap[2 * MOST_REACH + 1];
} filter;

typedef struct {
	uint32_t width, height;                       /* of the band, with the rows beside it */
	filter achromatic, red_green, blue_yellow[2]; /* contrast sensitivity */
	double share[2];                              /* of the two blue-yellow filters */
	filter smooth, edge, point;                   /* features */
	double *work[3];
} lens;

/* Planes of an image: YCxCz, later L*a*b* as an observer sees it; and the strength of features. */
typedef struct {
	double *colour[3], *edge, *point;
} seen;

/* ---- filters ---- */

/* exp(-rate x^2), scaled to a sum of 1; returns the sum before. */
static double make_gaussian(filter *f, int reach, double rate)
{
	double sum = 0;
	f->reach = reach;
	for (int i = -reach; i <= reach; i++) sum += f->tap[reach + i] = exp(-rate * i * i);
	for (int i = 0; i <= 2 * reach; i++) f->tap[i] /= sum;
	return sum;
}

/* Scaled so that the positive taps sum to 1, and the negative ones to -1. */
static void balance(filter *f)
{
	double above = 0, below = 0;
	for (int i = 0; i <= 2 * f->reach; i++) {
		above += fmax(f->tap[i], 0);
		below -= fmin(f->tap[i], 0);
	}
	for (int i = 0; i <= 2 * f->reach; i++) f->tap[i] /= f->tap[i] > 0 ? above : below;
}

/* Contrast sensitivity: a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees. */
static void make_sensitivity(lens *l, double ppd)
{
	static const double a[2] = {34.1, 13.5}, b[2] = {0.04, 0.025};
	int reach = (int)ceil(3 * sqrt(b[0] / (2 * pi * pi)) * ppd);
	make_gaussian(&l->achromatic, reach, pi * pi / (0.0047 * ppd * ppd));
	make_gaussian(&l->red_green, reach, pi * pi / (0.0053 * ppd * ppd));
	for (int k = 0; k < 2; k++) {
		double sum = make_gaussian(&l->blue_yellow[k], reach, pi * pi / (b[k] * ppd * ppd));
		l->share[k] = a[k] * sqrt(pi / b[k]) * sum * sum;
	}
	double all = l->share[0] + l->share[1];
	for (int k = 0; k < 2; k++) l->share[k] /= all;
}

/* A Gaussian, and its first and second derivative. */
static void make_features(lens *l, double ppd)
{
	double sigma = 0.5 * edge_width * ppd, rate = 1 / (2 * sigma * sigma);
	int reach = (int)ceil(3 * sigma);
	make_gaussian(&l->smooth, reach, rate);
	l->edge.reach = l->point.reach = reach;
	for (int i = -reach; i <= reach; i++) {
		double g = exp(-rate * i * i);
		l->edge.tap[reach + i] = -i * g;
		l->point.tap[reach + i] = (i * i / (sigma * sigma) - 1) * g;
	}
	balance(&l->edge);
	balance(&l->point);
}

/* to[x] += weight * from[x + shift], within the row. */
static void add_shifted(double *to, const double *from, int64_t n, int64_t shift, double weight)
{
	int64_t begin = shift < 0 ? -shift : 0, end = shift > 0 ? n - shift : n;
	begin = begin < n ? begin : n;
	end = end > begin ? end : begin;
	for (int64_t x = 0; x < begin; x++) to[x] += weight * from[shift < 0 ? 0 : n - 1];
	for (int64_t x = begin; x < end; x++) to[x] += weight * from[x + shift];
	for (int64_t x = end; x < n; x++) to[x] += weight * from[shift < 0 ? 0 : n - 1];
}

/* `to` may be `from`. */
static void apply(const lens *l, double *to, const double *from, const filter *along, const filter *across)
{
	const int64_t width = l->width, height = l->height;
	double *between = l->work[0];
	ts_stop *stop = ts_stop_here();
#pragma omp parallel for num_threads((int)ts_threads_all()) schedule(static)
	for (int64_t y = 0; y < height; y++) {
		if (ts_stopped(stop)) continue;
		double *row = between + y * width;
		for (int64_t x = 0; x < width; x++) row[x] = 0;
		for (int i = -along->reach; i <= along->reach; i++) {
			add_shifted(row, from + y * width, width, i, along->tap[along->reach + i]);
		}
	}
#pragma omp parallel for num_threads((int)ts_threads_all()) schedule(static)
	for (int64_t y = 0; y < height; y++) {
		if (ts_stopped(stop)) continue;
		double *row = to + y * width;
		for (int64_t x = 0; x < width; x++) row[x] = 0;
		for (int i = -across->reach; i <= across->reach; i++) {
			int64_t at = y + i < 0 ? 0 : y + i < height ? y + i : height - 1;
			add_shifted(row, between + at * width, width, 0, across->tap[across->reach + i]);
		}
	}
}

/* ---- colours ---- */

static void multiply(double to[3], const double m[3][3], const double from[3])
{
	for (int i = 0; i < 3; i++) to[i] = m[i][0] * from[0] + m[i][1] * from[1] + m[i][2] * from[2];
}

static double white(int i) { return xyz_of_rgb[i][0] + xyz_of_rgb[i][1] + xyz_of_rgb[i][2]; }

static double linear_of(uint8_t code)
{
	double v = code / 255.0;
	return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
}

static void opponent_of_linear(double to[3], const double rgb[3])
{
	double xyz[3];
	multiply(xyz, xyz_of_rgb, rgb);
	for (int i = 0; i < 3; i++) xyz[i] /= white(i);
	to[0] = 116 * xyz[1] - 16;
	to[1] = 500 * (xyz[0] - xyz[1]);
	to[2] = 200 * (xyz[1] - xyz[2]);
}

/* Clamped to the sRGB cube, as on a display. */
static void linear_of_opponent(double rgb[3], const double from[3])
{
	double y = (from[0] + 16) / 116;
	double xyz[3] = {(y + from[1] / 500) * white(0), y * white(1), (y - from[2] / 200) * white(2)};
	multiply(rgb, rgb_of_xyz, xyz);
	for (int i = 0; i < 3; i++) rgb[i] = fmin(fmax(rgb[i], 0), 1);
}

static double lab_root(double t)
{
	const double delta = 6.0 / 29;
	return t > delta * delta * delta ? cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
}

/* L*a*b* of linear sRGB, with weaker colours where it is dark (Hunt). */
static void lab_of_linear(double lab[3], const double rgb[3])
{
	double xyz[3];
	multiply(xyz, xyz_of_rgb, rgb);
	for (int i = 0; i < 3; i++) xyz[i] = lab_root(xyz[i] / white(i));
	lab[0] = 116 * xyz[1] - 16;
	lab[1] = 0.01 * lab[0] * 500 * (xyz[0] - xyz[1]);
	lab[2] = 0.01 * lab[0] * 200 * (xyz[1] - xyz[2]);
}

/* HyAB to the power of q_c. */
static double apart(const double a[3], const double b[3])
{
	return pow(fabs(a[0] - b[0]) + hypot(a[1] - b[1], a[2] - b[2]), q_c);
}

/* The greatest distance: from green to blue. */
static double most_apart(void)
{
	static const double green[3] = {0, 1, 0}, blue[3] = {0, 0, 1};
	double a[3], b[3];
	lab_of_linear(a, green);
	lab_of_linear(b, blue);
	return apart(a, b);
}

/* Maps to 0 to 1: distances below p_c of the greatest fill p_t of the range. */
static double spread(double distance, double most)
{
	double bend = p_c * most;
	return distance < bend ? p_t / bend * distance : p_t + (distance - bend) / (most - bend) * (1 - p_t);
}

/* ---- images ---- */

static void take_strength(const lens *l, double *to, const double *from, const filter *feature)
{
	apply(l, l->work[1], from, feature, &l->smooth);
	apply(l, l->work[2], from, &l->smooth, feature);
	for (size_t i = 0; i < (size_t)l->width * l->height; i++) to[i] = hypot(l->work[1][i], l->work[2][i]) / 116;
}

static void take_colour(const lens *l, const seen *s)
{
	ts_stop *stop = ts_stop_here();
	apply(l, s->colour[0], s->colour[0], &l->achromatic, &l->achromatic);
	apply(l, s->colour[1], s->colour[1], &l->red_green, &l->red_green);
	for (int k = 0; k < 2; k++) apply(l, l->work[1 + k], s->colour[2], &l->blue_yellow[k], &l->blue_yellow[k]);
#pragma omp parallel for num_threads((int)ts_threads_all()) schedule(static)
	for (int64_t i = 0; i < (int64_t)l->width * l->height; i++) {
		if (ts_stopped(stop)) continue;
		double blue_yellow = l->share[0] * l->work[1][i] + l->share[1] * l->work[2][i], rgb[3], lab[3];
		linear_of_opponent(rgb, (const double[3]){s->colour[0][i], s->colour[1][i], blue_yellow});
		lab_of_linear(lab, rgb);
		for (int c = 0; c < 3; c++) s->colour[c][i] = lab[c];
	}
}

static void see(const lens *l, const seen *s, const uint8_t *srgb)
{
	double linear[256], opponent[3];
	for (int code = 0; code < 256; code++) linear[code] = linear_of((uint8_t)code);
	for (size_t i = 0; i < (size_t)l->width * l->height; i++) {
		const uint8_t *p = srgb + 3 * i;
		opponent_of_linear(opponent, (const double[3]){linear[p[0]], linear[p[1]], linear[p[2]]});
		for (int c = 0; c < 3; c++) s->colour[c][i] = opponent[c];
	}
	take_strength(l, s->edge, s->colour[0], &l->edge);
	take_strength(l, s->point, s->colour[0], &l->point);
	take_colour(l, s);
}

/* Features make colour differences more visible. */
static double error_of(const seen *a, const seen *b, size_t i, double most)
{
	const double of_a[3] = {a->colour[0][i], a->colour[1][i], a->colour[2][i]};
	const double of_b[3] = {b->colour[0][i], b->colour[1][i], b->colour[2][i]};
	double colour = spread(apart(of_a, of_b), most);
	double edge = fabs(a->edge[i] - b->edge[i]), point = fabs(a->point[i] - b->point[i]);
	double feature = pow(fmax(edge, point) / sqrt(2), q_f);
	return pow(colour, 1 - feature);
}

static uint32_t reach_of(const lens *l)
{
	const int reach = l->achromatic.reach > l->smooth.reach ? l->achromatic.reach : l->smooth.reach;
	return (uint32_t)reach;
}

/* Adds the errors of the rows from `begin` to `end` to *sum, in their order. */
static void take_band(lens *l, const seen s[2], float *errors, double *sum, const uint8_t *const image[2],
                      uint32_t begin, uint32_t end, uint32_t height)
{
	const size_t width = l->width, reach = reach_of(l);
	const double most = most_apart();
	const size_t low = begin > reach ? begin - reach : 0, high = end + reach < height ? end + reach : height;
	l->height = (uint32_t)(high - low);
	for (int k = 0; k < 2; k++) see(l, &s[k], image[k] + 3 * width * low);
	ts_stop *stop = ts_stop_here();
	for (size_t i = begin * width; i < end * width && !ts_stopped(stop); i++) {
		const double error = error_of(&s[0], &s[1], i - low * width, most);
		errors[i] = (float)error;
		*sum += error;
	}
}

ts_status ts_flip(float *errors, double *mean, const uint8_t *reference, const uint8_t *image, uint32_t width,
                  uint32_t height, double ppd)
{
	lens l = {.width = width};
	seen s[2];
	make_sensitivity(&l, ppd);
	make_features(&l, ppd);
	const size_t row_bytes = (size_t)width * N_PLANES * sizeof(double);
	const size_t fit = row_bytes > 0 ? TS_FLIP_BYTES / row_bytes : 0;
	const uint32_t band = fit < LEAST_BAND ? LEAST_BAND : (uint32_t)fit;
	const uint64_t rows = (uint64_t)band + 2 * reach_of(&l);
	const size_t n = (size_t)width * (height < rows ? height : (size_t)rows);
	double sum = 0, *planes = ts_alloc(n, N_PLANES * sizeof *planes, "FLIP");
	if (planes == NULL) return TS_ERROR;
	for (int k = 0; k < 3; k++) l.work[k] = planes + (size_t)k * n;
	for (int k = 0; k < 2; k++) {
		double *own = planes + (size_t)(3 + 5 * k) * n;
		s[k] = (seen){{own, own + n, own + 2 * n}, own + 3 * n, own + 4 * n};
	}
	for (uint32_t y = 0, end; y < height; y = end) {
		end = height - y < band ? height : y + band;
		take_band(&l, s, errors, &sum, (const uint8_t *const[]){reference, image}, y, end, height);
	}
	const size_t pixels = (size_t)width * height;
	*mean = pixels > 0 ? sum / (double)pixels : 0;
	free(planes);
	return ts_go_on();
}

/* The cross-bilateral filter against its definition in double precision (METHODS 14): weights by position and normal,
 * the sky, borders; constant light, radius 0, and the closed form on a plane. */
#include <string.h>
#include "kernels/views/bilateral.h"
#include "tests/kernels/seeded.h"

enum { MOST = 16, PIXELS = MOST * MOST, N_WORLDS = 400 };

typedef struct {
	u32 width, height, radius;
	ts_gpixel pixels[PIXELS];
	f32 from[3 * PIXELS], to[3 * PIXELS];
} world;

static void filter(world *w, bool columns)
{
	const ts_bilateral_args args = {w->pixels, w->from, w->to, w->width, w->height, w->radius, columns};
	memset(w->to, 0xff, sizeof w->to);
	for (u64 i = w->width * w->height; i-- > 0;) ts_k_bilateral_item(&args, i);
}

/* A plane seen from ahead, all of it dark. */
static void begin(world *w, u32 width, u32 height, u32 radius)
{
	*w = (world){.width = width, .height = height, .radius = radius};
	for (u32 i = 0; i < width * height; i++) {
		ts_store3(w->pixels[i].position, ts_v3_make((f32)(i % width), (f32)(i / width), 0));
		ts_store3(w->pixels[i].normal, ts_v3_make(0, 0, 1));
	}
}

static bool is_sky(const world *w, u32 i) { return w->pixels[i].depth == TS_SKY; }

/* An uneven surface with holes; rough: how far from a plane. Light, too, is where the sky is. */
static void begin_rough(world *w, u32 number)
{
	static const f32 rough[] = {0, 0.03f, 0.15f, 1};
	begin(w, 1 + below(MOST), 1 + below(MOST), 1 + below(2 * MOST));
	for (u32 i = 0; i < w->width * w->height; i++) {
		ts_v3 off = uniform3(-1, 1), bend = uniform3(-1, 1);
		ts_v3 p = ts_mad(ts_load3(w->pixels[i].position), off, rough[number % 4]);
		ts_v3 n = ts_normalize(ts_mad(ts_v3_make(0, 0, 1), bend, rough[number / 4 % 4]));
		ts_store3(w->pixels[i].position, p);
		ts_store3(w->pixels[i].normal, n);
		ts_store3(&w->from[3 * i], uniform3(0, 10));
		w->pixels[i].depth = below(6) == 0 ? TS_SKY : uniform(0, 0.9f);
	}
}

static double3 position(const world *w, u32 i) { return d3_of(ts_load3(w->pixels[i].position)); }
static double3 normal(const world *w, u32 i) { return d3_of(ts_load3(w->pixels[i].normal)); }

/* exp(-((2k / R)^2 / 2 + 128 (n . w)^2 + 32 (1 - n . n'))) */
static double weight(const world *w, u32 a, u32 b, double k)
{
	if (a == b) return 1;
	double3 way = d3_sub(position(w, b), position(w, a));
	double sine = d3_length(way) > 0 ? d3_dot(normal(w, a), d3_unit(way)) : 0, steps = 2 * k / w->radius;
	return exp(-(steps * steps / 2 + 128 * sine * sine + 32 * (1 - d3_dot(normal(w, a), normal(w, b)))));
}

/* The mean over all pixels of the same row or column; sum: of the weights. */
static double3 mean(const world *w, u32 i, bool columns, double *sum)
{
	double3 light = {0, 0, 0};
	*sum = 0;
	for (u32 j = 0; j < w->width * w->height; j++) {
		double across = (double)(j % w->width) - i % w->width, down = (double)(j / w->width) - i / w->width;
		double k = columns ? down : across, aside = columns ? across : down;
		if (aside != 0 || fabs(k) > w->radius || is_sky(w, j) || is_sky(w, i)) continue;
		double share = weight(w, i, j, k);
		light = d3_mad(light, d3_of(ts_load3(&w->from[3 * j])), share);
		*sum += share;
	}
	return *sum > 0 ? d3_scale(light, 1 / *sum) : light;
}

static void filter_matches_its_definition(void **state)
{
	(void)state;
	static world w;
	u32 n_mixed = 0, n_alone = 0;
	for (u32 number = 0; number < N_WORLDS; number++) {
		begin_rough(&w, number);
		for (u32 columns = 0; columns < 2; columns++) {
			filter(&w, columns != 0);
			for (u32 i = 0; i < w.width * w.height; i++) {
				double sum;
				double3 expected = mean(&w, i, columns != 0, &sum);
				assert_true(d3_distance(d3_of(ts_load3(&w.to[3 * i])), expected) < 1e-4);
				if (is_sky(&w, i)) assert_true(w.to[3 * i] == 0 && w.to[3 * i + 1] == 0 && w.to[3 * i + 2] == 0);
				n_mixed += sum > 1.2;
				n_alone += sum > 0 && sum < 1.0001;
			}
		}
	}
	assert_true(n_mixed > 10000 && n_alone > 5000);
}

/* Of the same light everywhere nothing changes, whatever the surface. */
static void constant_light_stays_constant(void **state)
{
	(void)state;
	static world w;
	for (u32 number = 0; number < N_WORLDS; number++) {
		begin_rough(&w, number);
		for (u32 i = 0; i < 3 * PIXELS; i++) w.from[i] = is_sky(&w, i / 3) ? 1e6f : 3;
		filter(&w, number % 2 != 0);
		for (u32 i = 0; i < 3 * w.width * w.height; i++) assert_near(w.to[i], is_sky(&w, i / 3) ? 0 : 3, 2e-6);
	}
}

static void radius_zero_leaves_every_bit(void **state)
{
	(void)state;
	static world w;
	for (u32 number = 0; number < N_WORLDS; number++) {
		begin_rough(&w, number);
		w.radius = 0;
		filter(&w, number % 2 != 0);
		for (u32 i = 0; i < 3 * w.width * w.height; i++) assert_true(w.to[i] == (is_sky(&w, i / 3) ? 0 : w.from[i]));
	}
}

/* exp(-2 (k / R)^2) by its sum over what there is of a line of n pixels about `at`. */
static double gauss(u32 at, u32 from, u32 n, u32 radius)
{
	double sum = 0, own = 0;
	for (u32 i = 0; i < n; i++) {
		double k = (double)i - at, share = fabs(k) <= radius ? exp(-2 * k * k / ((double)radius * radius)) : 0;
		sum += share;
		if (i == from) own = share;
	}
	return own / sum;
}

/* One lit pixel of a plane, anywhere, along rows, then along columns: the product of two Gaussians, each cut off at the
 * borders. */
static void a_lit_pixel_spreads_as_two_gaussians(void **state)
{
	(void)state;
	static world w;
	enum { WIDTH = 7, HEIGHT = 5 };
	for (u32 radius = 1; radius <= 9; radius++) {
		for (u32 lit = 0; lit < WIDTH * HEIGHT; lit++) {
			begin(&w, WIDTH, HEIGHT, radius);
			w.from[3 * lit + 1] = 1;
			filter(&w, false);
			memcpy(w.from, w.to, sizeof w.from);
			filter(&w, true);
			for (u32 i = 0; i < WIDTH * HEIGHT; i++) {
				double across = gauss(i % WIDTH, lit % WIDTH, WIDTH, radius);
				double down = gauss(i / WIDTH, lit / WIDTH, HEIGHT, radius);
				assert_near(w.to[3 * i + 1], across * down, 1e-6);
				assert_true(w.to[3 * i] == 0 && w.to[3 * i + 2] == 0);
			}
		}
	}
}

/* No light passes an edge: of two walls that meet only one is lit before. */
static void no_light_passes_an_edge(void **state)
{
	(void)state;
	static world w;
	begin(&w, MOST, MOST, 4);
	for (u32 i = 0; i < PIXELS; i++) {
		bool left = i % MOST < MOST / 2;
		f32 x = (f32)(i % MOST) - MOST / 2, y = (f32)(i / MOST);
		ts_store3(w.pixels[i].position, left ? ts_v3_make(x, y, 0) : ts_v3_make(0, y, x));
		ts_store3(w.pixels[i].normal, left ? ts_v3_make(0, 0, 1) : ts_v3_make(-1, 0, 0));
		for (u32 c = 0; c < 3; c++) w.from[3 * i + c] = left;
	}
	for (u32 columns = 0; columns < 2; columns++) {
		filter(&w, columns != 0);
		for (u32 i = 0; i < 3 * PIXELS; i++) assert_near(w.to[i], w.from[i], 1e-5);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(filter_matches_its_definition), seeded_test(constant_light_stays_constant),
		seeded_test(radius_zero_leaves_every_bit),  seeded_test(a_lit_pixel_spreads_as_two_gaussians),
		seeded_test(no_light_passes_an_edge),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* The fast hulls equal the plain kernel bit for bit: boxes, irradiance and counter, of random boxes and lobes biased
 * to the extremes. */
#include <string.h>
#include "backends/fast.h"
#include "backends/kernels.h"
#include "tests/kernels/seeded.h"

enum { N = 400, GRID = 64, TEXELS = GRID * GRID, MOST_BOXES = 64, MOST_PIXELS = 2048 };

typedef struct {
	u32 offset[TEXELS + 1], n;
	ts_segment boxes[MOST_BOXES];
	ts_moment moments[4 * MOST_BOXES];
	ts_lobes lobes[4 * MOST_BOXES];
	ts_gpixel pixels[MOST_PIXELS];
} world;

/* What a pass over it writes. */
typedef struct {
	u32 box[MOST_PIXELS];
	f32 irradiance[3 * MOST_PIXELS];
	i64 n_unlit;
} result;

/* Far apart in size, and now and then 0, the least or the most that there is. */
static f32 extreme(f32 most)
{
	const f32 ends[] = {0, 0.5f, 1, 2, most};
	u32 sort = below(8);
	return sort < 5 ? ends[sort] : most * (f32)pow(2, -30 * (double)uniform(0, 1));
}

static ts_v3 extreme_direction(void)
{
	u32 sort = below(8);
	ts_v3 d = direction();
	if (sort == 0) return ts_v3_make(0, 0, 0);
	return sort == 1 ? ts_v3_make(0, 0, d.x < 0 ? -1.0f : 1.0f) : d;
}

static void random_corner(world *w, u32 i)
{
	w->moments[i].depth = below(8) == 0 ? 1 : uniform(0.2f, 1);
	for (u32 c = 0; c < 3; c++) {
		w->lobes[i].mu[c] = extreme(1e20f);
		w->lobes[i].lambda[c] = extreme(100000);
		ts_store3(w->lobes[i].phi + c * 3, extreme_direction());
	}
}

static void random_box(world *w, u32 label)
{
	ts_segment *box = &w->boxes[w->n];
	u32 block = label / 1024;
	*box = (ts_segment){.nearest = uniform(0.5f, 0.9f), .label = label};
	box->farthest = box->nearest + uniform(0, 0.2f);
	for (u32 k = 0; k < 2; k++) {
		u32 first = (k == 0 ? block % 2 : block / 2) * 32;
		box->low[k] = first + below(32);
		box->high[k] = box->low[k] + below(first + 32 - box->low[k]);
	}
	for (u32 k = 0; k < 4; k++) random_corner(w, 4 * w->n + k);
	w->n++;
}

static void random_world(world *w, u32 n_pixels)
{
	memset(w, 0, sizeof *w);
	u32 most = below(16);
	for (u32 label = 0; label < TEXELS; label++) {
		w->offset[label] = w->n;
		if (label % 1024 < most && below(4) != 0) random_box(w, label);
	}
	w->offset[TEXELS] = w->n;
	for (u32 i = 0; i < n_pixels; i++) {
		w->pixels[i].depth = below(8) == 0 ? TS_SKY : uniform(0.4f, 0.99f);
		ts_store3(w->pixels[i].normal, extreme_direction());
	}
}

static ts_hull_args arguments(const world *w, result *r, u32 width)
{
	memset(r, 0x55, sizeof *r);
	r->n_unlit = 0;
	return (ts_hull_args){
		.choice = {.offset = w->offset, .boxes = w->boxes, .grid = GRID, .robust = below(2), .step = 0.02f},
		.pixels = w->pixels,
		.moments = w->moments,
		.lobes = w->lobes,
		.box = r->box,
		.irradiance = r->irradiance,
		.n_unlit = &r->n_unlit,
		.width = width,
		.height = 1 + MOST_PIXELS / width / 4, /* of four samples a pixel, or fewer */
		.cosine = TS_COSINE_OURS,
		.rectangle = below(2),
	};
}

static void fast_hulls_equal_the_kernel(void **state)
{
	(void)state;
	static world w;
	static result plain, fast;
	u64 n_lit = 0;
	for (u32 i = 0; i < N; i++) {
		u32 start = n_random, width = 1 + below(70), n = width * (1 + below(MOST_PIXELS / width)),
			threads = 1 + below(7);
		random_world(&w, n);
		ts_hull_args args = arguments(&w, &plain, width);
		ts_c_launch(TS_KERNEL_hull, &args, n, 1);
		memset(&fast, 0x55, sizeof fast);
		fast.n_unlit = 0;
		args.box = fast.box;
		args.irradiance = fast.irradiance;
		args.n_unlit = &fast.n_unlit;
		assert_true(ts_c_fast_hull(&args, n, threads));
		if (memcmp(&plain, &fast, sizeof plain) != 0) {
			fail_msg("random %u: %u boxes, %u x %u pixels, robust %u, %u threads", start, w.n, width, n / width,
			         args.choice.robust, threads);
		}
		for (u32 k = 0; k < n; k++) n_lit += plain.irradiance[3 * k] > 0;
	}
	assert_true(n_lit > 20 * N);
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(fast_hulls_equal_the_kernel)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

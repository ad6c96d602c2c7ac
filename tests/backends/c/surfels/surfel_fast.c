/* The fast paths of surfels give the kernels' bits and tallies, pass after pass: surfels of all sizes and shapes,
 * before, beside and around the eye, in images of several tiles and of parts of one, by all filters, of normals and
 * colours that sums saturate at. */
#include <stdlib.h>
#include "backends/fast.h"
#include "backends/kernels.h"
#include "kernels/surfels/surfel_setup.h"
#include "tests/kernels/seeded.h"

enum { N = 240, SURFELS = 300, SIDE = 150, PIXELS = SIDE * SIDE, TALLIES = 4 };

typedef struct {
	ts_disc disc[SURFELS];
	u64 key[PIXELS], heaviest[PIXELS];
	i64 sum[PIXELS * TS_BLEND_SUMS];
	ts_gpixel pixel[PIXELS];
	f32 radiance[PIXELS * 3];
	u8 srgb[PIXELS * 3];
	i64 tally[4][TALLIES];
} passes;

typedef struct {
	ts_view view;
	ts_filter filter;
	f32 epsilon;
	u32 npr, threads;
	ts_surfel surfel[SURFELS];
} frame;

static ts_view random_view(void)
{
	ts_v3 back = direction(), right = ts_normalize(ts_cross(direction(), back));
	u32 width = 1 + below(below(2) == 0 ? SIDE : 4 * SIDE), most = PIXELS / width;
	ts_view view = {.width = width, .height = 1 + below(most < SIDE ? most : SIDE), .near = 0.01f};
	view.focal = (f32)view.width * uniform(0.3f, 2.0f);
	ts_store3(view.back, back);
	ts_store3(view.right, right);
	ts_store3(view.up, ts_cross(right, back));
	ts_store3(view.eye, uniform3(-1, 1));
	return view;
}

/* Just before the eye's plane, and so far aside that what reaches that plane covers no pixel, or just may. */
static ts_v3 far_aside(const ts_view *view)
{
	f32 z = uniform(0.01f, 0.1f), x = (TS_FARTHEST_PIXEL + uniform(-300, 300)) / view->focal;
	return ts_add(ts_load3(view->eye), ts_scale(ts_sub(ts_scale(ts_load3(view->right), x), ts_load3(view->back)), z));
}

/* Most face the eye and are a few pixels wide; some are as large as the image, thin, seen from the side, or far
 * aside. */
static void random_surfel(ts_surfel *s, const ts_view *view)
{
	ts_v3 p = ts_add(ts_load3(view->eye), ts_scale(ts_load3(view->back), uniform(-4, 0.2f)));
	p = below(40) == 0 ? far_aside(view) : ts_add(p, uniform3(-2, 2));
	ts_v3 n = below(8) == 0 ? direction() : ts_normalize(ts_add(ts_load3(view->back), uniform3(-1.2f, 1.2f)));
	ts_v3 u = ts_normalize(ts_cross(n, direction()));
	f32 size = exp2f(below(8) == 0 ? uniform(-3, 3) : uniform(-12, -3));
	ts_store3(s->centre, p);
	ts_store3(s->u, ts_scale(u, size));
	ts_store3(s->v, ts_scale(ts_cross(n, u), size * exp2f(-uniform(0, 6) * (f32)below(2))));
	ts_store3(s->colour, uniform3(-0.1f, 1.1f));
	if (below(40) == 0) s->colour[below(3)] = NAN;
}

static void random_frame(frame *f)
{
	static const f32 sigmas[] = {0, 1, 1, 1.5f, 9};
	f32 sigma = sigmas[below(5)];
	f->view = random_view();
	f->epsilon = exp2f(uniform(-10, 1));
	f->npr = below(2);
	f->threads = 1 + below(7);
	f->filter = (ts_filter){.filter = below(3),
	                        .botsch = below(4) == 0,
	                        .opens = below(2),
	                        .per_sigma2 = sigma > 0 ? 1 / (sigma * sigma) : 0,
	                        .reach = sigma,
	                        .fall = 0.5f / exp2f(uniform(-4, 2)),
	                        .object2 = 0.25f,
	                        .screen2 = 0.25f};
	for (u32 i = 0; i < SURFELS; i++) random_surfel(&f->surfel[i], &f->view);
}

static void begin(passes *p)
{
	memset(p, 0, sizeof *p);
	memset(p->key, 0xff, sizeof p->key);
	memset(p->heaviest, 0xff, sizeof p->heaviest);
}

static void setup(const frame *f, passes *p, bool fast)
{
	ts_surfel_setup_args args = {&f->view, f->surfel, p->disc, p->tally[0], f->filter};
	if (fast)
		assert_true(ts_c_fast_surfel_setup(&args, SURFELS, f->threads));
	else
		ts_c_launch(TS_KERNEL_surfel_setup, &args, SURFELS, 1);
}

/* Normals that no surfel has and flags that no eye gives, as a port may write them. */
static void spoil(passes *a, passes *b)
{
	for (u32 i = 0; i < SURFELS; i++) {
		if (below(9) == 0) a->disc[i].flags ^= TS_DISC_PARALLEL;
		if (below(30) == 0) a->disc[i].normal[below(3)] = below(4) == 0 ? NAN : uniform(-3, 3) * exp2f((f32)below(60));
	}
	memcpy(b->disc, a->disc, sizeof a->disc);
}

static void draw(const frame *f, passes *p, bool fast)
{
	ts_surfel_depth_args depth = {&f->view, p->disc, &f->epsilon, p->key};
	ts_surfel_blend_args blend = {&f->view, f->surfel, p->disc, p->key, p->sum, p->heaviest, p->tally[1], f->filter};
	if (fast) {
		assert_true(ts_c_fast_surfel_depth(&depth, SURFELS, f->threads));
		assert_true(ts_c_fast_surfel_blend(&blend, SURFELS, f->threads));
	} else {
		ts_c_launch(TS_KERNEL_surfel_depth, &depth, SURFELS, 1);
		ts_c_launch(TS_KERNEL_surfel_blend, &blend, SURFELS, 1);
	}
}

static void shade(const frame *f, passes *p, bool fast)
{
	const ts_light sun = {.direction = {0.6f, -0.2f, -0.8f}, .intensity = {3, 2, 1}};
	const ts_lamp lamp = {.samples = 1};
	u64 n = (u64)f->view.width * (u64)f->view.height;
	ts_surfel_blend_mean_args mean = {&f->view, p->disc, &f->epsilon, p->key, p->sum, p->heaviest, p->pixel};
	ts_deferred_args deferred = {&f->view, p->pixel,    &sun, &lamp,  NULL, p->radiance,
	                             p->srgb,  p->tally[2], 1,    f->npr, 0.3f, 1.5f};
	if (fast) {
		assert_true(ts_c_fast_surfel_blend_mean(&mean, n, f->threads));
		assert_true(ts_c_fast_deferred(&deferred, n, f->threads));
	} else {
		ts_c_launch(TS_KERNEL_surfel_blend_mean, &mean, n, 1);
		ts_c_launch(TS_KERNEL_deferred, &deferred, n, 1);
	}
}

static void check_equal(const frame *f, const passes *a, const passes *b, const char *pass)
{
	if (memcmp(a, b, sizeof *a) == 0) return;
	fail_msg("%s: %u x %u, filter %u, botsch %u, 1 / sigma^2 %a, fall %a, epsilon %a, npr %u, threads %u", pass,
	         f->view.width, f->view.height, f->filter.filter, f->filter.botsch, (double)f->filter.per_sigma2,
	         (double)f->filter.fall, (double)f->epsilon, f->npr, f->threads);
}

static frame one;
static passes plain, fast;

static void fast_surfels_equal_the_kernel(void **state)
{
	(void)state;
	i64 n_fragments = 0, n_boxes = 0, n_shaded = 0;
	for (u32 i = 0; i < N; i++) {
		random_frame(&one);
		begin(&plain);
		begin(&fast);
		setup(&one, &plain, false);
		setup(&one, &fast, true);
		check_equal(&one, &plain, &fast, "setup");
		if (i % 2 == 0) spoil(&plain, &fast);
		draw(&one, &plain, false);
		draw(&one, &fast, true);
		check_equal(&one, &plain, &fast, "depth and blend");
		shade(&one, &plain, false);
		shade(&one, &fast, true);
		check_equal(&one, &plain, &fast, "mean and deferred");
		n_fragments += plain.tally[1][0];
		n_boxes += plain.tally[1][1];
		n_shaded += plain.tally[2][0];
	}
	print_message("# %lld fragments of %lld pixels of boxes, %lld pixels shaded\n", (long long)n_fragments,
	              (long long)n_boxes, (long long)n_shaded);
	assert_true(n_fragments > 1000 * N && n_boxes > 2 * n_fragments && n_shaded > 500 * N);
}

/* Refused, with nothing done: exact EWA, and boxes that are all of a large image. */
static void the_kernel_takes_ewa_and_large_boxes(void **state)
{
	(void)state;
	enum { SMALL = 4, WIDE = 64 * 64, HIGH = 1 };
	static u64 keys[WIDE * HIGH], empty[WIDE * HIGH];
	ts_view view = {.width = WIDE, .height = HIGH, .focal = 1, .near = 0.01f};
	ts_disc disc[SMALL] = {{.depth = 1}};
	f32 epsilon = 0.1f;
	memset(keys, 0xff, sizeof keys);
	memset(empty, 0xff, sizeof empty);
	for (u32 i = 0; i < SMALL; i++) {
		disc[i] = (ts_disc){.depth = 1, .low = {0, 0}, .high = {WIDE - 1, HIGH - 1}};
	}
	ts_surfel_depth_args args = {&view, disc, &epsilon, keys};
	ts_surfel_blend_args ewa = {.view = &view, .discs = disc, .filter = {.filter = TS_FILTER_EWA}};
	ts_surfel_setup_args ewa_setup = {.view = &view, .discs = disc, .filter = {.filter = TS_FILTER_EWA}};
	assert_false(ts_c_fast_surfel_depth(&args, SMALL, 2));
	assert_memory_equal(keys, empty, sizeof keys);
	assert_false(ts_c_fast_surfel_blend(&ewa, SMALL, 2));
	assert_false(ts_c_fast_surfel_setup(&ewa_setup, SMALL, 2));
	disc[0].high[0] = disc[1].high[0] = disc[2].high[0] = 63;
	disc[3].high[0] = 64 * 13 - 1;
	assert_true(ts_c_fast_surfel_depth(&args, SMALL, 2));
	assert_true(keys[64 * 13 - 1] != TS_EMPTY && keys[64 * 13] == TS_EMPTY);
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(fast_surfels_equal_the_kernel),
	                                   seeded_test(the_kernel_takes_ewa_and_large_boxes)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

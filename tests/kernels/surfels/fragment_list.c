/* Lists of the surfels of each pixel: against rays cast in double precision at every surfel, the same however they are
 * made, and of the very fragments that surfel_blend takes of each surfel. */
#include <string.h>
#include "kernels/base/sort.h"
#include "kernels/surfels/fragment_list.h"
#include "kernels/surfels/surfel_setup.h"
#include "tests/kernels/seeded.h"

enum { WIDTH = 48, HEIGHT = 32, PIXELS = WIDTH * HEIGHT, N = 37, N_WORLDS = 60 };
#define SIGMA 1.25

typedef struct {
	ts_view view;
	ts_filter filter;
	ts_surfel surfels[N];
	ts_disc discs[N];
	u64 keys[PIXELS];
} world;

typedef struct {
	u32 offset[PIXELS + 1], surfels[N * PIXELS];
} lists;

/* The eye is in the origin and looks along -z; few turn their backs. */
static void random_surfel(ts_surfel *s)
{
	f32 z = uniform(1, 6), size = powf(2, uniform(-5, 0));
	f32 x = uniform(-0.7f, 0.7f) * z, y = uniform(-0.5f, 0.5f) * z;
	ts_v3 c = ts_v3_make(x, y, -z);
	ts_v3 n = direction(), u = ts_normalize(ts_cross(n, direction())), v = ts_cross(n, u);
	if (ts_dot(n, c) > 0 && below(4) != 0) v = ts_neg(v);
	*s = (ts_surfel){.colour = {1, 0.5f, 0.25f}};
	ts_store3(s->centre, c);
	ts_store3(s->u, ts_scale(u, size));
	ts_store3(s->v, ts_scale(v, size * uniform(0.3f, 1)));
}

/* Some pixels have a depth that hides surfels, and some none. */
static void random_world(world *w, u32 filter)
{
	*w = (world){.view = {.right = {1, 0, 0}, .up = {0, 1, 0}, .back = {0, 0, 1}}};
	w->view.width = WIDTH;
	w->view.height = HEIGHT;
	w->view.focal = uniform(30, 50);
	w->view.near = 0.01f;
	w->filter = (ts_filter){.filter = filter,
	                        .opens = below(2),
	                        .per_sigma2 = (f32)(1 / (SIGMA * SIGMA)),
	                        .reach = (f32)SIGMA,
	                        .fall = 2,
	                        .object2 = 0.25f,
	                        .screen2 = 0.25f};
	ts_surfel_setup_args args = {.view = &w->view, .surfels = w->surfels, .discs = w->discs, .filter = w->filter};
	i64 fates[4] = {0};
	args.tally = fates;
	for (u32 i = 0; i < N; i++) {
		random_surfel(&w->surfels[i]);
		ts_k_surfel_setup_item(&args, i);
	}
	for (u32 p = 0; p < PIXELS; p++) {
		f32 depth = uniform(1, 8);
		w->keys[p] = below(3) == 0 ? TS_EMPTY : (u64)ts_f2u(depth) << 32 | below(N);
	}
}

/* As the stage makes them, surfels in steps of `step` from `first`: counted, summed, listed and, if wanted, sorted.
 * Returns the number of entries. */
static u32 list(lists *out, const world *w, u32 first, u32 step, bool sorted)
{
	u32 total = 0;
	ts_fragment_list_args args = {
		.view = &w->view, .discs = w->discs, .keys = w->keys, .offset = out->offset, .filter = w->filter};
	memset(out, 0, sizeof *out);
	for (u32 k = 0; k < N; k++) ts_k_fragment_list_item(&args, (first + k * step) % N);
	assert_int_equal(out->offset[0], 0);
	for (u32 p = 0; p <= PIXELS; p++) {
		u32 count = out->offset[p];
		out->offset[p] = total;
		total += count;
	}
	args.surfels = out->surfels;
	for (u32 k = 0; k < N; k++) ts_k_fragment_list_item(&args, (first + k * step) % N);
	assert_int_equal(out->offset[PIXELS], total);
	ts_sort_args sort = {.offset = out->offset, .entries = out->surfels};
	for (u32 p = 0; sorted && p < PIXELS; p++) ts_k_leaf_sort_item(&sort, p);
	return total;
}

/* In this order: of two the least where both are asked for, the greatest where either is. */
typedef enum { OUT, TIE, IN } verdict;

static verdict both(verdict a, verdict b) { return a < b ? a : b; }
static verdict either(verdict a, verdict b) { return a > b ? a : b; }

/* Whether a is at most b, where that is not for rounding to say. */
static verdict at_most(double a, double b, double rounding)
{
	if (fabs(a - b) <= rounding * b) return TIE;
	return a < b ? IN : OUT;
}

/* METHODS 16: a fragment is where the pixel's ray meets the surfel in its ellipse, or passes its centre within SIGMA
 * pixels, by the filter one of these or either; and where it is not behind the key, nor, unless the filter opens
 * pixels, the key is empty. Where the ray meets no ellipse its
 * depth is the centre's. */
static verdict judge(const world *w, u32 surfel, u32 pixel)
{
	const ts_surfel *s = &w->surfels[surfel];
	double3 u = d3_of(ts_load3(s->u)), v = d3_of(ts_load3(s->v)), c = d3_of(ts_load3(s->centre));
	double focal = w->view.focal, x = pixel % WIDTH + 0.5 - WIDTH / 2.0, y = HEIGHT / 2.0 - (pixel / WIDTH + 0.5);
	double3 n = d3_unit(d3_cross(u, v)), way = {x / focal, y / focal, -1};
	if (d3_dot(n, c) >= 0) return OUT;
	double z = d3_dot(n, c) / d3_dot(n, way), rounding = 1e-5 * d3_length(way) / fabs(d3_dot(n, way));
	double3 at = d3_sub(d3_scale(way, z), c);
	double a = d3_dot(at, u) / d3_dot(u, u), b = d3_dot(at, v) / d3_dot(v, v);
	double dx = x + focal * c.x / c.z, dy = y + focal * c.y / c.z;
	verdict object = z > 0 ? at_most(a * a + b * b, 1, rounding) : OUT;
	verdict screen = at_most(dx * dx + dy * dy, SIGMA * SIGMA, 1e-5);
	const verdict covers[] = {either(object, screen), object, screen}; /* TS_FILTER_MIN, _OBJECT, _SCREEN */
	verdict seen = w->filter.opens != 0 ? IN : OUT;
	if (w->keys[pixel] != TS_EMPTY) {
		double depth = ts_u2f((u32)(w->keys[pixel] >> 32));
		seen = object == TIE ? TIE : at_most(object == IN ? z : -c.z, depth, rounding);
	}
	return both(covers[w->filter.filter], seen);
}

static void lists_hold_what_rays_meet(void **state)
{
	(void)state;
	static world w;
	static lists l;
	u32 n[3] = {0};
	for (u32 i = 0; i < N_WORLDS; i++) {
		random_world(&w, i % 3);
		u32 total = list(&l, &w, 0, 1, true);
		for (u32 p = 0; p < PIXELS; p++) {
			u32 next = l.offset[p];
			for (u32 surfel = 0; surfel < N; surfel++) {
				bool listed = next < l.offset[p + 1] && l.surfels[next] == surfel;
				verdict right = judge(&w, surfel, p);
				if (right != TIE && listed != (right == IN)) fail_msg("world %u, pixel %u, surfel %u", i, p, surfel);
				next += listed;
				n[right] += 1;
			}
			assert_int_equal(next, l.offset[p + 1]);
		}
		assert_true(total > 0 && l.offset[PIXELS] == total);
	}
	print_message("# %u fragments, %u undecided\n", n[IN], n[TIE]);
	assert_true(n[IN] > 10000 && n[TIE] < n[IN] / 100 && n[OUT] > n[IN]);
}

/* Lists come in the order in which surfels do, and sorted they are the same. */
static void the_order_of_surfels_changes_no_list(void **state)
{
	(void)state;
	static world w;
	static lists first, other;
	u32 n_others = 0;
	for (u32 i = 0; i < N_WORLDS; i++) {
		random_world(&w, i % 4);
		u32 total = list(&first, &w, 0, 1, true), step = 1 + below(N - 1);
		assert_int_equal(list(&other, &w, below(N), step, false), total);
		n_others += memcmp(&first, &other, sizeof first) != 0;
		list(&other, &w, below(N), step, true);
		assert_memory_equal(&first, &other, sizeof first);
		for (u32 p = 0; p < PIXELS; p++) {
			assert_true(first.offset[p] <= first.offset[p + 1]);
			for (u32 k = first.offset[p] + 1; k < first.offset[p + 1]; k++)
				assert_true(first.surfels[k - 1] < first.surfels[k]);
		}
	}
	assert_true(n_others > N_WORLDS / 2);
}

/* A surfel is blended into those pixels whose lists have it, and into no others; by every filter. */
static void surfels_blend_where_the_lists_have_them(void **state)
{
	(void)state;
	static world w;
	static lists l;
	static i64 sums[PIXELS * TS_BLEND_SUMS];
	static u64 heaviest[PIXELS];
	for (u32 i = 0; i < N_WORLDS; i++) {
		static u32 next[PIXELS];
		random_world(&w, i % 4);
		i64 tally[2] = {0};
		u32 total = list(&l, &w, 0, 1, true);
		ts_surfel_blend_args args = {.view = &w.view, .surfels = w.surfels, .discs = w.discs, .keys = w.keys};
		args.sums = sums;
		args.heaviest = heaviest;
		args.tally = tally;
		args.filter = w.filter;
		memcpy(next, l.offset, sizeof next);
		memset(sums, 0, sizeof sums);
		for (u32 surfel = 0; surfel < N; surfel++) {
			ts_k_surfel_blend_item(&args, surfel);
			for (u32 p = 0; p < PIXELS; p++) {
				next[p] += next[p] < l.offset[p + 1] && l.surfels[next[p]] == surfel;
				assert_int_equal(sums[p * TS_BLEND_SUMS + TS_BLEND_FRAGMENTS], next[p] - l.offset[p]);
			}
		}
		for (u32 p = 0; p < PIXELS; p++) assert_int_equal(next[p], l.offset[p + 1]);
		assert_int_equal(tally[0], total);
	}
}

/* As deep as the key is not behind it; the next number is. Where the key is empty all is seen, or nothing. */
static void fragments_as_deep_as_keys_are_listed(void **state)
{
	(void)state;
	static world w;
	static lists l;
	random_world(&w, TS_FILTER_OBJECT);
	for (u32 i = 1; i < N; i++) ts_k_disc_clear(&w.discs[i]);
	w.surfels[0] = (ts_surfel){.centre = {0, 0, -2}, .u = {0.5f, 0, 0}, .v = {0, 0.5f, 0}};
	i64 fates[4] = {0};
	ts_surfel_setup_args args = {.view = &w.view, .surfels = w.surfels, .discs = w.discs, .filter = w.filter};
	args.tally = fates;
	ts_k_surfel_setup_item(&args, 0);
	for (u32 p = 0; p < PIXELS; p++) w.keys[p] = TS_EMPTY;
	w.filter.opens = 0;
	assert_int_equal(list(&l, &w, 0, 1, true), 0);
	w.filter.opens = 1;
	u32 all = list(&l, &w, 0, 1, true);
	for (u32 p = 0; p < PIXELS; p++) w.keys[p] = (u64)ts_f2u(2) << 32;
	assert_int_equal(list(&l, &w, 0, 1, true), all);
	for (u32 p = 0; p < PIXELS; p++) w.keys[p] = (u64)(ts_f2u(2) - 1) << 32 | TS_NONE;
	assert_int_equal(list(&l, &w, 0, 1, true), 0);
	double radius = (double)w.view.focal / 4;
	assert_near(all, 3.14159265 * radius * radius, 0.03 * all);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(lists_hold_what_rays_meet),
		seeded_test(the_order_of_surfels_changes_no_list),
		seeded_test(surfels_blend_where_the_lists_have_them),
		seeded_test(fragments_as_deep_as_keys_are_listed),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* The kernel of the atomic limit: the least key of each texel whatever the threads, as spread as it says, and every
 * launch as if into empty texels. */
#include <stdlib.h>
#include "backends/backend.h"
#include "backends/kernels.h"
#include "tests/kernels/seeded.h"

enum { MOST = 1 << 17 };

static u64 texels[MOST];

static void empty(void)
{
	for (u32 i = 0; i < MOST; i++) texels[i] = TS_EMPTY;
}

/* Offers by their texels, the least first. */
typedef struct {
	u64 texel, key;
} offer;

static int by_texel_and_key(const void *a, const void *b)
{
	const offer *x = a, *y = b;
	return x->texel != y->texel ? (x->texel > y->texel) - (x->texel < y->texel) : (x->key > y->key) - (x->key < y->key);
}

/* Against all offers, sorted. */
static void each_texel_keeps_its_least_key(void **state)
{
	(void)state;
	enum { N = 5000 };
	offer offers[N];
	for (u32 threads = 1; threads <= 4; threads++) {
		ts_bench_min_args args = {.texels = texels, .n_texels = 1000 + below(1000), .distance = below(1000)};
		for (u32 i = 0; i < N; i++) {
			offers[i].texel = (u64)(ts_pcg(i) * (double)args.n_texels / 4294967296.0);
			offers[i].key = args.distance * 4294967296u + ts_pcg(0xffffffffu - i);
		}
		qsort(offers, N, sizeof *offers, by_texel_and_key);
		empty();
		ts_c_launch(TS_KERNEL_bench_min, &args, N, threads);
		u64 n_met = 0;
		for (u32 i = 0; i < N; i++) {
			bool first = i == 0 || offers[i].texel != offers[i - 1].texel;
			if (first) assert_true(texels[offers[i].texel] == offers[i].key);
			n_met += first;
		}
		for (u32 k = 0; k < MOST; k++) n_met -= texels[k] != TS_EMPTY;
		assert_int_equal(n_met, 0);
	}
}

/* As many offers as texels: 1 - 1/e of these met, and of the offers Ein(1) = 0.7966 lower their texel, in every
 * launch. */
static void offers_spread_as_a_uniform_draw_does(void **state)
{
	(void)state;
	empty();
	for (u32 distance = 3; distance-- > 0;) {
		ts_bench_min_args args = {.texels = texels, .n_texels = MOST, .distance = distance};
		double n_lowered = 0, n_met = 0;
		for (u32 i = 0; i < MOST; i++) {
			u64 at = ((u64)ts_pcg(i) * MOST) >> 32, before = texels[at];
			ts_k_bench_min_item(&args, i);
			n_lowered += texels[at] < before;
		}
		for (u32 k = 0; k < MOST; k++) n_met += texels[k] >> 32 == distance;
		assert_near(n_lowered / MOST, 0.7966, 0.01);
		assert_near(n_met / MOST, 0.6321, 0.01);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(each_texel_keeps_its_least_key),
	                                   seeded_test(offers_spread_as_a_uniform_draw_does)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Keys that meet in any order against a plain search, window by window; and what is missing, extra or repeated. */
#include "compare/order.h"
#include "kernels/base/num.h"
#include "tests/lcg.h"
#include "tests/trace/folder.h"

enum { MOST = 3000 };

static u32 seed = 17;

static ts_buffer_id keys_of = TS_B_points_key;

static ts_trace side(const char *name, const u64 *keys, u64 n, bool arrival)
{
	ts_trace trace = {.arrival = arrival};
	ts_trace_item *item = &trace.item[keys_of];
	item->path = strdup(scratch_path("%s", name));
	assert_non_null(item->path);
	item->npy = (ts_npy){.n_dims = 1, .shape = {n}, .n = n};
	file_write(item->path, keys, n * sizeof *keys);
	return trace;
}

/* Keys without a partner, as the last call of `make` found them. */
static ts_named named[2 * MOST];
static ts_differences unmet = {.most = 2 * MOST};

static ts_status make(ts_order *order, const u64 *ref, u64 n_ref, const u64 *cand, u64 n_cand, bool arrival)
{
	ts_trace a = side("ref", ref, n_ref, false), b = side("cand", cand, n_cand, arrival);
	ts_status status = ts_order_make(order, keys_of, &a, &b);
	unmet = (ts_differences){.items = named, .most = unmet.most};
	if (status == TS_OK && order->given) assert_int_equal(ts_order_unmet(&unmet, order, keys_of, &a, &b), TS_OK);
	free(a.item[keys_of].path);
	free(b.item[keys_of].path);
	return status;
}

/* Ascending keys: of points, or with every bit in use. */
static u64 make_keys(u64 *keys, bool wide)
{
	u64 n = lcg_below(&seed, MOST), key = wide ? 0 : 5;
	for (u64 i = 0; i < n; i++) {
		key += 1 + (wide                       ? (u64)lcg_below(&seed, UINT32_MAX) << 20
		            : lcg_below(&seed, 9) == 0 ? (u64)lcg_below(&seed, 7) << 32
		                                       : lcg_below(&seed, 3));
		keys[i] = key;
	}
	if (wide && n > 0) keys[n - 1] = UINT64_MAX;
	return n;
}

static u64 place_of(const u64 *keys, u64 n, u64 key)
{
	for (u64 i = 0; i < n; i++) {
		if (keys[i] == key) return i;
	}
	return TS_NONE;
}

static void shuffle(u64 *keys, u64 n)
{
	for (u64 i = n; i > 1; i--) {
		u64 j = lcg_below(&seed, (u32)i), kept = keys[i - 1];
		keys[i - 1] = keys[j];
		keys[j] = kept;
	}
}

static void any_permutation_is_mapped_back(void **state)
{
	(void)state;
	static u64 ref[MOST], cand[MOST];
	for (u32 round = 0; round < 40; round++) {
		ts_order order;
		u64 n = make_keys(ref, round % 2 == 1);
		memcpy(cand, ref, sizeof cand);
		shuffle(cand, n);
		assert_int_equal(make(&order, ref, n, cand, n, true), TS_OK);
		assert_true(order.given && order.n_missing == 0 && order.n_extra == 0 && unmet.n == 0);
		for (u64 i = 0; i < n; i++) {
			assert_int_equal(ref[ts_order_map(&order, (u32)i)], cand[i]);
			assert_int_equal(cand[order.cand_of_ref[i]], ref[i]);
		}
		ts_order_free(&order);
	}
}

static int by_key(const void *a, const void *b)
{
	const ts_difference *x = a, *y = b;
	return (x->cand > y->cand) - (x->cand < y->cand);
}

/* The list of all that a plain search finds, cut to `most`: what is missing, then what is beside. */
static u64 search(ts_difference *found, const u64 *ref, u64 n, const u64 *cand, u64 m, u64 *missing)
{
	u64 all = 0;
	for (u64 i = 0; i < n; i++) {
		if (place_of(cand, m, ref[i]) == TS_NONE) found[all++] = (ts_difference){.how = TS_LACKED, .element = i};
	}
	*missing = all;
	for (u64 i = 0; i < m; i++) {
		bool known = place_of(ref, n, cand[i]) != TS_NONE, again = place_of(cand, i, cand[i]) != TS_NONE;
		ts_difference d = {.how = known ? TS_TWICE : TS_BESIDE, .element = i, .cand = cand[i]};
		if (!known || again) found[all++] = d;
	}
	qsort(found + *missing, all - *missing, sizeof *found, by_key);
	return all;
}

/* Drops, repeats and invents keys; what is found is what a plain search finds, as far as there is room. */
static void missing_and_repeated_keys_are_all_found(void **state)
{
	(void)state;
	static u64 ref[MOST], cand[2 * MOST];
	static ts_difference found[3 * MOST];
	for (u32 round = 0; round < 20; round++) {
		ts_order order;
		u64 n = make_keys(ref, round % 2 == 1), m = 0, missing;
		for (u64 i = 0; i < n; i++) {
			u32 fate = lcg_below(&seed, 8);
			if (fate > 0) cand[m++] = ref[i];
			if (fate == 1) cand[m++] = ref[i];
			if (fate == 2) cand[m++] = ref[i] + 1;
		}
		shuffle(cand, m);
		u64 all = search(found, ref, n, cand, m, &missing);
		const u32 rooms[] = {0, 1, (u32)missing, (u32)missing + 1, (u32)missing + 20, (u32)all, 2 * MOST};
		unmet.most = rooms[round % 7];
		assert_int_equal(make(&order, ref, n, cand, m, true), TS_OK);
		assert_true(order.n_missing == missing && order.n_extra == all - missing);
		assert_int_equal(unmet.n, all < unmet.most ? all : unmet.most);
		for (u64 i = 0; i < unmet.n; i++) {
			const ts_difference *d = &unmet.items[i].difference;
			assert_true(d->cand == found[i].cand && (i >= missing) == (d->how != TS_LACKED));
			if (i < missing) assert_int_equal(d->element, found[i].element);
			if (i >= missing) assert_int_equal(cand[d->element], d->cand);
			if (i >= missing) assert_int_equal(d->how, found[i].how);
		}
		for (u64 i = 0; i < m; i++) {
			u64 place = place_of(ref, n, cand[i]);
			u32 mapped = ts_order_map(&order, (u32)i);
			assert_true(mapped == place || mapped >= n);
			if (place_of(cand, i, cand[i]) == TS_NONE && place != TS_NONE) assert_int_equal(mapped, place);
		}
		ts_order_free(&order);
	}
	unmet.most = 2 * MOST;
}

/* An index that names nothing never becomes one that does. */
static void no_wrong_index_becomes_a_right_one(void **state)
{
	(void)state;
	const u64 ref[] = {1, 2, 3, 4, 5}, cand[] = {9, 2, 1};
	ts_order order;
	assert_int_equal(make(&order, ref, 5, cand, 3, true), TS_OK);
	static const u32 outside[] = {0, 3, 4, 5, 6, TS_NONE - 1, TS_NONE};
	for (u32 i = 0; i < 7; i++) assert_true(ts_order_map(&order, outside[i]) >= 5);
	assert_int_equal(ts_order_map(&order, 1), 1);
	assert_int_equal(ts_order_map(&order, 2), 0);
	assert_int_equal(ts_order_map(&order, TS_NONE), TS_NONE);
	assert_int_not_equal(ts_order_map(&order, 0), TS_NONE);
	ts_order_free(&order);
}

static void the_least_and_greatest_keys_are_met(void **state)
{
	(void)state;
	const u64 ref[] = {0, 7, UINT64_MAX}, cand[] = {UINT64_MAX, 3, UINT64_MAX, UINT64_MAX, 0}, down[] = {1, 3, 2};
	ts_order order;
	assert_int_equal(make(&order, ref, 3, cand, 5, true), TS_OK);
	assert_true(order.n_missing == 1 && order.n_extra == 3 && unmet.n == 4);
	assert_true(named[0].difference.how == TS_LACKED && named[0].difference.element == 1);
	assert_true(named[1].difference.how == TS_BESIDE && named[1].difference.cand == 3);
	assert_true(named[2].difference.how == TS_TWICE && named[3].difference.how == TS_TWICE);
	ts_order_free(&order);
	assert_int_equal(make(&order, ref, 0, cand, 5, true), TS_OK);
	assert_true(order.n_missing == 0 && order.n_extra == 5);
	ts_order_free(&order);
	assert_int_equal(make(&order, ref, 3, cand, 0, true), TS_OK);
	assert_true(order.n_missing == 3 && order.n_extra == 0 && named[0].difference.element == 0);
	ts_order_free(&order);
	assert_int_equal(make(&order, ref, 3, cand, 5, false), TS_OK);
	assert_true(!order.given && ts_order_map(&order, 4) == 4);
	ts_order_free(&order);
	assert_int_equal(make(&order, down, 3, cand, 5, true), TS_ERROR);
	says("keys do not ascend");
	ts_order_free(&order);
}

/* Canonical candidates keep the places of points, and those of other sets only where keys do not ascend. */
static void canonical_candidates_keep_their_places(void **state)
{
	(void)state;
	const u64 ref[] = {1, 2, 3, 4}, less[] = {1, 3, 4}, twice[] = {1, 2, 2, 3, 4}, turned[] = {1, 2, 4, 3};
	ts_order order;
	assert_int_equal(ts_order_key_of(TS_B_points_record), TS_B_points_key);
	assert_int_equal(ts_order_key_of(TS_B_align_frame), TS_N_BUFFERS);
	assert_int_equal(make(&order, ref, 4, less, 3, false), TS_OK);
	assert_true(!order.given);
	keys_of = ts_order_key_of(TS_B_traverse_rendered);
	assert_int_equal(keys_of, TS_B_traverse_rendered);
	assert_int_equal(make(&order, ref, 4, less, 3, false), TS_OK);
	assert_true(order.given && order.n_missing == 1 && order.n_extra == 0 && named[0].difference.element == 1);
	ts_order_free(&order);
	assert_int_equal(make(&order, ref, 4, twice, 5, false), TS_OK);
	assert_true(order.given && order.n_missing == 0 && order.n_extra == 1 && named[0].difference.how == TS_TWICE);
	ts_order_free(&order);
	assert_int_equal(make(&order, ref, 4, turned, 4, false), TS_OK);
	assert_true(!order.given && order.cand_of_ref == NULL && ts_order_map(&order, 3) == 3);
	assert_int_equal(make(&order, ref, 4, turned, 4, true), TS_OK);
	assert_true(order.given && order.n_missing == 0 && order.n_extra == 0 && order.cand_of_ref[3] == 2);
	ts_order_free(&order);
	keys_of = TS_B_points_key;
}

/* Where a missing point was, only the reference can say. */
static void without_the_reference_no_place_is_told(void **state)
{
	(void)state;
	const u64 ref[] = {1, 2, 3}, cand[] = {1, 3};
	ts_order order;
	ts_trace a = side("ref", ref, 3, false), b = side("cand", cand, 2, true);
	ts_differences list = {.items = named, .most = 5};
	assert_int_equal(ts_order_make(&order, keys_of, &a, &b), TS_OK);
	assert_int_equal(ts_order_unmet(&list, &order, keys_of, &a, &b), TS_OK);
	assert_int_equal(list.n, 1);
	remove(a.item[keys_of].path);
	list.n = 0;
	assert_int_equal(ts_order_unmet(&list, &order, keys_of, &a, &b), TS_ERROR);
	says("No such file");
	ts_order_free(&order);
	free(a.item[keys_of].path);
	free(b.item[keys_of].path);
}

/* An index is 32 bits wide, and its last value says that there is no partner. */
static void more_records_than_indices_are_refused(void **state)
{
	(void)state;
	const u64 keys[] = {1, 2, 3}, counts[][2] = {{TS_NONE, 3}, {3, TS_NONE}, {(u64)1 << 32, 3}, {3, (u64)1 << 32}};
	for (u32 i = 0; i < sizeof counts / sizeof *counts; i++) {
		ts_order order;
		ts_trace a = side("ref", keys, 3, false), b = side("cand", keys, 3, true);
		a.item[keys_of].npy.n = counts[i][0];
		b.item[keys_of].npy.n = counts[i][1];
		assert_int_equal(ts_order_make(&order, keys_of, &a, &b), TS_ERROR);
		says("more records than 32-bit indices can name");
		free(a.item[keys_of].path);
		free(b.item[keys_of].path);
	}
}

/* Records larger than a window, in random order, with some missing. */
static void records_are_gathered_by_windows(void **state)
{
	(void)state;
	enum { N = 900000, BYTES = sizeof(ts_vertex) };
	u64 *ref = malloc(N * sizeof *ref), *cand = malloc(N * sizeof *cand), held;
	u8 *records = calloc(N, BYTES);
	assert_true(ref != NULL && cand != NULL && records != NULL);
	for (u64 i = 0; i < N; i++) ref[i] = cand[i] = 3 * i;
	shuffle(cand, N);
	for (u64 i = 0; i < N; i += 1000) cand[i]++;
	for (u64 i = 0; i < N; i++) memcpy(records + i * BYTES + BYTES - 8, &cand[i], 8);
	ts_order order;
	assert_int_equal(make(&order, ref, N, cand, N, true), TS_OK);
	ts_trace_item item = {.path = strdup(scratch_path("records")), .npy = {.n_dims = 1, .shape = {N}, .n = N}};
	file_write(item.path, records, (size_t)N * BYTES);
	ts_gather *g = ts_gather_open(&item, TS_B_scene_vertex, &order);
	assert_non_null(g);
	u32 windows = 0;
	for (u64 i = 0; i < N; i += held, windows++) {
		const u8 *at = ts_gather_at(g, i, &held);
		assert_non_null(at);
		for (u64 k = 0; k < held; k++) {
			u64 expected = order.cand_of_ref[i + k] != TS_NONE ? ref[i + k] : 0;
			assert_memory_equal(at + k * BYTES + BYTES - 8, &expected, 8);
		}
	}
	assert_true(windows > 1);
	ts_gather_close(g);
	ts_order_free(&order);
	free(item.path);
	free(ref);
	free(cand);
	free(records);
}

int main(void)
{
	const struct CMUnitTest order[] = {
		cmocka_unit_test(any_permutation_is_mapped_back),
		cmocka_unit_test(missing_and_repeated_keys_are_all_found),
		cmocka_unit_test(no_wrong_index_becomes_a_right_one),
		cmocka_unit_test(the_least_and_greatest_keys_are_met),
		cmocka_unit_test(canonical_candidates_keep_their_places),
		cmocka_unit_test(records_are_gathered_by_windows),
		cmocka_unit_test(without_the_reference_no_place_is_told),
		cmocka_unit_test(more_records_than_indices_are_refused),
	};
	return cmocka_run_group_tests(order, scratch_begin, scratch_remove);
}

/* Shapes as text: products, one more, and what is refused. */
#include "../../src/core/shape.h"
#include "test.h"

static ts_sizes some(void)
{
	ts_sizes sizes = {.n = 0};
	ts_sizes_set(&sizes, "P", 7);
	ts_sizes_set(&sizes, "P2", 11);
	ts_sizes_set(&sizes, "K", 25);
	ts_sizes_set(&sizes, "N", 1);
	ts_sizes_set(&sizes, "N", 0);
	ts_sizes_set(&sizes, "huge", UINT64_MAX);
	return sizes;
}

static void test_dims(void **state)
{
	(void)state;
	static const struct { const char *shape; u32 n; u64 dims[TS_MAX_DIMS]; } cases[] = {
		{"P", 1, {7}}, {"P2 4", 2, {11, 4}}, {"P*K+1", 1, {176}}, {"P K 3", 3, {7, 25, 3}}, {"N", 1, {0}}, {"N+1", 1, {1}},
		{"1", 1, {1}}, {"P2*4+1 2 3 4", 4, {45, 2, 3, 4}}, {"huge", 1, {UINT64_MAX}},
	};
	ts_sizes sizes = some();
	for (u32 i = 0; i < sizeof cases / sizeof *cases; i++) {
		u32 n;
		u64 dims[TS_MAX_DIMS];
		if (!ts_shape_dims(cases[i].shape, &sizes, &n, dims)) fail_msg("%s", cases[i].shape);
		assert_int_equal(n, cases[i].n);
		for (u32 d = 0; d < n; d++) assert_int_equal(dims[d], cases[i].dims[d]);
	}
}

static void test_refused(void **state)
{
	(void)state;
	static const char *const shapes[] = {"", "Q", "P Q", "P3", "huge*2", "huge+1", "huge*P+1", "1 2 3 4 5"};
	ts_sizes sizes = some();
	for (u32 i = 0; i < sizeof shapes / sizeof *shapes; i++) {
		u32 n;
		u64 dims[TS_MAX_DIMS];
		if (ts_shape_dims(shapes[i], &sizes, &n, dims)) fail_msg("\"%s\" is a shape", shapes[i]);
	}
}

static void test_count(void **state)
{
	(void)state;
	u64 n;
	assert_true(ts_shape_count(&n, 3, (u64[]){2, 3, 4}) && n == 24);
	assert_true(ts_shape_count(&n, 2, (u64[]){0, UINT64_MAX}) && n == 0);
	assert_true(ts_shape_count(&n, 2, (u64[]){UINT64_MAX, 0}) && n == 0);
	assert_false(ts_shape_count(&n, 2, (u64[]){1ull << 32, 1ull << 32}));
}

int main(void)
{
	const struct CMUnitTest shape[] = {
		cmocka_unit_test(test_dims),
		cmocka_unit_test(test_refused),
		cmocka_unit_test(test_count),
	};
	return cmocka_run_group_tests(shape, NULL, NULL);
}

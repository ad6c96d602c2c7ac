/* Cones of views: sums of directions along an axis are exact, and no cosine is above 1. */
#include "../../../src/kernels/views/view_octree_cone.h"
#include "../seeded.h"

enum { N_VIEWS = 20000 };

/* The cone of a leaf with that view alone. */
static ts_cone cone_of(ts_v3 direction, u64 sum[3])
{
	ts_vpl view = {.bounce = 1};
	ts_cone cone;
	ts_node node = {.parent = TS_NONE};
	u32 offset[2] = {0, 1}, entry = 0, leaf = 0, least = TS_NONE;
	ts_cone_args args = {&view, &node, offset, &entry, &leaf, sum, &least, &cone, 0};
	ts_store3(view.normal, direction);
	ts_k_cone_leaf_item(&args, 0);
	ts_k_cone_least_item(&args, 0);
	ts_k_cone_item(&args, 0);
	return cone;
}

static void test_axes(void **state)
{
	(void)state;
	for (u32 i = 0; i < 6; i++) {
		u64 sum[3];
		f32 d[3] = {0, 0, 0};
		d[i / 2] = i % 2 == 0 ? 1 : -1;
		ts_cone cone = cone_of(ts_load3(d), sum);
		for (u32 k = 0; k < 3; k++) {
			assert_true((i64)sum[k] == (i64)d[k] * (1 << 30));
			assert_true(cone.axis[k] == d[k]);
		}
		assert_true(cone.cosine == 1);
	}
}

/* Some products of a direction with itself are rounded to more than 1. */
static void test_cosine(void **state)
{
	(void)state;
	u32 n_above = 0;
	for (u32 i = 0; i < N_VIEWS; i++) {
		u64 sum[3];
		ts_v3 d = direction();
		ts_cone cone = cone_of(d, sum);
		n_above += ts_dot(d, ts_load3(cone.axis)) > 1;
		assert_true(cone.cosine <= 1 && cone.cosine > 1 - 4e-7f);
	}
	assert_true(n_above > N_VIEWS / 100);
}

int main(void)
{
	const struct CMUnitTest tests[] = {seeded_test(test_axes), seeded_test(test_cosine)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

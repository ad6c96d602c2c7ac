/* The primitive of culling against each of its operations rounded once. */
#include "kernels/points/vectors.h"
#include "tests/model/test.h"
#include "tests/vectors/rounded.h"

static u32 in[TS_VECTOR_ITEMS * TS_VECTOR_WORDS];
static _Alignas(8) u32 out[TS_VECTOR_ITEMS * TS_VECTOR_WORDS];

static void culling_rounds_each_operation_once(void **state)
{
	(void)state;
	assert_int_equal(TS_N_points_vectors, 1);
	ts_vector_make(ts_vectors_find("cull_threshold"), in, out);
	for (u32 i = 0; i < TS_VECTOR_ITEMS; i++) {
		f32 p = rsub(1, rmul(10, ts_u2f(in[i])));
		assert_int_equal(out[i], saturated((double)fixed(p, 24, 25), 0, 33554431));
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(culling_rounds_each_operation_once)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

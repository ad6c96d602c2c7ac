/* The self-test passes here, and sees a changed floating-point environment. tests/model/canary.sh changes the build. */
#include <fenv.h>
#include "model/core.h"
#include "tests/model/test.h"
#if defined(__SSE__)
#include <xmmintrin.h>
#endif

static void this_build_is_good(void **state)
{
	(void)state;
	assert_int_equal(ts_selftest(), 0);
	assert_int_equal(ts_selftest_require(), TS_OK);
}

static void rounding_upward_is_seen(void **state)
{
	(void)state;
	if (fesetround(FE_UPWARD) != 0) skip();
	unsigned bad = ts_selftest();
	ts_status status = ts_selftest_require();
	fesetround(FE_TONEAREST);
	assert_int_not_equal(bad & 8, 0);
	assert_int_equal(status, TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "rounding"));
	assert_non_null(strstr(ts_error_message(), "self-test: this build or process breaks the numeric contract"));
	assert_int_equal(ts_selftest(), 0);
}

static void flushed_denormals_are_seen(void **state)
{
	(void)state;
#if defined(__SSE__)
	unsigned before = _mm_getcsr();
	_mm_setcsr(before | 0x8000);
	unsigned results = ts_selftest();
	_mm_setcsr(before | 0x0040);
	unsigned operands = ts_selftest();
	_mm_setcsr(before);
	assert_int_equal(results, 2);
	assert_int_equal(operands, 4);
#else
	skip();
#endif
}

int main(void)
{
	const struct CMUnitTest selftest[] = {
		cmocka_unit_test(this_build_is_good),
		cmocka_unit_test(rounding_upward_is_seen),
		cmocka_unit_test(flushed_denormals_are_seen),
	};
	return cmocka_run_group_tests(selftest, NULL, NULL);
}

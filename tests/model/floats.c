/* Holds of the floating-point environment: nothing traps meanwhile, on any thread; then each has its own again. */
#define _GNU_SOURCE
#include <fenv.h>
#include <omp.h>
#include "model/core.h"
#include "tests/model/test.h"

enum { THREADS = 4, TRAPS = FE_INVALID | FE_DIVBYZERO };

static volatile float zero = 0.0f, sink;

/* Divides by zero on so many threads. */
static void divide(int threads)
{
#pragma omp parallel num_threads(threads)
	sink = 1.0f / zero;
}

/* Threads that trap these, and no others. */
static int trapping(int threads)
{
	int n = 0;
#pragma omp parallel num_threads(threads) reduction(+ : n)
	n += fegetexcept() == TRAPS;
	return n;
}

static int host_traps(void **state)
{
	(void)state;
	feclearexcept(FE_ALL_EXCEPT);
	return feenableexcept(TRAPS) == -1;
}

static int host_is_done(void **state)
{
	(void)state;
	return fedisableexcept(TRAPS) == -1;
}

static void threads_that_are_made_in_a_hold_do_not_trap(void **state)
{
	(void)state;
	assert_int_equal(ts_floats_hold(THREADS), THREADS);
	divide(THREADS);
	ts_floats_give();
	assert_int_equal(fegetexcept(), TRAPS);
	assert_int_equal(fetestexcept(FE_ALL_EXCEPT), 0);
	assert_int_equal(trapping(THREADS), THREADS);
}

/* Those of the host's own loops, and one that has other traps than the others. */
static void threads_that_were_there_get_back_what_they_had(void **state)
{
	(void)state;
	int n = 0;
	assert_int_equal(trapping(THREADS), THREADS);
#pragma omp parallel num_threads(THREADS)
	if (omp_get_thread_num() == 2) fedisableexcept(FE_INVALID);
	ts_floats_hold(THREADS);
	divide(THREADS);
	ts_floats_give();
#pragma omp parallel num_threads(THREADS) reduction(+ : n)
	n += fegetexcept() == (omp_get_thread_num() == 2 ? FE_DIVBYZERO : TRAPS);
	assert_int_equal(n, THREADS);
#pragma omp parallel num_threads(THREADS)
	feenableexcept(TRAPS);
}

static void a_hold_ends_with_the_outermost(void **state)
{
	(void)state;
	assert_int_equal(ts_floats_hold(1), 1);
	assert_int_equal(ts_floats_hold(THREADS), THREADS);
	ts_floats_hold(1);
	ts_floats_give();
	ts_floats_give();
	divide(THREADS);
	ts_floats_give();
	assert_int_equal(trapping(THREADS), THREADS);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test_setup_teardown(threads_that_are_made_in_a_hold_do_not_trap, host_traps, host_is_done),
		cmocka_unit_test_setup_teardown(threads_that_were_there_get_back_what_they_had, host_traps, host_is_done),
		cmocka_unit_test_setup_teardown(a_hold_ends_with_the_outermost, host_traps, host_is_done),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

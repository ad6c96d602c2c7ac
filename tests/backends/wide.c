/* A test can take the vector widths that other machines have; what is none, or is not here, is refused. */
#include "backends/wide.h"
#include "tests/status.h"

static const void *caller(void) { return __builtin_return_address(0); }
static const void *(*volatile asked)(void) = caller;

TS_WIDE(const void *, version, (void), ())
{
	const void *found = asked();
	__asm__ volatile("");
	return found;
}

static const void *version_with(unsigned lanes)
{
	ts_most_lanes = lanes;
	const void *found = version();
	ts_most_lanes = 16;
	return found;
}

static void each_width_has_its_own_version(void **state)
{
	(void)state;
#if defined(__x86_64__)
	assert_ptr_not_equal(version_with(4), NULL);
	assert_int_equal(version_with(8) != version_with(4), __builtin_cpu_supports("avx2") != 0);
	assert_int_equal(version_with(16) != version_with(8), __builtin_cpu_supports("avx512f") != 0);
#else
	assert_ptr_equal(version_with(4), version_with(16));
#endif
}

static void refused_as(const char *text, const char *why)
{
	setenv("TS_LANES", text, 1);
	refused(ts_lanes_choose(), why);
	assert_int_equal(ts_most_lanes, 16);
}

static void lanes_are_chosen_by_the_environment(void **state)
{
	(void)state;
	unsetenv("TS_LANES");
	require(ts_lanes_choose());
	assert_int_equal(ts_most_lanes, 16);
	refused_as("", "4, 8 or 16 would be right");
	refused_as("5", "TS_LANES=5: 4, 8 or 16 would be right");
	refused_as("16 ", "4, 8 or 16 would be right");
#if defined(__x86_64__)
	setenv("TS_LANES", "4", 1);
	require(ts_lanes_choose());
	assert_int_equal(ts_most_lanes, 4);
	ts_most_lanes = 16;
	if (!__builtin_cpu_supports("avx512f")) refused_as("16", "this processor has");
	if (!__builtin_cpu_supports("avx2")) refused_as("8", "this processor has 4");
#else
	refused_as("4", "only x86-64 has a choice");
#endif
	unsetenv("TS_LANES");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(each_width_has_its_own_version),
		cmocka_unit_test(lanes_are_chosen_by_the_environment),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

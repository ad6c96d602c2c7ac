/* cmocka and what it needs. */
#ifndef TS_TESTS_MODEL_TEST_H
#define TS_TESTS_MODEL_TEST_H
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Wants those above. */
#include <cmocka.h>

/* cmocka's own takes NaN to be near to any number. */
static inline void test_near(double a, double b, double epsilon, const char *file, int line)
{
	double apart = a > b ? a - b : b - a, most = epsilon * (a > b ? a : b);
	if (apart <= epsilon || apart <= most) return;
	print_error("%.17g is not near to %.17g\n", a, b);
	_fail(file, line);
}
#undef assert_float_equal
#define assert_float_equal(a, b, epsilon) test_near((double)(a), (double)(b), (double)(epsilon), __FILE__, __LINE__)

/* Whether memory is a sanitizer's, which keeps what is released. */
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TS_TEST_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TS_TEST_SANITIZED 1
#endif
#endif
#ifndef TS_TEST_SANITIZED
#define TS_TEST_SANITIZED 0
#endif
#endif

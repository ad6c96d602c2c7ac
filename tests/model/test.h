/* cmocka and what it needs. */
#ifndef TS_TESTS_CORE_TEST_H
#define TS_TESTS_CORE_TEST_H
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#endif

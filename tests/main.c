/* The tests of this folder as one program, which is linked once. It has a name for each test, as
 * build/release/tests/api/compare, and runs the test by whose name it is called. */
#include <stdio.h>
#include <string.h>

#define TEST(function, name) int test_##function(void);
#include "tests.inc"
#undef TEST

static const struct {
	const char *name;
	int (*run)(void);
} tests[] = {
#define TEST(function, name) {name, test_##function},
#include "tests.inc"
#undef TEST
};

int main(int n, char **word)
{
	const char *called = n > 0 ? strstr(word[0], "/tests/") : NULL;
	for (const char *next = called; next != NULL; next = strstr(called + 1, "/tests/")) called = next;
	for (size_t i = 0; called != NULL && i < sizeof tests / sizeof *tests; i++) {
		if (strcmp(tests[i].name, called + strlen("/tests/")) == 0) return tests[i].run();
	}
	fprintf(stderr, "tests: call it by the name of a test, as build/release/tests/api/compare\n");
	return 2;
}

/* A scratch folder of one test program. */
#ifndef TS_TESTS_SCRATCH_H
#define TS_TESTS_SCRATCH_H
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

enum { SCRATCH_PATH = 512 };

static char scratch_root[SCRATCH_PATH];

/* A group's setup. */
static inline int scratch_begin(void **state)
{
	(void)state;
	const char *tmp = getenv("TMPDIR");
	snprintf(scratch_root, sizeof scratch_root, "%.400s/touchstone-test-XXXXXX", tmp != NULL ? tmp : "/tmp");
	return mkdtemp(scratch_root) != NULL ? 0 : -1;
}

/* A group's teardown, where each test removes its files: what is left is a failure. */
static inline int scratch_end(void **state)
{
	(void)state;
	return rmdir(scratch_root);
}

/* A group's teardown, which removes all that is left. */
static inline int scratch_remove(void **state)
{
	(void)state;
	char command[2 * SCRATCH_PATH];
	snprintf(command, sizeof command, "rm -rf '%s'", scratch_root);
	return system(command);
}

/* A path in the scratch folder; one of eight that are valid at a time. */
static inline const char *scratch_path(const char *format, ...) __attribute__((format(printf, 1, 2)));
static inline const char *scratch_path(const char *format, ...)
{
	static char paths[8][SCRATCH_PATH];
	static int turn;
	char *path = paths[turn++ % 8];
	int n = snprintf(path, SCRATCH_PATH, "%s/", scratch_root);
	va_list arguments;
	va_start(arguments, format);
	vsnprintf(path + n, (size_t)(SCRATCH_PATH - n), format, arguments);
	va_end(arguments);
	return path;
}

#endif

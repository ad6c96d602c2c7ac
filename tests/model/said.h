/* What was printed on standard error. */
#ifndef TS_TESTS_MODEL_SAID_H
#define TS_TESTS_MODEL_SAID_H
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static FILE *said_file;
static int said_before;

/* From here on it goes to a file. */
static inline void said_begin(void)
{
	said_file = tmpfile();
	assert_non_null(said_file);
	fflush(stderr);
	said_before = dup(STDERR_FILENO);
	assert_true(said_before >= 0 && dup2(fileno(said_file), STDERR_FILENO) >= 0);
}

/* And from here on no more. The text is valid until the next call. */
static inline const char *said_end(void)
{
	static char text[4096];
	fflush(stderr);
	assert_true(dup2(said_before, STDERR_FILENO) >= 0);
	close(said_before);
	rewind(said_file);
	size_t n = fread(text, 1, sizeof text - 1, said_file);
	fclose(said_file);
	text[n] = 0;
	return text;
}

#endif

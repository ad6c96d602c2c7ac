/* A locale of a host program whose decimal point is a comma. localedef makes it, of texts that stand here, so no
 * machine lacks it. */
#ifndef TS_TESTS_COMMA_H
#define TS_TESTS_COMMA_H
#include <locale.h>
#include "tests/model/test.h"
#include "tests/scratch.h"

/* The characters of ASCII, by their codes. */
static inline void comma_write_characters(void)
{
	FILE *out = fopen(scratch_path("characters"), "w");
	assert_non_null(out);
	fprintf(out, "<code_set_name> ASCII\n<comment_char> %%\n<escape_char> /\nCHARMAP\n");
	for (int code = 0; code < 128; code++) fprintf(out, "<U%04X> /x%02x X\n", code, code);
	fprintf(out, "END CHARMAP\n");
	assert_int_equal(fclose(out), 0);
}

static inline void comma_write_locale(void)
{
	FILE *out = fopen(scratch_path("locale"), "w");
	assert_non_null(out);
	fprintf(out, "escape_char /\ncomment_char %%\nLC_CTYPE\nEND LC_CTYPE\n"
	             "LC_NUMERIC\ndecimal_point \",\"\nthousands_sep \".\"\ngrouping 3;3\nEND LC_NUMERIC\n");
	assert_int_equal(fclose(out), 0);
}

/* Until comma_end. */
static inline void comma_begin(void)
{
	char command[4 * SCRATCH_PATH], root[SCRATCH_PATH];
	void *state = NULL;
	memcpy(root, scratch_root, sizeof root);
	assert_int_equal(scratch_begin(&state), 0);
	comma_write_characters();
	comma_write_locale();
	snprintf(command, sizeof command, "localedef -c --no-archive -f '%s' -i '%s' '%s' 2> '%s'",
	         scratch_path("characters"), scratch_path("locale"), scratch_path("comma"), scratch_path("warnings"));
	int warned = system(command);
	setenv("LOCPATH", scratch_root, 1);
	const char *set = setlocale(LC_NUMERIC, "comma");
	unsetenv("LOCPATH");
	assert_int_equal(scratch_remove(&state), 0);
	memcpy(scratch_root, root, sizeof root);
	if (set == NULL || strtod("0,5", NULL) != 0.5) fail_msg("localedef made no locale with a comma: status %d", warned);
}

static inline void comma_end(void) { setlocale(LC_NUMERIC, "C"); }

#endif

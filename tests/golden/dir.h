/* What the tests of a golden's files share: an open folder, and files in it. */
#ifndef TS_TESTS_GOLDEN_DIR_H
#define TS_TESTS_GOLDEN_DIR_H
#include "golden/file.h"
#include "tests/scratch.h"
#include "tests/status.h"

static ts_golden_dir dir;

static inline int dir_begin(void **state)
{
	return scratch_begin(state) == 0 && ts_golden_dir_open(&dir, NULL, scratch_root) == TS_OK ? 0 : -1;
}

static inline int dir_end(void **state)
{
	ts_golden_dir_close(&dir);
	return scratch_remove(state);
}

static inline void write_file(const char *name, const void *data, size_t n)
{
	FILE *file = fopen(scratch_path("%s", name), "wb");
	assert_non_null(file);
	assert_int_equal(fwrite(data, 1, n, file), n);
	assert_int_equal(fclose(file), 0);
}

#endif

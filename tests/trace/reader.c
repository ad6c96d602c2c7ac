/* Reading elements in any order against the plain file, and files that change meanwhile. */
#include <fcntl.h>
#include "model/core.h"
#include "tests/lcg.h"
#include "tests/trace/folder.h"
#include "trace/reader.h"

static u32 seed = 17;

static char *make_file(const char *path, size_t bytes)
{
	char *data = malloc(bytes + 1);
	assert_non_null(data);
	for (size_t i = 0; i < bytes; i++) data[i] = (char)lcg_below(&seed, 256);
	file_write(path, data, bytes);
	return data;
}

/* Sizes that do and do not divide a block, more blocks than the cache holds. */
static void any_order_reads_the_same_elements(void **state)
{
	(void)state;
	static const size_t sizes[] = {1, 4, 8, 24, 48, 80, 96, 112};
	const char *path = scratch_path("random");
	for (u32 s = 0; s < sizeof sizes / sizeof *sizes; s++) {
		u64 n = 7 * 1000 * 1000 / sizes[s] + 3, held;
		char *data = make_file(path, 100 + n * sizes[s]);
		ts_reader *r = ts_reader_open(open(path, O_RDONLY), path, 100, n, sizes[s]);
		assert_non_null(r);
		for (u32 i = 0; i < 3000; i++) {
			u64 at = i % 3 == 0 ? n - 1 - lcg_below(&seed, 5) : i % 3 == 1 ? lcg_below(&seed, (u32)n) : i;
			const void *found = ts_reader_at(r, at, &held);
			assert_non_null(found);
			assert_true(held >= 1 && at + held <= n);
			assert_memory_equal(found, data + 100 + at * sizes[s], held * sizes[s]);
		}
		ts_reader_close(r);
		free(data);
	}
}

static void each_element_is_read_once_in_order(void **state)
{
	(void)state;
	u64 n = 5 * 1000 * 1000, held, at = 0;
	const char *path = scratch_path("stream");
	char *data = make_file(path, n);
	ts_reader *r = ts_reader_open(open(path, O_RDONLY), path, 0, n, 1);
	for (; at < n; at += held) {
		const void *found = ts_reader_at(r, at, &held);
		assert_non_null(found);
		assert_memory_equal(found, data + at, held);
	}
	assert_int_equal(at, n);
	ts_reader_close(r);
	free(data);
}

static void a_shortened_file_is_refused(void **state)
{
	(void)state;
	const char *path = scratch_path("shortened");
	u64 n = 1000 * 1000, held;
	free(make_file(path, 8 * n));
	ts_reader *r = ts_reader_open(open(path, O_RDONLY), path, 0, n, 8);
	assert_non_null(ts_reader_at(r, 0, &held));
	assert_int_equal(truncate(path, 4 * 1000 * 1000), 0);
	assert_null(ts_reader_at(r, n - 1, &held));
	says("shortened: is shorter than it was");
	assert_null(ts_reader_at(r, n - 1, &held));
	assert_non_null(ts_reader_at(r, 0, &held));
	ts_reader_close(r);
}

static void what_is_no_file_is_refused(void **state)
{
	(void)state;
	u64 held;
	ts_reader *r = ts_reader_open(open(scratch_root, O_RDONLY), scratch_root, 0, 1, 1);
	assert_null(ts_reader_at(r, 0, &held));
	says("directory");
	ts_reader_close(r);
	ts_reader_close(NULL);
}

int main(void)
{
	const struct CMUnitTest reader[] = {
		cmocka_unit_test(any_order_reads_the_same_elements),
		cmocka_unit_test(each_element_is_read_once_in_order),
		cmocka_unit_test(a_shortened_file_is_refused),
		cmocka_unit_test(what_is_no_file_is_refused),
	};
	return cmocka_run_group_tests(reader, scratch_begin, scratch_remove);
}

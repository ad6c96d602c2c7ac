/* Files of a port's outputs: their elements are read as they stand; what is no such file, or of another shape, is
 * refused without waiting, and what is not there is no failure. */
#include <fcntl.h>
#include <sys/stat.h>
#include "cli/vectors.h"
#include "output/npy.h"
#include "tests/model/test.h"
#include "tests/scratch.h"

enum { N = 6 };

static const u32 words[2 * N] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};

/* Writes the words as an array of that shape, without its last bytes. */
static void write_words(const char *path, const char *descr, u32 n_dims, const u64 *shape, size_t less)
{
	char header[TS_NPY_HEADER];
	size_t bytes = ts_npy_header(header, descr, n_dims, shape);
	assert_int_equal(ts_npy_write(path, header, bytes, words, sizeof words - less), TS_OK);
}

static ts_status read_words(u32 *found, bool *there)
{
	memset(found, 0xff, sizeof words);
	return ts_vectors_read(found, there, scratch_root, "a.npy", "'<u4'", sizeof *words, 2, (const u64[]){N, 2});
}

static void assert_refused(const char *why)
{
	u32 found[2 * N];
	bool there = false;
	assert_int_equal(read_words(found, &there), TS_ERROR);
	assert_true(there);
	assert_non_null(strstr(ts_error_message(), "a.npy: "));
	assert_non_null(strstr(ts_error_message(), why));
}

static void elements_are_read_as_they_stand(void **state)
{
	(void)state;
	u32 found[2 * N];
	bool there = true;
	assert_int_equal(read_words(found, &there), TS_OK);
	assert_false(there);
	assert_int_equal(found[0], 0xffffffffu);
	const char *path = scratch_path("a.npy");
	write_words(path, "'<u4'", 2, (const u64[]){N, 2}, 0);
	assert_int_equal(read_words(found, &there), TS_OK);
	assert_true(there);
	assert_memory_equal(found, words, sizeof words);
	unlink(path);
}

static void wrong_shapes_and_types_are_refused(void **state)
{
	(void)state;
	const char *path = scratch_path("a.npy");
	write_words(path, "'<u4'", 2, (const u64[]){2, N}, 0);
	assert_refused("shape (2, 6); (6, 2) would be right");
	write_words(path, "'<u4'", 1, (const u64[]){2 * N}, 0);
	assert_refused("shape (12,); (6, 2) would be right");
	write_words(path, "'<f4'", 2, (const u64[]){N, 2}, 0);
	assert_refused("f4");
	write_words(path, "'<u4'", 2, (const u64[]){N, 2}, 1);
	assert_refused("47 bytes of data; its shape needs 48");
	unlink(path);
}

/* Opening a pipe that nobody writes to would wait for a writer. */
static void a_pipe_is_refused_without_waiting(void **state)
{
	(void)state;
	const char *path = scratch_path("a.npy");
	assert_int_equal(mkfifo(path, 0600), 0);
	alarm(10);
	assert_refused("not a regular file");
	alarm(0);
	unlink(path);
	assert_int_equal(mkdir(path, 0700), 0);
	assert_refused("not a regular file");
	rmdir(path);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(elements_are_read_as_they_stand),
		cmocka_unit_test(wrong_shapes_and_types_are_refused),
		cmocka_unit_test(a_pipe_is_refused_without_waiting),
	};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_end);
}

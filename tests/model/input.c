/* Files read whole: what they hold, and what is no file. */
#include <sys/stat.h>
#include <unistd.h>
#include "model/core.h"
#include "tests/model/test.h"

static char path[64];

static void write_file(const char *data, size_t n)
{
	FILE *file = fopen(path, "wb");
	assert_true(file != NULL && fwrite(data, 1, n, file) == n && fclose(file) == 0);
}

static void files_give_all_bytes_and_a_zero(void **state)
{
	(void)state;
	static char data[100000];
	for (size_t i = 0; i < sizeof data; i++) data[i] = (char)(i * 2654435761u >> 24);
	for (size_t n = 0; n <= sizeof data; n = n * 7 + (n < 2)) {
		size_t bytes = 1;
		write_file(data, n);
		char *read = ts_input_read(&bytes, path);
		assert_non_null(read);
		assert_true(bytes == n && memcmp(read, data, n) == 0 && read[n] == 0);
		free(read);
		assert_int_equal(unlink(path), 0);
	}
}

/* A text is the same with a mark before it; half a mark is text. */
static void a_mark_before_a_text_is_passed_over(void **state)
{
	(void)state;
	static const char *const texts[][2] = {{"", ""},
	                                       {"a", "a"},
	                                       {"\xef\xbb\xbf", ""},
	                                       {"\xef\xbb\xbf"
	                                        "ab",
	                                        "ab"},
	                                       {"\xef\xbb", "\xef\xbb"},
	                                       {"a\xef\xbb\xbf", "a\xef\xbb\xbf"}};
	for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
		size_t bytes;
		write_file(texts[i][0], strlen(texts[i][0]));
		char *read = ts_text_read(&bytes, path);
		assert_non_null(read);
		assert_int_equal(bytes, strlen(texts[i][1]));
		assert_string_equal(read, texts[i][1]);
		free(read);
	}
	assert_int_equal(unlink(path), 0);
	size_t bytes;
	assert_null(ts_text_read(&bytes, path));
}

static void refuses(const char *words)
{
	size_t bytes;
	assert_null(ts_input_read(&bytes, path));
	assert_non_null(strstr(ts_error_message(), path));
	assert_non_null(strstr(ts_error_message(), words));
}

/* A pipe that nobody writes to is not waited for. */
static void only_regular_files_are_read(void **state)
{
	(void)state;
	refuses("No such file");
	assert_int_equal(mkfifo(path, 0600), 0);
	refuses("not a regular file");
	assert_int_equal(unlink(path), 0);
	assert_int_equal(mkdir(path, 0700), 0);
	refuses("not a regular file");
	assert_int_equal(rmdir(path), 0);
}

static void nothing_beyond_memory_is_read(void **state)
{
	(void)state;
	write_file("", 0);
	assert_int_equal(truncate(path, (off_t)(ts_memory_total() / 2)), 0);
	refuses("more than a third of this machine's memory");
	assert_int_equal(unlink(path), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(files_give_all_bytes_and_a_zero),
		cmocka_unit_test(a_mark_before_a_text_is_passed_over),
		cmocka_unit_test(only_regular_files_are_read),
		cmocka_unit_test(nothing_beyond_memory_is_read),
	};
	snprintf(path, sizeof path, "/tmp/touchstone-input-%d", (int)getpid());
	return cmocka_run_group_tests(tests, NULL, NULL);
}

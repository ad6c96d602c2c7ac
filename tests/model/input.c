/* Files read whole: what they hold, and what is no file. */
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include "model/input.h"
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
		char *read = ts_input_read(&bytes, path, n);
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
		char *read = ts_text_read(&bytes, path, 5);
		assert_non_null(read);
		assert_int_equal(bytes, strlen(texts[i][1]));
		assert_string_equal(read, texts[i][1]);
		free(read);
	}
	assert_int_equal(unlink(path), 0);
	size_t bytes;
	assert_null(ts_text_read(&bytes, path, TS_INPUT_ANY));
}

static void refuses(const char *words)
{
	size_t bytes;
	assert_null(ts_input_read(&bytes, path, TS_INPUT_ANY));
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

static void nothing_beyond_the_limit_is_read(void **state)
{
	(void)state;
	size_t bytes;
	write_file("12345", 5);
	assert_null(ts_input_read(&bytes, path, 4));
	assert_non_null(strstr(ts_error_message(), ": 5 bytes; at most 4 are read"));
	assert_null(ts_text_read(&bytes, path, 0));
	assert_int_equal(unlink(path), 0);
}

static void heads_are_as_long_as_asked_or_as_the_file(void **state)
{
	(void)state;
	char head[8] = "";
	size_t n = 1;
	assert_int_equal(ts_input_head(&n, head, sizeof head, path), TS_ERROR);
	write_file("12345", 5);
	assert_int_equal(ts_input_head(&n, head, 3, path), TS_OK);
	assert_true(n == 3 && memcmp(head, "123\0", 4) == 0);
	assert_int_equal(ts_input_head(&n, head, sizeof head, path), TS_OK);
	assert_int_equal(n, 5);
	assert_int_equal(unlink(path), 0);
}

static char *read_in(const char *dir, const char *name)
{
	size_t bytes;
	return ts_input_read_in(&bytes, dir, name, TS_INPUT_ANY);
}

/* In a folder, which may be named by a link: its file, that of its folder; a link at any place of a name is none. */
static void names_in_a_folder_are_no_links(void **state)
{
	(void)state;
	static const char *const good[] = {"file", "sub/file"}, *const links[] = {"link", "sub/link", "way/file"};
	char inner[128], to[128];
	assert_int_equal(mkdir(path, 0700), 0);
	snprintf(inner, sizeof inner, "%s/sub", path);
	assert_int_equal(mkdir(inner, 0700), 0);
	const int folder = open(path, O_RDONLY | O_DIRECTORY);
	for (size_t i = 0; i < 2; i++) {
		const int file = openat(folder, good[i], O_WRONLY | O_CREAT, 0600);
		assert_int_equal(write(file, good[i], strlen(good[i])), strlen(good[i]));
		close(file);
	}
	assert_true(symlinkat("file", folder, "link") == 0 && symlinkat("file", folder, "sub/link") == 0);
	assert_int_equal(symlinkat("sub", folder, "way"), 0);
	snprintf(to, sizeof to, "%s/to", path);
	assert_int_equal(symlink(path, to), 0);
	for (size_t i = 0; i < 4; i++) {
		char *text = read_in(i < 2 ? path : to, good[i % 2]);
		assert_string_equal(text, good[i % 2]);
		free(text);
	}
	for (size_t i = 0; i < 3; i++) {
		assert_null(read_in(path, links[i]));
		assert_non_null(strstr(ts_error_message(), links[i]));
	}
	assert_null(read_in(path, "none/file"));
	static const char *const all[] = {"to", "way", "link", "sub/link", "file", "sub/file"};
	for (size_t i = 0; i < 6; i++) assert_int_equal(unlinkat(folder, all[i], 0), 0);
	assert_true(unlinkat(folder, "sub", AT_REMOVEDIR) == 0 && close(folder) == 0 && rmdir(path) == 0);
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
		cmocka_unit_test(nothing_beyond_the_limit_is_read),
		cmocka_unit_test(heads_are_as_long_as_asked_or_as_the_file),
		cmocka_unit_test(names_in_a_folder_are_no_links),
		cmocka_unit_test(nothing_beyond_memory_is_read),
	};
	snprintf(path, sizeof path, "/tmp/touchstone-input-%d", (int)getpid());
	return cmocka_run_group_tests(tests, NULL, NULL);
}

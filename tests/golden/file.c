/* Files of goldens: read in any pieces, through interruptions, never beyond what is allowed or through links. */
#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include "tests/golden/dir.h"
#include "tests/kernels/seeded.h"

enum { BYTES = 1000 };

/* What read() answers, call by call: at most that many bytes, 0 an early end, or an error below 0. */
static const int *answers;

ssize_t read(int fd, void *to, size_t n)
{
	struct iovec part = {.iov_base = to, .iov_len = n};
	int answer = answers != NULL ? *answers++ : BYTES;
	if (answer < 0) errno = -answer;
	if (answer <= 0) return answer < 0 ? -1 : 0;
	if (part.iov_len > (size_t)answer) part.iov_len = (size_t)answer;
	return readv(fd, &part, 1);
}

static u8 data[BYTES];

static int begin(void **state)
{
	if (dir_begin(state) != 0) return -1;
	for (u32 i = 0; i < BYTES; i++) data[i] = (u8)bits();
	write_file("file", data, BYTES);
	if (symlink("file", scratch_path("link")) != 0 || mkdir(scratch_path("folder"), 0700) != 0) return -1;
	return symlink("folder", scratch_path("way"));
}

static void reads(const int *script)
{
	char *text;
	size_t bytes;
	answers = script;
	ts_status status = ts_golden_read_file(&text, &bytes, &dir, "file", BYTES);
	answers = NULL;
	if (status != TS_OK) fail_msg("%s", ts_error_message());
	assert_int_equal(bytes, BYTES);
	assert_memory_equal(text, data, BYTES);
	assert_int_equal(text[BYTES], 0);
	free(text);
}

static void refuses(const char *name, const int *script, size_t most, const char *words)
{
	char *text;
	size_t bytes;
	answers = script;
	ts_status status = ts_golden_read_file(&text, &bytes, &dir, name, most);
	answers = NULL;
	assert_int_equal(status, TS_ERROR);
	assert_null(text);
	says(words);
}

static void files_are_read_in_any_pieces(void **state)
{
	(void)state;
	reads(NULL);
	reads((const int[]){1, 998, 1});
	reads((const int[]){-EINTR, 500, -EINTR, -EINTR, 499, 7});
	refuses("file", (const int[]){400, 0}, BYTES, "it became shorter");
	refuses("file", (const int[]){400, -EACCES}, BYTES, strerror(EACCES));
}

static void links_and_folders_are_refused(void **state)
{
	(void)state;
	refuses("file", NULL, BYTES - 1, "1000 bytes; at most 999 are read");
	refuses("none", NULL, BYTES, strerror(ENOENT));
	refuses("link", NULL, BYTES, "a link; the file itself would be right");
	refuses("folder", NULL, BYTES, "not a regular file");
}

static void folders_are_opened_without_links(void **state)
{
	(void)state;
	ts_golden_dir inner;
	assert_int_equal(ts_golden_dir_open(&inner, &dir, "folder"), TS_OK);
	assert_string_equal(inner.path, scratch_path("folder"));
	assert_false(ts_golden_has(&inner, "file"));
	ts_golden_dir_close(&inner);
	assert_int_equal(inner.fd, -1);
	assert_int_equal(ts_golden_dir_open(&inner, NULL, scratch_path("way")), TS_OK);
	ts_golden_dir_close(&inner);
	assert_int_equal(ts_golden_dir_open(&inner, &dir, "way"), TS_ERROR);
	assert_int_equal(inner.fd, -1);
	assert_int_equal(ts_golden_dir_open(&inner, &dir, "file"), TS_ERROR);
	assert_true(ts_golden_has(&dir, "file") && ts_golden_has(&dir, "link") && ts_golden_has(&dir, "folder"));
}

/* A descriptor that is closed is the next one to be opened. */
static void a_closed_descriptor_is_free_again(void **state)
{
	(void)state;
	ts_golden_dir first, second;
	assert_int_equal(ts_golden_dir_open(&first, NULL, scratch_root), TS_OK);
	int fd = first.fd;
	ts_golden_dir_close(&first);
	reads(NULL);
	assert_int_equal(ts_golden_dir_open(&second, NULL, scratch_root), TS_OK);
	assert_int_equal(second.fd, fd);
	ts_golden_dir_close(&second);
}

/* A path may have one byte less than its room. */
static void a_path_a_byte_too_long_fails(void **state)
{
	(void)state;
	char path[TS_GOLDEN_PATH + 1];
	ts_golden_dir inner;
	for (size_t i = 0; i < TS_GOLDEN_PATH; i++) path[i] = i % 2 ? '/' : '.';
	path[TS_GOLDEN_PATH] = 0;
	assert_int_equal(ts_golden_dir_open(&inner, NULL, path), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "a path beyond 1023 bytes"));
	path[TS_GOLDEN_PATH - 1] = 0;
	assert_int_equal(ts_golden_dir_open(&inner, NULL, path), TS_OK);
	assert_string_equal(inner.path, path);
	ts_golden_dir_close(&inner);
}

typedef struct {
	u32 n, most;
	bool file, folder, link, way;
} names;

static ts_status take(void *user, const char *name)
{
	names *found = user;
	found->n++;
	found->file |= strcmp(name, "file") == 0;
	found->folder |= strcmp(name, "folder") == 0;
	found->link |= strcmp(name, "link") == 0;
	found->way |= strcmp(name, "way") == 0;
	return found->n < found->most ? TS_OK : TS_ERROR;
}

static void names_of_a_folder_are_listed(void **state)
{
	(void)state;
	names all = {.most = 100}, few = {.most = 2};
	assert_int_equal(ts_golden_names(&dir, take, &all), TS_OK);
	assert_int_equal(all.n, 4);
	assert_true(all.file && all.folder && all.link && all.way);
	assert_int_equal(ts_golden_names(&dir, take, &few), TS_ERROR);
	assert_int_equal(few.n, 2);
	ts_golden_dir none = {.fd = -1, .path = "nowhere"};
	assert_int_equal(ts_golden_names(&none, take, &all), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "nowhere: cannot list the folder: "));
	struct rlimit few_files, usual;
	assert_int_equal(getrlimit(RLIMIT_NOFILE, &usual), 0);
	few_files = (struct rlimit){.rlim_cur = 0, .rlim_max = usual.rlim_max};
	assert_int_equal(setrlimit(RLIMIT_NOFILE, &few_files), 0);
	ts_status status = ts_golden_names(&dir, take, &all);
	assert_int_equal(setrlimit(RLIMIT_NOFILE, &usual), 0);
	assert_int_equal(status, TS_ERROR);
	assert_non_null(strstr(ts_error_message(), strerror(EMFILE)));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(files_are_read_in_any_pieces),      cmocka_unit_test(links_and_folders_are_refused),
		cmocka_unit_test(folders_are_opened_without_links),  cmocka_unit_test(a_path_a_byte_too_long_fails),
		cmocka_unit_test(a_closed_descriptor_is_free_again), cmocka_unit_test(names_of_a_folder_are_listed),
	};
	return cmocka_run_group_tests(tests, begin, dir_end);
}

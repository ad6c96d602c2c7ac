/* Files that are written: what is put in is what is there, in any pieces; a disk that says no, a folder that is not
 * there, and what replaces another file. */
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include "output/file.h"
#include "tests/kernels/seeded.h"
#include "tests/scratch.h"

enum { MOST = 1 << 20 };

static size_t read_back(const char *path, u8 *data)
{
	FILE *file = fopen(path, "rb");
	assert_non_null(file);
	size_t n = fread(data, 1, MOST, file);
	fclose(file);
	return n;
}

static void holds(const char *path, const char *text)
{
	static u8 data[MOST];
	size_t n = read_back(path, data);
	assert_int_equal(n, strlen(text));
	assert_memory_equal(data, text, n);
}

/* Pieces of no byte, a few, and more than is held back. */
static void any_pieces_make_up_the_file(void **state)
{
	(void)state;
	static u8 data[MOST], back[MOST];
	for (u32 i = 0; i < MOST; i++) data[i] = (u8)bits();
	for (u32 turn = 0; turn < 40; turn++) {
		ts_file file;
		size_t n = 0;
		assert_int_equal(ts_file_begin(&file, scratch_path("pieces")), TS_OK);
		for (u32 k = 0; k < 24; k++) {
			static const u32 most[] = {1, 100, 1 << 16, 200000};
			size_t piece = bits() % most[bits() % 4];
			if (piece > MOST - n) break;
			assert_int_equal(ts_file_put(&file, data + n, piece), TS_OK);
			n += piece;
		}
		assert_int_equal(ts_file_end(&file), TS_OK);
		assert_int_equal(read_back(scratch_path("pieces"), back), n);
		assert_memory_equal(back, data, n);
	}
	unlink(scratch_path("pieces"));
}

static void fails_with(int error)
{
	assert_non_null(strstr(ts_error_message(), "cannot be written: "));
	assert_non_null(strstr(ts_error_message(), strerror(error)));
}

/* A full disk is told by the piece that does not fit, by all behind it, and by the end. */
static void a_full_disk_fails_every_piece(void **state)
{
	(void)state;
	static u8 data[MOST];
	ts_file file;
	assert_int_equal(ts_file_write("/dev/full", "a", 1), TS_ERROR);
	fails_with(ENOSPC);
	assert_int_equal(ts_file_write("/dev/full", data, MOST), TS_ERROR);
	fails_with(ENOSPC);
	assert_int_equal(ts_file_begin(&file, "/dev/full"), TS_OK);
	assert_int_equal(ts_file_put(&file, data, 100), TS_OK);
	assert_int_equal(ts_file_put(&file, data, 1 << 16), TS_ERROR);
	assert_int_equal(ts_file_put(&file, data, 1 << 16), TS_ERROR);
	fails_with(ENOSPC);
	assert_int_equal(ts_file_put(&file, data, 1), TS_OK); /* held back */
	assert_int_equal(ts_file_end(&file), TS_ERROR);
	fails_with(ENOSPC);
}

static void a_missing_folder_is_an_error(void **state)
{
	(void)state;
	ts_file file;
	assert_int_equal(ts_file_begin(&file, scratch_path("none/file")), TS_ERROR);
	fails_with(ENOENT);
	assert_int_equal(ts_file_replace(scratch_path("none/file"), "a", 1), TS_ERROR);
	fails_with(ENOENT);
	assert_null(strstr(ts_error_message(), ".partial"));
}

/* What was there is there until all is written. */
static void the_old_file_stays_until_the_end(void **state)
{
	(void)state;
	static u8 data[MOST];
	struct rlimit kept, low = {1000, RLIM_INFINITY};
	assert_int_equal(ts_file_replace(scratch_path("it"), "old", 3), TS_OK);
	holds(scratch_path("it"), "old");
	assert_int_equal(ts_file_replace(scratch_path("it"), "newer", 5), TS_OK);
	holds(scratch_path("it"), "newer");
	signal(SIGXFSZ, SIG_IGN);
	getrlimit(RLIMIT_FSIZE, &kept);
	low.rlim_max = kept.rlim_max;
	assert_int_equal(setrlimit(RLIMIT_FSIZE, &low), 0);
	ts_status status = ts_file_replace(scratch_path("it"), data, MOST);
	setrlimit(RLIMIT_FSIZE, &kept);
	assert_int_equal(status, TS_ERROR);
	fails_with(EFBIG);
	holds(scratch_path("it"), "newer");
	assert_int_equal(access(scratch_path("it.partial"), F_OK), -1);
	unlink(scratch_path("it"));
}

static void a_pipe_stays_a_pipe(void **state)
{
	(void)state;
	assert_int_equal(mkfifo(scratch_path("pipe"), 0600), 0);
	pid_t reader = fork();
	if (reader == 0) {
		static u8 data[MOST];
		_exit(read_back(scratch_path("pipe"), data) == 3 && memcmp(data, "abc", 3) == 0 ? 0 : 1);
	}
	int told;
	assert_int_equal(ts_file_replace(scratch_path("pipe"), "abc", 3), TS_OK);
	assert_int_equal(waitpid(reader, &told, 0), reader);
	assert_int_equal(told, 0);
	struct stat there;
	assert_int_equal(stat(scratch_path("pipe"), &there), 0);
	assert_true(S_ISFIFO(there.st_mode));
	unlink(scratch_path("pipe"));
}

/* A link stays, and so what it leads to is written: /dev/stdout is one. */
static void a_link_stays_a_link(void **state)
{
	(void)state;
	struct stat there;
	char *link = strdup(scratch_path("link"));
	assert_int_equal(ts_file_write(scratch_path("end"), "a longer text", 13), TS_OK);
	assert_int_equal(symlink("end", link), 0);
	assert_int_equal(ts_file_replace(link, "abc", 3), TS_OK);
	assert_true(lstat(link, &there) == 0 && S_ISLNK(there.st_mode));
	assert_true(stat(scratch_path("end"), &there) == 0 && there.st_size == 3);
	unlink(scratch_path("end"));
	unlink(link);
	free(link);
}

/* The end of a file releases its memory, and nothing can be put into the file any more. */
static void the_end_releases_the_file(void **state)
{
	(void)state;
	ts_file file;
	assert_int_equal(ts_file_begin(&file, scratch_path("end")), TS_OK);
	assert_non_null(file.held);
	int descriptor = file.descriptor;
	assert_int_equal(ts_file_put(&file, "abc", 3), TS_OK);
	assert_int_equal(ts_file_end(&file), TS_OK);
	assert_true(file.held == NULL && file.descriptor == -1 && fcntl(descriptor, F_GETFD) == -1);
	unlink(scratch_path("end"));
}

/* Standard output, as a file or a full disk. */
static ts_status printed(const char *to, const char *what, bool as_text)
{
	ts_file_text text;
	fflush(stdout);
	int kept = dup(STDOUT_FILENO), there = open(to, O_WRONLY | O_CREAT | O_TRUNC, 0600);
	dup2(there, STDOUT_FILENO);
	close(there);
	ts_status status;
	if (as_text) {
		status = ts_file_text_begin(&text, "text");
		fputs(what, text.out);
		status = status == TS_OK ? ts_file_text_print(&text) : status;
	} else {
		status = ts_file_print(what, strlen(what));
	}
	dup2(kept, STDOUT_FILENO);
	close(kept);
	return status;
}

static void printing_to_a_full_disk_fails(void **state)
{
	(void)state;
	const char *path = scratch_path("printed");
	for (u32 as_text = 0; as_text < 2; as_text++) {
		assert_int_equal(printed(path, "some text", as_text == 1), TS_OK);
		holds(path, "some text");
		assert_int_equal(printed("/dev/full", "some text", as_text == 1), TS_ERROR);
		assert_non_null(strstr(ts_error_message(), "standard output: cannot be written: "));
	}
	unlink(path);
}

static void a_text_is_written_as_printed(void **state)
{
	(void)state;
	ts_file_text text;
	assert_int_equal(ts_file_text_begin(&text, "text"), TS_OK);
	fprintf(text.out, "%d lines\n", 2);
	fputs("and an end", text.out);
	assert_int_equal(ts_file_text_write(&text, scratch_path("text")), TS_OK);
	holds(scratch_path("text"), "2 lines\nand an end");
	assert_int_equal(ts_file_text_begin(&text, "text"), TS_OK);
	assert_int_equal(ts_file_text_replace(&text, scratch_path("text")), TS_OK);
	holds(scratch_path("text"), "");
	unlink(scratch_path("text"));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(any_pieces_make_up_the_file),   cmocka_unit_test(a_full_disk_fails_every_piece),
		cmocka_unit_test(a_missing_folder_is_an_error),  cmocka_unit_test(the_old_file_stays_until_the_end),
		cmocka_unit_test(a_pipe_stays_a_pipe),           cmocka_unit_test(a_link_stays_a_link),
		cmocka_unit_test(a_text_is_written_as_printed),  cmocka_unit_test(the_end_releases_the_file),
		cmocka_unit_test(printing_to_a_full_disk_fails),
	};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_end);
}

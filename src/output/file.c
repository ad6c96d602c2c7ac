/* Writing files, and text for them that is gathered in memory first: glibc's own streams in memory silently lose bytes
 * when memory ends. */
#define _GNU_SOURCE
#include "output/file.h"
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "output/left.h"
#include "output/lock.h"
#include "output/tree.h"

enum { HELD = 1 << 16, PART = 1 << 24 };

static ts_status fail(ts_file *file, int error)
{
	if (file->error == 0) file->error = error != 0 ? error : EIO;
	return ts_fail_as(TS_KIND_FILE, "%s: cannot be written: %s", file->path, strerror(file->error));
}

ts_status ts_file_adopt(ts_file *file, int descriptor, const char *path)
{
	*file = (ts_file){.path = path, .descriptor = descriptor};
	if (descriptor < 0) return fail(file, errno);
	file->held = ts_alloc(HELD, 1, path);
	if (file->held != NULL) return TS_OK;
	ts_file_drop(file);
	return TS_ERROR;
}

ts_status ts_file_begin(ts_file *file, const char *path)
{
	return ts_file_adopt(file, open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666), path);
}

static ts_status write_out(ts_file *file, const uint8_t *data, size_t bytes)
{
	if (file->error != 0) return fail(file, 0);
	ts_stop *stop = ts_stop_here();
	while (bytes > 0) {
		if (bytes >= PART && ts_stopped(stop)) return ts_go_on();
		ssize_t n = write(file->descriptor, data, bytes < PART ? bytes : PART);
		if (n < 0 && errno == EINTR) continue;
		if (n <= 0) return fail(file, n < 0 ? errno : EIO);
		data += n;
		bytes -= (size_t)n;
	}
	return TS_OK;
}

static ts_status write_held(ts_file *file)
{
	size_t bytes = file->n_held;
	file->n_held = 0;
	return write_out(file, file->held, bytes);
}

ts_status ts_file_put(ts_file *file, const void *data, size_t bytes)
{
	if (bytes > HELD - file->n_held && write_held(file) != TS_OK) return TS_ERROR;
	if (bytes >= HELD) return write_out(file, data, bytes);
	if (bytes > 0) memcpy(file->held + file->n_held, data, bytes);
	file->n_held += bytes;
	return TS_OK;
}

int ts_sync(int descriptor)
{
	int bad;
	while ((bad = fsync(descriptor)) != 0 && errno == EINTR) {
	}
	return bad == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : errno;
}

static ts_status write_rest(ts_file *file)
{
	if (write_held(file) != TS_OK) return TS_ERROR;
	int error = ts_sync(file->descriptor);
	return error == 0 ? TS_OK : fail(file, error);
}

ts_status ts_file_end(ts_file *file)
{
	ts_status status = write_rest(file);
	bool closed = close(file->descriptor) == 0 || errno == EINTR;
	if (status == TS_OK && !closed) status = fail(file, errno);
	file->descriptor = -1;
	ts_file_drop(file);
	return status;
}

void ts_file_drop(ts_file *file)
{
	if (file->descriptor >= 0) close(file->descriptor);
	free(file->held);
	*file = (ts_file){.descriptor = -1};
}

ts_status ts_file_write(const char *path, const void *data, size_t bytes)
{
	ts_file file;
	if (ts_file_begin(&file, path) != TS_OK) return TS_ERROR;
	if (ts_file_put(&file, data, bytes) == TS_OK) return ts_file_end(&file);
	ts_file_drop(&file);
	return TS_ERROR;
}

ts_status ts_file_print(const void *data, size_t bytes)
{
	ts_file file = {.path = "standard output", .descriptor = STDOUT_FILENO};
	errno = 0;
	bool whole = fflush(stdout) == 0 && ferror(stdout) == 0;
	return whole ? write_out(&file, data, bytes) : fail(&file, errno);
}

/* The lock is held until the file is in its place. */
static ts_status fill(const ts_lock *lock, const char *partial, const char *path, const void *data, size_t bytes)
{
	ts_file file;
	ts_status status = ts_file_adopt(&file, lock->descriptor, path);
	if (status == TS_OK && ftruncate(lock->descriptor, 0) != 0) status = fail(&file, errno);
	if (status == TS_OK) status = ts_file_put(&file, data, bytes);
	if (status == TS_OK) status = write_rest(&file);
	if (status == TS_OK && rename(partial, path) != 0) status = fail(&file, errno);
	if (status != TS_OK) unlink(partial);
	ts_file_drop(&file);
	return status;
}

ts_status ts_file_replace(const char *path, const void *data, size_t bytes)
{
	struct stat there;
	ts_lock lock;
	if (lstat(path, &there) == 0 && !S_ISREG(there.st_mode)) return ts_file_write(path, data, bytes);
	size_t n = strlen(path) + sizeof ".partial";
	char *partial = ts_alloc(n, 1, path);
	if (partial == NULL) return TS_ERROR;
	snprintf(partial, n, "%s.partial", path);
	sigset_t all, before;
	sigfillset(&all);
	pthread_sigmask(SIG_BLOCK, &all, &before); /* who ends this process now would leave the file */
	ts_status status = ts_lock_take(&lock, partial, path);
	if (status == TS_OK) ts_left_file(partial);
	pthread_sigmask(SIG_SETMASK, &before, NULL);
	if (status == TS_OK) {
		status = fill(&lock, partial, path, data, bytes);
		ts_left_file("");
	}
	if (status == TS_OK) status = ts_parent_sync(path);
	free(partial);
	return status;
}

static ssize_t append(void *user, const char *data, size_t bytes)
{
	ts_file_text *text = user;
	void *grown = text->text;
	if (ts_grow(&grown, &text->capacity, text->bytes + bytes + 1, 1, "text") != TS_OK) return 0;
	text->text = grown;
	memcpy(text->text + text->bytes, data, bytes);
	text->bytes += bytes;
	text->text[text->bytes] = 0;
	return (ssize_t)bytes;
}

ts_status ts_file_text_begin(ts_file_text *text, const char *what)
{
	*text = (ts_file_text){.out = NULL};
	text->out = fopencookie(text, "w", (cookie_io_functions_t){.write = append});
	return text->out != NULL ? TS_OK : ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", what);
}

void ts_file_text_drop(ts_file_text *text)
{
	fclose(text->out);
	free(text->text);
	*text = (ts_file_text){.out = NULL};
}

ts_status ts_file_text_flush(ts_file_text *text, const char *what)
{
	return fflush(text->out) == 0 && ferror(text->out) == 0 ? TS_OK
	                                                        : ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", what);
}

ts_status ts_file_text_close(ts_file_text *text, const char *what)
{
	bool whole = fflush(text->out) == 0 && ferror(text->out) == 0 && append(text, "", 0) == 0 && text->text != NULL;
	whole &= fclose(text->out) == 0;
	text->out = NULL;
	if (whole) return TS_OK;
	free(text->text);
	*text = (ts_file_text){.out = NULL};
	return ts_fail_as(TS_KIND_MEMORY, "%s: out of memory", what);
}

typedef ts_status writer(const char *path, const void *data, size_t bytes);

static ts_status end(ts_file_text *text, const char *path, writer *write)
{
	if (ts_file_text_close(text, path) != TS_OK) return TS_ERROR;
	ts_status status = write(path, text->text, text->bytes);
	free(text->text);
	*text = (ts_file_text){.out = NULL};
	return status;
}

static ts_status print(const char *path, const void *data, size_t bytes)
{
	(void)path;
	return ts_file_print(data, bytes);
}

ts_status ts_file_text_write(ts_file_text *text, const char *path) { return end(text, path, ts_file_write); }
ts_status ts_file_text_replace(ts_file_text *text, const char *path) { return end(text, path, ts_file_replace); }
ts_status ts_file_text_print(ts_file_text *text) { return end(text, "standard output", print); }

/* A library to be preloaded: the process kills itself before the n-th of those calls that change the disk, n being what
 * TOUCHSTONE_KILL_AT says; counting starts when a lock, *.lock, is made. The count goes to TOUCHSTONE_KILL_COUNT. With
 * TOUCHSTONE_KILL_NO_EXCHANGE the file system cannot exchange folders. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static long count = -1;

static void write_count(void)
{
	const char *path = getenv("TOUCHSTONE_KILL_COUNT");
	FILE *file = path != NULL ? fopen(path, "w") : NULL;
	if (file == NULL) return;
	fprintf(file, "%ld\n", count);
	fclose(file);
}

static void step(void)
{
	const char *at = getenv("TOUCHSTONE_KILL_AT");
	if (count >= 0 && ++count == (at != NULL ? atol(at) : 0)) kill(getpid(), SIGKILL);
}

static void begin(const char *path)
{
	size_t n = strlen(path);
	if (count >= 0 || n < 5 || strcmp(path + n - 5, ".lock") != 0) return;
	count = 0;
	atexit(write_count);
}

int mkdir(const char *path, mode_t mode)
{
	int (*next)(const char *, mode_t) = (int (*)(const char *, mode_t))dlsym(RTLD_NEXT, "mkdir");
	step();
	return next(path, mode);
}

int open(const char *path, int flags, ...)
{
	int (*next)(const char *, int, ...) = (int (*)(const char *, int, ...))dlsym(RTLD_NEXT, "open");
	va_list rest;
	va_start(rest, flags);
	mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
	va_end(rest);
	if ((flags & O_CREAT) != 0) {
		begin(path);
		step();
	}
	return next(path, flags, mode);
}

ssize_t write(int file, const void *data, size_t bytes)
{
	ssize_t (*next)(int, const void *, size_t) = (ssize_t(*)(int, const void *, size_t))dlsym(RTLD_NEXT, "write");
	step();
	return next(file, data, bytes);
}

int fsync(int file)
{
	int (*next)(int) = (int (*)(int))dlsym(RTLD_NEXT, "fsync");
	step();
	return next(file);
}

int rename(const char *from, const char *to)
{
	int (*next)(const char *, const char *) = (int (*)(const char *, const char *))dlsym(RTLD_NEXT, "rename");
	step();
	return next(from, to);
}

int renameat2(int from_folder, const char *from, int to_folder, const char *to, unsigned flags)
{
	int (*next)(int, const char *, int, const char *, unsigned) =
		(int (*)(int, const char *, int, const char *, unsigned))dlsym(RTLD_NEXT, "renameat2");
	step();
	if (getenv("TOUCHSTONE_KILL_NO_EXCHANGE") == NULL) return next(from_folder, from, to_folder, to, flags);
	errno = EINVAL;
	return -1;
}

int remove(const char *path)
{
	int (*next)(const char *) = (int (*)(const char *))dlsym(RTLD_NEXT, "remove");
	step();
	return next(path);
}

int unlink(const char *path)
{
	int (*next)(const char *) = (int (*)(const char *))dlsym(RTLD_NEXT, "unlink");
	step();
	return next(path);
}

int rmdir(const char *path)
{
	int (*next)(const char *) = (int (*)(const char *))dlsym(RTLD_NEXT, "rmdir");
	step();
	return next(path);
}

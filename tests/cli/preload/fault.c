/* A library to be preloaded: of the calls TOUCHSTONE_FAULT_CALL ("open" of a file to be made, "write", "fsync" or
 * "rename") the n-th fails, n being what TOUCHSTONE_FAULT_AT says, with the error TOUCHSTONE_FAULT_ERROR; with 0 a
 * write is short. How many there were goes to the file TOUCHSTONE_FAULT_COUNT. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static long count;

static long number(const char *variable)
{
	const char *text = getenv(variable);
	return text != NULL ? atol(text) : 0;
}

static void write_count(void)
{
	const char *path = getenv("TOUCHSTONE_FAULT_COUNT");
	FILE *file = path != NULL ? fopen(path, "w") : NULL;
	if (file == NULL) return;
	fprintf(file, "%ld\n", count);
	fclose(file);
}

/* The n-th of the calls that are meant. */
static bool is_it(const char *call)
{
	const char *meant = getenv("TOUCHSTONE_FAULT_CALL");
	if (meant == NULL || strcmp(meant, call) != 0) return false;
	if (count == 0) atexit(write_count);
	return ++count == number("TOUCHSTONE_FAULT_AT");
}

static int fail(void)
{
	errno = (int)number("TOUCHSTONE_FAULT_ERROR");
	return -1;
}

int open(const char *path, int flags, ...)
{
	int (*next)(const char *, int, ...) = (int (*)(const char *, int, ...))dlsym(RTLD_NEXT, "open");
	va_list rest;
	va_start(rest, flags);
	mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
	va_end(rest);
	return (flags & O_CREAT) != 0 && is_it("open") ? fail() : next(path, flags, mode);
}

ssize_t write(int file, const void *data, size_t bytes)
{
	ssize_t (*next)(int, const void *, size_t) = (ssize_t(*)(int, const void *, size_t))dlsym(RTLD_NEXT, "write");
	if (!is_it("write")) return next(file, data, bytes);
	return number("TOUCHSTONE_FAULT_ERROR") != 0 ? fail() : next(file, data, (bytes + 1) / 2);
}

int fsync(int file)
{
	int (*next)(int) = (int (*)(int))dlsym(RTLD_NEXT, "fsync");
	return is_it("fsync") ? fail() : next(file);
}

int rename(const char *from, const char *to)
{
	int (*next)(const char *, const char *) = (int (*)(const char *, const char *))dlsym(RTLD_NEXT, "rename");
	return is_it("rename") ? fail() : next(from, to);
}

/* A library to be preloaded: what is opened with a name that begins with TOUCHSTONE_ABSENT is not installed. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

void *dlopen(const char *path, int how)
{
	void *(*next)(const char *, int);
	void *symbol = dlsym(RTLD_NEXT, "dlopen");
	const char *absent = getenv("TOUCHSTONE_ABSENT");
	memcpy(&next, &symbol, sizeof next);
	if (path == NULL || absent == NULL || strncmp(path, absent, strlen(absent)) != 0) return next(path, how);
	return next("libabsent.so", how);
}

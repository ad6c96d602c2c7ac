/* What the C library does itself, or by more than one system call: memory, threads, processes. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <stddef.h>
#include <sys/auxv.h>
#include <sys/mman.h>
#include <unistd.h>
#include "tests/faults/fault.h"

/* The function that would have been called, looked up once; two threads may both do it. */
#define NEXT(name) \
	static __typeof__(&name) next; \
	if (next == NULL) next = (__typeof__(&name))dlsym(RTLD_NEXT, #name)

/* What opening a library takes is counted apart: it can be most of it. */
static _Thread_local int opening;

/* Code of the command itself, and of no library. */
static bool is_own(void *code)
{
	Dl_info of, ours;
	return dladdr(code, &of) != 0 && dladdr((void *)getauxval(AT_ENTRY), &ours) != 0 && of.dli_fbase == ours.dli_fbase;
}

static bool fails(void *caller)
{
	if (ts_fault_watches(TS_OWN)) return is_own(caller) && ts_fault_is(TS_OWN);
	return ts_fault_is(opening > 0 ? TS_LOAD : TS_MEMORY);
}
#define no_memory() fails(__builtin_return_address(0))

void *dlopen(const char *path, int how)
{
	NEXT(dlopen);
	opening++;
	void *library = next(path, how);
	opening--;
	return library;
}

void *malloc(size_t bytes)
{
	NEXT(malloc);
	return no_memory() ? NULL : next(bytes);
}

void *calloc(size_t n, size_t size)
{
	NEXT(calloc);
	return no_memory() ? NULL : next(n, size);
}

void *realloc(void *data, size_t bytes)
{
	NEXT(realloc);
	return no_memory() ? NULL : next(data, bytes);
}

void *aligned_alloc(size_t align, size_t bytes)
{
	NEXT(aligned_alloc);
	return no_memory() ? NULL : next(align, bytes);
}

void *memalign(size_t align, size_t bytes)
{
	NEXT(memalign);
	return no_memory() ? NULL : next(align, bytes);
}

int posix_memalign(void **made, size_t align, size_t bytes)
{
	NEXT(posix_memalign);
	return no_memory() ? ENOMEM : next(made, align, bytes);
}

void *mmap(void *at, size_t bytes, int access, int flags, int file, off_t from)
{
	NEXT(mmap);
	return ts_fault_is(TS_MAP) ? MAP_FAILED : next(at, bytes, access, flags, file, from);
}

void *mmap64(void *at, size_t bytes, int access, int flags, int file, off64_t from)
{
	NEXT(mmap64);
	return ts_fault_is(TS_MAP) ? MAP_FAILED : next(at, bytes, access, flags, file, from);
}

int pthread_create(pthread_t *thread, const pthread_attr_t *how, void *(*run)(void *), void *of)
{
	NEXT(pthread_create);
	return ts_fault_is(TS_THREAD) ? EAGAIN : next(thread, how, run, of);
}

pid_t fork(void)
{
	NEXT(fork);
	return ts_fault_is(TS_PROCESS) ? -1 : next();
}

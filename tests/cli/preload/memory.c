/* A library to be preloaded: the n-th allocation, and no other, finds no memory, n being what TOUCHSTONE_FAULT_AT says.
 * How many there were goes to the file TOUCHSTONE_FAULT_COUNT. */
#include <errno.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

extern void *__libc_malloc(size_t bytes);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_realloc(void *data, size_t bytes);

static long count, at = -1;

static int fails(void)
{
	if (at < 0) {
		const char *text = getenv("TOUCHSTONE_FAULT_AT");
		at = text != NULL ? atol(text) : 0;
	}
	if (__atomic_add_fetch(&count, 1, __ATOMIC_RELAXED) != at) return 0;
	errno = ENOMEM;
	return 1;
}

void *malloc(size_t bytes) { return fails() ? NULL : __libc_malloc(bytes); }
void *calloc(size_t n, size_t size) { return fails() ? NULL : __libc_calloc(n, size); }
void *realloc(void *data, size_t bytes) { return fails() ? NULL : __libc_realloc(data, bytes); }

__attribute__((destructor)) static void write_count(void)
{
	const char *path = getenv("TOUCHSTONE_FAULT_COUNT");
	long n = count;
	FILE *file = path != NULL ? fopen(path, "w") : NULL;
	if (file == NULL) return;
	fprintf(file, "%ld\n", n);
	fclose(file);
}

/* Memory: sizes that cannot overflow, and a message instead of a crash. */
#define _DEFAULT_SOURCE /* madvise */
#include <stdlib.h>
#include <sys/mman.h>
#include "model/core.h"

enum { LARGE_BYTES = 8 << 20 }; /* smaller blocks, or zeroed ones, may be touched only in places */

/* A system without large pages refuses, which is harmless. */
void ts_memory_large_pages(void *memory, size_t bytes)
{
	const uintptr_t large = (uintptr_t)2 << 20;
	uintptr_t begin = ((uintptr_t)memory + large - 1) / large * large;
	uintptr_t end = ((uintptr_t)memory + bytes) / large * large;
	if (begin < end) (void)madvise((void *)begin, end - begin, MADV_HUGEPAGE);
}

static void *allocate(size_t count, size_t size, const char *what, bool zero)
{
	if (size != 0 && count > (size_t)PTRDIFF_MAX / size) {
		ts_fail_as(TS_KIND_MEMORY, "%s: %zu elements of %zu bytes are more than a process can address", what, count,
		           size);
		return NULL;
	}
	size_t bytes = count * size;
	size_t at_least_one = bytes ? bytes : 1;
	void *memory = zero ? calloc(at_least_one, 1) : malloc(at_least_one);
	if (!memory)
		ts_fail_as(TS_KIND_MEMORY, "%s: no memory for %zu elements of %zu bytes (%zu MiB)", what, count, size,
		           bytes >> 20);
	if (memory && !zero && bytes >= LARGE_BYTES) ts_memory_large_pages(memory, bytes);
	return memory;
}

void *ts_alloc(size_t count, size_t size, const char *what) { return allocate(count, size, what, false); }

void *ts_alloc_zero(size_t count, size_t size, const char *what) { return allocate(count, size, what, true); }

ts_status ts_grow(void **array, size_t *capacity, size_t need, size_t size, const char *what)
{
	if (need <= *capacity) return TS_OK;
	size_t most = (size_t)PTRDIFF_MAX / (size ? size : 1);
	if (need > most) {
		return ts_fail_as(TS_KIND_MEMORY, "%s: %zu elements of %zu bytes are more than a process can address", what,
		                  need, size);
	}
	size_t twice = *capacity > most / 2 ? most : 2 * *capacity;
	size_t count = need > twice ? need : twice;
	count = count < 16 && most >= 16 ? 16 : count;
	void *grown = realloc(*array, size ? count * size : 1);
	if (!grown) {
		return ts_fail_as(TS_KIND_MEMORY, "%s: no memory for %zu elements of %zu bytes (%zu MiB)", what, count, size,
		                  count * size >> 20);
	}
	*array = grown;
	*capacity = count;
	return TS_OK;
}

/* Memory: sizes that cannot overflow, and a message instead of a crash. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include "core.h"
#ifdef __GLIBC_PREREQ
#if __GLIBC_PREREQ(2, 33)
#include <malloc.h>
#define HAS_MALLINFO2
#endif
#endif

static void *allocate(size_t count, size_t size, const char *what, bool zero)
{
	if (size != 0 && count > (size_t)PTRDIFF_MAX / size) {
		ts_fail("%s: %zu elements of %zu bytes are more than a process can address", what, count, size);
		return NULL;
	}
	size_t bytes = count * size;
	size_t at_least_one = bytes ? bytes : 1;
	void *memory = zero ? calloc(at_least_one, 1) : malloc(at_least_one);
	if (!memory) ts_fail("%s: no memory for %zu elements of %zu bytes (%zu MiB)", what, count, size, bytes >> 20);
	return memory;
}

void *ts_alloc(size_t count, size_t size, const char *what) { return allocate(count, size, what, false); }

void *ts_alloc_zero(size_t count, size_t size, const char *what) { return allocate(count, size, what, true); }

ts_status ts_grow(void **array, size_t *capacity, size_t need, size_t size, const char *what)
{
	if (need <= *capacity) return TS_OK;
	size_t most = (size_t)PTRDIFF_MAX / (size ? size : 1);
	if (need > most) {
		return ts_fail("%s: %zu elements of %zu bytes are more than a process can address", what, need, size);
	}
	size_t twice = *capacity > most / 2 ? most : 2 * *capacity;
	size_t count = need > twice ? need : twice;
	count = count < 16 && most >= 16 ? 16 : count;
	void *grown = realloc(*array, size ? count * size : 1);
	if (!grown) {
		return ts_fail("%s: no memory for %zu elements of %zu bytes (%zu MiB)", what, count, size, count * size >> 20);
	}
	*array = grown;
	*capacity = count;
	return TS_OK;
}

/* What a container grants (cgroup 2), or UINT64_MAX. */
static uint64_t container_limit(void)
{
	uint64_t limit = UINT64_MAX;
	FILE *file = fopen("/sys/fs/cgroup/memory.max", "r");
	if (file) {
		if (fscanf(file, "%" SCNu64, &limit) != 1) limit = UINT64_MAX;
		fclose(file);
	}
	return limit;
}

uint64_t ts_memory_total(void)
{
	long pages = sysconf(_SC_PHYS_PAGES);
	long page_bytes = sysconf(_SC_PAGESIZE);
	uint64_t machine = pages > 0 && page_bytes > 0 ? (uint64_t)pages * (uint64_t)page_bytes : UINT64_MAX;
	uint64_t container = container_limit();
	return container < machine ? container : machine;
}

/* Resident pages of this process, and of these the ones with files behind them; 0 where the system does not tell. */
static void resident_bytes(uint64_t *all, uint64_t *files)
{
	unsigned long long pages = 0, shared = 0;
	uint64_t page_bytes = (uint64_t)sysconf(_SC_PAGESIZE);
	FILE *file = fopen("/proc/self/statm", "r");
	if (file) {
		if (fscanf(file, "%*s %llu %llu", &pages, &shared) != 2) pages = shared = 0;
		fclose(file);
	}
	*all = pages * page_bytes;
	*files = shared * page_bytes;
}

uint64_t ts_memory_used(void)
{
	uint64_t all, files;
	resident_bytes(&all, &files);
	uint64_t heap = all - files;
#ifdef HAS_MALLINFO2
	struct mallinfo2 info = mallinfo2();
	if (info.uordblks + info.hblkhd < heap) heap = info.uordblks + info.hblkhd;
#endif
	return files + heap;
}

uint64_t ts_memory_limit(void) { return ts_memory_total() / 4 * 3; }

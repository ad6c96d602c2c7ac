/* The memory limit of this process, and its use. */
#include "model/memory_limit.h"
#include <inttypes.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>
#include "model/core.h"
#ifdef __GLIBC_PREREQ
#if __GLIBC_PREREQ(2, 33)
#include <malloc.h>
#define HAS_MALLINFO2
#endif
#endif

enum { PATH_BYTES = 4096 };

static uint64_t least(uint64_t a, uint64_t b) { return a < b ? a : b; }

/* The number in a file; UINT64_MAX without file or number, such as "max". */
static uint64_t read_number(const char *path)
{
	uint64_t number = UINT64_MAX;
	FILE *file = fopen(path, "r");
	if (file == NULL) return number;
	if (fscanf(file, "%" SCNu64, &number) != 1) number = UINT64_MAX;
	fclose(file);
	return number;
}

/* The least limit of a control group and its parents, whose folders are under `mount`. A container may see only the
 * uppermost. */
static uint64_t group_limit(const char *mount, const char *group, const char *name)
{
	char folder[PATH_BYTES], path[PATH_BYTES + 64];
	uint64_t limit = UINT64_MAX;
	size_t root = strlen(mount);
	int n = snprintf(folder, sizeof folder, "%s%s", mount, group);
	if (n < 0 || (size_t)n >= sizeof folder) return limit;
	for (char *end = folder + n; end != NULL; end = strrchr(folder + root, '/')) {
		*end = 0;
		snprintf(path, sizeof path, "%s/%s", folder, name);
		limit = least(limit, read_number(path));
	}
	return limit;
}

static bool lists_memory(const char *controllers)
{
	for (const char *word = controllers; word != NULL; word = strchr(word, ',')) {
		word += *word == ',';
		if (strncmp(word, "memory", 6) == 0 && (word[6] == 0 || word[6] == ',')) return true;
	}
	return false;
}

uint64_t ts_container_limit(const char *root)
{
	char line[PATH_BYTES], two[PATH_BYTES], one[PATH_BYTES];
	snprintf(line, sizeof line, "%s/proc/self/cgroup", root);
	snprintf(two, sizeof two, "%s/sys/fs/cgroup", root);
	snprintf(one, sizeof one, "%s/sys/fs/cgroup/memory", root);
	uint64_t limit = group_limit(two, "", "memory.max");
	FILE *file = fopen(line, "r");
	while (file != NULL && fgets(line, sizeof line, file) != NULL) {
		char *controllers = strchr(line, ':'), *group = controllers != NULL ? strchr(controllers + 1, ':') : NULL;
		if (group == NULL) continue;
		*group++ = 0;
		group[strcspn(group, "\n")] = 0;
		if (controllers[1] == 0) limit = least(limit, group_limit(two, group, "memory.max"));
		if (lists_memory(controllers + 1)) limit = least(limit, group_limit(one, group, "memory.limit_in_bytes"));
	}
	if (file != NULL) fclose(file);
	return limit;
}

static uint64_t rest(uint64_t limit, uint64_t used)
{
	return limit == UINT64_MAX ? limit : limit > used ? limit - used : 0;
}

uint64_t ts_memory_granted(const ts_memory_grants *g)
{
	return least(least(g->machine, g->container), least(rest(g->space, g->mapped), rest(g->data, g->written)));
}

static uint64_t own_limit(int resource)
{
	struct rlimit limit;
	return getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY ? UINT64_MAX : limit.rlim_cur;
}

static uint64_t page_bytes(void)
{
	long bytes = sysconf(_SC_PAGESIZE);
	return bytes > 0 ? (uint64_t)bytes : 4096;
}

/* Bytes of this process by /proc/self/statm; 0 where the system has no such file. */
typedef struct {
	uint64_t mapped, resident, files, written; /* address space; in memory; of these files; data and stack */
} footprint;

static footprint footprint_read(void)
{
	unsigned long long mapped = 0, resident = 0, files = 0, written = 0;
	uint64_t page = page_bytes();
	FILE *file = fopen("/proc/self/statm", "r");
	if (file != NULL) {
		if (fscanf(file, "%llu %llu %llu %*s %*s %llu", &mapped, &resident, &files, &written) != 4)
			mapped = resident = files = written = 0;
		fclose(file);
	}
	return (footprint){mapped * page, resident * page, files * page, written * page};
}

static uint64_t total;

static void find_total(void)
{
	long pages = sysconf(_SC_PHYS_PAGES);
	footprint now = footprint_read();
	ts_memory_grants grants = {.machine = pages > 0 ? (uint64_t)pages * page_bytes() : UINT64_MAX,
	                           .container = ts_container_limit(""),
	                           .space = own_limit(RLIMIT_AS),
	                           .mapped = now.mapped,
	                           .data = own_limit(RLIMIT_DATA),
	                           .written = now.written};
	total = ts_memory_granted(&grants);
}

uint64_t ts_memory_total(void)
{
	static pthread_once_t once = PTHREAD_ONCE_INIT;
	pthread_once(&once, find_total);
	return total;
}

uint64_t ts_memory_used(void)
{
	footprint now = footprint_read();
	uint64_t heap = now.resident - now.files;
#ifdef HAS_MALLINFO2
	struct mallinfo2 info = mallinfo2();
	if (info.uordblks + info.hblkhd < heap) heap = info.uordblks + info.hblkhd;
#endif
	return now.files + heap;
}

uint64_t ts_memory_resident(void) { return footprint_read().resident; }

uint64_t ts_memory_limit(void) { return ts_memory_total() / 4 * 3; }

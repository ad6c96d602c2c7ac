/* How much memory there is: every limit counts, less what is taken, and none where a system says so. Control groups are
 * read from a tree of files made here. */
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include "model/core.h"
#include "model/memory_limit.h"
#include "tests/model/test.h"
#include "tests/scratch.h"

#define NONE UINT64_MAX

static void the_least_limit_counts(void **state)
{
	static const struct {
		ts_memory_grants grants;
		uint64_t expected;
	} rows[] = {
		{{NONE, NONE, NONE, 7, NONE, 7}, NONE}, {{100, NONE, NONE, 7, NONE, 7}, 100}, {{100, 90, NONE, 7, NONE, 7}, 90},
		{{100, 90, 80, 7, NONE, 7}, 73},        {{100, 90, 80, 7, 60, 20}, 40},       {{100, 90, 97, 7, 96, 7}, 89},
		{{100, 90, 5, 7, NONE, 7}, 0},          {{100, 90, NONE, 7, 20, 20}, 0},      {{100, 90, 200, 0, 200, 0}, 90},
	};
	(void)state;
	for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++)
		assert_true(ts_memory_granted(&rows[i].grants) == rows[i].expected);
}

/* Writes a file below the root, with the folders that lead to it. */
static void put(const char *path, const char *text)
{
	char all[SCRATCH_PATH];
	snprintf(all, sizeof all, "%s%s", scratch_root, path);
	for (char *slash = all + strlen(scratch_root) + 1; (slash = strchr(slash, '/')) != NULL; *slash++ = '/') {
		*slash = 0;
		mkdir(all, 0700);
	}
	FILE *file = fopen(all, "w");
	assert_non_null(file);
	fputs(text, file);
	fclose(file);
}

static void assert_limit(const char *groups, uint64_t expected)
{
	put("/proc/self/cgroup", groups);
	assert_true(ts_container_limit(scratch_root) == expected);
}

static void without_groups_there_is_no_limit(void **state)
{
	(void)state;
	assert_true(ts_container_limit(scratch_root) == NONE);
	assert_limit("", NONE);
	assert_limit("0::/a/b\n4:memory:/c\nwords\n:\n::\n", NONE);
}

static void groups_of_version_2_limit_memory(void **state)
{
	(void)state;
	put("/sys/fs/cgroup/a/b/memory.max", "max\n");
	assert_limit("0::/a/b\n", NONE);
	put("/sys/fs/cgroup/a/b/memory.max", "5000000000\n");
	put("/sys/fs/cgroup/z/memory.max", "1\n");
	assert_limit("0::/a/b\n", 5000000000);
	assert_limit("0::/a\n", NONE);
	assert_limit("1:name=systemd:/a/b\n", NONE);
	put("/sys/fs/cgroup/a/memory.max", "4000000000\n");
	assert_limit("0::/a/b\n", 4000000000);
	assert_limit("0::/a/b/gone\n", 4000000000);
	put("/sys/fs/cgroup/memory.max", "3000000000\n");
	assert_limit("0::/a/b\n", 3000000000);
	assert_limit("", 3000000000);
	put("/sys/fs/cgroup/memory.max", "max\n");
}

static void groups_of_version_1_limit_memory(void **state)
{
	(void)state;
	put("/sys/fs/cgroup/memory/c/memory.limit_in_bytes", "2000000000\n");
	put("/sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
	assert_limit("7:cpu:/c\n4:memory:/c\n", 2000000000);
	assert_limit("4:hugetlb,memory:/c", 2000000000);
	assert_limit("4:memory,cpuset:/c/d\n", 2000000000);
	assert_limit("4:memory_of_another_kind:/c\n", NONE);
	assert_limit("4:memory:/gone\n", 9223372036854771712u);
	assert_limit("4:memory:/c\n0::/a/b\n", 2000000000);
}

/* Limits of the process itself, set before it asks. */
static void limits_of_the_process_count(void **state)
{
	const int resources[2] = {RLIMIT_AS, RLIMIT_DATA};
	(void)state;
	if (TS_TEST_SANITIZED) skip(); /* which maps terabytes */
	for (int i = 0; i < 2; i++) {
		pid_t child = fork();
		assert_true(child >= 0);
		if (child == 0) {
			rlim_t bytes = (rlim_t)1 << 29;
			struct rlimit limit = {bytes, bytes};
			int set = setrlimit(resources[i], &limit);
			_exit(set == 0 && ts_memory_total() < bytes && ts_memory_limit() == ts_memory_total() / 4 * 3 ? 0 : 1);
		}
		int status = -1;
		assert_int_equal(waitpid(child, &status, 0), child);
		assert_int_equal(status, 0);
	}
}

int main(void)
{
	const struct CMUnitTest limits[] = {
		cmocka_unit_test(the_least_limit_counts),           cmocka_unit_test(without_groups_there_is_no_limit),
		cmocka_unit_test(groups_of_version_2_limit_memory), cmocka_unit_test(groups_of_version_1_limit_memory),
		cmocka_unit_test(limits_of_the_process_count),
	};
	return cmocka_run_group_tests(limits, scratch_begin, scratch_remove);
}

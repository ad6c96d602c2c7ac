/* Threads that can be had: as many as wanted, and fewer where the address space ends, where OpenMP finds them. */
#include <omp.h>
#include <stdio.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include "tests/model/said.h"
#include "tests/model/test.h"

static void wanted_threads_are_there(void **state)
{
	(void)state;
	said_begin();
	assert_int_equal(ts_threads_ready(0), 1);
	assert_int_equal(ts_threads_ready(1), 1);
	assert_int_equal(ts_threads_ready(5), 5);
	assert_int_equal(ts_threads_ready(3), 3);
	omp_set_dynamic(1); /* would let OpenMP give fewer */
	assert_int_equal(ts_threads_ready(6), 6);
	assert_false(omp_get_dynamic());
	assert_string_equal(said_end(), "");
}

/* What asks for all threads gets no more than its caller allows; another thread has its own limit. */
static void a_limit_holds_for_its_thread(void **state)
{
	(void)state;
	assert_int_equal(ts_threads_limit(1), 0);
	assert_int_equal(ts_threads_all(), 1);
	assert_int_equal(ts_threads_limit(3), 1);
	assert_int_equal(ts_threads_all(), 3);
#pragma omp parallel num_threads(2)
	{
		if (omp_get_thread_num() == 1) assert_int_equal(ts_threads_limit(0), 0);
	}
	assert_int_equal(ts_threads_limit(0), 3);
	assert_int_equal(ts_threads_all(), ts_processors());
}

static size_t mapped(void)
{
	size_t pages = 0;
	FILE *file = fopen("/proc/self/statm", "r");
	if (file == NULL || fscanf(file, "%zu", &pages) != 1) pages = 0;
	if (file != NULL) fclose(file);
	return pages * (size_t)sysconf(_SC_PAGESIZE);
}

/* In a child, which has no threads yet. */
static int few(size_t stacks)
{
	const size_t stack = 8 << 20, most = mapped() + stacks * stack;
	int seen = 0;
	if (setrlimit(RLIMIT_AS, &(struct rlimit){most, most}) != 0) return 1;
	said_begin();
	uint32_t n = ts_threads_ready(TS_MOST_THREADS);
	if (n < 2 || n > stacks || strstr(said_end(), "1024 threads wanted, ") == NULL) return 2;
#pragma omp parallel num_threads((int)n) reduction(+ : seen)
	seen++;
	return seen == (int)n ? 0 : 3;
}

static void little_memory_gives_fewer_threads(void **state)
{
	(void)state;
	if (TS_TEST_SANITIZED) skip(); /* which maps terabytes */
	for (size_t stacks = 12; stacks <= 40; stacks += 7) {
		int told;
		pid_t child = fork();
		if (child == 0) _exit(few(stacks));
		assert_int_equal(waitpid(child, &told, 0), child);
		assert_int_equal(told, 0);
	}
}

/* gcc's OpenMP would wait in a child for the threads of its parent: the child computes alone. */
static int alone(void)
{
	int seen = 0;
	alarm(10);
	said_begin();
	if (ts_threads_ready(4) != 1 || strstr(said_end(), "4 threads wanted, 1 is taken: after a fork") == NULL) return 1;
#pragma omp parallel num_threads((int)ts_threads_all()) reduction(+ : seen)
	seen++;
	return seen == 1 ? 0 : 2;
}

static void the_child_of_a_fork_computes_alone(void **state)
{
	(void)state;
	int told;
	assert_int_equal(ts_threads_ready(5), 5);
	pid_t child = fork();
	if (child == 0) _exit(alone());
	assert_int_equal(waitpid(child, &told, 0), child);
	assert_int_equal(told, 0);
	assert_int_equal(ts_threads_ready(5), 5);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(little_memory_gives_fewer_threads), cmocka_unit_test(wanted_threads_are_there),
		cmocka_unit_test(a_limit_holds_for_its_thread), cmocka_unit_test(the_child_of_a_fork_computes_alone)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

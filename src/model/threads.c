/* Threads are tried before they are needed: OpenMP's runtime ends the process if it cannot create one. */
#include <omp.h>
#include <pthread.h>
#include <unistd.h>
#include "model/core.h"

typedef struct {
	pthread_mutex_t mutex;
	pthread_cond_t opened;
	bool open;
} gate;

static void *wait_at(void *user)
{
	gate *g = user;
	pthread_mutex_lock(&g->mutex);
	while (!g->open) pthread_cond_wait(&g->opened, &g->mutex);
	pthread_mutex_unlock(&g->mutex);
	return NULL;
}

static void open_gate(gate *g)
{
	pthread_mutex_lock(&g->mutex);
	g->open = true;
	pthread_cond_broadcast(&g->opened);
	pthread_mutex_unlock(&g->mutex);
}

/* How many threads there can be at the same time beside this one, `most` at most. */
static uint32_t others(uint32_t most)
{
	pthread_t made[TS_MOST_THREADS];
	gate g = {PTHREAD_MUTEX_INITIALIZER, PTHREAD_COND_INITIALIZER, false};
	uint32_t n = 0;
	while (n < most && pthread_create(&made[n], NULL, wait_at, &g) == 0) n++;
	open_gate(&g);
	for (uint32_t i = 0; i < n; i++) pthread_join(made[i], NULL);
	return n;
}

/* OpenMP creates its threads now, while there is memory for them; its environment may allow fewer. Apart, as clang's
 * begins where a function that has a team is entered, by one thread alone too. */
static __attribute__((noinline)) uint32_t make_team(uint32_t wanted)
{
	uint32_t there = wanted;
	omp_set_dynamic(0);
#pragma omp parallel num_threads((int)wanted)
#pragma omp single
	there = (uint32_t)omp_get_num_threads();
	return there;
}

uint32_t ts_threads_ready(uint32_t wanted)
{
	static _Thread_local uint32_t ready = 1; /* OpenMP keeps each thread's team apart */
	static _Thread_local pid_t process;      /* of the team */
	uint32_t n = wanted < 1 ? 1 : wanted < TS_MOST_THREADS ? wanted : TS_MOST_THREADS;
	if (n == 1) return 1;
	/* Only the thread that forks is in the child. gcc's OpenMP would wait for the rest of its team for ever. */
	if (ready > 1 && process != getpid()) {
		ts_say("%u threads wanted, 1 is taken: after a fork OpenMP has no others", (unsigned)n);
		return 1;
	}
	if (n <= ready) return n;
	uint32_t had = others(n - 1);
	/* At the limit, the work needs the memory of half of the threads. */
	uint32_t there = had == n - 1 ? n : 1 + had / 2;
	if (there < n) ts_say("%u threads wanted, %u are taken of what is there", (unsigned)n, (unsigned)there);
	ready = make_team(there);
	process = getpid();
	return ready;
}

uint32_t ts_processors(void) { return (uint32_t)omp_get_num_procs(); }

static _Thread_local uint32_t limit;

uint32_t ts_threads_limit(uint32_t most)
{
	uint32_t before = limit;
	limit = most;
	return before;
}

uint32_t ts_threads_all(void) { return ts_threads_ready(limit > 0 ? limit : ts_processors()); }

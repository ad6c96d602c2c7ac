/* The floating-point environment of a host, which may trap what the library computes, as division by 0. */
#include <fenv.h>
#include "model/core.h"

typedef struct {
	fenv_t before; /* the host's, of this thread */
	uint32_t depth, threads;
} hold;

static _Thread_local hold own;

static void begin(void)
{
	if (own.depth++ == 0) feholdexcept(&own.before);
}

/* Apart from what a single thread calls: clang's OpenMP begins where a function that has a team is entered. */
static __attribute__((noinline)) void begin_all(uint32_t threads)
{
#pragma omp parallel num_threads((int)threads)
	if (own.depth == 0) begin();
}

/* A thread that was made meanwhile gets the environment of the one that made it. */
static __attribute__((noinline)) void end_all(const hold *first)
{
#pragma omp parallel num_threads((int)first->threads)
	{
		fesetenv(own.depth > 0 ? &own.before : &first->before);
		own.depth = 0;
	}
}

uint32_t ts_floats_hold(uint32_t threads)
{
	const uint32_t there = ts_threads_ready(threads);
	begin();
	if (there <= own.threads) return there;
	own.threads = there;
	if (there > 1) begin_all(there);
	return there;
}

void ts_floats_give(void)
{
	const hold first = own;
	if (--own.depth > 0) return;
	own.threads = 0;
	fesetenv(&first.before);
	if (first.threads > 1) end_all(&first);
}

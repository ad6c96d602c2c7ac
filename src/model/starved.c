/* Memory that a library did not get: jansson leaves out what it cannot hold, and drops letters of what it reads. */
#include <stdatomic.h>
#include <stdlib.h>
#include "core.h"

static atomic_bool starved;

void *ts_starved_malloc(size_t bytes)
{
	void *memory = malloc(bytes);
	if (memory == NULL) starved = true;
	return memory;
}

ts_status ts_starved_check(const char *what) { return starved ? ts_fail("%s: out of memory", what) : TS_OK; }

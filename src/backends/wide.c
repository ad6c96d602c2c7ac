/* Which versions of vector loops run. */
#include "backends/wide.h"
#include <stdlib.h>
#include <string.h>

unsigned ts_most_lanes = 16;

#if defined(__x86_64__)
static unsigned lanes_here(void)
{
	return __builtin_cpu_supports("avx512f") ? 16 : __builtin_cpu_supports("avx2") ? 8 : 4;
}
#else
static unsigned lanes_here(void) { return 0; }
#endif

ts_status ts_lanes_choose(void)
{
	const char *text = getenv("TS_LANES");
	if (text == NULL) return TS_OK;
	unsigned lanes = strcmp(text, "4") == 0 ? 4 : strcmp(text, "8") == 0 ? 8 : strcmp(text, "16") == 0 ? 16 : 0;
	if (lanes == 0) return ts_fail("TS_LANES=%.40s: 4, 8 or 16 would be right", text);
	if (lanes_here() == 0) return ts_fail("TS_LANES=%u: only x86-64 has a choice; leave it out", lanes);
	if (lanes > lanes_here()) return ts_fail("TS_LANES=%u: this processor has %u", lanes, lanes_here());
	ts_most_lanes = lanes;
	return TS_OK;
}

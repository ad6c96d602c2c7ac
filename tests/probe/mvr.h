/* A small run of reflections by MVR that is probed. */
#ifndef TS_TESTS_PROBE_MVR_H
#define TS_TESTS_PROBE_MVR_H
#include "probe/parts.h"
#include "tests/probe/probed.h"

enum { WIDTH = 24, HEIGHT = 16, MIRRORS = 2 };

static traced mvr;

static inline ts_params mvr_params(void)
{
	ts_params params = small_params(WIDTH, HEIGHT);
	params.reflectors_count = MIRRORS;
	params.reflectors_px = 16;
	params.cube_max_px = 32;
	return params;
}

static inline int mvr_make(void **state)
{
	(void)state;
	const ts_params params = mvr_params();
	make(&mvr, "reflections", "mvr", &params);
	return 0;
}

static inline int mvr_drop(void **state)
{
	(void)state;
	drop(&mvr);
	return 0;
}

#endif

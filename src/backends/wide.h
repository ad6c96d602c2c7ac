/* Vector loops: compiled for each vector width, with all functions that they call; each call takes the widest version
 * that this processor has. The bits are the same, since nothing is contracted and no sum is reordered (CONTRACT rule
 * 4). The loader does not choose (target_clones), since static programs of musl have no such loader. */
#ifndef TS_BACKENDS_WIDE_H
#define TS_BACKENDS_WIDE_H
#include "model/core.h"

/* No wider version is taken; 16 unless a test sets it. */
extern unsigned ts_most_lanes;
/* Sets it to the environment variable TS_LANES, if there is one: for tests of the widths that other machines have.
 * TS_ERROR: it is none of 4, 8 and 16, or this processor has fewer. */
ts_status ts_lanes_choose(void);

/* The head of a function: type, name, parameters and their names, these two in parentheses. */
#if defined(__x86_64__)
#define TS_WIDE(type, name, parameters, names) \
	static inline __attribute__((always_inline)) type name##_of_any_width parameters; \
	static __attribute__((target("avx512f"), flatten)) type name##_of_16 parameters \
	{ \
		return name##_of_any_width names; \
	} \
	static __attribute__((target("avx2"), flatten)) type name##_of_8 parameters { return name##_of_any_width names; } \
	static __attribute__((noinline, flatten)) type name##_of_4 parameters { return name##_of_any_width names; } \
	static type name parameters \
	{ \
		if (ts_most_lanes >= 16 && __builtin_cpu_supports("avx512f")) return name##_of_16 names; \
		if (ts_most_lanes >= 8 && __builtin_cpu_supports("avx2")) return name##_of_8 names; \
		return name##_of_4 names; \
	} \
	static inline type name##_of_any_width parameters
#else
#define TS_WIDE(type, name, parameters, names) static type name parameters
#endif

#endif

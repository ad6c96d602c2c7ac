/* What a comparison need not find exact. */
#ifndef TS_TRACE_RELAX_H
#define TS_TRACE_RELAX_H
#include "../model/core.h"
#include "../kernels/base/compat.h"

/* All zero: everything must be exact. */
typedef struct {
	u64 ulp; /* floats, also depths of maps and of keys that name the same thing, may be so many floats apart, */
	double abs, rel;    /* or so far, or so far in parts of the reference's; never a number from an infinity */
	bool decided;       /* only what the reference decides is judged (decided.h) */
	u64 allow;          /* so many elements of a buffer may differ */
	const char *ignore; /* "BUFFER,BUFFER.field,...": not judged; NULL: none */
	const u8 *mask;     /* H W: pixel buffers are judged only where it is not 0; NULL: everywhere */
	u32 mask_width, mask_height;
	const bool *only; /* by buffer: others are not judged; NULL: all are */
} ts_relaxations;

/* Whether these floats, given as bits, pass for equal. A NaN never does. */
bool ts_relax_close(const ts_relaxations *relaxations, u64 ref, u64 cand);
/* Whether the buffer may be judged at all. */
bool ts_relax_takes(const ts_relaxations *relaxations, u32 buffer);
/* Whether `name` is one of those to be ignored. */
bool ts_relax_ignores(const ts_relaxations *relaxations, const char *name);
/* Refuses names to be ignored that no buffer and no field has. */
ts_status ts_relax_check(const ts_relaxations *relaxations);

#endif

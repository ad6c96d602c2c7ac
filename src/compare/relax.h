/* Relaxations of a comparison. */
#ifndef TS_COMPARE_RELAX_H
#define TS_COMPARE_RELAX_H
#include "kernels/base/compat.h"
#include "model/core.h"

/* All zero: everything must be exact. */
typedef struct {
	u64 ulp;         /* floats, also depths of maps and of keys with the same index, may be this many floats apart, */
	double abs, rel; /* or this far, or this share of the reference's; never a number from an infinity */
	bool decided;    /* only elements that the reference decides are judged (decided.h) */
	u64 allow;       /* this many elements of a buffer may differ */
	const char *ignore; /* "BUFFER,BUFFER.field,...": not judged; NULL: none */
	const u8 *mask;     /* H W: pixel buffers are judged only where it is not 0; NULL: everywhere */
	u32 mask_width, mask_height;
	const bool *only; /* by buffer: others are not judged; NULL: all are */
} ts_relaxations;

/* Whether two floats, given as bits, pass as equal. A NaN never does. */
bool ts_relax_close(const ts_relaxations *relaxations, u64 ref, u64 cand);
/* Whether the buffer may be judged at all. */
bool ts_relax_takes(const ts_relaxations *relaxations, u32 buffer);
/* Whether `name` is one of those to be ignored. */
bool ts_relax_ignores(const ts_relaxations *relaxations, const char *name);
/* Refuses names in `ignore` of no buffer and no field. */
ts_status ts_relax_check(const ts_relaxations *relaxations);

#endif

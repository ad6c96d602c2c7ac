/* Who made a trace, and how it computes. */
#ifndef TS_TRACE_PRODUCER_H
#define TS_TRACE_PRODUCER_H
#include <jansson.h>

/* Name, version, commit, backend, device, compiler and flags of this program. New references, or NULL without memory. */
json_t *ts_producer(void);
/* Rounding, contraction and denormals of this process, measured now. */
json_t *ts_arithmetic(void);

#endif

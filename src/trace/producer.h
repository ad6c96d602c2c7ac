/* The producer of a trace, and its arithmetic. */
#ifndef TS_TRACE_PRODUCER_H
#define TS_TRACE_PRODUCER_H
#include <jansson.h>
#include "methods/stage.h"

/* Name, version and commit of this program; name, device, compiler and flags of its backend. New references, or NULL
 * without memory. */
json_t *ts_producer(const ts_run *run);
/* Rounding, contraction and denormals of the run's backend; for the C backend measured now in this process. */
json_t *ts_arithmetic(const ts_run *run);

#endif

/* The self-test of a file that computes what kernels do; the last line of such a file includes this one. TS_FILE: name
 * of the file, if one source is compiled several times. */
#ifndef TS_BACKENDS_SELFTEST_H
#define TS_BACKENDS_SELFTEST_H
#include "backends/wide.h"
#include "model/selftest.h"

#ifndef TS_FILE
#define TS_FILE __BASE_FILE__
#endif

TS_WIDE(unsigned, selftest_here, (void), ()) { return ts_selftest_all(); }
TS_SELFTEST_OF(TS_FILE, selftest_here)

#endif

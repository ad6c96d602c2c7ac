/* The commit that this program was built from. The Makefile sets it; only this file is built again when it changes. */
#include "model/core.h"

#ifndef TS_COMMIT
#define TS_COMMIT "unknown"
#endif

const char *ts_commit(void) { return TS_COMMIT; }

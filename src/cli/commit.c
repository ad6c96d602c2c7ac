/* What this program was built from. The Makefile knows; only this file is built again when it changes. */
#include "cli.h"

#ifndef TS_COMMIT
#define TS_COMMIT "unknown"
#endif

const char *ts_cli_commit(void) { return TS_COMMIT; }

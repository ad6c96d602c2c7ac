/* What the files of this folder have for tools.c. */
#ifndef TS_HULLS_TOOLS_H
#define TS_HULLS_TOOLS_H
#include "../../../replay/check.h"

extern const ts_check_rule ts_hulls_checks[];

#endif

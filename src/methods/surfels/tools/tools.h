/* What the files of this folder have for tools.c. */
#ifndef TS_SURFELS_TOOLS_H
#define TS_SURFELS_TOOLS_H
#include "../../../replay/check.h"

extern const ts_check_rule ts_surfels_checks[];

#endif

/* What the files of this folder have for tools.c. */
#ifndef TS_RASTER_TOOLS_H
#define TS_RASTER_TOOLS_H
#include "../../../replay/check.h"

extern const ts_check_rule ts_raster_checks[];

#endif

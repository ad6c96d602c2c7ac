/* Functions of this folder's files for tools.c. */
#ifndef TS_METHODS_RASTER_TOOLS_TOOLS_H
#define TS_METHODS_RASTER_TOOLS_TOOLS_H
#include "replay/check.h"
#include "study/viewer.h"

extern const ts_check_rule ts_raster_checks[];
extern const ts_viewer_rule ts_raster_viewers[];

#endif

/* What the files of this folder have for tools.c. */
#ifndef TS_VIEWS_TOOLS_H
#define TS_VIEWS_TOOLS_H
#include "../../../replay/check.h"

extern const ts_check_rule ts_views_checks[];

/* Lists of views that pixels draw from (check_gather.c); cones must have been checked. */
ts_status ts_check_gather(const ts_load *load, const ts_stage *stage, ts_buffer_id id);

#endif

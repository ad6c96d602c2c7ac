/* Pictures of what hulls are made of (SSAGH section 3). */
#ifndef TS_CLI_HULL_PICTURES_H
#define TS_CLI_HULL_PICTURES_H
#include "stage_pictures.h"

/* After `segment`: `segments`, the labels of the depth grid. After `box`: the outlines of the boxes, drawn into it. */
ts_status ts_hull_pictures_segments(ts_stage_pictures *pictures, const ts_run *run);
ts_status ts_hull_pictures_boxes(ts_stage_pictures *pictures, const ts_run *run);
/* After `fit`: `lobes`, the light at the corners of the larger boxes. */
ts_status ts_hull_pictures_lobes(ts_stage_pictures *pictures, const ts_run *run);

#endif

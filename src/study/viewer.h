/* Copies of a run's buffers for eyes and viewers; never hashed, never compared. */
#ifndef TS_CLI_VIEWER_H
#define TS_CLI_VIEWER_H
#include "../methods/stage.h"

/* Writes, of what a stage has just made, the copies there are, into folder FOLDER of the output: eye.depth.exr (axial depth,
 * 0 where nothing is seen) and eye.triangle.exr (triangle + 1), points.ply (centre, splat length, piece), image.radiance.exr
 * and image.srgb.png. */
ts_status ts_viewer_take(const ts_run *run, const ts_stage *stage, const char *folder);

#endif

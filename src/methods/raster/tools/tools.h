/* Functions of this folder's files: for tools.c, and for families that fill cubes. */
#ifndef TS_METHODS_RASTER_TOOLS_TOOLS_H
#define TS_METHODS_RASTER_TOOLS_TOOLS_H
#include "replay/check.h"
#include "study/picture.h"
#include "study/stage_pictures.h"

extern const ts_check_rule ts_raster_checks[];
extern const ts_viewer_rule ts_raster_viewers[];
extern const ts_picture_mark ts_raster_marks[];

/* Which pixels of indirect light are near a triangle of light (METHODS 17). Hulls must err there: their corners stand
 * for places that see such a triangle from another side, or not at all (near_light.c). Makes picture->near, 1 where the
 * surface is no farther from the middle of a triangle of rsm.patch than the triangle's side is long, and
 * picture->elsewhere, 1 at all other pixels but the sky's; surfaces are those of gbuffer.pixel. Without these buffers
 * there are none. Fails without memory. */
ts_status ts_near_light_mark(ts_picture *picture, const ts_run *run);

/* Pictures of cubes. */

extern const u8 ts_picture_nothing[3]; /* the colour of empty texels */

/* Finds the largest cube of all; false if there is none, or it is not in this batch. */
bool ts_picture_largest_cube(const ts_run *run, u32 *cube);
/* The colour of texel i of a cube. */
typedef void ts_picture_colour(u8 *rgb, const void *texels, u64 i);
/* Adds a picture of the six faces of a cube, as a cross, unless it is there already. */
ts_status ts_picture_cube(ts_stage_pictures *pictures, const ts_run *run, u32 cube, const char *name, const char *what,
                          const void *texels, ts_picture_colour *colour);
/* Adds a picture of the indices of the largest cube, in a buffer of keys. */
ts_status ts_picture_indices(ts_stage_pictures *pictures, const ts_run *run, ts_buffer_id keys, const char *what);

/* Rules of this folder. */
extern const ts_stage_picture_rule ts_raster_pictures[];

#endif

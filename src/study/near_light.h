/* Which pixels of indirect light are near a triangle of light (METHODS 17). Hulls must err there: their corners stand
 * for places that see such a triangle from another side, or not at all. */
#ifndef TS_STUDY_NEAR_LIGHT_H
#define TS_STUDY_NEAR_LIGHT_H
#include "methods/stage.h"

/* Marks in near[i] the pixels whose surface is no farther from the middle of a triangle of rsm.patch than the
 * triangle's side is long, and in elsewhere[i] all others but the sky's; surfaces are those of gbuffer.pixel. Both
 * arrays have a byte a pixel and must be 0 before. Fails without memory. */
ts_status ts_near_light_mark(u8 *near, u8 *elsewhere, const ts_run *run);

#endif

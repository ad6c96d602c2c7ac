/* Which pixels of indirect light are near a triangle of light (METHODS 17). There hulls must err: their corners stand
 * for places that see such a triangle from elsewhere, or not at all. */
#ifndef TS_CLI_NEAR_LIGHT_H
#define TS_CLI_NEAR_LIGHT_H
#include "../methods/stage.h"

/* Marks in near[i] the pixels whose surface is no farther from the middle of a triangle of rsm.patch than that triangle
 * has its side, in elsewhere[i] all others but the sky's, by gbuffer.pixel. Both are as many bytes as pixels, 0 at
 * first. Fails without memory. */
ts_status ts_near_light_mark(u8 *near, u8 *elsewhere, const ts_run *run);

#endif

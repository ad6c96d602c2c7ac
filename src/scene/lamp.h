/* Area lights: the lamps of shadow methods, and the views from the samples of lights (iVIR sections 4 and 6). */
#ifndef TS_SCENE_LAMP_H
#define TS_SCENE_LAMP_H
#include "kernels/base/records.h"
#include "model/param.h"
#include "scene/scene.h"

/* Between two seeds of a sunflower, in turns (Vogel 1979). */
#define TS_GOLDEN_TURN 0.61803400516510009765625f

/* The cone of the lamp of soft shadows, in shares of half of lamp.fov: where its full light ends, and its border. */
#define TS_LAMP_FULL 0.75f
#define TS_LAMP_BORDER 0.9375f
/* lamp.fov as it comes, degrees. */
#define TS_LAMP_FOV 45.0f

/* The distance from the middle of a thing without walls at which the full light of the lamp, with lamp.fov as it comes,
 * just holds the ball about the thing's box. */
f32 ts_lamp_distance(const ts_info *info);

/* The places of both lamps that follow from the hall alone (ts_lamp_spot, ts_lamp_ball). */
void ts_lamp_stands(ts_stand stands[TS_N_STANDS], const ts_info *info);

/* For both lamps: `stands` are the scene's, or NULL for a scene without stands.
 *
 * The lamp of soft shadows: a spot light under a corner of the hall, aimed across it at the floor; of a scene without
 * walls, above and beside it at ts_lamp_distance, aimed at its middle. Its cone keeps within the depth maps of all
 * samples, where it is aimed, if lamp.fov is 40 degrees or more and lamp.radius 1/36 or less. Its irradiance there is
 * params->light_irradiance. */
void ts_lamp_spot(ts_light *light, const ts_info *info, const ts_stand *stands, const ts_params *params);
/* The lamp of omnidirectional shadows: a point light in the middle of the hall, of a scene without walls above
 * it. */
void ts_lamp_ball(ts_light *light, const ts_info *info, const ts_stand *stands, const ts_params *params);

/* Size and angle of a light's depth maps. */
typedef struct {
	u32 side; /* texels */
	f32 fov;  /* degrees */
	bool own; /* of spot lights the angle of their cone instead of `fov` */
} ts_lens;

/* The radius of a light, over which its samples are spread: world units; of a sun the tangent of its angular radius. */
f32 ts_lamp_radius(const ts_light *light, const ts_info *info, const ts_params *params);

/* The depth map of sample k of n of a light, without its offset: on a disc across the light's direction, in the order
 * of a sunflower's seeds; one sample alone lies in the middle. Of suns orthographic and as wide as the scene. A point
 * light looks at the middle of the hall. */
void ts_lamp_view(ts_offscreen *view, const ts_light *light, f32 radius, u32 k, u32 n, const ts_info *info,
                  const ts_lens *lens);
/* The cube of sample k of n of a point light, of `side` texels, without its offset: on a ball. */
void ts_lamp_cube(ts_face *cube, const ts_light *light, f32 radius, u32 k, u32 n, const ts_info *info, u32 side);

#endif

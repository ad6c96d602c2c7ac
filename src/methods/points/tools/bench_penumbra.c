/* Widths of penumbras in texels of depth maps, for tables of soft shadows (iVIR 4, 6). */
#include <math.h>
#include "methods/points/tools/benches.h"
#include "methods/stages.h"

#define DEGREE 0.017453292519943295

/* The distances of occluders are not known here. So this is the penumbra, 2 radii wide, of an occluder halfway from the
 * lamp to where its irradiance is light.irradiance: the spot's target, or half the hall's height away from the ball. */
double ts_bench_penumbra(const ts_run *run)
{
	const ts_params *params = &run->params;
	if (TS_PARAM(params, lamp_source) == TS_LAMP_SCENE) return NAN;
	const ts_light *light = ts_frame_data(&run->frame, TS_B_lamp_light);
	const ts_lamp *lamp = ts_frame_data(&run->frame, TS_B_lamp_shape);
	double distance = sqrt((double)light->intensity[0] / (double)TS_PARAM(params, light_irradiance));
	double tangent = ts_run_has_cubes(run) ? 1 : tan((double)TS_PARAM(params, lamp_fov) / 2 * DEGREE);
	double texel = 2 * tangent * distance / TS_PARAM(params, depth_map_px);
	return 2 * (double)lamp->radius / texel;
}

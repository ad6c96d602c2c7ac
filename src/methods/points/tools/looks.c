/* What tables look at beside figures, and those that code measures. */
#include <math.h>
#include "kernels/points/cube_size.h"
#include "methods/points/tools/benches.h"
#include "methods/stages.h"

#define DEGREE 0.017453292519943295

/* The larger side of the reflectors' boxes in the eye's picture, in pixels: the mean of those in sight. */
static double projected_size(const ts_run *run)
{
	if (!run->frame.buffer[TS_B_cube_size_face].made) return NAN;
	const ts_face *cubes = ts_frame_data(&run->frame, TS_B_cube_size_face);
	ts_camera_k view = ts_k_view(ts_frame_data(&run->frame, TS_B_eye_view));
	double sum = 0, n = 0;
	for (u64 r = 0; r < ts_frame_n(&run->frame, TS_B_cube_size_face); r++) {
		if (cubes[r].n == 0) continue;
		ts_extent e = ts_k_box_extent(&view, ts_load3(cubes[r].box_min), ts_load3(cubes[r].box_max));
		sum += fmax(e.x1 - e.x0, e.y1 - e.y0);
		n++;
	}
	return n > 0 ? sum / n : NAN;
}

/* The side of the largest face of a cube in sight. */
static double largest_face(const ts_run *run)
{
	if (!run->frame.buffer[TS_B_cube_size_face].made) return NAN;
	const ts_face *cubes = ts_frame_data(&run->frame, TS_B_cube_size_face);
	double most = NAN;
	for (u64 i = 0; i < ts_frame_n(&run->frame, TS_B_cube_size_face); i++) most = fmax(most, cubes[i].n);
	return most;
}

/* Widths of penumbras in texels of depth maps; NaN for the scene's own lights. The distances of occluders are not known
 * here. So this is the penumbra, 2 radii wide, of an occluder halfway from the lamp to where its irradiance is
 * light.irradiance: the spot's target, or half the hall's height away from the ball. */
static double penumbra(const ts_run *run)
{
	const ts_params *params = &run->params;
	bool made = run->frame.buffer[TS_B_lamp_light].made && run->frame.buffer[TS_B_lamp_shape].made;
	if (!made || TS_PARAM(params, lamp_source) == TS_LAMP_SCENE) return NAN;
	const ts_light *light = ts_frame_data(&run->frame, TS_B_lamp_light);
	const ts_lamp *lamp = ts_frame_data(&run->frame, TS_B_lamp_shape);
	double distance = sqrt((double)light->intensity[0] / (double)TS_PARAM(params, light_irradiance));
	double tangent = ts_run_has_cubes(run) ? 1 : tan((double)TS_PARAM(params, lamp_fov) / 2 * DEGREE);
	double texel = 2 * tangent * distance / TS_PARAM(params, depth_map_px);
	return 2 * (double)lamp->radius / texel;
}

const ts_table_code ts_points_codes[] = {
	{"projected_size", .look = projected_size},
	{"largest_face", .look = largest_face},
	{"penumbra", .look = penumbra},
	{"sweep", .work = ts_bench_sweep},
	{0},
};

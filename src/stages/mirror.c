/* MVR: reflective pixels of the batch's reflectors look up their cubes. */
#include "stages.h"

ts_status ts_stage_mirror(ts_run *run)
{
	u64 n = ts_frame_n(&run->frame, TS_B_pixel_record);
	bool first = run->first_unit == 0;
	if (first && ts_frame_make2(&run->frame, TS_B_shade_radiance, n, 3) == NULL) return TS_ERROR;
	if (first && ts_run_fill(run, TS_B_shade_radiance, 0) != TS_OK) return TS_ERROR;
	ts_mirror_args args = {
		.view = ts_frame_handle(&run->frame, TS_B_eye_view),
		.cubes = ts_frame_handle(&run->frame, TS_B_resize_face),
		.pixels = ts_frame_handle(&run->frame, TS_B_pixel_record),
		.mip = ts_frame_handle(&run->frame, TS_B_face_mip),
		.radiance = ts_frame_handle(&run->frame, TS_B_shade_radiance),
		.first_cube = run->first_unit,
		.n_cubes = run->n_units,
		.supersample = run->params.mvr_filter == TS_MVR_SUPERSAMPLE,
	};
	return ts_run_launch(run, TS_KERNEL_mirror, &args, n);
}

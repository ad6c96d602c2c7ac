/* The eye and the image as EXR and PNG: eye.depth.exr (axial depth, 0 where nothing is seen), eye.triangle.exr
 * (triangle + 1), image.radiance.exr and image.srgb.png. */
#include <stdlib.h>
#include <touchstone/image.h>
#include "image/about.h"
#include "kernels/base/num.h"
#include "methods/raster/tools/tools.h"

/* The file shows `what` of the run's method. */
static void describe(ts_about *about, const ts_run *run, const char *what)
{
	char shows[64];
	const ts_pipeline *method = run->pipeline;
	snprintf(shows, sizeof shows, "%s-%s", method->name, what);
	ts_about_make(about, run->scene->name, method->effect->name, shows, &run->params);
}

/* Depth, or the triangle counted from 1, of each pixel; whole numbers below 2^24 are exact in binary32. */
static ts_status write_eye_as(const ts_run *run, const char *folder, bool depth)
{
	ts_about about;
	u32 width = TS_PARAM(&run->params, width), height = (u32)ts_run_size(run, TS_DIM_eye_rows);
	const u64 *keys = ts_frame_data(&run->frame, TS_B_eye_depth_triangle);
	f32 *values = ts_alloc((size_t)width * height, sizeof *values, "a viewer's copy");
	const char *path = values != NULL ? ts_viewer_file(folder, depth ? "eye.depth.exr" : "eye.triangle.exr") : NULL;
	for (size_t i = 0; path != NULL && i < (size_t)width * height; i++) {
		f32 seen = depth ? ts_u2f((u32)(keys[i] >> 32)) : (f32)((u32)keys[i] + 1u);
		values[i] = keys[i] != TS_EMPTY ? seen : 0.0f;
	}
	describe(&about, run, depth ? "eye.depth" : "eye.triangle");
	ts_status status = path != NULL ? ts_image_write_exr(path, values, width, height, 1, about.texts) : TS_ERROR;
	free(values);
	return status;
}

static ts_status write_eye(const ts_run *run, const char *folder)
{
	ts_status status = write_eye_as(run, folder, true);
	return status == TS_OK ? write_eye_as(run, folder, false) : status;
}

static ts_status write_image(const ts_run *run, const char *folder)
{
	ts_about about;
	const f32 *radiance = ts_frame_data(&run->frame, TS_B_image_radiance);
	const u8 *srgb = ts_frame_data(&run->frame, TS_B_image_srgb);
	const char *exr = ts_viewer_file(folder, "image.radiance.exr");
	const char *png = ts_viewer_file(folder, "image.srgb.png");
	u32 width = TS_PARAM(&run->params, width), height = TS_PARAM(&run->params, height);
	if (exr == NULL || png == NULL) return TS_ERROR;
	describe(&about, run, "image");
	if (ts_image_write_exr(exr, radiance, width, height, 3, about.texts) != TS_OK) return TS_ERROR;
	return ts_image_write_png(png, srgb, width, height, 3, about.texts);
}

const ts_viewer_rule ts_raster_viewers[] = {
	{TS_B_eye_depth_triangle, write_eye},
	{TS_B_image_radiance, write_image},
	{.write = NULL},
};

/* EXR, PLY and PNG of buffers. */
#include "viewer.h"
#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <touchstone/image.h>
#include "../kernels/base/num.h"
#include "folder.h"

static const char *place(const char *folder, const char *name)
{
	char path[96];
	snprintf(path, sizeof path, "%s/%s", folder, name);
	return ts_folder_file(path);
}

/* Depth, or the triangle counted from 1, of each pixel; whole numbers are exact in binary32 below 2^24. */
static ts_status write_eye(const ts_run *run, const char *folder, bool depth)
{
	u32 width = TS_PARAM(&run->params, width), height = TS_PARAM(&run->params, height);
	const u64 *keys = ts_frame_data(&run->frame, TS_B_eye_depth_triangle);
	f32 *values = ts_alloc((size_t)width * height, sizeof *values, "a viewer's copy");
	const char *path = values != NULL ? place(folder, depth ? "eye.depth.exr" : "eye.triangle.exr") : NULL;
	for (size_t i = 0; path != NULL && i < (size_t)width * height; i++) {
		f32 seen = depth ? ts_u2f((u32)(keys[i] >> 32)) : (f32)((u32)keys[i] + 1u);
		values[i] = keys[i] != TS_EMPTY ? seen : 0.0f;
	}
	ts_status status = path != NULL ? ts_image_write_exr(path, values, width, height, 1) : TS_ERROR;
	free(values);
	return status;
}

static ts_status write_points(const ts_run *run, const char *folder)
{
	const ts_point *points = ts_frame_data(&run->frame, TS_B_points_record);
	u64 n = ts_frame_n(&run->frame, TS_B_points_record);
	const char *path = place(folder, "points.ply");
	FILE *file = path != NULL ? fopen(path, "wb") : NULL;
	if (file == NULL) return path != NULL ? ts_fail("%s: cannot be made: %s", path, strerror(errno)) : TS_ERROR;
	fprintf(file, "ply\nformat binary_little_endian 1.0\ncomment units of the scene\nelement vertex %" PRIu64 "\n", n);
	fputs("property float x\nproperty float y\nproperty float z\nproperty float length\nproperty uint piece\n", file);
	fputs("end_header\n", file);
	for (u64 i = 0; i < n; i++) {
		fwrite(points[i].centre, sizeof(f32), 3, file);
		fwrite(&points[i].length, sizeof(f32), 1, file);
		fwrite(&points[i].piece, sizeof(u32), 1, file);
	}
	bool written = ferror(file) == 0;
	written &= fclose(file) == 0;
	return written ? TS_OK : ts_fail("%s: cannot be written; the disk may be full", path);
}

static ts_status write_image(const ts_run *run, const char *folder)
{
	const char *exr = place(folder, "image.radiance.exr"), *png = place(folder, "image.srgb.png");
	u32 width = TS_PARAM(&run->params, width), height = TS_PARAM(&run->params, height);
	if (exr == NULL || png == NULL) return TS_ERROR;
	ts_status status = ts_image_write_exr(exr, ts_frame_data(&run->frame, TS_B_image_radiance), width, height, 3);
	if (status != TS_OK) return status;
	return ts_image_write_png(png, ts_frame_data(&run->frame, TS_B_image_srgb), width, height, 3);
}

ts_status ts_viewer_take(const ts_run *run, const ts_stage *stage, const char *folder)
{
	if (ts_stage_writes(stage, TS_B_points_record)) return write_points(run, folder);
	if (ts_stage_writes(stage, TS_B_image_radiance)) return write_image(run, folder);
	if (!ts_stage_writes(stage, TS_B_eye_depth_triangle)) return TS_OK;
	ts_status status = write_eye(run, folder, true);
	return status == TS_OK ? write_eye(run, folder, false) : status;
}

/* Points as PLY: centre, splat length, piece. */
#include <inttypes.h>
#include "methods/points/tools/tools.h"
#include "output/file.h"

ts_status ts_points_view(const ts_run *run, const char *folder)
{
	const ts_point *points = ts_frame_data(&run->frame, TS_B_points_record);
	u64 n = ts_frame_n(&run->frame, TS_B_points_record);
	const char *path = ts_viewer_file(folder, "points.ply");
	ts_file_text text;
	if (path == NULL || ts_file_text_begin(&text, path) != TS_OK) return TS_ERROR;
	FILE *file = text.out;
	fprintf(file, "ply\nformat binary_little_endian 1.0\ncomment units of the scene\nelement vertex %" PRIu64 "\n", n);
	fputs("property float x\nproperty float y\nproperty float z\nproperty float length\nproperty uint piece\n", file);
	fputs("end_header\n", file);
	for (u64 i = 0; i < n; i++) {
		fwrite(points[i].centre, sizeof(f32), 3, file);
		fwrite(&points[i].length, sizeof(f32), 1, file);
		fwrite(&points[i].piece, sizeof(u32), 1, file);
	}
	return ts_file_text_write(&text, path);
}

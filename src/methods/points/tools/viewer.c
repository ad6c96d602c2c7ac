/* Points as PLY: centre, splat length, piece. */
#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include "tools.h"

ts_status ts_points_view(const ts_run *run, const char *folder)
{
	const ts_point *points = ts_frame_data(&run->frame, TS_B_points_record);
	u64 n = ts_frame_n(&run->frame, TS_B_points_record);
	const char *path = ts_viewer_file(folder, "points.ply");
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

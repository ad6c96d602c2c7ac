/* Pictures of points: points per triangle, splats and cubes as the pixels see them, index buffers, radiance. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "image/falsecolour.h"
#include "kernels/base/srgb.h"
#include "kernels/points/forward.h"
#include "kernels/raster/mip.h"
#include "methods/points/points.h"
#include "methods/points/tools/tools.h"
#include "methods/raster/tools/tools.h"

/* Points per triangle, summed over its pieces; to be released by free(). */
static u32 *points_per_triangle(const ts_run *run)
{
	const ts_piece *pieces = ts_frame_data(&run->frame, TS_B_split_piece);
	const u32 *offset = ts_frame_data(&run->frame, TS_B_points_offset);
	u64 n = ts_frame_n(&run->frame, TS_B_split_piece);
	u32 *points = ts_alloc_zero(run->scene->n_triangles, sizeof *points, "a stage picture");
	for (u64 q = 0; q < n && points != NULL; q++) points[pieces[q].triangle] += offset[q + 1] - offset[q];
	return points;
}

static ts_status take_points(ts_stage_pictures *pictures, const ts_run *run, ts_buffer_id id)
{
	(void)id;
	const ts_buffer *buffers = run->frame.buffer;
	if (!buffers[TS_B_eye_depth_triangle].made || !buffers[TS_B_split_piece].made) return TS_OK;
	ts_stage_picture *p =
		ts_stage_pictures_add(pictures, "points", TS_PARAM(&run->params, width), TS_PARAM(&run->params, height), false);
	u32 *points = p != NULL ? points_per_triangle(run) : NULL;
	if (points == NULL) return TS_ERROR;
	const u64 *eye = ts_frame_data(&run->frame, TS_B_eye_depth_triangle);
	for (u64 i = 0; i < (u64)p->width * p->height; i++) {
		u32 n = eye[i] != TS_EMPTY ? points[(u32)eye[i]] : 0;
		if (n > 0) ts_falsecolour_ramp(p->rgb + 3 * i, log2(n) / 16);
	}
	free(points);
	snprintf(p->caption, sizeof p->caption, "points of the triangle in each pixel: none black, 1 dark to 65536 bright");
	return TS_OK;
}

static const ts_launch stored_points = TS_LAUNCH(points, TS_IN(keys, points_key), TS_IN(points, points_record));
static const ts_launch counted_points = TS_LAUNCH(points, TS_IN(offset, points_offset));

/* Splat length in texels of the cube that holds it, as seen by the pixel's first sample; 0: empty. n_pieces 0: points
 * are stored. */
static double splat_texels(const ts_points_args *from, u32 n_pieces, const ts_face *face, u32 point)
{
	if (point == TS_NONE) return 0;
	f32 centre[3];
	double d2 = 0;
	ts_flight seen = ts_k_flight_at(from, n_pieces, point);
	ts_store3(centre, seen.centre);
	for (u32 c = 0; c < 3; c++) {
		double d = (double)centre[c] - (double)face->centre[c];
		d2 += d * d;
	}
	return d2 > 0 ? (double)seen.length * face->n / 2 / sqrt(d2) : 0;
}

static ts_status take_splats(ts_stage_pictures *pictures, const ts_run *run, ts_buffer_id id)
{
	const ts_frame *frame = &run->frame;
	u64 n = ts_frame_n(frame, TS_B_mirror_pixel_record);
	ts_stage_picture *p =
		ts_stage_pictures_add(pictures, "splats", TS_PARAM(&run->params, width), TS_PARAM(&run->params, height), true);
	if (p == NULL) return TS_ERROR;
	const ts_pixel *pixels = ts_frame_data(frame, TS_B_mirror_pixel_record);
	const ts_face *faces = ts_frame_data(frame, TS_B_cube_size_face);
	const u32 *lookup = ts_frame_data(frame, id);
	u64 samples = n > 0 ? ts_frame_n(frame, id) / n : 0;
	bool again = ts_points_again(run);
	ts_points_args from = again ? ts_points_values(run) : (ts_points_args){.keys = NULL};
	u32 n_pieces = again ? (u32)ts_run_size(run, TS_DIM_pieces) : 0;
	if (TS_ASK(run, n_pieces != 0 ? &counted_points : &stored_points, &from) != TS_OK) return TS_ERROR;
	for (u64 i = 0; i < n; i++) {
		double texels = splat_texels(&from, n_pieces, &faces[pixels[i].reflector], lookup[i * samples]);
		size_t pixel = pixels[i].index % ((size_t)p->width * p->height);
		p->mask[pixel] = 1;
		if (texels > 0) ts_falsecolour_ramp(p->rgb + 3 * pixel, (log2(texels) + 3) / 8);
	}
	snprintf(p->caption, sizeof p->caption, "splat seen by each reflective pixel: 1/8 texel dark to 32 texels bright");
	return TS_OK;
}

static ts_status take_faces(ts_stage_pictures *pictures, const ts_run *run, ts_buffer_id id)
{
	(void)id;
	ts_stage_picture *p =
		ts_stage_pictures_add(pictures, "faces", TS_PARAM(&run->params, width), TS_PARAM(&run->params, height), true);
	if (p == NULL) return TS_ERROR;
	const ts_pixel *pixels = ts_frame_data(&run->frame, TS_B_mirror_pixel_record);
	const ts_face *faces = ts_frame_data(&run->frame, TS_B_cube_size_face);
	for (u64 i = 0; i < ts_frame_n(&run->frame, TS_B_mirror_pixel_record); i++) {
		size_t pixel = pixels[i].index % ((size_t)p->width * p->height);
		p->mask[pixel] = 1;
		double share = (double)faces[pixels[i].reflector].n / TS_PARAM(&run->params, cube_max_px);
		ts_falsecolour_ramp(p->rgb + 3 * pixel, share);
	}
	snprintf(p->caption, sizeof p->caption, "cube face behind each reflective pixel: 0 texels dark to %u bright",
	         (unsigned)TS_PARAM(&run->params, cube_max_px));
	return TS_OK;
}

static ts_status take_indices(ts_stage_pictures *pictures, const ts_run *run, ts_buffer_id id)
{
	return ts_picture_indices(pictures, run, id, "a colour a point, empty grey");
}

static void colour_shared(u8 *rgb, const void *texels, u64 i)
{
	f32 radiance[3];
	u64 key = ((const u64 *)texels)[i];
	ts_store3(radiance, ts_k_shared_radiance((u32)key));
	for (u32 c = 0; c < 3; c++) rgb[c] = key == TS_EMPTY ? ts_picture_nothing[c] : (u8)ts_srgb_byte(radiance[c]);
}

static ts_status take_colours(ts_stage_pictures *pictures, const ts_run *run, ts_buffer_id id)
{
	u32 cube;
	if (!ts_picture_largest_cube(run, &cube)) return TS_OK;
	const ts_face *faces = ts_frame_data(&run->frame, TS_B_cube_size_face);
	const u64 *texels = (const u64 *)ts_frame_data(&run->frame, id) + faces[cube].offset;
	return ts_picture_cube(pictures, run, cube, "cube", "radiance of points, empty grey", texels, colour_shared);
}

static void colour_radiance(u8 *rgb, const void *texels, u64 i)
{
	for (u32 c = 0; c < 3; c++) rgb[c] = (u8)ts_srgb_byte(((const f32 *)texels)[4 * i + c]);
}

static ts_status take_radiance(ts_stage_pictures *pictures, const ts_run *run, ts_buffer_id id)
{
	u32 cube;
	if (!ts_picture_largest_cube(run, &cube)) return TS_OK;
	const ts_face *faces = ts_frame_data(&run->frame, TS_B_cube_size_face);
	const f32 *texels = (const f32 *)ts_frame_data(&run->frame, id) + 4 * ts_k_mip_first(faces, run->first_unit, cube);
	return ts_picture_cube(pictures, run, cube, "cube", "radiance", texels, colour_radiance);
}

const ts_stage_picture_rule ts_points_pictures[] = {
	{TS_B_points_offset, take_points},       {TS_B_splat_depth_index, take_indices},
	{TS_B_lookup_point, take_splats},        {TS_B_lookup_point, take_faces},
	{TS_B_splat_depth_colour, take_colours}, {TS_B_lookup_colour, take_faces},
	{TS_B_cube_face_mip, take_radiance},     {.take = NULL},
};

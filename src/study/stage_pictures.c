/* Pictures of what the stages made: points per triangle, splat sizes, face resolutions, index buffers, faces, depth
 * maps, light that arrives. Those of hulls: hull_pictures.c. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "../methods/pipeline.h"
#include "../image/falsecolour.h"
#include "../kernels/raster/mip.h"
#include "../kernels/base/srgb.h"
#include "hull_pictures.h"
#include "stage_pictures.h"

/* Where the faces +X -X +Y -Y +Z -Z stand in a cross of 4 by 3, so that edges meet. */
static const u8 cross_column[6] = { 2, 0, 1, 1, 1, 3 };
static const u8 cross_row[6] = { 1, 1, 0, 2, 1, 1 };
static const u8 nothing[3] = { 40, 40, 40 };

ts_stage_picture *ts_stage_pictures_add(ts_stage_pictures *pictures, const char *name, u32 width, u32 height, bool masked)
{
	if (pictures->n == TS_MAX_STAGE_PICTURES) {
		ts_fail("picture %s: one more than %d", name, TS_MAX_STAGE_PICTURES);
		return NULL;
	}
	ts_stage_picture *p = &pictures->picture[pictures->n++];
	snprintf(p->name, sizeof p->name, "%s", name);
	p->width = width;
	p->height = height;
	p->zoom = 1;
	p->rgb = ts_alloc_zero((size_t)width * height, 3, "a stage picture");
	p->mask = masked ? ts_alloc_zero((size_t)width, height, "a stage picture") : NULL;
	return p->rgb != NULL && (!masked || p->mask != NULL) ? p : NULL;
}

ts_stage_picture *ts_stage_pictures_find(ts_stage_pictures *pictures, const char *name)
{
	for (u32 i = 0; i < pictures->n; i++) {
		if (strcmp(pictures->picture[i].name, name) == 0) return &pictures->picture[i];
	}
	return NULL;
}

static bool has(const ts_run *run, ts_buffer_id id) { return run->frame.buffer[id].made; }

/* Points of each triangle: the pieces' counts added up. By free(). */
static u32 *points_per_triangle(const ts_run *run)
{
	const ts_piece *pieces = ts_frame_data(&run->frame, TS_B_split_triangle);
	const u32 *offset = ts_frame_data(&run->frame, TS_B_count_offset);
	u64 n = ts_frame_n(&run->frame, TS_B_split_triangle);
	u32 *points = ts_alloc_zero(run->scene->n_triangles, sizeof *points, "a stage picture");
	for (u64 q = 0; q < n && points != NULL; q++) points[pieces[q].triangle] += offset[q + 1] - offset[q];
	return points;
}

static ts_status take_points(ts_stage_pictures *pictures, const ts_run *run)
{
	if (!has(run, TS_B_eye_depth_triangle) || !has(run, TS_B_split_triangle)) return TS_OK;
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

/* Splat length in texels of the cube that holds it, as seen by the pixel's first sample; 0: empty. */
static double splat_texels(const ts_run *run, const ts_face *face, u32 point)
{
	const ts_point *points = ts_frame_data(&run->frame, TS_B_points_record);
	double d2 = 0;
	for (u32 c = 0; c < 3 && point != TS_NONE; c++) {
		double d = (double)points[point].centre[c] - (double)face->centre[c];
		d2 += d * d;
	}
	return d2 > 0 ? (double)points[point].length * face->n / 2 / sqrt(d2) : 0;
}

static ts_status take_splats(ts_stage_pictures *pictures, const ts_run *run)
{
	const ts_frame *frame = &run->frame;
	u64 n = ts_frame_n(frame, TS_B_pixel_record);
	ts_stage_picture *p =
		ts_stage_pictures_add(pictures, "splats", TS_PARAM(&run->params, width), TS_PARAM(&run->params, height), true);
	if (p == NULL) return TS_ERROR;
	const ts_pixel *pixels = ts_frame_data(frame, TS_B_pixel_record);
	const ts_face *faces = ts_frame_data(frame, TS_B_resize_face);
	const u32 *lookup = ts_frame_data(frame, TS_B_lookup_point);
	u64 samples = n > 0 ? ts_frame_n(frame, TS_B_lookup_point) / n : 0;
	for (u64 i = 0; i < n; i++) {
		double texels = splat_texels(run, &faces[pixels[i].reflector], lookup[i * samples]);
		p->mask[pixels[i].index] = 1;
		if (texels > 0) ts_falsecolour_ramp(p->rgb + 3 * (size_t)pixels[i].index, (log2(texels) + 3) / 8);
	}
	snprintf(p->caption, sizeof p->caption, "splat seen by each reflective pixel: 1/8 texel dark to 32 texels bright");
	return TS_OK;
}

static ts_status take_faces(ts_stage_pictures *pictures, const ts_run *run)
{
	ts_stage_picture *p =
		ts_stage_pictures_add(pictures, "faces", TS_PARAM(&run->params, width), TS_PARAM(&run->params, height), true);
	if (p == NULL) return TS_ERROR;
	const ts_pixel *pixels = ts_frame_data(&run->frame, TS_B_pixel_record);
	const ts_face *faces = ts_frame_data(&run->frame, TS_B_resize_face);
	for (u64 i = 0; i < ts_frame_n(&run->frame, TS_B_pixel_record); i++) {
		p->mask[pixels[i].index] = 1;
		double share = (double)faces[pixels[i].reflector].n / TS_PARAM(&run->params, face_max);
		ts_falsecolour_ramp(p->rgb + 3 * (size_t)pixels[i].index, share);
	}
	snprintf(p->caption, sizeof p->caption, "cube face behind each reflective pixel: 0 texels dark to %u bright",
	         (unsigned)TS_PARAM(&run->params, face_max));
	return TS_OK;
}

/* The largest cube of all; false if there is none or it is not in this batch. */
static bool largest_cube(const ts_run *run, u32 *reflector)
{
	const ts_face *faces = ts_frame_data(&run->frame, TS_B_resize_face);
	u64 n = ts_frame_n(&run->frame, TS_B_resize_face);
	*reflector = 0;
	for (u64 r = 1; r < n; r++) *reflector = faces[r].n > faces[*reflector].n ? (u32)r : *reflector;
	return n > 0 && faces[*reflector].n > 0 && *reflector >= run->first_unit &&
		*reflector - run->first_unit < run->n_units;
}

/* Lays the six faces of n x n texels out; colour() paints texel i of the cube. */
static void paint_cross(ts_stage_picture *p, u32 n, const void *texels, void (*colour)(u8 *rgb, const void *texels, u64 i))
{
	for (u32 f = 0; f < 6; f++) {
		for (u32 y = 0; y < n; y++) {
			u64 row = ((u64)cross_row[f] * n + y) * p->width + (u64)cross_column[f] * n;
			for (u32 x = 0; x < n; x++) colour(p->rgb + 3 * (row + x), texels, ((u64)f * n + y) * n + x);
		}
	}
}

static void colour_index(u8 *rgb, const void *texels, u64 i)
{
	u64 key = ((const u64 *)texels)[i];
	if (key == TS_EMPTY) {
		memcpy(rgb, nothing, 3);
	} else {
		ts_falsecolour_name(rgb, (u32)key);
	}
}

static void colour_radiance(u8 *rgb, const void *texels, u64 i)
{
	for (u32 c = 0; c < 3; c++) rgb[c] = (u8)ts_srgb_byte(((const f32 *)texels)[4 * i + c]);
}

static ts_status take_cube(ts_stage_pictures *pictures, const ts_run *run, ts_buffer_id id, const char *name,
                           const char *what)
{
	u32 r;
	if (!has(run, TS_B_resize_face) || !largest_cube(run, &r)) return TS_OK;
	if (ts_stage_pictures_find(pictures, name) != NULL) return TS_OK;
	const ts_face *faces = ts_frame_data(&run->frame, TS_B_resize_face);
	u32 n = faces[r].n;
	ts_stage_picture *p = ts_stage_pictures_add(pictures, name, 4 * n, 3 * n, false);
	if (p == NULL) return TS_ERROR;
	if (id == TS_B_face_mip) {
		u64 first = 4 * ts_k_mip_first(faces, run->first_unit, r);
		paint_cross(p, n, (const f32 *)ts_frame_data(&run->frame, id) + first, colour_radiance);
	} else {
		u64 first = faces[r].offset - faces[run->first_unit].offset;
		paint_cross(p, n, (const u64 *)ts_frame_data(&run->frame, id) + first, colour_index);
	}
	snprintf(p->caption, sizeof p->caption, "cube %u, six faces of %u texels: %s", (unsigned)r, (unsigned)n, what);
	return TS_OK;
}

enum { MOST_TEXELS = 1024 }; /* a side, of the picture of a depth map; of a cube's face half of it */

/* Square depth maps, one or six, shown by n of their texels a side, and between which depths they are. */
typedef struct { const u32 *depth; u32 size, n; f32 nearest, farthest; } depth_map;

static depth_map depth_map_of(const u32 *depth, u32 size, bool cubes)
{
	u32 most = cubes ? MOST_TEXELS / 2 : MOST_TEXELS;
	depth_map m = { depth, size, size < most ? size : most, INFINITY, 0 };
	for (u64 i = 0; i < (u64)(cubes ? 6 : 1) * size * size; i++) {
		if (depth[i] == TS_NONE) continue;
		m.nearest = ts_min(m.nearest, ts_u2f(depth[i]));
		m.farthest = ts_max(m.farthest, ts_u2f(depth[i]));
	}
	return m;
}

/* The nearest is white, the farthest dark grey. */
static void colour_depth(u8 *rgb, const void *texels, u64 i)
{
	static const u8 empty[3] = { 24, 24, 64 };
	const depth_map *m = texels;
	u64 x = i % m->n * m->size / m->n, y = i / m->n % m->n * m->size / m->n, face = i / m->n / m->n;
	u32 depth = m->depth[(face * m->size + y) * m->size + x];
	memcpy(rgb, empty, 3);
	if (depth == TS_NONE) return;
	f32 range = m->farthest - m->nearest, deep = range > 0 ? (ts_u2f(depth) - m->nearest) / range : 0;
	memset(rgb, (int)(255 - 215 * deep), 3);
}

/* The first depth map, or all faces of the first cube. */
static ts_status take_depth(ts_stage_pictures *pictures, const ts_run *run)
{
	bool cubes = has(run, TS_B_resize_face) && ts_frame_n(&run->frame, TS_B_resize_face) > 0;
	const ts_offscreen *view = ts_frame_data(&run->frame, TS_B_offscreen_view);
	if (run->first_unit != 0 || view->width == 0 || view->width != view->height) return TS_OK;
	if (ts_stage_pictures_find(pictures, "depth") != NULL) return TS_OK;
	depth_map map = depth_map_of(ts_frame_data(&run->frame, TS_B_scatter_depth), view->width, cubes);
	u32 width = cubes ? 4 * map.n : map.n, height = cubes ? 3 * map.n : map.n;
	ts_stage_picture *p = ts_stage_pictures_add(pictures, "depth", width, height, false);
	if (p == NULL) return TS_ERROR;
	if (cubes) {
		paint_cross(p, map.n, &map, colour_depth);
	} else {
		for (u64 i = 0; i < (u64)map.n * map.n; i++) colour_depth(p->rgb + 3 * i, &map, i);
	}
	snprintf(p->caption, sizeof p->caption, "%s of the first light sample: near white, far dark, empty blue",
	         cubes ? "cube" : "depth map");
	return TS_OK;
}

/* When the last batch has been resolved. */
static ts_status take_lit(ts_stage_pictures *pictures, const ts_run *run)
{
	if (run->first_unit + run->n_units != run->plan.units) return TS_OK;
	ts_stage_picture *p =
		ts_stage_pictures_add(pictures, "lit", TS_PARAM(&run->params, width), TS_PARAM(&run->params, height), false);
	if (p == NULL) return TS_ERROR;
	const u32 *lit = ts_frame_data(&run->frame, TS_B_resolve_lit);
	const ts_lamp *lamps = ts_frame_data(&run->frame, TS_B_lamp_shape);
	u64 n, n_lamps = ts_frame_n(&run->frame, TS_B_lamp_shape);
	const u64 *seen = ts_pipeline_seen(run, &n);
	for (u64 i = 0; i < n; i++) {
		double share = 0;
		for (u64 k = 0; k < n_lamps; k++) share += (double)lit[i * n_lamps + k] / lamps[k].samples / (double)n_lamps;
		memset(p->rgb + 3 * i, seen[i] != TS_EMPTY ? (int)(255 * share + 0.5) : nothing[0], 3);
	}
	snprintf(p->caption, sizeof p->caption, "samples that reach each pixel, mean of all lights: none black, all white");
	return TS_OK;
}

static ts_status take(ts_stage_pictures *pictures, const ts_run *run, ts_buffer_id id)
{
	switch (id) {
	case TS_B_count_offset: return take_points(pictures, run);
	case TS_B_splat_depth_index: return take_cube(pictures, run, id, "index", "a colour a point, empty grey");
	case TS_B_lookup_point:
		return take_splats(pictures, run) != TS_OK ? TS_ERROR : take_faces(pictures, run);
	case TS_B_face_depth_triangle: return take_cube(pictures, run, id, "index", "a colour a triangle, empty grey");
	case TS_B_scatter_depth: return take_depth(pictures, run);
	case TS_B_resolve_lit: return take_lit(pictures, run);
	case TS_B_face_mip: return take_cube(pictures, run, id, "cube", "radiance");
	case TS_B_segment_label: return ts_hull_pictures_segments(pictures, run);
	case TS_B_box_record: return ts_hull_pictures_boxes(pictures, run);
	case TS_B_fit_lobes: return ts_hull_pictures_lobes(pictures, run);
	default: return TS_OK;
	}
}

ts_status ts_stage_pictures_take(ts_stage_pictures *pictures, const ts_run *run, const ts_stage *stage)
{
	ts_status status = TS_OK;
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		if (status == TS_OK && has(run, *id)) status = take(pictures, run, *id);
	}
	return status;
}

void ts_stage_pictures_finish(ts_stage_pictures *pictures, const u8 *srgb)
{
	for (u32 k = 0; k < pictures->n; k++) {
		ts_stage_picture *p = &pictures->picture[k];
		for (u64 i = 0; p->mask != NULL && i < (u64)p->width * p->height; i++) {
			const u8 *pixel = srgb + 3 * (i / p->width / p->zoom * (p->width / p->zoom) + i % p->width / p->zoom);
			if (p->mask[i] == 0) memset(p->rgb + 3 * i, (pixel[0] + 2 * pixel[1] + pixel[2]) / 12, 3);
		}
	}
}

void ts_stage_pictures_free(ts_stage_pictures *pictures)
{
	for (u32 k = 0; k < pictures->n; k++) {
		free(pictures->picture[k].rgb);
		free(pictures->picture[k].mask);
	}
	pictures->n = 0;
}

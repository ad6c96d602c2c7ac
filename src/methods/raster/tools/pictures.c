/* Pictures of cubes, depth maps and arriving light. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "image/falsecolour.h"
#include "kernels/base/num.h"
#include "methods/pipeline.h"
#include "methods/raster/tools/tools.h"

const u8 ts_picture_nothing[3] = {40, 40, 40};

/* Where the faces +X -X +Y -Y +Z -Z stand in a cross of 4 by 3, so that edges meet. */
static const u8 cross_column[6] = {2, 0, 1, 1, 1, 3};
static const u8 cross_row[6] = {1, 1, 0, 2, 1, 1};

bool ts_picture_largest_cube(const ts_run *run, u32 *cube)
{
	if (!run->frame.buffer[TS_B_cube_size_face].made) return false;
	const ts_face *faces = ts_frame_data(&run->frame, TS_B_cube_size_face);
	u64 n = ts_frame_n(&run->frame, TS_B_cube_size_face);
	*cube = 0;
	for (u64 r = 1; r < n; r++) *cube = faces[r].n > faces[*cube].n ? (u32)r : *cube;
	bool in_batch = *cube >= run->first_unit && *cube - run->first_unit < run->n_units;
	return n > 0 && faces[*cube].n > 0 && in_batch;
}

/* Lays the six faces of n x n texels out; colour() paints texel i of the cube. */
static void paint_cross(ts_stage_picture *p, u32 n, const void *texels, ts_picture_colour *colour)
{
	for (u32 f = 0; f < 6; f++) {
		for (u32 y = 0; y < n; y++) {
			u64 row = ((u64)cross_row[f] * n + y) * p->width + (u64)cross_column[f] * n;
			for (u32 x = 0; x < n; x++) colour(p->rgb + 3 * (row + x), texels, ((u64)f * n + y) * n + x);
		}
	}
}

ts_status ts_picture_cube(ts_stage_pictures *pictures, const ts_run *run, u32 cube, const char *name, const char *what,
                          const void *texels, ts_picture_colour *colour)
{
	if (ts_stage_pictures_find(pictures, name) != NULL) return TS_OK;
	const ts_face *faces = ts_frame_data(&run->frame, TS_B_cube_size_face);
	u32 n = faces[cube].n;
	ts_stage_picture *p = ts_stage_pictures_add(pictures, name, 4 * n, 3 * n, false);
	if (p == NULL) return TS_ERROR;
	paint_cross(p, n, texels, colour);
	snprintf(p->caption, sizeof p->caption, "cube %u, six faces of %u texels: %s", (unsigned)cube, (unsigned)n, what);
	return TS_OK;
}

static void colour_index(u8 *rgb, const void *texels, u64 i)
{
	u64 key = ((const u64 *)texels)[i];
	if (key == TS_EMPTY) {
		memcpy(rgb, ts_picture_nothing, 3);
	} else {
		ts_falsecolour_name(rgb, (u32)key);
	}
}

ts_status ts_picture_indices(ts_stage_pictures *pictures, const ts_run *run, ts_buffer_id keys, const char *what)
{
	u32 cube;
	if (!ts_picture_largest_cube(run, &cube)) return TS_OK;
	const ts_face *faces = ts_frame_data(&run->frame, TS_B_cube_size_face);
	const u64 *texels = ts_frame_data(&run->frame, keys);
	u64 first = faces[cube].offset - faces[run->first_unit].offset;
	return ts_picture_cube(pictures, run, cube, "index", what, texels + first, colour_index);
}

static ts_status take_triangles(ts_stage_pictures *pictures, const ts_run *run, ts_buffer_id id)
{
	return ts_picture_indices(pictures, run, id, "a colour a triangle, empty grey");
}

enum { MOST_TEXELS = 1024 }; /* per side of a depth map's picture; half of it for a cube's face */

/* Square depth maps, one or six, shown at n texels per side, and the range of depths. */
typedef struct {
	const u32 *depth;
	u32 size, n;
	f32 nearest, farthest;
} depth_map;

static depth_map depth_map_of(const u32 *depth, u32 size, bool cubes)
{
	u32 most = cubes ? MOST_TEXELS / 2 : MOST_TEXELS;
	depth_map m = {depth, size, size < most ? size : most, INFINITY, 0};
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
	static const u8 empty[3] = {24, 24, 64};
	const depth_map *m = texels;
	u64 x = i % m->n * m->size / m->n, y = i / m->n % m->n * m->size / m->n, face = i / m->n / m->n;
	u32 depth = m->depth[(face * m->size + y) * m->size + x];
	memcpy(rgb, empty, 3);
	if (depth == TS_NONE) return;
	f32 range = m->farthest - m->nearest, deep = range > 0 ? (ts_u2f(depth) - m->nearest) / range : 0;
	memset(rgb, (int)(255 - 215 * deep), 3);
}

/* The first depth map, or all faces of the first cube. */
static ts_status take_depth(ts_stage_pictures *pictures, const ts_run *run, ts_buffer_id id)
{
	bool cubes = run->frame.buffer[TS_B_cube_size_face].made && ts_frame_n(&run->frame, TS_B_cube_size_face) > 0;
	const ts_offscreen *view = ts_frame_data(&run->frame, TS_B_offscreen_view);
	if (run->first_unit != 0 || view->width == 0 || view->width != view->height) return TS_OK;
	if (ts_stage_pictures_find(pictures, "depth") != NULL) return TS_OK;
	depth_map map = depth_map_of(ts_frame_data(&run->frame, id), view->width, cubes);
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

/* Once the last batch has been resolved. */
static ts_status take_lit(ts_stage_pictures *pictures, const ts_run *run, ts_buffer_id id)
{
	if (run->first_unit + run->n_units != run->plan.units) return TS_OK;
	ts_stage_picture *p =
		ts_stage_pictures_add(pictures, "lit", TS_PARAM(&run->params, width), TS_PARAM(&run->params, height), false);
	if (p == NULL) return TS_ERROR;
	const u32 *lit = ts_frame_data(&run->frame, id);
	const ts_lamp *lamps = ts_frame_data(&run->frame, TS_B_lamp_shape);
	u64 n, n_lamps = ts_frame_n(&run->frame, TS_B_lamp_shape);
	const u64 *seen = ts_pipeline_seen(run, &n);
	for (u64 i = 0, n_pixels = (u64)p->width * p->height; i < n_pixels; i++) {
		double share = 0, asked = 0;
		for (u64 at = i; at < n; at += n_pixels) {
			asked += seen[at] != TS_EMPTY;
			for (u64 k = 0; k < n_lamps; k++) share += (double)lit[at * n_lamps + k] / lamps[k].samples;
		}
		int grey = asked > 0 ? (int)(255 * share / (double)n_lamps / asked + 0.5) : ts_picture_nothing[0];
		memset(p->rgb + 3 * i, grey, 3);
	}
	snprintf(p->caption, sizeof p->caption, "samples that reach each pixel, mean of all lights: none black, all white");
	return TS_OK;
}

const ts_stage_picture_rule ts_raster_pictures[] = {
	{TS_B_cube_face_depth_triangle, take_triangles},
	{TS_B_depth_map_depth, take_depth},
	{TS_B_shadow_test_lit, take_lit},
	{.take = NULL},
};

/* Values that kernels loop over or address by, buffer by buffer. */
#include <inttypes.h>
#include <stdlib.h>
#include "../kernels/points/points.h"
#include "../kernels/base/shade.h"
#include "../methods/views/octree.h"
#include "check.h"

enum { MAX_SIDE = 1 << 22, MAX_REFLECTORS = 1 << 20, MAX_LATTICE = (1 << 23) - 1 };
static const u64 max_squares = 1ull << 34;

/* The elements of a buffer if it was loaded; else NULL and none. */
static const void *elements(const ts_load *load, ts_buffer_id id, u64 *n)
{
	*n = load->item[id] != NULL ? ts_frame_n(&load->run.frame, id) : 0;
	return load->item[id] != NULL ? ts_frame_data(&load->run.frame, id) : NULL;
}

static ts_status check_sum(const ts_load *load, const ts_sum_info *sum)
{
	u64 n, total = sum->size != TS_DIM_none ? load->sizes.n[sum->size] : TS_UNKNOWN;
	ts_buffer_id id = sum->buffer;
	const u32 *offset = elements(load, id, &n);
	if (n != 0 && offset[0] != 0) return ts_check_refuse(load, id, 0, "", 0, "0, where sums begin,");
	for (u64 i = 1; i < n; i++) {
		if (offset[i] < offset[i - 1]) {
			return ts_check_refuse(load, id, i, "", 0, "at least %" PRIu32 ", the sum before it,", offset[i - 1]);
		}
	}
	if (n == 0 || total == TS_UNKNOWN || offset[n - 1] == total) return TS_OK;
	return ts_check_refuse(load, id, n - 1, "", 0, "%" PRIu64 " (%s), where sums end,", total,
	                       ts_dim_table[sum->size].name);
}

/* Ids of octrees are compared with their masks (check_octree.c, check_gather.c). */
static bool are_ids(ts_buffer_id id) { return id == ts_scene_octree.before || id == ts_view_octree.before; }

static ts_status check_sums(const ts_load *load)
{
	size_t n;
	const ts_sum_info *sums = ts_sum_table(&n);
	for (size_t row = 0; row < n; row++) {
		if (!are_ids(sums[row].buffer) && check_sum(load, &sums[row]) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

/* Texels of a whole mip chain, and its levels. */
static u64 chain(u32 width, u32 height, u32 *n_levels)
{
	u64 texels = (u64)width * height;
	for (*n_levels = 1; width > 1 || height > 1; ++*n_levels) {
		width = width > 1 ? width >> 1 : 1;
		height = height > 1 ? height >> 1 : 1;
		texels += (u64)width * height;
	}
	return texels;
}

static ts_status check_images(const ts_load *load)
{
	const ts_buffer_id id = TS_B_scene_image;
	u64 n, n_texels = load->sizes.n[TS_DIM_image_texels];
	const ts_image *images = elements(load, id, &n);
	for (u64 i = 0; i < n; i++) {
		u32 levels;
		const ts_image *image = &images[i];
		if (image->width < 1 || image->width > MAX_SIDE)
			return ts_check_refuse(load, id, i, "width", 0, "1 to %d", MAX_SIDE);
		if (image->height < 1 || image->height > MAX_SIDE) {
			return ts_check_refuse(load, id, i, "height", 0, "1 to %d", MAX_SIDE);
		}
		u64 texels = chain(image->width, image->height, &levels);
		if (image->n_levels != levels) return ts_check_refuse(load, id, i, "n_levels", 0, "%" PRIu32, levels);
		if (image->first_texel <= n_texels && texels <= n_texels - image->first_texel) continue;
		return ts_check_refuse(load, id, i, "first_texel", 0,
		                       "a place before which %" PRIu64 " of %" PRIu64 " texels are left", texels, n_texels);
	}
	return TS_OK;
}

static ts_status check_slots(const ts_load *load)
{
	u64 n;
	const ts_slot *slots = elements(load, TS_B_scene_slot, &n);
	for (u64 i = 0; i < n; i++) {
		if (slots[i].uv_set > 1) return ts_check_refuse(load, TS_B_scene_slot, i, "uv_set", 0, "0 or 1");
		for (u32 k = 0; k < 2; k++) {
			if (slots[i].wrap[k] > TS_CLAMP) return ts_check_refuse(load, TS_B_scene_slot, i, "wrap", k, "0, 1 or 2");
		}
	}
	return TS_OK;
}

static ts_status check_lights(const ts_load *load)
{
	u64 n;
	const ts_light *lights = elements(load, TS_B_scene_light, &n);
	for (u64 i = 0; i < n; i++) {
		if (lights[i].kind > TS_LIGHT_KIND_SPOT)
			return ts_check_refuse(load, TS_B_scene_light, i, "kind", 0, "0, 1 or 2");
	}
	return TS_OK;
}

/* One object for each of the reflectors, whose indices have been checked. */
static ts_status check_reflectors(const ts_load *load, const ts_object *objects, u64 n)
{
	u32 n_reflectors = load->scene.info.n_reflectors;
	u32 *owner = ts_alloc(n_reflectors, sizeof *owner, "reflectors");
	if (owner == NULL) return TS_ERROR;
	for (u32 r = 0; r < n_reflectors; r++) owner[r] = TS_NONE;
	ts_status status = TS_OK;
	u32 named = 0;
	for (u64 i = 0; i < n && status == TS_OK; i++) {
		u32 r = objects[i].reflector;
		if (r == TS_NONE) continue;
		if (owner[r] != TS_NONE) {
			status = ts_check_refuse(load, TS_B_scene_object, i, "reflector", 0, "one that object %" PRIu32 " is not",
			                         owner[r]);
		} else if (objects[i].n_vertices == 0) {
			status = ts_check_refuse(load, TS_B_scene_object, i, "n_vertices", 0, "at least 1, of a reflector,");
		}
		owner[r] = (u32)i;
		named++;
	}
	free(owner);
	if (status != TS_OK || named == n_reflectors) return status;
	return ts_fail("%s: %" PRIu32 " objects are reflectors; %" PRIu32 " (reflectors) would be right",
	               load->item[TS_B_scene_object]->path, named, n_reflectors);
}

static ts_status check_objects(const ts_load *load)
{
	const ts_buffer_id id = TS_B_scene_object;
	u64 n, n_vertices = load->sizes.n[TS_DIM_vertices], next = 0;
	const ts_object *objects = elements(load, id, &n);
	for (u64 i = 0; i < n; i++) {
		if (objects[i].first_vertex != next) return ts_check_refuse(load, id, i, "first_vertex", 0, "%" PRIu64, next);
		if (objects[i].n_vertices > n_vertices - next) {
			return ts_check_refuse(load, id, i, "n_vertices", 0, "at most %" PRIu64, n_vertices - next);
		}
		next += objects[i].n_vertices;
	}
	bool any = load->item[id] != NULL && load->sizes.n[TS_DIM_reflectors] != TS_UNKNOWN;
	return any ? check_reflectors(load, objects, n) : TS_OK;
}

static ts_status check_view(const ts_load *load)
{
	u64 n;
	const ts_params *params = &load->run.params;
	const ts_view *view = elements(load, TS_B_eye_view, &n);
	if (n == 0) return TS_OK;
	if (view->width != TS_PARAM(params, width)) {
		return ts_check_refuse(load, TS_B_eye_view, 0, "width", 0, "%" PRIu32 ", as the parameter,",
		                       TS_PARAM(params, width));
	}
	if (view->height != TS_PARAM(params, height)) {
		return ts_check_refuse(load, TS_B_eye_view, 0, "height", 0, "%" PRIu32 ", as the parameter,",
		                       TS_PARAM(params, height));
	}
	return TS_OK;
}

u32 ts_check_largest(const ts_run *run)
{
	u32 fixed = run->plan.offscreen.side != 0 ? run->plan.offscreen.side : TS_PARAM(&run->params, face_px);
	return fixed != 0 ? fixed : ts_largest_face(&run->params);
}

ts_status ts_check_faces(const ts_load *load)
{
	const ts_buffer_id id = TS_B_resize_face;
	u64 n, offset = 0;
	const ts_face *cubes = elements(load, id, &n);
	u32 most = ts_check_largest(&load->run);
	for (u64 i = 0; i < n; i++) {
		if (cubes[i].n > most) {
			return ts_check_refuse(load, id, i, "n", 0, "at most %" PRIu32 ", by the parameters,", most);
		}
		if (cubes[i].offset != offset) {
			return ts_check_refuse(load, id, i, "offset", 0, "%" PRIu64 ", the texels of the cubes before it,", offset);
		}
		offset += (u64)6 * cubes[i].n * cubes[i].n;
	}
	return TS_OK;
}

/* Lattice squares that count and points walk over. */
static u64 squares(const ts_align *frame)
{
	if (!(frame->s > 0.0f)) return 0;
	ts_box box = ts_k_lattice_cover(frame, 129).touched;
	return box.x1 < box.x0 || box.y1 < box.y0 ? 0 : (u64)(box.x1 - box.x0 + 1) * (u64)(box.y1 - box.y0 + 1);
}

static ts_status check_frames(const ts_load *load, const ts_stage *stage)
{
	const ts_buffer_id id = TS_B_align_frame;
	u64 n, all = 0;
	const ts_align *frames = elements(load, id, &n);
	bool scatters = ts_stage_writes(stage, TS_B_scatter_depth) || ts_stage_writes(stage, TS_B_scatter_colour);
	bool walked = scatters || ts_stage_writes(stage, TS_B_count_offset) || ts_stage_reads(stage, TS_B_count_offset);
	for (u64 i = 0; i < n; i++) {
		if (frames[i].s < 0.0f) return ts_check_refuse(load, id, i, "s", 0, "0 or more");
		for (u32 k = 0; k < 6; k++) {
			bool inside = frames[i].q[k] >= -MAX_LATTICE && frames[i].q[k] <= MAX_LATTICE;
			if (!inside) return ts_check_refuse(load, id, i, "q", k, "from -%d to %d", MAX_LATTICE, MAX_LATTICE);
		}
		all += squares(&frames[i]);
		if (walked && all > max_squares) {
			return ts_fail("%s: element %" PRIu64 ": the pieces up to it span %" PRIu64 " lattice squares; at most %" PRIu64
			               " would be right", load->item[id]->path, i, all, max_squares);
		}
	}
	return TS_OK;
}

/* Points are written where count.offset says: the sums that stage count makes of the same pieces. */
static ts_status check_counts(const ts_load *load, const ts_stage *stage)
{
	if (!ts_stage_writes(stage, TS_B_points_record)) return TS_OK;
	return ts_check_again(load, ts_pipeline_maker(load->pipeline, TS_B_count_offset)->stage, "align.frame");
}

static ts_status check_segments(const ts_load *load)
{
	const ts_buffer_id id = TS_B_box_record;
	u64 n;
	const ts_segment *boxes = elements(load, id, &n);
	for (u64 i = 0; i < n; i++) {
		for (u32 k = 0; k < 2; k++) {
			if (boxes[i].high[k] >= boxes[i].low[k]) continue;
			return ts_check_refuse(load, id, i, "high", k, "at least %" PRIu32 ", as low,", boxes[i].low[k]);
		}
	}
	return TS_OK;
}

/* The low halves are indices. */
static ts_status check_rendered(const ts_load *load)
{
	u64 n, n_nodes = load->sizes.n[TS_DIM_nodes];
	const u64 *pairs = elements(load, TS_B_traverse_rendered, &n);
	for (u64 i = 0; i < n; i++) {
		if (pairs[i] >> 32 < n_nodes) continue;
		return ts_check_refuse(load, TS_B_traverse_rendered, i, "", 0, "less than %" PRIu64 " (nodes) in the high half",
		                       n_nodes);
	}
	return TS_OK;
}

ts_status ts_check_values(const ts_load *load, const ts_stage *stage)
{
	if (load->scene.info.n_reflectors > MAX_REFLECTORS) {
		return ts_fail("%s: %" PRIu32 " reflectors; at most %d would be right", load->reference->dir,
		               load->scene.info.n_reflectors, MAX_REFLECTORS);
	}
	if (load->run.plan.units > MAX_REFLECTORS) {
		return ts_fail("%s: %" PRIu32 " cubes or views; at most %d would be right", load->reference->dir,
		               load->run.plan.units, MAX_REFLECTORS);
	}
	if (check_sums(load) != TS_OK || check_images(load) != TS_OK || check_slots(load) != TS_OK) return TS_ERROR;
	if (check_lights(load) != TS_OK || check_objects(load) != TS_OK || check_view(load) != TS_OK) return TS_ERROR;
	if (ts_check_lamps(load, stage) != TS_OK || check_frames(load, stage) != TS_OK) return TS_ERROR;
	if (check_segments(load) != TS_OK || check_rendered(load) != TS_OK) return TS_ERROR;
	if (ts_check_surfels(load) != TS_OK) return TS_ERROR;
	if (ts_check_octrees(load, stage) != TS_OK || ts_check_gather(load, stage) != TS_OK) return TS_ERROR;
	return check_counts(load, stage);
}

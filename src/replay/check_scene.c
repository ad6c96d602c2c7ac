/* The scene: images, texture references, lights and objects. */
#include <inttypes.h>
#include <stdlib.h>
#include "kernels/base/shade.h"
#include "replay/check.h"

enum { MAX_SIDE = 1 << 22 };

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

static ts_status check_images(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)stage;
	u64 n, n_texels = load->sizes.n[TS_DIM_image_texels];
	const ts_image *images = ts_check_elements(load, id, &n);
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

static ts_status check_slots(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)stage;
	u64 n;
	const ts_slot *slots = ts_check_elements(load, id, &n);
	for (u64 i = 0; i < n; i++) {
		if (slots[i].uv_set > 1) return ts_check_refuse(load, id, i, "uv_set", 0, "0 or 1");
		for (u32 k = 0; k < 2; k++) {
			if (slots[i].wrap[k] > TS_CLAMP) return ts_check_refuse(load, id, i, "wrap", k, "0, 1 or 2");
		}
	}
	return TS_OK;
}

ts_status ts_check_kinds(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)stage;
	u64 n;
	const ts_light *lights = ts_check_elements(load, id, &n);
	for (u64 i = 0; i < n; i++) {
		if (lights[i].kind > TS_LIGHT_KIND_SPOT) return ts_check_refuse(load, id, i, "kind", 0, "0, 1 or 2");
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
	return ts_refuse("%s: %" PRIu32 " objects are reflectors; %" PRIu32 " (reflectors) would be right",
	                 load->item[TS_B_scene_object]->path, named, n_reflectors);
}

static ts_status check_objects(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)stage;
	u64 n, n_vertices = load->sizes.n[TS_DIM_vertices], next = 0;
	const ts_object *objects = ts_check_elements(load, id, &n);
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

static ts_status check_motions(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)stage;
	u64 n;
	const ts_motion *motions = ts_check_elements(load, id, &n);
	for (u64 i = 0; i < n; i++) {
		if (motions[i].moves > 2) return ts_check_refuse(load, id, i, "moves", 0, "0, 1 or 2");
	}
	return TS_OK;
}

const ts_check_rule ts_check_scene[] = {
	{TS_B_scene_image, TS_CHECK_VALUES, check_images},   {TS_B_scene_slot, TS_CHECK_VALUES, check_slots},
	{TS_B_scene_light, TS_CHECK_VALUES, ts_check_kinds}, {TS_B_scene_object, TS_CHECK_VALUES, check_objects},
	{TS_B_scene_motion, TS_CHECK_VALUES, check_motions}, {.check = NULL},
};

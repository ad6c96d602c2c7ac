/* The scene of a trace in memory, checked so that kernels stay within its arrays. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include "probe/parts.h"

static void shape_text(char *text, size_t bytes, u32 n, const u64 *dims)
{
	size_t used = 0;
	for (u32 i = 0; i < n; i++)
		used += (size_t)snprintf(text + used, bytes - used, "%s%" PRIu64, i > 0 ? " x " : "", dims[i]);
}

ts_status ts_probe_shapes(const ts_probe *p, u64 texels)
{
	ts_sizes sizes = p->sizes;
	sizes.n[TS_DIM_texels] = texels;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_trace_item *item = &p->trace->item[id];
		const ts_shape *shape = ts_buffer_shape((ts_buffer_id)id);
		u64 dims[TS_MAX_DIMS];
		char is[96], right[96];
		if (item->path == NULL || item->cropped || !ts_shape_dims(shape, &sizes, dims)) continue;
		if (memcmp(dims, item->npy.shape, shape->n * sizeof *dims) == 0) continue;
		shape_text(is, sizeof is, shape->n, item->npy.shape);
		shape_text(right, sizeof right, shape->n, dims);
		return ts_fail("%s: shape %s; %s, %s, would be right", item->path, is, right, ts_buffer_table[id].shape);
	}
	return TS_OK;
}

static ts_status check_images(const ts_probe *p)
{
	const char *path = p->trace->item[TS_B_scene_image].path;
	u64 n_texels = ts_probe_n(p, TS_B_scene_texel);
	for (u64 i = 0; i < ts_probe_n(p, TS_B_scene_image); i++) {
		const ts_image *image = &p->scene.images[i];
		u64 texels = 0, w = image->width, h = image->height;
		bool right = w >= 1 && h >= 1 && w <= TS_PROBE_SIDE && h <= TS_PROBE_SIDE && image->n_levels >= 1 &&
		             image->n_levels <= 15;
		for (u32 l = 0; right && l < image->n_levels; l++) {
			texels += w * h;
			w = w > 1 ? w / 2 : 1;
			h = h > 1 ? h / 2 : 1;
		}
		right = right && image->first_texel <= n_texels && texels <= n_texels - image->first_texel;
		if (!right) return ts_fail("%s: element %" PRIu64 ": no mip chain within scene.texel", path, i);
	}
	for (u64 i = 0; i < ts_probe_n(p, TS_B_scene_slot); i++) {
		if (p->scene.slots[i].uv_set <= 1) continue;
		return ts_fail("%s: element %" PRIu64 " field uv_set is %u; 0 or 1 would be right",
		               p->trace->item[TS_B_scene_slot].path, i, (unsigned)p->scene.slots[i].uv_set);
	}
	return TS_OK;
}

static ts_status check_view(const ts_probe *p)
{
	u32 w = p->view.width, h = p->view.height;
	const char *path = p->trace->item[TS_B_eye_view].path;
	if (w < 1 || h < 1 || w > TS_PROBE_SIDE || h > TS_PROBE_SIDE) {
		return ts_fail("%s: %u x %u pixels; at most %d x %d", path, (unsigned)w, (unsigned)h, TS_PROBE_SIDE,
		               TS_PROBE_SIDE);
	}
	if (w == p->sizes.n[TS_DIM_width] && h == p->sizes.n[TS_DIM_height]) return TS_OK;
	return ts_fail("%s: %u x %u pixels; %" PRIu64 " x %" PRIu64 ", as the parameters, would be right", path,
	               (unsigned)w, (unsigned)h, p->sizes.n[TS_DIM_width], p->sizes.n[TS_DIM_height]);
}

static ts_status read_arrays(ts_probe *p)
{
	ts_arrays *s = &p->scene;
	ts_buffer_id lights = ts_probe_makes(p, TS_B_lamp_light) ? TS_B_lamp_light : TS_B_scene_light;
	u64 n_triangles = ts_probe_n(p, TS_B_scene_triangle), n_lights = ts_probe_n(p, lights);
	const ts_info *info = ts_probe_whole(p, TS_B_scene_info);
	if (info == NULL) return TS_ERROR;
	s->ambient = ts_probe_n(p, TS_B_scene_info) > 0 ? info->ambient : 0.0f;
	s->vertices = ts_probe_whole(p, TS_B_pose_vertex);
	s->triangles = s->vertices != NULL ? ts_probe_whole(p, TS_B_scene_triangle) : NULL;
	s->materials = s->triangles != NULL ? ts_probe_whole(p, TS_B_scene_material) : NULL;
	s->slots = s->materials != NULL ? ts_probe_whole(p, TS_B_scene_slot) : NULL;
	s->images = s->slots != NULL ? ts_probe_whole(p, TS_B_scene_image) : NULL;
	s->lights = s->images != NULL ? ts_probe_whole(p, lights) : NULL;
	s->objects = s->lights != NULL ? ts_probe_whole(p, TS_B_scene_object) : NULL;
	if (s->objects == NULL) return TS_ERROR;
	if (n_triangles >= TS_NONE || n_lights >= TS_NONE) return ts_fail("%s: too large", p->trace->dir);
	s->n_triangles = (u32)n_triangles;
	s->n_lights = (u32)n_lights;
	return TS_OK;
}

ts_status ts_probe_scene(ts_probe *p)
{
	static const ts_buffer_id needed[] = {TS_B_scene_triangle, TS_B_scene_material, TS_B_scene_slot,   TS_B_scene_image,
	                                      TS_B_scene_texel,    TS_B_scene_light,    TS_B_scene_object, TS_B_scene_info,
	                                      TS_B_eye_view,       TS_B_pose_vertex,    TS_N_BUFFERS};
	if (p->texels != NULL) return TS_OK;
	if (ts_probe_require(p, needed) != TS_OK) return TS_ERROR;
	if (ts_probe_fetch(p, TS_B_eye_view, 0, 1, &p->view) != TS_OK || check_view(p) != TS_OK) return TS_ERROR;
	if (read_arrays(p) != TS_OK || ts_probe_shapes(p, TS_UNKNOWN) != TS_OK || check_images(p) != TS_OK) return TS_ERROR;
	free(p->image_read);
	p->image_read = ts_alloc_zero((size_t)ts_probe_n(p, TS_B_scene_image), 1, "images");
	if (p->image_read == NULL) return TS_ERROR;
	p->texels = ts_alloc_zero((size_t)ts_probe_n(p, TS_B_scene_texel), sizeof(u64), "scene.texel");
	p->scene.texels = p->texels;
	return p->texels != NULL ? TS_OK : TS_ERROR;
}

static ts_status read_image(ts_probe *p, u32 index)
{
	const ts_image *image = &p->scene.images[index];
	u64 n = 0, w = image->width, h = image->height;
	if (p->image_read[index]) return TS_OK;
	for (u32 l = 0; l < image->n_levels; l++) {
		n += w * h;
		w = w > 1 ? w / 2 : 1;
		h = h > 1 ? h / 2 : 1;
	}
	p->image_read[index] = 1;
	return ts_probe_fetch(p, TS_B_scene_texel, image->first_texel, n, p->texels + image->first_texel);
}

ts_status ts_probe_textures(ts_probe *p, u32 triangle)
{
	const ts_material *m = &p->scene.materials[p->scene.triangles[triangle].material];
	for (u32 i = 0; i < 5; i++) {
		if (m->slot[i] != TS_NONE && read_image(p, p->scene.slots[m->slot[i]].image) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

/* The scene of a trace in memory, checked so that no kernel reads beside an array. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include "../methods/views/views.h"
#include "../methods/stages.h"
#include "parts.h"

void *ts_probe_load(ts_probe *p, ts_buffer_id id, u64 *n)
{
	const ts_buffer_id needed[] = {id, TS_N_BUFFERS};
	if (ts_probe_require(p, needed) != TS_OK) return NULL;
	*n = ts_probe_n(p, id);
	void *data = ts_alloc((size_t)*n, ts_buffer_table[id].element_bytes, ts_buffer_table[id].name);
	if (data != NULL && *n > 0 && ts_probe_fetch(p, id, 0, *n, data) != TS_OK) {
		free(data);
		return NULL;
	}
	return data;
}

static void shape_text(char *text, size_t bytes, u32 n, const u64 *dims)
{
	size_t used = 0;
	for (u32 i = 0; i < n; i++)
		used += (size_t)snprintf(text + used, bytes - used, "%s%" PRIu64, i > 0 ? " x " : "", dims[i]);
}

/* Texels of cubes, and of views that are no cubes' faces. */
static u64 texels_of(const ts_probe *p)
{
	u64 texels = 0;
	for (u32 r = 0; r < p->n_cubes && p->mirrors; r++) texels += (u64)6 * p->cubes[r].n * p->cubes[r].n;
	for (u32 v = 0; v < p->n_views; v++) texels += (u64)p->views[v].width * p->views[v].height;
	return texels;
}

ts_status ts_probe_shapes(const ts_probe *p)
{
	ts_sizes sizes = p->sizes;
	sizes.n[TS_DIM_texels] = texels_of(p);
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
	for (u64 i = 0; i < p->n_images; i++) {
		const ts_image *image = &p->scene.images[i];
		u64 texels = 0, w = image->width, h = image->height;
		bool right =
			w >= 1 && h >= 1 && w <= TS_PROBE_SIDE && h <= TS_PROBE_SIDE && image->n_levels >= 1 && image->n_levels <= 15;
		for (u32 l = 0; right && l < image->n_levels; l++) {
			texels += w * h;
			w = w > 1 ? w / 2 : 1;
			h = h > 1 ? h / 2 : 1;
		}
		right = right && image->first_texel <= p->n_texels && texels <= p->n_texels - image->first_texel;
		if (!right) return ts_fail("%s: element %" PRIu64 ": no mip chain within scene.texel", path, i);
	}
	for (u64 i = 0; i < p->n_slots; i++) {
		if (p->scene.slots[i].uv_set <= 1) continue;
		return ts_fail("%s: element %" PRIu64 " field uv_set is %u; 0 or 1 would be right",
		               p->trace->item[TS_B_scene_slot].path, i, (unsigned)p->scene.slots[i].uv_set);
	}
	return TS_OK;
}

static ts_status check_cubes(const ts_probe *p)
{
	u64 offset = 0;
	const char *path = p->trace->item[TS_B_resize_face].path;
	for (u32 r = 0; r < p->n_cubes; r++) {
		if (p->cubes[r].n > TS_PROBE_SIDE || p->cubes[r].offset != offset) {
			return ts_fail("%s: element %u: size %u at texel %" PRIu64 "; it would begin at %" PRIu64, path,
			               (unsigned)r, (unsigned)p->cubes[r].n, p->cubes[r].offset, offset);
		}
		offset += (u64)6 * p->cubes[r].n * p->cubes[r].n;
	}
	return TS_OK;
}

static ts_status check_view(const ts_probe *p)
{
	u32 w = p->view.width, h = p->view.height;
	const char *path = p->trace->item[TS_B_eye_view].path;
	if (w < 1 || h < 1 || w > TS_PROBE_SIDE || h > TS_PROBE_SIDE) {
		return ts_fail("%s: %u x %u pixels; at most %d x %d", path, (unsigned)w, (unsigned)h, TS_PROBE_SIDE, TS_PROBE_SIDE);
	}
	if (w == p->sizes.n[TS_DIM_width] && h == p->sizes.n[TS_DIM_height]) return TS_OK;
	return ts_fail("%s: %u x %u pixels; %" PRIu64 " x %" PRIu64 ", as the parameters, would be right", path, (unsigned)w,
	               (unsigned)h, p->sizes.n[TS_DIM_width], p->sizes.n[TS_DIM_height]);
}

static ts_status load_arrays(ts_probe *p)
{
	ts_arrays *s = &p->scene;
	u64 n_triangles, n_cubes = 0, n;
	bool cubes = ts_pipeline_maker(p->trace->pipeline, TS_B_resize_face) != NULL;
	ts_info *info = ts_probe_load(p, TS_B_scene_info, &n);
	s->ambient = info != NULL && n > 0 ? info->ambient : 0.0f;
	free(info);
	if (info == NULL) return TS_ERROR;
	s->vertices = ts_probe_load(p, TS_B_pose_vertex, &p->n_vertices);
	s->triangles = s->vertices != NULL ? ts_probe_load(p, TS_B_scene_triangle, &n_triangles) : NULL;
	s->materials = s->triangles != NULL ? ts_probe_load(p, TS_B_scene_material, &p->n_materials) : NULL;
	s->slots = s->materials != NULL ? ts_probe_load(p, TS_B_scene_slot, &p->n_slots) : NULL;
	s->images = s->slots != NULL ? ts_probe_load(p, TS_B_scene_image, &p->n_images) : NULL;
	s->lights = s->images != NULL ? ts_probe_load(p, p->has_lamps ? TS_B_lamp_light : TS_B_scene_light, &p->n_lights) : NULL;
	s->objects = s->lights != NULL ? ts_probe_load(p, TS_B_scene_object, &p->n_objects) : NULL;
	p->cubes = s->objects != NULL && cubes ? ts_probe_load(p, TS_B_resize_face, &n_cubes) : NULL;
	if (s->objects == NULL || (cubes && p->cubes == NULL)) return TS_ERROR;
	if (n_triangles >= TS_NONE || n_cubes > 65536 || p->n_lights >= TS_NONE)
		return ts_fail("%s: too large", p->trace->dir);
	s->n_triangles = (u32)n_triangles;
	s->n_lights = (u32)p->n_lights;
	p->n_cubes = (u32)n_cubes;
	p->n_words = (p->n_cubes * 6 + 63) / 64;
	return TS_OK;
}

static ts_status load_scene(ts_probe *p)
{
	static const ts_buffer_id needed[] = {TS_B_scene_triangle, TS_B_scene_material, TS_B_scene_slot, TS_B_scene_image,
		TS_B_scene_texel, TS_B_scene_light, TS_B_scene_object, TS_B_scene_info, TS_B_eye_view, TS_B_pose_vertex,
		TS_N_BUFFERS};
	if (ts_probe_require(p, needed) != TS_OK) return TS_ERROR;
	if (ts_probe_fetch(p, TS_B_eye_view, 0, 1, &p->view) != TS_OK || check_view(p) != TS_OK) return TS_ERROR;
	if (load_arrays(p) != TS_OK || (p->has_lamps && ts_probe_lamps(p) != TS_OK)) return TS_ERROR;
	p->n_texels = ts_probe_n(p, TS_B_scene_texel);
	if (check_cubes(p) != TS_OK || ts_probe_shapes(p) != TS_OK || check_images(p) != TS_OK) return TS_ERROR;
	p->image_read = ts_alloc_zero((size_t)p->n_images, 1, "images");
	p->texels = p->image_read != NULL ? ts_alloc_zero((size_t)p->n_texels, sizeof(u64), "scene.texel") : NULL;
	p->scene.texels = p->texels;
	return p->texels != NULL ? TS_OK : TS_ERROR;
}

ts_status ts_probe_scene(ts_probe *p)
{
	if (p->texels != NULL) return TS_OK;
	ts_probe_scene_free(p);
	return load_scene(p);
}

void ts_probe_scene_free(ts_probe *p)
{
	free((void *)p->scene.vertices);
	free((void *)p->scene.triangles);
	free((void *)p->scene.materials);
	free((void *)p->scene.slots);
	free((void *)p->scene.images);
	free((void *)p->scene.lights);
	free((void *)p->scene.objects);
	free(p->cubes);
	free(p->views);
	free(p->lamps);
	free(p->lit);
	free(p->texels);
	free(p->image_read);
	p->scene = (ts_arrays){.vertices = NULL};
	p->cubes = NULL;
	p->views = NULL;
	p->lamps = NULL;
	p->lit = NULL;
	p->texels = NULL;
	p->image_read = NULL;
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

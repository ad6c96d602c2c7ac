/* The sizes of records.def: those of the scene, those that stages counted, and computed ones. */
#include <assert.h>
#include "methods/registry.h"

u64 ts_size_height(const ts_size_question *q) { return TS_PARAM(&q->run->params, height); }

u64 ts_size_width(const ts_size_question *q) { return TS_PARAM(&q->run->params, width); }

bool ts_is_made(const ts_size_question *q, ts_buffer_id id) { return q->run->frame.buffer[id].made; }

static ts_size_answer *answer(ts_dim dim) { return ts_registered()->sizes[dim]; }

/* TS_UNKNOWN: the size is not computed. */
static u64 computed(ts_dim dim, const ts_size_question *q)
{
	u64 n = TS_UNKNOWN;
	if (answer(dim) != NULL) TS_PARAM_READER("size", ts_dim_table[dim].name, n = answer(dim)(q));
	return n;
}

void ts_run_set_size(ts_run *run, ts_dim dim, u64 n)
{
	assert(answer(dim) == NULL);
	run->sizes.n[dim] = n;
}

u64 ts_run_size(const ts_run *run, ts_dim dim)
{
	const ts_size_question q = {run, &run->sizes, run->n_units == run->plan.units};
	u64 n = computed(dim, &q);
	return n != TS_UNKNOWN ? n : run->sizes.n[dim];
}

void ts_sizes_give(ts_sizes *sizes, const ts_run *run)
{
	const ts_size_question q = {run, sizes, true};
	for (u32 dim = 0; dim < TS_N_DIMS; dim++) {
		if (sizes->n[dim] == TS_UNKNOWN) sizes->n[dim] = computed((ts_dim)dim, &q);
	}
}

void ts_sizes_scene(ts_sizes *sizes, const ts_scene *scene)
{
	sizes->n[TS_DIM_vertices] = scene->n_vertices;
	sizes->n[TS_DIM_triangles] = scene->n_triangles;
	sizes->n[TS_DIM_materials] = scene->n_materials;
	sizes->n[TS_DIM_slots] = scene->n_slots;
	sizes->n[TS_DIM_images] = scene->n_images;
	sizes->n[TS_DIM_image_texels] = scene->n_texels;
	sizes->n[TS_DIM_lights] = scene->n_lights;
	sizes->n[TS_DIM_objects] = scene->n_objects;
	sizes->n[TS_DIM_surfels] = scene->n_surfels;
	sizes->n[TS_DIM_stands] = scene->n_stands;
	sizes->n[TS_DIM_path_frames] = scene->n_path;
	sizes->n[TS_DIM_motion_frames] = scene->n_motion;
	sizes->n[TS_DIM_reflectors] = scene->info.n_reflectors;
}

void ts_sizes_cubes(ts_sizes *sizes, u64 n)
{
	sizes->n[TS_DIM_cubes] = n;
	sizes->n[TS_DIM_views] = 6 * n;
}

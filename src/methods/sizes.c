/* The sizes of records.def that are computed: from parameters, other sizes, and what is in the frame. TS_UNKNOWN where
 * that is not there. */
#include "../kernels/raster/mip.h"
#include "../kernels/views/mask.h"
#include "../kernels/points/samples.h"
#include "views/octree.h"
#include <assert.h>

/* `known`: what is known already. whole: of all units, not of the batch. */
typedef struct {
	const ts_run *run;
	const ts_sizes *known;
	bool whole;
} question;

static bool is_made(const question *q, ts_buffer_id id) { return q->run->frame.buffer[id].made; }

static u64 height(const question *q) { return TS_PARAM(&q->run->params, height); }

static u64 width(const question *q) { return TS_PARAM(&q->run->params, width); }

static u64 view_words(const question *q)
{
	u64 views = q->known->n[TS_DIM_views];
	return views != TS_UNKNOWN ? views / 64 + (views % 64 != 0) : TS_UNKNOWN;
}

/* The units that are asked about: cubes, or views. */
static u32 units(const question *q, u32 *first)
{
	ts_buffer_id id = ts_run_has_cubes(q->run) ? TS_B_resize_face : TS_B_offscreen_view;
	*first = q->whole ? 0 : q->run->first_unit;
	return !q->whole ? q->run->n_units : is_made(q, id) ? (u32)ts_frame_n(&q->run->frame, id) : 0;
}

static u64 texels(const question *q)
{
	u32 first, n = units(q, &first);
	bool any = is_made(q, TS_B_resize_face) || is_made(q, TS_B_offscreen_view);
	return any ? ts_run_n_texels(q->run, first, n) : TS_UNKNOWN;
}

static u64 mip_texels(const question *q)
{
	u32 first, n = units(q, &first);
	if (!is_made(q, TS_B_resize_face)) return TS_UNKNOWN;
	if (!ts_run_has_cubes(q->run)) return 0;
	const ts_face *cubes = ts_frame_data(&q->run->frame, TS_B_resize_face);
	return ts_k_mip_first(cubes, first, first + n);
}

static u64 samples(const question *q)
{
	(void)q;
	return TS_N_SAMPLES;
}

static u64 grid(const question *q) { return TS_PARAM(&q->run->params, grid_px); }

static u64 levels(const question *q) { return TS_PARAM(&q->run->params, levels) + 1; }

static u64 mask_words(const question *q) { return ts_k_mask_first(TS_PARAM(&q->run->params, levels) + 1); }

/* The levels of an octree are there, and as many as they should be. */
static bool has_levels(const question *q, ts_buffer_id level)
{
	return is_made(q, level) && ts_frame_n(&q->run->frame, level) == TS_PARAM(&q->run->params, levels) + 2;
}

static u64 leaves_of(const question *q, ts_buffer_id level)
{
	if (!has_levels(q, level)) return TS_UNKNOWN;
	const u32 *first = (const u32 *)ts_frame_data(&q->run->frame, level) + TS_PARAM(&q->run->params, levels);
	return first[1] - first[0];
}

static u64 leaves(const question *q) { return leaves_of(q, TS_B_octree_level); }

static u64 view_leaves(const question *q) { return leaves_of(q, TS_B_view_octree_level); }

static u64 view_side(const question *q) { return ts_view_pyramid(&q->run->params).n; }

static u64 map_texels(const question *q)
{
	ts_pyramid pyramid = ts_view_pyramid(&q->run->params);
	return ts_k_pyramid_texels(&pyramid);
}

static u64 gather_nodes(const question *q)
{
	bool views = has_levels(q, TS_B_view_octree_level) && is_made(q, TS_B_view_octree_node);
	if (!views || !has_levels(q, TS_B_octree_level)) return TS_UNKNOWN;
	const u32 *first = (const u32 *)ts_frame_data(&q->run->frame, TS_B_octree_level) + ts_gather_level(q->run);
	return first[1] - first[0];
}

typedef u64 answer(const question *q);

#define ANSWER_fixed(id) NULL
#define ANSWER_counted(id) NULL
#define ANSWER_given(id) id
#define ANSWER_found(id) id
#define ANSWER_batched(id) id
#define DIM(id, noun, how, bits, doc) [TS_DIM_##id] = ANSWER_##how(id),
static answer *const answers[TS_N_DIMS] = {
#include <touchstone/records.def>
};

void ts_run_set_size(ts_run *run, ts_dim dim, u64 n)
{
	assert(answers[dim] == NULL);
	run->sizes.n[dim] = n;
}

u64 ts_run_size(const ts_run *run, ts_dim dim)
{
	const question q = {run, &run->sizes, run->n_units == run->plan.units};
	u64 n = answers[dim] != NULL ? answers[dim](&q) : TS_UNKNOWN;
	return n != TS_UNKNOWN ? n : run->sizes.n[dim];
}

void ts_sizes_give(ts_sizes *sizes, const ts_run *run)
{
	const question q = {run, sizes, true};
	for (u32 dim = 0; dim < TS_N_DIMS; dim++) {
		if (answers[dim] != NULL && sizes->n[dim] == TS_UNKNOWN) sizes->n[dim] = answers[dim](&q);
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
	sizes->n[TS_DIM_reflectors] = scene->info.n_reflectors;
}

void ts_sizes_cubes(ts_sizes *sizes, u64 n)
{
	sizes->n[TS_DIM_cubes] = n;
	sizes->n[TS_DIM_views] = 6 * n;
}

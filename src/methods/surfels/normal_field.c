/* Linear fields of normals, optional for static surfels: the nearest surfels of each, by their centres, and what is
 * fitted to them. */
#include <stdlib.h>
#include "kernels/surfels/normal_field.h"
#include "methods/surfels/surfel.h"
#include "scene/neighbours.h"

/* Equal distances go by index. */
static void list_near(u32 *near, const ts_neighbours *tree, u32 i)
{
	ts_neighbour found[TS_FIELD_NEIGHBOURS];
	u32 n = ts_neighbours_find(tree, i, TS_FIELD_NEIGHBOURS, found);
	for (u32 k = 0; k < TS_FIELD_NEIGHBOURS; k++) near[k] = k < n ? found[k].index : TS_NONE;
}

static ts_status find_near(ts_run *run, ts_v3 *centres, u32 n)
{
	const ts_surfel *surfels = ts_frame_data(&run->frame, TS_B_scene_surfel);
	u32 *near = ts_run_make(run, TS_B_surfel_near_surfel);
	if (near == NULL) return TS_ERROR;
	for (u32 i = 0; i < n; i++) centres[i] = ts_load3(surfels[i].centre);
	ts_neighbours *tree = ts_neighbours_new(centres, n);
	if (tree == NULL) return TS_ERROR;
#pragma omp parallel for num_threads((int)run->c.threads) schedule(dynamic, 1024)
	for (i64 i = 0; i < (i64)n; i++) list_near(near + i * TS_FIELD_NEIGHBOURS, tree, (u32)i);
	ts_neighbours_free(tree);
	return TS_OK;
}

static ts_status surfel_near(ts_run *run)
{
	u64 n = ts_run_size(run, TS_DIM_surfels);
	if (n > INT32_MAX) return ts_run_too_many(n, "surfels");
	ts_v3 *centres = ts_alloc((size_t)n, sizeof *centres, "centres of surfels");
	if (centres == NULL) return TS_ERROR;
	ts_status status = find_near(run, centres, (u32)n);
	free(centres);
	return status;
}

const ts_stage ts_stage_surfel_near = {
	.name = "surfel_near",
	.kind = "map",
	.paper = "NV40: Phong Shading for PBR",
	.doc = "the nearest surfels of each surfel, by their centres",
	.run = surfel_near,
	.looks_at = TS_BUFFERS(TS_B_scene_surfel),
	.makes = TS_BUFFERS(TS_B_surfel_near_surfel),
};

static const ts_launch launch = TS_LAUNCH(normal_field, TS_ALL);

static ts_status normal_field(ts_run *run)
{
	ts_normal_field_args args;
	return TS_RUN(run, &launch, &args, ts_run_size(run, TS_DIM_surfels));
}

const ts_stage ts_stage_normal_field = {
	.name = "normal_field",
	.kind = "map",
	.paper = "NV40: Phong Shading for PBR",
	.doc = "a linear field of normals for each surfel, fitted to its nearest surfels",
	.run = normal_field,
	.launches = TS_LAUNCHES(&launch),
};

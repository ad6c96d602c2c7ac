/* Expected sizes of octrees, maps and lists of many views, from the area of the scene's surfaces. The shares were
 * measured on the built-in scenes and two models at all levels; scripts/memory compares estimates with actual runs. */
#include <math.h>
#include "kernels/base/vec.h"
#include "methods/views/pipelines.h"
#include "methods/views/traverse.h"
#include "methods/views/views.h"

#define FILLED 0.25    /* of all voxels at most, as surfaces stand close to each other */
#define TRIANGLES 2    /* per leaf, besides one leaf per triangle */
#define PAIRS 5        /* per node of views and texel of its map that the traversal decides */
#define PAIRS_ALONE 20 /* the same for a view without a hierarchy */
#define REACH 4.0      /* area of surfaces within a distance, divided by its square: more than a disc's */
#define PAIRS_A_VIEW 1024
#define NODE_BYTES 26 /* per node of the scene, where the C backend maps pairs at once, without queues */
#define VIEW_BYTES 50 /* per node of views */

static double least(double a, double b) { return a < b ? a : b; }

typedef struct {
	double area, side;
} surfaces; /* world units; side of the root cube */

static surfaces measure(const ts_scene *scene)
{
	surfaces r = {0, 0};
	ts_v3 low = ts_v3_make(INFINITY, INFINITY, INFINITY), high = ts_neg(low);
	for (u32 t = 0; t < scene->n_triangles; t++) {
		ts_v3 p[3];
		for (u32 k = 0; k < 3; k++) {
			p[k] = ts_load3(scene->vertices[scene->triangles[t].vertex[k]].position);
			low = ts_min3(low, p[k]);
			high = ts_max3(high, p[k]);
		}
		r.area += (double)ts_length(ts_cross(ts_sub(p[1], p[0]), ts_sub(p[2], p[0]))) / 2;
	}
	ts_v3 extent = ts_sub(high, low);
	if (scene->n_triangles > 0) r.side = (double)ts_max(extent.x, ts_max(extent.y, extent.z));
	return r;
}

/* How many of n voxels contain things at random places: nearly the number of things if few, nearly all if many. */
static double occupied(double things, double n) { return things > 0 ? things * n / (things + n) : 0; }

/* An area in squares as wide as the voxels of a level. */
static double squares(const surfaces *s, double area, u32 level)
{
	return s->side > 0 ? area / (s->side * s->side) * (double)(1ull << 2 * level) : 0;
}

/* Nodes of a level of the scene's octree: a surface is in about one voxel per square. */
static double nodes_at(const surfaces *s, u32 level)
{
	return occupied(squares(s, s->area, level), FILLED * (double)(1ull << 3 * level)) + 1;
}

/* Nodes of a level of the views' octree: some nodes of the surfaces that the lights are on. */
static double views_at(const surfaces *s, const ts_expected_lights *lights, u32 level)
{
	return occupied((double)lights->n_places, least(squares(s, lights->area, level) + 1, nodes_at(s, level)));
}

/* Share of the pairs of two levels that culling leaves to gathering. The lights see everything, or half of a hall whose
 * surfaces they are on, so all pairs within the cut-off stay. */
static double share_in_reach(const surfaces *s, const ts_params *params, u32 level)
{
	double distance = (double)TS_PARAM(params, vpl_gather_cutoff) + 2 * s->side / (double)(1u << level);
	return TS_PARAM(params, vpl_gather_cutoff) > 0 && s->area > 0 ? least(REACH * distance * distance / s->area, 1) : 1;
}

/* Memory of queues for this many pairs: half of them in the last step, and each step has half the pairs of the next.
 * All of their memory where that exceeds a run's limit, so that the run is refused. */
static u64 queue_bytes(double pairs, const ts_params *params)
{
	u64 bytes = 0, room = ts_traverse_room(params), all = (u64)TS_PARAM(params, traverse_queue_mb) << 20;
	if (all > ts_memory_limit()) return all;
	for (u64 step = (u64)(pairs / 2); step > 0; step /= 2) {
		bytes += (step < room ? step : room) * sizeof(u64);
	}
	return bytes;
}

/* Pairs that the traversal for maps decides; without a hierarchy of the scene those of each of its leaves. */
static double mapped_pairs(const ts_expected_lights *lights, const ts_params *params, double nodes, double view_nodes)
{
	if (TS_PARAM(params, traverse_hierarchies) == TS_HIERARCHIES_VIEWS) return view_nodes * nodes;
	double texels = 2.0 * lights->px * lights->px, each = PAIRS_ALONE * texels;
	return lights->alone ? (double)lights->n * least(each, nodes) : PAIRS * texels * view_nodes;
}

void ts_expect_views(ts_expected *expected, const ts_scene *scene, const ts_params *params,
                     const ts_expected_lights *lights)
{
	const surfaces s = measure(scene);
	u32 levels = TS_PARAM(params, octree_levels);
	double nodes = 0, view_nodes = 0;
	for (u32 l = 0; l <= levels; l++) {
		nodes += nodes_at(&s, l);
		view_nodes += views_at(&s, lights, l);
	}
	bool shared = TS_PARAM(params, traverse_hierarchies) == TS_HIERARCHIES_BOTH;
	u64 *n = expected->sizes.n, leaves = (u64)nodes_at(&s, levels);
	n[TS_DIM_nodes] = (u64)nodes;
	n[TS_DIM_leaves] = leaves;
	n[TS_DIM_leaf_triangles] = scene->n_triangles + TRIANGLES * leaves;
	n[TS_DIM_vpls] = lights->n;
	n[TS_DIM_view_nodes] = lights->alone ? lights->n : (u64)view_nodes + 1;
	n[TS_DIM_view_leaves] = lights->alone ? lights->n : (u64)views_at(&s, lights, levels) + 1;
	n[TS_DIM_rendered_pairs] = shared ? lights->n * PAIRS_A_VIEW : n[TS_DIM_view_leaves] * leaves;
	u64 at_once = n[TS_DIM_nodes] * NODE_BYTES + n[TS_DIM_view_nodes] * VIEW_BYTES;
	expected->work = queue_bytes(mapped_pairs(lights, params, nodes, view_nodes), params);
	if (at_once > expected->work) expected->work = at_once;
}

void ts_expect_gather(ts_expected *expected, const ts_scene *scene, const ts_params *params,
                      const ts_expected_lights *lights)
{
	const surfaces s = measure(scene);
	u32 level = ts_gather_level_of(params, TS_PARAM(params, view_map_field), lights->alone);
	double lists = nodes_at(&s, level), views = lights->alone ? (double)lights->n : views_at(&s, lights, level);
	double pairs = lists * views * share_in_reach(&s, params, level);
	u64 work = queue_bytes(2 * pairs, params);
	expected->sizes.n[TS_DIM_gather_nodes] = (u64)lists;
	expected->sizes.n[TS_DIM_gather_pairs] = (u64)pairs;
	if (work > expected->work) expected->work = work;
}

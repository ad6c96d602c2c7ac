/* Why maps of many views differ from rays (METHODS 17). */
#include "kernels/views/octree.h"
#include "kernels/views/vpl_gather.h"
#include "methods/views/tools/tools.h"
#include "truth/truth.h"

const char *const ts_wrong_names[] = {
#define WRONG(id, counter, head) counter,
#include "methods/views/tools/truth_wrong.def"
#undef WRONG
	NULL,
};

typedef struct {
	const ts_truth *truth;
	const ts_vpl_gather_args *of;
	u32 view, texel;
	ts_v3 p, n, light, way; /* from the light to the place */
	f32 reach, apart;
} answer;

/* The first hit that stops light; TS_NONE: none. */
static ts_truth_hit cast(const answer *a, bool whole)
{
	ts_truth_query ray = {.origin = a->light,
	                      .direction = ts_normalize(a->way),
	                      .near = a->reach,
	                      .masked = TS_NONE,
	                      .from = a->light,
	                      .whole = whole};
	return ts_truth_cast(a->truth, &ray);
}

/* Whether a place would be dark if a map showed the hit. */
static bool stops(const answer *a, const ts_truth_hit *hit)
{
	return hit->triangle != TS_NONE && ts_length(a->way) > hit->t + ts_k_vpl_slack(a->of, a->way, a->n);
}

/* Whether maps leave out the leaf that holds the place at distance t from the light. */
static bool is_left_out(const answer *a, f32 t)
{
	u32 levels = a->of->levels;
	ts_v3 q = ts_mad(a->light, ts_normalize(a->way), t);
	ts_node leaf;
	ts_k_octree_ball(&leaf, a->of->root, levels, ts_k_morton(ts_k_voxel_of(a->of->root, levels, q)));
	ts_v3 view = ts_load3(a->of->nodes[a->of->leaves[a->view]].centre);
	return ts_length(ts_sub(ts_load3(leaf.centre), view)) < a->apart * leaf.radius;
}

static ts_wrong why_lit(const answer *a, u64 shown)
{
	ts_truth_hit hit = cast(a, false);
	if (!stops(a, &hit)) return TS_WRONG_slack;
	bool spared =
		(u32)shown != TS_NONE && ts_length(a->way) > ts_k_vpl_reach(a->of, a->view, shown, a->texel, a->p, a->n);
	if (spared) return TS_WRONG_plane;
	if (is_left_out(a, hit.t)) return TS_WRONG_near;
	return (u32)shown == TS_NONE ? TS_WRONG_empty : TS_WRONG_leak;
}

static bool is_at_light(const answer *a, const ts_node *node)
{
	ts_v3 normal = ts_load3(a->of->lights[a->view].normal);
	if (ts_length(ts_sub(ts_load3(node->centre), a->light)) <= a->apart * node->radius) return true;
	bool has_plane = ts_dot(normal, normal) > 0.0f;
	return has_plane && ts_k_node_height(node, a->light, normal) <= ts_k_vpl_clear(a->of, node);
}

static bool is_on_way(const answer *a, const ts_node *node)
{
	ts_v3 to = ts_sub(ts_load3(node->centre), a->light);
	return ts_length(ts_cross(to, ts_normalize(a->way))) <= node->radius;
}

static ts_wrong why_dark(const answer *a, u32 shown)
{
	const ts_node *node = &a->of->scene[shown];
	ts_truth_hit hit = cast(a, false), whole = cast(a, true);
	if (stops(a, &whole) && !stops(a, &hit)) return TS_WRONG_cut;
	if (ts_length(ts_sub(ts_load3(node->centre), a->p)) <= a->apart * node->radius) return TS_WRONG_place;
	if (is_at_light(a, node)) return TS_WRONG_light;
	return is_on_way(a, node) ? TS_WRONG_way : TS_WRONG_texel;
}

ts_wrong ts_truth_wrong(const ts_truth *truth, const ts_vpl_gather_args *of, u32 view, ts_v3 p, ts_v3 n, f32 reach,
                        f32 apart, bool lit)
{
	ts_v3 light = ts_load3(of->lights[view].position), way = ts_sub(p, light);
	const answer a = {truth, of, view, ts_k_paraboloid_texel(way, of->n), p, n, light, way, reach, apart};
	u64 shown = ts_k_vpl_shown(of, view, a.texel);
	return lit ? why_lit(&a, shown) : why_dark(&a, (u32)shown);
}

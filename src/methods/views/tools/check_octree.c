/* Octrees: links that kernels follow from node to node, and places where lists are written.
 *
 * voxel.mask, voxel.before and those of the views equal the outputs of stages voxel and view_voxel for the same
 * triangles and views, for lists are written at their bits. octree.level and view_octree.level begin at 0, never fall
 * and end at the number of nodes. A node has the level that they give it, its parent before it, and, except for leaves,
 * children after it that refer to it. Every leaf of the views has some views, and those refer to it; view_octree.cone
 * refers to existing views. In lists of views that pixels draw from the drawn numbers are indices; views from the
 * middles of cubes have one map per cube. */
#include <inttypes.h>
#include "kernels/views/mask.h"
#include "methods/views/octree.h"
#include "methods/views/tools/tools.h"

/* One map per cube. */
static ts_status check_colours(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)stage;
	u64 n_cubes, n_views = load->sizes.n[TS_DIM_vpls];
	if (ts_check_elements(load, TS_B_cube_size_face, &n_cubes) == NULL || n_views == n_cubes) return TS_OK;
	return ts_refuse("%s: maps of %" PRIu64 " views; %" PRIu64 ", one a cube, would be right", load->item[id]->path,
	                 n_views, n_cubes);
}

/* The sums up to each node of a list add up its cones' views. */
static ts_status check_list(const ts_load *load, u32 from, u32 to)
{
	const u32 *node = ts_frame_data(&load->run.frame, TS_B_vpl_gather_pair_node);
	const u32 *views = ts_frame_data(&load->run.frame, TS_B_vpl_gather_pair_views);
	const ts_cone *cones = ts_frame_data(&load->run.frame, TS_B_view_octree_cone);
	u32 sum = 0;
	for (u32 k = from; k < to; k++) {
		sum += cones[node[k]].views;
		if (views[k] != sum)
			return ts_check_refuse(load, TS_B_vpl_gather_pair_views, k, "", 0, "%" PRIu32 ", the sum,", sum);
	}
	return TS_OK;
}

/* Levels of voxel.before begin where octree.level has them: a voxel's id is its node. */
static ts_status check_voxels(const ts_load *load)
{
	const u32 *before = ts_frame_data(&load->run.frame, TS_B_voxel_before);
	const u32 *level = ts_frame_data(&load->run.frame, TS_B_octree_level);
	for (u32 l = 0; l <= TS_PARAM(&load->run.params, octree_levels) + 1; l++) {
		u32 first = before[ts_k_mask_first(l)];
		if (level[l] == first) continue;
		return ts_check_refuse(load, TS_B_octree_level, l, "", 0, "%" PRIu32 ", as voxel.before,", first);
	}
	return TS_OK;
}

/* Lists of views that pixels draw from; cones must have been checked. */
static ts_status check_gather(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	if (!ts_stage_reads(stage, id)) return TS_OK;
	const u32 *offset = ts_frame_data(&load->run.frame, TS_B_vpl_gather_pair_offset);
	u64 n_lists = ts_frame_n(&load->run.frame, TS_B_vpl_gather_pair_offset) - 1;
	for (u64 i = 0; i < n_lists; i++) {
		if (check_list(load, offset[i], offset[i + 1]) != TS_OK) return TS_ERROR;
	}
	return check_voxels(load);
}

/* The octree that these masks, ids, levels or nodes belong to. */
static const ts_octree *octree_of(ts_buffer_id id)
{
	const ts_octree *scene = &ts_scene_octree;
	bool is_scene = id == scene->mask || id == scene->before || id == scene->level || id == scene->node;
	return is_scene ? scene : &ts_view_octree;
}

static ts_status check_levels(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)stage;
	const ts_octree *octree = octree_of(id);
	ts_dim of = ts_buffer_counts(octree->node);
	u64 n = ts_frame_n(&load->run.frame, id), n_nodes = load->sizes.n[of];
	const u32 *level = ts_frame_data(&load->run.frame, id);
	if (level[0] != 0) return ts_check_refuse(load, id, 0, "", 0, "0, where levels begin,");
	for (u64 i = 1; i < n; i++) {
		if (level[i] >= level[i - 1]) continue;
		return ts_check_refuse(load, id, i, "", 0, "at least %" PRIu32 ", as before,", level[i - 1]);
	}
	if (n_nodes == TS_UNKNOWN || level[n - 1] == n_nodes) return TS_OK;
	return ts_check_refuse(load, id, n - 1, "", 0, "%" PRIu64 " (%s), all nodes,", n_nodes, ts_dim_table[of].name);
}

/* A node's children have it as their parent, and are of the next level. */
static bool is_parent(const ts_node *nodes, u64 i, u64 n)
{
	u64 n_children = ts_k_count_bits(nodes[i].children), child = nodes[i].child;
	if (child <= i || child + n_children > n) return false;
	for (u64 c = child; c < child + n_children; c++) {
		if (nodes[c].parent != i || nodes[c].level != nodes[i].level + 1) return false;
	}
	return true;
}

/* Every walk ends, and every node has a leaf below it. */
static ts_status check_links(const ts_load *load, ts_buffer_id id, u64 i, u64 n)
{
	const ts_node *nodes = ts_frame_data(&load->run.frame, id), *node = &nodes[i];
	bool leaf = node->level == TS_PARAM(&load->run.params, octree_levels), root = i == 0;
	if (node->children > 255 || (node->children == 0) != leaf) {
		return ts_check_refuse(load, id, i, "children", 0, leaf ? "0, of a leaf," : "1 to 255");
	}
	if (leaf ? node->child != TS_NONE : !is_parent(nodes, i, n)) {
		const char *right = leaf ? "4294967295, of a leaf," : "the first of nodes whose parent it is";
		return ts_check_refuse(load, id, i, "child", 0, "%s", right);
	}
	if (root ? node->parent == TS_NONE : node->parent < i) return TS_OK;
	return ts_check_refuse(load, id, i, "parent", 0, root ? "4294967295, of the root," : "a node before it");
}

static ts_status check_tree(const ts_load *load, const ts_octree *octree, u64 n)
{
	const ts_node *nodes = ts_frame_data(&load->run.frame, octree->node);
	u64 n_levels;
	const u32 *level = ts_check_elements(load, octree->level, &n_levels);
	for (u64 i = 0; i < n; i++) {
		u32 l = nodes[i].level;
		if (level != NULL && (i < level[l] || i >= level[l + 1])) {
			return ts_check_refuse(load, octree->node, i, "level", 0, "that of its place in %s",
			                       ts_buffer_table[octree->level].name);
		}
		if (check_links(load, octree->node, i, n) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

/* Views without a hierarchy are roots and leaves. */
static ts_status check_alone(const ts_load *load, ts_buffer_id id, u64 n)
{
	const ts_node *nodes = ts_frame_data(&load->run.frame, id);
	for (u64 i = 0; i < n; i++) {
		if (nodes[i].children != 0) return ts_check_refuse(load, id, i, "children", 0, "0, of a leaf,");
		if (nodes[i].parent != TS_NONE) return ts_check_refuse(load, id, i, "parent", 0, "4294967295, of a root,");
		if (nodes[i].level != 0) return ts_check_refuse(load, id, i, "level", 0, "0, of a root,");
	}
	return TS_OK;
}

static ts_status check_nodes(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)stage;
	const ts_octree *octree = octree_of(id);
	u64 n = ts_frame_n(&load->run.frame, id);
	bool alone = ts_pipeline_maker(load->pipeline, octree->offset) == NULL;
	return alone ? check_alone(load, id, n) : check_tree(load, octree, n);
}

/* Lists are written at the bits of masks. */
static ts_status check_masks(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	bool views = octree_of(id) == &ts_view_octree;
	if (!ts_stage_writes(stage, octree_of(id)->entries)) return TS_OK;
	return ts_check_again(load, views ? "view_octree.voxel" : "voxel",
	                      views ? "vpl.light and octree.root" : "pose.vertex and octree.root");
}

/* The id of a node is the number of set bits before it in the mask. */
static ts_status check_ids(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)stage;
	u64 n, n_words;
	const u32 *before = ts_check_elements(load, id, &n);
	const u64 *mask = ts_check_elements(load, octree_of(id)->mask, &n_words);
	u32 sum = 0;
	for (u64 i = 0; i < n && mask != NULL; i++) {
		if (before[i] != sum) return ts_check_refuse(load, id, i, "", 0, "%" PRIu32 ", the bits before it,", sum);
		if (i < n_words) sum += ts_k_count_bits(mask[i]);
	}
	return TS_OK;
}

/* Every leaf has views, which refer to it. */
static ts_status check_leaves(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)stage;
	const u32 *offset = ts_frame_data(&load->run.frame, id);
	const u32 *view = ts_frame_data(&load->run.frame, TS_B_view_octree_view);
	u64 n_views;
	const u32 *leaf = ts_check_elements(load, TS_B_view_octree_leaf, &n_views);
	if (leaf == NULL) return TS_OK;
	u32 first = ts_octree_first(&load->run, &ts_view_octree, TS_PARAM(&load->run.params, octree_levels));
	for (u64 i = 0, n = ts_frame_n(&load->run.frame, id) - 1; i < n; i++) {
		if (offset[i + 1] == offset[i]) {
			return ts_check_refuse(load, id, i + 1, "", 0, "more than the sum before it");
		}
		for (u32 k = offset[i]; k < offset[i + 1]; k++) {
			if (leaf[view[k]] == first + i) continue;
			return ts_check_refuse(load, TS_B_view_octree_view, k, "", 0, "a view whose leaf is node %" PRIu64,
			                       first + i);
		}
	}
	return TS_OK;
}

static ts_status check_cones(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)stage;
	u64 n_views = load->sizes.n[TS_DIM_vpls];
	const ts_cone *cones = ts_frame_data(&load->run.frame, id);
	if (n_views == TS_UNKNOWN) return TS_OK;
	for (u64 i = 0, n = ts_frame_n(&load->run.frame, id); i < n; i++) {
		u64 left = n_views - cones[i].first;
		if (cones[i].views >= 1 && cones[i].views <= left) continue;
		return ts_check_refuse(load, id, i, "views", 0, "1 to %" PRIu64, left);
	}
	return TS_OK;
}

/* The low halves are indices. */
static ts_status check_rendered(const ts_load *load, const ts_stage *stage, ts_buffer_id id)
{
	(void)stage;
	u64 n, n_nodes = load->sizes.n[TS_DIM_nodes];
	const u64 *pairs = ts_check_elements(load, id, &n);
	for (u64 i = 0; i < n; i++) {
		if (pairs[i] >> 32 < n_nodes) continue;
		return ts_check_refuse(load, id, i, "", 0, "less than %" PRIu64 " (nodes) in the high half", n_nodes);
	}
	return TS_OK;
}

const ts_check_rule ts_views_checks[] = {
	{TS_B_traverse_rendered, TS_CHECK_VALUES, check_rendered},
	{TS_B_octree_level, TS_CHECK_VALUES, check_levels},
	{TS_B_octree_node, TS_CHECK_VALUES, check_nodes},
	{TS_B_voxel_mask, TS_CHECK_VALUES, check_masks},
	{TS_B_voxel_before, TS_CHECK_SUMS, check_ids},
	{TS_B_view_octree_level, TS_CHECK_VALUES, check_levels},
	{TS_B_view_octree_node, TS_CHECK_VALUES, check_nodes},
	{TS_B_view_octree_voxel_mask, TS_CHECK_VALUES, check_masks},
	{TS_B_view_octree_voxel_before, TS_CHECK_SUMS, check_ids},
	{TS_B_view_octree_offset, TS_CHECK_VALUES, check_leaves},
	{TS_B_view_octree_cone, TS_CHECK_VALUES, check_cones},
	{TS_B_view_map_colour, TS_CHECK_VALUES, check_colours},
	{TS_B_vpl_gather_pair_views, TS_CHECK_VALUES, check_gather},
	{.check = NULL},
};

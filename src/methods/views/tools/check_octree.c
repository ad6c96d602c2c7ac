/* Octrees: what their kernels follow from node to node, and where lists are written. */
#include <inttypes.h>
#include "../octree.h"
#include "../../../replay/check.h"

static bool is_loaded(const ts_load *load, ts_buffer_id id) { return load->item[id] != NULL; }

static ts_status compare(const ts_load *load, const ts_frame *right, ts_buffer_id id, const char *maker, const char *from)
{
	size_t bytes = ts_buffer_table[id].element_bytes;
	const u8 *a = ts_frame_data(&load->run.frame, id), *b = ts_frame_data(right, id);
	for (u64 i = 0, n = ts_frame_n(right, id); i < n; i++) {
		if (memcmp(a + i * bytes, b + i * bytes, bytes) == 0) continue;
		u64 value = 0;
		memcpy(&value, b + i * bytes, bytes);
		return ts_check_refuse(load, id, i, "", 0, "%" PRIu64 ", which stage %s makes of the same %s,", value, maker, from);
	}
	return TS_OK;
}

ts_status ts_check_again(const ts_load *load, const char *maker, const char *from)
{
	const ts_stage *stage = ts_stage_find(maker);
	ts_run again = load->run;
	again.hook = NULL;
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		again.frame.buffer[*id] = (ts_buffer){.made = false};
	}
	ts_status status = ts_run_stage(&again, stage);
	for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
		if (status == TS_OK && is_loaded(load, *id)) status = compare(load, &again.frame, *id, maker, from);
		ts_frame_drop(&again.frame, *id);
	}
	return status;
}

static ts_status check_levels(const ts_load *load, const ts_octree *octree)
{
	ts_dim of = ts_buffer_counts(octree->node);
	u64 n = ts_frame_n(&load->run.frame, octree->level), n_nodes = load->sizes.n[of];
	const u32 *level = ts_frame_data(&load->run.frame, octree->level);
	if (level[0] != 0) return ts_check_refuse(load, octree->level, 0, "", 0, "0, where levels begin,");
	for (u64 i = 1; i < n; i++) {
		if (level[i] >= level[i - 1]) continue;
		return ts_check_refuse(load, octree->level, i, "", 0, "at least %" PRIu32 ", as before,", level[i - 1]);
	}
	if (n_nodes == TS_UNKNOWN || level[n - 1] == n_nodes) return TS_OK;
	return ts_check_refuse(load, octree->level, n - 1, "", 0, "%" PRIu64 " (%s), all nodes,", n_nodes,
	                       ts_dim_table[of].name);
}

/* The children name a node as their parent, and are of the next level. */
static bool is_parent(const ts_node *nodes, u64 i, u64 n)
{
	u64 n_children = ts_k_count_bits(nodes[i].children), child = nodes[i].child;
	if (child <= i || child + n_children > n) return false;
	for (u64 c = child; c < child + n_children; c++) {
		if (nodes[c].parent != i || nodes[c].level != nodes[i].level + 1) return false;
	}
	return true;
}

/* So that no walk is endless, and every node has a leaf below it. */
static ts_status check_links(const ts_load *load, ts_buffer_id id, u64 i, u64 n)
{
	const ts_node *nodes = ts_frame_data(&load->run.frame, id), *node = &nodes[i];
	bool leaf = node->level == TS_PARAM(&load->run.params, levels), root = i == 0;
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

static ts_status check_nodes(const ts_load *load, const ts_octree *octree)
{
	u64 n = ts_frame_n(&load->run.frame, octree->node);
	const ts_node *nodes = ts_frame_data(&load->run.frame, octree->node);
	const u32 *level = is_loaded(load, octree->level) ? ts_frame_data(&load->run.frame, octree->level) : NULL;
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
static ts_status check_alone(const ts_load *load)
{
	const ts_buffer_id id = TS_B_view_octree_node;
	const ts_node *nodes = ts_frame_data(&load->run.frame, id);
	for (u64 i = 0, n = ts_frame_n(&load->run.frame, id); i < n; i++) {
		if (nodes[i].children != 0) return ts_check_refuse(load, id, i, "children", 0, "0, of a leaf,");
		if (nodes[i].parent != TS_NONE) return ts_check_refuse(load, id, i, "parent", 0, "4294967295, of a root,");
		if (nodes[i].level != 0) return ts_check_refuse(load, id, i, "level", 0, "0, of a root,");
	}
	return TS_OK;
}

/* Every leaf has views, and those say so. */
static ts_status check_leaves(const ts_load *load)
{
	const u32 *offset = ts_frame_data(&load->run.frame, TS_B_view_octree_offset);
	const u32 *view = ts_frame_data(&load->run.frame, TS_B_view_octree_view);
	const u32 *leaf = ts_frame_data(&load->run.frame, TS_B_view_octree_leaf);
	u32 first = ts_octree_first(&load->run, &ts_view_octree, TS_PARAM(&load->run.params, levels));
	for (u64 i = 0, n = ts_frame_n(&load->run.frame, TS_B_view_octree_offset) - 1; i < n; i++) {
		if (offset[i + 1] == offset[i]) {
			return ts_check_refuse(load, TS_B_view_octree_offset, i + 1, "", 0, "more than the sum before it");
		}
		for (u32 k = offset[i]; k < offset[i + 1]; k++) {
			if (leaf[view[k]] == first + i) continue;
			return ts_check_refuse(load, TS_B_view_octree_view, k, "", 0, "a view whose leaf is node %" PRIu64, first + i);
		}
	}
	return TS_OK;
}

static ts_status check_cones(const ts_load *load)
{
	const ts_buffer_id id = TS_B_view_cone_node;
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

ts_status ts_check_octrees(const ts_load *load, const ts_stage *stage)
{
	const ts_octree *octrees[] = {&ts_scene_octree, &ts_view_octree};
	for (u32 k = 0; k < 2; k++) {
		const ts_octree *octree = octrees[k];
		if (is_loaded(load, octree->level) && check_levels(load, octree) != TS_OK) return TS_ERROR;
		bool alone = ts_pipeline_maker(load->pipeline, octree->offset) == NULL;
		ts_status status = !is_loaded(load, octree->node) ? TS_OK : alone ? check_alone(load) : check_nodes(load, octree);
		if (status != TS_OK) return status;
		const char *from = k == 0 ? "pose.vertex and root.cube" : "vpl.light and root.cube";
		bool lists = !alone && ts_stage_writes(stage, octree->entries);
		if (lists && ts_check_again(load, k == 0 ? "voxel" : "view_voxel", from) != TS_OK) return TS_ERROR;
	}
	if (is_loaded(load, TS_B_view_octree_offset) && is_loaded(load, TS_B_view_octree_leaf) &&
	    check_leaves(load) != TS_OK) return TS_ERROR;
	return is_loaded(load, TS_B_view_cone_node) ? check_cones(load) : TS_OK;
}

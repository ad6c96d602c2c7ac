/* A texel of the whole map of a node of views: the results of the nodes above it there, and the pair that was
 * rendered. */
#include <stdlib.h>
#include "kernels/views/view_map_margin.h"
#include "methods/stages.h"
#include "methods/views/tools/probe.h"
#include "methods/views/traverse.h"

ts_status ts_probe_read_chain(ts_probe *p, ts_probe_chain *c, u32 node)
{
	const ts_node *nodes = ts_probe_loaded(p, TS_B_view_octree_node);
	ts_pyramid pyramid = ts_view_pyramid(&p->load->run.params, &p->load->run.plan);
	u32 n_texels = ts_k_pyramid_texels(&pyramid);
	*c = (ts_probe_chain){.n = nodes[node].level + 1};
	c->texels = ts_alloc((size_t)c->n * n_texels, sizeof *c->texels, "maps");
	if (c->texels == NULL) return TS_ERROR;
	for (u32 i = 0; i < c->n; i++) {
		c->id[i] = ts_k_ancestor(nodes, node, i);
		c->nodes[i] = nodes[c->id[i]];
		c->nodes[i].parent = i > 0 ? i - 1 : TS_NONE;
		u64 *to = c->texels + (size_t)i * n_texels;
		if (ts_probe_fetch(p, TS_B_view_map_depth_node, (u64)c->id[i] * n_texels, n_texels, to) != TS_OK)
			return TS_ERROR;
	}
	c->args = (ts_view_map_fuse_args){.views = c->nodes,
	                                  .texels = c->texels,
	                                  .pyramid = pyramid,
	                                  .nearest = TS_PARAM(&p->load->run.params, view_map_fusion) == TS_FUSION_MIN};
	return TS_OK;
}

u64 ts_probe_own_key(const ts_probe_chain *c, u32 i, u32 texel)
{
	u32 n_texels = ts_k_pyramid_texels(&c->args.pyramid);
	return ts_k_map_key(c->texels + (size_t)i * n_texels, &c->args.pyramid, texel);
}

/* The last node's result; *from: the node whose own it is. */
static u64 shown(const ts_probe_chain *c, u32 texel, u32 *from)
{
	u64 key = TS_EMPTY;
	for (u32 i = 0; i < c->n; i++) {
		key = ts_k_fused(&c->args, i, key, texel);
		if (key != TS_EMPTY && key == ts_probe_own_key(c, i, texel)) *from = i;
	}
	return key;
}

void ts_probe_put_decision(ts_probe *p, json_t *o, const ts_traverse_args *how, u64 pair)
{
	u32 node = ts_k_pair_node(pair), views = ts_k_pair_views(pair), fate = ts_k_pair_fate(how, pair);
	ts_ball s = ts_k_pair_ball(how, &how->nodes[node]), v = ts_k_pair_ball(how, &how->views[views]);
	ts_cone_k cone = ts_k_load_cone(&how->cones[views]);
	bool leaves = fate == TS_PAIR_RENDER && !ts_k_pair_is_equivalent(&s, &v, how->n);
	ts_probe_put(p, o, "node", ts_probe_int(node));
	ts_probe_put(p, o, "level", ts_probe_int(how->nodes[node].level));
	ts_probe_put(p, o, "centre", ts_probe_v3(s.p));
	ts_probe_put(p, o, "radius", ts_probe_real(s.r));
	ts_probe_put(p, o, "views", ts_probe_int(views));
	ts_probe_put(p, o, "level_of_views", ts_probe_int(how->views[views].level));
	ts_probe_put(p, o, "radius_of_views", ts_probe_real(v.r));
	ts_probe_put(p, o, "distance", ts_probe_bits(ts_put(ts_length(ts_sub(s.p, v.p)))));
	ts_probe_put(p, o, "outside_the_cone", ts_probe_real(ts_k_pair_outside(&s, &v, &cone, &how->phi)));
	ts_probe_put(p, o, "culled_beyond", ts_probe_real(ts_k_pair_reach(&s, &v)));
	ts_probe_put(p, o, "texels_wide", ts_probe_real(ts_k_pair_size(&s, &v, how->n)));
	if (s.leaf && v.leaf) ts_probe_put(p, o, "near_within", ts_probe_real(how->apart * s.r));
	ts_probe_put(p, o, "margin", ts_probe_real(ts_k_fate_margin(how, pair, fate)));
	ts_probe_put(p, o, "why",
	             json_string(leaves                   ? "both are leaves"
	                         : fate == TS_PAIR_RENDER ? "all of the views show it in one texel"
	                                                  : "it should not have been rendered"));
}

static ts_status put_rendered(ts_probe *p, json_t *o, u64 pair, u32 held)
{
	ts_traverse_args how;
	if (ts_traverse_arguments(&p->load->run, &how) != TS_OK) return TS_ERROR;
	ts_v3 s = ts_load3(how.nodes[ts_k_pair_node(pair)].centre), v = ts_load3(how.views[ts_k_pair_views(pair)].centre);
	f32 d = ts_put(ts_length(ts_sub(s, v))), map = ts_u2f(held);
	ts_probe_put_decision(p, o, &how, pair);
	ts_probe_put_check(p, o, TS_B_view_map_depth_node, &d, &map, 1);
	return TS_OK;
}

ts_status ts_probe_put_pair(ts_probe *p, json_t *object, u32 node, u32 texel)
{
	static const ts_buffer_id needed[] = {TS_B_view_map_depth_node, TS_N_BUFFERS};
	ts_probe_chain c = {.n = 0};
	u32 from = 0;
	json_t *o = json_object();
	ts_status status = ts_probe_require(p, needed);
	if (status == TS_OK) status = ts_probe_read_chain(p, &c, node);
	u64 key = status == TS_OK && shown(&c, texel, &from) != TS_EMPTY ? ts_probe_own_key(&c, from, texel) : TS_EMPTY;
	if (key != TS_EMPTY) status = put_rendered(p, o, ts_k_pair((u32)key, c.id[from]), (u32)(key >> 32));
	ts_probe_put(p, object, "pair", o);
	free(c.texels);
	return status;
}

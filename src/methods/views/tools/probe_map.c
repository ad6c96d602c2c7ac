/* A texel of a map: the pairs of nodes that were rendered into it and into the maps of the view nodes above, and the
 * results of fusion, from the root down. */
#include <inttypes.h>
#include <stdlib.h>
#include "methods/stages.h"
#include "methods/views/tools/probe.h"
#include "methods/views/traverse.h"

enum { MOST_LISTED = 8 };

/* A pair rendered to the texel in the map of a node of the chain, at a level of its pyramid. */
typedef struct {
	u64 key, pair;
	u32 step, mip;
} offer;

typedef struct {
	ts_traverse_args how;
	ts_own_args own;
	ts_probe_chain chain;
	u32 texel; /* of the finest level */
	u64 *map;  /* scratch, a map */
	u64 *stack;
	size_t n, room;
	offer *offers;
	size_t n_offers, offers_room;
	u32 n_near; /* pairs that would be rendered to the texel if they were farther */
} search;

static ts_status push(search *s, u64 pair)
{
	void *array = s->stack;
	if (ts_grow(&array, &s->room, s->n + 1, sizeof *s->stack, "pairs") != TS_OK) return TS_ERROR;
	s->stack = array;
	s->stack[s->n++] = pair;
	return TS_OK;
}

/* The kernel renders the pair alone; *mip is the level of its result over the texel. */
static u64 key_of(search *s, u64 pair, u32 step, u32 *mip)
{
	const ts_pyramid *pyramid = &s->chain.args.pyramid;
	ts_view_map_args to = {
		.nodes = s->how.nodes, .views = &s->chain.nodes[step], .texels = s->map, .pyramid = *pyramid};
	for (u32 l = 0; l < pyramid->levels; l++) s->map[ts_k_pyramid_above(pyramid, s->texel, l)] = TS_EMPTY;
	ts_k_map_pair(&to, ts_k_pair(ts_k_pair_node(pair), 0));
	for (*mip = 0; *mip < pyramid->levels; ++*mip) {
		u64 key = s->map[ts_k_pyramid_above(pyramid, s->texel, *mip)];
		if (key != TS_EMPTY) return key;
	}
	return TS_EMPTY;
}

static ts_status offer_pair(search *s, u64 pair, u32 step, u32 fate)
{
	u32 mip;
	void *array = s->offers;
	u64 key = key_of(s, pair, step, &mip);
	if (key == TS_EMPTY || ts_k_pair_is_own(&s->own, s->how.views, pair)) return TS_OK;
	if (fate == TS_PAIR_NEAR) s->n_near++;
	if (fate == TS_PAIR_NEAR) return TS_OK;
	if (ts_grow(&array, &s->offers_room, s->n_offers + 1, sizeof *s->offers, "pairs of a texel") != TS_OK)
		return TS_ERROR;
	s->offers = array;
	s->offers[s->n_offers++] = (offer){.key = key, .pair = pair, .step = step, .mip = mip};
	return TS_OK;
}

/* Children of a node of the scene, or the one node of views on the chain. */
static ts_status split(search *s, u64 pair, u32 step, u32 fate)
{
	u32 node = ts_k_pair_node(pair), views = ts_k_pair_views(pair);
	if (fate == TS_PAIR_SPLIT_VIEW)
		return step + 1 < s->chain.n ? push(s, ts_k_pair(node, s->chain.id[step + 1])) : TS_OK;
	u32 first = s->how.nodes[node].child, n = ts_k_count_bits(s->how.nodes[node].children);
	for (u32 k = 0; k < n; k++) {
		if (push(s, ts_k_pair(first + k, views)) != TS_OK) return TS_ERROR;
	}
	return TS_OK;
}

/* The traversal from the roots, or from each leaf of the scene; its nodes of views are only those of the chain. */
static ts_status traverse(search *s, bool leaves, u64 n_nodes)
{
	ts_status status = leaves ? TS_OK : push(s, ts_k_pair(0, s->chain.id[0]));
	for (u64 i = 0; leaves && i < n_nodes && status == TS_OK; i++) {
		if (s->how.nodes[i].children == 0) status = push(s, ts_k_pair((u32)i, s->chain.id[0]));
	}
	while (status == TS_OK && s->n > 0) {
		u64 pair = s->stack[--s->n];
		u32 fate = ts_k_pair_fate(&s->how, pair), step = s->how.views[ts_k_pair_views(pair)].level;
		bool ends = fate == TS_PAIR_RENDER || fate == TS_PAIR_NEAR;
		if (ends)
			status = offer_pair(s, pair, step, fate);
		else if (fate != TS_PAIR_CULL)
			status = split(s, pair, step, fate);
	}
	return status;
}

/* Brute force: every leaf of the scene. */
static ts_status try_all(search *s, u64 n_nodes)
{
	ts_status status = TS_OK;
	for (u64 i = 0; i < n_nodes && status == TS_OK; i++) {
		u64 pair = ts_k_pair((u32)i, s->chain.id[0]);
		u32 fate = s->how.nodes[i].children == 0 ? ts_k_pair_fate(&s->how, pair) : TS_PAIR_CULL;
		if (fate == TS_PAIR_RENDER || fate == TS_PAIR_NEAR) status = offer_pair(s, pair, 0, fate);
	}
	return status;
}

/* From the root down; each map shows the nearest. */
static int by_win(const void *a, const void *b)
{
	const offer *x = a, *y = b;
	if (x->step != y->step) return x->step < y->step ? -1 : 1;
	return x->key < y->key ? -1 : x->key > y->key;
}

/* The pairs that views from cubes' middles leave out. */
static ts_own_args own_of(const ts_run *run)
{
	if (!run->plan.views.cubes) return (ts_own_args){0};
	return (ts_own_args){ts_frame_data(&run->frame, TS_B_octree_reflector),
	                     ts_frame_data(&run->frame, TS_B_view_octree_leaf)};
}

static ts_status find_offers(ts_probe *p, search *s)
{
	s->own = own_of(&p->load->run);
	u64 n_nodes = ts_frame_n(&p->load->run.frame, TS_B_octree_node);
	bool all = !ts_probe_makes(p, TS_B_traverse_rendered);
	s->map = ts_alloc_zero(ts_k_pyramid_texels(&s->chain.args.pyramid), sizeof *s->map, "a map");
	if (s->map == NULL || ts_traverse_arguments(&p->load->run, &s->how) != TS_OK) return TS_ERROR;
	bool leaves = TS_PARAM(&p->load->run.params, traverse_hierarchies) == TS_HIERARCHIES_VIEWS;
	ts_status status = n_nodes == 0 ? TS_OK : all ? try_all(s, n_nodes) : traverse(s, leaves, n_nodes);
	if (s->n_offers > 0) qsort(s->offers, s->n_offers, sizeof *s->offers, by_win);
	return status;
}

static void put_offer(ts_probe *p, json_t *list, const search *s, const offer *o, const offer *winner)
{
	json_t *entry = json_object();
	ts_probe_put_decision(p, entry, &s->how, o->pair);
	if (s->chain.args.pyramid.levels > 1) ts_probe_put(p, entry, "level_of_map", ts_probe_int(o->mip));
	if (o != winner) ts_probe_put_margin(p, entry, ts_u2f((u32)(winner->key >> 32)), ts_u2f((u32)(o->key >> 32)));
	ts_probe_append(p, list, entry);
}

/* Puts the pairs rendered into the node's own map. Returns their number. */
static size_t put_own(ts_probe *p, json_t *object, const search *s, const offer *first, u32 step)
{
	json_t *o = json_object(), *list = json_array();
	size_t n = 0, left = s->n_offers - (size_t)(first - s->offers);
	for (; n < left && first[n].step == step; n++) {
		if (n < MOST_LISTED) put_offer(p, list, s, &first[n], first);
	}
	ts_probe_put(p, o, "competitors", ts_probe_int(n));
	ts_probe_put_key_check(p, o, TS_B_view_map_depth_node, n > 0 ? first->key : TS_EMPTY,
	                       ts_probe_own_key(&s->chain, step, s->texel));
	ts_probe_put(p, o, "by_depth", list);
	ts_probe_put(p, object, "rendered", o);
	return n;
}

static json_t *depth_or_empty(u32 bits) { return bits == TS_NONE ? json_string("empty") : ts_probe_bits(ts_u2f(bits)); }

/* The node of the scene at the distance that fusion found. */
static void put_node(ts_probe *p, json_t *object, u32 node, u32 held)
{
	json_t *o = json_object();
	ts_probe_put(p, o, "node", node == TS_NONE ? json_string("none") : ts_probe_int(node));
	ts_probe_put_record_check(p, o, TS_B_view_map_fused_node, &node, &held);
	ts_probe_put(p, object, "shows", o);
}

/* Fusion of the node's own result with its parent's, `above`, in the trace. */
static void put_fused(ts_probe *p, json_t *object, const search *s, u32 step, u64 above, u64 held)
{
	const ts_view_map_fuse_args *args = &s->chain.args;
	json_t *o = json_object();
	u64 own = ts_probe_own_key(&s->chain, step, s->texel), key = ts_k_fused(args, step, above, s->texel);
	f32 moved = 0.0f, computed = ts_u2f((u32)(key >> 32)), there = ts_u2f((u32)(held >> 32));
	if (above != TS_EMPTY) {
		ts_v3 a = ts_load3(args->views[step - 1].centre), b = ts_load3(args->views[step].centre);
		moved = ts_put(ts_k_moved_depth(a, ts_u2f((u32)(above >> 32)), b, s->texel, args->pyramid.n));
	}
	ts_probe_put(p, o, "own", depth_or_empty((u32)(own >> 32)));
	ts_probe_put(p, o, "moved_from_above", depth_or_empty(above != TS_EMPTY ? ts_f2u(moved) : TS_NONE));
	ts_probe_put(p, o, "depth", depth_or_empty((u32)(key >> 32)));
	ts_probe_put(p, o, "is", json_string(key == TS_EMPTY ? "empty" : key == own ? "its own" : "moved from above"));
	ts_probe_put_check(p, o, TS_B_view_map_fused_depth, &computed, &there, 1);
	put_node(p, o, (u32)key, (u32)held);
	ts_probe_put(p, object, "fused", o);
}

/* The texel of the whole map of a node of views, in the trace. */
static ts_status fetch_fused(ts_probe *p, u64 element, u64 *key)
{
	u32 depth, node;
	if (ts_probe_fetch(p, TS_B_view_map_fused_depth, element, 1, &depth) != TS_OK) return TS_ERROR;
	if (ts_probe_fetch(p, TS_B_view_map_fused_node, element, 1, &node) != TS_OK) return TS_ERROR;
	*key = (u64)depth << 32 | node;
	return TS_OK;
}

static ts_status put_chain(ts_probe *p, json_t *object, const search *s)
{
	json_t *list = json_array();
	const offer *next = s->offers;
	u32 n_texels = 2 * s->chain.args.pyramid.n * s->chain.args.pyramid.n;
	u64 above = TS_EMPTY, held = TS_EMPTY;
	ts_status status = TS_OK;
	for (u32 i = 0; i < s->chain.n && status == TS_OK; i++) {
		json_t *o = json_object();
		status = fetch_fused(p, (u64)s->chain.id[i] * n_texels + s->texel, &held);
		ts_probe_put(p, o, "views", ts_probe_int(s->chain.id[i]));
		ts_probe_put(p, o, "level_of_views", ts_probe_int(i));
		next += put_own(p, o, s, next, i);
		if (status == TS_OK) put_fused(p, o, s, i, above, held);
		ts_probe_append(p, list, o);
		above = held;
	}
	ts_probe_put(p, object, "from_the_root", list);
	ts_probe_put(p, object, "too_near", ts_probe_int(s->n_near));
	if (status == TS_OK) ts_probe_put(p, object, "depth", depth_or_empty((u32)(held >> 32)));
	return status;
}

static const char *half(u32 side) { return side == 0 ? "front" : "back"; }

static ts_status describe(ts_probe *p, json_t *o, u32 node, u32 texel)
{
	search s = {.texel = texel};
	u32 n = p->load->run.plan.views.px;
	const ts_cone *cone = (const ts_cone *)ts_probe_loaded(p, TS_B_view_octree_cone) + node;
	ts_status status = ts_probe_read_chain(p, &s.chain, node);
	if (status == TS_OK) status = find_offers(p, &s);
	ts_probe_put(p, o, "node", ts_probe_int(node));
	ts_probe_put(p, o, "lights", ts_probe_int(cone->views));
	ts_probe_put(p, o, "half", json_string(half(texel / (n * n))));
	ts_probe_put(p, o, "texel", ts_probe_pair(texel % n, texel / n % n));
	ts_probe_put_method(p, o);
	if (ts_k_paraboloid_is_used(texel, n)) {
		ts_probe_put(p, o, "direction", ts_probe_v3(ts_k_paraboloid_direction(texel, n)));
	} else {
		ts_probe_put(p, o, "direction", json_string("in the corner: its middle is in the other half"));
	}
	if (status == TS_OK) status = put_chain(p, o, &s);
	free(s.chain.texels);
	free(s.map);
	free(s.stack);
	free(s.offers);
	return status;
}

static ts_status load(ts_probe *p)
{
	static const ts_buffer_id needed[] = {TS_B_view_map_depth_node, TS_B_view_map_fused_depth, TS_B_view_map_fused_node,
	                                      TS_B_view_octree_leaf, TS_N_BUFFERS};
	const char *maker = ts_pipeline_maker(p->trace->pipeline, TS_B_view_map_depth_node)->stage;
	const ts_step *traverse = ts_pipeline_maker(p->trace->pipeline, TS_B_traverse_rendered);
	const char *stage = traverse != NULL ? traverse->stage : maker;
	if (ts_probe_scene(p) != TS_OK || ts_probe_require(p, needed) != TS_OK) return TS_ERROR;
	const char *own = ts_probe_makes(p, TS_B_octree_reflector) ? maker : NULL; /* reads which pairs views leave out */
	return ts_probe_load_for(p, (const char *const[]){stage, own, NULL});
}

/* Puts the texel of half `side` of a node's map. */
static ts_status answer(ts_probe *p, const ts_probe_question *q, u32 node, json_t *o)
{
	u32 side = p->load->run.plan.views.px;
	if (q->x >= side || q->y >= side) {
		return ts_fail("%s: no texel (%u, %u); halves of maps have %u x %u", p->trace->dir, (unsigned)q->x,
		               (unsigned)q->y, (unsigned)side, (unsigned)side);
	}
	return describe(p, o, node, (q->side * side + q->y) * side + q->x);
}

/* Loads inputs of maps; fails if there is no such light or node, each of which has an element of buffer id. */
static ts_status begin(ts_probe *p, const ts_probe_question *q, ts_buffer_id id, const char *noun)
{
	if (load(p) != TS_OK) return TS_ERROR;
	u64 n = ts_probe_n(p, id);
	if (q->index < n) return TS_OK;
	return ts_fail("%s: no %s %" PRIu64 "; there are %" PRIu64, p->trace->dir, noun, q->index, n);
}

ts_status ts_probe_light_texel(ts_probe *p, const ts_probe_question *q, json_t *o)
{
	u32 node;
	if (begin(p, q, TS_B_view_octree_leaf, "light") != TS_OK) return TS_ERROR;
	if (ts_probe_fetch(p, TS_B_view_octree_leaf, q->index, 1, &node) != TS_OK) return TS_ERROR;
	ts_probe_put(p, o, "light", ts_probe_int(q->index));
	return answer(p, q, node, o);
}

ts_status ts_probe_node_texel(ts_probe *p, const ts_probe_question *q, json_t *o)
{
	if (begin(p, q, TS_B_view_octree_node, "node of views") != TS_OK) return TS_ERROR;
	return answer(p, q, (u32)q->index, o);
}

const ts_probe_view ts_probe_map_of_light = {
	.form = "LIGHT.front or LIGHT.back",
	.prefix = "",
	.side = half,
	.n_sides = 2,
};
const ts_probe_view ts_probe_map_of_node = {
	.form = "nodeN.front or nodeN.back",
	.prefix = "node",
	.side = half,
	.n_sides = 2,
};

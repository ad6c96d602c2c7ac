/* A pixel lit by virtual point lights or particles: the nodes of views that culling leaves its node of the scene, the
 * lights that it draws, and the contribution of each. */
#include <stdlib.h>
#include "methods/views/octree.h"
#include "methods/views/tools/probe.h"
#include "methods/views/traverse.h"

enum { MOST_LISTED = 16, MOST_DRAWN = 64 };

/* A light and its number of draws. */
typedef struct {
	u32 view, times;
	ts_v3 light;
} term;
typedef struct {
	u64 nodes, views;
} tally;

/* The fate of the pair of nodes s and v: that of the first pair of nodes above them that is not split. */
static u32 fate_of(const ts_traverse_args *how, u32 s, u32 v, u64 *pair)
{
	*pair = ts_k_pair(0, ts_k_ancestor(how->views, v, 0));
	for (;;) {
		u32 fate = ts_k_pair_fate(how, *pair), node = ts_k_pair_node(*pair), views = ts_k_pair_views(*pair);
		if (fate != TS_PAIR_SPLIT_SCENE && fate != TS_PAIR_SPLIT_VIEW) return fate;
		if (fate == TS_PAIR_SPLIT_SCENE) node = ts_k_ancestor(how->nodes, s, how->nodes[node].level + 1);
		if (fate == TS_PAIR_SPLIT_VIEW) views = ts_k_ancestor(how->views, v, how->views[views].level + 1);
		*pair = ts_k_pair(node, views);
	}
}

static void put_tally(ts_probe *p, json_t *o, const char *key, const tally *t)
{
	ts_probe_put(p, o, key, json_pack("{s:o,s:o}", "nodes", ts_probe_int(t->nodes), "views", ts_probe_int(t->views)));
}

/* Compares the nodes of views of the lists' level with the list. */
static ts_status put_culling(ts_probe *p, json_t *o, const ts_vpl_gather_args *args, const ts_view_list *list, u32 node)
{
	ts_traverse_args how;
	tally all = {0, 0}, left = {0, 0}, unseen = {0, 0}, far = {0, 0};
	bool same = true;
	u32 first = ts_octree_first(&p->load->run, &ts_view_octree, args->level);
	u32 end = ts_octree_first(&p->load->run, &ts_view_octree, args->level + 1);
	if (ts_vpl_pairs_arguments(&p->load->run, &how) != TS_OK) return TS_ERROR;
	for (u32 v = first; v < end; v++) {
		u64 pair;
		bool culled = fate_of(&how, node, v, &pair) == TS_PAIR_CULL;
		ts_ball a = ts_k_pair_ball(&how, &how.nodes[ts_k_pair_node(pair)]);
		ts_ball b = ts_k_pair_ball(&how, &how.views[ts_k_pair_views(pair)]);
		ts_cone_k cone = ts_k_load_cone(&how.cones[ts_k_pair_views(pair)]);
		tally *of = !culled ? &left : ts_k_pair_is_culled(&a, &b, &cone, &how.phi) ? &unseen : &far;
		u64 at = list->from + left.nodes;
		if (!culled) same = same && at < list->to && args->list[at] == v;
		of->nodes++;
		of->views += args->cones[v].views;
		all.nodes++;
		all.views += args->cones[v].views;
	}
	same = same && left.nodes == list->to - list->from;
	put_tally(p, o, "views", &all);
	put_tally(p, o, "culled_as_they_look_elsewhere", &unseen);
	put_tally(p, o, "culled_beyond_cutoff", &far);
	put_tally(p, o, "left", &left);
	ts_probe_put(p, o, "check", json_sprintf("bits %s vpl_gather.pair_node", same ? "agree with" : "differ from"));
	return TS_OK;
}

static ts_status put_node(ts_probe *p, json_t *object, const ts_vpl_gather_args *args, const ts_view_list *list,
                          ts_v3 at)
{
	json_t *o = json_object();
	ts_status status = TS_OK;
	u32 node = ts_k_list_node(args, at);
	if (node != TS_NONE) {
		const ts_node *nodes = ts_probe_loaded(p, TS_B_octree_node);
		ts_probe_put(p, o, "node", ts_probe_int(node));
		ts_probe_put(p, o, "level", ts_probe_int(args->level));
		ts_probe_put(p, o, "centre", ts_probe_v3(ts_load3(nodes[node].centre)));
		status = put_culling(p, o, args, list, node);
	} else {
		ts_probe_put(p, o, "node", json_string("none holds the pixel: all lights are drawn from"));
	}
	ts_probe_put(p, object, "culling", o);
	return status;
}

static int by_view(const void *a, const void *b)
{
	const term *s = a, *t = b;
	return (s->view > t->view) - (s->view < t->view);
}

static f32 strength(const term *t) { return (f32)t->times * (t->light.x + t->light.y + t->light.z); }

static int by_light(const void *a, const void *b)
{
	f32 x = strength(a), y = strength(b);
	return x != y ? (x < y) - (x > y) : by_view(a, b);
}

/* Merges draws of the same light. Returns how many are left, the brightest first. */
static u32 group(term *terms, u32 n)
{
	u32 n_lights = 0;
	qsort(terms, n, sizeof *terms, by_view);
	for (u32 k = 0; k < n; k++) {
		bool more = n_lights > 0 && terms[n_lights - 1].view == terms[k].view;
		if (more) terms[n_lights - 1].times++;
		if (!more) terms[n_lights++] = terms[k];
	}
	qsort(terms, n_lights, sizeof *terms, by_light);
	return n_lights;
}

/* Sums up the lights from `MOST_LISTED` on. */
static void put_others(ts_probe *p, json_t *o, const term *terms, u32 n)
{
	u32 n_draws = 0;
	ts_v3 sum = ts_v3_make(0.0f, 0.0f, 0.0f);
	if (n <= MOST_LISTED) return;
	json_t *others = json_object();
	for (u32 k = MOST_LISTED; k < n; k++) {
		sum = ts_mad(sum, terms[k].light, (f32)terms[k].times);
		n_draws += terms[k].times;
	}
	ts_probe_put(p, others, "lights", ts_probe_int(n - MOST_LISTED));
	ts_probe_put(p, others, "draws", ts_probe_int(n_draws));
	ts_probe_put(p, others, "irradiance", ts_probe_v3(sum));
	ts_probe_put(p, o, "others", others);
}

static ts_status put_terms(ts_probe *p, json_t *o, const ts_probe_gather *gather, const term *terms, u32 n)
{
	json_t *list = json_array();
	ts_status status = TS_OK;
	f32 sum = 0.0f;
	for (u32 k = 0; k < n; k++) sum += strength(&terms[k]);
	for (u32 k = 0; k < n && k < MOST_LISTED && status == TS_OK; k++) {
		const term *t = &terms[k];
		json_t *entry = json_object();
		ts_probe_put(p, entry, "light", ts_probe_int(t->view));
		ts_probe_put(p, entry, "drawn", ts_probe_int(t->times));
		ts_probe_put(p, entry, "irradiance", ts_probe_v3_bits(t->light));
		ts_probe_put(p, entry, "part", ts_probe_real(sum > 0.0f ? strength(t) / sum : 0.0f));
		status = ts_probe_vpl(p, entry, gather, t->view);
		ts_probe_append(p, list, entry);
	}
	ts_probe_put(p, o, "brightest", list);
	put_others(p, o, terms, n);
	return status;
}

static ts_status put_draws(ts_probe *p, json_t *o, const ts_probe_gather *gather, const ts_view_list *list, u32 pixel)
{
	const ts_vpl_gather_args *args = &gather->args;
	ts_v3 at = ts_load3(gather->pixel.position), n = ts_load3(gather->pixel.normal), sum = ts_v3_make(0.0f, 0.0f, 0.0f);
	u32 draws = list->views > 0 ? ts_k_list_draws(args, list) : 0, n_giving = 0;
	term *terms = ts_alloc(draws + (size_t)1, sizeof *terms, "lights that are drawn");
	if (terms == NULL) return TS_ERROR;
	json_t *drawn = json_array();
	for (u32 k = 0; k < draws; k++) {
		u32 view = ts_k_drawn_view(args, list, pixel, k);
		terms[k] = (term){view, 1, ts_k_vpl_light(args, view, at, n)};
		sum = ts_add(sum, terms[k].light);
		n_giving += terms[k].light.x + terms[k].light.y + terms[k].light.z > 0.0f;
		if (k < MOST_DRAWN) ts_probe_append(p, drawn, ts_probe_int(view));
	}
	f32 share = draws > 0 ? (f32)list->views / (f32)draws : 0.0f;
	ts_probe_put(p, o, "draws", ts_probe_int(draws));
	ts_probe_put(p, o, "of_views", ts_probe_int(list->views));
	ts_probe_put(p, o, "that_give", ts_probe_int(n_giving));
	ts_probe_put(p, o, "share", ts_probe_bits(share));
	ts_probe_put(p, o, "drawn", drawn);
	ts_status status = put_terms(p, o, gather, terms, group(terms, draws));
	free(terms);
	ts_probe_put_sum(p, o, ts_scale(sum, share), ts_k_vpl_sum(args, list, pixel, at, n));
	return status;
}

static ts_status put_lights(ts_probe *p, json_t *object, const ts_probe_gather *gather, u32 pixel)
{
	f32 computed[3];
	json_t *o = json_object();
	const f32 *held = (const f32 *)ts_probe_loaded(p, TS_B_vpl_gather_irradiance) + (u64)pixel * 3;
	ts_v3 at = ts_load3(gather->pixel.position);
	ts_view_list list = ts_k_pixel_list(&gather->args, at);
	ts_status status = put_node(p, object, &gather->args, &list, at);
	if (status == TS_OK) status = put_draws(p, o, gather, &list, pixel);
	ts_store3(computed, ts_k_vpl_sum(&gather->args, &list, pixel, at, ts_load3(gather->pixel.normal)));
	ts_probe_put(p, o, "irradiance", ts_probe_v3_bits(ts_load3(computed)));
	ts_probe_put_check(p, o, TS_B_vpl_gather_irradiance, computed, held, 3);
	ts_probe_put(p, object, "lights", o);
	return status;
}

/* Loads inputs of stage vpl_gather and its neighbours. */
static ts_status load(ts_probe *p)
{
	const char *maker = ts_pipeline_maker(p->trace->pipeline, TS_B_vpl_light)->stage;
	return ts_probe_load_for(p, (const char *const[]){maker, "vpl_gather.pairs", "bilateral", "vpl_gather", NULL});
}

static ts_status put_irradiance(ts_probe *p, const ts_probe_seen *at, const ts_gpixel *pixel, json_t *object,
                                ts_probe_gathered *gathered)
{
	u32 index = at->row * p->view.width + at->x;
	ts_probe_gather gather = {.paths = NULL};
	(void)pixel;
	if (load(p) != TS_OK || ts_vpl_gather_ask(&p->load->run, &gather.args) != TS_OK) return TS_ERROR;
	gather.pixel = gather.args.pixels[index];
	if (ts_probe_read_paths(p, &gather) != TS_OK || put_lights(p, object, &gather, index) != TS_OK) return TS_ERROR;
	return ts_probe_filter(p, at, object, gathered->irradiance);
}

static ts_status put_light(ts_probe *p, const ts_probe_seen *at, json_t *o, ts_v3 *radiance)
{
	return ts_probe_put_indirect(p, at, put_irradiance, o, radiance);
}

ts_status ts_probe_views_pixel(ts_probe *p, const ts_probe_question *q, json_t *o)
{
	static const ts_buffer_id vpls[] = {TS_B_eye_depth_triangle, TS_B_rsm_patch, TS_N_BUFFERS};
	static const ts_buffer_id particles[] = {TS_B_eye_depth_triangle, TS_B_vpl_light, TS_N_BUFFERS};
	return ts_probe_eye_pixel(p, q, ts_probe_makes(p, TS_B_rsm_patch) ? vpls : particles, put_light, o);
}

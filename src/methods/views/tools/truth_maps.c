/* Maps of many views compared with rays (METHODS 17): the depths of whole maps along the middles of their texels, and
 * their results for places that pixels see. A large number of views is sampled at regular steps. */
#include "kernels/views/vpl_gather.h"
#include "methods/views/tools/tools.h"
#include "methods/views/traverse.h"
#include "methods/views/views.h"
#include "truth/truth.h"

enum { MOST_VIEWS = 1024, PLACES = 64, WRONG_LEAVES = 3, FINER = 4 };

typedef struct {
	const ts_truth *truth;
	ts_vpl_gather_args of;
	u64 n_pixels;
	f32 leaf, reach; /* side of a leaf; surfaces this near a light stop nothing */
	f32 apart;       /* params.view_map_apart */
	bool all;        /* views see all directions */
} judge;

static ts_truth_hit cast(const judge *j, ts_v3 from, ts_v3 way)
{
	ts_truth_query ray = {.origin = from, .direction = way, .near = j->reach, .masked = TS_NONE, .from = from};
	return ts_truth_cast(j->truth, &ray);
}

/* Whether any direction within the texel, not only its middle, hits something equally far away. */
static bool is_there(const judge *j, ts_v3 from, u32 texel, f32 depth)
{
	u32 n = j->of.n, side = FINER * n, half = texel / (n * n), row = texel / n % n, column = texel % n;
	for (u32 k = 0; k < FINER * FINER; k++) {
		u32 finer = (half * side + FINER * row + k / FINER) * side + FINER * column + k % FINER;
		ts_truth_hit hit = cast(j, from, ts_k_paraboloid_direction(finer, side));
		if (hit.triangle != TS_NONE && ts_abs(depth - hit.t) <= j->leaf * WRONG_LEAVES) return true;
	}
	return false;
}

static void judge_texel(const judge *j, u32 view, u32 texel, ts_texel_counts *counts)
{
	const ts_vpl *light = &j->of.lights[view];
	ts_v3 from = ts_load3(light->position), d = ts_k_paraboloid_direction(texel, j->of.n);
	bool seen = j->all || ts_dot(d, ts_load3(light->normal)) > 0.0f;
	if (!seen || !ts_k_paraboloid_is_used(texel, j->of.n)) return;
	ts_truth_hit hit = cast(j, from, d);
	u32 leaf = j->of.leaves[view], bits = (u32)(ts_k_vpl_shown(&j->of, view, texel) >> 32);
	if (hit.triangle == TS_NONE) return;
	counts->covered++;
	counts->holes += bits == TS_NONE;
	if (bits == TS_NONE) return;
	f32 depth = ts_k_moved_depth(ts_load3(j->of.nodes[leaf].centre), ts_u2f(bits), from, texel, j->of.n);
	counts->leaks += depth > hit.t + j->leaf * WRONG_LEAVES;
	counts->apart += ts_abs(depth - hit.t) > j->leaf * WRONG_LEAVES && !is_there(j, from, texel, depth);
}

/* Judges the pixel for a view's place k, the same for all methods. */
static void judge_place(const judge *j, u32 view, u32 k, ts_texel_counts *counts)
{
	const ts_vpl *light = &j->of.lights[view];
	const ts_gpixel *pixel = &j->of.pixels[((u64)ts_random(view * PLACES + k, 0, 0) * j->n_pixels) >> 32];
	if (pixel->depth == TS_SKY) return;
	ts_v3 from = ts_load3(light->position), p = ts_load3(pixel->position), n = ts_load3(pixel->normal);
	ts_v3 way = ts_sub(p, from);
	if (!(ts_k_vpl_form(way, ts_load3(light->normal), n, j->of.near * j->leaf) > 0.0f)) return;
	bool lit = ts_k_vpl_reaches(&j->of, view, ts_k_paraboloid_texel(way, j->of.n), p, n);
	bool sees = ts_truth_sees(j->truth, p, from, j->reach);
	counts->asked++;
	counts->lit += lit && !sees;
	counts->dark += !lit && sees;
	if (lit != sees) counts->because[ts_truth_wrong(j->truth, &j->of, view, p, n, j->reach, j->apart, lit)]++;
}

static ts_texel_counts judge_view(const judge *j, u32 view)
{
	ts_texel_counts counts = {.asked = 0};
	for (u32 texel = 0; texel < 2 * j->of.n * j->of.n; texel++) judge_texel(j, view, texel, &counts);
	for (u32 k = 0; k < PLACES; k++) judge_place(j, view, k, &counts);
	return counts;
}

static void add(ts_texel_counts *sum, const ts_texel_counts *counts)
{
	sum->covered += counts->covered;
	sum->holes += counts->holes;
	sum->leaks += counts->leaks;
	sum->apart += counts->apart;
	sum->asked += counts->asked;
	sum->lit += counts->lit;
	sum->dark += counts->dark;
	for (u32 i = 0; i < TS_N_WRONG; i++) sum->because[i] += counts->because[i];
}

ts_status ts_truth_maps(ts_texel_counts *counts, ts_truth *truth, const ts_run *run, ts_buffer_id id)
{
	(void)id;
	judge j = {.truth = truth};
	if (ts_vpl_gather_ask(run, &j.of) != TS_OK) return TS_ERROR;
	u32 step = (j.of.n_lights + MOST_VIEWS - 1) / MOST_VIEWS;
	j.n_pixels = (u64)TS_PARAM(&run->params, width) * TS_PARAM(&run->params, height);
	j.leaf = ts_k_leaf_side(&j.of);
	j.reach = ts_k_leaf_diagonal(&j.of);
	j.apart = TS_PARAM(&run->params, view_map_apart);
	j.all = run->plan.views.field == TS_VIEW_FIELD_ALL;
	ts_texel_counts sum = {.asked = 0};
#pragma omp parallel for num_threads((int)run->c.threads) schedule(dynamic, 4)
	for (u32 view = 0; view < j.of.n_lights; view += step) {
		ts_texel_counts one = judge_view(&j, view);
#pragma omp critical(maps)
		add(&sum, &one);
	}
	add(counts, &sum);
	counts->reasons = ts_wrong_names;
	return TS_OK;
}

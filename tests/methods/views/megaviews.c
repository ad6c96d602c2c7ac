/* Indirect light by many small views, as whole runs: the same bits on any number of threads and by queues of any
 * length; lists that leave no light out; light that tends to what every pixel gathers from triangles of light; skies,
 * lamps and octrees that are hardly there; maps by brute force against a second reckoning, and against ManyLoDs; every
 * stage from what it claims to read. */
#include <math.h>
#include "kernels/views/view_map.h"
#include "methods/views/views.h"
#include "tests/methods/small.h"
#include "trace/emitted/sums.h"

static const char *const methods[] = {"megaviews", "manylods", "bruteforce"};
enum { N_METHODS = 3 };

static ts_params tiny_params(void)
{
	ts_params params = small_params(40, 22);
	params.reflectors_count = 0;
	params.rsm_px = 24;
	params.octree_levels = 5;
	params.vpl_gather_level = 3;
	params.vpl_paths = 150;
	return params;
}

static ts_scene *scene; /* which only few parameters change */

static void run_of(ts_run *run, const ts_scene *of, const ts_params *params, const char *method)
{
	ts_run_begin(run, of, params, 2);
	if (ts_pipeline_run(ts_pipeline_find("indirect", method), run) != TS_OK)
		fail_msg("%s: %s", method, ts_error_message());
}

static void sums_of(ts_sums *sums, const ts_params *params, const char *method, u32 threads)
{
	const ts_how how = {.threads = threads};
	ts_status status = ts_sums_of(sums, ts_pipeline_find("indirect", method), scene, params, &how);
	if (status != TS_OK) fail_msg("%s: %s", method, ts_error_message());
}

static void assert_same(const ts_sums *a, const ts_sums *b)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		if (strcmp(a->hex[id], b->hex[id]) != 0) fail_msg("%s differs", ts_buffer_table[id].name);
	}
	assert_int_equal(strlen(a->hex[TS_B_indirect_irradiance]), 64);
}

static void threads_and_queues_change_no_bit(void **state)
{
	(void)state;
	for (u32 m = 0; m < N_METHODS; m++) {
		static ts_sums one, three, pieces;
		ts_params params = tiny_params();
		params.octree_levels = 6;
		params.vpl_paths = 30;
		params.vpl_bounces = 2;
		sums_of(&one, &params, methods[m], 1);
		sums_of(&three, &params, methods[m], 3);
		params.traverse_queue_mb = 1;
		sums_of(&pieces, &params, methods[m], 2);
		assert_same(&one, &three);
		assert_same(&one, &pieces);
	}
}

static void stages_read_only_what_they_claim(void **state)
{
	(void)state;
	for (u32 k = 0; k < 2 * N_METHODS; k++) {
		ts_run run;
		ts_params params = tiny_params();
		params.vpl_paths = 30;
		if (k >= N_METHODS) {
			params.vpl_place = TS_VPL_AT_RANDOM;
			params.vpl_gather_query = TS_QUERY_DESCEND;
			params.traverse_hierarchies = TS_HIERARCHIES_VIEWS;
		}
		ts_run_begin(&run, scene, &params, 2);
		run.traced = run.margins = true;
		assert_int_equal(ts_pipeline_run(ts_pipeline_find("indirect", methods[k % N_METHODS]), &run), TS_OK);
		for (u32 i = 0; i < run.n_timings; i++) small_assert_claims(&run, ts_stage_find(run.timings[i].stage));
		ts_run_end(&run);
	}
}

/* The node of the scene of a level that holds a leaf. */
static u32 above(const ts_node *nodes, u32 node, u32 level)
{
	while (nodes[node].level > level) node = nodes[node].parent;
	return node;
}

static bool lists(const ts_run *run, u64 list, u32 views)
{
	const u32 *offset = ts_frame_data(&run->frame, TS_B_vpl_gather_pair_offset);
	const u32 *node = ts_frame_data(&run->frame, TS_B_vpl_gather_pair_node);
	for (u32 k = offset[list]; k < offset[list + 1]; k++) {
		if (node[k] == views) return true;
	}
	return false;
}

/* What a list leaves out cannot light any place in its node, here the eight corners of the node's box; sums are of
 * views. */
static void lists_leave_out_no_light(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	params.vpl_paths = 60;
	params.octree_levels = 6;
	params.vpl_gather_level = 5;
	ts_run run;
	run_of(&run, scene, &params, "megaviews");
	const ts_node *nodes = ts_frame_data(&run.frame, TS_B_octree_node);
	const ts_node *views = ts_frame_data(&run.frame, TS_B_view_octree_node);
	const u32 *level = ts_frame_data(&run.frame, TS_B_octree_level);
	const u32 *leaf = ts_frame_data(&run.frame, TS_B_view_octree_leaf);
	const ts_vpl *lights = ts_frame_data(&run.frame, TS_B_vpl_light);
	u64 n_left_out = 0, n_lists = ts_frame_n(&run.frame, TS_B_vpl_gather_pair_offset) - 1;
	assert_int_equal(n_lists, level[6] - level[5]);
	for (u64 list = 0; list < n_lists; list++) {
		const ts_node *node = &nodes[level[5] + list];
		f32 half = node->radius / sqrtf(3.0f);
		for (u32 v = 0; v < params.vpl_paths; v++) {
			if (lists(&run, list, above(views, leaf[v], 5))) continue;
			n_left_out++;
			for (u32 k = 0; k < 8; k++) {
				ts_v3 corner = {(k & 1) != 0 ? half : -half, (k & 2) != 0 ? half : -half, (k & 4) != 0 ? half : -half};
				ts_v3 way = ts_add(ts_sub(ts_load3(node->centre), ts_load3(lights[v].position)), corner);
				assert_true(ts_dot(way, ts_load3(lights[v].normal)) < 0.001f);
			}
		}
	}
	assert_true(n_left_out > 1000);
	assert_true(ts_run_counter(&run, "gather pairs culled") > 0 && ts_run_counter(&run, "pixels in no node") == 0);
	assert_int_equal(ts_run_counter(&run, "gather pairs"), ts_frame_n(&run.frame, TS_B_vpl_gather_pair_node));
	ts_run_end(&run);
}

/* Nothing farther than the cut-off is in a list, and what is left out is. */
static void lists_end_at_the_cut_off(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	params.view_map_field = TS_VIEW_FIELD_ALL;
	params.vpl_gather_cutoff = 4;
	ts_run run;
	run_of(&run, scene, &params, "megaviews");
	const ts_node *nodes = ts_frame_data(&run.frame, TS_B_octree_node);
	const ts_node *views = ts_frame_data(&run.frame, TS_B_view_octree_node);
	const u32 *level = ts_frame_data(&run.frame, TS_B_octree_level);
	const u32 *view_level = ts_frame_data(&run.frame, TS_B_view_octree_level);
	for (u64 list = 0; list < ts_frame_n(&run.frame, TS_B_vpl_gather_pair_offset) - 1; list++) {
		for (u32 v = view_level[3]; v < view_level[4]; v++) {
			const ts_node *a = &nodes[level[3] + list], *b = &views[v];
			f32 gap = ts_length(ts_sub(ts_load3(a->centre), ts_load3(b->centre))) - (a->radius + b->radius);
			assert_true(lists(&run, list, v) == (gap <= 4));
		}
	}
	assert_true(ts_run_counter(&run, "gather pairs culled") > 0);
	ts_run_end(&run);
}

static double apart(const f32 *a, const f32 *b, u64 n)
{
	double difference = 0, all = 0;
	for (u64 i = 0; i < n; i++) {
		difference += fabs((double)a[i] - (double)b[i]);
		all += (double)b[i];
	}
	return difference / all;
}

static const f32 *light_of(const ts_run *run) { return ts_frame_data(&run->frame, TS_B_indirect_irradiance); }

/* Without shadows, filter and chance the lights are the triangles of light, as points: leaves' sides off their
 * surfaces, and as good only from afar. */
static void units_of_light_match_direct(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	params.width = 80;
	params.height = 44;
	params.octree_levels = 8;
	params.vpl_paths = params.vpl_gather_lights = params.bilateral_px = params.vpl_gather_shadows = 0;
	params.vpl_gather_near = 1;
	ts_run direct, views, alone;
	run_of(&direct, scene, &params, "direct");
	run_of(&views, scene, &params, "megaviews");
	run_of(&alone, scene, &params, "manylods");
	u64 n = ts_frame_n(&direct.frame, TS_B_indirect_irradiance);
	double of_direct = apart(light_of(&views), light_of(&direct), n);
	double of_alone = apart(light_of(&views), light_of(&alone), n);
	if (!(of_direct < 0.06)) fail_msg("%g of the light of triangles apart", of_direct);
	if (!(of_alone < 1e-5)) fail_msg("%g apart without a hierarchy", of_alone);
	ts_run_end(&direct);
	ts_run_end(&views);
	ts_run_end(&alone);
}

/* Drawn lights are, on the mean, all of them; and shadows only take away. */
static void drawn_lights_average_to_all(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	params.bilateral_px = params.vpl_gather_lights = 0;
	ts_run all, some, open;
	run_of(&all, scene, &params, "megaviews");
	params.vpl_gather_lights = 256;
	run_of(&some, scene, &params, "megaviews");
	params.vpl_gather_lights = params.vpl_gather_shadows = 0;
	run_of(&open, scene, &params, "megaviews");
	u64 n = ts_frame_n(&all.frame, TS_B_indirect_irradiance), n_dark = 0;
	double mean_all = 0, mean_some = 0;
	for (u64 i = 0; i < n; i++) {
		mean_all += (double)light_of(&all)[i];
		mean_some += (double)light_of(&some)[i];
		assert_true(light_of(&all)[i] <= light_of(&open)[i]);
		n_dark += light_of(&all)[i] < light_of(&open)[i];
	}
	assert_true(n_dark > n / 20 && mean_all > 0 && fabs(mean_some / mean_all - 1) < 0.03);
	ts_run_end(&all);
	ts_run_end(&some);
	ts_run_end(&open);
}

/* Nothing but sky; no light; one; octrees of a level. */
static void little_light_and_no_light_end_well(void **state)
{
	(void)state;
	for (u32 k = 0; k < 4 * N_METHODS; k++) {
		ts_params params = tiny_params();
		u32 few = k / N_METHODS;
		if (few == 1) params.light_irradiance = 0;
		if (few == 2) params.vpl_paths = 1;
		if (few == 3) params.octree_levels = 1;
		ts_scene *own = small_scene(&params);
		if (few == 0) {
			own->info.circles = 0;
			ts_store3(own->info.eye, ts_v3_make(60, 30, -2));
			ts_store3(own->info.back, ts_v3_make(-1, 0, 0));
			ts_store3(own->info.right, ts_v3_make(0, 0, 1));
			ts_store3(own->info.up, ts_v3_make(0, 1, 0));
		}
		ts_run run;
		run_of(&run, own, &params, methods[k % N_METHODS]);
		double sum = 0;
		for (u64 i = 0; i < ts_frame_n(&run.frame, TS_B_indirect_irradiance); i++) {
			f32 e = light_of(&run)[i];
			assert_true(e >= 0 && e < 1e6f);
			sum += (double)e;
		}
		assert_true(few < 2 ? sum == 0 : sum >= 0);
		assert_int_equal(ts_run_counter(&run, "virtual point lights"), few == 1 ? 0 : few == 2 ? 1 : 150);
		ts_run_end(&run);
		ts_scene_free(own);
	}
}

static void is_near(const char *what, u64 expected, u64 made, double factor)
{
	double ratio = ((double)expected + 1) / ((double)made + 1);
	if (ratio > factor || ratio < 1 / factor)
		fail_msg("%s: %llu expected, %llu made", what, (unsigned long long)expected, (unsigned long long)made);
}

/* A run takes about the memory that is expected; queues take no more than they may, and with more pairs more. */
static void a_run_takes_the_memory_expected(void **state)
{
	(void)state;
	u32 n_octrees = 0;
	for (u32 k = 0; k < 2 * N_METHODS; k++) {
		const ts_pipeline *pipeline =
			ts_pipeline_find(k < N_METHODS ? "indirect" : "particles", methods[k % N_METHODS]);
		ts_params params = tiny_params();
		params.particle_count = params.vpl_paths;
		params.traverse_queue_mb = 64;
		ts_expected expected = ts_pipeline_expect(pipeline, scene, &params);
		u64 estimate = ts_pipeline_estimate(pipeline, scene, &params, true);
		assert_true(expected.work <= 64 << 20);
		params.traverse_queue_mb = 1;
		u64 least = ts_pipeline_expect(pipeline, scene, &params).work;
		assert_true(least <= 1 << 20 && least <= expected.work);
		ts_run run;
		ts_run_begin(&run, scene, &params, 2);
		run.lean = true;
		assert_int_equal(ts_pipeline_run(pipeline, &run), TS_OK);
		is_near("bytes", estimate - expected.work, run.frame.peak_bytes, 1.5);
		is_near("nodes", expected.sizes.n[TS_DIM_nodes], (u64)ts_run_counter(&run, "scene nodes"), 1.5);
		u64 view_nodes = (u64)ts_run_counter(&run, "view nodes");
		if (view_nodes != 0) is_near("view nodes", expected.sizes.n[TS_DIM_view_nodes], view_nodes, 1.5);
		n_octrees += view_nodes != 0;
		is_near("pairs", expected.sizes.n[TS_DIM_gather_pairs], (u64)ts_run_counter(&run, "gather pairs"), 3);
		ts_run_end(&run);
	}
	assert_true(n_octrees >= 2);
}

/* A distance beyond which nothing is gathered leaves few pairs, a map of finer texels more in the queues. */
static void a_cut_off_leaves_few_pairs(void **state)
{
	(void)state;
	const ts_pipeline *pipeline = ts_pipeline_find("indirect", "megaviews");
	ts_params params = tiny_params();
	params.octree_levels = 9;
	params.traverse_queue_mb = 256;
	ts_expected all = ts_pipeline_expect(pipeline, scene, &params);
	params.vpl_gather_cutoff = 0.01f;
	ts_expected few = ts_pipeline_expect(pipeline, scene, &params);
	assert_true(few.sizes.n[TS_DIM_gather_pairs] < all.sizes.n[TS_DIM_gather_pairs] / 2);
	params.view_map_px *= 2;
	assert_true(ts_pipeline_expect(pipeline, scene, &params).work > few.work);
	params.view_map_field = TS_VIEW_FIELD_ALL;
	params.vpl_gather_cutoff = 0;
	assert_int_equal(ts_pipeline_expect(pipeline, scene, &params).sizes.n[TS_DIM_gather_nodes], 1);
}

/* Of many more paths than texels of the reflective shadow map maps are expected where those are. */
static void many_paths_share_texels_places(void **state)
{
	(void)state;
	const ts_pipeline *pipeline = ts_pipeline_find("indirect", "megaviews");
	ts_params params = tiny_params();
	params.traverse_queue_mb = 1;
	params.rsm_px = 8;
	params.octree_levels = 9;
	params.vpl_paths = 64;
	u64 few = ts_pipeline_estimate(pipeline, scene, &params, true);
	params.vpl_paths = 64000;
	u64 many = ts_pipeline_estimate(pipeline, scene, &params, true);
	assert_true(many > few && many - few < 64000 * 100);
	params.vpl_bounces = 2;
	assert_true(ts_pipeline_estimate(pipeline, scene, &params, true) - many > 64000ull * 2 * 16 * 16 * 16);
}

/* Where a leaf of the scene is in the map of a view, in double precision: place of the texel, how far the direction
 * is from its edges in texels, and the distance; false: behind the view, or too near to be rendered, or nearly so:
 * `unsure`. */
typedef struct {
	u32 texel;
	double edge, distance;
	bool unsure;
} spot;

static bool place_of(spot *r, const ts_node *leaf, const ts_vpl *light, u32 n)
{
	double d[3], square = 0, ahead = 0, at[2];
	for (u32 k = 0; k < 3; k++) {
		d[k] = (double)leaf->centre[k] - (double)light->position[k];
		square += d[k] * d[k];
		ahead += d[k] * (double)light->normal[k];
	}
	r->distance = sqrt(square);
	r->edge = 1;
	for (u32 k = 0; k < 2; k++) {
		at[k] = (d[k + 1] / (r->distance + fabs(d[0])) / 2 + 0.5) * n;
		r->edge = fmin(r->edge, fabs(at[k] - round(at[k])));
	}
	r->texel = ((d[0] < 0 ? n : 0) + (u32)at[1]) * n + (u32)at[0];
	double radius = (double)leaf->radius, apart = r->distance - 3 * radius, seen = ahead + radius;
	r->unsure = fabs(apart) < 1e-4 || fabs(seen) < 2e-3 * r->distance;
	return apart > 0 && seen > 0;
}

/* Every leaf that is surely seen well within a texel is there or behind what is; and what is there is such a leaf. */
static void assert_brute(const ts_run *run, u32 view, u64 *n_leaves)
{
	u32 n = run->params.view_map_px;
	const u64 *map = (const u64 *)ts_frame_data(&run->frame, TS_B_view_map_depth_node) + (u64)view * 2 * n * n;
	const ts_node *nodes = ts_frame_data(&run->frame, TS_B_octree_node);
	const ts_vpl *light = (const ts_vpl *)ts_frame_data(&run->frame, TS_B_vpl_light) + view;
	const u32 *level = (const u32 *)ts_frame_data(&run->frame, TS_B_octree_level) + run->params.octree_levels;
	for (u32 i = level[0]; i < level[1]; i++) {
		spot at;
		if (!place_of(&at, &nodes[i], light, n) || at.unsure || at.edge < 1e-4) continue;
		assert_true((double)ts_u2f((u32)(map[at.texel] >> 32)) < at.distance * 1.00001);
		++*n_leaves;
	}
	for (u32 t = 0; t < 2 * n * n; t++) {
		spot at;
		u32 i = (u32)map[t];
		if (map[t] == TS_EMPTY) continue;
		assert_true(i >= level[0] && i < level[1] && (place_of(&at, &nodes[i], light, n) || at.unsure));
		assert_true(fabs(at.distance / (double)ts_u2f((u32)(map[t] >> 32)) - 1) < 1e-5 &&
		            (at.texel == t || at.edge < 1e-4));
	}
}

static int by_value(const void *a, const void *b)
{
	u64 x = *(const u64 *)a, y = *(const u64 *)b;
	return x < y ? -1 : x > y;
}

/* Maps without the hierarchy: every leaf is in them; and they are those of ManyLoDs in texels that show a leaf in
 * both, this one rendered by both. */
static void brute_force_shows_every_leaf(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	params.octree_levels = 6;
	params.vpl_paths = 40;
	params.view_map_texel = TS_TEXEL_POINT;
	ts_run brute, alone;
	run_of(&brute, scene, &params, "bruteforce");
	ts_run_begin(&alone, scene, &params, 2);
	alone.traced = true;
	assert_int_equal(ts_pipeline_run(ts_pipeline_find("indirect", "manylods"), &alone), TS_OK);
	u64 n = ts_frame_n(&brute.frame, TS_B_view_map_depth_node), n_leaves = 0, n_same = 0, n_differ = 0, n_shown = 0;
	for (u32 v = 0; v < params.vpl_paths; v++) assert_brute(&brute, v, &n_leaves);
	const u64 *a = ts_frame_data(&brute.frame, TS_B_view_map_depth_node),
			  *b = ts_frame_data(&alone.frame, TS_B_view_map_depth_node);
	const u64 *pairs = ts_frame_data(&alone.frame, TS_B_traverse_rendered);
	const ts_node *nodes = ts_frame_data(&brute.frame, TS_B_octree_node);
	assert_int_equal(n, ts_frame_n(&alone.frame, TS_B_view_map_depth_node));
	for (u64 i = 0; i < n; i++) {
		u64 pair = (u64)(u32)a[i] << 32 | i / (2 * params.view_map_px * params.view_map_px);
		u64 n_pairs = ts_frame_n(&alone.frame, TS_B_traverse_rendered);
		bool both = a[i] != TS_EMPTY && b[i] != TS_EMPTY && nodes[(u32)b[i]].children == 0 &&
		            bsearch(&pair, pairs, n_pairs, sizeof pair, by_value) != NULL;
		if (both) assert_true(a[i] == b[i]);
		n_same += both;
		n_shown += a[i] != TS_EMPTY;
		n_differ += a[i] != b[i];
	}
	i64 n_scene = ts_run_counter(&brute, "scene leaves");
	assert_int_equal(ts_run_counter(&brute, "pairs"), n_scene * params.vpl_paths);
	double percent = 100.0 / (double)n_shown;
	print_message("texels: %.1f %% that both show by a leaf, %.1f %% that differ\n", percent * (double)n_same,
	              percent * (double)n_differ);
	assert_true(n_leaves > 10000 && n_same > n_shown / 20 && n_differ > 0);
	ts_run_end(&brute);
	ts_run_end(&alone);
}

/* Where every leaf is wider than a texel all is the same, up to the light; for all views see the same leaves. */
static void wide_leaves_leave_no_difference(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	params.octree_levels = 4;
	params.view_map_px = 128;
	params.vpl_paths = 40;
	ts_run brute, alone;
	run_of(&brute, scene, &params, "bruteforce");
	run_of(&alone, scene, &params, "manylods");
	i64 rendered = ts_run_counter(&alone, "pairs rendered");
	assert_int_equal(ts_run_counter(&alone, "pairs wider than a texel"), rendered);
	assert_int_equal(ts_run_counter(&brute, "pairs rendered"), rendered);
	static const ts_buffer_id same[] = {TS_B_view_map_depth_node, TS_B_view_map_fused_depth, TS_B_vpl_gather_irradiance,
	                                    TS_B_indirect_irradiance};
	for (u32 i = 0; i < sizeof same / sizeof *same; i++) {
		size_t bytes = ts_frame_n(&alone.frame, same[i]) * ts_buffer_table[same[i]].element_bytes;
		assert_memory_equal(ts_frame_data(&brute.frame, same[i]), ts_frame_data(&alone.frame, same[i]), bytes);
	}
	ts_run_end(&brute);
	ts_run_end(&alone);
}

/* Whether a light sees all that a texel does: its corners, and what lies between them. */
static bool sees_texel(const f32 *normal, u32 texel, u32 n)
{
	const double bent = 0.05;
	bool back = texel >= n * n;
	for (u32 k = 0; k < 4; k++) {
		double u = 2.0 * (texel % n + k % 2) / n - 1, v = 2.0 * (texel / n % n + k / 2) / n - 1, square = u * u + v * v;
		double x = back ? square - 1 : 1 - square;
		if (x * (double)normal[0] + 2 * u * (double)normal[1] + 2 * v * (double)normal[2] < bent) return false;
	}
	return true;
}

/* Without culling there are more pairs, and maps show the same before each light. */
static void culling_changes_no_lit_map(void **state)
{
	(void)state;
	for (u32 m = 0; m < N_METHODS; m++) {
		ts_params params = tiny_params(), whole;
		params.view_map_multipixel = TS_MULTIPIXEL_MIPS;
		whole = params;
		whole.traverse_cull = 0;
		ts_run culled, all;
		run_of(&culled, scene, &params, methods[m]);
		run_of(&all, scene, &whole, methods[m]);
		i64 n = ts_run_counter(&culled, "pairs culled"), n_whole = ts_run_counter(&all, "pairs culled");
		assert_true(strcmp(methods[m], "bruteforce") == 0 || (n > 0 && n_whole == 0));
		assert_true(ts_run_counter(&all, "pairs rendered") > ts_run_counter(&culled, "pairs rendered"));
		const ts_vpl *lights = ts_frame_data(&all.frame, TS_B_vpl_light);
		const u32 *leaf = ts_frame_data(&all.frame, TS_B_view_octree_leaf);
		const u32 *a = ts_frame_data(&all.frame, TS_B_view_map_fused_depth);
		const u32 *b = ts_frame_data(&culled.frame, TS_B_view_map_fused_depth);
		u32 px = params.view_map_px, seen = 0, unseen = 0;
		for (u64 l = 0; l < ts_frame_n(&all.frame, TS_B_vpl_light); l++) {
			for (u32 t = 0; t < 2 * px * px; t++) {
				u64 at = (u64)leaf[l] * 2 * px * px + t;
				bool sees = sees_texel(lights[l].normal, t, px);
				if (sees && a[at] != b[at]) fail_msg("%s: light %u, texel %u", methods[m], (unsigned)l, (unsigned)t);
				seen += sees;
				unseen += a[at] != b[at];
			}
		}
		assert_true(seen > 10000 && unseen > 1000);
		ts_run_end(&culled);
		ts_run_end(&all);
	}
}

/* Without a hierarchy of the scene, or of the views either, maps are those of brute force; with one of the views there
 * are more pairs than with both, in queues of any length. */
static void views_alone_show_as_brute_force(void **state)
{
	(void)state;
	static ts_sums brute, alone, shared, pieces;
	ts_params params = tiny_params();
	params.vpl_paths = 40;
	ts_run both, views;
	sums_of(&brute, &params, "bruteforce", 2);
	run_of(&both, scene, &params, "megaviews");
	params.traverse_hierarchies = TS_HIERARCHIES_VIEWS;
	sums_of(&alone, &params, "manylods", 2);
	sums_of(&shared, &params, "megaviews", 2);
	run_of(&views, scene, &params, "megaviews");
	params.traverse_queue_mb = 1;
	sums_of(&pieces, &params, "megaviews", 3);
	assert_string_equal(brute.hex[TS_B_view_map_depth_node], alone.hex[TS_B_view_map_depth_node]);
	assert_string_equal(brute.hex[TS_B_indirect_irradiance], alone.hex[TS_B_indirect_irradiance]);
	assert_same(&shared, &pieces);
	i64 n = ts_run_counter(&views, "pairs"), n_both = ts_run_counter(&both, "pairs");
	i64 most = ts_run_counter(&views, "scene leaves") * ts_run_counter(&views, "view nodes");
	print_message("pairs: %lld, of both %lld, at most %lld\n", (long long)n, (long long)n_both, (long long)most);
	assert_true(n > 2 * n_both && n <= most && n > most / 4);
	ts_run_end(&both);
	ts_run_end(&views);
}

/* Maps asked from the root down, without fusion, answer the same: pictures have the same bits, and a question reads a
 * texel of each node above its view, and of each level of their pyramids. */
static void queries_from_the_root_agree(void **state)
{
	(void)state;
	for (u32 m = 0; m < N_METHODS; m++) {
		for (u32 k = 0; k < 4; k++) {
			ts_params params = tiny_params(), descend;
			params.vpl_paths = 30;
			params.view_map_fusion = k % 2 != 0 ? TS_FUSION_PAPER : TS_FUSION_MIN;
			params.view_map_texel = k / 2 != 0 ? TS_TEXEL_MIDDLE : TS_TEXEL_POINT;
			params.view_map_multipixel = k / 2 != 0 ? TS_MULTIPIXEL_MIPS : TS_MULTIPIXEL_OFF;
			params.bilateral_px = 0;
			descend = params;
			descend.vpl_gather_query = TS_QUERY_DESCEND;
			ts_run a, b;
			run_of(&a, scene, &params, methods[m]);
			run_of(&b, scene, &descend, methods[m]);
			const ts_buffer *fused = &a.frame.buffer[TS_B_vpl_gather_irradiance],
							*asked = &b.frame.buffer[TS_B_vpl_gather_irradiance];
			assert_true(fused->bytes > 0 && fused->bytes == asked->bytes);
			assert_memory_equal(ts_frame_data(&a.frame, TS_B_vpl_gather_irradiance),
			                    ts_frame_data(&b.frame, TS_B_vpl_gather_irradiance), fused->bytes);
			assert_false(b.frame.buffer[TS_B_view_map_fused_depth].made);
			u32 levels = ts_view_pyramid(&params, &a.plan).levels, nodes = m == 0 ? params.octree_levels + 1 : 1;
			assert_int_equal(ts_run_counter(&a, "texels a question"), 1);
			assert_int_equal(ts_run_counter(&b, "texels a question"), levels * nodes);
			ts_run_end(&a);
			ts_run_end(&b);
		}
	}
}

static int begin(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	scene = small_scene(&params);
	return 0;
}

static int end(void **state)
{
	(void)state;
	ts_scene_free(scene);
	return 0;
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(threads_and_queues_change_no_bit),   cmocka_unit_test(stages_read_only_what_they_claim),
		cmocka_unit_test(lists_leave_out_no_light),           cmocka_unit_test(lists_end_at_the_cut_off),
		cmocka_unit_test(units_of_light_match_direct),        cmocka_unit_test(drawn_lights_average_to_all),
		cmocka_unit_test(little_light_and_no_light_end_well), cmocka_unit_test(a_run_takes_the_memory_expected),
		cmocka_unit_test(a_cut_off_leaves_few_pairs),         cmocka_unit_test(many_paths_share_texels_places),
		cmocka_unit_test(brute_force_shows_every_leaf),       cmocka_unit_test(wide_leaves_leave_no_difference),
		cmocka_unit_test(culling_changes_no_lit_map),         cmocka_unit_test(queries_from_the_root_agree),
		cmocka_unit_test(views_alone_show_as_brute_force),
	};
	return cmocka_run_group_tests(tests, begin, end);
}

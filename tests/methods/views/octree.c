/* The two octrees of MegaViews, from the scene to the cones of the views, by a pipeline of this test: the same bits
 * on any number of threads and on OpenCL; leaves that hold just their triangles; surfaces; lights; every stage from
 * what it claims to read. */
#include "../../../src/methods/views/views.h"
#include "../../../src/kernels/views/cast.h"
#include "../small.h"
#include <math.h>
#include "../../../src/kernels/views/voxel.h"
#include "../../../src/methods/raster/pipelines.h"
#include "../../../src/methods/stages.h"
#include "../../../src/trace/sums.h"
#include "../../backends/device.h"

static const ts_step steps[] = {
	{.stage = "pose"},
	{.stage = "lamp"},
	{.stage = "rsm.view"},
	{.stage = "rsm"},
	{.stage = "rsm.patch"},
	{.stage = "octree.root"},
	{.stage = "voxel"},
	{.stage = "octree"},
	{.stage = "octree.surface"},
	{.stage = "vpl"},
	{.stage = "view_octree.voxel"},
	{.stage = "view_octree"},
	{.stage = "view_octree.cone"},
	{0},
};
static const ts_pipeline pipeline = {
	.name = "octrees",
	.effect = &ts_effect_indirect,
	.steps = steps,
	.plan = ts_indirect_plan,
	.expect = ts_indirect_expect,
};

static ts_params params_of(u32 levels, u32 vpls)
{
	ts_params params = small_params(96, 64);
	params.reflectors_count = 0;
	params.rsm_px = 24;
	params.octree_levels = levels;
	params.vpl_paths = vpls;
	return params;
}

static void run_of(ts_run *run, const ts_scene *scene, const ts_params *params)
{
	ts_run_begin(run, scene, params, 2);
	if (ts_pipeline_run(&pipeline, run) != TS_OK) fail_msg("%s", ts_error_message());
}

static void sums_of(ts_sums *sums, const ts_scene *scene, const ts_params *params, u32 threads, ts_backend *backend)
{
	const ts_how how = {.threads = threads, .backend = backend};
	if (ts_sums_of(sums, &pipeline, scene, params, &how) != TS_OK) fail_msg("%s", ts_error_message());
	assert_int_equal(strlen(sums->hex[TS_B_view_octree_cone]), 64);
}

static void assert_same(const ts_sums *a, const ts_sums *b)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		if (strcmp(a->hex[id], b->hex[id]) != 0) fail_msg("%s differs", ts_buffer_table[id].name);
	}
}

static void test_threads(void **state)
{
	(void)state;
	static ts_sums one, seven;
	ts_params params = params_of(6, 1000);
	params.vpl_bounces = 4;
	ts_scene *scene = small_scene(&params);
	sums_of(&one, scene, &params, 1, NULL);
	sums_of(&seven, scene, &params, 7, NULL);
	assert_same(&one, &seven);
	ts_scene_free(scene);
}

static void test_opencl(void **state)
{
	(void)state;
	device_need();
	static ts_sums c, cl;
	const ts_backend_options options = {.work_group = 5, .build = ""};
	for (u32 levels = 1; levels <= 6; levels += 5) {
		ts_backend *backend = NULL;
		ts_params params = params_of(levels, levels == 1 ? 0 : 300);
		params.vpl_bounces = levels == 1 ? 1 : 3;
		ts_scene *scene = small_scene(&params);
		sums_of(&c, scene, &params, 2, NULL);
		if (ts_opencl_kind.open(&backend, &options) != TS_OK) fail_msg("%s", ts_error_message());
		sums_of(&cl, scene, &params, 1, backend);
		assert_same(&c, &cl);
		backend->close(backend);
		ts_scene_free(scene);
	}
}

static bool is_listed(const u32 *offset, const u32 *entries, u32 leaf, u32 triangle)
{
	for (u32 k = offset[leaf]; k < offset[leaf + 1]; k++) {
		if (entries[k] == triangle) return true;
	}
	return false;
}

/* Every leaf lists triangles in order, each once, and those whose corner it holds are there. */
static void test_lists(void **state)
{
	(void)state;
	ts_run run;
	ts_params params = params_of(6, 0);
	ts_scene *scene = small_scene(&params);
	run_of(&run, scene, &params);
	const u32 *offset = ts_frame_data(&run.frame, TS_B_octree_offset);
	const u32 *entries = ts_frame_data(&run.frame, TS_B_octree_triangle);
	const u32 *before = ts_frame_data(&run.frame, TS_B_voxel_before),
			  *level = ts_frame_data(&run.frame, TS_B_octree_level);
	const u64 *mask = ts_frame_data(&run.frame, TS_B_voxel_mask);
	const ts_root *root = ts_frame_data(&run.frame, TS_B_octree_root);
	u64 n_leaves = ts_frame_n(&run.frame, TS_B_octree_offset) - 1;
	assert_int_equal(n_leaves, level[7] - level[6]);
	assert_int_equal(offset[n_leaves], ts_frame_n(&run.frame, TS_B_octree_triangle));
	for (u64 i = 0; i < n_leaves; i++) {
		assert_true(offset[i] < offset[i + 1]);
		for (u32 k = offset[i] + 1; k < offset[i + 1]; k++) assert_true(entries[k - 1] < entries[k]);
	}
	const ts_arrays arrays = ts_run_arrays(&run);
	for (u32 t = 0; t < scene->n_triangles; t++) {
		ts_corners corners = ts_k_corners(&arrays, t);
		if (ts_k_is_degenerate(corners.n)) continue;
		u64 code = ts_k_morton(ts_k_voxel_of(root, 6, corners.b));
		u64 word = ts_k_mask_word(6, code);
		assert_true((mask[word] & ts_k_mask_bit(code)) != 0);
		assert_true(is_listed(offset, entries, ts_k_mask_id(mask, before, 6, code) - level[6], t));
	}
	assert_int_equal(ts_run_counter(&run, "scene leaves"), n_leaves);
	assert_int_equal(ts_run_counter(&run, "scene nodes"), level[7]);
	ts_run_end(&run);
	ts_scene_free(scene);
}

/* Albedos are those of materials; inner nodes are means of their children. */
static void test_surfaces(void **state)
{
	(void)state;
	ts_run run;
	ts_params params = params_of(5, 0);
	ts_scene *scene = small_scene(&params);
	run_of(&run, scene, &params);
	const ts_node *nodes = ts_frame_data(&run.frame, TS_B_octree_node);
	const ts_node_surface *surfaces = ts_frame_data(&run.frame, TS_B_octree_surface);
	u64 n = ts_frame_n(&run.frame, TS_B_octree_node);
	u32 n_coloured = 0;
	for (u64 i = 0; i < n; i++) {
		double albedo[3] = {0, 0, 0}, normal[3] = {0, 0, 0};
		u32 children = ts_k_count_bits(nodes[i].children);
		for (u32 k = 0; k < 3; k++) {
			assert_true(surfaces[i].albedo[k] >= 0 && surfaces[i].albedo[k] <= 1);
			assert_true(fabsf(surfaces[i].normal[k]) <= 1.000001f);
			for (u32 c = 0; c < children; c++) {
				albedo[k] += (double)surfaces[nodes[i].child + c].albedo[k] / children;
				normal[k] += (double)surfaces[nodes[i].child + c].normal[k] / children;
			}
			if (children == 0) continue;
			assert_true(fabs(albedo[k] - (double)surfaces[i].albedo[k]) < 1e-6);
			assert_true(fabs(normal[k] - (double)surfaces[i].normal[k]) < 1e-6);
		}
		n_coloured += surfaces[i].albedo[0] != surfaces[i].albedo[1];
	}
	assert_true(n_coloured > n / 10);
	ts_run_end(&run);
	ts_scene_free(scene);
}

/* Flux of all lights, of red. */
static double flux_of(const ts_run *run)
{
	double sum = 0;
	const ts_vpl *lights = ts_frame_data(&run->frame, TS_B_vpl_light);
	for (u64 i = 0; i < ts_frame_n(&run->frame, TS_B_vpl_light); i++) sum += (double)lights[i].flux[0];
	return sum;
}

/* All lights send what their texels do, half a leaf above them; so many at random send as much in all. */
static void test_lights(void **state)
{
	(void)state;
	ts_run all, some;
	ts_params params = params_of(6, 0);
	ts_scene *scene = small_scene(&params);
	run_of(&all, scene, &params);
	const ts_vpl *lights = ts_frame_data(&all.frame, TS_B_vpl_light);
	const ts_patch *patches = ts_frame_data(&all.frame, TS_B_rsm_patch);
	const ts_root *root = ts_frame_data(&all.frame, TS_B_octree_root);
	u64 n = 0;
	double sum = 0, half_leaf = (double)root->side / 128;
	for (u64 i = 0; i < ts_frame_n(&all.frame, TS_B_rsm_patch); i++) {
		const ts_patch *p = &patches[i];
		if (!(p->exitance[0] > 0 || p->exitance[1] > 0 || p->exitance[2] > 0)) continue;
		double side = 0, away = 0;
		for (u32 k = 0; k < 3; k++) {
			double middle = ((double)p->a[k] + (double)p->b[k] + (double)p->c[k]) / 3;
			side += ((double)p->b[k] - (double)p->a[k]) * ((double)p->b[k] - (double)p->a[k]);
			away += ((double)lights[n].position[k] - middle) * (double)p->normal[k];
		}
		double flux = (double)p->exitance[0] * sqrt(3) / 4 * side;
		assert_true(fabs((double)lights[n].flux[0] - flux) <= 1e-4 * flux + 1e-9);
		assert_true(fabs(away - half_leaf) < 1e-3 * half_leaf && lights[n].bounce == 1);
		assert_memory_equal(lights[n].normal, p->normal, sizeof p->normal);
		sum += flux;
		n++;
	}
	assert_int_equal(n, ts_frame_n(&all.frame, TS_B_vpl_light));
	params.vpl_paths = 100000;
	run_of(&some, scene, &params);
	assert_int_equal(ts_frame_n(&some.frame, TS_B_vpl_light), 100000);
	assert_true(fabs(flux_of(&some) - sum) < 0.02 * sum);
	ts_run_end(&some);
	ts_run_end(&all);
	ts_scene_free(scene);
}

static ts_cast_args cast_of(const ts_run *run, u32 levels)
{
	const ts_root *root = ts_frame_data(&run->frame, TS_B_octree_root);
	return (ts_cast_args){
		.scene = ts_run_arrays(run),
		.nodes = ts_frame_data(&run->frame, TS_B_octree_node),
		.offset = ts_frame_data(&run->frame, TS_B_octree_offset),
		.triangles = ts_frame_data(&run->frame, TS_B_octree_triangle),
		.first_leaf = ((const u32 *)ts_frame_data(&run->frame, TS_B_octree_level))[levels],
		.leaf = root->side / (f32)(1 << levels),
	};
}

static f32 uniform(u32 n) { return ts_uniform(ts_random(n, 6, 3)); }

/* In double precision: where the ray meets the triangle's plane, or 0 if that is not well inside it and in front. */
static double meets(const ts_corners *t, ts_v3 o, ts_v3 d, double margin)
{
	double e1[3] = {(double)t->b.x - (double)t->a.x, (double)t->b.y - (double)t->a.y, (double)t->b.z - (double)t->a.z};
	double e2[3] = {(double)t->c.x - (double)t->a.x, (double)t->c.y - (double)t->a.y, (double)t->c.z - (double)t->a.z};
	double s[3] = {(double)o.x - (double)t->a.x, (double)o.y - (double)t->a.y, (double)o.z - (double)t->a.z};
	double r[3] = {(double)d.x, (double)d.y, (double)d.z};
	double p[3] = {r[1] * e2[2] - r[2] * e2[1], r[2] * e2[0] - r[0] * e2[2], r[0] * e2[1] - r[1] * e2[0]};
	double q[3] = {s[1] * e1[2] - s[2] * e1[1], s[2] * e1[0] - s[0] * e1[2], s[0] * e1[1] - s[1] * e1[0]};
	double whole = e1[0] * p[0] + e1[1] * p[1] + e1[2] * p[2];
	double u = (s[0] * p[0] + s[1] * p[1] + s[2] * p[2]) / whole, v = (r[0] * q[0] + r[1] * q[1] + r[2] * q[2]) / whole;
	double at = (e2[0] * q[0] + e2[1] * q[1] + e2[2] * q[2]) / whole;
	return u > margin && v > margin && u + v < 1 - margin && at > 1e-4 ? at : 0;
}

/* A ray meets what a loop over all triangles finds, and what is in its way in double precision. */
static void test_cast(void **state)
{
	(void)state;
	ts_run run;
	u32 n_hits = 0;
	ts_params params = params_of(5, 0);
	ts_scene *scene = small_scene(&params);
	run_of(&run, scene, &params);
	const ts_cast_args args = cast_of(&run, 5);
	for (u32 i = 0; i < 1500; i++) {
		ts_v3 o = ts_v3_make(12 * uniform(6 * i) - 6, 8 * uniform(6 * i + 1) - 4, 12 * uniform(6 * i + 2) - 6);
		ts_v3 d = ts_v3_make(uniform(6 * i + 3) - 0.5f, uniform(6 * i + 4) - 0.5f, uniform(6 * i + 5) - 0.5f);
		d = i % 10 == 0 ? ts_v3_make(0, i % 20 == 0 ? 1 : -1, 0) : ts_normalize(d);
		ts_cast_ray ray = ts_k_cast_ray(o, d);
		ts_cast_hit found = ts_k_cast(&args, o, d), all = {.t = 4611686018427387904.0f, .triangle = TS_NONE};
		double sure = 1e30;
		for (u32 t = scene->n_triangles; t-- > 0;) {
			ts_corners corners = ts_k_corners(&args.scene, t);
			ts_k_cast_triangle(&args, &ray, t, &all);
			double at = meets(&corners, o, d, 1e-3);
			bool counts = at > 0 && ts_k_is_facing(&args.scene, t, &corners, o);
			bool whole = (args.scene.materials[args.scene.triangles[t].material].flags & TS_MASKED) == 0;
			if (counts && whole && at < sure) sure = at;
		}
		assert_memory_equal(&found, &all, sizeof found);
		assert_true((double)found.t <= sure * 1.0001);
		if (found.triangle == TS_NONE) continue;
		ts_corners corners = ts_k_corners(&args.scene, found.triangle);
		double at = meets(&corners, o, d, -1e-3);
		assert_true(at == 0 ? found.t < 1e-3f : fabs(at - (double)found.t) < 1e-3 * at);
		n_hits++;
	}
	assert_true(n_hits > 500);
	ts_run_end(&run);
	ts_scene_free(scene);
}

/* Paths begin where single lights are, lose the albedo of what they meet, and their lights hover over surfaces. */
static void test_paths(void **state)
{
	(void)state;
	ts_run once, often;
	u32 n[5] = {0}, n_lost = 0;
	ts_params params = params_of(5, 3000);
	ts_scene *scene = small_scene(&params);
	run_of(&once, scene, &params);
	params.vpl_bounces = 4;
	run_of(&often, scene, &params);
	const ts_vpl *first = ts_frame_data(&once.frame, TS_B_vpl_light),
				 *light = ts_frame_data(&often.frame, TS_B_vpl_light);
	const u32 *path = ts_frame_data(&often.frame, TS_B_vpl_path);
	const ts_cast_args args = cast_of(&often, 5);
	for (u32 k = 0; k < 3000; k++) {
		assert_memory_equal(&light[path[k]], &first[k], sizeof *first);
		for (u32 i = path[k]; i < path[k + 1]; i++) {
			const ts_v3 normal = ts_load3(light[i].normal), p = ts_load3(light[i].position);
			assert_int_equal(light[i].bounce, i - path[k] + 1);
			n[light[i].bounce]++;
			f32 below = ts_k_cast(&args, p, ts_neg(normal)).t;
			n_lost += below >= args.leaf * 0.501f; /* beside the border of its triangle, as rounding falls */
			if (i == path[k]) continue;
			for (u32 c = 0; c < 3; c++) assert_true(light[i].flux[c] <= light[i - 1].flux[c]);
		}
	}
	assert_true(n[1] == 3000 && n[2] > 1000 && n[2] >= n[3] && n[3] >= n[4] && n[4] > 300);
	assert_true(n_lost < 30);
	ts_run_end(&often);
	ts_run_end(&once);
	ts_scene_free(scene);
}

/* Directions about a normal: mean cosine 2/3, of its square 1/2, and nothing to one side. */
static void test_directions(void **state)
{
	(void)state;
	enum { N = 100000 };
	const ts_vpl_args args = {.seed = 5};
	for (u32 k = 0; k < 3; k++) {
		double up = 0, square = 0, aside[3] = {0, 0, 0};
		ts_v3 n = k == 0 ? ts_v3_make(0, 1, 0) : ts_normalize(ts_v3_make(0.3f, (f32)k - 2, 0.7f));
		for (u32 i = 0; i < N; i++) {
			ts_v3 d = ts_k_vpl_direction(&args, i, 1 + k, n), across = ts_mad(d, n, -ts_dot(d, n));
			double cosine = (double)ts_dot(d, n);
			assert_true(cosine >= 0 && fabsf(ts_length(d) - 1) < 1e-6f);
			up += cosine / N;
			square += cosine * cosine / N;
			aside[0] += (double)across.x / N;
			aside[1] += (double)across.y / N;
			aside[2] += (double)across.z / N;
		}
		assert_true(fabs(up - 2.0 / 3) < 0.004 && fabs(square - 0.5) < 0.005);
		for (u32 c = 0; c < 3; c++) assert_true(fabs(aside[c]) < 0.008);
	}
}

/* A lamp that meets nothing: no lights, an octree without nodes. */
static void test_dark(void **state)
{
	(void)state;
	ts_run run;
	ts_params params = params_of(4, 50);
	params.light_irradiance = 0;
	ts_scene *scene = small_scene(&params);
	run_of(&run, scene, &params);
	assert_int_equal(ts_frame_n(&run.frame, TS_B_vpl_light), 0);
	assert_int_equal(ts_frame_n(&run.frame, TS_B_view_octree_node), 0);
	assert_int_equal(ts_frame_n(&run.frame, TS_B_view_octree_cone), 0);
	assert_true(ts_frame_n(&run.frame, TS_B_octree_node) > 0);
	ts_run_end(&run);
	ts_scene_free(scene);
}

/* Every stage again from a frame where all that it does not claim to read is zero. */
static void test_claims(void **state)
{
	(void)state;
	ts_run run;
	ts_params params = params_of(5, 200);
	params.vpl_bounces = 2;
	ts_scene *scene = small_scene(&params);
	run_of(&run, scene, &params);
	for (const ts_step *step = steps; step->stage != NULL; step++) {
		const ts_stage *stage = ts_stage_find(step->stage);
		small_assert_claims(&run, stage);
	}
	ts_run_end(&run);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_threads),  cmocka_unit_test(test_opencl),     cmocka_unit_test(test_lists),
		cmocka_unit_test(test_surfaces), cmocka_unit_test(test_lights),     cmocka_unit_test(test_cast),
		cmocka_unit_test(test_paths),    cmocka_unit_test(test_directions), cmocka_unit_test(test_dark),
		cmocka_unit_test(test_claims),
	};
	device_keep_kernels();
	return cmocka_run_group_tests(tests, NULL, NULL);
}

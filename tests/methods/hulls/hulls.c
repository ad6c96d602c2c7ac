/* Screen-space approximate Gaussian hulls and the light they approximate, as whole runs: the same bits on any number of
 * threads; views of every light; the counters; pictures that look alike; what is refused; and skies, lamps and colours
 * that are not there. */
#include <math.h>
#include "kernels/base/shade.h"
#include "kernels/base/srgb.h"
#include "kernels/hulls/segment_box.h"
#include "tests/methods/small.h"
#include "trace/emitted/sums.h"

static ts_params tiny_params(void)
{
	ts_params params = small_params(100, 54);
	params.reflectors_count = 0;
	params.depth_grid_px = 64;
	params.rsm_px = 8;
	return params;
}

static void effect_of(ts_run *run, const ts_scene *scene, const ts_params *params, const char *effect,
                      const char *method)
{
	ts_run_begin(run, scene, params, 2);
	if (ts_pipeline_run(ts_pipeline_find(effect, method), run) != TS_OK) fail_msg("%s: %s", method, ts_error_message());
}

static void run_of(ts_run *run, const ts_scene *scene, const ts_params *params, const char *method)
{
	effect_of(run, scene, params, "indirect", method);
}

static void sums_of(ts_sums *sums, const ts_scene *scene, const ts_params *params, const ts_pipeline *method,
                    u32 threads)
{
	const ts_how how = {.threads = threads};
	ts_status status = ts_sums_of(sums, method, scene, params, &how);
	if (status != TS_OK) fail_msg("%s: %s", method->name, ts_error_message());
}

static void threads_change_no_bit_of_any_way(void **state)
{
	(void)state;
	static const struct {
		const char *effect, *method, *set[4][2];
	} rows[] = {
		{"indirect",
	     "hulls",
	     {{"segment.method", "components"}, {"hull.sharpness", "vmf"}, {"hull.interpolation", "moments"}}},
		{"indirect", "hulls", {{"hull.surface", "paper"}, {"hull.cosine", "quadrature"}}},
		{"indirect", "hulls", {{"hull.cosine", "sg"}, {"lamp.source", "scene"}}},
		{"indirect", "hulls", {{"corner.facing", "paper"}, {"hull.corners", "rectangle"}}},
		{"indirect", "direct", {{"lamp.source", "lamp"}}},
		{"area-light", "hulls", {{"lamp.radius", "0.25"}}},
		{"area-light", "direct", {{"lamp.source", "scene"}}},
		{"indirect", "hulls", {{"gloss.lobe", "on"}, {"hull.interpolation", "moments"}}},
		{"area-light", "direct", {{"gloss.lobe", "on"}}},
	};
	for (u32 row = 0; row < sizeof rows / sizeof *rows; row++) {
		static ts_sums one, seven;
		ts_params params = tiny_params();
		ts_scene *scene = small_scene(&params);
		for (u32 i = 0; i < 4 && rows[row].set[i][0] != NULL; i++) {
			assert_int_equal(ts_params_set(&params, rows[row].set[i][0], rows[row].set[i][1]), TS_OK);
		}
		const ts_pipeline *method = ts_pipeline_find(rows[row].effect, rows[row].method);
		sums_of(&one, scene, &params, method, 1);
		sums_of(&seven, scene, &params, method, 7);
		for (u32 id = 0; id < TS_N_BUFFERS; id++) assert_string_equal(one.hex[id], seven.hex[id]);
		assert_int_equal(strlen(one.hex[TS_B_indirect_irradiance]), 64);
		ts_scene_free(scene);
	}
}

/* Sums over all pixels and channels of the light that two runs disagree on, of what the second has. */
static double apart(const ts_run *a, const ts_run *b)
{
	const f32 *p = ts_frame_data(&a->frame, TS_B_indirect_irradiance);
	const f32 *q = ts_frame_data(&b->frame, TS_B_indirect_irradiance);
	double difference = 0, all = 0;
	for (u64 i = 0; i < ts_frame_n(&a->frame, TS_B_indirect_irradiance); i++) {
		difference += fabs((double)p[i] - (double)q[i]);
		all += (double)q[i];
	}
	return difference / all;
}

/* Of the sky and of nothing else no light arrives at, and what arrives is finite. */
static void check_light(const ts_run *run)
{
	const ts_gpixel *pixels = ts_frame_data(&run->frame, TS_B_gbuffer_pixel);
	const f32 *light = ts_frame_data(&run->frame, TS_B_indirect_irradiance);
	const f32 *radiance = ts_frame_data(&run->frame, TS_B_image_radiance);
	const u64 *seen = ts_frame_data(&run->frame, TS_B_eye_depth_triangle);
	const ts_v3 sky = ts_k_background();
	for (u64 i = 0; i < ts_frame_n(&run->frame, TS_B_gbuffer_pixel); i++) {
		assert_true((seen[i] == TS_EMPTY) == (pixels[i].depth == 1));
		assert_true(pixels[i].depth >= 0 && pixels[i].depth <= 1);
		for (u32 c = 0; c < 3; c++) {
			f32 e = light[3 * i + c];
			assert_true(e >= 0 && e < 1e6f && (pixels[i].depth < 1 || e == 0));
			if (pixels[i].depth == 1) assert_true(radiance[3 * i + c] == (c == 0 ? sky.x : c == 1 ? sky.y : sky.z));
		}
	}
}

/* Hulls are near what they approximate; so are other ways to get there, and nearer to each other. */
static void hulls_are_near_what_they_stand_for(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	ts_scene *scene = small_scene(&params);
	params.depth_grid_px = 256;
	ts_run direct, hulls, other;
	run_of(&direct, scene, &params, "direct");
	run_of(&hulls, scene, &params, "hulls");
	check_light(&direct);
	check_light(&hulls);
	assert_true(apart(&hulls, &direct) < 0.4);
	assert_int_equal(ts_run_counter(&direct, "gathers"), 100 * 54 * 64);
	assert_int_equal(ts_run_counter(&hulls, "gathers"), 4 * 64 * ts_run_counter(&hulls, "boxes"));
	static const char *const set[][2] = {{"segment.method", "components"},
	                                     {"hull.cosine", "quadrature"},
	                                     {"hull.interpolation", "moments"},
	                                     {"hull.integrals", "printed"}};
	for (u32 i = 0; i < 4; i++) {
		ts_params changed = params;
		assert_int_equal(ts_params_set(&changed, set[i][0], set[i][1]), TS_OK);
		run_of(&other, scene, &changed, "hulls");
		check_light(&other);
		double d = apart(&other, &hulls);
		if (!(d > 0 && d < 0.15)) fail_msg("%s=%s: %g", set[i][0], set[i][1], d);
		ts_run_end(&other);
	}
	ts_run_end(&direct);
	ts_run_end(&hulls);
	ts_scene_free(scene);
}

/* The least place of a block that a texel hangs together with, found by looking until nothing changes. */
static void components_of(u32 *component, const f32 *depths, u32 grid, u32 block, f32 step)
{
	for (u32 p = 0; p < TS_BLOCK_TEXELS; p++) component[p] = p;
	for (bool changed = true; changed;) {
		changed = false;
		for (u32 k = 0; k < 2 * TS_BLOCK_TEXELS; k++) {
			u32 p = k / 2, q = k % 2 == 0 ? p + 1 : p + TS_BLOCK;
			if (q >= TS_BLOCK_TEXELS || (k % 2 == 0 && q % TS_BLOCK == 0)) continue;
			f32 a = depths[ts_k_block_texel(grid, block, p % TS_BLOCK, p / TS_BLOCK)];
			f32 b = depths[ts_k_block_texel(grid, block, q % TS_BLOCK, q / TS_BLOCK)];
			f32 gap = fabsf(a - b), room_a = step * (1 - a), room_b = step * (1 - b);
			u32 least = component[p] < component[q] ? component[p] : component[q];
			if (component[p] == component[q] || (gap > room_a && gap > room_b)) continue;
			component[p] = component[q] = least;
			changed = true;
		}
	}
}

/* Of rendered depth: no label spans two components, and the other segment.method has them. */
static void check_segments(const ts_scene *scene, const ts_params *params, u64 *n_more)
{
	static u32 component[TS_BLOCK_TEXELS];
	ts_run swept, exact;
	ts_params other = *params;
	other.segment_method = TS_SEGMENTATION_COMPONENTS;
	run_of(&swept, scene, params, "hulls");
	run_of(&exact, scene, &other, "hulls");
	const f32 *depths = ts_frame_data(&swept.frame, TS_B_depth_grid_depth);
	const u32 *labels = ts_frame_data(&swept.frame, TS_B_segment_label);
	const u32 *components = ts_frame_data(&exact.frame, TS_B_segment_label);
	for (u32 block = 0; block < params->depth_grid_px / TS_BLOCK * (params->depth_grid_px / TS_BLOCK); block++) {
		components_of(component, depths, params->depth_grid_px, block, params->segment_step);
		for (u32 p = 0; p < TS_BLOCK_TEXELS; p++) {
			u64 at = ts_k_block_texel(params->depth_grid_px, block, p % TS_BLOCK, p / TS_BLOCK);
			assert_int_equal(component[labels[at]], component[p]);
			assert_int_equal(components[at], component[p]);
		}
	}
	*n_more += (u64)(ts_run_counter(&swept, "labels") - ts_run_counter(&exact, "labels"));
	assert_true(ts_run_counter(&swept, "labels") >= ts_run_counter(&exact, "labels"));
	ts_run_end(&swept);
	ts_run_end(&exact);
}

static void no_segment_spans_two_components(void **state)
{
	(void)state;
	static const char *const specs[] = {SMALL_SCENE, "gallery:texels=16", "dining:texels=16"};
	u64 n_more = 0;
	for (u32 i = 0; i < sizeof specs / sizeof *specs; i++) {
		ts_params params = tiny_params();
		ts_scene *scene;
		params.width = 320;
		params.height = 180;
		params.depth_grid_px = 256;
		params.rsm_px = 1;
		if (ts_scene_load(&scene, specs[i], &params, NULL) != TS_OK) fail_msg("%s", ts_error_message());
		check_segments(scene, &params, &n_more);
		ts_scene_free(scene);
	}
	assert_true(n_more > 50);
}

/* The box of a block that is one segment, and its corners. */
static void check_unparted(const ts_run *run, const ts_segment *box)
{
	u32 grid = run->params.depth_grid_px, block = box->label / TS_BLOCK_TEXELS;
	const f32 *depths = ts_frame_data(&run->frame, TS_B_depth_grid_depth);
	const ts_gpixel *pixels = ts_frame_data(&run->frame, TS_B_gbuffer_pixel);
	const ts_moment *corner = ts_frame_data(&run->frame, TS_B_corner_moment);
	corner += 4 * (box - (const ts_segment *)ts_frame_data(&run->frame, TS_B_segment_box));
	f32 least = 1, most = 0;
	for (u32 p = 0; p < TS_BLOCK_TEXELS; p++) {
		f32 depth = depths[ts_k_block_texel(grid, block, p % TS_BLOCK, p / TS_BLOCK)];
		least = fminf(least, depth);
		most = fmaxf(most, depth);
	}
	assert_true(box->nearest == least && box->farthest == most && box->label % TS_BLOCK_TEXELS == 0);
	for (u32 k = 0; k < 2; k++) {
		u32 first = TS_BLOCK * (k == 0 ? block % (grid / TS_BLOCK) : block / (grid / TS_BLOCK));
		assert_true(box->low[k] == first && box->high[k] == first + TS_BLOCK - 1);
	}
	for (u32 k = 0; k < 4; k++) {
		u32 x = k % 2 == 0 ? box->low[0] : box->high[0], y = k / 2 == 0 ? box->low[1] : box->high[1];
		const ts_gpixel *pixel = &pixels[ts_k_grid_pixel(grid, run->params.width, run->params.height, x, y)];
		assert_memory_equal(corner[k].position, pixel->position, sizeof pixel->position);
	}
}

/* Without segments a box is a block with its sky, no corner is corrected, and every pixel has the box of its block. No
 * decision was near another. */
static void unparted_blocks_have_one_box_each(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	ts_scene *scene;
	ts_run run;
	params.width = 320;
	params.height = 180;
	params.depth_grid_px = 256;
	params.segment_method = TS_SEGMENTATION_NONE;
	if (ts_scene_load(&scene, "gallery:texels=16", &params, NULL) != TS_OK) fail_msg("%s", ts_error_message());
	ts_run_begin(&run, scene, &params, 2);
	run.traced = run.margins = true;
	if (ts_pipeline_run(ts_pipeline_find("indirect", "hulls"), &run) != TS_OK) fail_msg("%s", ts_error_message());
	const ts_segment *boxes = ts_frame_data(&run.frame, TS_B_segment_box);
	const ts_gpixel *pixels = ts_frame_data(&run.frame, TS_B_gbuffer_pixel);
	const u32 *chosen = ts_frame_data(&run.frame, TS_B_hull_box);
	const f32 *margin = ts_frame_data(&run.frame, TS_B_segment_margin);
	u64 n = ts_frame_n(&run.frame, TS_B_segment_box), with_sky = 0;
	for (u64 b = 0; b < n; b++) {
		check_unparted(&run, &boxes[b]);
		with_sky += boxes[b].farthest == 1;
	}
	assert_true(n > 32 && n <= 64 && with_sky > 0 && ts_run_counter(&run, "labels") == 64);
	for (u64 i = 0; i < ts_frame_n(&run.frame, TS_B_hull_box); i++) {
		u32 x = ts_k_resample((u32)(i % params.width), params.width, params.depth_grid_px);
		u32 y = ts_k_resample((u32)(i / params.width), params.height, params.depth_grid_px);
		if (pixels[i].depth == 1) continue;
		assert_int_equal(boxes[chosen[i]].label / TS_BLOCK_TEXELS, ts_k_block_of(params.depth_grid_px, x, y));
	}
	for (u64 i = 0; i < ts_frame_n(&run.frame, TS_B_segment_margin); i++) assert_true(margin[i] > 1e6f);
	ts_run_end(&run);
	ts_scene_free(scene);
}

static u64 count_unlit(const ts_run *run)
{
	const ts_gpixel *pixels = ts_frame_data(&run->frame, TS_B_gbuffer_pixel);
	const u32 *box = ts_frame_data(&run->frame, TS_B_hull_box);
	u64 n = 0;
	for (u64 i = 0; i < ts_frame_n(&run->frame, TS_B_hull_box); i++) {
		n += pixels[i].depth < 1 && box[i] == TS_NONE;
		assert_true(pixels[i].depth < 1 || box[i] == TS_NONE);
	}
	return n;
}

/* An image larger than the grid, and not a multiple of it: some pixels no segment holds. Boxes are of their own block,
 * and hold the pixel, where the paper has one. */
static void boxes_hold_the_pixels_they_light(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	params.width = 150;
	params.height = 70;
	ts_scene *scene = small_scene(&params);
	ts_run paper, robust;
	params.hull_surface = TS_SURFACE_ROBUST;
	run_of(&robust, scene, &params, "hulls");
	params.hull_surface = TS_SURFACE_PAPER;
	run_of(&paper, scene, &params, "hulls");
	u64 n = count_unlit(&paper);
	if (!(n > 10 && n < 150 * 70 / 2)) fail_msg("%u unlit", (unsigned)n);
	assert_int_equal(count_unlit(&robust), 0);
	assert_int_equal(ts_run_counter(&paper, "pixels without a segment"), n);
	assert_int_equal(ts_run_counter(&robust, "pixels without a segment"), 0);
	const u32 *held = ts_frame_data(&paper.frame, TS_B_hull_box), *found = ts_frame_data(&robust.frame, TS_B_hull_box);
	const ts_segment *boxes = ts_frame_data(&paper.frame, TS_B_segment_box);
	const ts_gpixel *pixels = ts_frame_data(&paper.frame, TS_B_gbuffer_pixel);
	for (u32 i = 0; i < 150 * 70; i++) {
		if (held[i] == TS_NONE) continue;
		const ts_segment *box = &boxes[held[i]];
		u32 x = (u32)floor((i % 150 + 0.5) * 64 / 150), y = (u32)floor((i / 150 + 0.5) * 64 / 70);
		assert_true(held[i] == found[i] && box->label / 1024 == y / 32 * 2 + x / 32);
		assert_true(x >= box->low[0] && x <= box->high[0] && y >= box->low[1] && y <= box->high[1]);
		assert_true(pixels[i].depth >= box->nearest && pixels[i].depth <= box->farthest);
	}
	ts_run_end(&paper);
	ts_run_end(&robust);
	ts_scene_free(scene);
}

static void a_whole_grid_holds_every_pixel(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	ts_scene *scene = small_scene(&params);
	params.depth_grid_px = 128;
	params.hull_surface = TS_SURFACE_PAPER;
	ts_run run;
	run_of(&run, scene, &params, "hulls");
	assert_int_equal(count_unlit(&run), 0);
	assert_int_equal(ts_run_counter(&run, "blocks"), 16);
	assert_true(ts_run_counter(&run, "boxes") >= 14 && ts_run_counter(&run, "labels") >= ts_run_counter(&run, "boxes"));
	ts_run_end(&run);
	ts_scene_free(scene);
}

/* From outside: the scene small before the sky, with corners of boxes in it; and nothing but sky. */
static void the_sky_gathers_no_light(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	ts_scene *scene = small_scene(&params);
	scene->info.circles = 0;
	scene->info.yfov = 0.125f;
	ts_store3(scene->info.up, ts_v3_make(0, 1, 0));
	for (u32 k = 0; k < 2; k++) {
		ts_run run;
		f32 back = k == 0 ? 1 : -1; /* towards the scene, and away from it */
		ts_store3(scene->info.eye, ts_v3_make(60, 30, -2));
		ts_store3(scene->info.back, ts_v3_make(back, 0, 0));
		ts_store3(scene->info.right, ts_v3_make(0, 0, -back));
		run_of(&run, scene, &params, "hulls");
		const ts_gpixel *pixels = ts_frame_data(&run.frame, TS_B_gbuffer_pixel);
		u64 n_sky = 0, n = ts_frame_n(&run.frame, TS_B_gbuffer_pixel);
		for (u64 i = 0; i < n; i++) n_sky += pixels[i].depth == 1;
		check_light(&run);
		assert_int_equal(count_unlit(&run), 0);
		assert_true(k == 0 ? n_sky > n / 2 && n_sky < n : n_sky == n);
		assert_int_equal(ts_frame_n(&run.frame, TS_B_segment_box) == 0, k);
		ts_run_end(&run);
	}
	ts_scene_free(scene);
}

/* Each light has its maps, a point light six; a lamp that does not shine, or not in two colours, leaves those dark. */
static void each_light_has_its_maps(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	ts_scene *scene = small_scene(&params);
	ts_light *own = scene->lights, lights[3] = {{.kind = TS_LIGHT_KIND_SPOT,
	                                             .position = {0, 4, 0},
	                                             .direction = {0, -1, 0},
	                                             .intensity = {30, 0, 0},
	                                             .spot_scale = 4,
	                                             .spot_offset = -3}};
	u32 n_own = scene->n_lights;
	lights[1] = lights[2] = lights[0];
	lights[1].kind = TS_LIGHT_KIND_POINT;
	lights[2].kind = TS_LIGHT_KIND_DIRECTIONAL;
	scene->lights = lights;
	params.lamp_source = TS_LAMP_SCENE;
	params.rsm_px = 1;
	for (u32 n = 1; n <= 3; n++) {
		ts_run run;
		scene->n_lights = n;
		run_of(&run, scene, &params, "hulls");
		check_light(&run);
		const u32 views[] = {1, 7, 8};
		const ts_offscreen *view = ts_frame_data(&run.frame, TS_B_offscreen_view);
		const ts_patch *patches = ts_frame_data(&run.frame, TS_B_rsm_patch);
		assert_int_equal(ts_frame_n(&run.frame, TS_B_offscreen_view), views[n - 1]);
		assert_int_equal(ts_frame_n(&run.frame, TS_B_rsm_patch), views[n - 1]);
		for (u32 v = 0; v < views[n - 1]; v++) {
			assert_true(view[v].light == (v == 0 ? 0u : v < 7 ? 1u : 2u) && view[v].offset == v && view[v].width == 1);
			assert_true(patches[v].exitance[1] == 0 && patches[v].exitance[2] == 0);
		}
		const f32 *light = ts_frame_data(&run.frame, TS_B_indirect_irradiance);
		const ts_lobes *lobes = ts_frame_data(&run.frame, TS_B_corner_lobes);
		double red = 0;
		for (u64 i = 0; i < 100 * 54; i++) {
			red += (double)light[3 * i];
			assert_true(light[3 * i + 1] == 0 && light[3 * i + 2] == 0);
		}
		assert_true(red > 0);
		for (u64 i = 0; i < ts_frame_n(&run.frame, TS_B_corner_lobes); i++) {
			assert_true(lobes[i].mu[1] == 0 && lobes[i].lambda[1] == 1);
		}
		ts_run_end(&run);
	}
	scene->lights = own;
	scene->n_lights = n_own;
	ts_scene_free(scene);
}

/* Light of three lamps is the sum of each one's, triangle by triangle and where they have no extent; nothing of
 * reflective shadow maps is made. */
static void check_lamps(ts_scene *scene, const ts_params *params, ts_light *lights, double tolerance)
{
	ts_run all, hulls;
	effect_of(&all, scene, params, "area-light", "direct");
	effect_of(&hulls, scene, params, "area-light", "hulls");
	check_light(&all);
	check_light(&hulls);
	assert_int_equal(ts_frame_n(&all.frame, TS_B_polygon_patch), 24);
	assert_int_equal(ts_run_counter(&all, "gathers"), 100 * 54 * 24);
	assert_false(all.frame.buffer[TS_B_rsm_patch].made);
	double d = apart(&hulls, &all);
	if (!(d < tolerance)) fail_msg("lamp.radius=%g: %g", (double)params->lamp_radius, d);
	const f32 *sum = ts_frame_data(&all.frame, TS_B_indirect_irradiance);
	double off = 0, mean = 0;
	static double each[3 * 100 * 54];
	memset(each, 0, sizeof each);
	scene->n_lights = 1;
	for (u32 k = 0; k < 3; k++) {
		ts_run one;
		scene->lights = lights + k;
		effect_of(&one, scene, params, "area-light", "direct");
		const f32 *light = ts_frame_data(&one.frame, TS_B_indirect_irradiance);
		for (u32 i = 0; i < 3 * 100 * 54; i++) each[i] += (double)light[i];
		ts_run_end(&one);
	}
	for (u32 i = 0; i < 3 * 100 * 54; i++) {
		off = fmax(off, fabs(each[i] - (double)sum[i]) / (each[i] + 0.01));
		mean += each[i] / (3 * 100 * 54);
	}
	assert_true(off < 1e-5 && mean > 0.1);
	scene->lights = lights;
	scene->n_lights = 3;
	ts_run_end(&all);
	ts_run_end(&hulls);
}

static void lamps_add_up_triangle_by_triangle(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	ts_scene *scene = small_scene(&params);
	ts_light *own = scene->lights, lights[3] = {{.kind = TS_LIGHT_KIND_SPOT,
	                                             .position = {0, 4, 0},
	                                             .direction = {0, -1, 0},
	                                             .intensity = {30, 20, 10},
	                                             .spot_scale = 2,
	                                             .spot_offset = -1}};
	u32 n_own = scene->n_lights;
	lights[1] = lights[2] = lights[0];
	lights[1].kind = TS_LIGHT_KIND_POINT;
	lights[1].position[0] = 2;
	lights[2].kind = TS_LIGHT_KIND_DIRECTIONAL;
	for (u32 k = 0; k < 3; k++) lights[2].intensity[k] /= 30;
	scene->lights = lights;
	scene->n_lights = 3;
	params.lamp_source = TS_LAMP_SCENE;
	params.depth_grid_px = 256;
	static const f32 radii[] = {0, 0.02f, 0.2f};
	for (u32 i = 0; i < 3; i++) {
		params.lamp_radius = radii[i];
		check_lamps(scene, &params, lights, 0.6);
	}
	scene->lights = own;
	scene->n_lights = n_own;
	ts_scene_free(scene);
}

/* Display values of lamps are as bright as radiance says, those of a bounce eight times that. */
static void a_bounce_is_eight_times_brighter(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	ts_scene *scene = small_scene(&params);
	static const char *const effects[] = {"area-light", "indirect"};
	for (u32 k = 0; k < 2; k++) {
		ts_run run;
		effect_of(&run, scene, &params, effects[k], "direct");
		const f32 *radiance = ts_frame_data(&run.frame, TS_B_image_radiance);
		const u8 *srgb = ts_frame_data(&run.frame, TS_B_image_srgb);
		const ts_gpixel *pixels = ts_frame_data(&run.frame, TS_B_gbuffer_pixel);
		for (u64 i = 0; i < 3 * 100 * 54; i++) {
			f32 gain = k == 0 || pixels[i / 3].depth == 1 ? 1.0f : 8.0f;
			assert_int_equal(srgb[i], ts_srgb_byte(radiance[i] * gain));
		}
		ts_run_end(&run);
	}
	ts_scene_free(scene);
}

static void without_light_all_is_dark(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	params.light_irradiance = 0;
	ts_scene *scene = small_scene(&params);
	static const char *const methods[] = {"hulls", "direct"};
	for (u32 m = 0; m < 2; m++) {
		ts_run run;
		run_of(&run, scene, &params, methods[m]);
		check_light(&run);
		const f32 *light = ts_frame_data(&run.frame, TS_B_indirect_irradiance);
		for (u64 i = 0; i < ts_frame_n(&run.frame, TS_B_indirect_irradiance); i++) assert_true(light[i] == 0);
		ts_run_end(&run);
	}
	ts_scene_free(scene);
}

/* Specular reflection is added to the picture, and nothing else of that changes; the sky has none; hulls are near what
 * each pixel gathers itself. */
static void check_gloss(const ts_scene *scene, ts_params params, const char *effect)
{
	ts_run off, hulls, direct;
	effect_of(&off, scene, &params, effect, "hulls");
	params.gloss_lobe = 1;
	effect_of(&hulls, scene, &params, effect, "hulls");
	effect_of(&direct, scene, &params, effect, "direct");
	assert_false(off.frame.buffer[TS_B_indirect_specular].made || off.frame.buffer[TS_B_gloss_pixel].made);
	u64 n = ts_frame_n(&hulls.frame, TS_B_indirect_specular);
	const f32 *specular = ts_frame_data(&hulls.frame, TS_B_indirect_specular);
	const f32 *gathered = ts_frame_data(&direct.frame, TS_B_indirect_specular);
	const f32 *with = ts_frame_data(&hulls.frame, TS_B_image_radiance);
	const f32 *without = ts_frame_data(&off.frame, TS_B_image_radiance);
	const ts_gpixel *pixels = ts_frame_data(&off.frame, TS_B_gbuffer_pixel);
	const ts_gloss *gloss = ts_frame_data(&hulls.frame, TS_B_gloss_pixel);
	double difference = 0, all = 0;
	assert_true(n == 3 * 100 * 54);
	for (u64 i = 0; i < n; i++) {
		assert_true(specular[i] >= 0 && specular[i] < 1e6f && gathered[i] >= 0 && gathered[i] < 1e6f);
		assert_true(with[i] == without[i] + specular[i]);
		if (pixels[i / 3].depth == 1) assert_true(gathered[i] == 0 && gloss[i / 3].f0[i % 3] == 0);
		difference += fabs((double)specular[i] - (double)gathered[i]);
		all += (double)gathered[i];
	}
	print_message("# %s: specular reflection within %.2f\n", effect, difference / all);
	assert_true(all > 1 && difference < 0.6 * all);
	ts_run_end(&off);
	ts_run_end(&hulls);
	ts_run_end(&direct);
}

static void gloss_only_adds_to_the_picture(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	ts_scene *scene = small_scene(&params);
	params.depth_grid_px = 256;
	params.lamp_radius = 0.2f;
	check_gloss(scene, params, "indirect");
	check_gloss(scene, params, "area-light");
	ts_scene_free(scene);
}

static void assert_refused(const ts_scene *scene, const ts_params *params, const char *message)
{
	ts_run run;
	ts_run_begin(&run, scene, params, 2);
	assert_int_equal(ts_pipeline_run(ts_pipeline_find("indirect", "hulls"), &run), TS_ERROR);
	assert_string_equal(ts_error_message(), message);
	ts_run_end(&run);
}

static void a_grid_of_no_multiple_is_refused(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	ts_scene *scene = small_scene(&params);
	u32 n_own = scene->n_lights;
	params.depth_grid_px = 100;
	assert_refused(scene, &params, "stage depth_grid: depth_grid.px=100: a multiple of 32, as 96, would be right");
	params.lamp_source = TS_LAMP_SCENE;
	scene->n_lights = 0;
	assert_refused(scene, &params,
	               "stage lamp: lamp.source=scene: the scene has no lights; lamp.source=lamp would be right");
	scene->n_lights = n_own;
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(threads_change_no_bit_of_any_way),  cmocka_unit_test(hulls_are_near_what_they_stand_for),
		cmocka_unit_test(no_segment_spans_two_components),   cmocka_unit_test(unparted_blocks_have_one_box_each),
		cmocka_unit_test(boxes_hold_the_pixels_they_light),  cmocka_unit_test(a_whole_grid_holds_every_pixel),
		cmocka_unit_test(the_sky_gathers_no_light),          cmocka_unit_test(each_light_has_its_maps),
		cmocka_unit_test(without_light_all_is_dark),         cmocka_unit_test(a_grid_of_no_multiple_is_refused),
		cmocka_unit_test(lamps_add_up_triangle_by_triangle), cmocka_unit_test(a_bounce_is_eight_times_brighter),
		cmocka_unit_test(gloss_only_adds_to_the_picture),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

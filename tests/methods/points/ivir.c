/* iVIR, VIR and shadows from depth maps as whole runs: the same bits on any number of threads, in passes of any size
 * and with points stored or not; the counters; the papers' claims that hold for every scene; and what is refused. */
#include <math.h>
#include "kernels/base/area.h"
#include "kernels/base/shade.h"
#include "tests/methods/small.h"
#include "trace/emitted/sums.h"

#define SHADOWED "soft-shadows", "ivir"

static ts_params tiny_params(void)
{
	ts_params params = small_params(64, 36);
	params.depth_map_px = 32;
	params.cube_max_px = 16;
	params.lamp_views = 7;
	params.lamp_views_a_pass = 3;
	params.lamp_cubes = 3;
	params.reflectors_count = 2;
	return params;
}

static ts_sums sums_of(const ts_scene *scene, const ts_params *params, const char *effect, const char *method,
                       ts_how how)
{
	ts_sums sums;
	if (ts_sums_of(&sums, ts_pipeline_find(effect, method), scene, params, &how) != TS_OK) {
		fail_msg("%s by %s: %s", effect, method, ts_error_message());
	}
	return sums;
}

/* Returns how many buffers were made. */
static u32 assert_same(const ts_sums *a, const ts_sums *b, const char *what)
{
	u32 n = 0;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		if (strcmp(a->hex[id], b->hex[id]) != 0) fail_msg("%s: %s", what, ts_buffer_table[id].name);
		n += a->hex[id][0] != 0;
	}
	return n;
}

static const char *const methods[][2] = {
	{"soft-shadows", "ivir"}, {"omni-shadows", "ivir"}, {"soft-shadows", "mvr"},
	{"omni-shadows", "mvr"},  {"omni-shadows", "vir"},  {"reflections", "ivir"},
};

/* Every buffer, whatever computes it: threads, and without the fast paths. */
static void threads_and_fast_paths_change_no_bit(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	ts_scene *scene = small_scene(&params);
	for (u32 m = 0; m < sizeof methods / sizeof *methods; m++) {
		const char *effect = methods[m][0], *method = methods[m][1];
		ts_sums two = sums_of(scene, &params, effect, method, (ts_how){.threads = 2});
		ts_sums seven = sums_of(scene, &params, effect, method, (ts_how){.threads = 7});
		ts_sums reference = sums_of(scene, &params, effect, method, (ts_how){.threads = 1, .no_fast_paths = true});
		assert_true(assert_same(&two, &seven, method) >= 6);
		assert_same(&two, &reference, "one thread without fast paths");
	}
	ts_scene_free(scene);
}

static void assert_same_buffers(const ts_sums *a, const ts_sums *b, const ts_buffer_id *ids, const char *what)
{
	for (; *ids != TS_N_BUFFERS; ids++) {
		assert_true(a->hex[*ids][0] != 0);
		if (strcmp(a->hex[*ids], b->hex[*ids]) != 0) fail_msg("%s: %s", what, ts_buffer_table[*ids].name);
	}
}

/* However many depth maps a pass makes, and whether its points are stored: the same pieces, maps and shadows. */
static void the_size_of_a_pass_changes_nothing(void **state)
{
	(void)state;
	static const ts_buffer_id ids[] = {TS_B_split_piece,     TS_B_split_density,   TS_B_cull_keep, TS_B_align_frame,
	                                   TS_B_depth_map_depth, TS_B_shadow_test_lit, TS_N_BUFFERS};
	ts_params params = tiny_params();
	ts_scene *scene = small_scene(&params);
	params.lamp_views = 20;
	params.lamp_cubes = 4;
	for (u32 m = 0; m < 2; m++) {
		params.lamp_views_a_pass = 32;
		ts_sums all = sums_of(scene, &params, methods[m][0], "ivir", (ts_how){.threads = 2});
		params.lamp_views_a_pass = 8;
		ts_sums some = sums_of(scene, &params, methods[m][0], "ivir", (ts_how){.threads = 2});
		assert_same_buffers(&all, &some, ids, "pass");
		params.points_buffered = TS_BUFFERED_ON;
		ts_sums stored = sums_of(scene, &params, methods[m][0], "ivir", (ts_how){.threads = 2});
		assert_same_buffers(&all, &stored, ids, "buffered");
		assert_true(stored.hex[TS_B_points_record][0] != 0 && all.hex[TS_B_points_record][0] == 0);
		params.points_buffered = TS_BUFFERED_DEFAULT;
	}
	ts_scene_free(scene);
}

static void run_of(ts_run *run, const ts_scene *scene, const ts_params *params, const char *effect, const char *method)
{
	ts_run_begin(run, scene, params, 2);
	if (ts_pipeline_run(ts_pipeline_find(effect, method), run) != TS_OK) {
		fail_msg("%s by %s: %s", effect, method, ts_error_message());
	}
}

/* Beside the eye MVR goes over the geometry once a view, iVIR once a pass; stored points are as many as those made. */
static void each_pass_goes_over_the_geometry_once(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	ts_scene *scene = small_scene(&params);
	ts_run mvr, made, stored;
	run_of(&mvr, scene, &params, "soft-shadows", "mvr");
	run_of(&made, scene, &params, "soft-shadows", "ivir");
	params.points_buffered = TS_BUFFERED_ON;
	run_of(&stored, scene, &params, "soft-shadows", "ivir");
	assert_int_equal(ts_run_counter(&mvr, "geometry traversals"), 1 + params.lamp_views);
	assert_int_equal(ts_run_counter(&made, "geometry traversals"),
	                 1 + (params.lamp_views + params.lamp_views_a_pass - 1) / params.lamp_views_a_pass);
	assert_int_equal(ts_run_counter(&stored, "points"), (i64)ts_frame_n(&stored.frame, TS_B_points_record));
	static const char *const same[] = {"points", "pieces", "pieces kept", "point-view scatters", "texel writes"};
	for (u32 k = 0; k < 5; k++) {
		assert_true(ts_run_counter(&made, same[k]) > 0);
		assert_int_equal(ts_run_counter(&made, same[k]), ts_run_counter(&stored, same[k]));
	}
	assert_true(ts_run_counter(&made, "texel writes") <= ts_run_counter(&made, "point-view scatters"));
	ts_run_end(&mvr);
	ts_run_end(&made);
	ts_run_end(&stored);
	ts_scene_free(scene);
}

/* Share of the pixels' light samples of which two runs say different things. */
static double difference(const ts_run *a, const ts_run *b, u32 samples)
{
	const u32 *p = ts_frame_data(&a->frame, TS_B_shadow_test_lit), *q = ts_frame_data(&b->frame, TS_B_shadow_test_lit);
	u64 n = ts_frame_n(&a->frame, TS_B_shadow_test_lit), sum = 0, lit = 0;
	assert_true(n > 0 && n == ts_frame_n(&b->frame, TS_B_shadow_test_lit));
	for (u64 i = 0; i < n; i++) {
		assert_true(p[i] <= samples && q[i] <= samples);
		sum += p[i] > q[i] ? p[i] - q[i] : q[i] - p[i];
		lit += p[i];
	}
	assert_true(lit > 0 && lit < n * samples);
	return (double)sum / (double)(n * samples);
}

/* Watertight points cast the shadows that MVR's triangles do, but for what is a texel wide. */
static void watertight_points_cast_the_shadows_of_mvr(void **state)
{
	(void)state;
	static const char *const effects[] = {"soft-shadows", "omni-shadows"};
	ts_params params = tiny_params();
	params.depth_map_px = 64;
	params.points_cull = 0;
	ts_scene *scene = small_scene(&params);
	for (u32 e = 0; e < 2; e++) {
		u32 samples = e == 0 ? params.lamp_views : params.lamp_cubes;
		ts_run mvr, ivir;
		run_of(&mvr, scene, &params, effects[e], "mvr");
		run_of(&ivir, scene, &params, effects[e], "ivir");
		double share = difference(&mvr, &ivir, samples);
		print_message("%s: %.4f\n", effects[e], share);
		assert_true(share < 0.06);
		ts_run_end(&mvr);
		ts_run_end(&ivir);
	}
	ts_scene_free(scene);
}

static i64 points_of(const ts_scene *scene, const ts_params *params, const char *effect, const char *method)
{
	ts_run run;
	run_of(&run, scene, params, effect, method);
	i64 n = ts_run_counter(&run, "points");
	ts_run_end(&run);
	return n;
}

/* The paper's rate makes no more points than VIR's, far fewer for environment maps, which only iVIR sizes as the image
 * asks for; culling saves some. */
static void the_papers_rate_makes_fewer_points(void **state)
{
	(void)state;
	static const char *const effects[] = {"soft-shadows", "omni-shadows", "reflections"};
	ts_params params = tiny_params();
	params.density_rate = TS_DENSITY_RATE_PAPER;
	params.cube_max_px = 64;
	ts_scene *scene = small_scene(&params);
	for (u32 e = 0; e < 3; e++) {
		params.points_cull = 1;
		i64 ivir = points_of(scene, &params, effects[e], "ivir"), vir = points_of(scene, &params, effects[e], "vir");
		params.points_cull = 0;
		i64 all = points_of(scene, &params, effects[e], "ivir");
		print_message("%s: %lld of %lld points, %lld without culling\n", effects[e], (long long)ivir, (long long)vir,
		              (long long)all);
		assert_true(ivir > 0 && ivir <= vir && ivir <= all);
		if (e == 2) assert_true(ivir * 2 <= vir);
	}
	ts_scene_free(scene);
}

/* Pieces of A samples stay with probability min(1, 10 A): their number is the sum of that, within four standard
 * deviations. */
static void culling_keeps_as_many_as_expected(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	ts_scene *scene = small_scene(&params);
	params.depth_map_px = 16;
	ts_run run;
	run_of(&run, scene, &params, "soft-shadows", "ivir");
	const ts_piece *pieces = ts_frame_data(&run.frame, TS_B_split_piece);
	const f32 *scale = ts_frame_data(&run.frame, TS_B_split_density);
	double expected = 0, variance = 0;
	for (u64 i = 0; i < ts_frame_n(&run.frame, TS_B_split_piece); i++) {
		const ts_piece *p = &pieces[i];
		double area = ts_k_area(ts_load3(p->a), ts_load3(p->b), ts_load3(p->c)), s = scale[i];
		double share = fmin(10 * area * s * s, 1);
		expected += share;
		variance += share * (1 - share);
	}
	double kept = (double)ts_run_counter(&run, "pieces kept");
	assert_true(variance > 30 && fabs(kept - expected) <= 4 * sqrt(variance));
	ts_run_end(&run);
	ts_scene_free(scene);
}

/* The radiance of mirrors as a display would show it, and the number of its values. */
static f32 *shown(const ts_scene *scene, const ts_params *params, const char *method, u64 *n)
{
	ts_run run;
	run_of(&run, scene, params, "reflections", method);
	const f32 *radiance = ts_frame_data(&run.frame, TS_B_shade_radiance);
	*n = ts_frame_n(&run.frame, TS_B_shade_radiance);
	f32 *values = malloc(*n * sizeof *values);
	assert_non_null(values);
	for (u64 i = 0; i < *n; i++) values[i] = radiance[i] * params->image_exposure;
	ts_run_end(&run);
	return values;
}

/* What is much brighter than the display's white stays white in a mirror, whatever the mirror's tint: codes of colours
 * have room above white for the tint. */
static void white_stays_white_in_a_mirror(void **state)
{
	(void)state;
	static const char *const coded[] = {"ivir", "vir"};
	ts_params params = tiny_params();
	params.image_exposure = 256;
	params.reflectors_count = 8; /* the tints that a scene's mirrors have */
	ts_scene *scene = small_scene(&params);
	u64 n;
	f32 *mvr = shown(scene, &params, "mvr", &n);
	for (u32 m = 0; m < 2; m++) {
		u64 n_white = 0, n_coded;
		f32 *values = shown(scene, &params, coded[m], &n_coded);
		assert_true(n_coded == n);
		for (u64 i = 0; i < n; i++) {
			if (mvr[i] < 8) continue;
			assert_true(values[i] >= 1);
			n_white++;
		}
		print_message("%s: %llu of %llu values are white\n", coded[m], (unsigned long long)n_white,
		              (unsigned long long)n);
		assert_true(n_white > n / 2);
		free(values);
	}
	free(mvr);
	ts_scene_free(scene);
}

/* In light that a display can show mirrors are as bright as MVR's, however much room the codes have. */
static void headroom_keeps_the_brightness_of_mirrors(void **state)
{
	(void)state;
	const f32 headrooms[] = {1, 2, 16};
	ts_params params = tiny_params();
	ts_scene *scene = small_scene(&params);
	u64 n;
	f32 *mvr = shown(scene, &params, "mvr", &n);
	for (u32 h = 0; h < 3; h++) {
		params.scatter_headroom = headrooms[h];
		f32 *values = shown(scene, &params, "vir", &n);
		double sum = 0, expected = 0;
		for (u64 i = 0; i < n; i++) sum += values[i], expected += mvr[i];
		print_message("scatter.headroom=%g: %.4f of the radiance by MVR\n", (double)headrooms[h], sum / expected);
		assert_true(fabs(sum / expected - 1) < 0.05);
		free(values);
	}
	free(mvr);
	ts_scene_free(scene);
}

/* Gives the scene n lights of every kind. */
static void give_lights(ts_scene *scene, ts_light *lights, u32 n)
{
	for (u32 i = 0; i < n; i++) {
		lights[i] = (ts_light){.kind = i % 3,
		                       .direction = {0.6f, -0.8f, 0},
		                       .position = {(f32)i, 8, 0},
		                       .intensity = {1, 1, 1},
		                       .spot_scale = 4,
		                       .spot_offset = -3};
	}
	scene->lights = lights;
	scene->n_lights = n;
}

/* The scene's lights share the views evenly, each with maps of its own; what they say is theirs. */
static void lights_share_their_views_evenly(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	ts_scene *scene = small_scene(&params);
	ts_light *own = scene->lights, lights[5];
	u32 n_own = scene->n_lights;
	params.lamp_source = TS_LAMP_SCENE;
	for (u32 n = 1; n <= 5; n += 2) {
		ts_run run;
		give_lights(scene, lights, n);
		run_of(&run, scene, &params, SHADOWED);
		const ts_lamp *lamps = ts_frame_data(&run.frame, TS_B_lamp_shape);
		const ts_offscreen *views = ts_frame_data(&run.frame, TS_B_offscreen_view);
		const u32 *lit = ts_frame_data(&run.frame, TS_B_shadow_test_lit);
		u32 next = 0;
		assert_int_equal(ts_frame_n(&run.frame, TS_B_lamp_shape), n);
		for (u32 i = 0; i < n; i++) {
			assert_true(lamps[i].first == next && lamps[i].samples >= params.lamp_views / n);
			assert_true(lamps[i].samples <= (params.lamp_views + n - 1) / n);
			next += lamps[i].samples;
			for (u32 v = lamps[i].first; v < next; v++) {
				assert_true(views[v].light == i &&
				            views[v].orthographic == (lights[i].kind == TS_LIGHT_KIND_DIRECTIONAL));
				assert_true(views[v].offset == (u64)v * params.depth_map_px * params.depth_map_px);
			}
		}
		assert_int_equal(next, params.lamp_views);
		assert_int_equal(ts_frame_n(&run.frame, TS_B_shadow_test_lit), (u64)params.width * params.height * n);
		for (u64 k = 0; k < (u64)params.width * params.height * n; k++) assert_true(lit[k] <= lamps[k % n].samples);
		ts_run_end(&run);
	}
	scene->lights = own;
	scene->n_lights = n_own;
	ts_scene_free(scene);
}

static void assert_refused(const ts_scene *scene, const ts_params *params, const char *message)
{
	ts_run run;
	ts_run_begin(&run, scene, params, 2);
	assert_int_equal(ts_pipeline_run(ts_pipeline_find(SHADOWED), &run), TS_ERROR);
	assert_string_equal(ts_error_message(), message);
	ts_run_end(&run);
}

/* In one line: what, where, and what would be right. */
static void lights_without_a_view_are_refused(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	ts_scene *scene = small_scene(&params);
	ts_light *own = scene->lights, lights[4];
	u32 n_own = scene->n_lights;
	params.lamp_source = TS_LAMP_SCENE;
	give_lights(scene, lights, 0);
	assert_refused(scene, &params,
	               "stage lamp: lamp.source=scene: the scene has no lights; lamp.source=lamp would be right");
	give_lights(scene, lights, 4);
	params.lamp_views = 3;
	assert_refused(scene, &params, "stage lamp: lamp.views=3: at least 4, one a light, would be right");
	scene->lights = own;
	scene->n_lights = n_own;
	ts_scene_free(scene);
}

/* VIR's points about a light grow with the texels of its cube, two of them each, whatever the triangles. */
static void points_about_a_light_are_expected_by_its_texels(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	ts_scene *scene = small_scene(&params);
	u64 points[2];
	for (u32 i = 0; i < 2; i++) {
		params.depth_map_px = i == 0 ? 64 : 512;
		ts_expected expected = ts_pipeline_expect(ts_pipeline_find("omni-shadows", "vir"), scene, &params);
		points[i] = expected.sizes.n[TS_DIM_points];
	}
	assert_int_equal(points[1] - points[0], 2 * 6 * (512 * 512 - 64 * 64));
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(threads_and_fast_paths_change_no_bit),
		cmocka_unit_test(the_size_of_a_pass_changes_nothing),
		cmocka_unit_test(each_pass_goes_over_the_geometry_once),
		cmocka_unit_test(watertight_points_cast_the_shadows_of_mvr),
		cmocka_unit_test(the_papers_rate_makes_fewer_points),
		cmocka_unit_test(culling_keeps_as_many_as_expected),
		cmocka_unit_test(lights_share_their_views_evenly),
		cmocka_unit_test(lights_without_a_view_are_refused),
		cmocka_unit_test(points_about_a_light_are_expected_by_its_texels),
		cmocka_unit_test(white_stays_white_in_a_mirror),
		cmocka_unit_test(headroom_keeps_the_brightness_of_mirrors),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

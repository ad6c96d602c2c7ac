/* EPR's variants as whole runs: without buffers of points every buffer that both have is the same; with cubes of
 * colours a texel has the colour of the point that EPR's texel names, and one mirror shows what EPR shows; without the
 * texels that nobody reads the picture is the same. */
#include <math.h>
#include "kernels/points/forward.h"
#include "tests/methods/small.h"
#include "trace/emitted/sums.h"

static ts_sums sums_of(const ts_scene *scene, const ts_params *params, const char *method, ts_how how)
{
	ts_sums sums;
	if (ts_sums_of(&sums, ts_pipeline_find("reflections", method), scene, params, &how) != TS_OK) {
		fail_msg("%s: %s", method, ts_error_message());
	}
	return sums;
}

/* What a run was asked for: a scene, and parameters by name. */
typedef struct {
	const char *scene;
	const char *set[6][2];
} setting;

static const setting settings[] = {
	{"atrium:triangles=10000:texels=32", {{"reflectors.count", "4"}}},
	{"atrium:triangles=10000:texels=32", {{"reflectors.count", "0"}}},
	{"gallery:triangles=10000:texels=32",
     {{"reflectors.count", "3"}, {"lookup.bounces", "3"}, {"seed", "5"}, {"splat.box", "touched"}}},
	{"dining:triangles=10000:texels=32",
     {{"reflectors.count", "3"}, {"lookup.bounces", "2"}, {"points.conservative", "off"}, {"points.cull", "off"}}},
	{"gallery:triangles=10000:texels=32",
     {{"reflectors.count", "2"}, {"points.split", "off"}, {"density.scale", "2"}, {"lookup.samples", "adaptive"}}},
	{"atrium:triangles=10000:texels=32",
     {{"reflectors.count", "3"},
      {"splat.plane_depth", "on"},
      {"splat.clip", "off"},
      {"splat.size", "paper"},
      {"lookup.bounces", "3"},
      {"points.conservative", "exact"}}},
	{"scenes/room.gltf", {{"reflectors.count", "1"}, {"lookup.bounces", "2"}}},
};

static ts_params params_of(const setting *s)
{
	ts_params params = small_params(64, 36);
	params.cube_max_px = 32;
	params.reflectors_px = 24;
	for (u32 i = 0; i < 6 && s->set[i][0] != NULL; i++) {
		assert_int_equal(ts_params_set(&params, s->set[i][0], s->set[i][1]), TS_OK);
	}
	return params;
}

static ts_scene *scene_of(const setting *s, const ts_params *params)
{
	ts_scene *scene;
	if (ts_scene_load(&scene, s->scene, params, NULL) != TS_OK) fail_msg("%s", ts_error_message());
	return scene;
}

/* All that EPR makes but the points themselves, bit for bit. */
static void assert_same(const ts_sums *epr, const ts_sums *without, const char *scene)
{
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		bool stored = id == TS_B_points_record || id == TS_B_points_key;
		if (stored && without->hex[id][0] != 0) fail_msg("%s was stored", ts_buffer_table[id].name);
		if (stored || strcmp(epr->hex[id], without->hex[id]) == 0) continue;
		fail_msg("%s: %s", scene, ts_buffer_table[id].name);
	}
	assert_true(without->hex[TS_B_splat_depth_index][0] != 0 && without->hex[TS_B_image_srgb][0] != 0);
}

static void buffers_without_points_are_the_same(void **state)
{
	(void)state;
	for (u32 i = 0; i < sizeof settings / sizeof *settings; i++) {
		ts_params params = params_of(&settings[i]);
		ts_scene *scene = scene_of(&settings[i], &params);
		ts_sums epr = sums_of(scene, &params, "epr", (ts_how){.threads = 2});
		ts_sums fast = sums_of(scene, &params, "epr-bufferless", (ts_how){.threads = 2});
		ts_sums plain = sums_of(scene, &params, "epr-bufferless", (ts_how){.threads = 3, .no_fast_paths = true});
		ts_sums arrival = sums_of(scene, &params, "epr-bufferless", (ts_how){.threads = 2, .arrival = true});
		assert_same(&epr, &fast, settings[i].scene);
		assert_same(&epr, &plain, "without fast paths");
		assert_same(&epr, &arrival, "points have one order where none is stored");
		ts_scene_free(scene);
	}
}

static void each_variant_counts_the_same_work(void **state)
{
	(void)state;
	static const char *const same[] = {"points",   "point-view scatters", "texel writes",
	                                   "look-ups", "shading operations",  "distinct points shaded"};
	ts_params params = params_of(&settings[2]);
	ts_scene *scene = scene_of(&settings[2], &params);
	ts_run epr, without, forward;
	small_run(&epr, scene, &params, "epr", 2, NULL, NULL);
	small_run(&without, scene, &params, "epr-bufferless", 2, NULL, NULL);
	small_run(&forward, scene, &params, "epr-forward", 2, NULL, NULL);
	for (u32 i = 0; i < sizeof same / sizeof *same; i++) {
		assert_true(ts_run_counter(&epr, same[i]) > 0);
		assert_int_equal(ts_run_counter(&epr, same[i]), ts_run_counter(&without, same[i]));
	}
	for (u32 i = 0; i < 3; i++) assert_int_equal(ts_run_counter(&epr, same[i]), ts_run_counter(&forward, same[i]));
	assert_int_equal(ts_run_counter(&forward, "shading operations"), ts_run_counter(&forward, "points"));
	ts_run_end(&epr);
	ts_run_end(&without);
	ts_run_end(&forward);
	ts_scene_free(scene);
}

static bool has_counter(const ts_run *run, const char *name)
{
	for (u32 i = 0; i < run->n_counters; i++) {
		if (strcmp(run->counters[i].name, name) == 0) return true;
	}
	return false;
}

static void assert_equal_buffers(const ts_run *a, const ts_run *b, ts_buffer_id id, const char *scene)
{
	u64 n = ts_frame_n(&a->frame, id);
	assert_true(n > 0 && ts_frame_n(&b->frame, id) == n);
	if (memcmp(ts_frame_data(&a->frame, id), ts_frame_data(&b->frame, id), n * ts_buffer_table[id].element_bytes) != 0)
		fail_msg("%s: %s", scene, ts_buffer_table[id].name);
}

/* Where nobody looks at the texels, those that are not read are left out: with later bounces, or where they stay, all
 * are made. */
static void texels_that_nobody_reads_are_left_out(void **state)
{
	(void)state;
	for (u32 i = 0; i < 2 * sizeof settings / sizeof *settings; i++) {
		ts_params params = params_of(&settings[i / 2]);
		ts_scene *scene = scene_of(&settings[i / 2], &params);
		ts_run run, whole;
		small_run(&whole, scene, &params, "epr", 2, NULL, NULL);
		ts_run_begin(&run, scene, &params, 2);
		run.lean = run.asked = run.keep[TS_B_lookup_point] = true;
		run.keep[TS_B_splat_depth_index] = i % 2 != 0;
		assert_int_equal(ts_pipeline_run(ts_pipeline_find("reflections", "epr"), &run), TS_OK);
		bool counts = i % 2 != 0 || TS_PARAM(&params, lookup_bounces) > 1;
		assert_true(counts == has_counter(&run, "texel writes") && counts == has_counter(&run, "point-view scatters"));
		if (params.reflectors_count > 0) assert_equal_buffers(&run, &whole, TS_B_lookup_point, settings[i / 2].scene);
		assert_equal_buffers(&run, &whole, TS_B_image_srgb, settings[i / 2].scene);
		ts_run_end(&run);
		ts_run_end(&whole);
		ts_scene_free(scene);
	}
}

/* A texel has the distance that EPR's has, and the colour of the point that EPR's names, or of another of that distance
 * and a lower code. */
static void assert_texels(const ts_run *epr, const ts_run *forward)
{
	const u64 *indices = ts_frame_data(&epr->frame, TS_B_splat_depth_index);
	const u64 *colours = ts_frame_data(&forward->frame, TS_B_splat_depth_colour);
	const u32 *lit = ts_frame_data(&forward->frame, TS_B_forward_colour);
	const u8 *ties = ts_frame_data(&epr->frame, TS_B_splat_tie);
	u64 n = ts_frame_n(&epr->frame, TS_B_splat_depth_index), n_held = 0, n_tied = 0;
	assert_int_equal(ts_frame_n(&forward->frame, TS_B_splat_depth_colour), n);
	for (u64 i = 0; i < n; i++) {
		assert_true(colours[i] >> 32 == indices[i] >> 32);
		if (indices[i] == TS_EMPTY) continue;
		u32 of_point = lit[(u32)indices[i]], held = (u32)colours[i];
		assert_true(held == of_point || (ties[i] != 0 && held < of_point));
		n_held++;
		n_tied += held != of_point;
	}
	bool plane = TS_PARAM(&epr->params, splat_plane_depth) != 0; /* ties often */
	assert_true(n_held > n / 8 && (plane || n_tied < n_held / 20));
}

static void forward_texels_have_the_colours_of_points(void **state)
{
	(void)state;
	for (u32 i = 0; i < sizeof settings / sizeof *settings; i++) {
		ts_params params = params_of(&settings[i]);
		if (params.reflectors_count == 0) continue;
		ts_scene *scene = scene_of(&settings[i], &params);
		ts_run epr, forward;
		ts_run_begin(&epr, scene, &params, 2);
		epr.traced = true;
		assert_int_equal(ts_pipeline_run(ts_pipeline_find("reflections", "epr"), &epr), TS_OK);
		small_run(&forward, scene, &params, "epr-forward", 2, NULL, NULL);
		assert_texels(&epr, &forward);
		ts_run_end(&epr);
		ts_run_end(&forward);
		ts_scene_free(scene);
	}
}

/* Nothing in the cubes or behind them tells how points were numbered. */
static void forward_cubes_do_not_tell_the_order(void **state)
{
	(void)state;
	static const ts_buffer_id free_of_order[] = {TS_B_splat_depth_colour, TS_B_lookup_colour, TS_B_shade_radiance,
	                                             TS_B_image_srgb, TS_N_BUFFERS};
	ts_params params = params_of(&settings[5]);
	ts_scene *scene = scene_of(&settings[5], &params);
	ts_sums ordered = sums_of(scene, &params, "epr-forward", (ts_how){.threads = 2});
	ts_sums plain = sums_of(scene, &params, "epr-forward", (ts_how){.threads = 1, .no_fast_paths = true});
	ts_sums arrival = sums_of(scene, &params, "epr-forward", (ts_how){.threads = 3, .arrival = true});
	for (u32 id = 0; id < TS_N_BUFFERS; id++) assert_string_equal(ordered.hex[id], plain.hex[id]);
	for (const ts_buffer_id *id = free_of_order; *id != TS_N_BUFFERS; id++) {
		assert_true(ordered.hex[*id][0] != 0);
		assert_string_equal(ordered.hex[*id], arrival.hex[*id]);
	}
	ts_scene_free(scene);
}

/* Of one mirror all points are lit towards its centre, as EPR lights them: pixels differ by what 9 bits leave of the
 * brightest channel, half of 1/256, and where texels were tied. */
static void forward_shows_one_mirror_as_epr_does(void **state)
{
	(void)state;
	ts_params params = small_params(96, 54);
	params.reflectors_count = 1;
	params.reflectors_px = 40;
	ts_scene *scene = small_scene(&params);
	ts_run epr, forward;
	small_run(&epr, scene, &params, "epr", 2, NULL, NULL);
	small_run(&forward, scene, &params, "epr-forward", 2, NULL, NULL);
	const f32 *a = ts_frame_data(&epr.frame, TS_B_shade_radiance);
	const f32 *b = ts_frame_data(&forward.frame, TS_B_shade_radiance);
	u64 n = ts_frame_n(&epr.frame, TS_B_shade_radiance) / 3, n_apart = 0;
	assert_true(n > 300 && n == ts_frame_n(&forward.frame, TS_B_shade_radiance) / 3);
	for (u64 i = 0; i < n; i++) {
		f32 most = fmaxf(a[3 * i], fmaxf(a[3 * i + 1], a[3 * i + 2])), apart = 0;
		for (u32 c = 0; c < 3; c++) apart = fmaxf(apart, fabsf(a[3 * i + c] - b[3 * i + c]));
		n_apart += apart > most / 256;
	}
	assert_true(n_apart * 50 < n);
	ts_run_end(&epr);
	ts_run_end(&forward);
	ts_scene_free(scene);
}

typedef struct {
	u64 n, empty;
	i64 culled;
} texel_count;

static texel_count texels_of(const ts_scene *scene, const ts_params *params)
{
	ts_run run;
	small_run(&run, scene, params, "epr", 2, NULL, NULL);
	const u64 *texels = ts_frame_data(&run.frame, TS_B_splat_depth_index);
	texel_count r = {.n = ts_frame_n(&run.frame, TS_B_splat_depth_index),
	                 .culled = ts_run_counter(&run, "pieces culled")};
	for (u64 i = 0; i < r.n; i++) r.empty += texels[i] == TS_EMPTY;
	ts_run_end(&run);
	return r;
}

/* Culling leaves a texel empty with the paper's probability, 5 in 100,000, however high the density: a cube limits the
 * density, so a higher density.scale alone does not make what culling keeps denser. Below 1 that holds in the eye's
 * pixels; the raster's samples, which are larger, cull more. */
static void density_makes_no_holes(void **state)
{
	(void)state;
	static const f32 densities[] = {0.25f, 0.5f, 1, 2, 4, 8};
	ts_params params = params_of(&settings[0]);
	ts_scene *scene = scene_of(&settings[0], &params);
	i64 last = 0;
	for (u32 i = 0; i < 12; i++) {
		params.density_scale = densities[i / 2];
		params.points_cull_unit = i % 2;
		if (params.density_scale < 1 && params.points_cull_unit == TS_CULL_RASTER) {
			assert_true(texels_of(scene, &params).culled > last);
			continue;
		}
		params.points_cull = 0;
		texel_count all = texels_of(scene, &params);
		params.points_cull = 1;
		texel_count culled = texels_of(scene, &params);
		print_message(
			"density.scale=%g, unit %u: %lld pieces culled, %llu of %llu texels empty, %llu without culling\n",
			(double)params.density_scale, i % 2, (long long)culled.culled, (unsigned long long)culled.empty,
			(unsigned long long)culled.n, (unsigned long long)all.empty);
		assert_true(all.culled == 0 && culled.culled > 0 && culled.n == all.n);
		last = culled.culled;
		assert_true((culled.empty - all.empty) * 20000 <= all.n - all.empty);
	}
	ts_scene_free(scene);
}

/* The second reading of the limit, density.cap=greatest, is the weaker one. If all cubes have the greatest side, both
 * readings are the same. */
static void the_second_reading_limits_less(void **state)
{
	(void)state;
	ts_params params = params_of(&settings[0]);
	params.reflectors_px = 10; /* cubes smaller than the greatest */
	params.width = 128;
	params.height = 72;
	ts_scene *scene = scene_of(&settings[0], &params);
	ts_sums sums[3];
	i64 points[3], limited[3];
	for (u32 cap = 0; cap < 3; cap++) {
		ts_run run;
		params.density_cap = cap;
		small_run(&run, scene, &params, "epr", 2, NULL, NULL);
		points[cap] = ts_run_counter(&run, "points");
		limited[cap] = ts_run_counter(&run, "density.limited");
		ts_run_end(&run);
		params.cube_px = 32;
		sums[cap] = sums_of(scene, &params, "epr", (ts_how){.threads = 2});
		params.cube_px = 0;
	}
	print_message("off, on, greatest: %lld, %lld, %lld points\n", (long long)points[0], (long long)points[1],
	              (long long)points[2]);
	assert_true(points[TS_DENSITY_CAP_ON] < points[TS_DENSITY_CAP_GREATEST]);
	assert_true(points[TS_DENSITY_CAP_GREATEST] < points[TS_DENSITY_CAP_OFF]);
	assert_true(limited[TS_DENSITY_CAP_OFF] == 0 && limited[TS_DENSITY_CAP_GREATEST] > 0);
	assert_true(limited[TS_DENSITY_CAP_GREATEST] < limited[TS_DENSITY_CAP_ON]);
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		assert_string_equal(sums[TS_DENSITY_CAP_ON].hex[id], sums[TS_DENSITY_CAP_GREATEST].hex[id]);
	}
	ts_scene_free(scene);
}

static u64 points_expected(const ts_scene *scene, const ts_params *params)
{
	return ts_pipeline_expect(ts_pipeline_find("reflections", "epr"), scene, params).sizes.n[TS_DIM_points];
}

/* As many points are expected of a density per area as of its root per side. */
static void density_per_area_expects_as_many_points(void **state)
{
	(void)state;
	ts_params params = params_of(&settings[0]);
	ts_scene *scene = scene_of(&settings[0], &params);
	params.density_cap = TS_DENSITY_CAP_OFF;
	for (u32 i = 0; i < 3; i++) {
		f32 side = (f32)(1u << i) * 0.5f;
		params.density_scale = side;
		params.density_per_area = 0;
		u64 expected = points_expected(scene, &params);
		params.density_scale = side * side;
		params.density_per_area = 1;
		assert_true(expected > 2 * (u64)scene->n_triangles && points_expected(scene, &params) == expected);
	}
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest epr[] = {
		cmocka_unit_test(buffers_without_points_are_the_same),
		cmocka_unit_test(each_variant_counts_the_same_work),
		cmocka_unit_test(texels_that_nobody_reads_are_left_out),
		cmocka_unit_test(forward_texels_have_the_colours_of_points),
		cmocka_unit_test(forward_cubes_do_not_tell_the_order),
		cmocka_unit_test(forward_shows_one_mirror_as_epr_does),
		cmocka_unit_test(density_makes_no_holes),
		cmocka_unit_test(the_second_reading_limits_less),
		cmocka_unit_test(density_per_area_expects_as_many_points),
	};
	return cmocka_run_group_tests(epr, NULL, NULL);
}

/* Glowing particles: where they are and what they send; the same bits on any number of threads; light of all of them
 * against a sum in double precision; shadows that only take light away, by shared maps as by maps of their own; nothing
 * culled; every stage from what it claims to read. */
#include <math.h>
#include "scene/view.h"
#include "tests/methods/small.h"
#include "trace/emitted/sums.h"

static const char *const methods[] = {"megaviews", "manylods", "bruteforce"};
enum { N_METHODS = 3 };

static ts_params tiny_params(void)
{
	ts_params params = small_params(48, 26);
	params.reflectors_count = 0;
	params.octree_levels = 5;
	params.particle_count = 150;
	return params;
}

static void run_of(ts_run *run, const ts_scene *scene, const ts_params *params, const char *method)
{
	ts_run_begin(run, scene, params, 2);
	if (ts_pipeline_run(ts_pipeline_find("particles", method), run) != TS_OK)
		fail_msg("%s: %s", method, ts_error_message());
}

static void sums_of(ts_sums *sums, const ts_scene *scene, const ts_params *params, const char *method, u32 threads)
{
	const ts_how how = {.threads = threads};
	ts_status status = ts_sums_of(sums, ts_pipeline_find("particles", method), scene, params, &how);
	if (status != TS_OK) fail_msg("%s: %s", method, ts_error_message());
	assert_int_equal(strlen(sums->hex[TS_B_indirect_irradiance]), 64);
}

static void threads_change_no_particle(void **state)
{
	(void)state;
	static ts_sums one, seven;
	ts_params params = tiny_params();
	ts_scene *scene = small_scene(&params);
	for (u32 m = 0; m < N_METHODS; m++) {
		sums_of(&one, scene, &params, methods[m], 1);
		sums_of(&seven, scene, &params, methods[m], 7);
		for (u32 id = 0; id < TS_N_BUFFERS; id++) assert_string_equal(one.hex[id], seven.hex[id]);
	}
	ts_scene_free(scene);
}

/* Only the stage that makes them, with memory for them in `to`. */
static void particles_of(ts_vpl *to, const ts_scene *scene, const ts_params *params)
{
	ts_run run;
	ts_run_begin(&run, scene, params, 2);
	assert_int_equal(ts_run_stage(&run, ts_stage_find("particle")), TS_OK);
	assert_int_equal(ts_frame_n(&run.frame, TS_B_vpl_light), params->particle_count);
	memcpy(to, ts_frame_data(&run.frame, TS_B_vpl_light), params->particle_count * sizeof *to);
	ts_run_end(&run);
}

enum { MANY = 20000 };

/* In halves of the hall from its middle. */
static void offset_of(double at[3], const ts_vpl *light, const ts_space *hall)
{
	at[0] = (double)(light->position[0] - hall->middle.x) / (double)hall->half.x;
	at[1] = (double)(light->position[1] - hall->middle.y) / (double)hall->half.y;
	at[2] = (double)(light->position[2] - hall->middle.z) / (double)hall->half.z;
}

/* Half of them in the inner half of the cylinder's area, half in its lower half, and a quarter in each quadrant. */
static void particles_fill_the_cylinder_evenly(void **state)
{
	(void)state;
	static ts_vpl lights[MANY];
	u32 inner = 0, lower = 0, quadrant[4] = {0};
	ts_params params = tiny_params();
	params.particle_count = MANY;
	ts_scene *scene = small_scene(&params);
	ts_space hall = ts_view_hall(&scene->info);
	particles_of(lights, scene, &params);
	for (u32 i = 0; i < MANY; i++) {
		double at[3], square;
		offset_of(at, &lights[i], &hall);
		square = (at[0] * at[0] + at[2] * at[2]) / (0.75 * 0.75);
		if (!(square < 1.0001 && fabs(at[1]) < 0.7501)) fail_msg("particle %u is outside", (unsigned)i);
		inner += square < 0.5;
		lower += at[1] < 0;
		quadrant[(at[0] < 0) + 2 * (at[2] < 0)]++;
		for (u32 k = 0; k < 3; k++) assert_true(lights[i].normal[k] == 0);
		assert_int_equal(lights[i].bounce, 0);
	}
	assert_true(fabs((double)inner / MANY - 0.5) < 0.02 && fabs((double)lower / MANY - 0.5) < 0.02);
	for (u32 k = 0; k < 4; k++) assert_true(fabs((double)quadrant[k] / MANY - 0.25) < 0.02);
	ts_scene_free(scene);
}

/* A quarter of a turn in 60 frames, every other the other way; a whole one is none. Colours and heights stay. */
static void particles_turn_once_in_their_frames(void **state)
{
	(void)state;
	static ts_vpl first[MANY], later[MANY], again[MANY];
	ts_params params = tiny_params();
	params.particle_count = 1000;
	ts_scene *scene = small_scene(&params);
	ts_space hall = ts_view_hall(&scene->info);
	particles_of(first, scene, &params);
	params.frame = 60;
	particles_of(later, scene, &params);
	params.frame = 240;
	particles_of(again, scene, &params);
	assert_memory_equal(first, again, params.particle_count * sizeof *first);
	for (u32 i = 0; i < params.particle_count; i++) {
		double a[3], b[3], sign = i % 2 == 0 ? 1 : -1;
		offset_of(a, &first[i], &hall);
		offset_of(b, &later[i], &hall);
		bool turned = fabs(b[0] + sign * a[2]) < 1e-4 && fabs(b[2] - sign * a[0]) < 1e-4 && fabs(b[1] - a[1]) < 1e-6;
		if (!turned) fail_msg("particle %u is elsewhere", (unsigned)i);
		assert_memory_equal(first[i].flux, later[i].flux, sizeof first[i].flux);
	}
	ts_scene_free(scene);
}

/* All of them send glow on the area of the hall's box, each as much; in each channel as much, if chance is even. */
static void particles_send_all_of_the_glow(void **state)
{
	(void)state;
	static ts_vpl lights[MANY];
	double sum[3] = {0};
	ts_params params = tiny_params();
	params.particle_count = MANY;
	params.particle_glow = 2;
	ts_scene *scene = small_scene(&params);
	ts_space hall = ts_view_hall(&scene->info);
	double x = (double)hall.half.x, y = (double)hall.half.y, z = (double)hall.half.z;
	double power = 2 * 8 * (x * y + y * z + z * x);
	particles_of(lights, scene, &params);
	for (u32 i = 0; i < MANY; i++) {
		const f32 *flux = lights[i].flux;
		double mean = ((double)flux[0] + (double)flux[1] + (double)flux[2]) / 3;
		if (fabs(mean * MANY / power - 1) > 1e-5)
			fail_msg("particle %u sends %g of %g", (unsigned)i, mean, power / MANY);
		for (u32 k = 0; k < 3; k++) sum[k] += (double)flux[k];
	}
	for (u32 k = 0; k < 3; k++) assert_true(fabs(sum[k] / power - 1) < 0.02);
	ts_scene_free(scene);
}

/* Irradiance from all particles, unshadowed; `near` bounds the distance from below. */
static double light_at(const ts_gpixel *pixel, const ts_vpl *lights, u32 n, double near, u32 channel)
{
	double sum = 0;
	for (u32 i = 0; i < n; i++) {
		double square = 0, cosine = 0;
		for (u32 k = 0; k < 3; k++) {
			double way = (double)lights[i].position[k] - (double)pixel->position[k];
			square += way * way;
			cosine += way * (double)pixel->normal[k];
		}
		double bounded = fmax(square, near * near);
		if (cosine > 0) sum += (double)lights[i].flux[channel] * cosine / sqrt(square) / (4 * acos(-1) * bounded);
	}
	return sum;
}

static void light_of_particles_matches_double_precision(void **state)
{
	(void)state;
	ts_run run;
	ts_params params = tiny_params();
	params.vpl_gather_lights = params.bilateral_px = params.vpl_gather_shadows = 0;
	ts_scene *scene = small_scene(&params);
	run_of(&run, scene, &params, "megaviews");
	const ts_gpixel *pixels = ts_frame_data(&run.frame, TS_B_gbuffer_pixel);
	const ts_vpl *lights = ts_frame_data(&run.frame, TS_B_vpl_light);
	const f32 *found = ts_frame_data(&run.frame, TS_B_indirect_irradiance);
	const ts_root *root = ts_frame_data(&run.frame, TS_B_octree_root);
	double near = (double)params.vpl_gather_near * (double)root->side / 32;
	u32 n = 0;
	for (u64 i = 0; i < ts_frame_n(&run.frame, TS_B_gbuffer_pixel); i++) {
		if (pixels[i].depth == 1.0f) continue;
		double right = light_at(&pixels[i], lights, params.particle_count, near, (u32)(i % 3)),
			   is = (double)found[3 * i + i % 3];
		if (fabs(is / right - 1) > 1e-4) fail_msg("pixel %u: %.9g for %.9g", (unsigned)i, is, right);
		n++;
	}
	assert_true(n > 1000);
	ts_run_end(&run);
	ts_scene_free(scene);
}

static double mean_of(const ts_run *run, const f32 *most)
{
	const f32 *e = ts_frame_data(&run->frame, TS_B_indirect_irradiance);
	u64 n = ts_frame_n(&run->frame, TS_B_indirect_irradiance);
	double sum = 0;
	for (u64 i = 0; i < n; i++) {
		if (most != NULL && e[i] > most[i] * 1.0001f) fail_msg("shadow adds light at %u", (unsigned)i);
		sum += (double)e[i];
	}
	return sum / (double)n;
}

/* Shadows take light away and never add any; maps that views share take nearly as much as maps of their own. */
static void shadows_only_take_light_away(void **state)
{
	(void)state;
	ts_run bright, dark[2];
	double mean[2];
	ts_params params = tiny_params();
	params.octree_levels = 6;
	params.particle_count = 100;
	params.vpl_gather_lights = params.bilateral_px = params.vpl_gather_shadows = 0;
	ts_scene *scene = small_scene(&params);
	run_of(&bright, scene, &params, "megaviews");
	params.vpl_gather_shadows = 1;
	double all = mean_of(&bright, NULL);
	for (u32 m = 0; m < 2; m++) {
		run_of(&dark[m], scene, &params, methods[m]);
		mean[m] = mean_of(&dark[m], ts_frame_data(&bright.frame, TS_B_indirect_irradiance)) / all;
		ts_run_end(&dark[m]);
	}
	print_message("light that shadows leave: %.4f by megaviews, %.4f by manylods\n", mean[0], mean[1]);
	assert_true(mean[0] < 0.97 && mean[0] > 0.4 && fabs(mean[0] / mean[1] - 1) < 0.02);
	ts_run_end(&bright);
	ts_scene_free(scene);
}

/* Whatever was asked for, views see all around; lists are one, but where some particles are too far away. */
static void nothing_of_particles_is_culled(void **state)
{
	(void)state;
	ts_run run;
	ts_params params = tiny_params();
	params.view_map_field = TS_VIEW_FIELD_HALF;
	params.vpl_gather_level = 3;
	ts_scene *scene = small_scene(&params);
	for (u32 far = 0; far < 2; far++) {
		params.vpl_gather_cutoff = far == 0 ? 0.0f : 2.0f;
		run_of(&run, scene, &params, "megaviews");
		assert_true(ts_run_counter(&run, "pairs") > 0);
		assert_int_equal(ts_run_counter(&run, "pairs culled"), 0);
		assert_int_equal(ts_run_counter(&run, "gather pairs culled") > 0, far);
		assert_int_equal(ts_frame_n(&run.frame, TS_B_vpl_gather_pair_offset) == 2, far == 0);
		ts_run_end(&run);
	}
	ts_scene_free(scene);
}

/* Every stage again from a frame where all that it does not claim to read is zero. */
static void stages_read_only_what_they_claim(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	ts_scene *scene = small_scene(&params);
	for (u32 m = 0; m < N_METHODS; m++) {
		ts_run run;
		run_of(&run, scene, &params, methods[m]);
		const ts_step *step = ts_pipeline_steps(ts_pipeline_find("particles", methods[m]));
		for (; step->stage != NULL; step++) {
			const ts_stage *stage = ts_stage_find(step->stage);
			if (step->only_traced || step->only_margins) continue;
			small_assert_claims(&run, stage);
		}
		ts_run_end(&run);
	}
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(threads_change_no_particle),
		cmocka_unit_test(particles_fill_the_cylinder_evenly),
		cmocka_unit_test(particles_turn_once_in_their_frames),
		cmocka_unit_test(particles_send_all_of_the_glow),
		cmocka_unit_test(light_of_particles_matches_double_precision),
		cmocka_unit_test(shadows_only_take_light_away),
		cmocka_unit_test(nothing_of_particles_is_culled),
		cmocka_unit_test(stages_read_only_what_they_claim),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

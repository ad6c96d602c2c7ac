/* Deferred surface splatting: the same bits on any number of threads and in any order of the surfels; every stage
 * from what it claims to read; sums against sums in double precision over rays cast in double; visibility, occlusion
 * and shadows; and that a pixel is shaded once, whatever overlaps there. */
#include "tests/methods/surfels/surfels.h"
#include "kernels/raster/gbuffer.h"
#include "trace/emitted/sums.h"

static const char *const methods[] = {"deferred", "ewa"};

static ts_params tiny_params(void)
{
	ts_params params = small_params(96, 64);
	params.reflectors_count = 0;
	params.depth_map_px = 128;
	return params;
}

static void threads_change_no_bit_of_surfels(void **state)
{
	(void)state;
	static ts_sums one, seven;
	ts_params params = tiny_params();
	params.deferred_shader = TS_SHADER_PHONG_SHADOW;
	ts_scene *scene = surfels_balls(&params, 3000);
	for (u32 m = 0; m < 2; m++) {
		const ts_pipeline *pipeline = ts_pipeline_find("surfels", methods[m]);
		const ts_how alone = {.threads = 1}, many = {.threads = 7};
		assert_int_equal(ts_sums_of(&one, pipeline, scene, &params, &alone), TS_OK);
		assert_int_equal(ts_sums_of(&seven, pipeline, scene, &params, &many), TS_OK);
		for (u32 id = 0; id < TS_N_BUFFERS; id++) assert_string_equal(one.hex[id], seven.hex[id]);
		assert_int_equal(strlen(one.hex[TS_B_surfel_blend_sum]), 64);
	}
	ts_scene_free(scene);
}

static void stages_read_only_what_they_claim(void **state)
{
	(void)state;
	ts_params params = tiny_params();
	params.deferred_shader = TS_SHADER_NPR_SHADOW;
	surfels_assert_claims(&params, "deferred");
}

/* Within a room, large surfels near the eye and all, both filters show nearly the same. */
static void both_filters_show_nearly_the_same_room(void **state)
{
	(void)state;
	ts_run run[2];
	double sum = 0;
	ts_params params = tiny_params();
	params.surfels_from_mesh = 20000;
	ts_scene *scene = small_scene(&params);
	for (u32 m = 0; m < 2; m++) surfels_run(&run[m], scene, &params, methods[m], 2);
	const u8 *a = ts_frame_data(&run[0].frame, TS_B_image_srgb), *b = ts_frame_data(&run[1].frame, TS_B_image_srgb);
	u64 n = ts_frame_n(&run[0].frame, TS_B_image_srgb);
	for (u64 i = 0; i < n; i++) sum += abs(a[i] - b[i]);
	print_message("%.2f grey levels apart\n", sum / (double)n);
	assert_true(sum / (double)n < 6);
	for (u32 m = 0; m < 2; m++) ts_run_end(&run[m]);
	ts_scene_free(scene);
}

/* The same surfels the other way round: sums and depths do not change, only what names them. */
static void the_order_of_surfels_changes_no_sum(void **state)
{
	(void)state;
	ts_run run, turned;
	ts_params params = tiny_params();
	ts_scene *scene = surfels_balls(&params, 3000);
	surfels_run(&run, scene, &params, "deferred", 2);
	ts_scene backwards = *scene;
	backwards.surfels = malloc(scene->n_surfels * sizeof *scene->surfels);
	assert_non_null(backwards.surfels);
	for (u32 i = 0; i < scene->n_surfels; i++) backwards.surfels[i] = scene->surfels[scene->n_surfels - 1 - i];
	surfels_run(&turned, &backwards, &params, "deferred", 1);
	u64 n = ts_frame_n(&run.frame, TS_B_surfel_blend_sum);
	assert_memory_equal(ts_frame_data(&run.frame, TS_B_surfel_blend_sum),
	                    ts_frame_data(&turned.frame, TS_B_surfel_blend_sum), n * 8);
	n = ts_frame_n(&run.frame, TS_B_image_radiance);
	const f32 *image = ts_frame_data(&run.frame, TS_B_image_radiance);
	assert_memory_equal(image, ts_frame_data(&turned.frame, TS_B_image_radiance), n * sizeof *image);
	ts_run_end(&run);
	ts_run_end(&turned);
	free(backwards.surfels);
	ts_scene_free(scene);
}

typedef struct {
	double sum[8];
	bool decided;
} pixel_truth;

static pixel_truth truth_of(const ts_scene *scene, const ts_view *view, const ts_params *params, double eps, u32 x,
                            u32 y)
{
	pixel_truth truth = {.decided = true};
	double i = x + 0.5, j = y + 0.5, nearest = 1e30;
	double way = hypot(1, hypot((i - view->width / 2.0) / view->focal, (j - view->height / 2.0) / view->focal));
	for (u32 k = 0; k < scene->n_surfels; k++) {
		ray_hit hit = hit_of(view, &scene->surfels[k], i, j);
		if (fabs(hit.r3 - 1) < 1e-4) truth.decided = false;
		if (hit.r3 <= 1 && hit.z < nearest) nearest = hit.z;
	}
	for (u32 k = 0; k < scene->n_surfels; k++) {
		const ts_surfel *s = &scene->surfels[k];
		ray_hit hit = hit_of(view, s, i, j);
		double r2 = hit.r2 / params->ewa_screen_radius, r = fmin(hit.r3, r2);
		double z = hit.r3 <= 1 ? hit.z : view->eye[2] - s->centre[2];
		if (fabs(r2 - 1) < 1e-4 || fabs(z - (nearest + eps / way)) < 1e-4) truth.decided = false;
		if (!(r <= 1) || z > nearest + eps / way) continue;
		double weight = exp(-0.5 * r * r / (params->ewa_sigma_k * params->ewa_sigma_k));
		d3 n = d3_cross(d3_of(s->u), d3_of(s->v));
		double value[6] = {s->colour[0], s->colour[1], s->colour[2], n.x, n.y, n.z}, length = sqrt(d3_dot(n, n));
		for (u32 m = 0; m < 6; m++) truth.sum[m] += weight * value[m] / (m < 3 ? 1 : length);
		truth.sum[6] += weight;
		truth.sum[7] += 1;
	}
	return truth;
}

static void sums_match_double_precision(void **state)
{
	(void)state;
	ts_run run;
	ts_params params = tiny_params();
	ts_scene *scene = surfels_balls(&params, 1200);
	surfels_run(&run, scene, &params, "deferred", 2);
	const ts_view *view = ts_frame_data(&run.frame, TS_B_eye_view);
	const f32 *epsilon = ts_frame_data(&run.frame, TS_B_surfel_setup_epsilon);
	const i64 *sums = ts_frame_data(&run.frame, TS_B_surfel_blend_sum);
	u32 n_decided = 0, n_fragments = 0;
	double worst = 0;
	for (u32 p = 0; p < params.width * params.height; p += 3) {
		pixel_truth truth = truth_of(scene, view, &params, (double)*epsilon, p % params.width, p / params.width);
		if (!truth.decided) continue;
		n_decided++;
		assert_int_equal(sums[8 * p + 7], (i64)truth.sum[7]);
		n_fragments += (u32)truth.sum[7];
		for (u32 k = 0; k < 7; k++) {
			worst = fmax(worst, fabs((double)sums[8 * p + k] / 1073741824.0 - truth.sum[k]) / fmax(truth.sum[6], 0.1));
		}
	}
	print_message("# %u pixels with %u fragments: means within %.2g\n", n_decided, n_fragments, worst);
	assert_true(n_decided > params.width * params.height / 3 * 3 / 4 && n_fragments > 5 * n_decided);
	assert_true(worst < 2e-5);
	ts_run_end(&run);
	ts_scene_free(scene);
}

/* The outer ball is behind the inner one: of its green nothing comes through, nor does the inner ball's own back. */
static void the_inner_ball_hides_the_outer(void **state)
{
	(void)state;
	ts_run run;
	ts_params params = tiny_params();
	ts_scene *scene = surfels_balls(&params, 4000);
	surfels_run(&run, scene, &params, "deferred", 2);
	const ts_gpixel *pixels = ts_frame_data(&run.frame, TS_B_gbuffer_pixel);
	u32 n_inner = 0, n_covered = 0, n = params.width * params.height;
	for (u32 p = 0; p < n; p++) {
		ts_v3 at = ts_load3(pixels[p].position);
		f32 r = ts_length(at);
		n_covered += pixels[p].depth != TS_SKY;
		if (r > 1.1f || pixels[p].depth == TS_SKY) continue;
		n_inner++;
		assert_true(pixels[p].albedo[1] < 0.305f); /* red or blue, or between */
		assert_true(ts_dot(ts_normalize(at), ts_load3(pixels[p].normal)) > 0.97f);
		assert_true(fabsf(r - 1) < 0.02f);
	}
	assert_int_equal(n_covered, n); /* no holes */
	assert_true(n_inner > n / 8);
	assert_int_equal(ts_run_counter(&run, "shading operations"), n_covered);
	assert_true(ts_run_counter(&run, "fragments") > 5 * (i64)n_covered);
	ts_run_end(&run);
	ts_scene_free(scene);
}

/* Shadows only take light away; there are some, and not everywhere. */
static void shadows_only_take_light_away(void **state)
{
	(void)state;
	ts_run run, dark;
	ts_params params = tiny_params();
	ts_scene *scene = surfels_balls(&params, 4000);
	surfels_run(&run, scene, &params, "deferred", 2);
	params.deferred_shader = TS_SHADER_PHONG_SHADOW;
	surfels_run(&dark, scene, &params, "deferred", 2);
	const f32 *with = ts_frame_data(&dark.frame, TS_B_image_radiance);
	const f32 *without = ts_frame_data(&run.frame, TS_B_image_radiance);
	u32 n_less = 0, n = params.width * params.height;
	for (u32 k = 0; k < 3 * n; k++) {
		assert_true(with[k] <= without[k]);
		n_less += with[k] < without[k];
	}
	print_message("# %u of %u channels are darker\n", n_less, 3 * n);
	assert_true(n_less > n / 20 && n_less < 2 * n);
	ts_run_end(&run);
	ts_run_end(&dark);
	ts_scene_free(scene);
}

/* Without surfels there is nothing to draw. */
static void a_scene_without_surfels_is_refused(void **state)
{
	(void)state;
	ts_run run;
	ts_params params = tiny_params();
	ts_scene *scene = small_scene(&params);
	ts_run_begin(&run, scene, &params, 1);
	assert_int_equal(ts_pipeline_run(ts_pipeline_find("surfels", "deferred"), &run), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "has no surfels"));
	ts_run_end(&run);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(threads_change_no_bit_of_surfels),
		cmocka_unit_test(stages_read_only_what_they_claim),
		cmocka_unit_test(both_filters_show_nearly_the_same_room),
		cmocka_unit_test(the_order_of_surfels_changes_no_sum),
		cmocka_unit_test(sums_match_double_precision),
		cmocka_unit_test(the_inner_ball_hides_the_outer),
		cmocka_unit_test(shadows_only_take_light_away),
		cmocka_unit_test(a_scene_without_surfels_is_refused),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

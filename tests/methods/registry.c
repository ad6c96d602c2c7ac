/* The rows of effects and methods, and what is asked of them instead of their names. */
#include "model/core.h"
#include "tests/methods/small.h"

static void assert_is(const ts_pipeline *pipeline, const char *effect, const char *name)
{
	assert_non_null(pipeline);
	assert_string_equal(pipeline->effect->name, effect);
	assert_string_equal(pipeline->name, name);
}

/* Every method has an effect, whose methods stand together, and makes what the eye sees of it. */
static void every_method_has_an_effect(void **state)
{
	(void)state;
	const ts_effect *first = ts_pipelines()[0]->effect;
	for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) {
		const ts_effect *effect = (*at)->effect;
		assert_ptr_equal(ts_effect_find(effect->name), effect);
		for (const ts_pipeline *const *other = at; *other != NULL; other++) {
			if ((*other)->effect == effect) assert_ptr_equal(other[other > at ? -1 : 0]->effect, effect);
		}
		assert_true(effect->difference_scale > 0 && effect->lower != NULL && effect->doc[0] != 0);
		assert_int_equal(effect->mirrors, effect == first);
		assert_non_null(ts_pipeline_maker(*at, effect->seen));
	}
	assert_null(ts_effect_find("shadow"));
}

/* Truths start from the first method that makes what they need: truth A and B of reflections from EPR. */
static void truths_start_from_the_first_that_fits(void **state)
{
	(void)state;
	static const ts_buffer_id looked[] = {TS_B_mirror_pixel_record, TS_B_lookup_point, TS_N_BUFFERS};
	static const ts_buffer_id faces[] = {TS_B_cube_face_depth_triangle, TS_N_BUFFERS};
	static const ts_buffer_id views[] = {TS_B_lamp_shape, TS_B_offscreen_view, TS_N_BUFFERS};
	static const ts_buffer_id pixels[] = {TS_B_gbuffer_pixel, TS_N_BUFFERS};
	static const ts_buffer_id none[] = {TS_B_cube_face_depth_triangle, TS_B_lookup_point, TS_N_BUFFERS};
	assert_is(ts_pipeline_making("reflections", looked), "reflections", "epr");
	assert_is(ts_pipeline_making(NULL, faces), "reflections", "mvr");
	assert_is(ts_pipeline_making("omni-shadows", views), "omni-shadows", "ivir");
	assert_is(ts_pipeline_making("particles", pixels), "particles", "megaviews");
	assert_null(ts_pipeline_making("surfels", faces));
	assert_null(ts_pipeline_making(NULL, none));
}

/* Those of surfels, and no other, read surfels. */
static void only_methods_of_surfels_read_surfels(void **state)
{
	(void)state;
	for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) {
		const ts_pipeline *p = *at;
		bool surfels = ts_pipeline_reads(p, TS_B_scene_surfel), triangles = ts_pipeline_reads(p, TS_B_scene_triangle);
		assert_true(surfels != triangles);
		assert_int_equal(surfels, strcmp(p->effect->name, "surfels") == 0);
	}
}

typedef struct {
	u64 done, total;
	u32 n;
} seen;

static void see(void *user, const char *label, u64 done, u64 total)
{
	seen *s = user;
	assert_true(label[0] != 0 && done >= s->done && done <= total && (s->n == 0 || total == s->total));
	*s = (seen){done, total, s->n + 1};
}

/* In batches too. */
static void progress_reaches_its_total(void **state)
{
	(void)state;
	ts_params params = small_params(32, 18);
	params.reflectors_count = 3;
	params.cube_max_px = 16;
	params.lamp_views = params.lamp_cubes = 4;
	params.lamp_views_a_pass = 2;
	params.depth_map_px = 32;
	params.surfels_from_mesh = 1000;
	params.particle_count = 16;
	params.vpl_paths = 16;
	ts_scene *scene = small_scene(&params);
	for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) {
		seen s = {0};
		ts_run run;
		const ts_listener before = ts_listen(&(ts_listener){.progress = see, .user = &s});
		ts_run_begin(&run, scene, &params, 1);
		ts_status status = ts_pipeline_run(*at, &run);
		ts_listen(&before);
		if (status != TS_OK) fail_msg("%s: %s", (*at)->name, ts_error_message());
		if (s.done != s.total || s.n < 4)
			fail_msg("%s: %u calls, to %u of %u", (*at)->name, s.n, (u32)s.done, (u32)s.total);
		ts_run_end(&run);
	}
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(every_method_has_an_effect),
		cmocka_unit_test(truths_start_from_the_first_that_fits),
		cmocka_unit_test(only_methods_of_surfels_read_surfels),
		cmocka_unit_test(progress_reaches_its_total),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* What a run told: what it counted and made is what its buffers hold; and pictures of it. */
#include "study/measure.h"
#include "tests/methods/small.h"
#include "tests/srgb.h"

enum { WIDTH = 64, HEIGHT = 36, N = WIDTH * HEIGHT };

static ts_params few_mirrors(void)
{
	ts_params params = small_params(WIDTH, HEIGHT);
	TS_PARAM_SET(&params, reflectors_count, 3);
	TS_PARAM_SET(&params, cube_max_px, 32);
	return params;
}

/* The buffers and pictures that a hook finds behind the measured run. */
typedef struct {
	ts_picture picture, truth;
	u64 n_faces, sides, n_seen;
	u32 n_calls;
} after;

static ts_status look(ts_run *run, void *user)
{
	after *a = user;
	u64 n;
	const u64 *seen = ts_pipeline_seen(run, &n);
	const ts_face *faces = ts_frame_data(&run->frame, TS_B_cube_size_face);
	a->n_calls++;
	for (u64 i = 0; i < ts_frame_n(&run->frame, TS_B_cube_size_face); i++) {
		a->n_faces += faces[i].n > 0;
		a->sides += faces[i].n;
	}
	ts_status status = ts_picture_take(&a->picture, "epr", run);
	for (u64 i = 0; i < n; i++) {
		if (seen[i] != TS_EMPTY) a->n_seen++;
		assert_int_equal(a->picture.seen[i], seen[i] != TS_EMPTY);
	}
	assert_memory_equal(a->picture.srgb, ts_frame_data(&run->frame, TS_B_image_srgb), N * 3);
	return status == TS_OK ? ts_picture_truth(&a->truth, ts_truths()[0], run) : status;
}

static void a_run_tells_what_its_buffers_hold(void **state)
{
	(void)state;
	ts_params params = few_mirrors();
	ts_scene *scene = small_scene(&params);
	after a = {.n_calls = 0};
	ts_measure m = {.whole = true};
	const ts_how how = {.threads = 2};
	if (ts_measure_run(&m, ts_pipeline_find("reflections", "epr"), scene, &params, &how, look, &a) != TS_OK)
		fail_msg("%s", ts_error_message());
	double seconds = 0;
	for (u32 i = 0; i < m.n_timings; i++) seconds += m.timings[i].seconds;
	assert_int_equal(a.n_calls, 1);
	assert_true(m.n_in_sight == a.n_faces && a.n_faces > 0 && m.mean_diameter == (double)a.sides / (double)a.n_faces);
	assert_true(m.seconds == seconds && seconds > 0);
	assert_int_equal(m.bytes[TS_B_image_srgb], N * 3);
	assert_int_equal(m.elements[TS_B_image_srgb], N * 3);
	assert_true(m.peak_bytes >= m.bytes[TS_B_image_srgb] + m.bytes[TS_B_image_radiance]);
	assert_true(a.n_seen > 0 && ts_measure_timing(&m, "eye") != NULL && ts_measure_timing(&m, "no stage") == NULL);
	assert_true(ts_measure_counter(&m, "points")->value > 0 && ts_measure_counter(&m, "no counter") == NULL);

	/* The truth cast rays, and took as long as they and the rest together. */
	assert_true(a.truth.cost.rays > 0 && a.truth.cost.seconds > 0 && a.truth.cost.seconds <= 2 * a.truth.seconds);
	assert_string_equal(a.truth.name, "truth-a");
	ts_picture_free(&a.picture);
	ts_picture_free(&a.truth);
	ts_scene_free(scene);
}

/* A run without cubes in sight has no mean. */
static void a_run_without_cubes_has_no_mean(void **state)
{
	(void)state;
	ts_params params = small_params(WIDTH, HEIGHT);
	TS_PARAM_SET(&params, reflectors_count, 0);
	ts_scene *scene = small_scene(&params);
	ts_measure m = {.n_in_sight = 5};
	const ts_how how = {.threads = 1};
	assert_int_equal(ts_measure_run(&m, ts_pipeline_find("reflections", "epr"), scene, &params, &how, NULL, NULL),
	                 TS_OK);
	assert_true(m.n_in_sight == 0 && m.mean_diameter == 0);
	ts_scene_free(scene);
}

static void begin_truths(const ts_truth_kind *kind, u32 asked, u32 of_its_run, const ts_scene *scene,
                         const ts_params *params)
{
	static ts_picture pictures[TS_MAX_TRUTHS];
	char effect[64];
	snprintf(effect, sizeof effect, "%s", kind->effects);
	effect[strcspn(effect, " ")] = 0;
	memset(pictures, 0, sizeof pictures);
	if (ts_picture_truths_begun(pictures, asked, kind, effect, scene, params, 2) != TS_OK)
		fail_msg("%s: %s", kind->name, ts_error_message());
	for (u32 t = 0; t < TS_MAX_TRUTHS; t++) {
		assert_int_equal(pictures[t].srgb != NULL, (asked & of_its_run & 1u << t) != 0);
		ts_picture_free(&pictures[t]);
	}
}

/* Truths in a run of their own: those that are meant and begin alike, and no others. */
static void truths_begin_alike_in_their_run(void **state)
{
	(void)state;
	ts_params params = small_params(16, 9);
	TS_PARAM_SET(&params, reflectors_count, 0);
	TS_PARAM_SET(&params, truth_area_samples, 16);
	TS_PARAM_SET(&params, vpl_paths, 20);
	ts_scene *scene = small_scene(&params);
	for (u32 t = 0; ts_truths()[t] != NULL; t++) {
		const ts_truth_kind *kind = ts_truths()[t];
		u32 of_its_run = 0;
		if (kind->begin == NULL) continue;
		for (u32 other = 0; ts_truths()[other] != NULL; other++) {
			if (ts_truths()[other]->begin == kind->begin) of_its_run |= 1u << other;
		}
		bool first = (of_its_run & ((1u << t) - 1)) == 0;
		begin_truths(kind, first ? UINT32_MAX : 1u << t, of_its_run, scene, &params);
	}
	ts_scene_free(scene);
}

/* ---- pictures ---- */

static void differences_of_pictures_are_scaled(void **state)
{
	(void)state;
	u8 a[] = {0, 10, 255, 100, 7, 250}, b[] = {0, 20, 0, 90, 7, 255};
	static const u8 once[] = {0, 10, 255, 10, 0, 5}, often[] = {0, 255, 255, 255, 0, 150};
	ts_params params = small_params(2, 1);
	f32 light[] = {0, 1, 2, 0.5f, 4, 5}, dark[] = {1, 1, 0, 0.25f, 0, 9};
	const ts_picture image = {.srgb = a, .radiance = light}, reference = {.srgb = b, .radiance = dark};
	ts_picture difference;
	assert_int_equal(ts_picture_difference(&difference, &image, &reference, &params, 1), TS_OK);
	assert_memory_equal(difference.srgb, once, sizeof once);
	for (u32 i = 0; i < 6; i++) assert_true(difference.radiance[i] == light[i] - dark[i]);
	ts_picture_free(&difference);
	assert_int_equal(ts_picture_difference(&difference, &reference, &image, &params, 30), TS_OK);
	assert_memory_equal(difference.srgb, often, sizeof often);
	ts_picture_free(&difference);
	assert_true(isnan(ts_picture_change(&image, NULL, &params)));
	const ts_picture later = {.srgb = a, .before = b}, still = {.srgb = a, .before = a};
	double squares = 0;
	for (u32 i = 0; i < sizeof a; i++) squares += (a[i] - b[i]) * (a[i] - b[i]);
	assert_float_equal(ts_picture_change(&later, NULL, &params), sqrt(squares / sizeof a), 1e-9);
	assert_true(ts_picture_change(&still, NULL, &params) == 0);
}

/* Display values of a radiance (IEC 61966-2-1). */
static void radiance_is_displayed_by_the_curve(void **state)
{
	(void)state;
	ts_params params = small_params(4, 1);
	params.image_exposure = 2;
	f32 *radiance = malloc(12 * sizeof *radiance);
	assert_non_null(radiance);
	for (u32 i = 0; i < 12; i++) radiance[i] = (f32)i * 0.05f;
	ts_picture picture = {.radiance = NULL};
	assert_int_equal(ts_picture_make(&picture, "made", radiance, &params), TS_OK);
	assert_string_equal(picture.name, "made");
	assert_ptr_equal(picture.radiance, radiance);
	for (u32 i = 0; i < 12; i++) {
		double right = 255 * srgb_encoded(fmin(0.1 * i, 1));
		assert_true(fabs(picture.srgb[i] - right) < 0.501);
	}
	ts_picture_free(&picture);
	assert_null(picture.srgb);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_run_tells_what_its_buffers_hold), cmocka_unit_test(a_run_without_cubes_has_no_mean),
		cmocka_unit_test(truths_begin_alike_in_their_run), cmocka_unit_test(differences_of_pictures_are_scaled),
		cmocka_unit_test(radiance_is_displayed_by_the_curve)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

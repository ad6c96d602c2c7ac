/* What the probe says of shadows, against the buffers of the run that wrote the trace. */
#include "tests/probe/probed.h"

enum { N_TRIED = 50 };

static const struct {
	const char *effect, *method;
} shadow_methods[] = {
	{"soft-shadows", "mvr"}, {"soft-shadows", "ivir"}, {"soft-shadows", "pcss"},
	{"omni-shadows", "mvr"}, {"omni-shadows", "epr"},
};
enum { N_SHADOWS = sizeof shadow_methods / sizeof *shadow_methods };
static traced shadows[N_SHADOWS];

static int make_all(void **state)
{
	(void)state;
	ts_params params = small_params(96, 64);
	params.reflectors_count = 3;
	params.reflectors_px = 40;
	params.splat_plane_depth = 1;
	params.lamp_views = params.lamp_cubes = 5;
	params.depth_map_px = 64;
	params.lamp_views_a_pass = 2;
	for (u32 i = 0; i < N_SHADOWS; i++) make(&shadows[i], shadow_methods[i].effect, shadow_methods[i].method, &params);
	return 0;
}

static int drop_all(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_SHADOWS; i++) drop(&shadows[i]);
	return 0;
}

/* The least of a figure of the samples, as its bits; all ones: none has it. */
static u64 least_of(const json_t *samples, const char *name)
{
	f32 least = INFINITY;
	size_t i;
	json_t *sample;
	json_array_foreach ((json_t *)samples, i, sample) {
		const json_t *own = json_object_get(sample, name);
		if (own != NULL) least = fminf(least, (f32)json_real_value(own));
	}
	return isinf(least) ? TS_EMPTY : ts_f2u(least);
}

static u32 n_reaching(const json_t *samples)
{
	u32 n = 0;
	size_t i;
	json_t *sample;
	json_array_foreach ((json_t *)samples, i, sample) {
		n += strncmp(json_string_value(json_object_get(sample, "answer")), "reaches", 7) == 0;
	}
	return n;
}

/* The samples add up to the buffers: those that reach the pixel, and of their margins the least. Returns how many
 * do. */
static u32 try_shadow(const traced *t, u32 pixel)
{
	json_t *answer;
	u32 width = t->run.params.width, lit = ((const u32 *)data(t, TS_B_shadow_test_lit))[pixel];
	if (((const u64 *)data(t, TS_B_eye_depth_triangle))[pixel] == TS_EMPTY) return 0;
	require(ask_pixel(t, pixel % width, pixel / width, &answer));
	const json_t *light = json_array_get(json_object_get(answer, "shadow"), 0);
	const json_t *samples = json_object_get(light, "by_sample");
	assert_int_equal(figure(light, "reach"), lit);
	if (samples != NULL) {
		const u64 *margin = (const u64 *)data(t, TS_B_shadow_test_margin) + pixel * 2;
		assert_int_equal(n_reaching(samples), lit);
		assert_int_equal(json_array_size(samples), 5);
		assert_true(least_of(samples, "edge_margin") == margin[0]);
		assert_true(least_of(samples, "depth_margin") == margin[1]);
	}
	json_decref(answer);
	return lit;
}

static void shadow_samples_add_up_to_the_buffers(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_SHADOWS; i++) {
		const traced *t = &shadows[i];
		u32 n_lit = 0, most = i == 2 ? 64 : 5;
		json_t *answer;
		for (u32 k = 0; k < N_TRIED; k++) {
			u32 pixel = below(t->run.params.width * t->run.params.height);
			try_pixel(t, pixel);
			n_lit += try_shadow(t, pixel);
		}
		assert_true(n_lit > N_TRIED / 8 * most && n_lit < N_TRIED * most);
		assert_int_equal(ask_texel(t, "0.+X", 0, 0, &answer), TS_ERROR);
		assert_int_equal(ask_triangle(t, 0, &answer), TS_ERROR);
		assert_int_equal(ask_point(t, 0, &answer), TS_ERROR);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(shadow_samples_add_up_to_the_buffers),
	};
	return cmocka_run_group_tests(tests, make_all, drop_all);
}

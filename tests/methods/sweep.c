/* Every parameter at its ends and every choice, alone and all at once at random: runs end well, with finite pictures.
 * What leaves the scene as it is runs on the atrium; what does not, and all at once, on a soup, which opens at once. */
#include "tests/methods/small.h"
#include "tests/truth/soup.h"

enum { N_RANDOM = 24 };

/* Ends that would take a test too long. */
static const struct {
	const char *name, *most;
} shorter[] = {
	{"width", "150"},      {"height", "150"}, {"frame", "40"},        {"reflectors.count", "16"},
	{"cube.max_px", "64"}, {"cube.px", "64"}, {"density.scale", "2"}, {"surfels.from_mesh", "2000"},
	{NULL, NULL},
};

/* Parameters that a scene depends on; all others leave the scene as it is. */
static const char *const of_the_scene[] = {"width",
                                           "height",
                                           "seed",
                                           "eye.fov",
                                           "eye.distance",
                                           "light.irradiance",
                                           "light.ambient",
                                           "reflectors.count",
                                           "reflectors.shape",
                                           "reflectors.px",
                                           NULL};

static bool is_of_the_scene(const char *name)
{
	u32 i = 0;
	while (of_the_scene[i] != NULL && strcmp(of_the_scene[i], name) != 0) i++;
	return of_the_scene[i] != NULL;
}

static const char *most_of(const ts_param_info *row)
{
	for (u32 i = 0; shorter[i].name != NULL; i++) {
		if (strcmp(shorter[i].name, row->name) == 0) return shorter[i].most;
	}
	return row->max;
}

static ts_params base_params(void)
{
	ts_params params = small_params(32, 32);
	params.reflectors_count = 4;
	params.cube_max_px = 16;
	return params;
}

static void set(ts_params *params, const char *name, const char *value)
{
	if (ts_params_set(params, name, value) != TS_OK) fail_msg("%s", ts_error_message());
}

static void assert_finite(const ts_run *run, const char *what)
{
	const f32 *x = ts_frame_data(&run->frame, TS_B_image_radiance);
	u64 n = ts_frame_n(&run->frame, TS_B_image_radiance);
	for (u64 i = 0; i < n; i++) {
		if (!(x[i] >= 0 && x[i] <= FLT_MAX)) fail_msg("%s: radiance %a", what, (double)x[i]);
	}
	assert_int_equal(n, (u64)run->params.width * run->params.height * 3);
}

static void assert_runs(const ts_scene *scene, const ts_params *params, const char *what)
{
	static const char *const methods[] = {"epr", "mvr"};
	for (u32 m = 0; m < 2; m++) {
		ts_run run;
		ts_run_begin(&run, scene, params, 2);
		if (ts_pipeline_run(ts_pipeline_find("reflections", methods[m]), &run) != TS_OK) {
			fail_msg("%s, %s: %s", what, methods[m], ts_error_message());
		}
		assert_finite(&run, what);
		ts_run_end(&run);
	}
}

static void assert_opens_and_runs(const ts_params *params, const char *what)
{
	ts_scene *scene = soup_open(params, 3000);
	if (scene == NULL) fail_msg("%s: %s", what, ts_error_message());
	assert_runs(scene, params, what);
	ts_scene_free(scene);
}

/* The k-th choice of "a|b|c"; false: there are fewer. */
static bool choice_of(const char *choices, u32 k, char text[64])
{
	for (; k > 0; k--) {
		choices = strchr(choices, '|');
		if (choices == NULL) return false;
		choices++;
	}
	size_t n = strcspn(choices, "|");
	assert_true(n < 64);
	memcpy(text, choices, n);
	text[n] = 0;
	return n > 0;
}

static void run_with(const ts_scene *base, const ts_param_info *row, const char *value)
{
	char what[128];
	ts_params params = base_params();
	snprintf(what, sizeof what, "%s=%s", row->name, value);
	set(&params, row->name, value);
	if (is_of_the_scene(row->name))
		assert_opens_and_runs(&params, what);
	else
		assert_runs(base, &params, what);
}

static void each_parameter_runs_at_its_ends(void **state)
{
	(void)state;
	size_t n;
	const ts_param_info *table = ts_param_table(&n);
	ts_params params = base_params();
	ts_scene *base = small_scene(&params);
	for (size_t i = 0; i < n; i++) {
		char text[64];
		if (strcmp(table[i].kind, "enum") != 0) {
			run_with(base, &table[i], table[i].min);
			run_with(base, &table[i], most_of(&table[i]));
			continue;
		}
		for (u32 k = 0; choice_of(table[i].choices, k, text); k++) run_with(base, &table[i], text);
	}
	ts_scene_free(base);
}

/* Half of the parameters at one of their ends. */
static void randomize(ts_params *params, u32 run, char *what, size_t what_bytes)
{
	size_t n, used = 0;
	const ts_param_info *table = ts_param_table(&n);
	for (size_t i = 0; i < n; i++) {
		char text[64];
		u32 h = ts_random(run * 64 + (u32)i, 6, 3);
		if ((h & 1) == 0) continue;
		if (strcmp(table[i].kind, "enum") != 0) {
			snprintf(text, sizeof text, "%s", (h & 2) != 0 ? table[i].min : most_of(&table[i]));
		} else {
			u32 k = h >> 8 & 7;
			while (!choice_of(table[i].choices, k, text)) k--;
		}
		set(params, table[i].name, text);
		int length = snprintf(what + used, what_bytes - used, "%s=%s ", table[i].name, text);
		assert_true(length > 0 && used + (size_t)length < what_bytes);
		used += (size_t)length;
	}
}

static void random_parameters_run_together(void **state)
{
	(void)state;
	for (u32 run = 0; run < N_RANDOM; run++) {
		char what[2048] = "";
		ts_params params = base_params();
		randomize(&params, run, what, sizeof what);
		assert_opens_and_runs(&params, what);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(each_parameter_runs_at_its_ends),
	                                   cmocka_unit_test(random_parameters_run_together)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* What the probe says of virtual point lights and particles, against the buffers of the run that wrote the trace. */
#include "tests/probe/probed.h"
#include "tests/whole.h"

static u32 n_tries(void) { return whole_or(50, 30); }

static const struct {
	const char *effect, *method;
	u32 vpls, bounces, lights, fusion, multipixel, shadows;
	f32 cutoff;
} view_methods[] = {
	{"indirect", "megaviews", 0, 1, 16, TS_FUSION_MIN, TS_MULTIPIXEL_OFF, 1, 0},
	{"indirect", "megaviews", 100, 3, 16, TS_FUSION_PAPER, TS_MULTIPIXEL_MIPS, 1, 12},
	{"indirect", "megaviews", 0, 1, 0, TS_FUSION_MIN, TS_MULTIPIXEL_OFF, 0, 0},
	{"indirect", "manylods", 16, 4, 16, TS_FUSION_MIN, TS_MULTIPIXEL_TEXELS, 1, 0},
	{"particles", "megaviews", 0, 1, 16, TS_FUSION_MIN, TS_MULTIPIXEL_OFF, 1, 10},
	{"particles", "manylods", 0, 1, 16, TS_FUSION_MIN, TS_MULTIPIXEL_OFF, 1, 0},
};
enum { N_VIEWS = sizeof view_methods / sizeof *view_methods };
static traced views[N_VIEWS];

static int make_all(void **state)
{
	(void)state;
	ts_params params = small_params(48, 32);
	params.rsm_px = 4;
	params.octree_levels = 5;
	params.vpl_gather_level = 3;
	params.bilateral_px = 3;
	params.particle_count = 200;
	params.depth_map_bias = params.depth_map_bias_slope = 0.25f;
	params.vpl_gather_bias = 0.5f;
	for (u32 i = 0; i < N_VIEWS; i++) {
		params.vpl_paths = view_methods[i].vpls;
		params.vpl_bounces = view_methods[i].bounces;
		params.vpl_gather_lights = view_methods[i].lights;
		params.view_map_fusion = view_methods[i].fusion;
		params.view_map_texel = view_methods[i].multipixel == TS_MULTIPIXEL_MIPS ? TS_TEXEL_MIDDLE : TS_TEXEL_POINT;
		params.view_map_multipixel = view_methods[i].multipixel;
		params.vpl_gather_shadows = view_methods[i].shadows;
		params.vpl_gather_cutoff = view_methods[i].cutoff;
		make(&views[i], view_methods[i].effect, view_methods[i].method, &params);
	}
	return 0;
}

static int drop_all(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_VIEWS; i++) drop(&views[i]);
	return 0;
}

/* The entry of a light among those that are listed. */
static const json_t *listed(const json_t *lights, u64 light)
{
	size_t i;
	json_t *entry;
	json_array_foreach (json_object_get(lights, "brightest"), i, entry) {
		if (figure(entry, "light") == light) return entry;
	}
	fail_msg("light %u is not listed", (unsigned)light);
	return NULL;
}

/* The light sends its flux by the geometry, and nothing into its shadow. Returns whether the pixel is in shadow. */
static bool try_light(const traced *t, const json_t *entry)
{
	u64 view = figure(entry, "light");
	const ts_vpl *light = (const ts_vpl *)data(t, TS_B_vpl_light) + view;
	const json_t *question = json_object_get(entry, "shadow");
	bool dark = false;
	if (json_is_object(question) && json_object_get(question, "free") != NULL) {
		const json_t *height = json_object_get(question, "above_the_plane");
		dark = json_real_value(json_object_get(question, "free")) < 0 &&
		       (height == NULL || shown(question, "above_the_plane", 0) > shown(question, "clear_from", 0));
		assert_string_equal(json_string_value(json_object_get(question, "answer")), dark ? "in shadow" : "lit");
		assert_non_null(json_object_get(json_object_get(question, "pair"), "why"));
	}
	for (u32 c = 0; c < 3; c++) {
		assert_bits(shown(entry, "flux", c), light->flux[c]);
		assert_bits(shown(entry, "irradiance", c), light->flux[c] * (dark ? 0.0f : shown(entry, "geometry", 0)));
	}
	if (t->run.frame.buffer[TS_B_vpl_path].made) {
		const u32 *paths = (const u32 *)data(t, TS_B_vpl_path) + figure(entry, "path");
		assert_true(paths[0] <= view && view < paths[1]);
		assert_int_equal(figure(entry, "bounce"), view - paths[0] + 1);
	}
	return dark;
}

/* The lights, in the order in which they are drawn, add up to the buffer. Returns how many of them are in shadow. */
static u32 try_draws(const traced *t, const json_t *lights, u32 pixel)
{
	const f32 *right = (const f32 *)data(t, TS_B_vpl_gather_irradiance) + pixel * 3;
	f32 sum[3] = {0, 0, 0};
	u32 n_dark = 0;
	size_t i;
	json_t *entry;
	json_array_foreach (json_object_get(lights, "drawn"), i, entry) {
		const json_t *light = listed(lights, (u64)json_integer_value(entry));
		for (u32 c = 0; c < 3; c++) sum[c] += shown(light, "irradiance", c);
	}
	assert_int_equal(i, figure(lights, "draws"));
	for (u32 c = 0; c < 3; c++) assert_bits(ts_put(sum[c] * shown(lights, "share", 0)), right[c]);
	double parts = 0, before = INFINITY;
	json_array_foreach (json_object_get(lights, "brightest"), i, entry) {
		size_t k;
		json_t *view;
		u64 times = 0;
		f32 light = shown(entry, "irradiance", 0) + shown(entry, "irradiance", 1) + shown(entry, "irradiance", 2);
		json_array_foreach (json_object_get(lights, "drawn"), k, view) {
			times += json_integer_value(view) == json_integer_value(json_object_get(entry, "light"));
		}
		assert_int_equal(figure(entry, "drawn"), times);
		assert_true((double)times * light <= before * 1.000001);
		before = (double)times * light;
		n_dark += try_light(t, entry);
		parts += json_real_value(json_object_get(entry, "part"));
	}
	bool all = json_object_get(lights, "others") == NULL && right[0] + right[1] + right[2] > 0;
	assert_true(parts < 1.0001 && (parts > 0.9999 || !all));
	return n_dark;
}

/* Of a column of at most 8 pixels all are told: their weighed mean is the buffer's. */
static void try_filter(const traced *t, const json_t *filter, u32 pixel)
{
	const json_t *column = json_object_get(filter, "along_the_column");
	f32 sum[3] = {0, 0, 0}, weights = 0;
	for (u32 y = 0; y < t->run.params.height; y++) {
		size_t i;
		json_t *entry;
		json_array_foreach (json_object_get(column, "heaviest"), i, entry) {
			if (json_integer_value(json_array_get(json_object_get(entry, "pixel"), 1)) != y) continue;
			f32 weight = shown(entry, "weight", 0);
			weights += weight;
			for (u32 c = 0; c < 3; c++) {
				f32 light = (f32)json_real_value(json_array_get(json_object_get(entry, "irradiance"), c));
				sum[c] += light * weight;
			}
		}
	}
	for (u32 c = 0; c < 3; c++) {
		assert_bits(ts_put(sum[c] / weights), ((const f32 *)data(t, TS_B_indirect_irradiance))[pixel * 3 + c]);
	}
}

/* Culled nodes and kept nodes are all nodes, and the list has the kept ones. */
static u64 try_culling(const traced *t, const json_t *culling)
{
	const u32 *offset = data(t, TS_B_vpl_gather_pair_offset), *level = data(t, TS_B_octree_level);
	u64 node = figure(culling, "node") - level[figure(culling, "level")];
	u64 unseen = figure(json_object_get(culling, "culled_as_they_look_elsewhere"), "views");
	u64 far = figure(json_object_get(culling, "culled_beyond_cutoff"), "views");
	const json_t *left = json_object_get(culling, "left");
	assert_int_equal(figure(left, "nodes"), offset[node + 1] - offset[node]);
	assert_int_equal(figure(left, "views") + unseen + far, count(t, TS_B_vpl_light));
	assert_true(t->run.params.vpl_gather_cutoff > 0 || far == 0);
	return unseen + far;
}

static void the_probe_tells_what_lights_give(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_VIEWS; i++) {
		const traced *t = &views[i];
		u32 n_dark = 0, n_tried = 0;
		u64 n_culled = 0;
		for (u32 k = 0; k < n_tries() / 2; k++) {
			json_t *answer;
			u32 pixel = below(t->run.params.width * t->run.params.height), width = t->run.params.width;
			try_pixel(t, pixel);
			if (((const u64 *)data(t, TS_B_eye_depth_triangle))[pixel] == TS_EMPTY) continue;
			require(ask_pixel(t, pixel % width, pixel / width, &answer));
			n_culled += try_culling(t, json_object_get(answer, "culling"));
			const json_t *lights = json_object_get(answer, "lights");
			if (figure(lights, "draws") <= 16) n_dark += try_draws(t, lights, pixel);
			try_filter(t, json_object_get(answer, "filter"), pixel);
			json_decref(answer);
			n_tried++;
		}
		bool culls = i == 0 || t->run.params.vpl_gather_cutoff > 0;
		assert_true(n_tried > n_tries() / 4 && (n_culled > 0 || !culls));
		assert_true(t->run.params.vpl_gather_shadows == 0 ? n_dark == 0 : n_dark > 0);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(the_probe_tells_what_lights_give),
	};
	return cmocka_run_group_tests(tests, make_all, drop_all);
}

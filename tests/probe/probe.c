/* The probe against the buffers of the run that wrote the trace. */
#include "../../src/kernels/surfels/disc.h"
#include "../../src/kernels/hulls/hull.h"
#include "probed.h"

enum { N_TRIED = 50 };

static traced epr, mvr, plane; /* plane: EPR with the depth of planes, which ties often */
static const struct { const char *effect, *method; } shadow_methods[] = {
	{"soft-shadows", "mvr"}, {"soft-shadows", "ivir"}, {"soft-shadows", "pcss"}, {"omni-shadows", "mvr"},
	{"omni-shadows", "epr"},
};
enum { N_SHADOWS = sizeof shadow_methods / sizeof *shadow_methods };
static traced shadows[N_SHADOWS];
static const struct { const char *method; u32 surface, interpolation, sharpness, cosine, integrals; } indirect_methods[] = {
	{"direct", 0, 0, 0, 0, 0},
	{"hulls", TS_SURFACE_ROBUST, 0, 0, TS_COSINE_IS_OURS, 0},
	{"hulls", TS_SURFACE_PAPER, TS_INTERPOLATION_MOMENTS, TS_SHARPNESS_VMF, TS_COSINE_IS_OURS, TS_INTEGRALS_PRINTED},
	{"hulls", TS_SURFACE_ROBUST, 0, 0, TS_COSINE_IS_CONSTANT, 0},
	{"hulls", TS_SURFACE_ROBUST, 0, 0, TS_COSINE_IS_SG, 0},
};
enum { N_INDIRECT = sizeof indirect_methods / sizeof *indirect_methods };
static traced indirect[N_INDIRECT];
static const struct {
	const char *effect, *method;
	u32 vpls, bounces, lights, fusion, multipixel, shadows;
	f32 cutoff;
} view_methods[] = {
	{"indirect", "megaviews", 0, 1, 16, TS_FUSION_MIN, 0, 1, 0},
	{"indirect", "megaviews", 100, 3, 16, TS_FUSION_PAPER, 1, 1, 12},
	{"indirect", "megaviews", 0, 1, 0, TS_FUSION_MIN, 0, 0, 0},
	{"indirect", "manylods", 16, 4, 16, TS_FUSION_MIN, 1, 1, 0},
	{"particles", "megaviews", 0, 1, 16, TS_FUSION_MIN, 0, 1, 10},
	{"particles", "manylods", 0, 1, 16, TS_FUSION_MIN, 0, 1, 0},
};
enum { N_VIEWS = sizeof view_methods / sizeof *view_methods };
static traced views[N_VIEWS];
static const struct { const char *method; u32 filter, shader, accumulation; f32 sigma, eps; } surfel_methods[] = {
	{"deferred", TS_FILTER_MIN, TS_SHADER_PHONG_SHADOW, TS_ACCUMULATION_FIXED, 1, 0},
	{"deferred", TS_FILTER_OBJECT, TS_SHADER_NPR_SHADOW, TS_ACCUMULATION_FLOAT32, 1, 0.05f},
	{"deferred", TS_FILTER_SCREEN, TS_SHADER_NPR, TS_ACCUMULATION_HALF, 2, 0.5f},
	{"ewa", TS_FILTER_MIN, TS_SHADER_PHONG, TS_ACCUMULATION_FIXED, 1, 0.25f},
};
enum { N_SURFELS = sizeof surfel_methods / sizeof *surfel_methods };
static traced surfels[N_SURFELS];
static void make_indirect(void)
{
	ts_params params = small_params(96, 64);
	params.grid_px = 64;
	params.rsm_px = 4;
	for (u32 i = 0; i < N_INDIRECT; i++) {
		params.surface = indirect_methods[i].surface;
		params.interpolation = indirect_methods[i].interpolation;
		params.sharpness = indirect_methods[i].sharpness;
		params.cosine = indirect_methods[i].cosine;
		params.integrals = indirect_methods[i].integrals;
		make(&indirect[i], "indirect", indirect_methods[i].method, &params);
	}
}

static void make_views(void)
{
	ts_params params = small_params(96, 64);
	params.rsm_px = 4;
	params.levels = 5;
	params.gather_level = 3;
	params.filter_px = 3;
	params.particles = 200;
	params.bias = params.bias_slope = 0.25f;
	params.light_bias = 0.5f;
	for (u32 i = 0; i < N_VIEWS; i++) {
		params.vpls = view_methods[i].vpls;
		params.vpl_bounces = view_methods[i].bounces;
		params.gather_lights = view_methods[i].lights;
		params.fusion = view_methods[i].fusion;
		params.multipixel = view_methods[i].multipixel;
		params.shadows = view_methods[i].shadows;
		params.cutoff = view_methods[i].cutoff;
		make(&views[i], view_methods[i].effect, view_methods[i].method, &params);
	}
}

static void make_surfels(void)
{
	ts_params params = small_params(96, 64);
	params.reflectors = 0;
	params.from_mesh = 6000;
	params.map_px = 64;
	for (u32 i = 0; i < N_SURFELS; i++) {
		params.filter = surfel_methods[i].filter;
		params.shader = surfel_methods[i].shader;
		params.accumulation = surfel_methods[i].accumulation;
		params.sigma = surfel_methods[i].sigma;
		params.eps = surfel_methods[i].eps;
		make(&surfels[i], "surfels", surfel_methods[i].method, &params);
	}
}

static int make_all(void **state)
{
	(void)state;
	ts_params params = small_params(96, 64);
	params.reflectors = 3;
	params.reflector_px = 40;
	params.bounces = 2;
	params.mvr_faces = TS_MVR_FACES_ADAPTIVE;
	make(&epr, "reflections", "epr", &params);
	make(&mvr, "reflections", "mvr", &params);
	params.planedepth = 1;
	make(&plane, "reflections", "epr", &params);
	params.views = params.light_samples = 5;
	params.map_px = 64;
	params.pass = 2;
	for (u32 i = 0; i < N_SHADOWS; i++) make(&shadows[i], shadow_methods[i].effect, shadow_methods[i].method, &params);
	make_indirect();
	make_views();
	make_surfels();
	return 0;
}

static int drop_all(void **state)
{
	(void)state;
	drop(&epr);
	drop(&mvr);
	drop(&plane);
	for (u32 i = 0; i < N_SHADOWS; i++) drop(&shadows[i]);
	for (u32 i = 0; i < N_INDIRECT; i++) drop(&indirect[i]);
	for (u32 i = 0; i < N_VIEWS; i++) drop(&views[i]);
	for (u32 i = 0; i < N_SURFELS; i++) drop(&surfels[i]);
	return 0;
}

static void try_pixel(const traced *t, u32 pixel)
{
	json_t *answer;
	const f32 *radiance = data(t, TS_B_image_radiance);
	u32 width = t->run.params.width;
	require(ask_pixel(t, pixel % width, pixel / width, &answer));
	assert_true(assert_agrees(answer) >= 2);
	const json_t *bits = json_object_get(get(answer, "image", "radiance"), "bits");
	for (u32 c = 0; c < 3; c++) assert_int_equal(bits_of(json_array_get(bits, c)), ts_f2u(radiance[pixel * 3 + c]));
	json_decref(answer);
}

/* Every term of every one of these pixels adds up to the bits of the picture. */
static void pixels_of(const traced *t)
{
	const ts_pixel *records = data(t, TS_B_pixel_record);
	u32 n = (u32)count(t, TS_B_pixel_record);
	assert_true(n > N_TRIED);
	for (u32 i = 0; i < N_TRIED; i++) try_pixel(t, records[below(n)].index);
	for (u32 i = 0; i < N_TRIED; i++) try_pixel(t, below(t->run.params.width * t->run.params.height));
}

static void test_pixels_epr(void **state)
{
	(void)state;
	pixels_of(&epr);
}

static void test_pixels_mvr(void **state)
{
	(void)state;
	pixels_of(&mvr);
}

static void test_pixels_of_bounces(void **state)
{
	(void)state;
	const ts_bounce *queue = data(&epr, TS_B_lookup2_parent);
	const ts_pixel *records = data(&epr, TS_B_pixel_record);
	assert_true(count(&epr, TS_B_lookup2_parent) > 0);
	for (u32 i = 0; i < 8; i++) {
		try_pixel(&epr, records[queue[below((u32)count(&epr, TS_B_lookup2_parent))].parent / 25].index);
	}
}

/* The first of the competitors is the key that the buffer holds. */
static json_t *try_texel(const traced *t, u64 texel, u64 key, const char *depth, const char *index)
{
	json_t *answer;
	char view[32];
	const ts_face *cubes = data(t, TS_B_resize_face);
	u32 r = 0;
	while (texel - cubes[r].offset >= (u64)6 * cubes[r].n * cubes[r].n) r++;
	u64 n = cubes[r].n, inside = texel - cubes[r].offset;
	snprintf(view, sizeof view, "%u.%u", (unsigned)r, (unsigned)(inside / (n * n)));
	require(ask_texel(t, view, (u32)(inside % n), (u32)(inside / n % n), &answer));
	assert_true(assert_agrees(answer) >= 1);
	assert_int_equal(figure(answer, "element"), texel);
	const json_t *first = json_array_get(json_object_get(answer, "by_depth"), 0);
	assert_int_equal(figure(first, index), (u32)key);
	assert_int_equal(bits_of(json_object_get(json_object_get(first, depth), "bits")), key >> 32);
	return answer;
}

static void test_texels(void **state)
{
	(void)state;
	const u64 *keys = data(&epr, TS_B_splat_depth_index);
	for (u32 i = 0; i < N_TRIED;) {
		u64 texel = below((u32)count(&epr, TS_B_splat_depth_index));
		if (keys[texel] == TS_EMPTY) continue;
		json_decref(try_texel(&epr, texel, keys[texel], "distance", "point"));
		i++;
	}
}

/* A texel that is marked as tied has two competitors at the least distance. */
static void test_ties(void **state)
{
	(void)state;
	const u8 *tie = data(&plane, TS_B_splat_tie);
	const u64 *keys = data(&plane, TS_B_splat_depth_index);
	u32 n_tried = 0;
	for (u64 texel = 0; texel < count(&plane, TS_B_splat_tie) && n_tried < N_TRIED; texel++) {
		if (tie[texel] == 0) continue;
		json_t *answer = try_texel(&plane, texel, keys[texel], "distance", "point");
		assert_int_equal(figure(answer, "won_by_ulps"), 0);
		assert_true(json_is_true(json_object_get(answer, "tied")));
		json_decref(answer);
		n_tried++;
	}
	assert_int_equal(n_tried, N_TRIED);
}

/* The frame keeps the last reflector's faces alone. */
static void test_texels_mvr(void **state)
{
	(void)state;
	const u64 *keys = data(&mvr, TS_B_face_depth_triangle);
	const ts_face *cubes = data(&mvr, TS_B_resize_face);
	u64 first = cubes[count(&mvr, TS_B_resize_face) - 1].offset;
	for (u32 i = 0; i < N_TRIED;) {
		u64 inside = below((u32)count(&mvr, TS_B_face_depth_triangle));
		if (keys[inside] == TS_EMPTY) continue;
		json_decref(try_texel(&mvr, first + inside, keys[inside], "depth", "triangle"));
		i++;
	}
}

/* The least of a figure of the samples, as its bits; all ones: none has it. */
static u64 least_of(const json_t *samples, const char *name)
{
	f32 least = INFINITY;
	size_t i;
	json_t *sample;
	json_array_foreach((json_t *)samples, i, sample) {
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
	json_array_foreach((json_t *)samples, i, sample) {
		n += strncmp(json_string_value(json_object_get(sample, "answer")), "reaches", 7) == 0;
	}
	return n;
}

/* The samples add up to the buffers: those that reach the pixel, and of their margins the least. Returns how many
 * do. */
static u32 try_shadow(const traced *t, u32 pixel)
{
	json_t *answer;
	u32 width = t->run.params.width, lit = ((const u32 *)data(t, TS_B_resolve_lit))[pixel];
	if (((const u64 *)data(t, TS_B_eye_depth_triangle))[pixel] == TS_EMPTY) return 0;
	require(ask_pixel(t, pixel % width, pixel / width, &answer));
	const json_t *light = json_array_get(json_object_get(answer, "shadow"), 0);
	const json_t *samples = json_object_get(light, "by_sample");
	assert_int_equal(figure(light, "reach"), lit);
	if (samples != NULL) {
		const u64 *margin = (const u64 *)data(t, TS_B_resolve_margin) + pixel * 2;
		assert_int_equal(n_reaching(samples), lit);
		assert_int_equal(json_array_size(samples), 5);
		assert_true(least_of(samples, "edge_margin") == margin[0]);
		assert_true(least_of(samples, "depth_margin") == margin[1]);
	}
	json_decref(answer);
	return lit;
}

static void test_shadows(void **state)
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

static void assert_bits(f32 found, f32 right) { assert_int_equal(ts_f2u(found), ts_f2u(right)); }

/* The corners' parameters by their shares are the lobe's, these its integral, and that the irradiance. */
static void try_lobe(const ts_params *params, const json_t *corners, const json_t *lobe, u32 c, f32 irradiance)
{
	f32 mu = 0, lambda = 0, shares = 0, integral = shown(lobe, "A_h", 0);
	for (u32 k = 0; k < 4; k++) {
		const json_t *corner = json_array_get(corners, k), *fitted = json_object_get(corner, "fitted");
		f32 share = shown(corner, "share", 0);
		shares += share;
		mu += share * shown(fitted, "mu", c);
		lambda += share * shown(fitted, "lambda", c);
	}
	assert_true(fabsf(shares - 1) < 1e-6f);
	if (params->interpolation == TS_INTERPOLATION_PARAMETERS) {
		assert_bits(shown(lobe, "mu", 0), mu);
		assert_bits(shown(lobe, "lambda", 0), lambda);
	}
	if (params->cosine == TS_COSINE_IS_OURS) {
		f32 share = shown(lobe, "c", 0), up = share * shown(lobe, "A_u", 0), down = (1 - share) * shown(lobe, "A_b", 0);
		assert_bits(integral, up + down);
	}
	if (params->cosine == TS_COSINE_IS_CONSTANT) {
		assert_bits(integral, fmaxf(0, shown(lobe, "cos_beta", 0)) * shown(lobe, "A", 0));
	}
	f32 product = shown(lobe, "mu", 0) * integral;
	assert_bits(irradiance, product * 0.318309873f);
}

/* Every triangle of light that gives something, in their own order. */
static f32 sum_of(const json_t *terms, u32 n, u32 c)
{
	f32 sum = 0;
	for (u32 patch = 0; patch < n; patch++) {
		size_t i;
		json_t *term;
		json_array_foreach((json_t *)terms, i, term) {
			if (figure(term, "patch") != patch) continue;
			assert_bits(shown(term, "irradiance", c), shown(term, "exitance", c) * shown(term, "form_factor", 0));
			sum += shown(term, "irradiance", c);
		}
	}
	return sum;
}

/* Returns whether there is light. */
static bool try_indirect(const traced *t, u32 pixel)
{
	json_t *answer;
	u32 width = t->run.params.width;
	const f32 *irradiance = (const f32 *)data(t, TS_B_indirect_irradiance) + pixel * 3;
	const f32 *radiance = (const f32 *)data(t, TS_B_image_radiance) + pixel * 3;
	if (((const u64 *)data(t, TS_B_eye_depth_triangle))[pixel] == TS_EMPTY) return false;
	require(ask_pixel(t, pixel % width, pixel / width, &answer));
	const json_t *lobes = json_object_get(answer, "lobes"), *corners = json_object_get(answer, "corners");
	const json_t *direct = json_object_get(answer, "direct");
	for (u32 c = 0; c < 3; c++) {
		assert_bits(shown(json_object_get(answer, "light"), "irradiance", c), irradiance[c]);
		assert_bits(radiance[c], shown(json_object_get(answer, "gbuffer"), "albedo", c) * (irradiance[c] * 0.318309873f));
		if (direct != NULL) assert_bits(irradiance[c], sum_of(json_object_get(direct, "brightest"), 16, c));
		if (lobes != NULL) try_lobe(&t->run.params, corners, json_array_get(lobes, c), c, irradiance[c]);
	}
	if (direct == NULL) {
		u32 box = ((const u32 *)data(t, TS_B_hull_box))[pixel];
		const json_t *found = json_object_get(json_object_get(answer, "hull"), "box");
		assert_true(box == TS_NONE ? lobes == NULL && json_is_string(found) : (u32)json_integer_value(found) == box);
		assert_true(assert_agrees(answer) >= (box == TS_NONE ? 4 : 16));
	}
	json_decref(answer);
	return irradiance[0] > 0;
}

static void test_indirect(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_INDIRECT; i++) {
		const traced *t = &indirect[i];
		u32 n_lit = 0;
		json_t *answer;
		for (u32 k = 0; k < N_TRIED; k++) {
			u32 pixel = below(t->run.params.width * t->run.params.height);
			try_pixel(t, pixel);
			n_lit += try_indirect(t, pixel);
		}
		assert_true(n_lit > N_TRIED / 8);
		assert_int_equal(ask_triangle(t, 0, &answer), TS_ERROR);
	}
}

/* The entry of a light among those that are listed. */
static const json_t *listed(const json_t *lights, u64 light)
{
	size_t i;
	json_t *entry;
	json_array_foreach(json_object_get(lights, "brightest"), i, entry) {
		if (figure(entry, "light") == light) return entry;
	}
	fail_msg("light %u is not listed", (unsigned)light);
	return NULL;
}

/* What the light sends is its flux by the geometry, or nothing where its map says so. Returns whether it is in
 * shadow. */
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
	json_array_foreach(json_object_get(lights, "drawn"), i, entry) {
		const json_t *light = listed(lights, (u64)json_integer_value(entry));
		for (u32 c = 0; c < 3; c++) sum[c] += shown(light, "irradiance", c);
	}
	assert_int_equal(i, figure(lights, "draws"));
	for (u32 c = 0; c < 3; c++) assert_bits(ts_put(sum[c] * shown(lights, "share", 0)), right[c]);
	json_array_foreach(json_object_get(lights, "brightest"), i, entry) n_dark += try_light(t, entry);
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
		json_array_foreach(json_object_get(column, "heaviest"), i, entry) {
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

/* What is left and what is culled is all there is, and the list has what is left. */
static u64 try_culling(const traced *t, const json_t *culling)
{
	const u32 *offset = data(t, TS_B_vpl_pairs_offset), *level = data(t, TS_B_octree_level);
	u64 node = figure(culling, "node") - level[figure(culling, "level")];
	u64 unseen = figure(json_object_get(culling, "culled_as_they_look_elsewhere"), "views");
	u64 far = figure(json_object_get(culling, "culled_beyond_cutoff"), "views");
	const json_t *left = json_object_get(culling, "left");
	assert_int_equal(figure(left, "nodes"), offset[node + 1] - offset[node]);
	assert_int_equal(figure(left, "views") + unseen + far, count(t, TS_B_vpl_light));
	assert_true(t->run.params.cutoff > 0 || far == 0);
	return unseen + far;
}

static void test_views(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_VIEWS; i++) {
		const traced *t = &views[i];
		u32 n_dark = 0, n_tried = 0;
		u64 n_culled = 0;
		for (u32 k = 0; k < N_TRIED / 2; k++) {
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
		bool culls = i == 0 || t->run.params.cutoff > 0;
		assert_true(n_tried > N_TRIED / 4 && (n_culled > 0 || !culls));
		assert_true(t->run.params.shadows == 0 ? n_dark == 0 : n_dark > 0);
	}
}

static u32 triangle_of(u32 point)
{
	const ts_point *points = data(&epr, TS_B_points_record);
	return ((const ts_piece *)data(&epr, TS_B_split_triangle))[points[point].piece].triangle;
}

/* What became of a triangle, counted from the buffers. */
typedef struct { bool seen, kept; u64 points, won, samples; } truth;

static truth truth_of(u32 triangle)
{
	const u64 *bits = data(&epr, TS_B_visibility_bits), *keys = data(&epr, TS_B_splat_depth_index);
	const u32 *offset = data(&epr, TS_B_split_offset), *keep = data(&epr, TS_B_cull_keep);
	const u32 *before = data(&epr, TS_B_count_offset), *found = data(&epr, TS_B_lookup_point);
	const u32 *found2 = data(&epr, TS_B_lookup2_point);
	truth t = {.seen = bits[triangle] != 0};
	for (u32 q = offset[triangle]; q < offset[triangle + 1]; q++) t.kept |= keep[q] != 0;
	t.points = before[offset[triangle + 1]] - before[offset[triangle]];
	for (u64 i = 0; i < count(&epr, TS_B_splat_depth_index); i++) {
		t.won += keys[i] != TS_EMPTY && triangle_of((u32)keys[i]) == triangle;
	}
	for (u64 i = 0; i < count(&epr, TS_B_lookup_point); i++)
		t.samples += found[i] != TS_NONE && triangle_of(found[i]) == triangle;
	for (u64 i = 0; i < count(&epr, TS_B_lookup2_point); i++) {
		t.samples += found2[i] != TS_NONE && triangle_of(found2[i]) == triangle;
	}
	return t;
}

static const char *stage_of(const truth *t)
{
	if (!t->seen) return "visibility";
	if (!t->kept) return "cull";
	if (t->points == 0) return "count";
	return t->won == 0 ? "splat" : t->samples == 0 ? "lookup" : "no stage";
}

static void try_triangle(u32 triangle)
{
	json_t *answer;
	truth t = truth_of(triangle);
	require(ask_triangle(&epr, triangle, &answer));
	assert_true(assert_agrees(answer) >= 2);
	assert_int_equal(json_integer_value(get(answer, "cubes", "points")), t.points);
	assert_int_equal(json_integer_value(get(answer, "cubes", "texels_won")), t.won);
	const json_t *lost = json_object_get(answer, "lost_at");
	const char *stage =
		json_is_string(lost) ? json_string_value(lost) : json_string_value(json_object_get(lost, "stage"));
	bool tie = strcmp(stage, "tie") == 0 && strcmp(stage_of(&t), "splat") == 0;
	if (!tie) assert_string_equal(stage, stage_of(&t));
	json_decref(answer);
}

/* Triangles that each stage loses, as many as there are, up to 6 each. */
static void test_triangles(void **state)
{
	(void)state;
	static const char *const stages[] = {"visibility", "cull", "splat", "lookup", "no stage"};
	u32 tried[5] = {0}, n = (u32)count(&epr, TS_B_scene_triangle);
	for (u32 i = 0; i < 1500; i++) {
		u32 triangle = below(n);
		truth t = truth_of(triangle);
		for (u32 s = 0; s < 5; s++) {
			if (strcmp(stages[s], stage_of(&t)) != 0 || tried[s] == 6) continue;
			tried[s]++;
			try_triangle(triangle);
		}
	}
	for (u32 s = 0; s < 5; s++) {
		if (tried[s] == 0) fail_msg("no triangle was lost at %s", stages[s]);
	}
}

static void test_points(void **state)
{
	(void)state;
	const u64 *keys = data(&epr, TS_B_points_key), *texels = data(&epr, TS_B_splat_depth_index);
	for (u32 i = 0; i < 20; i++) {
		json_t *answer, *by_key;
		u64 won = 0;
		u32 point = below((u32)count(&epr, TS_B_points_key));
		require(ask_key(&epr, keys[point], &by_key));
		require(ask_point(&epr, point, &answer));
		assert_int_equal(figure(by_key, "point"), point);
		assert_true(json_equal(answer, by_key));
		json_decref(by_key);
		for (u64 k = 0; k < count(&epr, TS_B_splat_depth_index); k++)
			won += texels[k] != TS_EMPTY && (u32)texels[k] == point;
		assert_int_equal(json_integer_value(get(answer, "cubes", "texels_won")), won);
		assert_int_equal(figure(answer, "triangle"), triangle_of(point));
		assert_agrees(answer);
		json_decref(answer);
	}
}

static double dot3(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/* Where the ray of a pixel meets the plane of a surfel, r3D and how deep, and how far the pixel is from its centre,
 * r2D. */
typedef struct { double r3, r2, z; } met;

static met meet(const traced *t, u32 surfel, u32 x, u32 y)
{
	const ts_surfel *s = (const ts_surfel *)data(t, TS_B_scene_surfel) + surfel;
	const ts_view *view = data(t, TS_B_eye_view);
	double px = x + 0.5 - view->width / 2.0, py = view->height / 2.0 - y - 0.5, f = view->focal, z;
	double way[3], to[3], u[3], v[3], n[3], d[3], cx, cy;
	for (u32 k = 0; k < 3; k++) {
		way[k] = px / f * (double)view->right[k] + py / f * (double)view->up[k] - (double)view->back[k];
		to[k] = (double)s->centre[k] - (double)view->eye[k];
		u[k] = s->u[k];
		v[k] = s->v[k];
	}
	for (u32 k = 0; k < 3; k++) n[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
	z = dot3(to, n) / dot3(way, n);
	for (u32 k = 0; k < 3; k++) d[k] = way[k] * z - to[k];
	cx = cy = 0;
	double deep = 0;
	for (u32 k = 0; k < 3; k++) {
		cx += to[k] * (double)view->right[k];
		cy += to[k] * (double)view->up[k];
		deep -= to[k] * (double)view->back[k];
	}
	double a = dot3(d, u) / dot3(u, u), b = dot3(d, v) / dot3(v, v);
	return (met){hypot(a, b), hypot(f * cx / deep - px, f * cy / deep - py) / (double)t->run.params.sigma, z};
}

/* A fragment against that ray. Returns its weight. */
static double try_fragment(const traced *t, const json_t *fragment, u32 x, u32 y)
{
	u32 surfel = (u32)figure(fragment, "surfel"), filter = t->run.params.filter;
	met is = meet(t, surfel, x, y);
	double weight = (double)shown(fragment, "weight", 0), k = (double)t->run.params.sigma_k;
	const json_t *r3 = json_object_get(fragment, "r3D"), *r2 = json_object_get(fragment, "r2D");
	bool centre = json_object_get(fragment, "depth_of") != NULL;
	if (r3 != NULL) assert_true(fabs(json_real_value(r3) / is.r3 - 1) < 0.02);
	if (r2 != NULL) assert_true(fabs(json_real_value(r2) / is.r2 - 1) < 0.02);
	if (!centre) assert_true(fabs((double)shown(fragment, "depth", 0) / is.z - 1) < 1e-4);
	if (json_object_get(fragment, "peak") != NULL) return weight;
	double r = filter == TS_FILTER_OBJECT ? is.r3 : filter == TS_FILTER_SCREEN || centre ? is.r2 : fmin(is.r3, is.r2);
	assert_true(fabs(weight - exp(-0.5 * r * r / (k * k))) < 0.01);
	return weight;
}

/* No surfel that is inside its ellipse is nearer. */
static void try_nearest(const traced *t, const json_t *visibility, u32 x, u32 y)
{
	const json_t *found = json_object_get(visibility, "nearest");
	const ts_disc *discs = data(t, TS_B_surfel_setup_disc);
	double least = found != NULL ? (double)shown(visibility, "depth", 0) : 1e30;
	for (u32 i = 0; i < count(t, TS_B_scene_surfel); i++) {
		if (discs[i].high[0] < 0 || (discs[i].flags & TS_DISC_FLAT) != 0) continue;
		met is = meet(t, i, x, y);
		assert_false(is.r3 < 0.999 && is.z > 0.011 && is.z < least * 0.9999);
	}
}

/* Every fragment where rays say; listed ones and the others make up the sum of weights; what hides is nearer than
 * what is hidden. Returns how many are hidden. */
static u64 try_surfels(const traced *t, u32 x, u32 y)
{
	json_t *answer, *fragment;
	size_t i;
	double sum = 0;
	require(ask_pixel(t, x, y, &answer));
	const json_t *blended = json_object_get(answer, "blended"), *hidden = json_object_get(answer, "hidden_by_epsilon");
	json_array_foreach(json_object_get(blended, "heaviest"), i, fragment) {
		double weight = try_fragment(t, fragment, x, y);
		assert_true(json_object_get(fragment, "behind") == NULL);
		if (i == 0) assert_int_equal(figure(fragment, "surfel"), figure(json_object_get(answer, "heaviest"), "surfel"));
		sum += weight;
	}
	json_array_foreach(json_object_get(hidden, "heaviest"), i, fragment) {
		try_fragment(t, fragment, x, y);
		assert_true(json_real_value(json_object_get(fragment, "behind")) > 0);
	}
	const json_t *others = json_object_get(blended, "others");
	if (others != NULL) sum += json_real_value(json_object_get(others, "weight"));
	double told = json_real_value(get(answer, "sums", "weight"));
	bool halves = t->run.params.accumulation == TS_ACCUMULATION_HALF;
	assert_true(fabs(sum - told) < (halves ? 0.01 * (1 + sum) : 1e-4));
	assert_int_equal(figure(json_object_get(answer, "sums"), "fragments"), figure(blended, "fragments"));
	if (x % 4 == 0) try_nearest(t, json_object_get(answer, "visibility"), x, y);
	u64 n = figure(hidden, "fragments");
	json_decref(answer);
	return n;
}

static void test_surfels(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_SURFELS; i++) {
		const traced *t = &surfels[i];
		u64 n_hidden = 0;
		json_t *answer;
		for (u32 k = 0; k < N_TRIED; k++) {
			u32 x = below(t->run.params.width), y = below(t->run.params.height);
			try_pixel(t, y * t->run.params.width + x);
			n_hidden += try_surfels(t, x, y);
		}
		assert_true(n_hidden > N_TRIED);
		assert_int_equal(ask_texel(t, "0.+X", 0, 0, &answer), TS_ERROR);
		assert_int_equal(ask_triangle(t, 0, &answer), TS_ERROR);
		assert_int_equal(ask_point(t, 0, &answer), TS_ERROR);
	}
}

static void test_nothing_there(void **state)
{
	(void)state;
	json_t *answer;
	assert_int_equal(ask_pixel(&epr, 96, 0, &answer), TS_ERROR);
	assert_null(answer);
	assert_int_equal(ask_texel(&epr, "3.+X", 0, 0, &answer), TS_ERROR);
	assert_int_equal(ask_texel(&epr, "0.6", 0, 0, &answer), TS_ERROR);
	assert_int_equal(ask_texel(&epr, "0.+X", 4096, 0, &answer), TS_ERROR);
	assert_int_equal(ask_triangle(&epr, count(&epr, TS_B_scene_triangle), &answer), TS_ERROR);
	assert_int_equal(ask_point(&epr, count(&epr, TS_B_points_key), &answer), TS_ERROR);
	assert_int_equal(ask_point(&mvr, 0, &answer), TS_ERROR);
	assert_int_equal(ask_key(&epr, UINT64_MAX, &answer), TS_ERROR);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_pixels_epr), cmocka_unit_test(test_pixels_mvr), cmocka_unit_test(test_pixels_of_bounces),
		cmocka_unit_test(test_texels), cmocka_unit_test(test_texels_mvr), cmocka_unit_test(test_ties),
		cmocka_unit_test(test_shadows), cmocka_unit_test(test_indirect), cmocka_unit_test(test_views),
		cmocka_unit_test(test_triangles), cmocka_unit_test(test_points), cmocka_unit_test(test_surfels),
		cmocka_unit_test(test_nothing_there),
	};
	return cmocka_run_group_tests(tests, make_all, drop_all);
}

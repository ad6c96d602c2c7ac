/* What the probe says of hulls and of direct gathering, against the buffers of the run that wrote the trace. */
#include "kernels/hulls/hull.h"
#include "tests/probe/probed.h"
#include "tests/whole.h"

enum { RSM = 4 };

static u32 n_tries(void) { return whole_or(50, 30); }

static const struct {
	const char *effect, *method;
	u32 surface, interpolation, sharpness, cosine, integrals;
	f32 radius;
	u32 facing, corners, gloss;
} indirect_methods[] = {
	{"indirect", "direct", 0, 0, 0, 0, 0, 0, 0, 0, 0},
	{"indirect", "hulls", TS_SURFACE_ROBUST, 0, 0, TS_COSINE_OURS, 0, 0, 0, 0, 0},
	{"indirect", "hulls", TS_SURFACE_PAPER, TS_INTERPOLATION_MOMENTS, TS_SHARPNESS_VMF, TS_COSINE_OURS,
     TS_INTEGRALS_PRINTED, 0, 0, 0, 0},
	{"indirect", "hulls", TS_SURFACE_ROBUST, 0, 0, TS_COSINE_CONSTANT, 0, 0, TS_FACING_PAPER, 0, 0},
	{"indirect", "hulls", TS_SURFACE_ROBUST, 0, 0, TS_COSINE_SG, 0, 0, 0, TS_CORNERS_RECTANGLE, 0},
	{"area-light", "direct", 0, 0, 0, 0, 0, 0.25f, 0, 0, 0},
	{"area-light", "hulls", TS_SURFACE_ROBUST, 0, 0, TS_COSINE_OURS, 0, 0.25f, 0, 0, 0},
	{"area-light", "direct", 0, 0, 0, 0, 0, 0, 0, 0, 0},
	{"area-light", "hulls", TS_SURFACE_ROBUST, 0, 0, TS_COSINE_OURS, 0, 0, 0, 0, 0},
	{"indirect", "direct", 0, 0, 0, 0, 0, 0, 0, 0, 1},
	{"indirect", "hulls", TS_SURFACE_ROBUST, 0, 0, TS_COSINE_OURS, 0, 0, 0, TS_CORNERS_RECTANGLE, 1},
	{"area-light", "direct", 0, 0, 0, 0, 0, 0, 0, 0, 1},
	{"area-light", "hulls", TS_SURFACE_PAPER, TS_INTERPOLATION_MOMENTS, 0, TS_COSINE_SG, 0, 0.25f, 0, 0, 1},
};
enum { N_INDIRECT = sizeof indirect_methods / sizeof *indirect_methods };
static traced indirect[N_INDIRECT];

static int make_all(void **state)
{
	(void)state;
	ts_params params = small_params(48, 32);
	params.depth_grid_px = 64;
	params.rsm_px = RSM;
	params.lamp_fov = 150; /* a lamp without extent has a cone */
	for (u32 i = 0; i < N_INDIRECT; i++) {
		params.hull_surface = indirect_methods[i].surface;
		params.hull_interpolation = indirect_methods[i].interpolation;
		params.hull_sharpness = indirect_methods[i].sharpness;
		params.hull_cosine = indirect_methods[i].cosine;
		params.hull_integrals = indirect_methods[i].integrals;
		params.lamp_radius = indirect_methods[i].radius;
		params.corner_facing = indirect_methods[i].facing;
		params.hull_corners = indirect_methods[i].corners;
		params.gloss_lobe = indirect_methods[i].gloss;
		make(&indirect[i], indirect_methods[i].effect, indirect_methods[i].method, &params);
	}
	return 0;
}

static int drop_all(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_INDIRECT; i++) drop(&indirect[i]);
	return 0;
}

/* The corners' parameters by their shares are the lobe's, these its integral, and that the irradiance. */
static void try_lobe(const ts_params *params, const json_t *corners, const json_t *lobe, u32 c, f32 irradiance)
{
	f32 mu = 0, lambda = 0, lit = 0, shares = 0, integral = shown(lobe, "A_h", 0);
	for (u32 k = 0; k < 4; k++) {
		const json_t *corner = json_array_get(corners, k), *fitted = json_object_get(corner, "fitted");
		f32 share = shown(corner, "share", 0), lit_share = shown(fitted, "mu", c) > 0 ? share : 0;
		shares += share;
		lit += lit_share;
		mu += share * shown(fitted, "mu", c);
		lambda += lit_share * shown(fitted, "lambda", c);
	}
	assert_true(fabsf(shares - 1) < 1e-6f);
	if (params->hull_interpolation == TS_INTERPOLATION_PARAMETERS) {
		assert_bits(shown(lobe, "mu", 0), mu);
		assert_bits(shown(lobe, "lambda", 0), lit > 0 ? lambda / lit : 1);
	}
	if (params->hull_cosine == TS_COSINE_OURS) {
		f32 t = ts_k_sg_t(shown(lobe, "lambda", 0)), s = ts_k_sg_s(t, shown(lobe, "cos_beta", 0));
		assert_true(json_real_value(json_object_get(lobe, "t")) == (double)t);
		assert_true(json_real_value(json_object_get(lobe, "s")) == (double)s);
		assert_bits(shown(lobe, "c", 0), ts_k_sg_c(s, shown(lobe, "cos_beta", 0)));
		f32 share = shown(lobe, "c", 0), up = share * shown(lobe, "A_u", 0), down = (1 - share) * shown(lobe, "A_b", 0);
		assert_bits(integral, up + down);
	}
	if (params->hull_cosine == TS_COSINE_CONSTANT) {
		assert_bits(integral, fmaxf(0, shown(lobe, "cos_beta", 0)) * shown(lobe, "A", 0));
	}
	f32 product = shown(lobe, "mu", 0) * integral;
	assert_bits(irradiance, product * 0.318309873f);
}

/* Of a reflective shadow map of RSM texels a side; there is one. */
static void try_texel(const json_t *term, u32 patch)
{
	const json_t *texel = json_object_get(term, "texel");
	assert_int_equal(figure(term, "view"), 0);
	assert_int_equal(json_integer_value(json_array_get(texel, 0)), patch % RSM);
	assert_int_equal(json_integer_value(json_array_get(texel, 1)), patch / RSM);
}

/* Every triangle of light that gives something, in their own order; or the one lamp without extent. */
static f32 sum_of(const json_t *terms, u32 n, u32 c)
{
	f32 sum = 0;
	if (json_array_size(terms) == 1 && json_object_get(json_array_get(terms, 0), "patch") == NULL)
		return shown(json_array_get(terms, 0), "irradiance", c);
	for (u32 patch = 0; patch < n; patch++) {
		size_t i;
		json_t *term;
		json_array_foreach ((json_t *)terms, i, term) {
			if (figure(term, "patch") != patch) continue;
			if (json_object_get(term, "view") == NULL) assert_true(figure(term, "light") == patch / 8);
			if (json_object_get(term, "view") != NULL) try_texel(term, patch);
			assert_bits(shown(term, "irradiance", c), shown(term, "exitance", c) * shown(term, "form_factor", 0));
			sum += shown(term, "irradiance", c);
		}
	}
	return sum;
}

/* What is reflected: of hulls the channel's product with the surface's lobe, of direct all that is listed, at most. */
static f32 try_gloss(const traced *t, const json_t *answer, u32 pixel, u32 c)
{
	f32 held = ((const f32 *)data(t, TS_B_indirect_specular))[pixel * 3 + c];
	const json_t *gloss = json_object_get(answer, "gloss"), *lobe = json_array_get(json_object_get(gloss, "lobes"), c);
	assert_bits(shown(json_object_get(answer, "reflected"), "radiance", c), held);
	if (gloss == NULL) return held; /* no box */
	const ts_gloss *surface = (const ts_gloss *)data(t, TS_B_gloss_pixel) + pixel;
	assert_bits(shown(gloss, "f0", c), surface->f0[c]);
	assert_bits(shown(gloss, "alpha_squared", 0), surface->alpha_squared);
	if (lobe != NULL) {
		f32 sent = (shown(lobe, "mu", 0) * shown(lobe, "A_h", 0)) * 0.318309873f;
		assert_true(fabsf(held - sent * shown(lobe, "V_F", c)) <= 1e-6f * held);
	}
	size_t i;
	json_t *term;
	f32 listed = 0;
	json_array_foreach ((json_t *)json_object_get(gloss, "brightest"), i, term) listed += shown(term, "radiance", c);
	assert_true(lobe != NULL || (listed <= held * 1.00001f && listed >= held / 16));
	return held;
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
	bool glossy = t->run.params.gloss_lobe != 0;
	assert_true(glossy == (json_object_get(answer, "reflected") != NULL));
	for (u32 c = 0; c < 3; c++) {
		assert_bits(shown(json_object_get(answer, "light"), "irradiance", c), irradiance[c]);
		f32 sent = shown(json_object_get(answer, "gbuffer"), "albedo", c) * (irradiance[c] * 0.318309873f);
		assert_bits(radiance[c], glossy ? sent + try_gloss(t, answer, pixel, c) : sent);
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

static void the_probe_tells_indirect_light(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_INDIRECT; i++) {
		const traced *t = &indirect[i];
		u32 n_lit = 0;
		json_t *answer;
		for (u32 k = 0; k < n_tries(); k++) {
			u32 pixel = below(t->run.params.width * t->run.params.height);
			try_pixel(t, pixel);
			n_lit += try_indirect(t, pixel);
		}
		assert_true(n_lit > n_tries() / 8);
		assert_int_equal(ask_triangle(t, 0, &answer), TS_ERROR);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(the_probe_tells_indirect_light),
	};
	return cmocka_run_group_tests(tests, make_all, drop_all);
}

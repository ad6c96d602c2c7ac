/* Specular reflection of lobes: the surface's lobe has GGX's peak and weight, and points to the mirrored eye; a narrow
 * light is reflected as the lobe says at its direction; uniform light nearly as the BRDF returns it; surfaces of known
 * materials; sums in the order of the triangles; and no input gives what is no number. */
#include "kernels/hulls/gloss.h"
#include "methods/hulls/tools/truth_gloss.h"
#include "tests/kernels/hulls/gaussian_truth.h"
#include "tests/kernels/hulls/room.h"
#include "tests/kernels/small.h"

enum { N = 2000, STEPS = 160 };

static ts_glossy glossy_of(ts_v3 n, ts_v3 v, ts_v3 f0, f32 a2)
{
	ts_gpixel pixel;
	ts_gloss gloss = {.alpha_squared = a2};
	ts_store3(gloss.f0, f0);
	ts_k_gpixel_store(&pixel, ts_v3_make(0, 0, 0), 0.5f, n, f0);
	return ts_k_glossy(&pixel, &gloss, v, TS_COSINE_QUADRATURE, 0);
}

static ts_v3 about(ts_v3 n, f32 cosine)
{
	ts_v3 across = ts_normalize(ts_cross(n, direction()));
	return ts_normalize(ts_mad(ts_scale(n, cosine), across, ts_sqrt(1.0f - cosine * cosine)));
}

static void lobes_have_the_peak_of_ggx(void **state)
{
	(void)state;
	for (u32 i = 0; i <= 512; i++) {
		f32 a2 = i < 18 ? 1.0f / (f32)(1u << i) : (f32)i / 512;
		ts_v3 n = direction(), v = about(n, uniform(0.1f, 1));
		ts_sg at_n = ts_k_gloss_lobe(n, n, a2), lobe = ts_k_gloss_lobe(n, v, a2);
		double weight = sg_up(4 * (double)at_n.lambda) * (double)at_n.mu;
		assert_near(weight, 1, 0.014);
		assert_near(at_n.mu, 1 / (sg_pi * (double)a2), 1e-6 / (double)a2);
		assert_near(lobe.lambda * ts_dot(n, v), at_n.lambda, 1e-4 * (double)at_n.lambda);
		ts_v3 half = ts_normalize(ts_add(lobe.phi, v));
		assert_near(ts_dot(half, n), 1, 1e-6);
	}
}

/* Light from one direction: D V F cos there, D of the lobe, V and F by Smith and Schlick in double precision. */
static void narrow_light_is_reflected_by_the_lobe(void **state)
{
	(void)state;
	u32 n_bright = 0;
	for (u32 i = 0; i < N; i++) {
		ts_v3 n = direction(), v = about(n, uniform(0.1f, 1)), l = about(n, uniform(0.1f, 1));
		f32 a2 = uniform(0.05f, 1), m = uniform(0.1f, 9);
		ts_glossy at = glossy_of(n, v, ts_v3_make(1, 1, 1), a2);
		ts_sg light = ts_sg_make(m / ts_k_sg_integral(1e5f), 1e5f, l);
		ts_sg both = ts_k_sg_product(&light, &at.lobe);
		double found = (double)ts_k_gloss_reflected(&at, &both).y;
		double nl = (double)ts_dot(n, l), nv = (double)ts_dot(n, v), a = (double)a2;
		double smith = 0.5 / (nl * sqrt(nv * nv * (1 - a) + a) + nv * sqrt(nl * nl * (1 - a) + a));
		double lobe = sg_value(at.lobe.mu, at.lobe.lambda, ts_dot(at.lobe.phi, l));
		double right = (double)m / sg_pi * lobe * smith * nl;
		assert_near(found, right, 0.02 * right + 1e-6);
		n_bright += right > 0.01;
	}
	assert_true(n_bright > N / 4);
}

/* What the BRDF returns of light that is the same from all sides, by rings about the normal. */
static double returned(const ts_glossy *at, f32 a2)
{
	ts_gloss gloss = {.f0 = {1, 1, 1}, .alpha_squared = a2};
	ts_truth_glossy of = ts_truth_glossy_of(&gloss, ts_v3_make(0, 0, 0), at->n, at->v);
	ts_v3 u = ts_normalize(ts_cross(at->n, ts_v3_make(0.3f, 0.5f, 0.8f))), w = ts_cross(at->n, u);
	double sum = 0;
	for (u32 i = 0; i < STEPS * STEPS; i++) {
		double cosine = (i % STEPS + 0.5) / STEPS, sine = sqrt(1 - cosine * cosine);
		double turn = 2 * sg_pi * (i / STEPS + 0.5) / STEPS;
		ts_double3 l = ts_double3_mad((ts_double3){0, 0, 0}, ts_double3_of(at->n), cosine);
		l = ts_double3_mad(ts_double3_mad(l, ts_double3_of(u), sine * cos(turn)), ts_double3_of(w), sine * sin(turn));
		sum += ts_truth_gloss_brdf(&of, l).y * 2 * sg_pi / (STEPS * STEPS);
	}
	return sum;
}

static void uniform_light_returns_nearly_as_the_brdf(void **state)
{
	(void)state;
	static const f32 alphas[] = {1, 0.7f, 0.4f, 0.2f}, cosines[] = {1, 0.7f, 0.4f};
	double worst = 0;
	for (u32 i = 0; i < 12; i++) {
		f32 a2 = alphas[i % 4] * alphas[i % 4];
		ts_v3 n = direction(), v = about(n, cosines[i / 4]);
		ts_glossy at = glossy_of(n, v, ts_v3_make(1, 1, 1), a2);
		ts_sg light = ts_sg_make((f32)sg_pi, 0.0f, ts_v3_make(0, 0, 0));
		ts_sg both = ts_k_sg_product(&light, &at.lobe);
		double found = (double)ts_k_gloss_reflected(&at, &both).y, right = returned(&at, a2);
		worst = fmax(worst, fabs(found / right - 1));
	}
	print_message("# uniform light within %.2f of what the BRDF returns\n", worst);
	assert_true(worst < 0.3);
}

static void any_input_reflects_to_a_number(void **state)
{
	(void)state;
	for (u32 i = 0; i < 20 * N; i++) {
		ts_v3 n = direction(), v = direction(), none = {0, 0, 0};
		f32 a2 = i % 3 == 0 ? 1.0f / 262144.0f : uniform(0.000004f, 1);
		ts_glossy at = glossy_of(n, i % 7 == 0 ? n : v, uniform3(0, 1), a2);
		at.cosine = i % 4;
		at.printed = i / 4 % 2;
		f32 lambda = i % 5 == 0 ? 0.0f : ts_exp(uniform(-12, 11.5f));
		ts_sg light = ts_sg_make(ts_exp(uniform(-20, 20)), lambda, i % 11 == 0 ? none : direction());
		ts_sg both = ts_k_sg_product(&light, &at.lobe);
		ts_v3 sent = ts_k_gloss_reflected(&at, &both);
		for (u32 c = 0; c < 3; c++) assert_true((&sent.x)[c] >= 0 && (&sent.x)[c] < INFINITY);
	}
}

/* A triangle before the eye, of each material. */
static void each_material_has_its_reflectance(void **state)
{
	(void)state;
	static const struct {
		f32 metallic, roughness;
		u32 flags;
		f32 f0[3], a2;
	} rows[] = {
		{0, 0.5f, 0, {0.04f, 0.04f, 0.04f}, 0.0625f},
		{1, 1, 0, {0.5f, 0.25f, 0.75f}, 1},
		{0.5f, 0, 0, {0.27f, 0.145f, 0.395f}, 0x1p-18f},
		{0, 1, TS_UNLIT, {0, 0, 0}, 1},
	};
	for (u32 i = 0; i < 4; i++) {
		static small_scene scene;
		small_clear(&scene);
		small_add(&scene, ts_v3_make(-1, -9, -9), ts_v3_make(-1, 9, -9), ts_v3_make(-1, 0, 9), 0, 0);
		ts_material *m = &scene.materials[0];
		m->metallic = rows[i].metallic;
		m->roughness = rows[i].roughness;
		m->flags = rows[i].flags | TS_DOUBLE_SIDED;
		ts_store3(m->base, ts_v3_make(0.5f, 0.25f, 0.75f));
		ts_view eye = {
			.focal = 1, .right = {0, 0, 1}, .width = 2, .up = {0, 1, 0}, .height = 1, .back = {1, 0, 0}, .near = 0.1f};
		const u64 keys[2] = {(u64)ts_f2u(1) << 32, TS_EMPTY};
		ts_gloss gloss[2];
		ts_gloss_args args = {.scene = small_arrays(&scene), .view = &eye, .depth_triangle = keys, .pixels = gloss};
		for (u32 k = 0; k < 2; k++) ts_k_gloss_item(&args, k);
		assert_near(gloss[0].alpha_squared, rows[i].a2, 1e-7);
		assert_true(gloss[1].alpha_squared == 1);
		for (u32 c = 0; c < 3; c++) {
			assert_near(gloss[0].f0[c], rows[i].f0[c], 1e-6);
			assert_true(gloss[1].f0[c] == 0);
		}
	}
}

/* In a room of light: triangle by triangle in order, none from behind, none in the sky. */
static void gloss_adds_triangles_in_their_order(void **state)
{
	(void)state;
	enum { PARTS = 4, N_PATCHES = 12 * PARTS * PARTS };
	static ts_patch patches[N_PATCHES];
	room_make(patches, PARTS, ts_v3_make(1, 2, 4));
	for (u32 i = 0; i < 100; i++) {
		ts_v3 p = uniform3(-0.5f, 0.5f), n = direction();
		ts_view eye = {.eye = {0.9f, 0.9f, -0.9f}};
		ts_gpixel pixel;
		ts_k_gpixel_store(&pixel, p, i == 0 ? TS_SKY : 0.5f, n, p);
		ts_gloss gloss = {.f0 = {1, 1, 1}, .alpha_squared = uniform(0.3f, 1)};
		f32 sent[3];
		ts_gloss_direct_args args = {.of = {.pixels = &pixel, .patches = patches, .n_patches = N_PATCHES},
		                             .view = &eye,
		                             .gloss = &gloss,
		                             .specular = sent,
		                             .cosine = TS_COSINE_OURS};
		ts_k_gloss_direct_item(&args, 0);
		ts_glossy at = ts_k_glossy(&pixel, &gloss, ts_load3(eye.eye), args.cosine, 0);
		ts_v3 sum = {0, 0, 0};
		for (u32 k = 0; k < N_PATCHES && i > 0; k++) sum = ts_add(sum, ts_k_gloss_direct(&at, &patches[k], p, 0));
		assert_true(same_bits3(sum, ts_load3(sent)));
		if (i > 0 && ts_dot(n, at.v) > 0.1f) assert_true(sum.x > 0 && sum.y == 2 * sum.x && sum.z == 4 * sum.x);
		for (u32 k = 0; k < N_PATCHES; k++) ts_store3(patches[k].normal, ts_neg(ts_load3(patches[k].normal)));
		ts_k_gloss_direct_item(&args, 0);
		assert_true(sent[0] == 0 && sent[1] == 0 && sent[2] == 0);
		for (u32 k = 0; k < N_PATCHES; k++) ts_store3(patches[k].normal, ts_neg(ts_load3(patches[k].normal)));
	}
}

/* Of a triangle the part above the horizon, by many places of it; all of one that is above, to the bit; nothing of one
 * in the pixel's own plane. */
static void only_the_part_above_the_horizon_counts(void **state)
{
	(void)state;
	double worst = 0;
	u32 n_cut = 0;
	for (u32 i = 0; i < N; i++) {
		ts_v3 p = uniform3(-1, 1), n = direction(), c[3];
		double angle = 0;
		u32 n_above = 0;
		for (u32 k = 0; k < 3; k++) {
			c[k] = uniform3(-3, 3);
			n_above += ts_dot(n, ts_sub(c[k], p)) > 0;
		}
		ts_gloss_seen seen = ts_k_gloss_above(p, n, c[0], c[1], c[2]);
		f32 whole = ts_k_solid_angle(p, c[0], c[1], c[2]);
		if (n_above == 3) assert_near(seen.angle, whole, 2e-5f * whole + 1e-6f);
		if (n_above == 0) assert_true(seen.angle == 0);
		if (n_above % 3 == 0 || i % 20 != 0) continue;
		double3 a = d3_sub(d3_of(c[0]), d3_of(p)), b = d3_sub(d3_of(c[1]), d3_of(c[0]));
		double3 d = d3_sub(d3_of(c[2]), d3_of(c[0])), across = d3_cross(b, d);
		for (u32 k = 0; k < STEPS * STEPS; k++) {
			double u = (k % STEPS + 0.5) / STEPS, v = (k / STEPS + 0.5) / STEPS;
			double3 at = d3_mad(d3_mad(a, b, u + v > 1 ? 1 - u : u), d, u + v > 1 ? 1 - v : v);
			double far = d3_length(at);
			if (d3_dot(d3_of(n), at) > 0) angle += fabs(d3_dot(across, at)) / (far * far * far) / (2 * STEPS * STEPS);
		}
		worst = fmax(worst, fabs((double)seen.angle - angle) / (angle + 0.05));
		n_cut++;
	}
	print_message("# %u cut, within %.2g\n", n_cut, worst);
	assert_true(n_cut > N / 40 && worst < 0.05);
	ts_v3 x = {-1, 0, -1}, y = {0, 0, 2}, z = {1, 0, -1};
	for (f32 off = -1e-6f; off < 1.5e-6f; off += 1e-6f) {
		ts_gloss_seen flat = ts_k_gloss_above(ts_v3_make(0, off, 0), ts_v3_make(0, 1, 0), x, y, z);
		assert_true(off < 0 || flat.angle == 0);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(lobes_have_the_peak_of_ggx),
		seeded_test(narrow_light_is_reflected_by_the_lobe),
		seeded_test(uniform_light_returns_nearly_as_the_brdf),
		seeded_test(any_input_reflects_to_a_number),
		seeded_test(each_material_has_its_reflectance),
		seeded_test(gloss_adds_triangles_in_their_order),
		seeded_test(only_the_part_above_the_horizon_counts),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

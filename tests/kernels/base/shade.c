/* Shading against the textbook form of GGX in double precision, energy over the hemisphere by quadrature, reciprocity,
 * and the formulas of punctual lights. */
#include "kernels/base/shade.h"
#include "tests/kernels/small.h"

enum { N = 100000 };

static double pi;

static ts_surface material(ts_v3 base, f32 metallic, f32 roughness)
{
	ts_v3 z = ts_v3_make(0, 0, 1);
	return (ts_surface){
		.n = z,
		.face = z,
		.base = base,
		.metallic = metallic,
		.roughness = roughness,
		.occlusion = 1,
	};
}

/* A direction of the upper hemisphere at this cosine. */
static ts_v3 polar(double cosine, double turn)
{
	double sine = sqrt(1 - cosine * cosine);
	return ts_v3_make((f32)(sine * cos(2 * pi * turn)), (f32)(sine * sin(2 * pi * turn)), (f32)cosine);
}

/* Smith's shape of the microfacets: D by tangents, and Lambda. */
static double ggx(double cosine, double a)
{
	double c2 = cosine * cosine, tan2 = (1 - c2) / c2, k = 1 + tan2 / (a * a);
	return 1 / (pi * a * a * c2 * c2 * k * k);
}

static double lambda(double cosine, double a)
{
	return (sqrt(1 + a * a * (1 - cosine * cosine) / (cosine * cosine)) - 1) / 2;
}

/* BRDF times n.l for a channel of base colour. */
static double brdf(double base, double metallic, double roughness, double3 n, double3 v, double3 l)
{
	double3 h = d3_unit(d3_add(v, l));
	double a = fmax(roughness * roughness, 1.0 / 512), nl = d3_dot(n, l), nv = d3_dot(n, v);
	double f0 = 0.04 * (1 - metallic) + base * metallic, f = f0 + (1 - f0) * pow(1 - d3_dot(v, h), 5);
	double specular = ggx(d3_dot(n, h), a) / (1 + lambda(nv, a) + lambda(nl, a)) / (4 * nl * nv);
	return nl * (f * specular + (1 - f) * (1 - metallic) * base / pi);
}

static void brdf_matches_the_textbook_form(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		f32 roughness = uniform(0.25f, 1), metallic = uniform(0, 1);
		ts_surface s = material(uniform3(0, 1), metallic, roughness);
		ts_v3 n = direction(), v = direction(), l = direction();
		if (ts_dot(n, v) < 0.01f || ts_dot(n, l) < 0.01f) continue;
		ts_v3 r = ts_k_brdf(&s, n, v, l, ts_dot(n, l));
		for (u32 c = 0; c < 3; c++) {
			double truth = brdf((&s.base.x)[c], metallic, roughness, d3_of(n), d3_of(v), d3_of(l));
			assert_near((&r.x)[c], truth, 1e-4 * truth + 1e-6);
		}
	}
}

static void light_and_view_may_change_places(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_surface s = material(uniform3(0, 1), uniform(0, 1), uniform(0.1f, 1));
		ts_v3 v = polar(uniform(0.01f, 1), uniform(0, 1)), l = polar(uniform(0.01f, 1), uniform(0, 1));
		double there = (double)ts_k_brdf(&s, s.n, v, l, l.z).x / l.z;
		double back = (double)ts_k_brdf(&s, s.n, l, v, v.z).x / v.z;
		assert_near(there, back, 2e-3 * back);
	}
}

/* What is returned of uniform white light: the midpoint rule over l, fine enough for these roughnesses. */
static double albedo(const ts_surface *s, ts_v3 v, u32 steps)
{
	double sum = 0;
	for (u32 i = 0; i < steps; i++) {
		double cosine = (i + 0.5) / steps;
		for (u32 k = 0; k < 2 * steps; k++) {
			ts_v3 l = polar(cosine, (k + 0.5) / (2 * steps));
			sum += ts_k_brdf(s, s->n, v, l, l.z).x;
		}
	}
	return sum * 2 * pi / (2.0 * steps * steps);
}

/* White metal never returns more than it receives, a white dielectric nearly everything, black metal nearly nothing.
 * glTF weighs Lambert's part by the Fresnel term of the half-vector: seen along the surface a white one returns up to a
 * quarter too much. That is the model's; the textbook form agrees (brdf_matches_the_textbook_form). */
static void white_never_returns_more_than_it_receives(void **state)
{
	(void)state;
	ts_v3 white = {1, 1, 1}, black = {0, 0, 0};
	const f32 roughness[] = {0.3f, 0.5f, 0.8f, 1};
	const double cosines[] = {1, 0.8, 0.5, 0.2};
	for (u32 i = 0; i < 16; i++) {
		ts_v3 v = polar(cosines[i % 4], 0.1);
		ts_surface lambert = material(white, 0, roughness[i / 4]), metal = material(white, 1, roughness[i / 4]);
		double a = albedo(&lambert, v, 160), b = albedo(&metal, v, 160);
		assert_true(a > 0.8 && a <= (cosines[i % 4] >= 0.8 ? 1.001 : cosines[i % 4] >= 0.5 ? 1.05 : 1.25));
		assert_true(b > 0.25 && b <= 1.001);
		if (roughness[i / 4] <= 0.3f && cosines[i % 4] >= 0.5) assert_true(b > 0.97);
		ts_surface dark = material(black, 1, roughness[i / 4]);
		assert_true(albedo(&dark, v, 40) < (cosines[i % 4] >= 0.8 ? 0.05 : 0.5));
	}
}

/* A mirror-like lobe: integrated over half-vectors, where D is smooth, roughness 0.1 still returns what it receives. */
static void a_narrow_lobe_returns_what_it_receives(void **state)
{
	(void)state;
	enum { STEPS = 2000 };
	ts_surface s = material(ts_v3_make(1, 1, 1), 1, 0.1f);
	double sum = 0;
	for (u32 i = 0; i < STEPS; i++) {
		double tangent = 0.3 * (i + 0.5) / STEPS, cosine = 1 / sqrt(1 + tangent * tangent);
		double l_z = 2 * cosine * cosine - 1;
		double ring = 2 * pi * (4 * cosine) * cosine * cosine * cosine * tangent * 0.3 / STEPS;
		sum += (double)ts_k_brdf(&s, s.n, s.n, polar(l_z, 0.3), (f32)l_z).x * ring;
	}
	assert_true(sum > 0.98 && sum <= 1.001);
}

static bool is_sound(ts_v3 a)
{
	for (u32 c = 0; c < 3; c++) {
		f32 x = (&a.x)[c];
		if (!(x >= 0) || !(x <= 1e9f)) return false;
	}
	return true;
}

/* Grazing, opposite, along the normal, at roughness 0: finite and not negative. */
static void extreme_directions_shade_finite(void **state)
{
	(void)state;
	const f32 roughness[] = {0, 1e-3f, 0.01f, 1};
	for (u32 i = 0; i < N; i++) {
		ts_surface s = material(uniform3(0, 1), (f32)(i & 1), roughness[i / 2 % 4]);
		f32 z = ldexpf(1, -(int)below(40));
		ts_v3 v = i % 3 == 0 ? polar(z, uniform(0, 1)) : i % 3 == 1 ? s.n : direction();
		ts_v3 l = i % 5 == 0 ? ts_v3_make(-v.x, -v.y, ts_abs(v.z)) : i % 5 == 1 ? v : polar(z, uniform(0, 1));
		f32 n_l = ts_dot(s.n, l);
		if (n_l > 0) assert_true(is_sound(ts_k_brdf(&s, s.n, v, l, n_l)));
	}
}

static ts_light point_light(u32 kind)
{
	return (ts_light){.kind = kind, .position = {1, 2, 3}, .direction = {0, -1, 0}, .intensity = {1, 1, 1}};
}

static void directional_light_is_not_weakened(void **state)
{
	(void)state;
	ts_light light = point_light(TS_LIGHT_KIND_DIRECTIONAL);
	ts_v3 l;
	assert_true(ts_k_light(&light, uniform3(-9, 9), &l) == 1);
	assert_true(l.x == 0 && l.y == 1 && l.z == 0);
}

/* Inverse square, times the window that closes at the range. */
static void point_light_falls_by_the_inverse_square(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_light light = point_light(1);
		light.range = i % 2 == 0 ? 0 : uniform(0.5f, 8);
		ts_v3 p = uniform3(-5, 5), l;
		double3 to = d3_sub(d3_of(ts_load3(light.position)), d3_of(p));
		double d = d3_length(to), window = light.range > 0 ? fmax(0, 1 - pow(d / light.range, 4)) : 1;
		f32 arrives = ts_k_light(&light, p, &l);
		assert_near(arrives, window / (d * d), 2e-6 / (d * d));
		assert_true(d3_distance(d3_of(l), d3_unit(to)) <= 1e-6);
		if (light.range > 0 && d > light.range * 1.0001) assert_true(arrives == 0);
	}
	ts_light light = point_light(1);
	ts_v3 l;
	light.range = 4;
	assert_true(ts_k_light(&light, ts_v3_make(1, 2, 7), &l) == 0);
	assert_true(ts_k_light(&light, ts_v3_make(1, 2, 5), &l) == 0.25f * (1 - 1.0f / 16));
	assert_true(ts_k_light(&light, ts_v3_make(1, 2, 3), &l) == 0);
}

/* Full inside the inner cone, none outside the outer, the square of the linear ramp of cosines between. */
static void spot_light_fades_between_its_cones(void **state)
{
	(void)state;
	double inner = cos(0.4), outer = cos(0.9);
	ts_light light = point_light(TS_LIGHT_KIND_SPOT);
	light.spot_scale = (f32)(1 / (inner - outer));
	light.spot_offset = (f32)(-outer / (inner - outer));
	for (u32 i = 0; i < N; i++) {
		double angle = uniform(0, 1.5f), turn = uniform(0, 1), r = uniform(0.5f, 3);
		ts_v3 p = ts_v3_make((f32)(1 + r * sin(angle) * cos(turn)), (f32)(2 - r * cos(angle)),
		                     (f32)(3 + r * sin(angle) * sin(turn)));
		ts_v3 l;
		double ramp = fmin(fmax((cos(angle) - outer) / (inner - outer), 0), 1);
		f32 arrives = ts_k_light(&light, p, &l);
		assert_near(arrives * r * r, ramp * ramp, 2e-5);
		if (angle > 0.901) assert_true(arrives == 0);
		if (angle < 0.399) assert_near(arrives * r * r, 1, 3e-6);
	}
}

static small_scene scene;

static ts_v3 shaded(const ts_surface *s, ts_v3 v)
{
	ts_arrays arrays = small_arrays(&scene);
	return ts_k_shade(&arrays, s, v);
}

/* Without lights: emission and ambient light on what is not metal; unlit shows its base colour. */
static void without_lights_ambient_and_emission_remain(void **state)
{
	(void)state;
	small_clear(&scene);
	scene.ambient = 0.25f;
	ts_surface s = material(ts_v3_make(0.5f, 1, 0), 0.75f, 1);
	s.emissive = ts_v3_make(1, 2, 3);
	s.occlusion = 0.5f;
	ts_v3 r = shaded(&s, s.n);
	assert_true(r.x == 1 + 0.25f * 0.5f * 0.25f * 0.5f && r.y == 2 + 0.25f * 0.5f * 0.25f && r.z == 3);
	s.flags = TS_UNLIT;
	assert_true(same_bits3(shaded(&s, s.n), s.base));
	assert_true(ts_k_background().x == 0.2f && ts_k_background().y == 0.3f && ts_k_background().z == 0.5f);
}

/* Lights add, and twice the intensity is twice the light; one behind the surface gives nothing. */
static void lights_add_and_scale_with_intensity(void **state)
{
	(void)state;
	for (u32 i = 0; i < N / 10; i++) {
		small_clear(&scene);
		ts_surface s = material(uniform3(0, 1), uniform(0, 1), uniform(0.1f, 1));
		ts_v3 v = polar(uniform(0.05f, 1), uniform(0, 1));
		double3 sum = {0, 0, 0};
		for (u32 k = 0; k < 3; k++) {
			scene.lights[0] = point_light(k % 2);
			ts_store3(scene.lights[0].position, uniform3(-3, 3));
			ts_store3(scene.lights[0].direction, direction());
			ts_store3(scene.lights[0].intensity, uniform3(0, 5));
			scene.n_lights = 1;
			ts_v3 one = shaded(&s, v), l;
			ts_k_light(&scene.lights[0], s.p, &l);
			if (l.z <= 0) assert_true(one.x == 0 && one.y == 0 && one.z == 0);
			sum = d3_add(sum, d3_of(one));
			ts_light twice = scene.lights[k + 1] = scene.lights[0];
			for (u32 c = 0; c < 3; c++) twice.intensity[c] *= 2;
			scene.lights[0] = twice;
			ts_v3 both = shaded(&s, v);
			assert_true(both.x == 2 * one.x && both.y == 2 * one.y && both.z == 2 * one.z);
		}
		scene.lights[0] = scene.lights[1];
		scene.lights[1] = scene.lights[2];
		scene.lights[2] = scene.lights[3];
		scene.n_lights = 3;
		assert_true(d3_distance(d3_of(shaded(&s, v)), sum) <= 1e-6 * d3_length(sum));
	}
}

/* Seen from behind, a double-sided surface is lit as its mirror image is from the front; a single-sided one is not. */
static void a_back_is_lit_as_its_mirror(void **state)
{
	(void)state;
	small_clear(&scene);
	scene.n_lights = 1;
	scene.lights[0] = point_light(TS_LIGHT_KIND_DIRECTIONAL);
	ts_surface s = material(ts_v3_make(1, 1, 1), 0, 0.5f);
	ts_store3(scene.lights[0].direction, ts_v3_make(0.6f, 0, -0.8f));
	ts_v3 front = shaded(&s, ts_v3_make(0, 0.6f, 0.8f));
	ts_store3(scene.lights[0].direction, ts_v3_make(0.6f, 0, 0.8f));
	assert_true(shaded(&s, ts_v3_make(0, 0.6f, -0.8f)).x == 0);
	s.flags = TS_DOUBLE_SIDED;
	assert_true(front.x > 0 && same_bits3(shaded(&s, ts_v3_make(0, 0.6f, -0.8f)), front));
}

int main(void)
{
	pi = acos(-1);
	const struct CMUnitTest tests[] = {
		seeded_test(brdf_matches_the_textbook_form),
		seeded_test(light_and_view_may_change_places),
		seeded_test(white_never_returns_more_than_it_receives),
		seeded_test(a_narrow_lobe_returns_what_it_receives),
		seeded_test(extreme_directions_shade_finite),
		seeded_test(directional_light_is_not_weakened),
		seeded_test(point_light_falls_by_the_inverse_square),
		seeded_test(spot_light_fades_between_its_cones),
		seeded_test(without_lights_ambient_and_emission_remain),
		seeded_test(lights_add_and_scale_with_intensity),
		seeded_test(a_back_is_lit_as_its_mirror),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

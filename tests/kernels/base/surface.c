/* The surface: a corner's weights give the corner's data, normal maps turn the normal in the frame that the texture
 * coordinates span (in double precision), and material textures multiply. */
#include "kernels/base/surface.h"
#include "tests/kernels/small.h"

enum { N = 20000 };

static small_scene scene;
static const ts_v3 corner_weights[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

static double3 position(u32 k) { return d3_of(ts_load3(scene.vertices[k].position)); }

static double3 face_normal(void)
{
	return d3_cross(d3_sub(position(1), position(0)), d3_sub(position(2), position(0)));
}

/* One triangle with random corners of everything. */
static void random_triangle(void)
{
	small_clear(&scene);
	do {
		scene.n_triangles = 0;
		small_add(&scene, uniform3(-3, 3), uniform3(-3, 3), uniform3(-3, 3), 0, 0);
	} while (d3_length(face_normal()) < 1);
	for (u32 k = 0; k < 3; k++) {
		ts_vertex *v = &scene.vertices[k];
		ts_store3(v->normal, direction());
		ts_store3(v->colour, uniform3(0, 1));
		for (u32 i = 0; i < 4; i++) v->uv[i] = uniform(0, 1);
	}
}

static ts_surface surface(ts_v3 w, f32 footprint)
{
	ts_arrays arrays = small_arrays(&scene);
	return ts_k_surface(&arrays, 0, w, footprint);
}

static void weights_of_a_corner_give_its_data(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		random_triangle();
		ts_store3(scene.materials[0].base, uniform3(0, 1));
		for (u32 k = 0; k < 3; k++) {
			ts_surface s = surface(corner_weights[k], 0.1f);
			const ts_vertex *v = &scene.vertices[k];
			assert_true(d3_distance(d3_of(s.p), position(k)) == 0);
			assert_true(d3_distance(d3_of(s.n), d3_of(ts_load3(v->normal))) <= 3e-7);
			for (u32 c = 0; c < 3; c++) {
				assert_near((&s.base.x)[c], (double)scene.materials[0].base[c] * v->colour[c], 1e-7);
			}
		}
	}
}

static void points_and_normals_blend_by_weights(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		random_triangle();
		ts_v3 w = random_weights();
		ts_surface s = surface(w, 0.1f);
		assert_true(d3_distance(d3_of(s.p), d3_blend(w, position(0), position(1), position(2))) <= 3e-6);
		assert_true(d3_distance(d3_of(s.face), d3_unit(face_normal())) <= 1e-5);
		double3 n = d3_blend(w, d3_of(ts_load3(scene.vertices[0].normal)), d3_of(ts_load3(scene.vertices[1].normal)),
		                     d3_of(ts_load3(scene.vertices[2].normal)));
		if (d3_length(n) > 0.1) assert_true(d3_distance(d3_of(s.n), d3_unit(n)) <= 1e-5);
	}
}

static void without_normals_the_face_gives_one(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		random_triangle();
		for (u32 k = 0; k < 3; k++) ts_store3(scene.vertices[k].normal, ts_v3_make(0, 0, 0));
		ts_surface s = surface(random_weights(), 0.1f);
		assert_true(same_bits3(s.n, s.face));
	}
}

/* A normal map of one normal, linear in [-1, 1] to the 16 bits of a texel. */
static void set_map(double x, double y, double z)
{
	scene.n_images = scene.n_texels = 0;
	small_colour(&scene, 0, 4,
	             texel((u32)lround((x + 1) / 2 * 65535), (u32)lround((y + 1) / 2 * 65535),
	                   (u32)lround((z + 1) / 2 * 65535), 65535));
	scene.materials[0].slot[2] = 0;
}

static double uv_area(void)
{
	const f32 *a = scene.vertices[0].uv, *b = scene.vertices[1].uv, *c = scene.vertices[2].uv;
	return ((double)b[0] - a[0]) * ((double)c[1] - a[1]) - ((double)b[1] - a[1]) * ((double)c[0] - a[0]);
}

/* How position changes with u or v over the triangle. */
static double3 slope(u32 axis)
{
	const f32 *a = scene.vertices[0].uv, *b = scene.vertices[1].uv, *c = scene.vertices[2].uv;
	u32 other = 1 - axis;
	double3 e1 = d3_sub(position(1), position(0)), e2 = d3_sub(position(2), position(0));
	double3 d = d3_sub(d3_scale(e1, (double)c[other] - a[other]), d3_scale(e2, (double)b[other] - a[other]));
	return d3_scale(d, (axis == 0 ? 1 : -1) / uv_area());
}

static void a_flat_normal_map_changes_nothing(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		random_triangle();
		ts_v3 w = random_weights();
		ts_v3 without = surface(w, 0.1f).n;
		set_map(0, 0, 1);
		assert_true(d3_distance(d3_of(surface(w, 0.1f).n), d3_of(without)) <= 3e-5);
		set_map(0.6, -0.3, 0.5);
		scene.materials[0].normal_scale = 0;
		assert_true(d3_distance(d3_of(surface(w, 0.1f).n), d3_of(without)) <= 2e-6);
	}
}

/* Red leans towards growing u; green upward in the image, where v falls; mirrored coordinates included. */
static void a_normal_map_leans_along_its_coordinates(void **state)
{
	(void)state;
	u32 n_mirrored = 0, n_judged = 0;
	for (u32 i = 0; i < N; i++) {
		random_triangle();
		for (u32 k = 0; k < 3; k++) ts_store3(scene.vertices[k].normal, ts_v3_make(0, 0, 0));
		if (fabs(uv_area()) < 0.05) continue;
		n_judged++;
		n_mirrored += uv_area() < 0;
		double x = uniform(-0.7f, 0.7f), y = uniform(-0.7f, 0.7f), z = 0.5;
		set_map(x, y, z);
		double3 n = d3_unit(face_normal());
		double3 t = d3_unit(slope(0)), up = d3_scale(slope(1), -1);
		double3 b = d3_unit(d3_mad(up, t, -d3_dot(up, t)));
		double3 expected = d3_unit(d3_add(d3_add(d3_scale(t, x), d3_scale(b, y)), d3_scale(n, z)));
		assert_true(d3_distance(d3_of(surface(random_weights(), 0.1f).n), expected) <= 2e-4);
	}
	assert_true(n_mirrored > n_judged / 3 && n_mirrored < n_judged * 2 / 3);
}

/* A given tangent, made orthogonal to the normal; its w turns the bitangent. */
static void a_given_tangent_turns_the_normal_map(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		random_triangle();
		ts_v3 t = direction(), n = direction();
		if (ts_abs(ts_dot(t, n)) > 0.9f) continue;
		f32 handedness = i % 2 == 0 ? 1 : -1;
		for (u32 k = 0; k < 3; k++) {
			ts_store3(scene.vertices[k].normal, n);
			ts_store3(scene.vertices[k].tangent, t);
			scene.vertices[k].tangent[3] = handedness;
		}
		set_map(0.5, -0.4, 0.7);
		double3 m = d3_of(n), u = d3_unit(d3_mad(d3_of(t), m, -d3_dot(d3_of(t), m)));
		double3 v = d3_scale(d3_cross(m, u), handedness);
		double3 expected = d3_unit(d3_add(d3_add(d3_scale(u, 0.5), d3_scale(v, -0.4)), d3_scale(m, 0.7)));
		assert_true(d3_distance(d3_of(surface(random_weights(), 0.1f).n), expected) <= 1e-4);
	}
}

/* Coordinates without area, or a tangent along the normal: the map is not used. */
static void without_a_frame_no_map_is_used(void **state)
{
	(void)state;
	random_triangle();
	set_map(0.7, 0.1, 0.2);
	for (u32 k = 0; k < 3; k++) scene.vertices[k].uv[1] = 0.25f;
	for (u32 k = 0; k < 3; k++) ts_store3(scene.vertices[k].normal, ts_v3_make(0, 1, 0));
	assert_true(same_bits3(surface(random_weights(), 0.1f).n, ts_v3_make(0, 1, 0)));
	for (u32 k = 0; k < 3; k++) scene.vertices[k].tangent[1] = 1;
	assert_true(same_bits3(surface(corner_weights[1], 0.1f).n, ts_v3_make(0, 1, 0)));
}

/* Each texture multiplies its factors from its own channels; occlusion is 1 + strength (t - 1). */
static void each_texture_multiplies_its_factors(void **state)
{
	(void)state;
	random_triangle();
	ts_material *m = &scene.materials[0];
	for (u32 k = 0; k < 3; k++) {
		scene.vertices[k].colour[0] = scene.vertices[k].colour[1] = scene.vertices[k].colour[2] = 0.5f;
		m->emissive[k] = 4;
	}
	m->metallic = 0.5f;
	m->roughness = 0.8f;
	m->occlusion = 0.25f;
	small_colour(&scene, 0, 4, texel(65535, 0, 13107, 7));
	small_colour(&scene, 1, 4, texel(1, 13107, 26214, 3));
	small_colour(&scene, 3, 4, texel(39321, 1, 2, 3));
	small_colour(&scene, 4, 4, texel(0, 13107, 65535, 9));
	for (u32 k = 0; k < 5; k++) m->slot[k] = k == 2 ? TS_NONE : k;
	m->flags = TS_DOUBLE_SIDED;
	ts_surface s = surface(random_weights(), 0.1f);
	assert_true(d3_distance(d3_of(s.base), (double3){0.5, 0, 0.1}) <= 1e-6);
	assert_near(s.roughness, 0.16, 1e-6);
	assert_near(s.metallic, 0.2, 1e-6);
	assert_near(s.occlusion, 0.9, 1e-6);
	assert_true(d3_distance(d3_of(s.emissive), (double3){0, 0.8, 4}) <= 1e-6);
	assert_int_equal(s.flags, TS_DOUBLE_SIDED);
}

/* The slot's own set of coordinates and its transform decide where it reads; the footprint decides the level. */
static void a_slot_decides_what_is_read(void **state)
{
	(void)state;
	random_triangle();
	small_colour(&scene, 0, 4, texel(0, 0, 0, 65535));
	scene.texels[1 * 4 + 2] = texel(65535, 0, 0, 65535);
	scene.materials[0].slot[0] = 0;
	f32 *m = scene.slots[0].transform;
	m[0] = 0;
	m[1] = 2;
	m[2] = 0.125f;
	m[3] = -1;
	m[4] = 0;
	m[5] = 0.5f;
	scene.slots[0].uv_set = 1;
	for (u32 k = 0; k < 3; k++) {
		scene.vertices[k].colour[0] = 1;
		scene.vertices[k].uv[2] = 0.125f;
		scene.vertices[k].uv[3] = 0.25f;
	}
	assert_true(surface(corner_weights[0], 0).base.x == 1);
	scene.slots[0].uv_set = 0;
	scene.vertices[0].uv[0] = scene.vertices[0].uv[1] = 0.75f;
	assert_true(surface(corner_weights[0], 0).base.x == 0);
	scene.slots[0].uv_set = 1;
	scene.vertices[1].uv[3] = 0.5f;
	scene.vertices[2].uv[2] = 0.625f;
	assert_true(surface(corner_weights[0], 0.0001f).base.x == 1);
	assert_true(surface(corner_weights[0], 10000).base.x == 0);
}

/* Only masked materials cut, where texture x factor x vertex alpha is below the cutoff. */
static void only_masked_materials_below_the_cutoff_cut(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		random_triangle();
		ts_arrays arrays = small_arrays(&scene);
		ts_v3 w = random_weights(), n = ts_k_corners(&arrays, 0).n;
		ts_material *m = &scene.materials[0];
		f32 a[3] = {uniform(0, 1), uniform(0, 1), uniform(0, 1)};
		for (u32 k = 0; k < 3; k++) scene.vertices[k].colour[3] = a[k];
		m->base[3] = uniform(0.5f, 1);
		m->alpha_cutoff = uniform(0, 0.6f);
		double alpha = m->base[3] * ((double)w.x * a[0] + (double)w.y * a[1] + (double)w.z * a[2]);
		if (i % 2 == 0) {
			small_colour(&scene, 0, 2, texel(0, 0, 0, 43690));
			m->slot[0] = 0;
			alpha *= 43690.0 / 65535;
		}
		if (fabs(alpha - m->alpha_cutoff) < 1e-5) continue;
		assert_false(ts_k_is_cut(&arrays, 0, w, n, 0.1f));
		m->flags = TS_MASKED;
		assert_true(ts_k_is_cut(&arrays, 0, w, n, 0.1f) == (alpha < m->alpha_cutoff));
	}
}

static void mirrors_not_followed_are_diffuse(void **state)
{
	(void)state;
	random_triangle();
	scene.materials[0].metallic = 1;
	scene.materials[0].roughness = 0;
	assert_true(surface(corner_weights[0], 0.1f).metallic == 1 && surface(corner_weights[0], 0.1f).roughness == 0);
	scene.objects[0].reflector = 0;
	assert_true(surface(corner_weights[0], 0.1f).metallic == 0 && surface(corner_weights[0], 0.1f).roughness == 1);
}

/* width / sqrt |cos|, at most eight widths. */
static void the_footprint_grows_with_the_slant(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_v3 d = ts_scale(direction(), uniform(0.1f, 10)), n = ts_scale(direction(), uniform(0.1f, 10));
		double cosine = fabs(d3_dot(d3_unit(d3_of(d)), d3_unit(d3_of(n))));
		assert_near(ts_k_footprint(0.25f, d, n), 0.25 / sqrt(fmax(cosine, 1.0 / 64)), 2e-5);
	}
	assert_true(ts_k_footprint(3, ts_v3_make(0, 0, 2), ts_v3_make(0, 0, -5)) == 3);
	assert_true(ts_k_footprint(3, ts_v3_make(0, 2, 0), ts_v3_make(0, 0, -5)) == 24);
	assert_true(ts_k_footprint(3, ts_v3_make(0, 0, 0), ts_v3_make(0, 0, -5)) == 3);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(weights_of_a_corner_give_its_data),
		seeded_test(points_and_normals_blend_by_weights),
		seeded_test(without_normals_the_face_gives_one),
		seeded_test(a_flat_normal_map_changes_nothing),
		seeded_test(a_normal_map_leans_along_its_coordinates),
		seeded_test(a_given_tangent_turns_the_normal_map),
		seeded_test(without_a_frame_no_map_is_used),
		seeded_test(each_texture_multiplies_its_factors),
		seeded_test(a_slot_decides_what_is_read),
		seeded_test(only_masked_materials_below_the_cutoff_cut),
		seeded_test(mirrors_not_followed_are_diffuse),
		seeded_test(the_footprint_grows_with_the_slant),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Surfaces of answers: what a triangle belongs to, what its textures give, and the terms of its light. */
#include "tests/probe/mvr.h"

/* Of every triangle its material and object, and the reflector if that is one. */
static void every_triangle_tells_whose_it_is(void **state)
{
	(void)state;
	const ts_triangle *triangles = data(&mvr, TS_B_scene_triangle);
	const ts_vertex *vertices = data(&mvr, TS_B_scene_vertex);
	const ts_object *objects = data(&mvr, TS_B_scene_object);
	u32 n_mirrors = 0, n = (u32)count(&mvr, TS_B_scene_triangle), last = 0;
	require(ts_probe_scene(mvr.probe));
	for (u32 t = 0; t < n; t++) {
		json_t *o = json_object();
		u32 object = vertices[triangles[t].vertex[0]].object, reflector = objects[object].reflector;
		ts_probe_put_triangle(mvr.probe, o, t);
		assert_true(figure(o, "triangle") == t && figure(o, "material") == triangles[t].material);
		assert_int_equal(figure(o, "object"), object);
		assert_int_equal(json_object_get(o, "reflector") != NULL, reflector != TS_NONE);
		if (reflector != TS_NONE) assert_int_equal(figure(o, "reflector"), reflector);
		n_mirrors += reflector != TS_NONE;
		last = object > last ? object : last;
		json_decref(o);
	}
	assert_true(n_mirrors > 0 && last > 1);
}

/* A surface in the middle of a triangle: as its kernel has it, with a texture for each slot of its material. */
static void a_surface_tells_each_texture_it_uses(void **state)
{
	(void)state;
	static const char *const uses[] = {"base", "metallic-roughness", "normal", "occlusion", "emissive"};
	u32 n_textures = 0;
	require(ts_probe_scene(mvr.probe));
	for (u32 i = 0; i < 40; i++) {
		u32 t = below((u32)count(&mvr, TS_B_scene_triangle)), k = 0;
		const ts_arrays *scene = &mvr.probe->scene;
		const ts_material *material = &scene->materials[scene->triangles[t].material];
		const ts_v3 middle = ts_v3_make(0.25f, 0.25f, 0.5f), position = ts_v3_make(1, -2, 3);
		const ts_surface s = {.p = position, .n = {0, 1, 0}, .metallic = 0.5f, .roughness = 0.25f, .flags = 3};
		require(ts_probe_textures(mvr.probe, t));
		json_t *o = ts_probe_surface(mvr.probe, t, &s, middle, 0.125f), *list = json_object_get(o, "textures");
		assert_int_equal(figure(o, "triangle"), t);
		assert_int_equal(figure(o, "flags"), 3);
		assert_true(json_real_value(json_object_get(o, "metallic")) == 0.5);
		assert_true(json_real_value(json_object_get(o, "roughness")) == 0.25);
		assert_true(json_real_value(json_object_get(o, "occlusion")) == 0.0);
		assert_true(json_real_value(json_object_get(o, "footprint")) == 0.125);
		assert_true(json_real_value(json_array_get(json_object_get(o, "weights"), 2)) == 0.5);
		assert_true(json_real_value(json_array_get(json_object_get(o, "position"), 1)) == -2.0);
		assert_true(json_real_value(json_array_get(json_object_get(o, "normal"), 1)) == 1.0);
		for (u32 u = 0; u < 5; u++) {
			if (material->slot[u] == TS_NONE) continue;
			const json_t *texture = json_array_get(list, k++);
			assert_string_equal(json_string_value(json_object_get(texture, "use")), uses[u]);
			assert_int_equal(figure(texture, "slot"), material->slot[u]);
			assert_int_equal(figure(texture, "image"), scene->slots[material->slot[u]].image);
			assert_int_equal(json_array_size(json_object_get(texture, "rgba")), 4);
		}
		assert_int_equal(json_array_size(list), k);
		n_textures += k;
		json_decref(o);
	}
	assert_true(n_textures > 0);
}

/* Three lights of three kinds over a white floor, of which some samples reach it; by hand. */
static ts_light lights[] = {
	{.kind = 0, .direction = {0, -1, 0}, .intensity = {1, 2, 4}},
	{.kind = 1, .position = {0, 2, 0}, .intensity = {8, 8, 8}},
	{.kind = 2,
     .position = {0, 4, 0},
     .direction = {0, -1, 0},
     .intensity = {16, 16, 16},
     .spot_scale = 1,
     .spot_offset = 1},
};
static const ts_lamp lamps[] = {{.samples = 4}, {.samples = 4}, {.samples = 8}};
static const ts_surface plain = {
	.n = {0, 1, 0}, .face = {0, 1, 0}, .base = {1, 1, 1}, .emissive = {0, 0.5f, 0}, .roughness = 1, .occlusion = 1};

static ts_probe by_hand(f32 ambient)
{
	return (ts_probe){.scene = {.lights = lights, .n_lights = 3, .ambient = ambient}};
}

/* Each light is told with its kind, what arrives of it, and its part of the total. */
static void each_light_tells_its_part(void **state)
{
	(void)state;
	static const char *const kinds[] = {"directional", "point", "spot"};
	static const f32 arrives[2][3] = {{1.0f, 0.25f, 0.0625f}, {0.5f, 0.0f, 0.0625f}};
	static const u32 lit[] = {2, 0, 8};
	ts_probe p = by_hand(0.5f);
	for (u32 shadows = 0; shadows < 2; shadows++) {
		ts_v3 total, v = ts_v3_make(0, 1, 0);
		json_t *o = ts_probe_shading(&p, &plain, v, shadows != 0 ? lit : NULL, shadows != 0 ? lamps : NULL, &total);
		const json_t *list = json_object_get(o, "lights");
		assert_false(p.failed);
		assert_int_equal(assert_agrees(o), 1);
		assert_int_equal(json_array_size(list), 3);
		for (u32 c = 0; c < 3; c++) assert_bits(shown(o, "total", c), c == 0 ? total.x : c == 1 ? total.y : total.z);
		assert_bits(shown(o, "emissive", 1), 0.5f);
		for (u32 c = 0; c < 3; c++) assert_bits(shown(o, "ambient", c), 0.5f);
		for (u32 i = 0; i < 3; i++) {
			const json_t *light = json_array_get(list, i);
			assert_int_equal(figure(light, "light"), i);
			assert_string_equal(json_string_value(json_object_get(light, "kind")), kinds[i]);
			assert_true(fabs(json_real_value(json_object_get(light, "arrives")) - (double)arrives[shadows][i]) < 1e-6);
			assert_int_equal(shown(light, "radiance", 0) > 0.0f, arrives[shadows][i] > 0.0f);
			assert_true(json_real_value(json_array_get(json_object_get(light, "towards"), 1)) == 1.0);
		}
		json_decref(o);
	}
}

/* What is unlit has its own colour, and no terms. */
static void what_is_unlit_has_no_terms(void **state)
{
	(void)state;
	ts_probe p = by_hand(0.5f);
	ts_surface s = plain;
	ts_v3 total;
	s.flags = TS_UNLIT;
	s.base = ts_v3_make(0.25f, 0.5f, 0.75f);
	json_t *o = ts_probe_shading(&p, &s, ts_v3_make(0, 1, 0), NULL, NULL, &total);
	assert_true(total.x == 0.25f && total.y == 0.5f && total.z == 0.75f);
	assert_bits(shown(o, "unlit", 2), 0.75f);
	assert_bits(shown(o, "total", 0), 0.25f);
	assert_true(json_object_get(o, "lights") == NULL && json_object_get(o, "ambient") == NULL);
	json_decref(o);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(every_triangle_tells_whose_it_is),
		cmocka_unit_test(a_surface_tells_each_texture_it_uses),
		cmocka_unit_test(each_light_tells_its_part),
		cmocka_unit_test(what_is_unlit_has_no_terms),
	};
	return cmocka_run_group_tests(tests, mvr_make, mvr_drop);
}

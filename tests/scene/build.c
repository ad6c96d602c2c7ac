/* Building a scene: what is added, what is refused, what is kept, and the mip chains. */
#include "kernels/base/shade.h"
#include "scene/build.h"
#include "tests/srgb.h"
#include "tests/status.h"

static ts_params params;

static int set_up(void **state)
{
	(void)state;
	ts_params_default(&params);
	return 0;
}

static u32 vertex(ts_build *build, f32 x, f32 y, f32 z)
{
	ts_vertex v = {.position = {x, y, z}, .colour = {1.0f, 1.0f, 1.0f, 1.0f}};
	return ts_build_vertex(build, &v);
}

static u32 right_triangle(ts_build *build, f32 size, u32 material)
{
	u32 a = vertex(build, 0.0f, 0.0f, 0.0f);
	vertex(build, size, 0.0f, 0.0f);
	vertex(build, 0.0f, 0.0f, -size);
	ts_build_triangle(build, a, a + 1, a + 2, material);
	return a;
}

static ts_build *start(void)
{
	ts_build *build = ts_build_new("test");
	assert_non_null(build);
	right_triangle(build, 1.0f, TS_NONE);
	return build;
}

static ts_scene *finish(ts_build *build)
{
	ts_scene *scene;
	assert_int_equal(ts_build_finish(build, &params, NULL, &scene), TS_OK);
	assert_non_null(scene);
	return scene;
}

/* The build must fail with one line that holds `words`. */
static void refuse(ts_build *build, const char *words)
{
	ts_scene *scene = (ts_scene *)build;
	assert_int_equal(ts_build_finish(build, &params, NULL, &scene), TS_ERROR);
	assert_null(scene);
	says(words);
}

static void what_is_not_said_has_its_default(void **state)
{
	(void)state;
	ts_scene *scene = finish(start());
	assert_int_equal(scene->n_materials, 1);
	assert_true(scene->materials[0].base[0] == 1.0f && scene->materials[0].roughness == 1.0f);
	assert_int_equal(scene->triangles[0].material, 0);
	assert_int_equal(scene->n_objects, 1);
	assert_int_equal(scene->objects[0].n_vertices, 3);
	assert_int_equal(scene->objects[0].reflector, TS_NONE);
	assert_int_equal(scene->camera, TS_NONE);
	assert_true(scene->info.box_min[2] == -1.0f && scene->info.box_max[0] == 1.0f && scene->info.box_max[1] == 0.0f);
	ts_scene_free(scene);
}

/* Nothing to draw is a scene too. */
static void an_empty_scene_is_a_scene(void **state)
{
	(void)state;
	ts_scene *scene = finish(ts_build_new("empty"));
	assert_int_equal(scene->n_triangles, 0);
	assert_int_equal(scene->n_lights, 1);
	for (u32 k = 0; k < 3; k++) assert_true(scene->info.box_min[k] == 0.0f && scene->info.box_max[k] == 0.0f);
	for (u32 k = 0; k < 2; k++) assert_true(scene->info.hall_min[k] == 0.0f && scene->info.hall_max[k] == 0.0f);
	ts_scene_free(scene);
}

static void a_scene_without_lights_gets_a_sun(void **state)
{
	(void)state;
	params.light_irradiance = 5.0f;
	params.light_ambient = 0.25f;
	ts_scene *scene = finish(start());
	assert_int_equal(scene->n_lights, 1);
	const ts_light *sun = &scene->lights[0];
	assert_int_equal(sun->kind, TS_LIGHT_KIND_DIRECTIONAL);
	assert_true(sun->intensity[0] == 5.0f && sun->intensity[1] == 5.0f && sun->intensity[2] == 5.0f);
	assert_float_equal(sun->direction[0] / sun->direction[1], 0.4f, 1e-6f);
	assert_float_equal(sun->direction[2] / sun->direction[1], 0.3f, 1e-6f);
	assert_float_equal(ts_length(ts_load3(sun->direction)), 1.0f, 1e-6f);
	assert_true(sun->direction[1] < 0.0f && scene->info.ambient == 0.25f);
	ts_scene_free(scene);
}

static void own_lights_leave_out_the_sun(void **state)
{
	(void)state;
	ts_build *build = start();
	ts_light lamp = {.kind = TS_LIGHT_KIND_POINT, .intensity = {1.0f, 2.0f, 3.0f}};
	ts_build_light(build, &lamp);
	ts_scene *scene = finish(build);
	assert_int_equal(scene->n_lights, 1);
	assert_true(scene->info.ambient == 0.0f && scene->lights[0].intensity[2] == 3.0f);
	ts_scene_free(scene);
}

static void wild_numbers_are_sanitized(void **state)
{
	(void)state;
	ts_build *build = start();
	ts_vertex wild = {
		.position = {NAN, -0.0f, 1e-42f},
		.normal = {0.0f, 3.0f, 4.0f},
		.pad = 7,
		.object = 9,
		.tangent = {2.0f, 0.0f, 0.0f, -5.0f},
		.uv = {INFINITY, 0.0f, 0.0f, 0.0f},
	};
	u32 i = ts_build_vertex(build, &wild);
	ts_material dirty = ts_material_default();
	dirty.pad[1] = 3;
	dirty.metallic = 1.5f;
	ts_build_material(build, &dirty);
	ts_scene *scene = finish(build);
	const ts_vertex *v = &scene->vertices[i];
	for (int k = 0; k < 3; k++) assert_int_equal(ts_f2u(v->position[k]), 0);
	assert_float_equal(v->normal[1], 0.6f, 1e-6f);
	assert_true(v->tangent[0] == 1.0f && v->tangent[3] == -1.0f);
	assert_true(v->uv[0] == 0x1p62f && v->pad == 0 && v->object == 0);
	assert_true(scene->materials[0].pad[1] == 0 && scene->materials[0].metallic == 1.0f);
	assert_int_equal(scene->n_notes, 1);
	assert_non_null(strstr(scene->notes[0], "metallic"));
	ts_scene_free(scene);
}

/* Every number of a camera, one after the other. */
static void wild_cameras_are_sanitized(void **state)
{
	(void)state;
	for (u32 k = 0; k < 13; k++) {
		char name[] = "wild";
		ts_build *build = start();
		ts_camera wild = {.name = name, .yfov = 1, .right = {1, 0, 0}, .up = {0, 1, 0}, .back = {0, 0, 1}};
		f32 *const parts[] = {wild.eye, wild.right, wild.up, wild.back};
		*(k < 12 ? &parts[k / 3][k % 3] : &wild.yfov) = NAN;
		ts_build_camera(build, &wild);
		ts_scene *scene = finish(build);
		const ts_camera *c = &scene->cameras[0];
		const f32 *const found[] = {c->eye, c->right, c->up, c->back};
		for (u32 i = 0; i < 12; i++) assert_true(found[i / 3][i % 3] == (i == k ? 0.0f : parts[i / 3][i % 3]));
		assert_true(c->yfov == (k == 12 ? 0.0f : 1.0f));
		ts_scene_free(scene);
	}
}

static void wrong_indices_are_refused(void **state)
{
	(void)state;
	ts_build *build = start();
	ts_build_triangle(build, 0, 1, 3, TS_NONE);
	refuse(build, "triangle 1: vertex 3");
	build = start();
	ts_build_triangle(build, 0, 1, 2, 5);
	refuse(build, "triangle 1: material 5");
	build = start();
	ts_material m = ts_material_default();
	m.slot[TS_SLOT_NORMAL] = 0;
	ts_build_material(build, &m);
	refuse(build, "texture reference 0");
	build = start();
	ts_slot s = {.image = 0};
	ts_build_slot(build, &s);
	refuse(build, "image 0");
}

static void values_out_of_range_are_refused(void **state)
{
	(void)state;
	const u8 white[4] = {255, 255, 255, 255};
	const ts_slot slots[3] = {{.uv_set = 2}, {.wrap = {3, 0}}, {.wrap = {0, 3}}};
	const char *const words[3] = {"TEXCOORD_2", "wrap modes 3", "and 3"};
	for (int i = 0; i < 3; i++) {
		ts_build *build = start();
		ts_build_image(build, white, 1, 1, false);
		ts_build_slot(build, &slots[i]);
		refuse(build, words[i]);
	}
	ts_build *build = start();
	ts_light odd = {.kind = 3, .direction = {0.0f, 1.0f, 0.0f}};
	ts_build_light(build, &odd);
	refuse(build, "kind 3");
	build = start();
	ts_light aimless = {.kind = TS_LIGHT_KIND_SPOT};
	ts_build_light(build, &aimless);
	refuse(build, "no direction");
	build = start();
	ts_build_image(build, white, 0, 1, false);
	refuse(build, "0 x 1 texels");
	build = start();
	ts_build_image(build, white, 1, 65537, false);
	refuse(build, "1 x 65537 texels");
	build = start();
	ts_material m = ts_material_default();
	m.flags = 8;
	ts_build_material(build, &m);
	refuse(build, "flags 8");
}

static void coordinates_beyond_the_limit_are_refused(void **state)
{
	(void)state;
	const f32 limit = 0x1p24f, beyond = 0x1.000002p24f;
	ts_build *build = start();
	vertex(build, 0.0f, -limit, limit);
	ts_scene_free(finish(build));
	for (int k = 0; k < 3; k++) {
		build = start();
		vertex(build, k == 0 ? beyond : 0.0f, k == 1 ? -beyond : 0.0f, k == 2 ? INFINITY : 0.0f);
		refuse(build, "vertex 3: coordinate");
	}
	build = start();
	ts_object far = {.period = 240, .centre = {limit, 0.0f, 0.0f}};
	ts_build_object(build, &far, true);
	right_triangle(build, 4.0f, TS_NONE);
	refuse(build, "coordinate");
}

static void the_first_failure_sticks(void **state)
{
	(void)state;
	ts_build *build = start();
	assert_false(ts_build_failed(build));
	ts_build_fail(build, "first\n%d", 1);
	ts_build_fail(build, "second");
	assert_true(ts_build_failed(build));
	u32 before = ts_build_peek(build)->n_vertices;
	vertex(build, 0.0f, 0.0f, 0.0f);
	assert_int_equal(ts_build_peek(build)->n_vertices, before);
	refuse(build, "first");
}

static void a_camera_is_chosen_by_its_name(void **state)
{
	(void)state;
	for (int i = 0; i < 3; i++) {
		const char *const asked[3] = {"b", "c", "a"};
		ts_build *build = start();
		ts_camera a = {.name = "a", .yfov = 0.125f}, b = {.name = "b"};
		ts_build_camera(build, &a);
		ts_build_camera(build, &b);
		ts_scene *scene;
		ts_status status = ts_build_finish(build, &params, asked[i], &scene);
		assert_int_equal(status, i == 1 ? TS_ERROR : TS_OK);
		if (i == 1)
			assert_non_null(strstr(ts_error_message(), "camera c does not exist; there are: a, b"));
		else
			assert_int_equal(scene->camera, i == 0 ? 1 : 0);
		ts_scene_free(scene);
	}
	ts_scene *scene;
	assert_int_equal(ts_build_finish(start(), &params, "a", &scene), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "no cameras"));
}

/* Vertices come in turns for three objects; each object must end as one range that holds its own. */
static void objects_become_ranges(void **state)
{
	(void)state;
	ts_build *build = start();
	ts_object still = {.period = 0}, moving = {.period = 240, .axis = {1.0f, 1.0f}};
	assert_int_equal(ts_build_object(build, &still, true), 1);
	right_triangle(build, 2.0f, TS_NONE);
	assert_int_equal(ts_build_object(build, NULL, false), 0);
	right_triangle(build, 3.0f, TS_NONE);
	assert_int_equal(ts_build_object(build, &moving, true), 2);
	right_triangle(build, 4.0f, TS_NONE);
	ts_build_object(build, NULL, false);
	right_triangle(build, 0.0f, TS_NONE);
	ts_scene *scene = finish(build);
	const u32 first[3] = {0, 9, 12}, count[3] = {9, 3, 3}, owner[5] = {0, 1, 0, 2, 0};
	const f32 size[5] = {1.0f, 2.0f, 3.0f, 4.0f, 0.0f};
	for (u32 i = 0; i < 3; i++) {
		assert_int_equal(scene->objects[i].first_vertex, first[i]);
		assert_int_equal(scene->objects[i].n_vertices, count[i]);
		assert_int_equal(scene->objects[i].reflector, i == 0 ? TS_NONE : i - 1);
	}
	for (u32 i = 0; i < 5; i++) {
		const ts_vertex *b = &scene->vertices[scene->triangles[i].vertex[1]];
		assert_int_equal(b->object, owner[i]);
		assert_true(b->position[0] == size[i]);
	}
	assert_int_equal(scene->info.n_reflectors, 2);
	assert_int_equal(scene->n_triangles_file, 4);
	assert_int_equal(scene->n_degenerate, 1);
	assert_true(scene->info.box_max[0] == 3.0f);
	ts_scene_free(scene);
}

static void objects_without_vertices_are_refused(void **state)
{
	(void)state;
	ts_object still = {.period = 0};
	ts_build *build = start();
	ts_build_object(build, &still, true);
	refuse(build, "object 1 has no vertices");
	build = start();
	ts_build_object(build, &still, true);
	u32 a = right_triangle(build, 1.0f, TS_NONE);
	ts_build_triangle(build, 0, 1, a, TS_NONE);
	refuse(build, "different objects");
}

/* A scene whose only mesh is a reflector still has a box. */
static void a_lone_reflector_has_a_box(void **state)
{
	(void)state;
	ts_build *build = ts_build_new("reflector");
	ts_object still = {.period = 0};
	ts_build_object(build, &still, true);
	right_triangle(build, 2.0f, TS_NONE);
	ts_scene *scene = finish(build);
	assert_true(scene->info.box_max[0] == 2.0f && scene->info.box_min[2] == -2.0f);
	ts_scene_free(scene);
}

static u32 channel(u64 texel, u32 k) { return (u32)(texel >> (16 * k) & 65535); }

static void coded_texels_follow_the_curve(void **state)
{
	(void)state;
	u8 codes[256][4];
	for (u32 i = 0; i < 256; i++) codes[i][0] = codes[i][1] = codes[i][2] = codes[i][3] = (u8)i;
	ts_build *build = start();
	assert_int_equal(ts_build_image(build, codes[0], 256, 1, true), 0);
	assert_int_equal(ts_build_image(build, codes[0], 256, 1, false), 1);
	ts_scene *scene = finish(build);
	const u64 *coded = scene->texels + scene->images[0].first_texel;
	const u64 *linear = scene->texels + scene->images[1].first_texel;
	for (u32 i = 0; i < 256; i++) {
		u32 expected = (u32)(65535 * srgb_decoded(i / 255.0L) + 0.5L);
		for (u32 k = 0; k < 3; k++) assert_int_equal(channel(coded[i], k), expected);
		assert_int_equal(channel(coded[i], 3), i * 257);
		for (u32 k = 0; k < 4; k++) assert_int_equal(channel(linear[i], k), i * 257);
	}
	ts_scene_free(scene);
}

/* Every texel of every level against the definition, read with clamped indices. */
static void check_mips(const u8 *rgba, u32 width, u32 height)
{
	ts_build *build = start();
	ts_build_image(build, rgba, width, height, false);
	ts_scene *scene = finish(build);
	const ts_image *image = &scene->images[0];
	u64 first = image->first_texel;
	for (u32 level = 1; level < image->n_levels; level++) {
		u32 w = width >> (level - 1) ? width >> (level - 1) : 1, h = height >> (level - 1) ? height >> (level - 1) : 1;
		u32 w1 = w > 1 ? w / 2 : 1, h1 = h > 1 ? h / 2 : 1;
		const u64 *above = scene->texels + first, *here = above + (u64)w * h;
		for (u32 i = 0; i < w1 * h1 * 4; i++) {
			u32 x = i / 4 % w1, y = i / 4 / w1, sum = 2;
			for (u32 n = 0; n < 4; n++) {
				u32 sx = 2 * x + n % 2 < w ? 2 * x + n % 2 : w - 1, sy = 2 * y + n / 2 < h ? 2 * y + n / 2 : h - 1;
				sum += channel(above[(u64)sy * w + sx], i % 4);
			}
			assert_int_equal(channel(here[y * w1 + x], i % 4), sum / 4);
		}
		first += (u64)w * h;
	}
	assert_int_equal(first + 1, scene->n_texels);
	assert_int_equal(width >> (image->n_levels - 1) | height >> (image->n_levels - 1), 1);
	ts_scene_free(scene);
}

static void every_texel_of_mips_is_a_mean(void **state)
{
	(void)state;
	enum { SIDE = 21 };
	u8 rgba[SIDE * SIDE * 4];
	for (u32 i = 0; i < sizeof rgba; i++) rgba[i] = (u8)ts_random(i, 6, 1);
	for (u32 n = 1; n <= SIDE; n++) {
		check_mips(rgba, n, n);
		check_mips(rgba, n, 1);
		check_mips(rgba, 1, n);
		check_mips(rgba, SIDE, n);
	}
}

static void mips_of_a_constant_image_are_constant(void **state)
{
	(void)state;
	u8 rgba[13 * 7 * 4];
	for (u32 i = 0; i < sizeof rgba; i++) rgba[i] = (u8)(50 * (i % 4) + 13);
	ts_build *build = start();
	ts_build_image(build, rgba, 13, 7, true);
	ts_scene *scene = finish(build);
	assert_int_equal(scene->n_texels, 13 * 7 + 6 * 3 + 3 * 1 + 1);
	for (u64 i = 1; i < scene->n_texels; i++) assert_true(scene->texels[i] == scene->texels[0]);
	ts_scene_free(scene);
}

static bool notes(const ts_scene *scene, const char *words)
{
	bool found = false;
	for (u32 i = 0; i < scene->n_notes; i++) found |= strstr(scene->notes[i], words) != NULL;
	return found;
}

static void colours_outside_are_clamped_and_counted(void **state)
{
	(void)state;
	ts_build *build = start();
	ts_vertex v = {.colour = {-1.0f, 2.0f, 0.5f, 1.5f}};
	ts_surfel s = {.u = {1.0f}, .v = {0.0f, 1.0f}, .colour = {0.0f, 1.0f, 1.25f}};
	u32 i = ts_build_vertex(build, &v), k = ts_build_surfel(build, &s);
	ts_material m = ts_material_default();
	m.base[0] = 1.5f;
	u32 j = ts_build_material(build, &m);
	ts_scene *scene = finish(build);
	static const f32 clamped[] = {0.0f, 1.0f, 0.5f, 1.0f};
	assert_memory_equal(scene->vertices[i].colour, clamped, sizeof clamped);
	assert_true(scene->surfels[k].colour[2] == 1.0f && scene->materials[j].base[0] == 1.0f);
	assert_true(notes(scene, "2 vertices or points have colours outside 0 to 1"));
	assert_true(notes(scene, "base colour 1.5 is outside 0 to 1, read as 1"));
	ts_scene_free(scene);
}

/* A box of fewer than 1024 steps of binary32, where it stands. */
static void scenes_far_from_the_origin_are_noted(void **state)
{
	(void)state;
	static const f32 far[] = {0.0f, 1.0f, 8000.0f, 8400.0f, 500000.0f};
	for (u32 i = 0; i < sizeof far / sizeof *far; i++) {
		ts_build *build = ts_build_new("test");
		for (u32 k = 0; k < 3; k++) vertex(build, far[i], k == 1 ? 1.0f : 0.0f, k == 2 ? 1.0f : 0.0f);
		ts_build_triangle(build, 0, 1, 2, TS_NONE);
		ts_scene *scene = finish(build);
		assert_int_equal(notes(scene, "from the origin, where binary32 has steps of"), far[i] > 8192.0f);
		ts_scene_free(scene);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test_setup(what_is_not_said_has_its_default, set_up),
		cmocka_unit_test_setup(an_empty_scene_is_a_scene, set_up),
		cmocka_unit_test_setup(a_scene_without_lights_gets_a_sun, set_up),
		cmocka_unit_test_setup(own_lights_leave_out_the_sun, set_up),
		cmocka_unit_test_setup(wild_numbers_are_sanitized, set_up),
		cmocka_unit_test_setup(wild_cameras_are_sanitized, set_up),
		cmocka_unit_test_setup(wrong_indices_are_refused, set_up),
		cmocka_unit_test_setup(values_out_of_range_are_refused, set_up),
		cmocka_unit_test_setup(coordinates_beyond_the_limit_are_refused, set_up),
		cmocka_unit_test_setup(the_first_failure_sticks, set_up),
		cmocka_unit_test_setup(a_camera_is_chosen_by_its_name, set_up),
		cmocka_unit_test_setup(objects_become_ranges, set_up),
		cmocka_unit_test_setup(objects_without_vertices_are_refused, set_up),
		cmocka_unit_test_setup(a_lone_reflector_has_a_box, set_up),
		cmocka_unit_test_setup(coded_texels_follow_the_curve, set_up),
		cmocka_unit_test_setup(every_texel_of_mips_is_a_mean, set_up),
		cmocka_unit_test_setup(mips_of_a_constant_image_are_constant, set_up),
		cmocka_unit_test_setup(colours_outside_are_clamped_and_counted, set_up),
		cmocka_unit_test_setup(scenes_far_from_the_origin_are_noted, set_up),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

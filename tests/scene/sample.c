/* Surfels sampled from triangles: that they lie on them, cover them, look like them, and are as many as asked for. */
#include <omp.h>
#include "kernels/base/texture.h"
#include "kernels/base/vec.h"
#include "model/core.h"
#include "scene/sources.h"
#include "tests/model/test.h"

static ts_params params;

static int set_up(void **state)
{
	(void)state;
	ts_params_default(&params);
	params.reflectors_count = 0;
	params.surfels_from_mesh = 1000;
	return 0;
}

static void add_triangle(ts_build *build, const f32 corner[3][3], u32 material)
{
	u32 v[3];
	for (u32 k = 0; k < 3; k++) {
		ts_vertex vertex = {.colour = {1.0f, 1.0f, 1.0f, 1.0f}};
		memcpy(vertex.position, corner[k], sizeof vertex.position);
		v[k] = ts_build_vertex(build, &vertex);
	}
	ts_build_triangle(build, v[0], v[1], v[2], material);
}

static f32 number(u32 i, u32 stream) { return ts_uniform(ts_random(i, stream, 11)); }

/* Triangles of every size and shape, slivers among them. */
static void add_random(ts_build *build, u32 n)
{
	for (u32 i = 0; i < n; i++) {
		f32 corner[3][3], size = ts_max(number(i, 50) * number(i, 51), 0.01f);
		for (u32 k = 0; k < 9; k++) corner[k / 3][k % 3] = number(i, k % 3 + 40) * 8.0f + size * number(i, k);
		if (i % 4 == 0)
			for (u32 k = 0; k < 3; k++)
				corner[2][k] = corner[0][k] + 0.6f * (corner[1][k] - corner[0][k]) + 0.001f * number(i, k);
		add_triangle(build, (const f32(*)[3])corner, TS_NONE);
	}
}

static ts_scene *finish(ts_build *build)
{
	ts_scene *scene;
	if (ts_build_finish(build, &params, NULL, &scene) != TS_OK) fail_msg("%s", ts_error_message());
	return scene;
}

static ts_v3 corner_of(const ts_scene *scene, u32 triangle, u32 k)
{
	return ts_load3(scene->vertices[scene->triangles[triangle].vertex[k]].position);
}

static f32 spacing_of(const ts_scene *scene)
{
	return ts_length(ts_load3(scene->surfels[0].u)) / params.surfels_radius;
}

/* A random point of a triangle; the border often. */
static ts_v3 point_of(const ts_scene *scene, u32 triangle, u32 i)
{
	f32 a = number(i, 1), b = number(i, 2) * (1.0f - a);
	if (i % 3 == 0) b = 0.0f;
	if (i % 7 == 0) a = (f32)(i % 2);
	if (i % 7 == 0) b = 0.0f;
	return ts_blend(ts_v3_make(1.0f - a - b, a, b), corner_of(scene, triangle, 0), corner_of(scene, triangle, 1),
	                corner_of(scene, triangle, 2));
}

static f32 distance_to(const ts_scene *scene, ts_v3 p)
{
	f32 least = 1e30f;
	for (u32 i = 0; i < scene->n_surfels; i++)
		least = ts_min(least, ts_length(ts_sub(ts_load3(scene->surfels[i].centre), p)));
	return least;
}

static void every_point_has_a_surfel_near(void **state)
{
	(void)state;
	ts_build *build = ts_build_new("test");
	add_random(build, 60);
	ts_scene *scene = finish(build);
	f32 spacing = spacing_of(scene);
	assert_in_range(scene->n_surfels, 1000, 1500);
	for (u32 t = 0; t < scene->n_triangles; t++) {
		for (u32 i = 0; i < 100; i++) {
			f32 d = distance_to(scene, point_of(scene, t, i));
			if (d > 1.6f * spacing) fail_msg("triangle %u: %g spacings from the nearest", t, (double)(d / spacing));
		}
	}
	ts_scene_free(scene);
}

/* Of one triangle: on its plane, not beyond its edges, axes in the plane, the normal that of the triangle. */
static void surfels_lie_on_their_triangle(void **state)
{
	(void)state;
	for (u32 t = 0; t < 40; t++) {
		ts_build *build = ts_build_new("test");
		f32 corner[3][3];
		for (u32 k = 0; k < 9; k++) corner[k / 3][k % 3] = number(t, k) * 4.0f;
		add_triangle(build, (const f32(*)[3])corner, TS_NONE);
		ts_scene *scene = finish(build);
		ts_v3 a = corner_of(scene, 0, 0), b = corner_of(scene, 0, 1), c = corner_of(scene, 0, 2);
		ts_v3 n = ts_normalize(ts_cross(ts_sub(b, a), ts_sub(c, a)));
		assert_in_range(scene->n_surfels, 950, 1250);
		for (u32 i = 0; i < scene->n_surfels; i++) {
			const ts_surfel *s = &scene->surfels[i];
			ts_v3 p = ts_load3(s->centre), m = ts_normalize(ts_cross(ts_load3(s->u), ts_load3(s->v)));
			assert_true(ts_abs(ts_dot(n, ts_sub(p, a))) < 1e-5f);
			assert_true(ts_dot(ts_cross(ts_sub(b, a), ts_sub(p, a)), n) > -1e-4f);
			assert_true(ts_dot(ts_cross(ts_sub(c, b), ts_sub(p, b)), n) > -1e-4f);
			assert_true(ts_dot(ts_cross(ts_sub(a, c), ts_sub(p, c)), n) > -1e-4f);
			assert_true(ts_dot(m, n) > 0.9999f);
		}
		ts_scene_free(scene);
	}
}

/* Discs turn to the normal between those of the corners, and keep the lengths and the right angle of their axes. */
static void surfels_have_the_interpolated_normal(void **state)
{
	(void)state;
	ts_build *build = ts_build_new("test");
	static const f32 corner[3][3] = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}},
					 normal[3][3] = {{-0.6f, 0, 0.8f}, {0.6f, 0, 0.8f}};
	u32 v[3];
	for (u32 k = 0; k < 3; k++) {
		ts_vertex vertex = {.colour = {1.0f, 1.0f, 1.0f, 1.0f}, .normal = {0, 0.96f, 0.28f}};
		memcpy(vertex.position, corner[k], sizeof vertex.position);
		if (k < 2) memcpy(vertex.normal, normal[k], sizeof vertex.normal);
		v[k] = ts_build_vertex(build, &vertex);
	}
	ts_build_triangle(build, v[0], v[1], v[2], TS_NONE);
	ts_scene *scene = finish(build);
	f32 radius = ts_length(ts_load3(scene->surfels[0].u));
	for (u32 i = 0; i < scene->n_surfels; i++) {
		const ts_surfel *s = &scene->surfels[i];
		ts_v3 u = ts_load3(s->u), w = ts_load3(s->v), n = ts_normalize(ts_cross(u, w));
		f32 b = s->centre[0] / 3, c = s->centre[1] / 3, a = 1 - b - c;
		ts_v3 right = ts_v3_make(0.6f * (b - a), 0.96f * c, 0.8f * (a + b) + 0.28f * c);
		assert_true(ts_length(ts_sub(n, ts_normalize(right))) < 2e-3f);
		assert_true(ts_abs(ts_dot(u, w)) < 1e-5f * radius * radius);
		assert_true(ts_abs(ts_length(u) / radius - 1) < 1e-5f && ts_abs(ts_length(w) / radius - 1) < 1e-5f);
	}
	ts_scene_free(scene);
}

/* The weights of a triangle's corners sum to 1 but for rounding. */
static void assert_colour(const ts_surfel *s, f32 red, f32 green)
{
	assert_true(ts_abs(s->colour[0] - red) < 1e-6f && ts_abs(s->colour[1] - green) < 1e-6f);
}

static const f32 large[3][3] = {{0, 0, 0}, {3, 0, 0}, {0, 3, 0}};

static void the_material_colours_them_and_turns_them(void **state)
{
	(void)state;
	ts_build *build = ts_build_new("test");
	ts_material material = ts_material_default();
	material.base[1] = 0.5f;
	material.metallic = 0.5f;
	add_triangle(build, large, ts_build_material(build, &material));
	ts_scene *one = finish(build);
	build = ts_build_new("test");
	material.flags = TS_DOUBLE_SIDED;
	add_triangle(build, large, ts_build_material(build, &material));
	ts_scene *two = finish(build);
	build = ts_build_new("test");
	add_triangle(build, large, ts_build_material(build, &material));
	params.surfels_sides = TS_SIDES_FRONT;
	ts_scene *fronts = finish(build);
	params.surfels_sides = TS_SIDES_MATERIAL;
	assert_int_equal(two->n_surfels, 2 * one->n_surfels);
	assert_int_equal(fronts->n_surfels, one->n_surfels);
	assert_memory_equal(fronts->surfels, one->surfels, one->n_surfels * sizeof(ts_surfel));
	for (u32 i = 0; i < one->n_surfels; i++) {
		const ts_surfel *front = &two->surfels[2 * i], *back = front + 1;
		assert_memory_equal(front, &one->surfels[i], sizeof *front);
		assert_memory_equal(front->centre, back->centre, sizeof front->centre);
		assert_memory_equal(front->u, back->v, sizeof front->u);
		assert_memory_equal(front->v, back->u, sizeof front->u);
		assert_colour(front, 0.5f, 0.25f);
		assert_colour(back, 0.5f, 0.25f);
	}
	ts_scene_free(one);
	ts_scene_free(two);
	ts_scene_free(fronts);
}

/* A texture of 2 by 2 texels, magnified: far from their borders surfels have the texel's colour. */
static void the_texture_is_read_where_they_are(void **state)
{
	(void)state;
	static const u8 texels[16] = {255, 255, 255, 255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255, 255};
	ts_build *build = ts_build_new("test");
	ts_slot slot = {.image = ts_build_image(build, texels, 2, 2, false),
	                .wrap = {TS_CLAMP, TS_CLAMP},
	                .transform = {1, 0, 0, 0, 1, 0}};
	ts_material material = ts_material_default();
	material.slot[TS_SLOT_BASE] = ts_build_slot(build, &slot);
	u32 m = ts_build_material(build, &material), v[3];
	for (u32 k = 0; k < 3; k++) {
		ts_vertex vertex = {.position = {k == 1 ? 2.0f : 0.0f, k == 2 ? 2.0f : 0.0f, 0.0f},
		                    .uv = {k == 1 ? 2.0f : 0.0f, k == 2 ? 2.0f : 0.0f},
		                    .colour = {1, 1, 1, 1}};
		v[k] = ts_build_vertex(build, &vertex);
	}
	ts_build_triangle(build, v[0], v[1], v[2], m);
	ts_scene *scene = finish(build);
	u32 n_white = 0, n_black = 0;
	for (u32 i = 0; i < scene->n_surfels; i++) {
		const ts_surfel *s = &scene->surfels[i];
		bool left = s->centre[0]<0.25f, right = s->centre[0]> 0.75f;
		if (s->centre[1] > 0.25f || !(left || right)) continue;
		assert_colour(s, left ? 1.0f : 0.0f, left ? 1.0f : 0.0f);
		n_white += left;
		n_black += right;
	}
	assert_true(n_white > 10 && n_black > 10);
	ts_scene_free(scene);
}

static void threads_and_splitting_change_nothing(void **state)
{
	(void)state;
	ts_scene *scene[2];
	params.surfels_from_mesh = 300000;
	for (u32 i = 0; i < 2; i++) {
		ts_build *build = ts_build_new("test");
		add_triangle(build, large, TS_NONE);
		add_random(build, 300);
		omp_set_num_threads(i == 0 ? 1 : 4);
		scene[i] = finish(build);
	}
	assert_in_range(scene[0]->n_surfels, 290000, 320000);
	assert_int_equal(scene[0]->n_surfels, scene[1]->n_surfels);
	assert_memory_equal(scene[0]->surfels, scene[1]->surfels, scene[0]->n_surfels * sizeof(ts_surfel));
	ts_scene_free(scene[0]);
	ts_scene_free(scene[1]);
	set_up(NULL);
}

static void what_cannot_be_sampled_is_refused(void **state)
{
	(void)state;
	ts_scene *scene;
	static const f32 needle[3][3] = {{0, 0, 0}, {1e6f, 0, 0}, {1e6f, 1e-4f, 0}};
	static const f32 line[3][3] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
	ts_build *build = ts_build_new("test");
	params.surfels_from_mesh = 10000000;
	add_triangle(build, needle, TS_NONE);
	assert_int_equal(ts_build_finish(build, &params, NULL, &scene), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "long and thin"));
	set_up(NULL);
	build = ts_build_new("test");
	add_triangle(build, line, TS_NONE);
	assert_int_equal(ts_build_finish(build, &params, NULL, &scene), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "no area"));
	assert_int_equal(ts_build_finish(ts_build_new("test"), &params, NULL, &scene), TS_ERROR);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(every_point_has_a_surfel_near),
		cmocka_unit_test(surfels_lie_on_their_triangle),
		cmocka_unit_test(surfels_have_the_interpolated_normal),
		cmocka_unit_test(the_material_colours_them_and_turns_them),
		cmocka_unit_test(the_texture_is_read_where_they_are),
		cmocka_unit_test(threads_and_splitting_change_nothing),
		cmocka_unit_test(what_cannot_be_sampled_is_refused),
	};
	return cmocka_run_group_tests(tests, set_up, NULL);
}

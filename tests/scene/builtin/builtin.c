/* The built-in scenes: exact counts, one-line errors, the same bytes every time, and that they are places: closed
 * rooms, normals that agree with their faces, a free path for the eye, triangles of all sizes. */
#include <omp.h>
#include "kernels/base/scene.h"
#include "scene/sources.h"
#include "scene/view.h"
#include "tests/model/test.h"

static const char *const names[3] = {"atrium", "gallery", "dining"};
static ts_scene *whole[3]; /* of as many triangles as they have by default */
static ts_scene *least[3]; /* of 10,000 triangles, made by one thread */

static ts_scene *make(const char *spec, u32 seed)
{
	ts_params params;
	ts_scene *scene;
	ts_params_default(&params);
	ts_build *build = ts_build_new(spec);
	assert_non_null(build);
	params.seed = seed;
	ts_builtin_make(build, spec, &params);
	if (ts_build_finish(build, &params, NULL, &scene) != TS_OK) fail_msg("%s", ts_error_message());
	return scene;
}

/* Of small textures, which cost most. */
static ts_scene *make_count(u32 which, const char *count)
{
	char spec[64];
	snprintf(spec, sizeof spec, "%s:triangles=%s:texels=64", names[which], count);
	return make(spec, 0);
}

static void the_table_names_each_scene(void **state)
{
	(void)state;
	const ts_builtin_info *b;
	for (size_t i = 0; (b = ts_builtin_at(i)) != NULL || i < 4; i++) {
		if (i < 3) assert_string_equal(b->name, names[i]);
		assert_true(strlen(b->doc) > 0);
		assert_true(ts_builtin_is(b->name));
	}
	assert_true(ts_builtin_is("gallery:triangles=9"));
	assert_false(ts_builtin_is("atriums"));
	assert_false(ts_builtin_is("atri"));
	assert_false(ts_builtin_is(""));
	assert_false(ts_builtin_is("./atrium"));
}

static void the_names_are_listed_and_cut(void **state)
{
	(void)state;
	char text[256] = "", right[256] = "";
	for (size_t i = 0; ts_builtin_at(i) != NULL; i++) {
		if (i > 0) strcat(right, ts_builtin_at(i + 1) != NULL ? ", " : " and ");
		strcat(right, ts_builtin_at(i)->name);
	}
	ts_builtin_names(text, sizeof text);
	assert_string_equal(text, right);
	ts_builtin_names(text, 10);
	assert_string_equal(text, "atrium, g");
}

static void an_unknown_scene_is_refused(void **state)
{
	(void)state;
	ts_params params;
	ts_params_default(&params);
	ts_scene *scene = (ts_scene *)&params;
	assert_int_equal(ts_builtin_open(&scene, "atriums", &params, NULL), TS_ERROR);
	assert_null(scene);
	char names_of[128], right[256];
	ts_builtin_names(names_of, sizeof names_of);
	snprintf(right, sizeof right, "\"atriums\" is no built-in scene; there are %s", names_of);
	assert_string_equal(ts_error_message(), right);
}

static void scenes_have_as_many_triangles_as_asked(void **state)
{
	(void)state;
	static const struct {
		const char *text;
		u32 count;
	} ask[] = {{"10000", 10000}, {"12.347k", 12347}, {"100k", 100000}, {"1.05M", 1050000}, {"4M", 4000000}};
	for (u32 k = 0; k < 3; k++) {
		for (u32 i = 0; i < sizeof ask / sizeof *ask; i++) {
			if (ask[i].count > 1000000 && i % 3 != k) continue; /* millions of one scene each */
			ts_scene *scene = make_count(k, ask[i].text);
			if (scene->n_triangles != ask[i].count)
				fail_msg("%s:triangles=%s has %u", names[k], ask[i].text, scene->n_triangles);
			ts_scene_free(scene);
		}
		assert_int_equal(whole[k]->n_triangles, 300000);
	}
}

static void wrong_options_are_refused_in_one_line(void **state)
{
	(void)state;
	static const char *const bad[][2] = {{"atrium:", "unknown option"},
	                                     {"atrium:triangle=20k", "unknown option"},
	                                     {"dining:triangles=", "no count"},
	                                     {"dining:triangles=.", "no count"},
	                                     {"dining:triangles=1e5", "no count"},
	                                     {"dining:triangles=-20000", "no count"},
	                                     {"dining:triangles=20 000", "no count"},
	                                     {"dining:triangles=20kk", "no count"},
	                                     {"dining:triangles=1.2.3M", "no count"},
	                                     {"dining:triangles=99999999999999999999", "no count"},
	                                     {"gallery:triangles=9999", "out of range"},
	                                     {"gallery:triangles=16000001", "out of range"},
	                                     {"gallery:triangles=9999999999M", "out of range"},
	                                     {"gallery:triangles=0", "out of range"},
	                                     {"atrium:surfels=20000", "unknown option"},
	                                     {"atrium:texels=48", "48 texels a side; write a power of two"},
	                                     {"atrium:texels=8", "8 texels are out of range; 16 to 512"},
	                                     {"atrium:texels=1k", "1000 texels are out of range"},
	                                     {"atrium:texels", "no count"},
	                                     {"atrium:texels=64:", "unknown option"},
	                                     {"atrium:texels=64;triangles=10k", "no count"},
	                                     {"atrium:triangles=10k:texel=64", "unknown option \"texel=64\""}};
	ts_params params;
	ts_params_default(&params);
	for (u32 i = 0; i < sizeof bad / sizeof *bad; i++) {
		ts_build *build = ts_build_new(bad[i][0]);
		ts_scene *scene;
		ts_builtin_make(build, bad[i][0], &params);
		assert_int_equal(ts_build_finish(build, &params, NULL, &scene), TS_ERROR);
		assert_null(scene);
		if (!strstr(ts_error_message(), bad[i][1]))
			fail_msg("%s: \"%s\" does not say \"%s\"", bad[i][0], ts_error_message(), bad[i][1]);
		assert_null(strchr(ts_error_message(), '\n'));
	}
}

static bool same(const ts_scene *a, const ts_scene *b)
{
	return a->n_vertices == b->n_vertices && a->n_texels == b->n_texels &&
	       memcmp(a->vertices, b->vertices, a->n_vertices * sizeof *a->vertices) == 0 &&
	       memcmp(a->triangles, b->triangles, a->n_triangles * sizeof *a->triangles) == 0 &&
	       memcmp(a->materials, b->materials, a->n_materials * sizeof *a->materials) == 0 &&
	       memcmp(a->texels, b->texels, a->n_texels * sizeof *a->texels) == 0;
}

static void any_threads_build_the_same_scene(void **state)
{
	(void)state;
	for (u32 k = 0; k < 3; k++) {
		ts_scene *three = make_count(k, "10k");
		assert_true(same(least[k], three));
		ts_scene_free(three);
	}
}

/* The same shapes with smaller textures, in either order of the options. */
static void smaller_textures_keep_the_shapes(void **state)
{
	(void)state;
	ts_scene *small = make("dining:triangles=10k:texels=16", 0), *turned = make("dining:texels=16:triangles=10k", 0);
	ts_scene *full = make("dining:triangles=10k", 0);
	assert_true(same(small, turned));
	assert_int_equal(small->n_triangles, full->n_triangles);
	assert_memory_equal(small->vertices, full->vertices, full->n_vertices * sizeof *full->vertices);
	assert_true(small->n_texels < full->n_texels / 200);
	ts_scene_free(small);
	ts_scene_free(turned);
	ts_scene_free(full);
}

static void another_seed_changes_the_scene(void **state)
{
	(void)state;
	for (u32 k = 0; k < 3; k++) {
		char spec[64];
		snprintf(spec, sizeof spec, "%s:triangles=10k:texels=64", names[k]);
		ts_scene *other = make(spec, 1);
		assert_false(same(least[k], other));
		assert_int_equal(least[k]->n_triangles, other->n_triangles);
		ts_scene_free(other);
	}
}

/* The last test: the process goes on keeping. */
static void kept_paintings_make_the_same_scenes(void **state)
{
	(void)state;
	ts_builtin_keep();
	for (u32 k = 0; k < 6; k++) {
		ts_scene *kept = make_count(k % 3, "10k");
		assert_true(same(least[k % 3], kept));
		ts_scene_free(kept);
	}
	another_seed_changes_the_scene(state);
	smaller_textures_keep_the_shapes(state);
}

static ts_v3 corner(const ts_scene *scene, u32 triangle, u32 k)
{
	return ts_load3(scene->vertices[scene->triangles[triangle].vertex[k]].position);
}

static ts_v3 face(const ts_scene *scene, u32 i)
{
	ts_v3 a = corner(scene, i, 0);
	return ts_cross(ts_sub(corner(scene, i, 1), a), ts_sub(corner(scene, i, 2), a));
}

static void normals_agree_with_their_faces(void **state)
{
	(void)state;
	for (u32 k = 0; k < 3; k++) {
		const ts_scene *scene = whole[k];
		u32 against = 0;
		assert_int_equal(scene->n_degenerate, 0);
		for (u32 i = 0; i < scene->n_vertices; i++) {
			f32 length = ts_length(ts_load3(scene->vertices[i].normal));
			if (!(length > 0.9999f && length < 1.0001f))
				fail_msg("%s: normal %u has length %g", names[k], i, (double)length);
		}
		for (u32 i = 0; i < scene->n_triangles; i++) {
			ts_v3 sum = {0.0f, 0.0f, 0.0f};
			for (u32 v = 0; v < 3; v++)
				sum = ts_add(sum, ts_load3(scene->vertices[scene->triangles[i].vertex[v]].normal));
			if (ts_dot(face(scene, i), sum) <= 0.0f) against++;
		}
		if (against > scene->n_triangles / 2000)
			fail_msg("%s: %u faces are turned away from their normals", names[k], against);
	}
}

/* Whether the ray meets any triangle from its front (Moeller and Trumbore, in doubles for its own sake). */
static bool hits_front(const ts_scene *scene, ts_v3 o, ts_v3 d)
{
	for (u32 i = 0; i < scene->n_triangles; i++) {
		ts_v3 a = corner(scene, i, 0), e1 = ts_sub(corner(scene, i, 1), a), e2 = ts_sub(corner(scene, i, 2), a);
		ts_v3 p = ts_cross(d, e2), s = ts_sub(o, a), q = ts_cross(s, e1);
		double det = (double)ts_dot(e1, p), u = (double)ts_dot(s, p), v = (double)ts_dot(d, q),
			   t = (double)ts_dot(e2, q);
		if (det > 0.0 && u >= 0.0 && v >= 0.0 && u + v <= det && t > 0.0) return true;
	}
	return false;
}

/* From everywhere on the eye's path, nothing but the roof's opening shows the outside: no ray to the floor or the walls
 * escapes. The dining room's windows are open to the sky, so only its floor is asked for. */
static void rooms_are_closed(void **state)
{
	(void)state;
	ts_params params;
	ts_params_default(&params);
	for (u32 k = 0; k < 3; k++) {
		const ts_scene *scene = least[k];
		for (u32 frame = 0; frame < 240; frame += 24) {
			ts_view view;
			params.frame = frame;
			ts_view_eye(&view, &scene->info, &params);
			for (u32 i = 0; i < 48; i++) {
				u32 id = frame * 64 + i;
				f32 turn = ts_uniform(ts_random(id, 6u, 1u)), low = k == 2 ? -4.0f : -1.0f;
				f32 y = low + 1.125f * ts_uniform(ts_random(id, 6u, 2u)) * (k == 2 ? 0.0f : 1.0f);
				ts_v3 d = {ts_cos_turn(turn), y, ts_sin_turn(turn)};
				if (!hits_front(scene, ts_load3(view.eye), d))
					fail_msg("%s: frame %u: a ray along %g %g %g escapes", names[k], frame, (double)d.x, (double)d.y,
					         (double)d.z);
			}
		}
	}
}

static void the_path_of_the_eye_is_free(void **state)
{
	(void)state;
	for (u32 k = 0; k < 3; k++) {
		const ts_scene *scene = whole[k];
		ts_params params;
		ts_params_default(&params);
		for (u32 step = 0; step < 240; step++) {
			ts_view view;
			params.frame = step;
			params.eye_distance = step % 8u == 7u ? TS_EYE_NEAR : TS_EYE_FAR;
			ts_view_eye(&view, &scene->info, &params);
			for (u32 i = 0; i < scene->n_vertices; i += 3) {
				ts_v3 away = ts_sub(ts_load3(scene->vertices[i].position), ts_load3(view.eye));
				if (ts_dot(away, away) < 0.0225f)
					fail_msg("%s: frame %u: something is nearer to the eye than 0.15 m", names[k], params.frame);
			}
		}
	}
}

static int by_size(const void *a, const void *b)
{
	f32 x = *(const f32 *)a, y = *(const f32 *)b;
	return (x > y) - (x < y);
}

static void triangles_are_of_all_sizes(void **state)
{
	(void)state;
	for (u32 k = 0; k < 3; k++) {
		const ts_scene *scene = whole[k];
		u32 n = scene->n_triangles;
		f32 *area = malloc(n * sizeof *area);
		assert_non_null(area);
		for (u32 i = 0; i < n; i++) area[i] = ts_length(face(scene, i)) * 0.5f;
		qsort(area, n, sizeof *area, by_size);
		f32 spread = area[n - n / 1000] / area[n / 1000];
		if (spread < 1000.0f) fail_msg("%s: areas at 0.1 and 99.9 %% differ by only %g", names[k], (double)spread);
		free(area);
	}
}

static void every_slot_is_used(void **state)
{
	(void)state;
	u32 used[TS_N_SLOTS] = {0}, flags = 0;
	for (u32 k = 0; k < 3; k++) {
		const ts_scene *scene = least[k];
		for (u32 i = 0; i < scene->n_materials; i++) {
			for (u32 s = 0; s < TS_N_SLOTS; s++) used[s] += scene->materials[i].slot[s] != TS_NONE;
			flags |= scene->materials[i].flags;
		}
	}
	for (u32 s = 0; s < TS_N_SLOTS; s++) assert_true(used[s] > 0);
	assert_int_equal(flags, TS_DOUBLE_SIDED | TS_MASKED);
}

static int begin(void **state)
{
	(void)state;
	for (u32 k = 0; k < 3; k++) {
		char spec[64];
		snprintf(spec, sizeof spec, "%s:texels=16", names[k]);
		omp_set_num_threads(1);
		least[k] = make_count(k, "10k");
		omp_set_num_threads(3);
		whole[k] = make(spec, 0);
	}
	return 0;
}

static int end(void **state)
{
	(void)state;
	for (u32 k = 0; k < 3; k++) {
		ts_scene_free(least[k]);
		ts_scene_free(whole[k]);
	}
	return 0;
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(the_table_names_each_scene),
		cmocka_unit_test(the_names_are_listed_and_cut),
		cmocka_unit_test(an_unknown_scene_is_refused),
		cmocka_unit_test(scenes_have_as_many_triangles_as_asked),
		cmocka_unit_test(wrong_options_are_refused_in_one_line),
		cmocka_unit_test(any_threads_build_the_same_scene),
		cmocka_unit_test(smaller_textures_keep_the_shapes),
		cmocka_unit_test(another_seed_changes_the_scene),
		cmocka_unit_test(normals_agree_with_their_faces),
		cmocka_unit_test(rooms_are_closed),
		cmocka_unit_test(the_path_of_the_eye_is_free),
		cmocka_unit_test(triangles_are_of_all_sizes),
		cmocka_unit_test(every_slot_is_used),
		cmocka_unit_test(kept_paintings_make_the_same_scenes),
	};
	return cmocka_run_group_tests(tests, begin, end);
}

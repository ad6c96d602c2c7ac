/* What the pictures of a file show: a room, a thing, or what looks like one; where eye, mirrors and lamps stand. */
#include "kernels/base/pose.h"
#include "kernels/base/scene.h"
#include "scene/lamp.h"
#include "scene/sources.h"
#include "scene/view.h"
#include "tests/model/test.h"

static ts_params params;
static u32 two_sided;

static ts_build *start(void)
{
	ts_params_default(&params);
	params.width = 480;
	params.height = 270;
	ts_build *build = ts_build_new("places");
	assert_non_null(build);
	ts_material material = ts_material_default();
	material.flags = TS_DOUBLE_SIDED;
	two_sided = ts_build_material(build, &material);
	return build;
}

static u32 corner(ts_build *build, f32 x, f32 y, f32 z)
{
	ts_vertex v = {.position = {x, y, z}};
	return ts_build_vertex(build, &v);
}

/* A box whose faces look outwards, or inwards. */
static void box(ts_build *build, const f32 low[3], const f32 high[3], bool inwards, u32 material)
{
	for (u32 face = 0; face < 6; face++) {
		u32 axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3, c[4];
		for (u32 k = 0; k < 4; k++) {
			f32 p[3];
			p[axis] = (face & 1 ? high : low)[axis];
			p[u] = (k == 1 || k == 2 ? high : low)[u];
			p[v] = (k >= 2 ? high : low)[v];
			c[k] = corner(build, p[0], p[1], p[2]);
		}
		bool turned = ((face & 1) == 0) != inwards;
		ts_build_triangle(build, c[0], c[turned ? 2 : 1], c[turned ? 1 : 2], material);
		ts_build_triangle(build, c[0], c[turned ? 3 : 2], c[turned ? 2 : 3], material);
	}
}

static void ground(ts_build *build, f32 y, f32 reach)
{
	u32 a = corner(build, -reach, y, reach);
	corner(build, reach, y, reach);
	corner(build, reach, y, -reach);
	corner(build, -reach, y, -reach);
	ts_build_triangle(build, a, a + 1, a + 2, TS_NONE);
	ts_build_triangle(build, a, a + 2, a + 3, TS_NONE);
}

static void furnish(ts_build *build)
{
	for (u32 i = 0; i < 12; i++) {
		f32 x = -4.0f + (f32)(i % 4) * 2.4f, z = -3.0f + (f32)(i / 4) * 2.6f;
		const f32 low[3] = {x, 0.0f, z}, high[3] = {x + 0.4f, 0.3f, z + 0.4f};
		box(build, low, high, false, TS_NONE);
	}
}

static ts_scene *open_with(ts_build *build, const ts_scene_options *options)
{
	ts_scene *scene;
	const char *camera = ts_arrange(build, &params, options, true);
	if (ts_build_finish(build, &params, camera, &scene) != TS_OK) fail_msg("%s", ts_error_message());
	return scene;
}

static ts_view eye_of(const ts_scene *scene)
{
	ts_view view;
	ts_view_eye(&view, &scene->info, &params);
	return view;
}

/* Every mirror is in the picture, apart from its eye and from the others, and what it may not touch is not near. */
static void check_mirrors(const ts_scene *scene, u32 n)
{
	ts_view view = eye_of(scene);
	u32 n_seen = 0;
	assert_int_equal(scene->info.n_reflectors, n);
	for (u32 i = 1; i < scene->n_objects; i++) {
		f32 depth;
		ts_v3 p = ts_k_pose(&scene->objects[i], 0).centre;
		n_seen += ts_view_holds(&view, p, 0.0f, &depth);
		for (u32 k = 1; k < i; k++) assert_true(ts_length(ts_sub(p, ts_k_pose(&scene->objects[k], 0).centre)) > 0.0f);
	}
	assert_true(n_seen * 2 >= n);
}

static f32 radius_of(const ts_scene *scene, u32 object)
{
	return ts_length(ts_load3(scene->vertices[scene->objects[object].first_vertex].position));
}

/* Pixels across, of all mirrors: by the axial depth of those in the picture, else by the distance. */
static double mean_diameter(const ts_scene *scene)
{
	ts_view view = eye_of(scene);
	double sum = 0.0;
	for (u32 i = 1; i < scene->n_objects; i++) {
		f32 depth;
		ts_v3 p = ts_k_pose(&scene->objects[i], 0).centre;
		bool held = ts_view_holds(&view, p, 0.0f, &depth);
		f32 distance = held ? depth : ts_length(ts_sub(p, ts_load3(view.eye)));
		sum += 2.0 * (double)view.focal * (double)radius_of(scene, i) / (double)distance;
	}
	return sum / scene->info.n_reflectors;
}

/* What a note says in its first number; 0 without such a note. */
static double noted(const ts_scene *scene, const char *words)
{
	for (u32 i = 0; i < scene->n_notes; i++) {
		const char *number = strpbrk(scene->notes[i], "0123456789");
		if (strstr(scene->notes[i], words) != NULL && number != NULL) return strtod(number, NULL);
	}
	return 0.0;
}

/* The mean is what was asked for, or less, and then a note says what it is. Returns whether it is. */
static bool check_mean(const ts_scene *scene)
{
	double mean = mean_diameter(scene), asked = (double)params.reflectors_px;
	double less = noted(scene, "px across instead of reflectors.px");
	if (less == 0.0 ? fabs(mean / asked - 1.0) > 1.0 / 64 : less > asked || fabs(mean / less - 1.0) > 1e-4)
		fail_msg("%u mirrors: %g px across of %g, noted %g", scene->info.n_reflectors, mean, asked, less);
	return fabs(mean / asked - 1.0) < 1e-4;
}

/* Mirrors that have places touch neither each other nor anything else. */
static void check_free(const ts_scene *scene)
{
	ts_rays *rays = ts_rays_new(scene);
	double n_touching = 0.0;
	assert_non_null(rays);
	for (u32 i = 1; i < scene->n_objects; i++) {
		f32 radius = radius_of(scene, i);
		ts_v3 p = ts_k_pose(&scene->objects[i], 0).centre;
		bool touches = ts_rays_clearance(rays, p, radius) < radius;
		for (u32 k = 1; k < i; k++)
			touches |= ts_length(ts_sub(p, ts_k_pose(&scene->objects[k], 0).centre)) < 2.0f * radius;
		n_touching += touches;
	}
	ts_rays_free(rays);
	assert_true(n_touching <= noted(scene, "have no free place"));
}

static const f32 low[3] = {-5.0f, 0.0f, -4.0f}, high[3] = {5.0f, 3.0f, 4.0f};

static void a_room_on_ground_keeps_its_box(void **state)
{
	(void)state;
	ts_build *build = start();
	box(build, low, high, true, TS_NONE);
	furnish(build);
	ground(build, -0.001f, 4000.0f);
	ts_scene *scene = open_with(build, NULL);
	assert_int_equal(scene->info.circles, TS_CIRCLES_ROOM);
	for (u32 k = 0; k < 3; k++) {
		assert_true(fabs((double)(scene->info.box_min[k] - low[k])) < 0.2);
		assert_true(fabs((double)(scene->info.box_max[k] - high[k])) < 0.2);
	}
	ts_view view = eye_of(scene);
	for (u32 k = 0; k < 3; k++) assert_true(view.eye[k] > low[k] && view.eye[k] < high[k]);
	check_mirrors(scene, 10);
	ts_scene_free(scene);
}

/* A thing is seen whole from outside, and fills nine tenths of the height or the width, with a ground or without. */
static void a_thing_is_seen_whole_from_outside(void **state)
{
	(void)state;
	for (u32 with = 0; with < 3; with++) {
		ts_build *build = start();
		const f32 a[3] = {-1.0f, 0.0f, -0.5f}, b[3] = {1.0f, 2.0f, 0.5f};
		box(build, a, b, false, with == 2 ? two_sided : TS_NONE);
		if (with == 1) ground(build, 0.0f, 500.0f);
		ts_scene *scene = open_with(build, NULL);
		assert_int_equal(scene->info.circles, TS_CIRCLES_OUTSIDE);
		ts_view view = eye_of(scene);
		f32 widest = 0.0f;
		for (u32 k = 0; k < 8; k++) {
			f32 depth;
			ts_v3 c = ts_v3_make(k & 1 ? b[0] : a[0], k & 2 ? b[1] : a[1], k & 4 ? b[2] : a[2]);
			assert_true(ts_view_holds(&view, c, 1.0f, &depth));
			ts_v3 d = ts_sub(c, ts_load3(view.eye));
			f32 up = ts_abs(ts_dot(d, ts_load3(view.up))) * view.focal / depth / 135.0f;
			f32 across = ts_abs(ts_dot(d, ts_load3(view.right))) * view.focal / depth / 240.0f;
			widest = ts_max(widest, ts_max(up, across));
		}
		if (widest < (with == 1 ? 0.8f : 0.899f) || widest > 0.91f) fail_msg("%g", (double)widest);
		check_mirrors(scene, 10);
		for (u32 i = 1; i < scene->n_objects; i++) {
			ts_v3 p = ts_k_pose(&scene->objects[i], 0).centre;
			assert_false(p.x > a[0] && p.x < b[0] && p.y > a[1] && p.y < b[1] && p.z > a[2] && p.z < b[2]);
		}
		ts_scene_free(scene);
	}
}

/* An empty room, one with posts in the way of mirrors, and a thing. */
static void make(ts_build *build, u32 kind)
{
	const f32 a[3] = {-1.0f, 0.0f, -0.5f}, b[3] = {1.0f, 2.0f, 0.5f};
	if (kind == 2) box(build, a, b, false, TS_NONE);
	if (kind == 2) return;
	box(build, low, high, true, TS_NONE);
	furnish(build);
	for (u32 i = 0; i < 6 && kind == 1; i++) {
		f32 x = -4.0f + 1.5f * (f32)i, z = -3.0f + (f32)i;
		const f32 foot[3] = {x, 0.0f, z}, head[3] = {x + 0.4f, 2.9f, z + 0.4f};
		box(build, foot, head, false, TS_NONE);
	}
}

/* Wherever rays place the mirrors, their mean size at these places is what was asked for, as long as they fit. */
static void mirrors_have_the_mean_size_asked_for(void **state)
{
	(void)state;
	u32 n_exact = 0, n = 0;
	for (u32 kind = 0; kind < 3; kind++) {
		for (u32 count = 1; count < 40; count = count * 2 + 1) {
			for (f32 px = 10.0f; px < 80.0f; px += 10.0f, n++) {
				ts_build *build = start();
				params.reflectors_count = count;
				params.reflectors_px = px;
				make(build, kind);
				ts_scene *scene = open_with(build, NULL);
				n_exact += check_mean(scene);
				check_free(scene);
				ts_scene_free(scene);
			}
		}
	}
	if (n_exact * 4 < n * 3) fail_msg("%u of %u have the size that was asked for", n_exact, n);
}

/* Where mirrors that grow again would find too few places they stay as they were, and do not shrink. */
static void mirrors_without_room_stay_as_they_were(void **state)
{
	(void)state;
	ts_build *build = start();
	params.reflectors_count = 15;
	params.reflectors_px = 70.0f;
	make(build, 0);
	ts_scene *scene = open_with(build, NULL);
	check_mean(scene);
	check_free(scene);
	double mean = mean_diameter(scene), quarter = params.height * 0.25;
	if (mean < 0.9 * quarter || mean > 0.95 * quarter) fail_msg("%g px of %g", mean, quarter);
	ts_scene_free(scene);
}

/* "circle" has nothing that rays found. */
static void the_circle_asks_no_rays(void **state)
{
	(void)state;
	const ts_scene_options circle = {.camera = TS_CAMERA_CIRCLE};
	ts_build *build = start();
	const f32 a[3] = {-1.0f, 0.0f, -0.5f}, b[3] = {1.0f, 2.0f, 0.5f};
	box(build, a, b, false, TS_NONE);
	ts_camera camera = {.name = "door", .right = {1, 0, 0}, .up = {0, 1, 0}, .back = {0, 0, 1}};
	ts_build_camera(build, &camera);
	ts_scene *scene = open_with(build, &circle);
	assert_int_equal(scene->info.circles, TS_CIRCLES_HALL);
	assert_int_equal(scene->camera, TS_NONE);
	assert_int_equal(scene->n_stands, 0);
	assert_float_equal(eye_of(scene).eye[0], 0.9f, 1e-6f);
	ts_scene_free(scene);
}

/* The first camera is the eye unless another is asked for; its field of view is its own unless fov is said. */
static void the_first_camera_is_the_eye(void **state)
{
	(void)state;
	const f32 eye[3] = {0, 1, 9}, target[3] = {0, 1, 0}, up[3] = {0, 20, 0};
	const ts_scene_options wanted[] = {{0},
	                                   {.camera = "two"},
	                                   {.own_fov = 1},
	                                   {.eye = eye, .target = target},
	                                   {.eye = eye},
	                                   {.eye = up, .target = target}};
	const f32 x[] = {7, 8, 7, 0, 0, 0}, yfov[] = {0.125f, 0.125f, 0, 0, 0, 0};
	for (u32 i = 0; i < sizeof wanted / sizeof *wanted; i++) {
		ts_build *build = start();
		box(build, low, high, false, TS_NONE);
		for (u32 k = 0; k < 2; k++) {
			ts_camera camera = {.name = k == 0 ? "one" : "two",
			                    .eye = {7.0f + (f32)k, 1, 9},
			                    .right = {1, 0, 0},
			                    .up = {0, 1, 0},
			                    .back = {0, 0, 1},
			                    .yfov = 0.125f};
			ts_build_camera(build, &camera);
		}
		ts_scene *scene = open_with(build, &wanted[i]);
		assert_int_equal(scene->info.circles, TS_CIRCLES_NOT);
		assert_true(scene->info.eye[0] == x[i] && scene->info.yfov == yfov[i]);
		ts_v3 right = ts_load3(scene->info.right), back = ts_load3(scene->info.back);
		assert_float_equal(ts_length(right), 1.0f, 1e-6f);
		assert_float_equal(ts_dot(right, back), 0.0f, 1e-6f);
		if (i == 5) assert_float_equal(back.y, 1.0f, 1e-6f);
		ts_scene_free(scene);
	}
}

static void given_mirrors_and_lamps_stand_where_told(void **state)
{
	(void)state;
	const f32 mirrors[2][4] = {{1, 1, 1, 0.5f}, {-1, 2, 0, 0.25f}}, lamp[3] = {2, 2.5f, 1};
	const ts_scene_options options = {.mirrors = mirrors, .n_mirrors = 2, .lamp = lamp};
	ts_build *build = start();
	params.reflectors_count = 0;
	box(build, low, high, true, TS_NONE);
	furnish(build);
	ts_scene *scene = open_with(build, &options);
	assert_int_equal(scene->info.n_reflectors, 2);
	assert_int_equal(scene->n_triangles_file, 13 * 12);
	for (u32 i = 0; i < 2; i++) {
		const ts_object *o = &scene->objects[i + 1];
		assert_true(o->period == 0 && o->reflector == i && o->n_vertices > 0);
		for (u32 k = 0; k < o->n_vertices; k++) {
			ts_v3 p = ts_load3(scene->vertices[o->first_vertex + k].position);
			assert_float_equal(ts_length(ts_sub(p, ts_load3(mirrors[i]))), mirrors[i][3], 1e-4f);
		}
	}
	assert_int_equal(scene->n_stands, TS_N_STANDS);
	for (u32 k = 0; k < TS_N_STANDS; k++) assert_memory_equal(scene->stands[k].position, lamp, sizeof lamp);
	ts_scene_free(scene);
}

/* A cupboard stands where the hall would have its lamp. */
static void the_lamp_avoids_the_cupboard(void **state)
{
	(void)state;
	ts_build *build = start();
	box(build, low, high, true, TS_NONE);
	furnish(build);
	const f32 a[3] = {3.0f, 1.5f, 1.8f}, b[3] = {4.2f, 2.95f, 3.0f};
	box(build, a, b, false, two_sided);
	ts_scene *scene = open_with(build, NULL);
	assert_int_equal(scene->n_stands, TS_N_STANDS);
	const f32 *p = scene->stands[TS_STAND_SPOT].position;
	assert_false(p[0] > a[0] && p[0] < b[0] && p[1] > a[1] && p[1] < b[1] && p[2] > a[2] && p[2] < b[2]);
	for (u32 k = 0; k < 3; k++) assert_true(p[k] > low[k] && p[k] < high[k]);
	ts_scene_free(scene);
}

/* A shelf of two-sided boards, into which the eye looks: the lamp lights the middle of its back through the open front,
 * and not the boards' other sides from above. */
static void the_lamp_lights_a_shelf_from_ahead(void **state)
{
	(void)state;
	static const f32 boards[5][2][3] = {{{-1, 0, -0.3f}, {1, 0, 0.3f}},
	                                    {{-1, 2, -0.3f}, {1, 2, 0.3f}},
	                                    {{-1, 0, -0.3f}, {-1, 2, 0.3f}},
	                                    {{1, 0, -0.3f}, {1, 2, 0.3f}},
	                                    {{-1, 0, -0.3f}, {1, 2, -0.3f}}};
	const ts_scene_options before = {.eye = (const f32[3]){-1, 0.6f, 2.8f}, .target = (const f32[3]){0.3f, 1, 0}};
	ts_build *build = start();
	params.reflectors_count = 0;
	for (u32 i = 0; i < 5; i++) box(build, boards[i][0], boards[i][1], false, two_sided);
	ts_scene *scene = open_with(build, &before);
	assert_true(ts_view_is_open(&scene->info));
	assert_int_equal(scene->n_stands, TS_N_STANDS);
	ts_v3 lamp = ts_load3(scene->stands[TS_STAND_SPOT].position), back = ts_v3_make(0, 1, -0.3f);
	f32 away = ts_length(ts_sub(lamp, ts_view_box(&scene->info).middle));
	assert_float_equal(away, ts_lamp_distance(&scene->info), 1e-5f * away);
	assert_true(lamp.z > 0.3f);
	ts_v3 through = ts_mad(back, ts_sub(lamp, back), 0.6f / (lamp.z + 0.3f));
	assert_true(through.x > -1.0f && through.x < 1.0f && through.y > 0.0f && through.y < 2.0f);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_room_on_ground_keeps_its_box),
		cmocka_unit_test(a_thing_is_seen_whole_from_outside),
		cmocka_unit_test(mirrors_have_the_mean_size_asked_for),
		cmocka_unit_test(mirrors_without_room_stay_as_they_were),
		cmocka_unit_test(the_circle_asks_no_rays),
		cmocka_unit_test(the_first_camera_is_the_eye),
		cmocka_unit_test(given_mirrors_and_lamps_stand_where_told),
		cmocka_unit_test(the_lamp_avoids_the_cupboard),
		cmocka_unit_test(the_lamp_lights_a_shelf_from_ahead),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

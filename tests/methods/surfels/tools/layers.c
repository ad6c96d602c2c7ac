/* Layers that epsilon blends: a carpet over a floor, by the pixels that it covers and its height; and none where a
 * surface is one, however it slants, bends, is rough or is seen. */
#include "methods/surfels/tools/tools.h"
#include "tests/methods/surfels/surfels.h"
#include "tests/scene/folder.h"

/* HALF * 2 surfels a side of the floor; of so many pixels each third along and across is measured. */
enum { WIDTH = 320, HEIGHT = 240, HALF = 60, STEP = 3 };
#define SPACING 0.02f
#define GAP 0.005f

static f32 flat(f32 x, f32 z)
{
	(void)x;
	(void)z;
	return 0;
}

static f32 slanted(f32 x, f32 z) { return 0.5f * x - 0.3f * z; }
static f32 rough(f32 x, f32 z)
{
	(void)x;
	(void)z;
	return 2 * GAP * surfels_uniform();
}
static f32 hilly(f32 x, f32 z) { return 0.1f * ts_sin_turn(x) * ts_cos_turn(z); }

/* A surfel on a height field, turned by its slope. */
static void add(ts_build *build, f32 (*height)(f32 x, f32 z), f32 x, f32 z, f32 above)
{
	const f32 step = SPACING / 2;
	f32 y = height(x, z), dx = (height(x + step, z) - y) / step, dz = (height(x, z + step) - y) / step;
	if (height == rough) dx = dz = 0;
	ts_v3 n = ts_normalize(ts_v3_make(-dx, 1, -dz));
	surfels_add(build, ts_add(ts_v3_make(x, y, z), ts_scale(n, above)), n, 1.5f * SPACING, 1, ts_v3_make(1, 1, 1));
}

/* A floor, and with `carpet` a square of half its sides over the middle. */
static ts_layers measure(f32 (*height)(f32 x, f32 z), bool carpet, f32 epsilon, char note[TS_NOTE_CHARS])
{
	ts_run run;
	ts_scene *scene;
	ts_layers layers;
	ts_params params = small_params(WIDTH, HEIGHT);
	params.surfel_depth_epsilon = epsilon;
	ts_build *build = ts_build_new("carpet");
	char name[] = "eye";
	ts_camera camera = {.name = name, .eye = {0, 1.6f, 1.6f}, .right = {1, 0, 0}, .yfov = 0.125f};
	ts_v3 back = ts_normalize(ts_v3_make(0, 1, 1));
	ts_store3(camera.back, back);
	ts_store3(camera.up, ts_cross(back, ts_v3_make(1, 0, 0)));
	ts_build_camera(build, &camera);
	surfels_random = 0;
	for (i32 i = -HALF; i < HALF; i++) {
		for (i32 k = -HALF; k < HALF; k++) {
			f32 x = ((f32)i + 0.5f) * SPACING, z = ((f32)k + 0.5f) * SPACING;
			bool covered = i >= -HALF / 2 && i < HALF / 2 && k >= -HALF / 2 && k < HALF / 2;
			add(build, height, x, z, 0);
			if (carpet && covered) add(build, height, x + 0.3f * SPACING, z + 0.4f * SPACING, GAP);
		}
	}
	if (ts_build_finish(build, &params, "eye", &scene) != TS_OK) fail_msg("%s", ts_error_message());
	surfels_run(&run, scene, &params, "deferred", 2);
	note[0] = '\0';
	assert_int_equal(ts_layers_measure(&layers, &run), TS_OK);
	assert_int_equal(ts_layers_note(note, &run), TS_OK);
	ts_run_end(&run);
	ts_scene_free(scene);
	return layers;
}

/* To the nearest centre of a lattice that is moved by a share of a spacing, in radii. */
static double nearest(double x, double z, double right, double down)
{
	double a = x / (double)SPACING - 0.5 - right, b = z / (double)SPACING - 0.5 - down;
	return hypot(a - floor(a + 0.5), b - floor(b + 0.5)) / 1.5;
}

/* The share of the floor's pixels whose rays meet floor and carpet within 0.1^(1/2) radii of a centre. */
static double expected(void)
{
	u32 all = 0, found = 0;
	double f = HEIGHT / 2.0 / tan(acos(-1) / 8), side = (double)SPACING * HALF, root = sqrt(0.1);
	for (u32 p = 0; p < WIDTH * HEIGHT; p++) {
		double i = (p % WIDTH + 0.5 - WIDTH / 2.0) / f, j = (HEIGHT / 2.0 - p / WIDTH - 0.5) / f, x[2], z[2];
		for (u32 k = 0; k < 2; k++) {
			double t = (1.6 - k * (double)GAP) * sqrt(2) / (1 - j); /* to the height of floor or carpet */
			x[k] = i * t;
			z[k] = 1.6 - t * (1 + j) / sqrt(2);
		}
		if (p % WIDTH % STEP != 0 || p / WIDTH % STEP != 0) continue;
		bool near = nearest(x[0], z[0], 0, 0) < root && nearest(x[1], z[1], 0.3, 0.4) < root;
		all += fabs(x[0]) < side && fabs(z[0]) < side;
		found += fabs(x[1]) < side / 2 && fabs(z[1]) < side / 2 && near;
	}
	return (double)found / all;
}

static void a_carpet_is_found_with_its_height(void **state)
{
	(void)state;
	char note[TS_NOTE_CHARS];
	ts_layers l = measure(flat, true, 0.02f, note);
	double share = (double)l.apart / l.pixels;
	print_message("# %u of %u pixels, %.3f instead of %.3f; gap %.6f: %s\n", l.apart, l.pixels, share, expected(),
	              (double)l.gap, note);
	assert_true(fabs(share / expected() - 1) < 0.05);
	assert_true(fabs((double)(l.gap / GAP) - 1) < 1e-4);
	assert_non_null(strstr(note, "lie 0.005 apart (median): epsilon is 0.02"));
	l = measure(hilly, true, 0.02f, note);
	assert_true(fabs((double)(l.gap / GAP) - 1) < 0.1 && strstr(note, "apart") != NULL);
}

static void one_surface_has_no_layers(void **state)
{
	(void)state;
	char note[TS_NOTE_CHARS];
	f32 (*const fields[])(f32 x, f32 z) = {flat, slanted, rough, hilly};
	for (u32 i = 0; i < sizeof fields / sizeof *fields; i++) {
		ts_layers l = measure(fields[i], false, i % 2 == 0 ? 0.02f : 0.2f, note);
		print_message("# field %u: %u of %u pixels\n", i, l.apart, l.pixels);
		assert_true(l.pixels > 1000 && l.apart < l.pixels / 500 && note[0] == '\0');
	}
	ts_layers l = measure(flat, true, 0.5f * GAP, note);
	assert_true(l.pixels > 1000 && l.apart == 0 && note[0] == '\0');
}

static void balls_have_no_layers(void **state)
{
	(void)state;
	ts_run run;
	ts_layers l;
	ts_params params = small_params(WIDTH, HEIGHT);
	ts_scene *scene = surfels_balls(&params, 4000);
	surfels_run(&run, scene, &params, "deferred", 2);
	assert_int_equal(ts_layers_measure(&l, &run), TS_OK);
	print_message("# balls: %u of %u pixels\n", l.apart, l.pixels);
	assert_true(l.pixels > 1000 && l.apart < l.pixels / 500);
	ts_run_end(&run);
	ts_scene_free(scene);
}

/* A scan of parts that are not quite in register. */
static void scans_have_hardly_a_layer(void **state)
{
	(void)state;
	static const char *const names[] = {"bunny_splats.glb", "dragon_splats.glb"};
	for (u32 i = 0; i < 2; i++) {
		char path[512];
		ts_run run;
		ts_layers l;
		ts_scene *scene;
		ts_params params = small_params(480, 400);
		params.eye_distance = TS_EYE_OUTSIDE;
		snprintf(path, sizeof path, "%s/%s", scenes_folder(), names[i]);
		FILE *file = fopen(path, "rb");
		if (file == NULL) skip();
		fclose(file);
		if (ts_scene_load(&scene, path, &params, NULL) != TS_OK) fail_msg("%s", ts_error_message());
		surfels_run(&run, scene, &params, "deferred", 2);
		assert_int_equal(ts_layers_measure(&l, &run), TS_OK);
		print_message("# %s: %u of %u pixels\n", names[i], l.apart, l.pixels);
		assert_true(l.pixels > 1000 && l.apart < l.pixels / 300);
		ts_run_end(&run);
		ts_scene_free(scene);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_carpet_is_found_with_its_height), cmocka_unit_test(one_surface_has_no_layers),
		cmocka_unit_test(balls_have_no_layers), cmocka_unit_test(scans_have_hardly_a_layer)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Point clouds as other programs write them: names and types of colours, points that are none, copies of points,
 * coordinates far from the origin, and sheets. */
#include <string.h>
#include <touchstone/touchstone.h>
#include "scene/sources.h"
#include "tests/status.h"

#define XYZ "property float x\nproperty float y\nproperty float z\n"
#define NORMAL "property float nx\nproperty float ny\nproperty float nz\n"
#define COLOUR(type) "property " type " red\nproperty " type " green\nproperty " type " blue\n"
#define POINTS(count) "ply\nformat ascii 1.0\nelement vertex " count "\n"
#define END "end_header\n"

static ts_scene *open_text(const char *text, const ts_scene_options *options)
{
	ts_params params;
	ts_scene *scene;
	ts_params_default(&params);
	const ts_scene_file file = {.name = "cloud.ply", .bytes = text, .n_bytes = strlen(text)};
	require(ts_scene_of_bytes(&scene, &file, &params, options));
	return scene;
}

static bool notes(const ts_scene *scene, const char *words)
{
	for (u32 i = 0; i < scene->n_notes; i++)
		if (strstr(scene->notes[i], words) != NULL) return true;
	return false;
}

static void has_colour(const char *text, f32 r, f32 g, f32 b, const char *note)
{
	ts_scene *scene = open_text(text, NULL);
	const f32 *c = scene->surfels[0].colour;
	if (ts_abs(c[0] - r) + ts_abs(c[1] - g) + ts_abs(c[2] - b) > 1e-3f)
		fail_msg("%s\nis %g %g %g", text, (double)c[0], (double)c[1], (double)c[2]);
	if (note != NULL && !notes(scene, note)) fail_msg("no note \"%s\"", note);
	ts_scene_free(scene);
}

#define ONE POINTS("1") XYZ NORMAL "property float radius\n"
#define AT "0 0 0 0 0 1 1 "

static void colours_are_what_their_writers_meant(void **state)
{
	(void)state;
	has_colour(ONE COLOUR("float") END AT "255 128 0\n", 1, 0.2158605f, 0,
	           "colours of floats up to 255 are read as codes");
	has_colour(ONE COLOUR("double") END AT "65535 32896 0\n", 1, 0.2158605f, 0, "codes of 65535");
	has_colour(ONE COLOUR("int") END AT "255 128 0\n", 1, 0.2158605f, 0, NULL);
	has_colour(ONE COLOUR("float") END AT "-1 1.5 0.5\n", 0, 1, 0.5f, "2 colours outside 0 to 1");
	has_colour(ONE "property uchar diffuse_red\nproperty uchar diffuse_green\nproperty uchar diffuse_blue\n" END AT
	               "255 128 0\n",
	           1, 0.2158605f, 0, NULL);
	has_colour(ONE "property uchar r\nproperty uchar g\nproperty uchar b\n" END AT "0 128 255\n", 0, 0.2158605f, 1,
	           NULL);
	has_colour(ONE COLOUR("uchar") "property uchar r\n" END AT "0 128 255 9\n", 0, 0.2158605f, 1,
	           "\"r\" of points is ignored");
}

/* The good ones are as they are without the others. */
static void bad_points_are_left_out_and_counted(void **state)
{
	(void)state;
	static const char *const bad[] = {"nan 0 0 0 0 1 1\n", "0 inf 0 0 0 1 1\n", "3 3 3 0 0 0 1\n",
	                                  "3 3 3 0 0 1 0\n",   "3 3 3 0 0 1 -2\n",  "3 3 3 0 nan 1 1\n",
	                                  "3 3 3 0 0 1 nan\n", "1e8 0 0 0 0 1 1\n"};
	ts_scene *alone = open_text(ONE END "1 2 3 0 0 1 1\n", NULL);
	for (u32 i = 0; i < sizeof bad / sizeof *bad; i++) {
		char text[512];
		snprintf(text, sizeof text, POINTS("2") XYZ NORMAL "property float radius\n" END "%s1 2 3 0 0 1 1\n", bad[i]);
		ts_scene *scene = open_text(text, NULL);
		assert_int_equal(scene->n_surfels, 1);
		assert_memory_equal(scene->surfels, alone->surfels, sizeof *alone->surfels);
		if (!notes(scene, "1 points are left out, the first: point 0: ")) fail_msg("%s", bad[i]);
		ts_scene_free(scene);
	}
	ts_scene_free(alone);
}

#define GRID 5
/* A sheet in the plane z, of GRID x GRID points, each `copies` times. */
static ts_scene *open_sheet(const char *properties, const char *behind, u32 copies)
{
	static char text[16384];
	char *at = text + sprintf(text, "ply\nformat ascii 1.0\nelement vertex %u\n" XYZ "%s" END, GRID * GRID * copies,
	                          properties);
	for (u32 i = 0; i < GRID * GRID; i++)
		for (u32 k = 0; k < copies; k++) at += sprintf(at, "%u %u 0%s\n", i % GRID, i / GRID, behind);
	return open_text(text, NULL);
}

static void normals_of_0_are_none(void **state)
{
	(void)state;
	ts_scene *zero = open_sheet(NORMAL, " 0 0 0", 1), *none = open_sheet("", "", 1);
	assert_int_equal(zero->n_surfels, none->n_surfels);
	assert_memory_equal(zero->surfels, none->surfels, none->n_surfels * sizeof *none->surfels);
	assert_true(notes(zero, "all normals are 0: they are estimated"));
	ts_scene_free(zero);
	ts_scene_free(none);
}

/* As from the corners of triangles. */
static void copies_of_points_do_not_shrink_each_other(void **state)
{
	(void)state;
	for (u32 with = 0; with < 2; with++) {
		const char *properties = with ? NORMAL : "", *behind = with ? " 0 0 1" : "";
		ts_scene *once = open_sheet(properties, behind, 1), *often = open_sheet(properties, behind, 9);
		assert_int_equal(often->n_surfels, 9 * once->n_surfels);
		u32 sides = with ? 1 : 2;
		for (u32 i = 0; i < often->n_surfels; i++) {
			const ts_surfel *of = &once->surfels[i / (9 * sides) * sides + i % sides];
			assert_memory_equal(&often->surfels[i], of, sizeof *of);
		}
		ts_scene_free(once);
		ts_scene_free(often);
	}
}

static void sheets_are_seen_from_both_sides(void **state)
{
	(void)state;
	ts_scene *sheet = open_sheet("", "", 1);
	i32 up = 0;
	for (u32 i = 0; i < sheet->n_surfels; i++) {
		ts_v3 n = ts_cross(ts_load3(sheet->surfels[i].u), ts_load3(sheet->surfels[i].v));
		up += n.z > 0.0f ? 1 : -1;
	}
	assert_true(sheet->n_surfels == 2 * GRID * GRID && up == 0);
	assert_true(notes(sheet, "25 points are of sheets, whose front is not known: they are seen from both sides"));
	ts_scene_free(sheet);
}

/* A place of the file, of an eye for instance, stays one. */
static void coordinates_far_away_are_counted_from_a_middle(void **state)
{
	(void)state;
	char text[4096], *at = text;
	const double middle[3] = {4500000, 5300000, 120};
	at += sprintf(at, POINTS("9") "property double x\nproperty double y\nproperty double z\n" NORMAL END);
	for (u32 i = 0; i < 9; i++)
		at += sprintf(at, "%.2f %.2f %.2f 0 0 1\n", middle[0] + 0.01 * (i % 3), middle[1] + 0.01 * (i / 3), middle[2]);
	const f32 eye[3] = {4500000, 5300000, 125}, target[3] = {4500000, 5300000, 120};
	ts_scene *scene =
		open_text(text, &(ts_scene_options){.bytes = sizeof(ts_scene_options), .eye = eye, .target = target});
	assert_int_equal(scene->n_surfels, 9);
	for (u32 i = 0; i < 9; i++) {
		const f32 *c = scene->surfels[i].centre;
		for (u32 k = 0; k < 3; k++) {
			double right = middle[k] + (k == 0 ? 0.01 * (i % 3) : k == 1 ? 0.01 * (i / 3) : 0) - scene->origin[k];
			assert_true(ts_abs(c[k] - (f32)right) < 1e-6f);
		}
		f32 radius = ts_length(ts_load3(scene->surfels[i].u));
		assert_true(radius > 0.01f && radius < 0.03f);
	}
	assert_true(notes(scene, "the points are far from the origin"));
	assert_true(ts_abs(scene->info.eye[2] - (f32)(125 - scene->origin[2])) < 1e-3f);
	ts_scene_free(scene);
}

static void types_that_are_not_read_are_passed_over(void **state)
{
	(void)state;
	static const char *const types[] = {"uint64", "int64", "long", "ulong", "float16", "half"};
	for (u32 i = 0; i < sizeof types / sizeof *types; i++) {
		char text[512];
		snprintf(text, sizeof text, ONE "property %s time\n" END AT "7\n", types[i]);
		ts_scene *scene = open_text(text, NULL);
		assert_int_equal(scene->n_surfels, 1);
		assert_true(notes(scene, "the property \"time\" of points is ignored"));
		ts_scene_free(scene);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(colours_are_what_their_writers_meant),
		cmocka_unit_test(bad_points_are_left_out_and_counted),
		cmocka_unit_test(normals_of_0_are_none),
		cmocka_unit_test(copies_of_points_do_not_shrink_each_other),
		cmocka_unit_test(sheets_are_seen_from_both_sides),
		cmocka_unit_test(coordinates_far_away_are_counted_from_a_middle),
		cmocka_unit_test(types_that_are_not_read_are_passed_over),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Reading PLY: files made here in all three formats, what they must say, and every way to lie about them. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "../../../src/model/core.h"
#include "../../../src/kernels/base/vec.h"
#include "../../../src/scene/sources.h"

static ts_build *load_bytes(const void *bytes, size_t n)
{
	char path[] = "/tmp/touchstone-ply-XXXXXX";
	int file = mkstemp(path);
	assert_true(file >= 0);
	assert_int_equal(write(file, bytes, n), n);
	close(file);
	ts_build *build = ts_build_new("test");
	ts_ply_load(build, path, 2);
	unlink(path);
	return build;
}

static ts_build *load(const char *text) { return load_bytes(text, strlen(text)); }

static const ts_scene *good(ts_build *build)
{
	if (ts_build_failed(build)) fail_msg("%s", ts_error_message());
	return ts_build_peek(build);
}

static void assert_refused(ts_build *build, const char *words)
{
	assert_true(ts_build_failed(build));
	if (strstr(ts_error_message(), words) == NULL) fail_msg("\"%s\" does not say \"%s\"", ts_error_message(), words);
	assert_null(strchr(ts_error_message(), '\n'));
	ts_build_free(build);
}

static void refuse(const char *text, const char *words) { assert_refused(load(text), words); }

static void assert_v3(const f32 *v, f32 x, f32 y, f32 z)
{
	if (ts_length(ts_sub(ts_load3(v), ts_v3_make(x, y, z))) > 1e-6f)
		fail_msg("%.9g %.9g %.9g is not %.9g %.9g %.9g", (double)v[0], (double)v[1], (double)v[2], (double)x, (double)y,
		         (double)z);
}

#define XYZ "property float x\nproperty float y\nproperty float z\n"
#define NORMAL "property float nx\nproperty float ny\nproperty float nz\n"
#define RADIUS "property float radius\n"
#define POINTS(count) "ply\nformat ascii 1.0\ncomment made here\nelement vertex " count "\n"
#define END "end_header\n"

static void a_radius_makes_a_circle(void **state)
{
	(void)state;
	ts_build *build = load(POINTS("2") XYZ NORMAL RADIUS END "1 2 3 0 0 2 0.5\n4 5e0 -6 0 -1 0 2");
	const ts_scene *scene = good(build);
	assert_int_equal(scene->n_surfels, 2);
	assert_v3(scene->surfels[0].centre, 1.0f, 2.0f, 3.0f);
	assert_v3(scene->surfels[1].centre, 4.0f, 5.0f, -6.0f);
	assert_v3(scene->surfels[1].colour, 1.0f, 1.0f, 1.0f);
	f32 n[3];
	ts_store3(n, ts_cross(ts_load3(scene->surfels[1].u), ts_load3(scene->surfels[1].v)));
	assert_v3(n, 0.0f, -4.0f, 0.0f);
	ts_build_free(build);
}

static void half_axes_need_no_normal(void **state)
{
	(void)state;
	ts_build *build = load("ply\r\nformat ascii 1.0\r\nelement vertex 1\r\n" XYZ
	                       "property double u_x\nproperty double u_y\nproperty double u_z\n"
	                       "property int v_x\nproperty int v_y\nproperty int v_z\nproperty float quality\n"
	                       "element face 7\nproperty list uchar int vertex_indices\n" END "0 0 0\n0 0.5 0 3 0 0 nan");
	const ts_scene *scene = good(build);
	assert_int_equal(scene->n_surfels, 1);
	assert_v3(scene->surfels[0].u, 0.0f, 0.5f, 0.0f);
	assert_v3(scene->surfels[0].v, 3.0f, 0.0f, 0.0f);
	assert_int_equal(scene->n_notes, 2);
	ts_build_free(build);
}

static void colours_of_bytes_are_srgb_and_of_floats_linear(void **state)
{
	(void)state;
	ts_build *build =
		load(POINTS("1") XYZ NORMAL RADIUS "property uchar red\nproperty uint8 green\nproperty float blue\n" END
	                                       "0 0 0 0 1 0 1 255 188 0.25");
	const f32 *colour = good(build)->surfels[0].colour;
	assert_true(colour[0] == 1.0f && colour[2] == 0.25f);
	assert_true(ts_abs(colour[1] - 0.50289f) < 1e-4f);
	ts_build_free(build);
}

static void points_without_a_radius_ask_their_neighbours(void **state)
{
	(void)state;
	ts_build *build = load(POINTS("3") XYZ NORMAL END "0 0 0 0 1 0 1 0 0 0 1 0 3 0 0 0 1 0");
	const ts_scene *scene = good(build);
	static const f32 radius[3] = {2.0f, 1.5f, 2.5f};
	assert_int_equal(scene->n_surfels, 3);
	for (u32 i = 0; i < 3; i++) assert_true(ts_abs(ts_length(ts_load3(scene->surfels[i].u)) - radius[i]) < 1e-6f);
	ts_build_free(build);
	build = load(POINTS("3") XYZ NORMAL END "0 0 0 0 1 0 0 0 0 0 1 0 0 0 0 0 1 0");
	assert_int_equal(good(build)->n_surfels, 0);
	assert_non_null(strstr(ts_build_peek(build)->notes[0], "3 points are not drawn"));
	ts_build_free(build);
}

/* A point of every type: x char, y uchar, z short, nx ushort, ny int, nz uint, radius double, red float, green,
 * blue. */
#define TYPED(format) \
	"ply\nformat " format " 1.0\nelement vertex 2\nproperty char x\nproperty uchar y\nproperty short z\n" \
	"property ushort nx\nproperty int ny\nproperty uint nz\nproperty double radius\nproperty float red\n" \
	"property float green\nproperty float blue\n" END
enum { TYPED_BYTES = 34, N_TYPED = 2 };

static size_t put(unsigned char *to, u64 word, size_t n, bool big)
{
	for (size_t k = 0; k < n; k++) to[big ? n - 1 - k : k] = (unsigned char)(word >> 8 * k);
	return n;
}

static size_t typed_file(unsigned char *to, bool big)
{
	const char *header = big ? TYPED("binary_big_endian") : TYPED("binary_little_endian");
	size_t n = strlen(header);
	memcpy(to, header, n);
	for (u32 i = 0; i < N_TYPED; i++) {
		double radius = 1.25 + i;
		u64 word;
		memcpy(&word, &radius, sizeof word);
		n += put(to + n, (u64)-100, 1, big);
		n += put(to + n, 200, 1, big);
		n += put(to + n, (u64)-3000, 2, big);
		n += put(to + n, 40000, 2, big);
		n += put(to + n, (u64)-30000, 4, big);
		n += put(to + n, 4000000000u, 4, big);
		n += put(to + n, word, 8, big);
		n += put(to + n, ts_f2u(0.5f), 4, big);
		n += put(to + n, ts_f2u(0.25f), 4, big);
		n += put(to + n, ts_f2u(1e-3f), 4, big);
	}
	return n;
}

static void all_formats_say_the_same(void **state)
{
	(void)state;
	static unsigned char bytes[1024];
	ts_build *text = load(TYPED("ascii") "-100 200 -3000 40000 -30000 4000000000 1.25 0.5 0.25 1e-3\n"
	                                     "-100 200 -3000 40000 -30000 4000000000 2.25 0.5 0.25 0.001 ");
	const ts_scene *expected = good(text);
	assert_int_equal(expected->n_surfels, N_TYPED);
	assert_v3(expected->surfels[0].centre, -100.0f, 200.0f, -3000.0f);
	for (u32 big = 0; big < 2; big++) {
		ts_build *build = load_bytes(bytes, typed_file(bytes, big));
		assert_int_equal(good(build)->n_surfels, N_TYPED);
		assert_memory_equal(ts_build_peek(build)->surfels, expected->surfels, N_TYPED * sizeof(ts_surfel));
		ts_build_free(build);
	}
	ts_build_free(text);
}

static void every_shorter_file_is_refused(void **state)
{
	(void)state;
	static unsigned char bytes[1024];
	size_t n = typed_file(bytes, false);
	for (size_t cut = 0; cut < n; cut++) assert_refused(load_bytes(bytes, cut), "touchstone-ply");
}

/* Whatever one byte says, the outcome is a scene or a line. */
static void damaged_files_do_no_harm(void **state)
{
	(void)state;
	static unsigned char good_bytes[1024], bytes[1024];
	u32 n_refused = 0;
	for (u32 round = 0; round < 3000; round++) {
		size_t n = typed_file(good_bytes, round & 1);
		memcpy(bytes, good_bytes, n);
		for (u32 k = 0; k <= round % 3; k++) bytes[ts_random(round, k, 1) % n] = (unsigned char)ts_random(round, k, 2);
		ts_build *build = load_bytes(bytes, n);
		if (ts_build_failed(build)) {
			n_refused++;
			assert_null(strchr(ts_error_message(), '\n'));
		} else {
			assert_true(ts_build_peek(build)->n_surfels <= N_TYPED);
		}
		ts_build_free(build);
	}
	assert_in_range(n_refused, 1000, 2999);
}

static void headers_are_held_to_their_words(void **state)
{
	(void)state;
	refuse("", "begins with a line \"ply\"");
	refuse("plx\n", "begins with a line \"ply\"");
	refuse("ply\nformat binary 1.0\n", "line 2: write format ascii");
	refuse("ply\nformat ascii 2.0\n", "line 2: write format ascii");
	refuse("ply\nformat ascii 1.0\nelement vertex 1\n" XYZ, "no end_header");
	refuse("ply\nformat ascii 1.0\nproperty float x\n", "line 3: a property before the first element");
	refuse("ply\nformat ascii 1.0\nelement face 1\n", "line 3: the first element must be vertex");
	refuse("ply\nformat ascii 1.0\nelement vertex -1\n", "write element NAME COUNT");
	refuse("ply\nformat ascii 1.0\nelement vertex 99999999999999999999\n", "write element NAME COUNT");
	refuse(POINTS("1") "property real x\n", "line 5: no such type");
	refuse(POINTS("1") "property float\n", "line 5: write property TYPE NAME");
	refuse(POINTS("1") XYZ "property float x\n", "line 8: a second property of this name");
	refuse(POINTS("1") "property list uchar float x\n", "line 5: a list is no property of a point");
	refuse(POINTS("1") "vertices\n", "line 5: begins with none of");
	refuse(POINTS("0") XYZ NORMAL END, "no points");
	refuse(POINTS("1") END "1", "no points");
	refuse("ply\nformat ascii 1.0\n" END, "no points");
}

static void counts_are_held_to_the_bytes(void **state)
{
	(void)state;
	refuse(POINTS("4000000000") XYZ NORMAL END "1 2 3 0 0 1\n", "do not fit in the 12 bytes");
	refuse(POINTS("999999999999999999") XYZ NORMAL END "1 2 3 0 0 1\n", "do not fit");
	refuse("ply\nformat binary_little_endian 1.0\nelement vertex 2\n" XYZ NORMAL END
	       "123456789012345678901234567890123456789012345",
	       "2 points of at least 24 bytes do not fit in the 45 bytes");
	refuse(POINTS("2") XYZ NORMAL END "1.0000000 2.00000000 3 0 0 1\n", "point 1: x is no number");
}

static void properties_come_in_whole_groups(void **state)
{
	(void)state;
	refuse(POINTS("1") "property float x\nproperty float y\n" NORMAL END "0 0 0 0 1 ",
	       "of the properties with \"x\" 2 are there; it takes 3");
	refuse(POINTS("1") XYZ "property float nx\n" END "0 0 0 1 ", "\"nx\" 1 are there; it takes 3");
	refuse(POINTS("1") NORMAL END "0 0 1 ", "need the properties x, y and z");
	refuse(POINTS("1") XYZ END "0 0 1 ", "points need normals");
	refuse(POINTS("1") XYZ NORMAL "property float u_x\n" END "0 0 0 0 0 1 1 ", "it takes 6");
	refuse(POINTS("1") XYZ NORMAL "property int red\nproperty int green\nproperty int blue\n" END "0 0 0 0 0 1 1 1 1 ",
	       "the property red must be uchar or float");
}

static void numbers_are_held_to_their_meaning(void **state)
{
	(void)state;
	refuse(POINTS("1") XYZ NORMAL RADIUS END "0 0 nan 0 0 1 1 ", "point 0: z is not finite");
	refuse(POINTS("1") XYZ NORMAL RADIUS END "0 0 inf 0 0 1 1 ", "point 0: z is not finite");
	refuse(POINTS("1") XYZ NORMAL RADIUS END "0 0 1e999 0 0 1 1 ", "point 0: z is not finite");
	refuse(POINTS("1") XYZ NORMAL RADIUS END "0 0 x 0 0 1 1 ", "point 0: z is no number");
	refuse(POINTS("1") XYZ NORMAL RADIUS END "0 0 1x 0 0 1 1 ", "point 0: z is no number");
	refuse(POINTS("1") XYZ NORMAL RADIUS END "0 0 0 0 0 0 1 ", "point 0: the normal has no length");
	refuse(POINTS("1") XYZ NORMAL RADIUS END "0 0 0 0 0 1 0 ", "point 0: the radius");
	refuse(POINTS("1") XYZ NORMAL RADIUS END "0 0 0 0 0 1 -1 ", "point 0: the radius");
	refuse(POINTS("1") XYZ NORMAL RADIUS "property uchar red\nproperty uchar green\nproperty uchar blue\n" END
	                                     "0 0 0 0 0 1 1 0 256 0 ",
	       "point 0: green is 256; a whole number from 0 to 255 would be right");
	refuse(POINTS("1") XYZ NORMAL RADIUS "property uchar red\nproperty uchar green\nproperty uchar blue\n" END
	                                     "0 0 0 0 0 1 1 0 12.7 0 ",
	       "point 0: green is 12.7; a whole number from 0 to 255 would be right");
	refuse(POINTS("1") XYZ NORMAL RADIUS END "0 0 0 0 0 1e39 1 ", "point 0: nz is 1e+39; a number from -3.40282e+38");
	refuse(POINTS("1") "property short x\nproperty short y\nproperty short z\n" NORMAL RADIUS END "0 -32769 0 0 0 1 1 ",
	       "point 0: y is -32769; a whole number from -32768 to 32767 would be right");
	refuse(POINTS("1") XYZ NORMAL RADIUS "property float red\nproperty float green\nproperty float blue\n" END
	                                     "0 0 0 0 0 1 1 0 0 -0.5 ",
	       "point 0: blue is -0.5; it must not be below 0");
}

static void locale_of_the_host_does_not_matter(void **state)
{
	(void)state;
	if (!setlocale(LC_ALL, "de_DE.UTF-8") && !setlocale(LC_ALL, "fr_FR.UTF-8")) skip();
	ts_build *build = load(POINTS("1") XYZ NORMAL RADIUS END "0.5 0 0 0 0 1 0.25");
	bool comma = strtod("0,5", NULL) > 0;
	setlocale(LC_ALL, "C");
	assert_v3(good(build)->surfels[0].centre, 0.5f, 0, 0);
	assert_true(comma);
	ts_build_free(build);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(locale_of_the_host_does_not_matter),
		cmocka_unit_test(a_radius_makes_a_circle),
		cmocka_unit_test(half_axes_need_no_normal),
		cmocka_unit_test(colours_of_bytes_are_srgb_and_of_floats_linear),
		cmocka_unit_test(points_without_a_radius_ask_their_neighbours),
		cmocka_unit_test(all_formats_say_the_same),
		cmocka_unit_test(every_shorter_file_is_refused),
		cmocka_unit_test(damaged_files_do_no_harm),
		cmocka_unit_test(headers_are_held_to_their_words),
		cmocka_unit_test(counts_are_held_to_the_bytes),
		cmocka_unit_test(properties_come_in_whole_groups),
		cmocka_unit_test(numbers_are_held_to_their_meaning),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

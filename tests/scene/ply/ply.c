/* Reading PLY: files made here in all three formats, what they must say, and every way to lie about them. */
#include <math.h>
#include <unistd.h>
#include "kernels/base/vec.h"
#include "model/core.h"
#include "scene/sources.h"
#include "tests/comma.h"
#include "tests/srgb.h"
#include "tests/status.h"

static ts_build *load_bytes(const void *bytes, size_t n)
{
	char path[] = "/tmp/touchstone-ply-XXXXXX";
	int file = mkstemp(path);
	assert_true(file >= 0);
	assert_int_equal(write(file, bytes, n), n);
	close(file);
	ts_build *build = ts_build_new("test");
	ts_ply_load(build, &(ts_scene_file){.name = path}, 2);
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
	says(words);
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

#define SIDE 12
/* A hill of SIDE x SIDE points, z up as many files have it; `what` is printed behind each. */
static ts_build *load_hill(const char *properties, const char *what)
{
	static char text[32768];
	char *at = text + sprintf(text, POINTS("144") XYZ "%s" END, properties);
	for (u32 i = 0; i < SIDE * SIDE; i++) {
		u32 x = i % SIDE, y = i / SIDE;
		at += sprintf(at, "%u %u %g%s\n", x, y, -0.01 * (x * x + y * y), what);
	}
	return load_bytes(text, (size_t)(at - text));
}

static void points_without_normals_ask_their_neighbours(void **state)
{
	(void)state;
	ts_build *with = load_hill(NORMAL, " 0 0 1"), *without = load_hill("", ""), *wide = load_hill(RADIUS, " 3");
	const ts_scene *a = good(with), *b = good(without), *c = good(wide);
	assert_true(a->n_surfels == SIDE * SIDE && b->n_surfels == 2 * SIDE * SIDE && c->n_surfels == 2 * SIDE * SIDE);
	u32 n_up = 0;
	for (u32 i = 0; i < SIDE * SIDE; i++) {
		f32 x = (f32)(i % SIDE), y = (f32)(i / SIDE);
		const ts_surfel *front = &b->surfels[2 * i], *back = front + 1;
		ts_v3 u = ts_load3(front->u), n = ts_normalize(ts_cross(u, ts_load3(front->v)));
		assert_memory_equal(front->u, back->v, sizeof back->v);
		assert_memory_equal(front->v, back->u, sizeof back->u);
		n_up += n.z > 0.0f;
		assert_true(ts_abs(ts_dot(n, ts_normalize(ts_v3_make(0.02f * x, 0.02f * y, 1.0f)))) > 0.99f);
		assert_true(ts_abs(ts_length(u) - ts_length(ts_load3(a->surfels[i].u))) < 1e-5f);
		assert_true(ts_abs(ts_length(ts_load3(c->surfels[2 * i].u)) - 3.0f) < 1e-5f);
	}
	assert_true(n_up == 0 || n_up == SIDE * SIDE);
	assert_string_equal(b->notes[0], "points have no normals: they are estimated by the points around each");
	assert_int_equal(a->n_notes, 0);
	ts_build_free(with);
	ts_build_free(without);
	ts_build_free(wide);
}

static void points_on_a_line_are_noted(void **state)
{
	(void)state;
	ts_build *build = load(POINTS("3") XYZ END "0 0 0 1 2 3 2 4 6");
	assert_int_equal(good(build)->n_surfels, 0);
	assert_string_equal(ts_build_peek(build)->notes[1],
	                    "3 points are not drawn: they are on a line with their neighbours");
	ts_build_free(build);
	build = load(POINTS("3") XYZ RADIUS END "0 0 0 1 1 0 0 1 2 0 0 1");
	assert_int_equal(good(build)->n_surfels, 0);
	ts_build_free(build);
	build = load(POINTS("1") XYZ END "0 0 0");
	assert_non_null(strstr(good(build)->notes[1], "1 points are not drawn: their neighbours are all in the same"));
	ts_build_free(build);
}

/* A point of every type: x char, y uchar, z short, nx ushort, ny int, nz uint, radius double, red float, green,
 * blue. */
#define TYPED(format) "ply\nformat " format " 1.0\n" TYPED_POINTS
#define TYPED_POINTS \
	"element vertex 2\nproperty char x\nproperty uchar y\nproperty short z\n" \
	"property ushort nx\nproperty int ny\nproperty uint nz\nproperty double radius\nproperty float red\n" \
	"property float green\nproperty float blue\n" END
enum { TYPED_BYTES = 34, N_TYPED = 2 };

static size_t put(unsigned char *to, u64 word, size_t n, bool big)
{
	for (size_t k = 0; k < n; k++) to[big ? n - 1 - k : k] = (unsigned char)(k < 8 ? word >> 8 * k : 0);
	return n;
}

static size_t put_points(unsigned char *to, bool big)
{
	size_t n = 0;
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

static size_t typed_file(unsigned char *to, bool big)
{
	const char *header = big ? TYPED("binary_big_endian") : TYPED("binary_little_endian");
	memcpy(to, header, strlen(header));
	return strlen(header) + put_points(to + strlen(header), big);
}

/* The same points behind three elements: one of fixed size, one with lists, and one of nothing. */
#define BEHIND(format) \
	"ply\ncomment\nformat " format " 1.0\nelement camera 2\nproperty short angle\nproperty double x\n" \
	"element face 3\nproperty list uchar int vertex_indices\nproperty list ushort short more\n" \
	"element void 999999999999999999\n" TYPED_POINTS

static size_t put_lists(unsigned char *to, bool big)
{
	size_t n = put(to, 0, 2 * (2 + 8), big);
	for (u32 i = 0; i < 3; i++) {
		n += put(to + n, 3 * i, 1, big);
		n += put(to + n, 0, 4 * 3 * i, big);
		n += put(to + n, 2 - i, 2, big);
		n += put(to + n, 0, 2 * (2 - i), big);
	}
	return n;
}

static size_t behind_file(unsigned char *to, bool big)
{
	const char *header = big ? BEHIND("binary_big_endian") : BEHIND("binary_little_endian");
	size_t n = strlen(header);
	memcpy(to, header, n);
	n += put_lists(to + n, big);
	return n + put_points(to + n, big);
}

#define TYPED_TEXT \
	"-100 200 -3000 40000 -30000 4000000000 1.25 0.5 0.25 1e-3\n" \
	"-100 200 -3000 40000 -30000 4000000000 2.25 0.5 0.25 0.001 "

/* Releases both. */
static void assert_same(ts_build *build, ts_build *expected)
{
	const ts_scene *a = good(build), *b = good(expected);
	assert_int_equal(a->n_surfels, b->n_surfels);
	assert_memory_equal(a->surfels, b->surfels, b->n_surfels * sizeof *b->surfels);
	ts_build_free(build);
	ts_build_free(expected);
}

static void all_formats_say_the_same(void **state)
{
	(void)state;
	static unsigned char bytes[1024];
	alarm(60);
	ts_build *text = load(TYPED("ascii") TYPED_TEXT);
	assert_int_equal(good(text)->n_surfels, N_TYPED);
	assert_v3(good(text)->surfels[0].centre, -100.0f, 200.0f, -3000.0f);
	ts_build_free(text);
	for (u32 big = 0; big < 2; big++) {
		assert_same(load_bytes(bytes, typed_file(bytes, big)), load(TYPED("ascii") TYPED_TEXT));
		assert_same(load_bytes(bytes, behind_file(bytes, big)), load(TYPED("ascii") TYPED_TEXT));
	}
	alarm(0);
}

static void elements_before_the_points_are_passed_over(void **state)
{
	(void)state;
	assert_same(load(BEHIND("ascii") "1 0.5 -2 nan\n0 2 1 2\n3 1 2 3 1 9\n6 1 2 3 4 5 6 0\n" TYPED_TEXT),
	            load(TYPED("ascii") TYPED_TEXT));
	static unsigned char bytes[1024];
	ts_build *build = load_bytes(bytes, behind_file(bytes, false));
	assert_string_equal(good(build)->notes[0], "elements before the points are ignored");
	ts_build_free(build);
	refuse(BEHIND("ascii") "1 0.5 -2 1\n0 2 1 2\n-1 1 2 3\n" TYPED_TEXT, "face 1: vertex_indices has no length");
	refuse(BEHIND("ascii") "1 0.5 -2 1\n0 2 1 2\n1.5 1 2 3\n" TYPED_TEXT, "face 1: vertex_indices has no length");
	refuse(BEHIND("ascii") "1 0.5 -2 1\n0 2 1 2\n256 1 2 3\n" TYPED_TEXT, "face 1: vertex_indices has no length");
	refuse(BEHIND("ascii") "1 0.5 -2 1\n0 2 1 2\n255 1 2 3\n" TYPED_TEXT,
	       "face 1: vertex_indices is missing: the file");
	refuse(BEHIND("ascii") "1 0.5 -2 1\n0 2 1 x\n" TYPED_TEXT, "face 0: more is no number");
}

#define FACES(format, count, type) \
	"ply\nformat " format " 1.0\nelement face " count "\nproperty list " type " double list\n" \
	"element vertex 1\n" XYZ NORMAL RADIUS END

static void lists_are_held_to_the_bytes(void **state)
{
	(void)state;
	static const char most[] =
		FACES("binary_little_endian", "1", "uint") "\xff\xff\xff\xff 28 bytes of a point and more ";
	assert_refused(load_bytes(most, sizeof most - 1), "face 0: list is missing: the file ends before it");
	static const char below[] =
		FACES("binary_little_endian", "1", "int") "\xff\xff\xff\xff 28 bytes of a point and more ";
	assert_refused(load_bytes(below, sizeof below - 1), "face 0: list has no length");
	refuse(FACES("binary_little_endian", "999999999999999999", "uint") "1234567890123456789012345678901234567890",
	       "element face: 999999999999999999 of at least 4 bytes each do not fit in a file of");
	refuse(FACES("binary_little_endian", "11", "uchar") "12345678901234567890123456789012345678",
	       "element vertex: 1 of at least 28 bytes each do not fit in a file of");
}

static void lists_of_points_are_passed_over(void **state)
{
	(void)state;
	assert_same(load(POINTS("2") "property list uchar int seen\n" XYZ NORMAL RADIUS "property list int float at\n" END
	                             "2 8 9 1 2 3 0 0 2 0.5 0\n0 4 5 -6 0 -1 0 2 1 -1e9"),
	            load(POINTS("2") XYZ NORMAL RADIUS END "1 2 3 0 0 2 0.5\n4 5 -6 0 -1 0 2"));
}

/* Text with other ends of lines: LINE for each \n. */
static ts_build *load_lines(const char *start, const char *text, const char *end)
{
	char bytes[4096];
	size_t n = strlen(start);
	memcpy(bytes, start, n);
	for (; *text != '\0'; text++) {
		const char *put = *text == '\n' ? end : (char[]){*text, '\0'};
		memcpy(bytes + n, put, strlen(put));
		n += strlen(put);
	}
	return load_bytes(bytes, n);
}

/* The first byte of the points is \n: behind lines that end in \r it is theirs. */
static void headers_may_be_written_otherwise(void **state)
{
	(void)state;
	static const char plain[] = POINTS("1") XYZ NORMAL RADIUS END "1 2 3 0 0 2 0.5";
	static const char busy[] =
		"ply\nobj_info num_cols 512\ncomment \xc3\xa9\n\nformat\tascii  1.0 \nelement vertex 1\n" XYZ
		"comment of six words or even more\n" NORMAL RADIUS END "1 2 3 0 0 2 0.5";
	static const char *const ends[] = {"\n", "\r\n", "\r"};
	for (u32 i = 0; i < 3; i++) {
		assert_same(load_lines("", plain, ends[i]), load(plain));
		assert_same(load_lines("\xef\xbb\xbf", busy, ends[i]), load(plain));
	}
	static const char words[] =
		"ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty uchar x\n"
		"property uchar y\nproperty uchar z\nproperty uchar nx\nproperty uchar ny\nproperty uchar nz\n"
		"property uchar radius\n" END;
	for (u32 i = 0; i < 3; i++) {
		char bytes[1024];
		size_t n = 0;
		for (const char *c = words; *c != '\0'; c++)
			n += (size_t)sprintf(bytes + n, "%s", *c == '\n' ? ends[i] : (char[]){*c, '\0'});
		memcpy(bytes + n, "\n\2\3\0\0\1\4", 7);
		assert_same(load_bytes(bytes, n + 7), load(POINTS("1") XYZ NORMAL RADIUS END "10 2 3 0 0 1 4"));
	}
}

static void colours_of_two_bytes_are_those_of_one_in_257_steps(void **state)
{
	(void)state;
	static char one[16384], two[16384];
	strcpy(one, POINTS("256") XYZ NORMAL RADIUS "property uchar red\nproperty uchar green\nproperty uchar blue\n" END);
	strcpy(two,
	       POINTS("256") XYZ NORMAL RADIUS "property ushort red\nproperty ushort green\nproperty uint16 blue\n" END);
	for (u32 i = 0; i < 256; i++) {
		sprintf(one + strlen(one), "0 0 0 0 1 0 1 %u %u 7\n", i, 255 - i);
		sprintf(two + strlen(two), "0 0 0 0 1 0 1 %u %u 1799\n", 257 * i, 65535 - 257 * i);
	}
	assert_same(load(two), load(one));
}

/* IEC 61966-2-1, in double precision. */
static void colours_of_two_bytes_are_srgb(void **state)
{
	(void)state;
	for (u32 i = 0; i < 300; i++) {
		char text[1024];
		u32 code = ts_random(i, 1, 6) & 65535;
		double expected = (double)srgb_decoded(code / 65535.0L);
		sprintf(text,
		        POINTS("1") XYZ NORMAL RADIUS "property ushort red\nproperty ushort green\nproperty ushort blue\n" END
		                                      "0 0 0 0 1 0 1 %u 0 65535",
		        code);
		ts_build *build = load(text);
		const f32 *colour = good(build)->surfels[0].colour;
		assert_true(fabs((double)colour[0] - expected) < 2e-5 && colour[1] == 0.0f && colour[2] == 1.0f);
		ts_build_free(build);
	}
}

typedef size_t make_file(unsigned char *to, bool big);
static make_file *const files[] = {typed_file, behind_file};

static void every_shorter_file_is_refused(void **state)
{
	(void)state;
	static unsigned char bytes[1024];
	for (u32 f = 0; f < 2; f++) {
		size_t n = files[f](bytes, false);
		for (size_t cut = 0; cut < n; cut++) assert_refused(load_bytes(bytes, cut), "touchstone-ply");
	}
}

/* Whatever one byte says, the outcome is a scene or a line. */
static void damaged_files_do_no_harm(void **state)
{
	(void)state;
	static unsigned char good_bytes[1024], bytes[1024];
	u32 n_refused = 0;
	for (u32 round = 0; round < 6000; round++) {
		size_t n = files[round / 3000](good_bytes, round & 1);
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
	assert_in_range(n_refused, 2000, 5999);
}

/* A header of this many lines, elements before the points, and properties of a point. */
static ts_build *load_large(u32 n_lines, u32 n_elements, u32 n_properties)
{
	static char text[2000000];
	char *at = text + sprintf(text, "ply\nformat ascii 1.0\n");
	for (u32 i = 0; i < n_elements; i++) at += sprintf(at, "element e%u 0\n", i);
	at += sprintf(at, "element vertex 1\n" XYZ NORMAL RADIUS);
	for (u32 i = 7; i < n_properties; i++) at += sprintf(at, "property float p%u\n", i);
	for (u32 i = 11 + n_elements + n_properties - 7; i < n_lines; i++) at += sprintf(at, "comment\n");
	at += sprintf(at, END "0 0 0 0 0 1 1");
	for (u32 i = 7; i < n_properties; i++) at += sprintf(at, " 5");
	return load_bytes(text, (size_t)(at - text));
}

static void bounds_of_headers_are_wide_and_held(void **state)
{
	(void)state;
	static const u32 good_sizes[][3] = {{0, 0, 65}, {1001, 0, 7}, {100000, 0, 7}, {0, 63, 7}, {0, 0, 1024}};
	for (u32 i = 0; i < 5; i++)
		assert_same(load_large(good_sizes[i][0], good_sizes[i][1], good_sizes[i][2]), load_large(0, 0, 7));
	assert_refused(load_large(100001, 0, 7), "line 100000: more than 100000 lines without end_header");
	assert_refused(load_large(0, 64, 7), "line 67: more than 63 elements before vertex");
	assert_refused(load_large(0, 0, 1025), "line 1028: more than 1024 properties up to those of vertex");
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
	refuse("ply\nelement vertex 1\nformat ascii 1.0\n", "line 2: write format ascii");
	refuse("ply\ncomment\nobj_info\n\n", "line 5: the header has no end_header");
	refuse("ply\nformat ascii 1.0\nelement vertex -1\n", "write element NAME COUNT");
	refuse("ply\nformat ascii 1.0\nelement vertex 99999999999999999999\n", "write element NAME COUNT");
	refuse(POINTS("1") "property real x\n", "line 5: no such type");
	refuse(POINTS("1") "property float\n", "line 5: write property TYPE NAME");
	refuse(POINTS("1") XYZ "property float x\n", "line 8: a second property of this name");
	refuse(POINTS("1") "property list uchar float\n", "line 5: write property TYPE NAME or property list TYPE TYPE");
	refuse(POINTS("1") "property list uchar real x\n", "line 5: no such type");
	refuse(POINTS("1") "property list float int x\n", "line 5: the first type of a list, that of its length, must be");
	refuse(POINTS("1") "vertices\n", "line 5: begins with none of");
	refuse(POINTS("0") XYZ NORMAL END, "no points");
	refuse(POINTS("1") END "1", "no points");
	refuse("ply\nformat ascii 1.0\n" END, "no points");
	refuse("ply\nformat ascii 1.0\nelement face 1\n" XYZ NORMAL END "1 2 3 4 5 6 ", "no points");
}

static void counts_are_held_to_the_bytes(void **state)
{
	(void)state;
	refuse(POINTS("4000000000") XYZ NORMAL END "1 2 3 0 0 1\n",
	       "element vertex: 4000000000 of at least 12 bytes each do not fit in a file of 193 bytes");
	refuse(POINTS("999999999999999999") XYZ NORMAL END "1 2 3 0 0 1\n", "do not fit");
	refuse("ply\nformat binary_little_endian 1.0\nelement vertex 2\n" XYZ NORMAL END
	       "123456789012345678901234567890123456789012345",
	       "element vertex: 2 of at least 24 bytes each do not fit in a file of 214 bytes");
	refuse(POINTS("2") XYZ NORMAL END "1.0000000 2.00000000 3 0 0 1\n",
	       "point 1: x is missing: the file ends before it");
}

static void properties_come_in_whole_groups(void **state)
{
	(void)state;
	refuse(POINTS("1") "property float x\nproperty float y\n" NORMAL END "0 0 0 0 1 ",
	       "of the properties with \"x\" 2 are there; it takes 3");
	refuse(POINTS("1") XYZ "property float nx\n" END "0 0 0 1 ", "\"nx\" 1 are there; it takes 3");
	refuse(POINTS("1") NORMAL END "0 0 1 ", "need the properties x, y and z");
	refuse(POINTS("1") NORMAL "property float x\nproperty float y\nproperty list uchar float z\n" END "0 0 1 1 1 1 1 ",
	       "the property z must not be a list");
	refuse(POINTS("1") XYZ NORMAL "property float u_x\n" END "0 0 0 0 0 1 1 ", "it takes 6");
}

static void numbers_are_held_to_their_meaning(void **state)
{
	(void)state;
	refuse(POINTS("1") XYZ NORMAL RADIUS END "0 0 nan 0 0 1 1 ", "point 0: z is not finite");
	refuse(POINTS("1") XYZ NORMAL RADIUS END "0 0 inf 0 0 1 1 ", "point 0: z is not finite");
	refuse(POINTS("1") XYZ NORMAL RADIUS END "0 0 1e999 0 0 1 1 ", "point 0: z is not finite");
	refuse(POINTS("1") XYZ NORMAL RADIUS END "0 0 x 0 0 1 1 ", "point 0: z is no number");
	refuse(POINTS("1") XYZ NORMAL RADIUS END "0 0 1x 0 0 1 1 ", "point 0: z is no number");
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
}

static void locale_of_the_host_does_not_matter(void **state)
{
	(void)state;
	comma_begin();
	ts_build *build = load(POINTS("1") XYZ NORMAL RADIUS END "0.5 0 0 0 0 1 0.25");
	comma_end();
	assert_v3(good(build)->surfels[0].centre, 0.5f, 0, 0);
	ts_build_free(build);
}

/* However long the file is. */
static void what_does_not_begin_as_ply_is_not_read(void **state)
{
	(void)state;
	char path[] = "/tmp/touchstone-ply-XXXXXX";
	int file = mkstemp(path);
	assert_int_equal(ftruncate(file, (off_t)(ts_memory_total() / 2)), 0);
	close(file);
	ts_build *build = ts_build_new("test");
	ts_ply_load(build, &(ts_scene_file){.name = path}, 2);
	unlink(path);
	assert_refused(build, "line 1: a PLY file begins with a line \"ply\"");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(what_does_not_begin_as_ply_is_not_read),
		cmocka_unit_test(locale_of_the_host_does_not_matter),
		cmocka_unit_test(a_radius_makes_a_circle),
		cmocka_unit_test(half_axes_need_no_normal),
		cmocka_unit_test(colours_of_bytes_are_srgb_and_of_floats_linear),
		cmocka_unit_test(points_without_a_radius_ask_their_neighbours),
		cmocka_unit_test(points_without_normals_ask_their_neighbours),
		cmocka_unit_test(points_on_a_line_are_noted),
		cmocka_unit_test(all_formats_say_the_same),
		cmocka_unit_test(elements_before_the_points_are_passed_over),
		cmocka_unit_test(lists_are_held_to_the_bytes),
		cmocka_unit_test(lists_of_points_are_passed_over),
		cmocka_unit_test(headers_may_be_written_otherwise),
		cmocka_unit_test(colours_of_two_bytes_are_those_of_one_in_257_steps),
		cmocka_unit_test(colours_of_two_bytes_are_srgb),
		cmocka_unit_test(bounds_of_headers_are_wide_and_held),
		cmocka_unit_test(every_shorter_file_is_refused),
		cmocka_unit_test(damaged_files_do_no_harm),
		cmocka_unit_test(headers_are_held_to_their_words),
		cmocka_unit_test(counts_are_held_to_the_bytes),
		cmocka_unit_test(properties_come_in_whole_groups),
		cmocka_unit_test(numbers_are_held_to_their_meaning),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

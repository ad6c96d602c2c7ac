/* Points of glTF: small files made here, of floats in a data URI, judged by closed forms. */
#include "kernels/base/vec.h"
#include "tests/scene/gltf/files.h"

/* Four points of a square of side 2, then of each: normal +z, half-axes 0.5 x and 0.25 y, colour, and the second axis
 * turned out of the plane; then the indices 3 1. */
enum {
	N = 4,
	POSITION = 0,
	NORMAL = 48,
	U = 96,
	V = 144,
	COLOUR = 192,
	SKEW = 240,
	ZERO = 288,
	INDICES = 336,
	BYTES = 342
};
static unsigned char buffer[BYTES];

static void put(size_t at, f32 x, f32 y, f32 z)
{
	f32 v[3] = {x, y, z};
	memcpy(buffer + at, v, sizeof v);
}

static int set_up(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		put(POSITION + 12 * i, i & 1 ? 2.0f : 0.0f, i & 2 ? 2.0f : 0.0f, 0.0f);
		put(NORMAL + 12 * i, 0.0f, 0.0f, 1.0f);
		put(U + 12 * i, 0.5f, 0.0f, 0.0f);
		put(V + 12 * i, 0.0f, 0.25f, 0.0f);
		put(COLOUR + 12 * i, 0.5f, 0.25f, (f32)i / 4.0f);
		put(SKEW + 12 * i, 0.1f, 0.25f, 0.0f);
		put(ZERO + 12 * i, 0.0f, 0.0f, 0.0f);
	}
	const uint16_t indices[2] = {3, 1};
	memcpy(buffer + INDICES, indices, sizeof indices);
	return 0;
}

/* accessors/0 to 6: positions, normals, u, v, colours, skewed v, zeros; /7: indices; /8: three positions only. */
static ts_build *load(const char *attributes, const char *more, const char *node)
{
	char text[8192], data[BYTES / 3 * 4 + 1], views[1024] = "";
	base64(data, buffer, sizeof buffer);
	for (u32 i = 0; i < 7; i++)
		snprintf(views + strlen(views), sizeof views - strlen(views),
		         "%s{\"bufferView\":0,\"byteOffset\":%u,\"componentType\":5126,\"type\":\"VEC3\",\"count\":4}",
		         i ? "," : "", 48 * i);
	snprintf(
		text, sizeof text,
		"{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":%d,\"uri\":"
		"\"data:application/octet-stream;base64,%s\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":%d}],"
		"\"accessors\":[%s,{\"bufferView\":0,\"byteOffset\":%d,\"componentType\":5123,\"type\":\"SCALAR\",\"count\":2},"
		"{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",\"count\":3}],"
		"\"materials\":[{\"pbrMetallicRoughness\":{\"baseColorFactor\":[0.5,1,1,1]}}],"
		"\"meshes\":[{\"primitives\":[{\"mode\":0,\"attributes\":{%s}%s}]}],"
		"\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0%s}]}",
		BYTES, data, BYTES, views, INDICES, attributes, more, node);
	return load_text(text, NULL, 2);
}

static const ts_scene *good(ts_build *build)
{
	if (ts_build_failed(build)) fail_msg("%s", ts_error_message());
	return ts_build_peek(build);
}

static void refuse(const char *attributes, const char *more, const char *words)
{
	assert_refused(load(attributes, more, ""), words);
}

static void assert_v3(const f32 *v, f32 x, f32 y, f32 z)
{
	if (ts_length(ts_sub(ts_load3(v), ts_v3_make(x, y, z))) > 1e-6f)
		fail_msg("%.9g %.9g %.9g is not %.9g %.9g %.9g", (double)v[0], (double)v[1], (double)v[2], (double)x, (double)y,
		         (double)z);
}

#define SPLATS "\"POSITION\":0,\"NORMAL\":1,\"_SPLAT_U\":2,\"_SPLAT_V\":3"

static void ellipses_are_read_as_they_are(void **state)
{
	(void)state;
	ts_build *build = load(SPLATS ",\"COLOR_0\":4", "", "");
	const ts_scene *scene = good(build);
	assert_int_equal(scene->n_surfels, N);
	assert_int_equal(scene->n_triangles, 0);
	assert_v3(scene->surfels[3].centre, 2.0f, 2.0f, 0.0f);
	assert_v3(scene->surfels[3].u, 0.5f, 0.0f, 0.0f);
	assert_v3(scene->surfels[3].v, 0.0f, 0.25f, 0.0f);
	assert_v3(scene->surfels[3].colour, 0.5f, 0.25f, 0.75f);
	assert_v3(scene->info.box_max, 2.0f, 2.0f, 0.0f);
	ts_build_free(build);
}

static void nodes_move_and_mirror_them(void **state)
{
	(void)state;
	ts_build *build = load(SPLATS, "", ",\"scale\":[-2,2,2],\"translation\":[1,0,7]");
	const ts_surfel *s = &good(build)->surfels[1];
	assert_v3(s->centre, -3.0f, 0.0f, 7.0f);
	assert_v3(s->u, 0.0f, 0.5f, 0.0f);
	assert_v3(s->v, -1.0f, 0.0f, 0.0f);
	assert_v3(s->colour, 1.0f, 1.0f, 1.0f);
	ts_build_free(build);
}

static void indices_and_materials_count(void **state)
{
	(void)state;
	ts_build *build = load(SPLATS ",\"COLOR_0\":4", ",\"indices\":7,\"material\":0", "");
	const ts_scene *scene = good(build);
	assert_int_equal(scene->n_surfels, 2);
	assert_v3(scene->surfels[0].centre, 2.0f, 2.0f, 0.0f);
	assert_v3(scene->surfels[1].colour, 0.25f, 0.25f, 0.25f);
	ts_build_free(build);
}

/* The two nearest of each corner of the square are 2 away. */
static void points_without_axes_are_as_wide_as_their_neighbours_are_far(void **state)
{
	(void)state;
	ts_build *build = load("\"POSITION\":0,\"NORMAL\":1", "", "");
	const ts_scene *scene = good(build);
	assert_int_equal(scene->n_surfels, N);
	for (u32 i = 0; i < N; i++) {
		ts_v3 u = ts_load3(scene->surfels[i].u), v = ts_load3(scene->surfels[i].v);
		f32 normal[3];
		ts_store3(normal, ts_cross(u, v));
		assert_v3(normal, 0.0f, 0.0f, 4.0f);
		assert_true(ts_abs(ts_length(u) - 2.0f) < 1e-6f && ts_abs(ts_length(v) - 2.0f) < 1e-6f);
	}
	ts_build_free(build);
}

static void without_normals_they_are_estimated(void **state)
{
	(void)state;
	ts_build *build = load("\"POSITION\":0", "", "");
	const ts_scene *scene = good(build);
	assert_int_equal(scene->n_surfels, 2 * N); /* a sheet, seen from both sides */
	for (u32 i = 0; i < 2 * N; i++) {
		ts_v3 n = ts_cross(ts_load3(scene->surfels[i].u), ts_load3(scene->surfels[i].v));
		assert_true(n.x == 0.0f && n.y == 0.0f && n.z != 0.0f);
	}
	assert_string_equal(scene->notes[0], "points have no normals: they are estimated by the points around each");
	ts_build_free(build);
	build = load("\"POSITION\":6,\"NORMAL\":1", "", "");
	assert_int_equal(good(build)->n_surfels, 0);
	assert_non_null(strstr(ts_build_peek(build)->notes[0], "no size"));
	ts_build_free(build);
}

static void what_is_no_splat_is_refused(void **state)
{
	(void)state;
	refuse("\"POSITION\":0,\"NORMAL\":1,\"_SPLAT_U\":2", "", "go together");
	refuse("\"POSITION\":0,\"NORMAL\":1,\"_SPLAT_U\":2,\"_SPLAT_V\":5", "",
	       "point 0: the half-axes u and v are not at a right");
	refuse("\"POSITION\":0,\"NORMAL\":1,\"_SPLAT_U\":2,\"_SPLAT_V\":6", "", "half-axis v is not longer than 0");
	refuse("\"POSITION\":0,\"NORMAL\":2,\"_SPLAT_U\":2,\"_SPLAT_V\":3", "", "right angle to the normal");
	refuse("\"POSITION\":8,\"NORMAL\":1", "", "has 3 items, another attribute has 4");
	refuse("\"POSITION\":8,\"NORMAL\":8,\"_SPLAT_U\":8,\"_SPLAT_V\":8", ",\"indices\":7", "index 3 at 0; there are 3");
	refuse("\"POSITION\":0,\"NORMAL\":1,\"_SPLAT_U\":7,\"_SPLAT_V\":3", "", "the type is not what this use needs");
	f32 nan = ts_u2f(0x7fc00000u);
	memcpy(buffer + U, &nan, sizeof nan);
	for (u32 i = 0; i < N; i++) memcpy(buffer + U + 12 * i, &nan, sizeof nan);
	refuse(SPLATS, "", "no point can be drawn; point 0: accessors/2: item 0 is not finite");
	set_up(NULL);
}

static void a_bad_point_is_left_out(void **state)
{
	(void)state;
	f32 nan = ts_u2f(0x7fc00000u);
	memcpy(buffer + 12, &nan, sizeof nan); /* of the second position */
	ts_build *build = load("\"POSITION\":0,\"NORMAL\":1", "", "");
	assert_int_equal(good(build)->n_surfels, N - 1);
	assert_note(build, "1 points are left out, the first: point 1: accessors/0: item 1 is not finite");
	ts_build_free(build);
	set_up(NULL);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(ellipses_are_read_as_they_are),
		cmocka_unit_test(nodes_move_and_mirror_them),
		cmocka_unit_test(indices_and_materials_count),
		cmocka_unit_test(points_without_axes_are_as_wide_as_their_neighbours_are_far),
		cmocka_unit_test(without_normals_they_are_estimated),
		cmocka_unit_test(a_bad_point_is_left_out),
		cmocka_unit_test(what_is_no_splat_is_refused),
	};
	return cmocka_run_group_tests(tests, set_up, NULL);
}

/* KHR_mesh_quantization: the same mesh as integers and as the floats that they stand for gives the same scene. */
#include "tests/scene/gltf/files.h"

enum { N = 3, BYTE = 5120, UBYTE, SHORT, USHORT, FLOAT = 5126 };

typedef struct {
	int type;
	bool normalized;
} coding;

static const coding codings[] = {{BYTE, false},  {BYTE, true},  {UBYTE, false},  {UBYTE, true},
                                 {SHORT, false}, {SHORT, true}, {USHORT, false}, {USHORT, true}};
enum { CODINGS = sizeof codings / sizeof codings[0] };

static bool is_signed(coding c) { return c.type == BYTE || c.type == SHORT; }

static int least(coding c) { return !is_signed(c) ? 0 : c.type == BYTE ? -128 : -32768; }

static int most(coding c) { return c.type == BYTE ? 127 : c.type == UBYTE ? 255 : c.type == SHORT ? 32767 : 65535; }

/* Both ends of the range and values between, of component k of vertex i. */
static int code(coding c, u32 i, u32 k)
{
	const int values[5] = {least(c), most(c), least(c) + 1, 1, most(c) / 3};
	return values[(3 * i + k) % 5];
}

/* glTF 2.0, 3.6.2.2, in double precision. */
static f32 meaning(coding c, int x)
{
	double value = c.normalized ? (double)x / most(c) : (double)x;
	return (f32)(value < -1.0 && c.normalized ? -1.0 : value);
}

/* A triangle by indices 0 1 2 whose attribute is coded so, 16 bytes a vertex; another attribute than POSITION has plain
 * positions beside it. */
static ts_build *load(const char *attribute, u32 components, coding c, bool as_floats, const char *extensions)
{
	unsigned char bytes[96] = {0};
	char data[129], text[4096], first[64] = "";
	for (u32 i = 0; i < N; i++) {
		for (u32 k = 0; k < components; k++) {
			int x = code(c, i, k);
			f32 number = meaning(c, x);
			size_t width = as_floats ? 4 : c.type < SHORT ? 1 : 2;
			memcpy(bytes + 16 * i + width * k, as_floats ? (void *)&number : (void *)&x, width);
		}
		f32 position[3] = {(f32)(i & 1), (f32)(i >> 1), 0.0f};
		memcpy(bytes + 48 + 12 * i, position, sizeof position);
	}
	base64(data, bytes, sizeof bytes);
	if (strcmp(attribute, "POSITION") != 0) snprintf(first, sizeof first, "\"POSITION\":1,");
	if (strcmp(attribute, "TANGENT") == 0) snprintf(first, sizeof first, "\"POSITION\":1,\"NORMAL\":1,");
	snprintf(text, sizeof text,
	         "{\"asset\":{\"version\":\"2.0\"},%s\"buffers\":[{\"byteLength\":96,\"uri\":"
	         "\"data:application/octet-stream;base64,%s\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":48,"
	         "\"byteStride\":16},{\"buffer\":0,\"byteOffset\":48,\"byteLength\":48}],\"accessors\":[{\"bufferView\":0,"
	         "\"componentType\":%d,\"normalized\":%s,\"type\":\"VEC%u\",\"count\":3},{\"bufferView\":1,"
	         "\"componentType\":5126,\"type\":\"VEC3\",\"count\":3}],\"meshes\":[{\"primitives\":[{\"attributes\":"
	         "{%s\"%s\":0}}]}],\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0,\"translation\":[1,-2,3],"
	         "\"rotation\":[0,0.6,0,0.8],\"scale\":[0.001,0.002,0.003]}]}",
	         extensions, data, as_floats ? FLOAT : c.type, c.normalized && !as_floats ? "true" : "false", components,
	         first, attribute);
	return load_text(text, NULL, 8);
}

#define REQUIRED "\"extensionsUsed\":[\"KHR_mesh_quantization\"],\"extensionsRequired\":[\"KHR_mesh_quantization\"],"

static void assert_same(const char *attribute, u32 components, coding c)
{
	ts_build *coded = load(attribute, components, c, false, REQUIRED), *plain;
	if (ts_build_failed(coded)) fail_msg("%s of %d: %s", attribute, c.type, ts_error_message());
	plain = load(attribute, components, c, true, "");
	if (ts_build_failed(plain)) fail_msg("%s of %d: %s", attribute, c.type, ts_error_message());
	const ts_scene *a = ts_build_peek(coded), *b = ts_build_peek(plain);
	assert_int_equal(a->n_notes, 0);
	assert_int_equal(a->n_vertices, N);
	assert_int_equal(b->n_vertices, N);
	assert_int_equal(a->n_triangles, 1);
	assert_memory_equal(a->triangles, b->triangles, sizeof *a->triangles);
	assert_memory_equal(a->vertices, b->vertices, N * sizeof *a->vertices);
	ts_build_free(coded);
	ts_build_free(plain);
}

static void positions_of_integers_are_those_of_floats(void **state)
{
	(void)state;
	for (u32 i = 0; i < CODINGS; i++) assert_same("POSITION", 3, codings[i]);
}

static void coordinates_of_integers_are_those_of_floats(void **state)
{
	(void)state;
	for (u32 i = 0; i < CODINGS; i++) {
		assert_same("TEXCOORD_0", 2, codings[i]);
		assert_same("TEXCOORD_1", 2, codings[i]);
	}
}

static void only_signed_normalized_directions_are_read(void **state)
{
	(void)state;
	for (u32 i = 0; i < CODINGS; i++) {
		if (is_signed(codings[i]) && codings[i].normalized) {
			assert_same("NORMAL", 3, codings[i]);
			assert_same("TANGENT", 4, codings[i]);
		} else {
			assert_refused(load("NORMAL", 3, codings[i], false, REQUIRED), "5126 (float) is expected");
			assert_refused(load("TANGENT", 4, codings[i], false, REQUIRED), "5126 (float) is expected");
		}
	}
}

/* Colours are as without the extension: unsigned and normalized. */
static void only_unsigned_normalized_colours_are_read(void **state)
{
	(void)state;
	for (u32 i = 0; i < CODINGS; i++) {
		if (!is_signed(codings[i]) && codings[i].normalized)
			assert_same("COLOR_0", 4, codings[i]);
		else
			assert_refused(load("COLOR_0", 4, codings[i], false, REQUIRED), "normalized 5121 or 5123");
	}
}

static void integers_without_the_extension_are_refused(void **state)
{
	(void)state;
	for (u32 i = 0; i < CODINGS; i++) {
		assert_refused(load("POSITION", 3, codings[i], false, ""), "where KHR_mesh_quantization is not required");
		assert_refused(load("NORMAL", 3, codings[i], false, ""), "where KHR_mesh_quantization is not required");
	}
	assert_refused(load("TEXCOORD_0", 2, codings[6], false, ""), "where KHR_mesh_quantization is not required");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(positions_of_integers_are_those_of_floats),
		cmocka_unit_test(coordinates_of_integers_are_those_of_floats),
		cmocka_unit_test(only_signed_normalized_directions_are_read),
		cmocka_unit_test(only_unsigned_normalized_colours_are_read),
		cmocka_unit_test(integers_without_the_extension_are_refused),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

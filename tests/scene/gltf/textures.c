/* Textures that other tools write: formats that are not read, no image at all, and any set of texture coordinates. */
#include "kernels/base/num.h"
#include "tests/scene/gltf/files.h"

/* A red PNG of one texel; then what begins as a KTX2, a WebP, a GIF, and as nothing known. */
#define PNG \
	"data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP438AAAAQBAYDFKhhdAAAAAElFTkSu" \
	"QmCC"
#define KTX2 "data:image/ktx2,%ABKTX%2020%BB%0D%0A%1A%0A0000"
#define WEBP "data:image/webp,RIFF0000WEBP0000"
#define GIF "data:image/gif,GIF89a0000000000"
#define JUNK "junk0000000000000"

/* A triangle with three sets of texture coordinates: (0, 0.1) (0.2, 0.3) (0.4, 0.5), plus 1 in set 1, plus 2 in set
 * 2. */
static ts_build *load(const char *material, const char *rest, const char *attributes)
{
	unsigned char bytes[108];
	char data[145], text[4096];
	const f32 positions[9] = {0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f};
	memcpy(bytes, positions, 36);
	for (u32 set = 0; set < 3; set++)
		for (u32 i = 0; i < 6; i++) {
			f32 uv = (f32)i / 10.0f + (f32)set;
			memcpy(bytes + 36 + 24 * set + 4 * i, &uv, 4);
		}
	base64(data, bytes, sizeof bytes);
	snprintf(
		text, sizeof text,
		"{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":108,\"uri\":"
		"\"data:application/octet-stream;base64,%s\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":108}],"
		"\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",\"count\":3},"
		"{\"bufferView\":0,\"byteOffset\":36,\"componentType\":5126,\"type\":\"VEC2\",\"count\":3},"
		"{\"bufferView\":0,\"byteOffset\":60,\"componentType\":5126,\"type\":\"VEC2\",\"count\":3},"
		"{\"bufferView\":0,\"byteOffset\":84,\"componentType\":5126,\"type\":\"VEC2\",\"count\":3}],"
		"\"materials\":[%s],%s,\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,%s},\"material\":0}]}],"
		"\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}]}",
		data, material, rest, attributes);
	return load_text(text, NULL, 8);
}

#define SETS "\"TEXCOORD_0\":1,\"TEXCOORD_1\":2,\"TEXCOORD_2\":3"
#define IMAGE(uri) "\"images\":[{\"uri\":\"" uri "\"}],\"textures\":[{\"source\":0}]"
#define RED "{\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0,0,1]}}"
#define TEXTURED "{\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,0,0,1],\"baseColorTexture\":{\"index\":0}}}"

static const ts_scene *good(ts_build *build)
{
	if (ts_build_failed(build)) fail_msg("%s", ts_error_message());
	return ts_build_peek(build);
}

/* The scene of a texture that is left out is that of its factor alone. */
static void assert_left_out(const char *rest, const char *note)
{
	ts_build *build = load(TEXTURED, rest, SETS), *plain = load(RED, "\"textures\":[]", SETS);
	const ts_scene *a = good(build), *b = good(plain);
	assert_int_equal(a->n_materials, b->n_materials);
	assert_memory_equal(a->materials, b->materials, b->n_materials * sizeof *b->materials);
	assert_memory_equal(a->vertices, b->vertices, b->n_vertices * sizeof *b->vertices);
	assert_int_equal(a->n_slots + a->n_images, 0);
	if (!has_note(build, note)) fail_msg("no note says \"%s\"", note);
	ts_build_free(build);
	ts_build_free(plain);
}

static void unknown_formats_are_left_out(void **state)
{
	(void)state;
	assert_left_out(IMAGE(KTX2), "images/0 is KTX2, neither PNG nor JPEG");
	assert_left_out(IMAGE(WEBP), "images/0 is WebP, neither PNG nor JPEG");
	assert_left_out(IMAGE(GIF), "images/0 is GIF, neither PNG nor JPEG");
	assert_left_out(IMAGE("data:image/png,RIFF0000WEBP0000"), "images/0 is WebP");
	assert_left_out(IMAGE("data:image/x-of-tomorrow," JUNK), "images/0 is \"image/x-of-tomorrow\"");
	assert_left_out("\"textures\":[{}]", "textures/0 has no image that is read");
	assert_refused(load(TEXTURED, IMAGE("data:image/png," JUNK), SETS), "images/0: neither PNG nor JPEG");
	assert_refused(load(TEXTURED, IMAGE("data:image/jpeg," JUNK), SETS), "images/0: neither PNG nor JPEG");
	assert_refused(load(TEXTURED, IMAGE("data:text/plain," JUNK), SETS), "media type \"text/plain\"");
}

/* What such extensions name is left out, required or not; an image beside it is read. */
static void an_image_beside_an_extension_is_read(void **state)
{
	static const char *const names[4] = {"KHR_texture_basisu", "EXT_texture_webp", "EXT_texture_avif",
	                                     "MSFT_texture_dds"};
	(void)state;
	for (int i = 0; i < 8; i++) {
		char rest[1024];
		const char *name = names[i / 2];
		snprintf(rest, sizeof rest,
		         "\"%s\":[\"%s\"],\"images\":[{\"uri\":\"%s\"}],\"textures\":[{\"extensions\":{\"%s\":{\"source\":"
		         "0}}}]",
		         i % 2 ? "extensionsRequired" : "extensionsUsed", name, KTX2, name);
		assert_left_out(rest, "textures/0 has no image that is read");
		snprintf(rest, sizeof rest,
		         "\"%s\":[\"%s\"],\"images\":[{\"uri\":\"%s\"},{\"uri\":\"" PNG "\"}],"
		         "\"textures\":[{\"source\":1,\"extensions\":{\"%s\":{\"source\":0}}}]",
		         i % 2 ? "extensionsRequired" : "extensionsUsed", name, KTX2, name);
		ts_build *build = load(TEXTURED, rest, SETS);
		assert_int_equal(good(build)->n_images, 1);
		assert_note(build, "from their PNG or JPEG images only");
		ts_build_free(build);
	}
}

/* Loads a material whose base colour and emission use these sets, and requires that their slots read those. */
static void assert_sets(int base, int emissive)
{
	char material[512];
	snprintf(material, sizeof material,
	         "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0,\"texCoord\":%d}},\"emissiveTexture\":"
	         "{\"index\":0,\"texCoord\":7,\"extensions\":{\"KHR_texture_transform\":{\"texCoord\":%d}}}}",
	         base, emissive);
	ts_build *build = load(material, IMAGE(PNG), SETS);
	const ts_scene *scene = good(build);
	const ts_material *m = &scene->materials[scene->triangles[0].material];
	const int sets[2] = {base, emissive};
	const u32 slots[2] = {m->slot[TS_SLOT_BASE], m->slot[TS_SLOT_EMISSIVE]};
	for (int k = 0; k < 2; k++) {
		assert_true(slots[k] < scene->n_slots);
		for (u32 i = 0; i < 6; i++) {
			u32 vertex = scene->triangles[0].vertex[i / 2];
			f32 uv = scene->vertices[vertex].uv[2 * scene->slots[slots[k]].uv_set + i % 2];
			assert_true(uv == (f32)i / 10.0f + (f32)sets[k]);
		}
	}
	assert_false(has_note(build, "left out"));
	assert_false(has_note(build, "read at (0, 0)"));
	ts_build_free(build);
}

static void slots_read_the_sets_they_name(void **state)
{
	(void)state;
	for (int base = 0; base < 3; base++)
		for (int emissive = 0; emissive < 3; emissive++) assert_sets(base, emissive);
}

static void a_third_set_is_left_out(void **state)
{
	(void)state;
	ts_build *build = load("{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":0,\"texCoord\":2}},"
	                       "\"occlusionTexture\":{\"index\":0,\"texCoord\":1},\"emissiveTexture\":{\"index\":0}}",
	                       IMAGE(PNG), SETS);
	const ts_scene *scene = good(build);
	const ts_material *m = &scene->materials[scene->triangles[0].material];
	assert_true(m->slot[TS_SLOT_BASE] != TS_NONE && m->slot[TS_SLOT_OCCLUSION] != TS_NONE);
	assert_int_equal(m->slot[TS_SLOT_EMISSIVE], TS_NONE);
	assert_note(build, "materials/0 reads more than two sets of texture coordinates: what uses TEXCOORD_0 is left out");
	assert_note(build, "\"TEXCOORD_0\" is ignored");
	ts_build_free(build);
}

static void an_absent_set_is_read_at_zero(void **state)
{
	(void)state;
	ts_build *build = load("{\"emissiveTexture\":{\"index\":0,\"texCoord\":2147483647}}", IMAGE(PNG), SETS);
	const ts_scene *scene = good(build);
	for (u32 i = 0; i < 3; i++) {
		const f32 *uv = scene->vertices[i].uv;
		assert_true(uv[0] == 0.0f && uv[1] == 0.0f);
	}
	assert_note(build, "textured primitives without TEXCOORD_2147483647 are read at (0, 0)");
	ts_build_free(build);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(unknown_formats_are_left_out),  cmocka_unit_test(an_image_beside_an_extension_is_read),
		cmocka_unit_test(slots_read_the_sets_they_name), cmocka_unit_test(a_third_set_is_left_out),
		cmocka_unit_test(an_absent_set_is_read_at_zero),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

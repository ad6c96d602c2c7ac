/* Files of a gibibyte: what they begin with, or what is said of them, is looked at before they are read. */
#include "files.h"
#include <sys/resource.h>
#include "../../scratch.h"

/* A gibibyte of zeros, without blocks on the disk, after `head`. */
static void make(const char *leaf, const char *head, size_t n)
{
	FILE *file = fopen(scratch_path("%s", leaf), "wb");
	assert_non_null(file);
	assert_int_equal(fwrite(head, 1, n, file), n);
	assert_int_equal(fflush(file), 0);
	assert_int_equal(ftruncate(fileno(file), 1 << 30), 0);
	fclose(file);
}

static long peak_kib(void)
{
	struct rusage usage;
	assert_int_equal(getrusage(RUSAGE_SELF, &usage), 0);
	return usage.ru_maxrss;
}

static ts_build *load(const char *leaf)
{
	ts_build *build = ts_build_new("test");
	long before = peak_kib();
	ts_gltf_load(build, scratch_path("%s", leaf), NULL, NULL, 8);
	assert_true(peak_kib() - before < 256 * 1024);
	return build;
}

static void test_scenes(void **state)
{
	static const struct {
		const char *leaf, *head, *words;
		size_t n;
	} rows[] = {
		{"zeros.glb", "", "does not begin with \"glTF\"", 0},
		{"zeros.gltf", "", "JSON is expected", 0},
		{"text.gltf", "<html>", "line 1, column 1: '[' or '{' expected near '<'", 6},
		{"old.glb", "glTF\1\0\0\0", "container version 1; 2 is expected", 8},
	};
	(void)state;
	for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
		make(rows[i].leaf, rows[i].head, rows[i].n);
		assert_refused(load(rows[i].leaf), rows[i].words);
		unlink(scratch_path("%s", rows[i].leaf));
	}
}

/* A scene whose buffer of 36 bytes and image are files. */
static void write_scene(void)
{
	FILE *file = fopen(scratch_path("scene.gltf"), "w");
	assert_non_null(file);
	fputs("{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":36,\"uri\":\"zeros.bin\"}],\"bufferViews\":["
	      "{\"buffer\":0,\"byteLength\":36}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\","
	      "\"count\":3}],\"images\":[{\"uri\":\"image\"}],\"textures\":[{\"source\":0}],\"materials\":[{"
	      "\"emissiveTexture\":{\"index\":0}}],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},"
	      "\"material\":0}]}],\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}]}",
	      file);
	fclose(file);
}

static void test_buffers_and_images(void **state)
{
	(void)state;
	write_scene();
	make("zeros.bin", "", 0);
	make("image", "", 0);
	assert_refused(load("scene.gltf"), "images/0: neither PNG nor JPEG");
	make("image", "GIF89a", 6);
	ts_build *build = load("scene.gltf");
	if (ts_build_failed(build)) fail_msg("%s", ts_error_message());
	assert_int_equal(ts_build_peek(build)->n_triangles, 1);
	assert_note(build, "images/0 is GIF");
	ts_build_free(build);
	unlink(scratch_path("image"));
	unlink(scratch_path("zeros.bin"));
	unlink(scratch_path("scene.gltf"));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_scenes),
		cmocka_unit_test(test_buffers_and_images),
	};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_end);
}

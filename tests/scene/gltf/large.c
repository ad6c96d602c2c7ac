/* Files of a gibibyte: what they begin with, or what is said of them, is looked at before they are read. And
 * images whose texels only their own bytes justify. */
#include <sys/resource.h>
#include <zlib.h>
#include "tests/scene/gltf/files.h"
#include "tests/scratch.h"

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
	ts_gltf_load(build, &(ts_scene_file){.name = scratch_path("%s", leaf)}, NULL, NULL, 8);
	assert_true(peak_kib() - before < 256 * 1024);
	return build;
}

static void large_files_are_refused_by_their_beginning(void **state)
{
	static const struct {
		const char *leaf, *head, *words;
		size_t n;
	} rows[] = {
		{"zeros.glb", "", "does not begin with \"glTF\"", 0},
		{"zeros.gltf", "", "JSON is expected", 0},
		{"text.gltf", "<html>", "line 1, column 1: no value; JSON is expected", 6},
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

static void the_beginning_of_a_large_image_decides(void **state)
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

static void put_chunk(FILE *file, const char *type, const void *data, size_t n)
{
	uLong sum = crc32(crc32(0, (const Bytef *)type, 4), data, (uInt)n);
	const unsigned char head[4] = {(unsigned char)(n >> 24), (unsigned char)(n >> 16), (unsigned char)(n >> 8),
	                               (unsigned char)n};
	const unsigned char tail[4] = {(unsigned char)(sum >> 24), (unsigned char)(sum >> 16), (unsigned char)(sum >> 8),
	                               (unsigned char)sum};
	fwrite(head, 1, 4, file);
	fwrite(type, 1, 4, file);
	fwrite(data, 1, n, file);
	fwrite(tail, 1, 4, file);
}

/* A black image of more texels than the bytes of the scene alone allow. */
static void make_flat_image(const char *leaf)
{
	enum { SIDE = 2048, ROW = SIDE + 1 };
	const unsigned char header[13] = {0, 0, SIDE >> 8, 0, 0, 0, SIDE >> 8, 0, 8, 0, 0, 0, 0};
	uLongf n = compressBound(SIDE * ROW);
	unsigned char *rows = calloc(SIDE, ROW), *packed = malloc(n);
	FILE *file = fopen(scratch_path("%s", leaf), "wb");
	assert_true(rows != NULL && packed != NULL && file != NULL);
	assert_int_equal(compress2(packed, &n, rows, SIDE * ROW, 9), Z_OK);
	fwrite("\x89PNG\r\n\x1a\n", 1, 8, file);
	put_chunk(file, "IHDR", header, sizeof header);
	put_chunk(file, "IDAT", packed, n);
	put_chunk(file, "IEND", "", 0);
	fclose(file);
	free(rows);
	free(packed);
}

static void bytes_of_images_justify_their_texels(void **state)
{
	(void)state;
	write_scene();
	make("zeros.bin", "", 0);
	make_flat_image("image");
	ts_build *build = load("scene.gltf");
	if (ts_build_failed(build)) fail_msg("%s", ts_error_message());
	ts_build_free(build);
	unlink(scratch_path("image"));
	unlink(scratch_path("zeros.bin"));
	unlink(scratch_path("scene.gltf"));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(large_files_are_refused_by_their_beginning),
		cmocka_unit_test(the_beginning_of_a_large_image_decides),
		cmocka_unit_test(bytes_of_images_justify_their_texels),
	};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_end);
}

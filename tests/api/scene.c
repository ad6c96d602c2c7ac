/* Scenes from bytes in memory: the same as from the file that holds these bytes. And how a host ends their opening. */
#include "tests/api/run.h"

typedef struct {
	char *bytes;
	size_t n;
} file;

static file read_file(const char *path)
{
	file f = {.bytes = malloc(1 << 20)};
	FILE *from = fopen(path, "rb");
	assert_true(f.bytes != NULL && from != NULL);
	f.n = fread(f.bytes, 1, 1 << 20, from);
	assert_true(f.n > 0 && f.n < 1 << 20 && fclose(from) == 0);
	return f;
}

static void put_word(char *to, size_t value)
{
	for (int i = 0; i < 4; i++) to[i] = (char)(value >> 8 * i & 255);
}

/* A .glb of the text of a .gltf. */
static file packed(const file *text)
{
	size_t n = (text->n + 3) / 4 * 4;
	file f = {malloc(n + 20), n + 20};
	assert_non_null(f.bytes);
	memcpy(f.bytes, "glTF\2\0\0\0", 8);
	put_word(f.bytes + 8, f.n);
	put_word(f.bytes + 12, n);
	memcpy(f.bytes + 16, "JSON", 4);
	memset(f.bytes + 20, ' ', n);
	memcpy(f.bytes + 20, text->bytes, text->n);
	return f;
}

/* The digests of what a run has of the scene, and of its picture. */
static void add_digests(char text[4][65], const ts_scene *of, const char *effect, const char *method,
                        const char *const buffers[4])
{
	char names[256];
	ts_trace *trace;
	const ts_run_options options = {.bytes = sizeof options, .buffers = names};
	snprintf(names, sizeof names, "%s,%s,%s,%s", buffers[0], buffers[1], buffers[2], buffers[3]);
	done(ts_trace_run(context, &trace, of, params, effect, method, &options));
	for (size_t i = 0; i < 4; i++) done(ts_trace_digest(trace, buffers[i], text[i]));
	ts_trace_close(trace);
}

/* The bytes are gone before the scene is used. */
static void same(const char *path, file f, const char *effect, const char *method, const char *const buffers[4])
{
	char right[4][65], found[4][65];
	ts_scene *from_file, *from_bytes;
	done(ts_scene_open(context, &from_file, path, params, NULL));
	done(ts_scene_open_bytes(context, &from_bytes, f.bytes, f.n, "mine", params, NULL));
	memset(f.bytes, 0, f.n);
	free(f.bytes);
	add_digests(right, from_file, effect, method, buffers);
	add_digests(found, from_bytes, effect, method, buffers);
	for (size_t i = 0; i < 4; i++) assert_string_equal(found[i], right[i]);
	ts_scene_free(from_file);
	ts_scene_free(from_bytes);
}

static void bytes_make_the_scene_of_their_file(void **state)
{
	(void)state;
	static const char *const of_triangles[4] = {"scene.vertex", "scene.triangle", "scene.texel", "image.srgb"};
	static const char *const of_surfels[4] = {"scene.surfel", "scene.light", "scene.info", "image.srgb"};
	file room = read_file("scenes/room.gltf");
	same("scenes/room.gltf", packed(&room), "reflections", "mvr", of_triangles);
	same("scenes/room.gltf", room, "reflections", "mvr", of_triangles);
	same("scenes/splats.ply", read_file("scenes/splats.ply"), "surfels", "deferred", of_surfels);
	same("scenes/splats.gltf", read_file("scenes/splats.gltf"), "surfels", "deferred", of_surfels);
}

static void bytes_that_are_no_scene_are_refused(void **state)
{
	(void)state;
	static const char beside[] =
		"{\"asset\": {\"version\": \"2.0\"}, \"buffers\": [{\"byteLength\": 36, \"uri\": \"beside.bin\"}], "
		"\"bufferViews\": [{\"buffer\": 0, \"byteLength\": 36}], \"accessors\": [{\"bufferView\": 0, "
		"\"componentType\": 5126, \"type\": \"VEC3\", \"count\": 3}], \"meshes\": [{\"primitives\": "
		"[{\"attributes\": {\"POSITION\": 0}}]}], \"scenes\": [{\"nodes\": [0]}], \"nodes\": [{\"mesh\": 0}]}";
	static const struct {
		const char *bytes, *words;
		ts_kind kind;
	} bad[] = {{"", "mine: its first bytes are those of no", TS_KIND_FORMAT},
	           {"plyable", "mine: its first bytes are those of no", TS_KIND_FORMAT},
	           {"ply\n", "mine: ", TS_KIND_FORMAT},
	           {"glTF\2", "mine: the header is cut", TS_KIND_FORMAT},
	           {" \n{", "mine: ", TS_KIND_FORMAT},
	           {beside,
	            "file \"beside.bin\": a scene in memory has no files beside it; a .glb, or data URIs, would be right",
	            TS_KIND_ARGUMENT}};
	ts_scene *made;
	for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
		refused(ts_scene_open_bytes(context, &made, bad[i].bytes, strlen(bad[i].bytes), "mine", params, NULL),
		        bad[i].words);
		assert_int_equal(ts_error_kind(), bad[i].kind);
		assert_null(made);
	}
}

/* Points on a wavy sheet, without normals or sizes. */
static file cloud(int side)
{
	file f = {.bytes = malloc((size_t)side * (size_t)side * 24 + 256)};
	assert_non_null(f.bytes);
	int at = sprintf(f.bytes,
	                 "ply\nformat ascii 1.0\nelement vertex %d\nproperty float x\nproperty float y\n"
	                 "property float z\nend_header\n",
	                 side * side);
	for (int i = 0; i < side * side; i++)
		at += sprintf(f.bytes + at, "%d %d %d\n", i % side, i % 7 * (i / side % 5), i / side);
	f.n = (size_t)at;
	return f;
}

/* A .glb of that many triangles side by side. */
static file mesh(int triangles)
{
	const size_t n = (size_t)triangles * 36;
	char text[512];
	float *corners = malloc(n);
	file json = {.bytes = text}, f = {.n = 0};
	assert_non_null(corners);
	for (int i = 0; i < triangles * 3; i++) {
		corners[3 * i] = (float)(i / 3 % 500) + (i % 3 == 1 ? 1.0f : 0.0f);
		corners[3 * i + 1] = (float)(i / 3 % 11);
		corners[3 * i + 2] = (float)(i / 1500) + (i % 3 == 2 ? 1.0f : 0.0f);
	}
	json.n = (size_t)sprintf(text,
	                         "{\"asset\": {\"version\": \"2.0\"}, \"buffers\": [{\"byteLength\": %zu}], "
	                         "\"bufferViews\": [{\"buffer\": 0, \"byteLength\": %zu}], \"accessors\": "
	                         "[{\"bufferView\": 0, \"componentType\": 5126, \"type\": \"VEC3\", \"count\": %d}], "
	                         "\"meshes\": [{\"primitives\": [{\"attributes\": {\"POSITION\": 0}}]}], "
	                         "\"scenes\": [{\"nodes\": [0]}], \"nodes\": [{\"mesh\": 0}]}",
	                         n, n, triangles * 3);
	f = packed(&json);
	f.bytes = realloc(f.bytes, f.n + 8 + n);
	assert_non_null(f.bytes);
	put_word(f.bytes + f.n, n);
	memcpy(f.bytes + f.n + 4, "BIN", 4);
	memcpy(f.bytes + f.n + 8, corners, n);
	f.n += 8 + n;
	put_word(f.bytes + 8, f.n);
	free(corners);
	return f;
}

/* Asked all the while; at whatever time it says yes the scene is none, and that was the last time. */
static void ends(ending_host *h, ts_context *own, const file *f, const char *spec)
{
	ts_scene *made;
	*h = (ending_host){.end_at = 0};
	done(f != NULL ? ts_scene_open_bytes(own, &made, f->bytes, f->n, spec, params, NULL)
	               : ts_scene_open(own, &made, spec, params, NULL));
	ts_scene_free(made);
	const int n = h->asked;
	if (n < 5) fail_msg("%s: asked %d times", spec, n);
	for (int k = 0; k < 4; k++) {
		*h = (ending_host){.end_at = 1 + k * n / 6};
		refused(f != NULL ? ts_scene_open_bytes(own, &made, f->bytes, f->n, spec, params, NULL)
		                  : ts_scene_open(own, &made, spec, params, NULL),
		        "cancelled");
		assert_int_equal(ts_error_kind(), TS_KIND_CANCELLED);
		assert_null(made);
		assert_int_equal(h->asked, h->end_at);
	}
}

static void a_scene_ends_as_it_opens(void **state)
{
	(void)state;
	ending_host h;
	ts_context *own;
	file points = cloud(130), triangles = mesh(100000);
	const ts_context_options options = {.bytes = sizeof options, .threads = 2, .user = &h, .cancelled = asked_to_end};
	h = (ending_host){.end_at = 0};
	done(ts_context_open(&own, &options));
	ends(&h, own, &points, "points");
	ends(&h, own, &triangles, "triangles");
	ends(&h, own, NULL, "gallery:triangles=300k:texels=16");
	ts_context_close(own);
	free(points.bytes);
	free(triangles.bytes);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(bytes_make_the_scene_of_their_file),
		cmocka_unit_test(bytes_that_are_no_scene_are_refused),
		cmocka_unit_test(a_scene_ends_as_it_opens),
	};
	return cmocka_run_group_tests(tests, run_begin, run_end);
}

/* Opening traces that are wrong in every way: none may be taken, each must be told what would be right. */
#include <sys/stat.h>
#include "tests/trace/small.h"
#include "trace/read.h"

static char good[SCRATCH_PATH], bad[SCRATCH_PATH];

/* A hand-made trace of three buffers. */
static int begin(void **state)
{
	static const char text[] =
		"{\"format\": \"touchstone-trace\", \"version\": 1, \"contract\": 1, \"order\": \"canonical\","
		"\"effect\": \"reflections\", \"pipeline\": \"epr\", \"producer\": {\"name\": \"port\", \"version\": \"7\"},"
		"\"params\": {\"width\": \"64\", \"height\": \"36\"}, \"buffers\": ["
		"{\"name\": \"points.key\", \"file\": \"k.npy\"}, {\"name\": \"image.srgb\", \"file\": \"s.npy\"},"
		"{\"name\": \"cull.keep\", \"file\": null}]}";
	char data[24] = {0};
	if (scratch_begin(state) != 0) return -1;
	snprintf(good, sizeof good, "%s", scratch_path("good"));
	snprintf(bad, sizeof bad, "%s", scratch_path("bad"));
	mkdir(good, 0777);
	file_write(scratch_path("good/trace.json"), text, sizeof text - 1);
	npy_write(scratch_path("good/k.npy"), "'<u8'", "(3,)", data, 24);
	npy_write(scratch_path("good/s.npy"), "'|u1'", "(2, 4, 3)", data, 24);
	return 0;
}

static void refuses(const char *what)
{
	ts_trace *trace = (ts_trace *)1;
	if (ts_trace_open_folder(&trace, bad) == TS_OK) fail_msg("taken, though %s", what);
	assert_null(trace);
	says(what);
}

static void a_good_trace_is_opened(void **state)
{
	(void)state;
	ts_trace *t;
	assert_int_equal(ts_trace_open_folder(&t, good), TS_OK);
	assert_string_equal(t->producer, "port 7");
	assert_true(!t->arrival && t->has_params && t->params.width == 64 && strcmp(t->pipeline->name, "epr") == 0);
	assert_true(t->item[TS_B_points_key].npy.n == 3 && t->item[TS_B_image_srgb].npy.shape[2] == 3);
	assert_null(t->item[TS_B_cull_keep].path);
	ts_trace_close(t);
	ts_trace_close(NULL);
}

/* One value of the root, or with "B.key" of the first buffer; without text it is removed. */
typedef struct {
	const char *key, *text, *says;
} wrong;

static void change(json_t *root, const void *user)
{
	const wrong *w = user;
	json_t *to = w->key[0] == 'B' ? json_array_get(json_object_get(root, "buffers"), 0) : root;
	const char *key = w->key[0] == 'B' ? w->key + 2 : w->key;
	if (w->text == NULL) {
		json_object_del(to, key);
		return;
	}
	json_t *value = json_loads(w->text, JSON_DECODE_ANY, NULL);
	if (value == NULL) fail_msg("%s is no JSON", w->text);
	json_object_set_new(to, key, value);
}

static const wrong values[] = {
	{"format", NULL, "format is not"},
	{"format", "3", "format is not"},
	{"format", "\"other\"", "format is not"},
	{"version", NULL, "version is missing"},
	{"version", "0", "version 0; this program reads version 1 to 2"},
	{"version", "3", "version 3; this program reads version 1 to 2"},
	{"version", "\"1\"", "version \"1\""},
	{"version", "1.5", "version 1.5"},
	{"version", "-1", "version -1"},
	{"contract", NULL, "contract is missing"},
	{"contract", "2", "contract 2; this program reads contract 1"},
	{"order", NULL, "order is \"\""},
	{"order", "\"random\"", "\"canonical\" or \"arrival\""},
	{"order", "[]", "order is"},
	{"pipeline", NULL, "no pipeline"},
	{"pipeline", "\"eprr\"", "no pipeline \"eprr\""},
	{"pipeline", "1", "no pipeline"},
	{"effect", "\"fog\"", "no pipeline"},
	{"effect", "7", "effect is not a text"},
	{"pipeline", "\"hulls\"", "effect \"area-light\" or \"indirect\" would be right"},
	{"buffers", NULL, "buffers is not an array"},
	{"buffers", "{}", "buffers is not an array"},
	{"buffers", "[1]", "no buffer \"\""},
	{"buffers", "[{}]", "no buffer"},
	{"buffers", "[null]", "no buffer"},
	{"params", "[]", "params is not an object"},
	{"params", "{\"width\": 64}", "width is not a string"},
	{"params", "{\"width\": \"x\"}", "width"},
	{"params", "{\"widht\": \"64\"}", "widht"},
	{"params", "{\"width\": \"1e9\"}", "width"},
	{"B.name", NULL, "no buffer \"\""},
	{"B.name", "\"points.keys\"", "no buffer \"points.keys\""},
	{"B.name", "7", "no buffer"},
	{"B.name", "\"image.srgb\"", "dtype '<u8'; '|u1' would be right"},
	{"B.name", "\"cull.keep\"", "dtype"},
	{"B.name", "\"visibility.bits\"", "its shape is none of visibility.bits, which is triangles view_words"},
	{"B.file", "7", "file \"\": not the name"},
	{"B.file", "\"\"", "not the name"},
	{"B.file", "\"../good/k.npy\"", "not the name"},
	{"B.file", "\"../scene/k.npy\"", "not the name"},
	{"B.file", "\"/etc/passwd\"", "not the name"},
	{"B.file", "\"..\"", "not the name"},
	{"B.file", "\".\"", "not the name"},
	{"B.file", "\".k.npy\"", "not the name"},
	{"B.file", "\"sub/k.npy\"", "not the name"},
	{"B.file", "\"none.npy\"", "No such file"},
	{"B.file", "\"s.npy\"", "dtype '|u1'; '<u8' would be right"},
	{"B.file", "\"trace.json\"", "not a .npy file"},
	{"B.file", "\"fifo\"", "fifo: not a regular file"},
	{"B.file", "\"folder\"", "folder: not a regular file"},
	{"B.file", "\"link.npy\"", "is a link"},
	{"B.file", "\"inside.npy\"", "is a link"},
	{"B.file", "\"empty\"", "not a .npy file"},
	{"B.crop", "[0, 0, 1, 1]", "no rows and columns"},
	{"buffers", "[{\"name\": \"points.key\", \"file\": \"k.npy\"}, {\"name\": \"points.key\", \"file\": \"k.npy\"}]",
     "there twice"},
	{"buffers", "[{\"name\": \"points.key\", \"file\": null}, {\"name\": \"points.key\", \"file\": \"k.npy\"}]",
     "there twice"},
	{"buffers", "[{\"name\": \"image.srgb\", \"file\": \"four.npy\"}]", "image.srgb, which is height width 3"},
	{"buffers", "[{\"name\": \"image.srgb\", \"file\": \"flat.npy\"}]", "image.srgb, which is height width 3"},
	{"buffers", "[{\"name\": \"image.srgb\", \"file\": \"s.npy\", \"crop\": []}]", "crop is not 4 numbers"},
	{"buffers", "[{\"name\": \"image.srgb\", \"file\": \"s.npy\", \"crop\": {}}]", "crop is not 4 numbers"},
	{"buffers", "[{\"name\": \"image.srgb\", \"file\": \"s.npy\", \"crop\": [0, 0, 4]}]", "crop is not 4 numbers"},
	{"buffers", "[{\"name\": \"image.srgb\", \"file\": \"s.npy\", \"crop\": [0, 0, -4, 2]}]", "crop is not 4 numbers"},
	{"buffers", "[{\"name\": \"image.srgb\", \"file\": \"s.npy\", \"crop\": [0, 0.5, 4, 2]}]", "crop is not 4 numbers"},
	{"buffers", "[{\"name\": \"image.srgb\", \"file\": \"s.npy\", \"crop\": [\"0\", 0, 4, 2]}]",
     "crop is not 4 numbers"},
	{"buffers", "[{\"name\": \"image.srgb\", \"file\": \"s.npy\", \"crop\": [null, 0, 4, 2]}]",
     "crop is not 4 numbers"},
	{"buffers", "[{\"name\": \"image.srgb\", \"file\": \"s.npy\", \"crop\": [true, 0, 4, 2]}]",
     "crop is not 4 numbers"},
	{"buffers", "[{\"name\": \"image.srgb\", \"file\": \"s.npy\", \"crop\": [0, 0, 2, 4]}]", "not that of its crop"},
	{"buffers", "[{\"name\": \"image.srgb\", \"file\": \"s.npy\", \"crop\": [0, 99999, 4, 2]}]",
     "crop is not 4 numbers"},
};

static void wrong_values_are_refused(void **state)
{
	(void)state;
	char zero[32] = {0};
	for (u32 i = 0; i < sizeof values / sizeof *values; i++) {
		small_copy(bad, good);
		assert_int_equal(mkfifo(scratch_path("bad/fifo"), 0666), 0);
		assert_int_equal(mkdir(scratch_path("bad/folder"), 0777), 0);
		assert_int_equal(symlink("../good/k.npy", scratch_path("bad/link.npy")), 0);
		assert_int_equal(symlink("k.npy", scratch_path("bad/inside.npy")), 0);
		file_write(scratch_path("bad/empty"), "", 0);
		npy_write(scratch_path("bad/four.npy"), "'|u1'", "(2, 4, 4)", zero, 32);
		npy_write(scratch_path("bad/flat.npy"), "'|u1'", "(24,)", zero, 24);
		small_edit(bad, change, &values[i]);
		refuses(values[i].says);
	}
}

/* A name in a trace.json of version 2. */
static void change_name(json_t *root, const void *user)
{
	json_object_set_new(root, "version", json_integer(2));
	json_object_set_new(json_array_get(json_object_get(root, "buffers"), 0), "file", json_string(user));
}

static const wrong shared[] = {
	{"../scene/", NULL, "not the name"},
	{"../scene", NULL, "not the name"},
	{"../scene/.k.npy", NULL, "not the name"},
	{"../scene/..", NULL, "not the name"},
	{"../scene/../good/k.npy", NULL, "not the name"},
	{"../scene/sub/k.npy", NULL, "not the name"},
	{"../scene//k.npy", NULL, "not the name"},
	{"../scenes/k.npy", NULL, "not the name"},
	{"./../scene/k.npy", NULL, "not the name"},
	{"../bad/../scene/k.npy", NULL, "not the name"},
	{"../../scene/k.npy", NULL, "not the name"},
	{"scene/k.npy", NULL, "not the name"},
	{"/etc/passwd", NULL, "not the name"},
	{"../good/k.npy", NULL, "not the name"},
	{"../scene/none.npy", NULL, "none.npy: No such file"},
	{"../scene/link.npy", NULL, "link.npy: is a link"},
	{"../scene/sub", NULL, "sub: not a regular file"},
	{"../scene/short.npy", NULL, "16 bytes of data; its shape needs 24"},
	{"../scene/long.npy", NULL, "25 bytes of data; its shape needs 24"},
	{"../scene/other.npy", NULL, "dtype '|u1'; '<u8' would be right"},
	{"../scene/k.npy.zst", NULL, "k.npy.zst: not a file of zstd"},
	{"plain.npy.zst", NULL, "plain.npy.zst: not a file of zstd"},
};

static void taken(const char *name)
{
	ts_trace *t;
	small_edit(bad, change_name, name);
	if (ts_trace_open_folder(&t, bad) != TS_OK) fail_msg("%s", ts_error_message());
	assert_int_equal(t->item[TS_B_points_key].npy.n, 3);
	ts_trace_close(t);
}

/* The folder of the scene beside a trace: its plain files, by that one way, and only for version 2. */
static void a_shared_scene_is_read_beside(void **state)
{
	(void)state;
	char zero[32] = {0};
	small_copy(bad, good);
	file_write(scratch_path("bad/plain.npy.zst"), zero, 32);
	small_edit(bad, change_name, "../scene/k.npy");
	refuses("scene: no such folder; traces of one run share it");
	file_write(scratch_path("scene"), zero, 1);
	refuses("scene: not a folder");
	unlink(scratch_path("scene"));
	assert_int_equal(symlink("good", scratch_path("scene")), 0);
	refuses("scene: not a folder");
	unlink(scratch_path("scene"));
	small_copy(scratch_path("scene"), good);
	assert_int_equal(mkdir(scratch_path("scene/sub"), 0777), 0);
	assert_int_equal(symlink("k.npy", scratch_path("scene/link.npy")), 0);
	npy_write(scratch_path("scene/short.npy"), "'<u8'", "(3,)", zero, 16);
	npy_write(scratch_path("scene/long.npy"), "'<u8'", "(3,)", zero, 25);
	npy_write(scratch_path("scene/other.npy"), "'|u1'", "(3,)", zero, 3);
	npy_write(scratch_path("scene/k.npy.zst"), "'<u8'", "(3,)", zero, 24);
	npy_write(scratch_path("bad/12.npy.zst"), "'<u8'", "(3,)", zero, 24);
	taken("../scene/k.npy");
	taken("k.npy");
	for (u32 i = 0; i < sizeof shared / sizeof *shared; i++) {
		small_edit(bad, change_name, shared[i].key);
		refuses(shared[i].says);
	}
	/* In version 1 the end of a name says nothing. */
	ts_trace *t;
	small_edit(bad, change, &(wrong){"B.file", "\"12.npy.zst\"", NULL});
	small_edit(bad, change, &(wrong){"version", "1", NULL});
	if (ts_trace_open_folder(&t, bad) != TS_OK) fail_msg("%s", ts_error_message());
	assert_null(t->item[TS_B_points_key].unpacked);
	ts_trace_close(t);
}

static void put(const char *text, size_t bytes) { file_write(scratch_path("bad/trace.json"), text, bytes); }

/* No JSON, cut JSON, duplicate keys, other roots, too deep, too long; no regular file. */
static void wrong_texts_are_refused(void **state)
{
	(void)state;
	size_t bytes;
	small_copy(bad, good);
	char *text = file_read(scratch_path("good/trace.json"), &bytes);
	for (size_t n = 0; n < bytes - 1; n++) {
		put(text, n);
		refuses("trace.json: line ");
	}
	free(text);
	put("[]", 2);
	refuses("not an object");
	put("{\"format\": \"touchstone-trace\", \"format\": \"touchstone-trace\"}", 60);
	refuses("duplicate");
	put("{\"a\": \"\\u0000\"}", 15);
	refuses("line 1");
	put("{\"a\": \"\xff\"}", 10);
	refuses("line 1");
	enum { DEEP = 1 << 20 };
	char *deep = malloc(DEEP);
	assert_non_null(deep);
	memset(deep, '[', DEEP);
	put(deep, DEEP);
	free(deep);
	refuses("line 1");
	assert_int_equal(truncate(scratch_path("bad/trace.json"), (1 << 24) + 1), 0);
	refuses("a trace.json has at most");
	unlink(scratch_path("bad/trace.json"));
	refuses("No such file");
	assert_int_equal(symlink("../good/trace.json", scratch_path("bad/trace.json")), 0);
	refuses("is a link");
	unlink(scratch_path("bad/trace.json"));
	assert_int_equal(mkfifo(scratch_path("bad/trace.json"), 0666), 0);
	refuses("not a regular file");
}

static void wrong_layouts_are_refused(void **state)
{
	(void)state;
	static const wrong cases[] = {
		{"points.key", NULL, "is not NAME=FILE"},
		{"points.keys=k.npy", NULL, "no buffer \"points.keys\""},
		{"points.key=../good/k.npy", NULL, "not the name"},
		{"points.key=none.bin", NULL, "No such file"},
		{"cull.keep=raw.bin", NULL, "the reference lacks it"},
		{"image.srgb=raw.bin", NULL, "rows of 12"},
		{"points.key=k.npy,points.key=k.npy", NULL, "there twice"},
		{"points.key=link.bin", NULL, "is a link"},
		{"points.key=", NULL, "not the name"},
		{"=k.npy", NULL, "no buffer \"\""},
	};
	ts_trace *like, *t;
	assert_int_equal(ts_trace_open_folder(&like, good), TS_OK);
	small_copy(bad, good);
	file_write(scratch_path("bad/raw.bin"), "0123456789abcdef", 16);
	assert_int_equal(symlink("raw.bin", scratch_path("bad/link.bin")), 0);
	for (u32 i = 0; i < sizeof cases / sizeof *cases; i++) {
		if (ts_trace_open_layout(&t, bad, cases[i].key, false, like) == TS_OK) fail_msg("%s", cases[i].key);
		assert_null(t);
		says(cases[i].says);
	}
	assert_int_equal(ts_trace_open_layout(&t, bad, "points.key=raw.bin,image.srgb=s.npy", true, like), TS_OK);
	const ts_npy *raw = &t->item[TS_B_points_key].npy;
	assert_true(t->arrival && raw->n == 2 && raw->data_at == 0 && raw->n_dims == 1 && raw->shape[0] == 2);
	ts_trace_close(t);
	ts_trace_close(like);
}

/* One file, which may be a link, for the user named it. */
static void one_file_is_opened_by_its_name(void **state)
{
	(void)state;
	ts_trace *t;
	ts_buffer_id id;
	small_copy(bad, good);
	rename(scratch_path("bad/k.npy"), scratch_path("bad/11-points.key.npy"));
	assert_int_equal(symlink("11-points.key.npy", scratch_path("bad/points.key.npy")), 0);
	for (u32 i = 0; i < 2; i++) {
		assert_int_equal(
			ts_trace_open_file(&t, scratch_path(i == 0 ? "bad/11-points.key.npy" : "bad/points.key.npy"), &id), TS_OK);
		assert_true(id == TS_B_points_key && t->item[id].npy.n == 3);
		ts_reader *r = ts_trace_read(&t->item[id], id);
		assert_non_null(r);
		ts_reader_close(r);
		ts_trace_close(t);
	}
	static const char *const names[] = {"bad/s.npy",   "bad/trace.json", "bad/.npy",
	                                    "bad/11-.npy", "bad/",           "bad/points.keys.npy"};
	for (u32 i = 0; i < 6; i++) {
		assert_int_equal(ts_trace_open_file(&t, scratch_path("%s", names[i]), &id), TS_ERROR);
		says("does not say which buffer");
	}
	assert_int_equal(ts_trace_open_file(&t, scratch_path("bad/cull.keep.npy"), &id), TS_ERROR);
	says("No such file");
}

/* The folder's writer may still be there. */
static void a_link_that_takes_a_files_place_is_refused(void **state)
{
	(void)state;
	ts_trace *t;
	small_copy(bad, good);
	assert_int_equal(ts_trace_open_folder(&t, bad), TS_OK);
	assert_int_equal(unlink(scratch_path("bad/k.npy")), 0);
	assert_int_equal(symlink("../good/k.npy", scratch_path("bad/k.npy")), 0);
	assert_null(ts_trace_read(&t->item[TS_B_points_key], TS_B_points_key));
	says("k.npy: is a link");
	ts_trace_close(t);
}

int main(void)
{
	const struct CMUnitTest read[] = {
		cmocka_unit_test(a_good_trace_is_opened),
		cmocka_unit_test(wrong_values_are_refused),
		cmocka_unit_test(a_shared_scene_is_read_beside),
		cmocka_unit_test(wrong_texts_are_refused),
		cmocka_unit_test(wrong_layouts_are_refused),
		cmocka_unit_test(one_file_is_opened_by_its_name),
		cmocka_unit_test(a_link_that_takes_a_files_place_is_refused),
	};
	return cmocka_run_group_tests(read, begin, scratch_remove);
}

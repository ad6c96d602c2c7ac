/* Traces in memory as files: what is opened again is what was saved; digests are those of the files; and what cannot be
 * written is named. */
#include "model/digest.h"
#include "tests/trace/small.h"
#include "trace/item.h"
#include "trace/write.h"

static u64 keys[3] = {7, 8, 9};
static u8 pixels[2 * 4 * 3];
static ts_trace *trace;

/* Three points and a crop of a picture. */
static int begin(void **state)
{
	if (scratch_begin(state) != 0) return -1;
	for (u32 i = 0; i < sizeof pixels; i++) pixels[i] = (u8)(i * 11);
	trace = ts_trace_new("in memory");
	if (trace == NULL) return -1;
	trace->pipeline = ts_pipeline_find("reflections", "epr");
	trace->arrival = true;
	const ts_npy points = {.n_dims = 1, .shape = {3}, .n = 3};
	const ts_npy picture = {.n_dims = 3, .shape = {2, 4, 3}, .n = sizeof pixels};
	ts_status status = ts_item_put(trace, TS_B_points_key, &points, keys);
	if (status == TS_OK) status = ts_item_put(trace, TS_B_image_srgb, &picture, pixels);
	trace->item[TS_B_image_srgb].cropped = true;
	memcpy(trace->item[TS_B_image_srgb].crop, (u32[]){5, 6, 4, 2}, 4 * sizeof(u32));
	return status == TS_OK ? 0 : -1;
}

static int end(void **state)
{
	ts_trace_close(trace);
	return scratch_remove(state);
}

static ts_status save(const char *dir, const char *producer)
{
	static small_place place;
	place = (small_place){.dir = dir, .n = 0};
	assert_int_equal(mkdir(dir, 0777), 0);
	return ts_trace_save_files(trace, producer, small_take, &place);
}

static json_t *text_of(const char *dir)
{
	char path[2 * SCRATCH_PATH];
	snprintf(path, sizeof path, "%s/trace.json", dir);
	json_t *root = json_load_file(path, JSON_REJECT_DUPLICATES, NULL);
	assert_non_null(root);
	return root;
}

static void holds(const json_t *entry, const char *key, const char *expected)
{
	char *text = json_dumps(json_object_get(entry, key), JSON_COMPACT | JSON_ENCODE_ANY);
	assert_non_null(text);
	assert_string_equal(text, expected);
	free(text);
}

/* The entry's digest is that of its whole file. */
static void check_digest(const char *dir, const json_t *entry)
{
	char path[2 * SCRATCH_PATH], hex[TS_DIGEST_BYTES];
	size_t bytes;
	ts_digest digest;
	snprintf(path, sizeof path, "%s/%s", dir, json_string_value(json_object_get(entry, "file")));
	char *data = file_read(path, &bytes);
	ts_digest_begin(&digest);
	ts_digest_add(&digest, data, bytes);
	ts_digest_end(&digest, hex);
	assert_string_equal(json_string_value(json_object_get(entry, "sha256")), hex);
	free(data);
}

static void a_saved_trace_has_its_whole_text(void **state)
{
	(void)state;
	char dir[SCRATCH_PATH];
	snprintf(dir, sizeof dir, "%s", scratch_path("text"));
	assert_int_equal(save(dir, "a port"), TS_OK);
	json_t *root = text_of(dir), *buffers = json_object_get(root, "buffers");
	assert_int_equal(json_array_size(buffers), 2);
	const json_t *points = json_array_get(buffers, 0), *picture = json_array_get(buffers, 1);
	holds(points, "name", "\"points.key\"");
	holds(points, "element", "\"u64\"");
	holds(points, "shape", "[3]");
	assert_null(json_object_get(points, "crop"));
	holds(picture, "name", "\"image.srgb\"");
	holds(picture, "shape", "[2,4,3]");
	holds(picture, "crop", "[5,6,4,2]");
	check_digest(dir, points);
	check_digest(dir, picture);
	holds(root, "format", "\"touchstone-trace\"");
	holds(root, "order", "\"arrival\"");
	holds(root, "pipeline", "\"epr\"");
	holds(root, "producer", "{\"name\":\"a port\"}");
	assert_null(json_object_get(root, "arithmetic"));
	assert_null(json_object_get(root, "replayed"));
	assert_null(json_object_get(root, "params"));
	json_decref(root);
}

static void a_saved_trace_opens_the_same(void **state)
{
	(void)state;
	ts_trace *t;
	char dir[SCRATCH_PATH];
	u64 read_keys[3];
	u8 read_pixels[sizeof pixels];
	snprintf(dir, sizeof dir, "%s", scratch_path("opened"));
	trace->has_params = true;
	TS_PARAM_SET(&trace->params, width, 77);
	trace->replayed = ts_stage_find("points");
	assert_int_equal(save(dir, NULL), TS_OK);
	trace->has_params = false;
	trace->replayed = NULL;
	json_t *root = text_of(dir);
	holds(root, "replayed", "\"points\"");
	assert_true(json_is_object(json_object_get(root, "arithmetic")));
	json_decref(root);
	if (ts_trace_open_folder(&t, dir) != TS_OK) fail_msg("%s", ts_error_message());
	assert_true(t->arrival && t->has_params && TS_PARAM(&t->params, width) == 77);
	assert_memory_equal(t->producer, "touchstone ", 11);
	const ts_trace_item *picture = &t->item[TS_B_image_srgb];
	assert_true(picture->cropped && picture->crop[0] == 5 && picture->crop[1] == 6);
	assert_int_equal(ts_trace_copy(read_keys, &t->item[TS_B_points_key], TS_B_points_key), TS_OK);
	assert_int_equal(ts_trace_copy(read_pixels, picture, TS_B_image_srgb), TS_OK);
	assert_memory_equal(read_keys, keys, sizeof keys);
	assert_memory_equal(read_pixels, pixels, sizeof pixels);
	ts_trace_close(t);
}

/* Places of which one of the files is none. */
static const char *refused_at;

static const char *take_some(void *user, const char *name)
{
	if (strstr(name, refused_at) != NULL) {
		ts_fail("no place for %s", name);
		return NULL;
	}
	return small_take(user, name);
}

static void an_unwritable_file_is_named(void **state)
{
	(void)state;
	static const char *const names[] = {"points.key", "image.srgb", "trace.json"};
	char dir[SCRATCH_PATH];
	snprintf(dir, sizeof dir, "%s", scratch_path("unwritable"));
	assert_int_equal(mkdir(dir, 0777), 0);
	for (u32 i = 0; i < 3; i++) {
		small_place place = {.dir = dir, .n = 0};
		refused_at = names[i];
		assert_int_equal(ts_trace_save_files(trace, NULL, take_some, &place), TS_ERROR);
		says("no place for ");
		says(names[i]);
		assert_int_equal(place.n, i);
	}
	small_place nowhere = {.dir = "/nonexistent", .n = 0};
	assert_int_equal(ts_trace_save_files(trace, NULL, small_take, &nowhere), TS_ERROR);
	says("points.key.npy: cannot be written: No such file");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_saved_trace_has_its_whole_text),
		cmocka_unit_test(a_saved_trace_opens_the_same),
		cmocka_unit_test(an_unwritable_file_is_named),
	};
	return cmocka_run_group_tests(tests, begin, end);
}

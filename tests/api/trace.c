/* Traces in memory: what every method makes has the digests of the files of a trace, and a part of a run has the bits
 * of the whole. */
#include <sys/stat.h>
#include <unistd.h>
#include "scene/scene.h"
#include "tests/api/run.h"
#include "trace/emitted/sums.h"

typedef struct {
	ts_trace *trace;
	size_t n;
} expected;

static void compare_digest(void *user, const char *buffer, const char *hex)
{
	expected *e = user;
	char whole[65];
	done(ts_trace_digest(e->trace, buffer, whole));
	assert_string_equal(hex, whole);
	e->n++;
}

static void every_method_has_its_files_digests(void **state)
{
	(void)state;
	const ts_method_info *method;
	size_t n_buffers = 0;
	ts_scene *board;
	done(ts_scene_open(context, &board, "checkerboard:surfels=10000", params, NULL));
	for (size_t i = 0; (method = ts_method_at(i)) != NULL; i++) {
		const ts_scene *own = strcmp(method->effect, "surfels") == 0 ? board : scene;
		ts_trace *trace;
		ts_sums sums;
		const ts_buffer_info *buffer;
		done(ts_trace_run(context, &trace, own, params, method->effect, method->name, NULL));
		done(ts_sums_of(&sums, ts_pipeline_find(method->effect, method->name), own, params, &(ts_how){.threads = 1}));
		for (size_t id = 0; (buffer = ts_buffer_at(id)) != NULL; id++) {
			char hex[65] = "";
			if (sums.hex[id][0] == 0) {
				refused(ts_trace_digest(trace, buffer->name, hex), buffer->name);
				continue;
			}
			done(ts_trace_digest(trace, buffer->name, hex));
			if (strcmp(hex, sums.hex[id]) != 0) fail_msg("%s %s: %s", method->effect, method->name, buffer->name);
			n_buffers++;
		}
		expected e = {.trace = trace};
		if (i % 5 == 0) {
			done(ts_run_digests(context, own, params, method->effect, method->name, compare_digest, &e));
			assert_true(e.n > 10);
		}
		ts_trace_close(trace);
	}
	ts_scene_free(board);
	assert_true(n_buffers > 400);
}

static void a_part_has_the_bits_of_all(void **state)
{
	(void)state;
	ts_params *more;
	done(ts_params_copy(&more, params));
	done(ts_params_set(more, "reflectors.count", "7")); /* several batches */
	ts_scene *hall = small_scene(context, more);
	ts_trace *whole = small_trace(context, hall, more, "mvr"), *part;
	ts_run_options options = {.bytes = sizeof options, .buffers = "image.srgb,cube_size.face"};
	done(ts_trace_run(context, &part, hall, more, "reflections", "mvr", &options));
	const char *const names[] = {"image.srgb", "cube_size.face"};
	for (size_t i = 0; i < 2; i++) {
		const ts_buffer_view *a = ts_trace_buffer(whole, names[i]), *b = ts_trace_buffer(part, names[i]);
		assert_true(a != NULL && b != NULL);
		assert_int_equal(bytes_of(a), bytes_of(b));
		assert_memory_equal(a->data, b->data, bytes_of(a));
	}
	assert_null(ts_trace_buffer(part, "eye.depth_triangle"));
	assert_int_equal(ts_trace_counter(whole, "shading operations"), ts_trace_counter(part, "shading operations"));
	assert_true(ts_trace_counter(whole, "shading operations") > 0);
	assert_int_equal(ts_trace_counter(whole, "no such counter"), 0);
	ts_trace_close(part);
	options.buffers = "image.srgb,points.record";
	refused(ts_trace_run(context, &part, hall, more, "reflections", "mvr", &options), "makes no points.record");
	assert_null(part);
	options.buffers = "splat.tie";
	refused(ts_trace_run(context, &part, hall, more, "reflections", "epr", &options), "makes no splat.tie");
	options.buffers = "";
	refused(ts_trace_run(context, &part, hall, more, "reflections", "mvr", &options), "names none");
	options.buffers = "image";
	refused(ts_trace_run(context, &part, hall, more, "reflections", "mvr", &options), "no buffer \"image\"");
	options = (ts_run_options){.bytes = sizeof options, .buffers = "image.srgb", .margins = 1};
	refused(ts_trace_run(context, &part, hall, more, "reflections", "mvr", &options), "margins");
	ts_trace_close(whole);
	ts_scene_free(hall);
	ts_params_free(more);
}

static void an_image_has_its_shape_and_pixels(void **state)
{
	(void)state;
	ts_trace *trace;
	const ts_buffer_view *image = ts_trace_buffer(reference, "image.srgb");
	assert_non_null(image);
	assert_int_equal(image->n_dims, 3);
	assert_int_equal(image->shape[0], 36);
	assert_int_equal(image->shape[1], 64);
	assert_int_equal(image->shape[2], 3);
	assert_string_equal(image->element, "u8");
	const uint8_t *pixels = image->data;
	assert_false(memcmp(pixels, pixels + 3, 64 * 36 * 3 - 3) == 0);
	refused(ts_trace_run(context, &trace, scene, params, "reflections", "magic", NULL),
	        "by magic: no such method; there are epr, mvr");
	refused(ts_trace_run(context, &trace, scene, params, "magic", "mvr", NULL),
	        "no effect \"magic\"; ts_method_at names all");
	assert_null(trace);
}

static void only_what_fits_is_put(void **state)
{
	(void)state;
	ts_trace *own;
	done(ts_trace_candidate(context, &own, reference, 0));
	uint64_t shape[4] = {36, 64}, keys[36 * 64 + 1] = {7};
	assert_null(ts_trace_buffer(own, "eye.depth_triangle"));
	assert_false(ts_trace_has(own, "eye.depth_triangle"));
	done(ts_trace_put(own, "eye.depth_triangle", 2, shape, keys, 36 * 64 * 8));
	assert_ptr_equal(ts_trace_buffer(own, "eye.depth_triangle")->data, keys);
	done(ts_trace_put(own, "eye.depth_triangle", 2, shape, keys + 1, 36 * 64 * 8));
	assert_ptr_equal(ts_trace_buffer(own, "eye.depth_triangle")->data, keys + 1);
	assert_true(ts_trace_has(own, "eye.depth_triangle"));
	refused(ts_trace_put(own, "eye.depth", 2, shape, keys, 36 * 64 * 8), "no buffer \"eye.depth\"");
	refused(ts_trace_put(own, "eye.depth_triangle", 2, shape, keys, 36 * 64 * 8 - 1), "bytes");
	refused(ts_trace_put(own, "eye.depth_triangle", 5, shape, keys, 36 * 64 * 8), "dimensions");
	refused(ts_trace_put(own, "eye.depth_triangle", 1, &shape[0], keys, 36 * 8), "shape");
	refused(ts_trace_put(own, "eye.depth_triangle", 2, shape, (const char *)keys + 4, 36 * 64 * 8), "aligned");
	refused(ts_trace_put(own, "image.srgb", 3, (uint64_t[]){36, 64, 4}, keys, 36 * 64 * 4), "shape");
	shape[0] = UINT64_MAX;
	refused(ts_trace_put(own, "eye.depth_triangle", 2, shape, keys, 8), "bytes");
	assert_ptr_equal(ts_trace_buffer(own, "eye.depth_triangle")->data, keys + 1);
	shape[0] = 0;
	done(ts_trace_put(own, "points.record", 1, shape, NULL, 0));
	assert_int_equal(count_of(ts_trace_buffer(own, "points.record")), 0);
	ts_trace_close(own);
	refused(ts_trace_put(reference, "eye.depth_triangle", 2, (uint64_t[]){36, 64}, keys, 36 * 64 * 8), "no candidate");
}

static void write_file(const char *path, const char *head, const void *data, size_t bytes)
{
	FILE *file = fopen(path, "wb");
	assert_non_null(file);
	assert_true(fwrite(head, 1, strlen(head), file) == strlen(head) && fwrite(data, 1, bytes, file) == bytes);
	assert_int_equal(fclose(file), 0);
}

/* Files without a trace.json: bare elements by a list, and one .npy by its name; looking reads nothing. */
static void files_are_opened_by_a_list(void **state)
{
	(void)state;
	char folder[FOLDER], path[PATH], head[129];
	make_folder(folder);
	ts_trace *own;
	const ts_buffer_view *keys = ts_trace_buffer(reference, "eye.depth_triangle");
	snprintf(path, sizeof path, "%s/keys.bin", folder);
	write_file(path, "", keys->data, bytes_of(keys));
	done(ts_trace_open_list(context, &own, folder, "eye.depth_triangle=keys.bin", 1, reference));
	const ts_trace_info *about = ts_trace_about(own);
	assert_string_equal(about->folder, folder);
	assert_string_equal(about->effect, "reflections");
	assert_string_equal(about->method, "epr");
	assert_true(about->arrival != 0 && ts_trace_about(reference)->arrival == 0);
	assert_true(ts_trace_about(reference)->has_params != 0);
	const ts_buffer_view *look = ts_trace_look(own, "eye.depth_triangle");
	assert_null(look->data);
	assert_int_equal(count_of(look), 36 * 64);
	assert_memory_equal(ts_trace_buffer(own, "eye.depth_triangle")->data, keys->data, bytes_of(keys));
	assert_non_null(ts_trace_look(own, "eye.depth_triangle")->data);
	assert_null(ts_trace_look(own, "image.srgb"));
	ts_trace_close(own);
	refused(ts_trace_open_list(context, &own, folder, "eye.depth_triangle=none.bin", 0, reference), "none.bin");
	assert_null(own);
	unlink(path);

	snprintf(head, sizeof head, "\x93NUMPY\x01%c\x76%c{'descr': '<u8', 'fortran_order': False, 'shape': (36, 64), }",
	         'x', 'x');
	memset(head + strlen(head), ' ', 127 - strlen(head));
	head[127] = '\n';
	head[128] = 0;
	snprintf(path, sizeof path, "%s/04-eye.depth_triangle.npy", folder);
	write_file(path, head, keys->data, bytes_of(keys));
	FILE *file = fopen(path, "r+b");
	assert_non_null(file);
	assert_true(fseek(file, 7, SEEK_SET) == 0 && fputc(0, file) == 0 && fseek(file, 9, SEEK_SET) == 0 &&
	            fputc(0, file) == 0);
	assert_int_equal(fclose(file), 0);
	done(ts_trace_open_npy(context, &own, path));
	assert_memory_equal(ts_trace_buffer(own, "eye.depth_triangle")->data, keys->data, bytes_of(keys));
	assert_false(ts_trace_has(own, "image.srgb"));
	ts_trace_close(own);
	unlink(path);
	refused(ts_trace_open_npy(context, &own, path), path);
	refused(ts_trace_open_npy(context, &own, "/tmp/magic.npy"), "which buffer");
	remove_folder(folder);
}

/* A trace that cannot be saved leaves nothing behind, and the next one is saved. */
static void leaves_nothing(const char *folder)
{
	char from[PATH], to[PATH];
	ts_trace *own;
	struct stat info;
	snprintf(from, sizeof from, "%s/from", folder);
	snprintf(to, sizeof to, "%s/to", folder);
	done(ts_trace_save(context, reference, from, NULL));
	done(ts_trace_open(context, &own, from));
	remove_folder(from);
	refused(ts_trace_save(context, own, to, NULL), from);
	assert_int_equal(stat(to, &info), -1);
	done(ts_trace_save(context, reference, to, NULL));
	assert_int_equal(stat(to, &info), 0);
	ts_trace_close(own);
}

/* A candidate that is saved is the same when it is opened, and says who made it; so is what a replayed stage made. */
static void a_saved_candidate_is_the_same_again(void **state)
{
	(void)state;
	char folder[FOLDER], path[PATH];
	make_folder(folder);
	ts_trace *own, *made;
	ts_verdicts *verdicts;
	const ts_buffer_view *keys = ts_trace_buffer(reference, "eye.depth_triangle");
	uint64_t *copy = malloc(bytes_of(keys));
	assert_non_null(copy);
	memcpy(copy, keys->data, bytes_of(keys));
	copy[100] ^= 2;
	snprintf(path, sizeof path, "%s/port", folder);
	done(ts_trace_candidate(context, &own, reference, 1));
	put(own, keys, copy);
	done(ts_trace_save(context, own, path, "my port"));
	refused(ts_trace_save(context, own, path, NULL), path);
	ts_trace_close(own);
	done(ts_trace_open(context, &own, path));
	assert_int_equal(strncmp(ts_trace_about(own)->producer, "my port", 7), 0);
	assert_true(ts_trace_about(own)->arrival != 0 && !ts_trace_has(own, "image.srgb"));
	done(ts_trace_match(reference, own));
	assert_memory_equal(ts_trace_buffer(own, "eye.depth_triangle")->data, copy, bytes_of(keys));
	done(ts_trace_replay(context, &made, "eye", reference, NULL));
	snprintf(path, sizeof path, "%s/made", folder);
	done(ts_trace_save(context, made, path, NULL));
	ts_trace_close(made);
	done(ts_trace_open(context, &made, path));
	done(ts_compare(context, &verdicts, reference, made, NULL));
	ts_verdicts_free(verdicts);
	ts_trace_close(made);
	refused(ts_trace_save(context, own, "/proc/none/trace", NULL), "/proc/none/trace");
	ts_trace_close(own);
	leaves_nothing(folder);

	/* A trace of a method matches none of another; a stage that parameters leave out was not taken. */
	own = small_trace(context, scene, params, "mvr");
	refused(ts_trace_match(reference, own), "mvr");
	assert_true(ts_trace_takes(reference, "splat") && !ts_trace_takes(reference, "lookup.third"));
	assert_false(ts_trace_takes(reference, "eye.margin") || ts_trace_takes(reference, "magic"));
	ts_trace_close(own);
	remove_folder(folder);
	free(copy);
}

/* A trace on disk, compressed or not, is that in memory; a folder that holds something stays as it is. */
static void a_written_trace_is_that_in_memory(void **state)
{
	(void)state;
	char folder[FOLDER], path[PATH];
	make_folder(folder);
	ts_trace *written;
	ts_verdicts *verdicts;
	snprintf(path, sizeof path, "%s/made/trace", folder);
	for (int compress = 0; compress < 2; compress++) {
		const ts_write_options options = {.bytes = sizeof options, .compress = compress};
		done(ts_trace_write(context, path, scene, params, "reflections", "epr", &options));
		done(ts_trace_open(context, &written, path));
		done(ts_compare(context, &verdicts, reference, written, NULL));
		for (size_t i = 0; ts_verdicts_at(verdicts, i) != NULL; i++) {
			assert_int_equal(ts_verdicts_at(verdicts, i)->judgement, TS_SAME);
		}
		ts_verdicts_free(verdicts);
		assert_int_equal(ts_trace_about(written)->has_params, 1);
		ts_trace_close(written);
		refused(ts_trace_write(context, path, scene, params, "reflections", "mvr", NULL), path);
		done(ts_trace_open(context, &written, path));
		assert_string_equal(ts_trace_about(written)->method, "epr");
		ts_trace_close(written);
		remove_folder(path);
	}
	const ts_write_options margins = {.bytes = sizeof margins, .margins = 1};
	done(ts_trace_write(context, path, scene, params, "reflections", "epr", &margins));
	done(ts_trace_open(context, &written, path));
	assert_true(ts_trace_has(written, "eye.margin"));
	ts_trace_close(written);
	refused(ts_trace_write(context, "/proc/none/trace", scene, params, "reflections", "epr", NULL), "/proc/none/trace");
	refused(ts_trace_write(context, path, scene, params, "reflections", "magic", NULL), "magic");
	remove_folder(folder);
}

/* The call is asked, and ends where it hears yes. */
#define ENDS(h, call, release) \
	do { \
		h = (ending_host){.end_at = 0}; \
		done(call); \
		release; \
		if (h.asked < 1) fail_msg("%s: not asked", #call); \
		h = (ending_host){.end_at = 1}; \
		refused(call, "cancelled"); \
		assert_int_equal(h.asked, 1); \
	} while (0)

static void what_is_written_and_judged_can_be_ended(void **state)
{
	(void)state;
	ending_host h = {.end_at = 0};
	char folder[FOLDER], path[PATH];
	ts_context *own;
	ts_scene *room;
	ts_trace *trace, *stored;
	ts_verdicts *verdicts;
	ts_params *large;
	const ts_context_options options = {.bytes = sizeof options, .threads = 2, .user = &h, .cancelled = asked_to_end};
	make_folder(folder);
	snprintf(path, sizeof path, "%s/saved", folder);
	done(ts_params_copy(&large, params));
	done(ts_params_set(large, "width", "960"));
	done(ts_params_set(large, "height", "540"));
	done(ts_context_open(&own, &options));
	done(ts_scene_open(own, &room, SMALL, large, NULL));
	done(ts_trace_run(own, &trace, room, large, "reflections", "mvr", NULL));
	ENDS(h, ts_trace_save(own, trace, path, NULL), remove_folder(path));
	h.end_at = 0;
	done(ts_trace_save(own, trace, path, NULL));
	done(ts_trace_open(own, &stored, path));
	ENDS(h, ts_compare(own, &verdicts, trace, stored, NULL), ts_verdicts_free(verdicts));
	ts_trace_close(stored);
	ts_trace_close(trace);
	ts_scene_free(room);
	ts_context_close(own);
	ts_params_free(large);
	remove_folder(folder);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_written_trace_is_that_in_memory),
		cmocka_unit_test(a_saved_candidate_is_the_same_again),
		cmocka_unit_test(files_are_opened_by_a_list),
		cmocka_unit_test(every_method_has_its_files_digests),
		cmocka_unit_test(a_part_has_the_bits_of_all),
		cmocka_unit_test(an_image_has_its_shape_and_pixels),
		cmocka_unit_test(only_what_fits_is_put),
		cmocka_unit_test(what_is_written_and_judged_can_be_ended),
	};
	return cmocka_run_group_tests(tests, run_begin, run_end);
}

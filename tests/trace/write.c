/* What a trace holds: the same files as the digests say, each by its own name; whole, of some stages, or cropped. */
#include "model/digest.h"
#include "tests/trace/small.h"
#include "trace/emitted/sums.h"
#include "trace/read.h"

static ts_scene *scene;
static ts_params params;

static int begin(void **state)
{
	params = small_params();
	if (scratch_begin(state) != 0) return -1;
	scene = small_scene(&params);
	return 0;
}

static int end(void **state)
{
	ts_scene_free(scene);
	return scratch_remove(state);
}

static void digest_of(char hex[TS_DIGEST_BYTES], const char *path)
{
	size_t bytes;
	ts_digest digest;
	char *data = file_read(path, &bytes);
	ts_digest_begin(&digest);
	ts_digest_add(&digest, data, bytes);
	ts_digest_end(&digest, hex);
	free(data);
}

static json_t *buffers_of(json_t **root, const char *dir)
{
	char path[2 * SCRATCH_PATH];
	snprintf(path, sizeof path, "%s/trace.json", dir);
	*root = json_load_file(path, JSON_REJECT_DUPLICATES, NULL);
	json_t *buffers = json_object_get(*root, "buffers");
	assert_true(json_is_array(buffers));
	return buffers;
}

/* Every entry's file has its digest and the digest of a run without files. Returns how many have files. */
static u32 check_digests(const char *dir, const ts_sums *sums)
{
	json_t *root, *buffers = buffers_of(&root, dir), *entry;
	size_t i;
	u32 n = 0;
	json_array_foreach (buffers, i, entry) {
		char hex[TS_DIGEST_BYTES], path[3 * SCRATCH_PATH];
		ts_buffer_id id;
		const char *sha256 = json_string_value(json_object_get(entry, "sha256"));
		const char *file = json_string_value(json_object_get(entry, "file"));
		assert_true(ts_trace_find(&id, json_string_value(json_object_get(entry, "name"))));
		if (sums != NULL) assert_string_equal(sha256, sums->hex[id]);
		if (file == NULL) continue;
		snprintf(path, sizeof path, "%s/%s", dir, file);
		digest_of(hex, path);
		assert_string_equal(sha256, hex);
		n++;
	}
	json_decref(root);
	return n;
}

static void traced(const char *name, const char *method, const ts_params *p, ts_trace_options options, u32 least)
{
	ts_sums sums;
	char dir[SCRATCH_PATH];
	snprintf(dir, sizeof dir, "%s", scratch_path("%s", name));
	small_trace(dir, method, scene, p, options);
	ts_how how = {.threads = 1, .no_fast_paths = true};
	assert_int_equal(ts_sums_of(&sums, ts_pipeline_find("reflections", method), scene, p, &how), TS_OK);
	bool cropped = options.crop[2] != 0;
	assert_true(check_digests(dir, cropped ? NULL : &sums) >= least);
	ts_trace *trace;
	if (ts_trace_open_folder(&trace, dir) != TS_OK) fail_msg("%s", ts_error_message());
	ts_trace_close(trace);
}

static void every_file_has_its_digest(void **state)
{
	(void)state;
	traced("epr", "epr", &params, (ts_trace_options){.place = NULL}, 40);
}

/* The batches of one reflector are one file; also where the last reflectors are out of sight. */
static void batches_of_a_reflector_are_one_file(void **state)
{
	(void)state;
	traced("mvr", "mvr", &params, (ts_trace_options){.place = NULL}, 20);
	ts_params p;
	ts_params_default(&p);
	p.width = 96;
	p.height = 54;
	p.cube_max_px = 16;
	p.eye_fov = 20;
	p.eye_distance = 0;
	p.reflectors_count = 6;
	p.mvr_faces = 1;
	ts_scene *three = scene;
	scene = small_scene(&p);
	traced("unseen", "mvr", &p, (ts_trace_options){.place = NULL}, 20);
	ts_trace *trace;
	assert_int_equal(ts_trace_open_folder(&trace, scratch_path("unseen")), TS_OK);
	size_t bytes;
	char *faces = file_read(trace->item[TS_B_cube_size_face].path, &bytes);
	const ts_face *cubes = (const ts_face *)(faces + trace->item[TS_B_cube_size_face].npy.data_at);
	u64 texels = 0;
	for (u32 r = 0; r < 6; r++) texels += 6ull * cubes[r].n * cubes[r].n;
	assert_int_equal(cubes[5].n, 0);
	assert_int_equal(trace->item[TS_B_cube_face_depth_triangle].npy.n, texels);
	free(faces);
	ts_trace_close(trace);
	ts_scene_free(scene);
	scene = three;
}

static void buffers_left_out_have_no_file(void **state)
{
	(void)state;
	ts_trace_options options = {.place = NULL};
	for (u32 id = 0; id < TS_N_BUFFERS; id++) options.without[id] = id != TS_B_points_key && id != TS_B_image_srgb;
	traced("some", "epr", &params, options, 2);
	json_t *root, *buffers = buffers_of(&root, scratch_path("some"));
	assert_true(json_array_size(buffers) >= 40);
	json_decref(root);
	assert_true(access(scratch_path("some/00-scene.texel.npy"), F_OK) != 0);
	assert_true(access(scratch_path("some/11-points.key.npy"), F_OK) == 0);
}

static void crops_hold_rows_of_the_whole(void **state)
{
	(void)state;
	traced("crop", "epr", &params, (ts_trace_options){.crop = {5, 7, 20, 11}}, 40);
	ts_trace *whole, *part;
	assert_int_equal(ts_trace_open_folder(&whole, scratch_path("epr")), TS_OK);
	assert_int_equal(ts_trace_open_folder(&part, scratch_path("crop")), TS_OK);
	static const ts_buffer_id ids[] = {TS_B_eye_depth_triangle, TS_B_image_radiance, TS_B_image_srgb};
	for (u32 i = 0; i < 3; i++) {
		const ts_trace_item *a = &whole->item[ids[i]], *b = &part->item[ids[i]];
		size_t bytes, row = ts_buffer_table[ids[i]].element_bytes * (a->npy.n_dims > 2 ? 3 : 1);
		assert_true(b->cropped && b->npy.shape[0] == 11 && b->npy.shape[1] == 20);
		char *all = file_read(a->path, &bytes), *some = file_read(b->path, &bytes);
		for (u32 y = 0; y < 11; y++) {
			assert_memory_equal(all + a->npy.data_at + ((y + 7) * 64 + 5) * row, some + b->npy.data_at + y * 20 * row,
			                    20 * row);
		}
		free(all);
		free(some);
	}
	assert_false(part->item[TS_B_mirror_pixel_record].cropped);
	ts_trace_close(whole);
	ts_trace_close(part);
}

static const char *file_of(json_t *buffers, const char *name)
{
	json_t *entry;
	size_t i;
	json_array_foreach (buffers, i, entry) {
		if (strcmp(json_string_value(json_object_get(entry, "name")), name) == 0) {
			return json_string_value(json_object_get(entry, "file"));
		}
	}
	return NULL;
}

static json_int_t version_of(const json_t *root) { return json_integer_value(json_object_get(root, "version")); }

/* Traces of one run name what the first of them wrote, but for a buffer of the scene that is another. */
static void traces_of_a_run_share_their_scene(void **state)
{
	(void)state;
	static const char *const methods[] = {"epr", "ivir", "mvr"}, *const folders[] = {"run/1", "run/2", "run/3"};
	static ts_trace_shared shared;
	ts_trace_options options = {.shared = &shared};
	assert_int_equal(mkdir(scratch_path("run"), 0777), 0);
	assert_int_equal(mkdir(scratch_path("run/scene"), 0777), 0);
	ts_material first = scene->materials[0];
	for (u32 i = 0; i < 3; i++) {
		char dir[SCRATCH_PATH];
		json_t *root;
		snprintf(dir, sizeof dir, "%s", scratch_path("%s", folders[i]));
		scene->materials[0].emissive[0] += i == 1 ? 1 : 0;
		small_trace(dir, methods[i], scene, &params, options);
		scene->materials[0] = first;
		json_t *buffers = buffers_of(&root, dir);
		assert_int_equal(version_of(root), 2);
		assert_string_equal(file_of(buffers, "scene.texel"), "../scene/00-scene.texel.npy");
		assert_string_equal(file_of(buffers, "scene.material"),
		                    i == 1 ? "00-scene.material.npy" : "../scene/00-scene.material.npy");
		assert_string_equal(file_of(buffers, "eye.view"), "01-eye.view.npy");
		json_decref(root);
		assert_true(access(scratch_path("%s/00-scene.texel.npy", folders[i]), F_OK) != 0);
		assert_true(check_digests(dir, NULL) >= 20);
		ts_trace *trace;
		if (ts_trace_open_folder(&trace, dir) != TS_OK) fail_msg("%s", ts_error_message());
		ts_trace_close(trace);
	}
}

/* The whole of an item, by free(). */
static void *copy_of(const ts_trace_item *item, ts_buffer_id id)
{
	void *data = malloc((size_t)item->npy.n * ts_buffer_table[id].element_bytes + 1);
	assert_non_null(data);
	if (ts_trace_copy(data, item, id) != TS_OK) fail_msg("%s", ts_error_message());
	return data;
}

/* Compressed, cropped and in batches: what is read is what plain files hold, and the digests are theirs. */
static void compressed(const char *name, const char *method, ts_trace_options options)
{
	ts_trace *plain, *packed;
	json_t *roots[2];
	small_trace(scratch_path("%s-plain", name), method, scene, &params, options);
	options.compress = true;
	small_trace(scratch_path("%s-packed", name), method, scene, &params, options);
	json_t *a = buffers_of(&roots[0], scratch_path("%s-plain", name));
	json_t *b = buffers_of(&roots[1], scratch_path("%s-packed", name)), *entry;
	assert_true(version_of(roots[0]) == 1 && version_of(roots[1]) == 2);
	size_t i;
	json_array_foreach (a, i, entry) {
		const char *text = json_string_value(json_object_get(entry, "sha256"));
		assert_string_equal(text, json_string_value(json_object_get(json_array_get(b, i), "sha256")));
	}
	assert_int_equal(ts_trace_open_folder(&plain, scratch_path("%s-plain", name)), TS_OK);
	if (ts_trace_open_folder(&packed, scratch_path("%s-packed", name)) != TS_OK) fail_msg("%s", ts_error_message());
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		const ts_trace_item *in = &plain->item[id], *out = &packed->item[id];
		assert_true((in->path != NULL) == (out->path != NULL));
		if (in->path == NULL) continue;
		assert_true(in->npy.n == out->npy.n && out->unpacked != NULL && in->unpacked == NULL);
		void *x = copy_of(in, (ts_buffer_id)id), *y = copy_of(out, (ts_buffer_id)id);
		assert_memory_equal(x, y, (size_t)in->npy.n * ts_buffer_table[id].element_bytes);
		free(x);
		free(y);
	}
	ts_trace_close(plain);
	ts_trace_close(packed);
	json_decref(roots[0]);
	json_decref(roots[1]);
}

static void compressed_files_hold_what_plain_ones_do(void **state)
{
	(void)state;
	compressed("whole", "epr", (ts_trace_options){.crop = {5, 7, 20, 11}});
	compressed("batches", "mvr", (ts_trace_options){.place = NULL});
}

static const char *nowhere(void *user, const char *name)
{
	(void)user;
	return name[0] == 't' ? "/nonexistent/trace.json" : "/nonexistent/x.npy";
}

static const char *full(void *user, const char *name)
{
	(void)user;
	(void)name;
	return "/dev/full";
}

static const char *no_place(void *user, const char *name)
{
	(void)user;
	ts_fail("no place for %s", name);
	return NULL;
}

static void an_unwritable_place_is_an_error(void **state)
{
	(void)state;
	ts_run run;
	ts_trace_writer *writer;
	ts_run_begin(&run, scene, &params, 1);
	run.traced = true;
	ts_trace_options options = {.place = nowhere};
	const ts_pipeline *epr = ts_pipeline_find("reflections", "epr");
	assert_int_equal(ts_trace_write_begin(&writer, epr, &run, &options), TS_ERROR);
	assert_null(writer);
	says("/nonexistent/x.npy: cannot be written: No such file");
	options.place = full;
	assert_int_equal(ts_trace_write_begin(&writer, epr, &run, &options), TS_ERROR);
	says("/dev/full: cannot be written: No space left");
	options.place = no_place;
	assert_int_equal(ts_trace_write_begin(&writer, epr, &run, &options), TS_ERROR);
	assert_null(writer);
	says("no place for 00-scene.");
	ts_run_end(&run);
}

static void estimates_leave_out_what_is_not_written(void **state)
{
	(void)state;
	ts_trace_options all = {.place = NULL}, none = {.place = NULL};
	memset(none.without, 1, sizeof none.without);
	const ts_pipeline *epr = ts_pipeline_find("reflections", "epr");
	assert_true(ts_trace_estimate(epr, scene, &params, &all) > 7u << 20);
	assert_true(ts_trace_estimate(epr, scene, &params, &none) == 0);
}

static json_int_t planned(const json_t *root, const char *name)
{
	const json_t *value = json_object_get(json_object_get(root, "plan"), name);
	assert_true(json_is_integer(value));
	return json_integer_value(value);
}

/* Parameters say what was typed, the plan what follows from it: all cubes of MVR as large as face_max. */
static void the_plan_says_what_follows_from_parameters(void **state)
{
	(void)state;
	json_t *root;
	small_trace(scratch_path("planned"), "mvr", scene, &params, (ts_trace_options){.place = NULL});
	buffers_of(&root, scratch_path("planned"));
	const json_t *face = json_object_get(json_object_get(root, "params"), "cube.px");
	assert_string_equal(json_string_value(face), "0");
	assert_int_equal(json_object_size(json_object_get(root, "plan")), TS_PLAN_ROWS);
	assert_int_equal(planned(root, "units"), 3);
	assert_int_equal(planned(root, "offscreen.side"), 32);
	assert_int_equal(planned(root, "offscreen.all"), 1);
	json_decref(root);
}

int main(void)
{
	const struct CMUnitTest write[] = {
		cmocka_unit_test(every_file_has_its_digest),
		cmocka_unit_test(batches_of_a_reflector_are_one_file),
		cmocka_unit_test(buffers_left_out_have_no_file),
		cmocka_unit_test(crops_hold_rows_of_the_whole),
		cmocka_unit_test(an_unwritable_place_is_an_error),
		cmocka_unit_test(estimates_leave_out_what_is_not_written),
		cmocka_unit_test(the_plan_says_what_follows_from_parameters),
		cmocka_unit_test(traces_of_a_run_share_their_scene),
		cmocka_unit_test(compressed_files_hold_what_plain_ones_do),
	};
	return cmocka_run_group_tests(write, begin, end);
}

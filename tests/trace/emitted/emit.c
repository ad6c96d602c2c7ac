/* The files of a run: the dtypes of buffers, and the parts in which their data come. */
#include "tests/trace/folder.h"
#include "tests/trace/small.h"
#include "trace/emitted/emit.h"

typedef struct {
	u32 n_begun[TS_N_BUFFERS];
	u64 bytes[TS_N_BUFFERS], whole[TS_N_BUFFERS];
	u32 fail_after, n;
} taken;

static ts_status take(void *user, const ts_chunk *chunk)
{
	taken *t = user;
	u64 n;
	if (++t->n == t->fail_after) return ts_fail("no more");
	assert_true(ts_shape_count(&n, chunk->n_dims, chunk->shape));
	u64 whole = n * ts_buffer_table[chunk->id].element_bytes;
	t->n_begun[chunk->id] += chunk->first;
	assert_int_equal(t->n_begun[chunk->id], 1);
	assert_true(chunk->first || t->whole[chunk->id] == whole);
	t->whole[chunk->id] = whole;
	t->bytes[chunk->id] += chunk->bytes;
	return TS_OK;
}

static ts_status stage(const ts_run *run, const ts_stage *s, void *user) { return ts_emit_stage(run, s, take, user); }

static ts_status offer(taken *t, const char *method, const ts_params *params)
{
	ts_run run;
	ts_scene *scene = small_scene(params);
	ts_run_begin(&run, scene, params, 2);
	run.traced = run.lean = true;
	run.hook = stage;
	run.hook_user = t;
	ts_status status = ts_emit_scene(&run, take, t);
	if (status == TS_OK) status = ts_pipeline_run(ts_pipeline_find("reflections", method), &run);
	ts_run_end(&run);
	ts_scene_free(scene);
	return status;
}

static void parts_add_up_to_their_shape(void **state)
{
	(void)state;
	for (u32 m = 0; m < 2; m++) {
		ts_params params = small_params();
		params.reflectors_count = 1 + 2 * m;
		taken t = {.n = 0};
		const char *method = m == 0 ? "epr" : "mvr";
		assert_int_equal(offer(&t, method, &params), TS_OK);
		for (u32 id = 0; id < TS_N_BUFFERS; id++) {
			bool scene = ts_emit_is_scene((ts_buffer_id)id);
			assert_int_equal(scene, strncmp(ts_buffer_table[id].name, "scene.", 6) == 0);
			assert_true(t.bytes[id] == t.whole[id]);
			bool made = scene || ts_emit_number(ts_pipeline_find("reflections", method), (ts_buffer_id)id) != 0;
			assert_true(made || t.n_begun[id] == 0);
		}
		assert_true(t.bytes[TS_B_image_srgb] == 64 * 36 * 3 && t.n_begun[TS_B_scene_vertex] == 1);
		assert_int_equal(t.n_begun[TS_B_cube_face_mip], m);
	}
}

static void a_failure_ends_the_files(void **state)
{
	(void)state;
	ts_params params = small_params();
	taken at_once = {.fail_after = 1}, later = {.fail_after = 20};
	assert_int_equal(offer(&at_once, "epr", &params), TS_ERROR);
	says("no more");
	assert_int_equal(offer(&later, "epr", &params), TS_ERROR);
	assert_int_equal(later.n, 20);
}

static void names_begin_with_their_stages_number(void **state)
{
	(void)state;
	char name[TS_EMIT_NAME];
	const ts_pipeline *epr = ts_pipeline_find("reflections", "epr"), *mvr = ts_pipeline_find("reflections", "mvr");
	ts_emit_name(name, epr, TS_B_scene_vertex);
	assert_string_equal(name, "00-scene.vertex.npy");
	ts_emit_name(name, epr, TS_B_eye_depth_triangle);
	assert_string_equal(name, "04-eye.depth_triangle.npy");
	assert_int_equal(ts_emit_number(epr, TS_B_cube_face_mip), 0);
	assert_int_equal(ts_emit_number(mvr, TS_B_cube_face_mip), 7);
	assert_int_equal(ts_emit_number(epr, TS_B_eye_view), 1);
}

/* All buffers once: those that no step makes in their order, then step by step; which is the order of the numbers. */
static void the_order_is_that_of_the_numbers(void **state)
{
	(void)state;
	for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) {
		ts_buffer_id ids[TS_N_BUFFERS];
		bool seen[TS_N_BUFFERS] = {false};
		memset(ids, 0xff, sizeof ids);
		ts_emit_order(ids, *at);
		for (u32 i = 0; i < TS_N_BUFFERS; i++) {
			assert_true(ids[i] < TS_N_BUFFERS && !seen[ids[i]]);
			seen[ids[i]] = true;
			if (i == 0) continue;
			u32 before = ts_emit_number(*at, ids[i - 1]), number = ts_emit_number(*at, ids[i]);
			bool none = strcmp(ts_emit_maker(*at, ids[i]), "scene") == 0;
			assert_true(before <= number && (number == 0 || !none) && (!none || ids[i - 1] < ids[i]));
		}
	}
}

/* Sizes of the types in a dtype must add up to the element: no padding that records.def does not name. */
static void dtypes_are_as_wide_as_their_elements(void **state)
{
	(void)state;
	char descr[TS_NPY_DESCR];
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		size_t bytes = 0;
		ts_npy_descr(descr, (ts_buffer_id)id);
		for (const char *at = descr; (at = strpbrk(at, "<|")) != NULL; at++) {
			unsigned count = 1;
			assert_true((at[0] == '|' && strncmp(at + 1, "u1'", 3) == 0) ||
			            (at[0] == '<' && strchr("fiu", at[1]) != NULL));
			if (at[3] == '\'') sscanf(at + 4, ", (%u,)", &count);
			bytes += (size_t)(at[2] - '0') * count;
		}
		assert_int_equal(bytes, ts_buffer_table[id].element_bytes);
	}
	ts_npy_descr(descr, TS_B_points_record);
	assert_string_equal(descr, "[('centre', '<f4', (3,)), ('length', '<f4'), ('piece', '<u4'), ('flags', '<u4'), "
	                           "('pad', '<u4', (2,))]");
}

static void headers_read_back_what_was_written(void **state)
{
	(void)state;
	char head[TS_NPY_HEADER], descr[TS_NPY_DESCR];
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		ts_npy npy;
		size_t element = ts_buffer_table[id].element_bytes;
		ts_npy_descr(descr, (ts_buffer_id)id);
		size_t bytes = ts_npy_header(head, descr, 2, (const u64[]){5, 3});
		assert_int_equal(ts_npy_parse(&npy, "f", head, bytes, bytes + 15 * element, descr, element), TS_OK);
		assert_true(npy.n == 15 && npy.data_at == bytes);
	}
}

int main(void)
{
	const struct CMUnitTest emit[] = {
		cmocka_unit_test(parts_add_up_to_their_shape),          cmocka_unit_test(a_failure_ends_the_files),
		cmocka_unit_test(names_begin_with_their_stages_number), cmocka_unit_test(the_order_is_that_of_the_numbers),
		cmocka_unit_test(dtypes_are_as_wide_as_their_elements), cmocka_unit_test(headers_read_back_what_was_written),
	};
	return cmocka_run_group_tests(emit, scratch_begin, scratch_remove);
}

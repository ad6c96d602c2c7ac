/* Replay: every stage of both methods, alone, makes what the trace holds; what a candidate made otherwise is found. */
#include "replay/judge.h"
#include "tests/replay/traces.h"

/* Samples of pixels, of traces with one sample a pixel. */
static bool is_left_out(u32 m, ts_buffer_id id)
{
	return id == TS_B_image_sample_radiance && traces[m]->item[id].path == NULL;
}

/* The whole of both methods, three bounces, by one batch of all reflectors where the trace was made of two. */
static void every_stage_replays_what_the_trace_holds(void **state)
{
	(void)state;
	for (u32 m = 0; m < N_TRACES; m++) {
		FOR_STAGES(m, stage)
		{
			if (traces_known(m, stage)) continue;
			for (u32 threads = 1; threads <= 3; threads += 2) {
				ts_load *load;
				if (ts_replay_run(&load, stage, traces[m], NULL, threads) != TS_OK) fail_msg("%s", ts_error_message());
				for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
					ts_judged v = {.id = TS_B_none};
					if (is_left_out(m, *id)) continue;
					if (ts_judge(&v, load, *id, NULL) != TS_OK) fail_msg("%s: %s", stage->name, v.text);
					assert_true(v.item != NULL && v.verdict.n_ref == v.item->npy.n);
					assert_true(v.verdict.n_ref > 0 && v.verdict.n_different == 0);
				}
				ts_load_end(load);
			}
		}
	}
}

/* The same, judged as a candidate. */
static void every_trace_is_right_as_a_candidate(void **state)
{
	(void)state;
	static ts_comparison c;
	const ts_relaxations exactly = {.ulp = 0};
	for (u32 m = 0; m < N_TRACES; m++) {
		assert_int_equal(ts_compare_forced(&c, traces[m], traces[m], &exactly, 2), TS_OK);
		assert_true(c.n_judged > 6 && c.n_unlike == 0 && c.n_missing == 0 && c.first == TS_N_BUFFERS);
	}
}

/* A key of records that are found by their keys: one is missing, and another stands beside. */
static bool is_found_by_key(ts_buffer_id id, const u64 *keys, u64 n, u64 element)
{
	if (ts_order_key_of(id) != id || id == ts_order_key()) return false;
	return (element == 0 || keys[element - 1] <= keys[element]) &&
	       (element + 1 == n || keys[element] <= keys[element + 1]);
}

/* One bit of one component of an output. */
static void plant_and_find(u32 m, const ts_stage *stage, ts_load *load, ts_buffer_id id, u32 seed)
{
	ts_buffer buffer;
	const ts_fields fields = ts_fields_of(id);
	u8 *data = traces_read(&buffer, traces[m], id);
	u32 f = seed % fields.n;
	u32 component = seed / 7 % fields.field[f].count;
	u64 element = seed * 2654435761ull % buffer.n;
	size_t at = fields.field[f].offset + component * fields.field[f].bytes;
	data[element * ts_buffer_table[id].element_bytes + at] ^= 1;
	ts_trace *candidate = traces_plant(m, &(planted){id, &buffer}, 1, "canonical", "");
	ts_judged v = {.id = TS_B_none};
	load->candidate = candidate;
	assert_int_equal(ts_judge(&v, load, id, NULL), TS_DIFFERENT);
	bool counts = ts_sum_of(id) != NULL && element + 1 < buffer.n; /* that a sum is in */
	bool by_key = is_found_by_key(id, (const u64 *)data, buffer.n, element);
	assert_int_equal(v.verdict.n_different, counts || by_key ? 2 : 1);
	if (counts && element > 0) assert_non_null(strstr(v.text, "count of element "));
	assert_int_equal(v.verdict.n_ref, buffer.n);
	if (by_key) {
		assert_string_equal(v.text, "1 records missing, 1 beside");
	} else if (v.verdict.first.element != element || v.verdict.first.component != component ||
	           v.verdict.first.field != f) {
		fail_msg("%s, %s: planted in element %u, field %s, component %u; found: %s", stage->name,
		         ts_buffer_table[id].name, (unsigned)element, fields.field[f].name, (unsigned)component, v.text);
	}
	load->candidate = NULL;
	traces_drop(candidate);
	free(data);
}

static void a_planted_bit_is_found_there(void **state)
{
	(void)state;
	u32 seed = 1;
	for (u32 m = 0; m < N_TRACES; m++) {
		FOR_STAGES(m, stage)
		{
			ts_load *load;
			if (traces_known(m, stage)) continue;
			assert_int_equal(ts_replay_run(&load, stage, traces[m], NULL, 1), TS_OK);
			for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++)
				if (!is_left_out(m, *id)) plant_and_find(m, stage, load, *id, seed++);
			ts_load_end(load);
		}
	}
}

/* The candidate's inputs are the ones that count: with its own densities its own frames are right. */
static void the_inputs_of_the_candidate_count(void **state)
{
	(void)state;
	ts_buffer scale, frames;
	f32 *scales = traces_read(&scale, traces[0], TS_B_split_density);
	for (u64 i = 0; i < scale.n; i++) scales[i] *= 0.5f;
	ts_trace *candidate = traces_plant(0, &(planted){TS_B_split_density, &scale}, 1, "canonical", "");
	const ts_stage *align = ts_stage_find("align");
	ts_load *load;
	ts_judged v = {.id = TS_B_none};
	assert_int_equal(ts_replay_run(&load, align, traces[0], candidate, 2), TS_OK);
	assert_int_equal(ts_judge(&v, load, TS_B_align_frame, NULL), TS_DIFFERENT);
	assert_string_equal(ts_fields_of(TS_B_align_frame).field[v.verdict.first.field].name, "s");
	frames = load->run.frame.buffer[TS_B_align_frame];
	const planted both[2] = {{TS_B_split_density, &scale}, {TS_B_align_frame, &frames}};
	ts_trace *port = traces_plant(0, both, 2, "canonical", "");
	ts_load *again;
	assert_int_equal(ts_replay_run(&again, align, traces[0], port, 2), TS_OK);
	assert_int_equal(ts_judge(&v, again, TS_B_align_frame, NULL), TS_OK);
	assert_ptr_equal(v.item, &port->item[TS_B_align_frame]);
	ts_load_end(again);
	ts_load_end(load);
	traces_drop(port);
	traces_drop(candidate);
	free(scales);
}

/* Points in another order: found by their keys; what is splatted from them is right by their own indices. */
static void points_in_another_order_are_right(void **state)
{
	(void)state;
	ts_buffer key, record;
	u64 *keys = traces_read(&key, traces[0], TS_B_points_key);
	ts_point *points = traces_read(&record, traces[0], TS_B_points_record);
	for (u64 i = 0; i < key.n / 2; i++) {
		u64 other = key.n - 1 - i, k = keys[i];
		ts_point p = points[i];
		keys[i] = keys[other];
		keys[other] = k;
		points[i] = points[other];
		points[other] = p;
	}
	const planted both[2] = {{TS_B_points_key, &key}, {TS_B_points_record, &record}};
	ts_trace *candidate = traces_plant(0, both, 2, "arrival", "");
	ts_load *load;
	ts_judged v = {.id = TS_B_none};
	assert_int_equal(ts_replay_run(&load, ts_stage_find("points"), traces[0], candidate, 2), TS_OK);
	assert_int_equal(ts_judge(&v, load, TS_B_points_key, NULL), TS_OK);
	assert_int_equal(ts_judge(&v, load, TS_B_points_record, NULL), TS_OK);
	ts_load_end(load);
	ts_buffer theirs;
	u64 *texels = traces_read(&theirs, traces[0], TS_B_splat_depth_index);
	u8 *ties = traces_read(&(ts_buffer){.n = 0}, traces[0], TS_B_splat_tie);
	assert_int_equal(ts_replay_run(&load, ts_stage_find("splat"), traces[0], candidate, 2), TS_OK);
	const u64 *ours = ts_frame_data(&load->run.frame, TS_B_splat_depth_index);
	for (u64 i = 0; i < theirs.n; i++) {
		u64 turned = texels[i] == TS_EMPTY ? TS_EMPTY : (texels[i] >> 32 << 32) | (key.n - 1 - (texels[i] & TS_NONE));
		if (ties[i] == 0)
			assert_int_equal(ours[i], turned);
		else
			assert_int_equal(ours[i] >> 32, turned >> 32);
	}
	ts_load_end(load);
	traces_drop(candidate);
	free(ties);
	free(texels);
	free(points);
	free(keys);
}

static void only_stages_of_the_method_are_found(void **state)
{
	(void)state;
	ts_params params = traces[0]->params;
	const ts_pipeline *epr = traces[0]->pipeline;
	assert_ptr_equal(ts_replay_find("splat", epr, &params), ts_stage_find("splat"));
	assert_null(ts_replay_find("cube_face", epr, &params));
	assert_null(ts_replay_find("nothing", epr, &params));
	params.lookup_bounces = 2;
	assert_non_null(ts_replay_find("lookup.second", epr, &params));
	assert_null(ts_replay_find("lookup.third", epr, &params));
	ts_buffer_id ids[TS_N_BUFFERS + 1];
	params.lookup_bounces = 1;
	ts_replay_reads(ids, ts_stage_find("shade"), epr, &params);
	for (u32 i = 0; ids[i] != TS_N_BUFFERS; i++)
		assert_true(strncmp(ts_buffer_table[ids[i]].name, "lookup.second", 13) != 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(every_stage_replays_what_the_trace_holds),
		cmocka_unit_test(every_trace_is_right_as_a_candidate),
		cmocka_unit_test(a_planted_bit_is_found_there),
		cmocka_unit_test(the_inputs_of_the_candidate_count),
		cmocka_unit_test(points_in_another_order_are_right),
		cmocka_unit_test(only_stages_of_the_method_are_found),
	};
	return cmocka_run_group_tests(tests, traces_begin, traces_end);
}

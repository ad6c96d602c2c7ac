/* What items tell, of every stage of every method: the bits of the kernels, and the values that buffers receive. */
#include "explain/explain.h"
#include "tests/kernels/seeded.h"
#include "tests/replay/traces.h"
#include "tests/whole.h"

static ts_telling silent;
static bool reached[TS_N_KERNELS];

static ts_status told_launch(ts_backend *backend, ts_frame *frame, const ts_launch *launch, const void *args, u64 n)
{
	(void)backend;
	(void)frame;
	reached[launch->kernel] = true;
	for (u64 i = 0; i < n; i++) ts_told_item(launch->kernel, args, i);
	return TS_OK;
}

/* Every item of every kernel tells, once a stage, and the buffers are those of the trace. */
static void telling_changes_no_bit(void **state)
{
	(void)state;
	u32 n_kernels = 0;
	ts_told_to(&silent);
	for (u32 m = 0; m < N_TRACES; m++) {
		FOR_STAGES(m, stage)
		{
			if (traces_known(m, stage)) continue;
			ts_load *load;
			assert_int_equal(ts_replay_load(&load, stage, traces[m], NULL, 1), TS_OK);
			load->run.c.backend.launch = told_launch;
			load->run.c.no_fast_paths = true;
			assert_int_equal(ts_replay_stage(&load->run, stage), TS_OK);
			for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
				ts_judged judged;
				if (!load->run.frame.buffer[*id].made) continue;
				if (ts_judge(&judged, load, *id, NULL) != TS_OK) fail_msg("%s: %s", stage->name, judged.text);
			}
			ts_load_end(load);
		}
	}
	for (u32 k = 0; k < TS_N_KERNELS; k++) n_kernels += reached[k];
	assert_true(n_kernels > 95);
}

static ts_question question_of(ts_buffer_id id, u64 element)
{
	return (ts_question){
		.subject = TS_EXPLAIN_ELEMENT, .kernel = TS_N_KERNELS, .buffer = id, .element = element, .most = 1 << 20};
}

/* The line stores what the element of the trace holds. Where the buffer has prefix sums, the line stores the count or,
 * if a kernel makes the sums, the sum. */
static void check_store(const ts_explanation *e, u32 m, ts_buffer_id id, u64 element)
{
	ts_buffer buffer;
	char place[TS_VALUE_TEXT], right[TS_VALUE_TEXT];
	const ts_told_line *line = &e->telling.lines[e->telling.stores];
	assert_true(e->telling.stores < e->telling.n_lines && line->site->how == TS_TOLD_STORE);
	snprintf(right, sizeof right, "%s:%u", ts_buffer_table[id].name, (unsigned)element);
	ts_explain_place(place, e, line);
	assert_string_equal(place, right);
	u32 n_items = 0;
	for (size_t i = 0; i < e->n_launches; i++) n_items += e->launch[i].item < e->launch[i].n;
	assert_int_equal(n_items, 1);
	u8 *data = traces_read(&buffer, traces[m], id);
	size_t bytes = ts_buffer_table[id].element_bytes;
	if (ts_sum_of(id) != NULL) {
		u32 told, sums[2];
		memcpy(&told, e->telling.bytes + line->value, 4);
		memcpy(sums, data + element * 4, 8);
		assert_true(told == sums[1] - sums[0] || told == sums[0]);
	} else if (line->site->type->bytes == bytes) {
		assert_memory_equal(e->telling.bytes + line->value, data + element * bytes, bytes);
	}
	free(data);
}

/* An element of every output, of the first stage that has it; whole: of each such stage. */
static void stored_values_are_those_of_the_trace(void **state)
{
	(void)state;
	u32 n_stored = 0, n_none = 0, whole = whole_or(1, 0);
	bool asked[TS_N_BUFFERS] = {false};
	for (u32 m = 0; m < N_TRACES; m++) {
		FOR_STAGES(m, stage)
		{
			if (traces_known(m, stage)) continue;
			for (const ts_buffer_id *id = ts_stage_outputs(stage); *id != TS_N_BUFFERS; id++) {
				u64 n = traces[m]->item[*id].path != NULL ? traces[m]->item[*id].npy.n : 0;
				if (n < 2 || (asked[*id] && !whole)) continue;
				asked[*id] = true;
				ts_explanation e;
				u64 element = below((u32)n - 1);
				ts_question question = question_of(*id, element);
				ts_status status = ts_explain(&e, stage, &question, traces[m], NULL);
				if (status == TS_OK) check_store(&e, m, *id, element);
				n_stored += status == TS_OK;
				n_none += status != TS_OK;
				ts_explain_end(&e);
			}
		}
	}
	print_message("%u elements explained, %u that no item writes\n", (unsigned)n_stored, (unsigned)n_none);
	assert_true(n_stored > 70 && n_none < n_stored);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(telling_changes_no_bit),
	                                   seeded_test(stored_values_are_those_of_the_trace)};
	return cmocka_run_group_tests(tests, traces_begin, traces_end);
}

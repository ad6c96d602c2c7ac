/* Verdicts: a bit that is planted in one buffer of a candidate is found there, and told with its bits; and a stage is
 * right or wrong given the candidate's own inputs. */
#include "tests/api/run.h"

static void a_copy_is_the_same(void **state)
{
	(void)state;
	ts_verdicts *verdicts;
	const ts_verdict_info *verdict;
	ts_trace *trace = candidate_of(reference, 0);
	for (int forced = 0; forced < 2; forced++) {
		ts_compare_options options = {.bytes = sizeof options, .forced = forced};
		size_t n = 0;
		done(ts_compare(context, &verdicts, reference, trace, &options));
		assert_null(ts_verdicts_first(verdicts));
		for (; (verdict = ts_verdicts_at(verdicts, n)) != NULL; n++) {
			bool scenes = strcmp(verdict->stage, "scene") == 0;
			assert_string_equal(verdict->verdict, forced && scenes ? "not judged" : "same");
			assert_int_equal(verdict->n_different, 0);
		}
		assert_true(n > 20);
		ts_verdicts_free(verdicts);
	}
	ts_trace_close(trace);
}

/* Changes the lowest bit of the last element's last word in a copy of each buffer of stages in turn. */
static void a_planted_bit_is_found(void **state)
{
	(void)state;
	const ts_buffer_info *buffer;
	ts_trace *trace = candidate_of(reference, 0);
	size_t n_found = 0;
	for (size_t i = 0; (buffer = ts_buffer_at(i)) != NULL; i++) {
		const ts_buffer_view *view = ts_trace_buffer(reference, buffer->name);
		/* Keys must ascend, and prefix sums are told by their counts: both are others' tests. */
		if (view == NULL || strstr(view->name, ".key") != NULL || strstr(view->name, ".offset") != NULL) continue;
		size_t last = count_of(view) - 1;
		if (count_of(view) == 0 || bytes_of(view) < 4) continue;
		uint8_t *copy = malloc(bytes_of(view));
		assert_non_null(copy);
		memcpy(copy, view->data, bytes_of(view));
		copy[last * view->element_bytes] ^= 1;
		put(trace, view, copy);
		ts_verdicts *verdicts;
		assert_int_equal(ts_compare(context, &verdicts, reference, trace, NULL), TS_DIFFERENT);
		const ts_divergence *first = ts_verdicts_first(verdicts);
		assert_non_null(first);
		assert_string_equal(first->buffer, view->name);
		assert_string_equal(first->how, "different");
		assert_int_equal(first->element, last);
		assert_int_equal(first->reference_bits ^ first->candidate_bits, 1);
		bool given = strcmp(first->stage, "scene") == 0;
		assert_string_equal(first->inputs, given ? "of the scene, which no stage makes" : "inputs identical");
		assert_non_null(strstr(first->line, first->where));
		assert_non_null(strstr(first->line, first->reference));
		assert_non_null(strstr(first->line, first->candidate));
		ts_verdicts_free(verdicts);
		put(trace, view, view->data);
		free(copy);
		n_found++;
	}
	assert_true(n_found > 15);
	ts_trace_close(trace);
}

static void a_replay_judges_by_the_given_inputs(void **state)
{
	(void)state;
	ts_trace *trace;
	ts_verdicts *verdicts;
	const ts_buffer_view *view = ts_trace_buffer(reference, "pose.vertex"), *keys;
	done(ts_replay(context, &verdicts, "eye", reference, NULL, NULL));
	assert_string_equal(ts_verdicts_at(verdicts, 0)->buffer, "eye.depth_triangle");
	assert_string_equal(ts_verdicts_at(verdicts, 0)->verdict, "same");
	ts_verdicts_free(verdicts);

	/* The candidate's own vertices: the reference's picture of them is no longer right. */
	ts_vertex *moved = malloc(bytes_of(view));
	assert_non_null(moved);
	memcpy(moved, view->data, bytes_of(view));
	for (size_t i = 0; i < count_of(view); i++) moved[i].position[1] += 0.25f;
	done(ts_trace_candidate(context, &trace, reference, 0));
	put(trace, view, moved);
	refused(ts_replay(context, &verdicts, "eye", reference, trace, NULL), ": the candidate has none of its outputs");
	keys = ts_trace_buffer(reference, "eye.depth_triangle");
	put(trace, keys, keys->data);
	assert_int_equal(ts_replay(context, &verdicts, "eye", reference, trace, NULL), TS_DIFFERENT);
	const ts_divergence *first = ts_verdicts_first(verdicts);
	assert_string_equal(first->stage, "eye");
	assert_string_equal(first->inputs, "given the candidate's inputs");
	assert_true(first->reference_bits != first->candidate_bits);
	ts_verdicts_free(verdicts);
	moved[0].position[0] = 1e30f / 1e-30f;
	refused(ts_replay(context, &verdicts, "eye", reference, trace, NULL), "stage eye: ");
	assert_null(verdicts);
	refused(ts_replay(context, &verdicts, "eyes", reference, trace, NULL), "eyes");
	memcpy(moved, view->data, bytes_of(view));
	refused(ts_replay(context, &verdicts, "splat", reference, trace, NULL), ": the candidate has none of its outputs");

	/* The reference's outputs are lent: what the candidate's inputs give is not what they are. Nobody's are missing. */
	ts_trace *bare;
	ts_compare_options lent = {.bytes = sizeof lent, .lent = 1};
	done(ts_trace_candidate(context, &bare, reference, 0));
	for (size_t i = 0; i < count_of(view); i++) moved[i].position[1] += 0.25f;
	put(bare, view, moved);
	assert_int_equal(ts_replay(context, &verdicts, "eye", reference, bare, &lent), TS_DIFFERENT);
	const ts_verdict_info *info = ts_verdicts_at(verdicts, 0);
	assert_non_null(strstr(info->text, "the candidate's inputs give"));
	assert_string_equal(info->file, "eye.depth_triangle");
	ts_verdicts_free(verdicts);
	ts_trace_close(bare);
	memcpy(moved, view->data, bytes_of(view));

	/* What the stage should have made. */
	ts_trace *right;
	done(ts_trace_replay(context, &right, "eye", reference, trace));
	assert_memory_equal(ts_trace_buffer(right, "eye.depth_triangle")->data, keys->data, bytes_of(keys));
	assert_false(ts_trace_has(right, "pose.vertex"));
	ts_trace_close(right);
	ts_trace_close(trace);
	free(moved);
}

static void relaxations_allow_what_they_say(void **state)
{
	(void)state;
	ts_trace *trace = candidate_of(reference, 0);
	ts_verdicts *verdicts;
	const ts_buffer_view *view = ts_trace_buffer(reference, "image.radiance");
	float *copy = malloc(bytes_of(view));
	assert_non_null(copy);
	memcpy(copy, view->data, bytes_of(view));
	((uint32_t *)copy)[30] += 2;
	put(trace, view, copy);
	ts_compare_options options = {.bytes = sizeof options};
	assert_int_equal(ts_compare(context, &verdicts, reference, trace, &options), TS_DIFFERENT);
	assert_int_equal(ts_verdicts_first(verdicts)->ulps, 2);
	assert_int_equal(ts_verdicts_first(verdicts)->element, 30);
	ts_verdicts_free(verdicts);
	options.ulp = 1;
	assert_int_equal(ts_compare(context, &verdicts, reference, trace, &options), TS_DIFFERENT);
	ts_verdicts_free(verdicts);
	options.ulp = 2;
	done(ts_compare(context, &verdicts, reference, trace, &options));
	ts_verdicts_free(verdicts);
	options = (ts_compare_options){.bytes = sizeof options, .ignore = "image.radiance"};
	done(ts_compare(context, &verdicts, reference, trace, &options));
	ts_verdicts_free(verdicts);
	options.ignore = "image.radiances";
	refused(ts_compare(context, &verdicts, reference, trace, &options), "image.radiances");
	uint8_t mask[36 * 64] = {0};
	options = (ts_compare_options){.bytes = sizeof options, .mask = mask, .mask_width = 64, .mask_height = 36};
	done(ts_compare(context, &verdicts, reference, trace, &options));
	ts_verdicts_free(verdicts);
	mask[10] = 1;
	assert_int_equal(ts_compare(context, &verdicts, reference, trace, &options), TS_DIFFERENT);
	ts_verdicts_free(verdicts);
	mask[10] = 0;
	done(ts_compare(context, &verdicts, reference, trace, &options));
	uint64_t n_masked = 0;
	for (size_t i = 0; ts_verdicts_at(verdicts, i) != NULL; i++) n_masked += ts_verdicts_at(verdicts, i)->n_masked;
	assert_true(n_masked > 0);
	ts_verdicts_free(verdicts);
	options.mask = NULL;
	refused(ts_compare(context, &verdicts, reference, trace, &options), "mask");
	options = (ts_compare_options){.bytes = sizeof options, .abs = -1};
	refused(ts_compare(context, &verdicts, reference, trace, &options), "abs: -1");
	options = (ts_compare_options){.bytes = sizeof options, .decided = 1};
	refused(ts_compare(context, &verdicts, reference, trace, &options), "margin");
	ts_trace_close(trace);
	free(copy);
}

/* Points as they come are those of the reference; and with margins only what they decide is judged. */
static void points_in_order_of_arrival_are_right(void **state)
{
	(void)state;
	ts_trace *arrived, *whole;
	ts_verdicts *verdicts;
	ts_run_options options = {.bytes = sizeof options, .arrival = 1};
	done(ts_trace_run(context, &arrived, scene, params, "reflections", "epr", &options));
	done(ts_compare(context, &verdicts, reference, arrived, NULL));
	ts_verdicts_free(verdicts);
	refused(ts_compare(context, &verdicts, arrived, reference, NULL), "order of arrival");

	/* Without their keys nothing can be said of points in another order, and nothing is. */
	ts_trace *part;
	const ts_buffer_view *cubes = ts_trace_buffer(arrived, "splat.depth_index");
	const ts_buffer_view *image = ts_trace_buffer(arrived, "image.srgb");
	done(ts_trace_candidate(context, &part, reference, 1));
	put(part, cubes, cubes->data);
	refused(ts_compare(context, &verdicts, reference, part, NULL), "nothing to judge");
	refused(ts_replay(context, &verdicts, "splat", reference, part, NULL), "another order");
	put(part, image, image->data);
	done(ts_compare(context, &verdicts, reference, part, NULL));
	ts_verdicts_free(verdicts);
	ts_trace_close(part);
	options = (ts_run_options){.bytes = sizeof options, .margins = 1};
	done(ts_trace_run(context, &whole, scene, params, "reflections", "epr", &options));
	ts_compare_options decided = {.bytes = sizeof decided, .decided = 1};
	done(ts_compare(context, &verdicts, whole, reference, &decided));
	ts_verdicts_free(verdicts);
	assert_true(ts_trace_has(whole, "eye.margin") && !ts_trace_has(reference, "eye.margin"));
	ts_trace_close(whole);
	ts_trace_close(arrived);
}

static void nothing_to_judge_is_refused(void **state)
{
	(void)state;
	ts_trace *trace, *other;
	ts_verdicts *verdicts;
	done(ts_trace_candidate(context, &trace, reference, 0));
	refused(ts_compare(context, &verdicts, reference, trace, NULL), "nothing to judge");
	other = small_trace(context, scene, params, "mvr");
	refused(ts_compare(context, &verdicts, reference, other, NULL), "a trace of mvr");
	assert_null(verdicts);
	assert_null(ts_verdicts_at(NULL, 0));
	assert_null(ts_verdicts_first(NULL));
	ts_verdicts_free(NULL);
	ts_trace_close(other);
	ts_trace_close(trace);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_copy_is_the_same),
		cmocka_unit_test(a_planted_bit_is_found),
		cmocka_unit_test(a_replay_judges_by_the_given_inputs),
		cmocka_unit_test(relaxations_allow_what_they_say),
		cmocka_unit_test(points_in_order_of_arrival_are_right),
		cmocka_unit_test(nothing_to_judge_is_refused),
	};
	return cmocka_run_group_tests(tests, run_begin, run_end);
}

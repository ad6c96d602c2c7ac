/* Explanations by the library: the line that stores an element has its value; of two traces the first line that differs
 * is found; and what cannot be asked is refused. */
#include "tests/api/run.h"

/* Ten values of the picture: the store that is told is of that element, and has its bits. */
static void the_store_told_is_of_the_element(void **state)
{
	(void)state;
	const ts_buffer_view *image = ts_trace_buffer(reference, "image.radiance");
	const uint32_t *bits = image->data;
	for (uint64_t e = 5; e < count_of(image); e += count_of(image) / 10) {
		ts_tree *answer;
		char to[64], hex[16];
		const ts_explain_options options = {
			.bytes = sizeof options, .stage = "image", .buffer = "image.radiance", .element = e};
		done(ts_explain_item(context, &answer, &options, reference, NULL, NULL));
		int64_t number = ts_tree_integer(ts_tree_get(answer, "stores"));
		const ts_tree *launches = ts_tree_get(answer, "launches"), *line = NULL;
		for (size_t i = 0; i < ts_tree_n(launches) && line == NULL; i++) {
			const ts_tree *lines = ts_tree_get(ts_tree_at(launches, i), "lines");
			if ((uint64_t)number <= ts_tree_n(lines)) line = ts_tree_at(lines, (size_t)number - 1);
			number -= (int64_t)ts_tree_n(lines);
		}
		snprintf(to, sizeof to, "image.radiance:%u", (unsigned)e);
		snprintf(hex, sizeof hex, "%08x", (unsigned)bits[e]);
		assert_string_equal(ts_tree_text(ts_tree_get(line, "to")), to);
		char *json = ts_tree_json(ts_tree_get(line, "value"));
		assert_non_null(strstr(json, hex));
		free(json);
		ts_tree_free(answer);
	}
}

/* The eye one bit further: the first line that differs is of another value; as text both sides are marked. */
static void the_first_line_that_differs_is_told(void **state)
{
	(void)state;
	ts_trace *other;
	ts_tree *answer;
	const ts_buffer_view *v = ts_trace_buffer(reference, "eye.view");
	ts_view *moved = malloc(bytes_of(v));
	assert_non_null(moved);
	memcpy(moved, v->data, bytes_of(v));
	((uint32_t *)moved)[0] ^= 1;
	done(ts_trace_candidate(context, &other, reference, 0));
	put(other, v, moved);
	ts_explain_options options = {.bytes = sizeof options, .stage = "eye", .item_said = 1, .item = 7};
	assert_int_equal(ts_explain_item(context, &answer, &options, reference, NULL, other), TS_DIFFERENT);
	assert_true(ts_tree_integer(ts_tree_get(ts_tree_get(answer, "first_difference"), "line")) > 0);
	ts_tree_free(answer);
	options.as_text = 1;
	assert_int_equal(ts_explain_item(context, &answer, &options, reference, NULL, other), TS_DIFFERENT);
	bool marked[2] = {false, false};
	for (size_t i = 0; i < ts_tree_n(answer); i++) {
		const char *line = ts_tree_text(ts_tree_at(answer, i));
		marked[0] |= line[0] == '<';
		marked[1] |= line[0] == '>';
	}
	assert_true(marked[0] && marked[1]);
	ts_tree_free(answer);
	done(ts_explain_item(context, &answer, &options, reference, other, NULL));
	ts_tree_free(answer);
	done(ts_explain_item(context, &answer, &options, reference, NULL, reference));
	ts_tree_free(answer);
	refused(ts_explain_item(context, &answer, &options, reference, other, other), "not both");
	assert_null(answer);
	ts_trace_close(other);
	free(moved);
}

static void wrong_questions_are_refused(void **state)
{
	(void)state;
	ts_tree *answer;
	ts_explain_options o = {.bytes = sizeof o, .stage = "magic"};
	refused(ts_explain_item(context, &answer, &o, reference, NULL, NULL), "magic");
	o.stage = "splat";
	o.buffer = "points.record";
	refused(ts_explain_item(context, &answer, &o, reference, NULL, NULL), "writes no buffer points.record");
	o.buffer = "splat.depth_index";
	o.element = 1u << 30;
	refused(ts_explain_item(context, &answer, &o, reference, NULL, NULL), "element");
	o.item_said = 1;
	refused(ts_explain_item(context, &answer, &o, reference, NULL, NULL), "leave both out");
	o = (ts_explain_options){.bytes = sizeof o, .stage = "splat", .kernel = "splatt", .item_said = 1};
	refused(ts_explain_item(context, &answer, &o, reference, NULL, NULL), "the nearest is splat");
	o.bytes = 3;
	refused(ts_explain_item(context, &answer, &o, reference, NULL, NULL), "bytes");
	assert_null(answer);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(the_store_told_is_of_the_element),
		cmocka_unit_test(the_first_line_that_differs_is_told),
		cmocka_unit_test(wrong_questions_are_refused),
	};
	return cmocka_run_group_tests(tests, run_begin, run_end);
}

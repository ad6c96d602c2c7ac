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
	assert_non_null(ts_tree_text(ts_tree_get(ts_tree_get(answer, "first_difference"), "title")));
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

static size_t n_titles(const ts_tree *answer, bool once)
{
	size_t n = 0;
	for (size_t i = 0; i < ts_tree_n(answer); i++) {
		const char *line = ts_tree_text(ts_tree_at(answer, i)), *title = strstr(line, " -- ");
		for (size_t k = 0; k < i && title != NULL && once; k++) {
			const char *before = strstr(ts_tree_text(ts_tree_at(answer, k)), " -- ");
			if (before != NULL && strncmp(before, title, 40) == 0) title = NULL;
		}
		n += title != NULL;
	}
	return n;
}

/* An outline is shorter, and has every title; it takes more lines than are printed by default. */
static void an_outline_has_every_title(void **state)
{
	(void)state;
	ts_tree *whole, *outline;
	ts_explain_options o = {.bytes = sizeof o, .stage = "image", .item_said = 1, .item = 7, .as_text = 1};
	done(ts_explain_item(context, &whole, &o, reference, NULL, NULL));
	o.outline = 1;
	done(ts_explain_item(context, &outline, &o, reference, NULL, NULL));
	assert_true(ts_tree_n(outline) < ts_tree_n(whole) / 2 && n_titles(outline, true) > 3);
	assert_int_equal(n_titles(outline, true), n_titles(whole, true));
	ts_tree_free(outline);
	o.lines = 10;
	done(ts_explain_item(context, &outline, &o, reference, NULL, NULL));
	assert_true(strstr(ts_tree_text(ts_tree_at(outline, ts_tree_n(outline) - 1)), " more lines") != NULL);
	ts_tree_free(outline);
	ts_tree_free(whole);
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
		cmocka_unit_test(an_outline_has_every_title),
		cmocka_unit_test(wrong_questions_are_refused),
	};
	return cmocka_run_group_tests(tests, run_begin, run_end);
}

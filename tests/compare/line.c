/* Lines of what differs: each kind of difference, how many there are, and what a stage's inputs were. */
#include <math.h>
#include "compare/line.h"
#include "tests/model/test.h"

/* A record's normal, from one float to another. */
static void tells(f32 ref, f32 cand, const char *right)
{
	char text[TS_DIFFERENCE_TEXT];
	const ts_named named = {.difference = {.field = 2, .component = 1, .ref = ts_f2u(ref), .cand = ts_f2u(cand)},
	                        .where = "pixel (3, 4)"};
	ts_compare_difference(text, TS_B_mirror_pixel_record, &named);
	assert_string_equal(text, right);
}

static void each_kind_of_difference_has_its_line(void **state)
{
	(void)state;
	char text[TS_DIFFERENCE_TEXT];
	tells(1, 0x1.000002p+0f,
	      "pixel (3, 4), field normal[1]: ref 1 = 0x1p+0 (3f800000) candidate 1.00000012 = "
	      "0x1.000002p+0 (3f800001) +1 ulp");
	tells(0, -0.0f,
	      "pixel (3, 4), field normal[1]: ref 0 = 0x0p+0 (00000000) candidate -0 = -0x0p+0 (80000000) -1 ulp");
	tells(1, ts_u2f(0x7fc00000u),
	      "pixel (3, 4), field normal[1]: ref 1 = 0x1p+0 (3f800000) candidate nan = nan "
	      "(7fc00000) NaN");
	const ts_named code = {.difference = {.ref = 7, .cand = 255}, .where = "pixel (0, 1) [2]"};
	ts_compare_difference(text, TS_B_image_srgb, &code);
	assert_string_equal(text, "pixel (0, 1) [2], ref 7 (07) candidate 255 (ff)");
	static const char *const hows[] = {NULL, "missing", "not of the reference", "twice"};
	for (int how = TS_LACKED; how <= TS_TWICE; how++) {
		char right[64];
		const ts_named point = {.difference = {.how = (ts_how_unlike)how}, .where = "point 5"};
		snprintf(right, sizeof right, "point 5: %s", hows[how]);
		ts_compare_difference(text, TS_B_points_record, &point);
		assert_string_equal(text, right);
	}
}

static void first_is(const ts_verdict *v, const char *right)
{
	char text[TS_FIRST_TEXT];
	ts_compare_first(text, TS_B_points_key, v);
	assert_string_equal(text, right);
}

static void the_first_difference_tells_their_number(void **state)
{
	(void)state;
	ts_named named = {.difference = {.how = TS_LACKED}, .where = "point 5"};
	ts_verdict v = {.n_ref = 12, .n_cand = 9, .n_different = 3, .n_missing = 2, .n_extra = 4};
	first_is(&v, "12 elements, candidate 9; equal as far as both go");
	v.list = (ts_differences){.items = &named, .n = 1, .most = 1};
	first_is(&v, "point 5: missing — first of 2 missing, 4 beside");
	named.difference.how = TS_BESIDE;
	first_is(&v, "point 5: not of the reference — first of 4");
	named.difference = (ts_difference){.ref = 1, .cand = 2};
	first_is(&v, "point 5, ref 1 (0000000000000001) candidate 2 (0000000000000002) — first of 3");
	snprintf(v.why, sizeof v.why, "shapes differ");
	first_is(&v, "shapes differ");
}

static void note_is(ts_buffer_id id, ts_verdict v, const char *right)
{
	char text[TS_LINE_TEXT];
	assert_true(ts_compare_note(text, id, &v));
	assert_string_equal(text, right);
}

static void notes_tell_sums_numbers_and_fields(void **state)
{
	(void)state;
	char text[TS_LINE_TEXT];
	const ts_verdict plain = {.n_ref = 5, .n_cand = 5, .n_different = 2, .n_field = {2}};
	assert_false(ts_compare_note(text, TS_B_image_radiance, &plain));
	note_is(TS_B_points_offset, plain, "points.offset: sums, judged by their counts");
	note_is(TS_B_image_radiance, (ts_verdict){.n_ref = 5, .n_cand = 6}, "image.radiance: 5 elements, candidate 6");
	note_is(TS_B_mirror_pixel_record, (ts_verdict){.n_ref = 5, .n_cand = 6, .n_field = {3, 0, 1}},
	        "mirror_pixel.record: 5 elements, candidate 6: elements that differ, by field: position 3, normal 1");
}

static ts_comparison c;
static ts_trace reference;

static void inputs_are(const char *right)
{
	char text[TS_INPUTS_TEXT];
	ts_compare_inputs(text, &c, &reference, TS_B_splat_depth_index);
	assert_string_equal(text, right);
}

/* What is said of the inputs of splat, as more and more is known of them. */
static void inputs_are_told_as_far_as_known(void **state)
{
	(void)state;
	char line[TS_LINE_TEXT], all[TS_INPUTS_TEXT] = "inputs identical as far as given; not given: ";
	reference.pipeline = ts_pipeline_find("reflections", "epr");
	const ts_buffer_id *inputs = ts_stage_inputs(ts_stage_find("splat"));
	inputs_are("none of its inputs was given");
	c.verdict[inputs[0]].judgement = TS_SAME;
	for (u32 i = 1; inputs[i] != TS_N_BUFFERS; i++) {
		size_t used = strlen(all);
		bool made = ts_pipeline_maker(reference.pipeline, inputs[i]) != NULL;
		if (made) snprintf(all + used, sizeof all - used, "%s%s", i > 1 ? ", " : "", ts_buffer_table[inputs[i]].name);
	}
	inputs_are(all);
	for (u32 i = 0; inputs[i] != TS_N_BUFFERS; i++) c.verdict[inputs[i]].judgement = TS_SAME;
	inputs_are("inputs identical");
	c.verdict[TS_B_cube_size_face].n_tied = 3;
	inputs_are("inputs may differ where cube_size.face is tied; forced judges by the candidate's own");
	c.verdict[TS_B_points_record].judgement = TS_UNLIKE;
	inputs_are("inputs differ: points.record");
	c.forced = true;
	inputs_are("given the candidate's inputs");
	ts_named named = {.difference = {.ref = 1, .cand = 2}, .where = "texel 3"};
	c.verdict[TS_B_splat_depth_index] = (ts_verdict){.n_different = 8, .list = {.items = &named, .n = 1, .most = 1}};
	ts_compare_line(line, &c, &reference, TS_B_splat_depth_index);
	assert_non_null(strstr(line, " splat, buffer splat.depth_index, texel 3, ref "));
	assert_non_null(strstr(line, " — first of 8; given the candidate's inputs"));
	ts_compare_line(line, &c, &reference, TS_B_scene_vertex);
	assert_int_equal(strncmp(line, "stage 00 scene, buffer scene.vertex, ", 37), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(each_kind_of_difference_has_its_line),
		cmocka_unit_test(the_first_difference_tells_their_number),
		cmocka_unit_test(notes_tell_sums_numbers_and_fields),
		cmocka_unit_test(inputs_are_told_as_far_as_known),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Verdicts on what a stage made: whose file is judged, shapes, crops, and what is said of the first difference. Buffers
 * and files are arrays of the test. */
#include "kernels/base/num.h"
#include "replay/judge.h"
#include "tests/model/test.h"

enum { ROWS = 5, COLUMNS = 4, BYTES = ROWS * COLUMNS * 3 };

static u8 made[BYTES], theirs[BYTES], ours[BYTES];
static ts_trace reference, candidate;
static ts_load load;

static void give(ts_trace *trace, ts_buffer_id id, const void *data, ts_npy npy)
{
	npy.n = 1;
	for (u32 d = 0; d < npy.n_dims; d++) npy.n *= npy.shape[d];
	trace->item[id] = (ts_trace_item){.path = (char *)(uintptr_t)ts_buffer_table[id].name, .memory = data, .npy = npy};
}

/* The stage made a picture of random bytes; both traces have the same one. */
static int begin(void **state)
{
	(void)state;
	const ts_npy whole = {.n_dims = 3, .shape = {ROWS, COLUMNS, 3}};
	for (u32 i = 0; i < BYTES; i++) made[i] = theirs[i] = ours[i] = (u8)(ts_random(i, 3, 7) >> 24);
	reference = (ts_trace){.pipeline = ts_pipeline_find("reflections", "epr")};
	candidate = reference;
	give(&reference, TS_B_image_srgb, theirs, whole);
	give(&candidate, TS_B_image_srgb, ours, whole);
	load = (ts_load){.reference = &reference, .candidate = &candidate, .pipeline = reference.pipeline};
	load.run.frame.buffer[TS_B_image_srgb] =
		(ts_buffer){.data = made, .n = BYTES, .n_dims = 3, .shape = {ROWS, COLUMNS, 3}, .made = true};
	return 0;
}

static ts_status judge(ts_judged *judged)
{
	*judged = (ts_judged){.id = TS_B_none};
	return ts_judge(judged, &load, TS_B_image_srgb, NULL);
}

/* The candidate's file where it has one, else the reference's, of which less is said; or none. */
static void the_candidates_file_is_judged_first(void **state)
{
	(void)state;
	ts_judged v;
	assert_int_equal(judge(&v), TS_OK);
	assert_true(v.verdict.judgement == TS_SAME && v.text[0] == 0 && !v.shape_differs && !v.not_given);
	theirs[4] ^= 1;
	assert_int_equal(judge(&v), TS_OK);
	ours[9] ^= 1;
	assert_int_equal(judge(&v), TS_DIFFERENT);
	assert_true(v.item == &candidate.item[TS_B_image_srgb] && !v.not_given && v.verdict.n_different == 1);
	assert_int_equal(v.verdict.first.element, 9);
	assert_non_null(strstr(v.text, " is right, "));
	candidate.item[TS_B_image_srgb].path = NULL;
	assert_int_equal(judge(&v), TS_DIFFERENT);
	assert_true(v.item == &reference.item[TS_B_image_srgb] && v.not_given && v.verdict.first.element == 4);
	assert_non_null(strstr(v.text, "the candidate's inputs give "));
	load.candidate = NULL;
	assert_int_equal(judge(&v), TS_DIFFERENT);
	assert_true(v.item == &reference.item[TS_B_image_srgb] && !v.not_given && v.verdict.first.element == 4);
	assert_non_null(strstr(v.text, " was found"));
	reference.item[TS_B_image_srgb].path = NULL;
	assert_int_equal(judge(&v), TS_OK);
	assert_true(v.item == NULL && v.verdict.judgement == TS_NOT_JUDGED);
}

/* Any other dimension, or number of dimensions, is told, and nothing is compared. */
static void any_other_shape_is_told(void **state)
{
	(void)state;
	static const struct {
		ts_npy npy;
		const char *text;
	} rows[] = {
		{{.n_dims = 3, .shape = {6, 4, 3}}, "shape 5 x 4 x 3 is right, shape 6 x 4 x 3 was found"},
		{{.n_dims = 3, .shape = {5, 3, 3}}, "shape 5 x 4 x 3 is right, shape 5 x 3 x 3 was found"},
		{{.n_dims = 3, .shape = {4, 5, 3}}, "shape 5 x 4 x 3 is right, shape 4 x 5 x 3 was found"},
		{{.n_dims = 3, .shape = {5, 4, 1}}, "shape 5 x 4 x 3 is right, shape 5 x 4 x 1 was found"},
		{{.n_dims = 2, .shape = {5, 4}}, "shape 5 x 4 x 3 is right, shape 5 x 4 was found"},
		{{.n_dims = 1, .shape = {5}}, "shape 5 x 4 x 3 is right, shape 5 was found"},
	};
	for (u32 row = 0; row < sizeof rows / sizeof *rows; row++) {
		ts_judged v;
		give(&candidate, TS_B_image_srgb, ours, rows[row].npy);
		assert_int_equal(judge(&v), TS_DIFFERENT);
		assert_true(v.shape_differs && v.verdict.judgement == TS_UNLIKE && v.verdict.n_different == 0);
		assert_true(v.verdict.n_ref == BYTES && v.verdict.n_cand == candidate.item[TS_B_image_srgb].npy.n);
		assert_string_equal(v.text, rows[row].text);
	}
}

/* A crop of ours at (x, y), judged; the last of its bytes may be wrong. */
static ts_status judge_crop(ts_judged *v, u32 x, u32 y, u32 width, u32 height, bool wrong)
{
	u8 part[(ROWS + 1) * (COLUMNS + 1) * 3] = {0};
	u32 n = 0;
	for (u32 row = y; row < y + height; row++) {
		for (u32 i = x * 3; i < (x + width) * 3; i++) {
			part[n++] = row < ROWS && i < COLUMNS * 3 ? made[row * COLUMNS * 3 + i] : 0;
		}
	}
	part[n - 1] ^= (u8)wrong;
	give(&candidate, TS_B_image_srgb, part, (ts_npy){.n_dims = 3, .shape = {height, width, 3}});
	ts_trace_item *item = &candidate.item[TS_B_image_srgb];
	item->cropped = true;
	memcpy(item->crop, (u32[]){x, y, width, height}, sizeof item->crop);
	return judge(v);
}

/* Every crop within the picture is compared with its part; every other one has a wrong shape. */
static void crops_are_compared_with_their_part(void **state)
{
	(void)state;
	u32 n = 0;
	for (u32 x = 0; x < COLUMNS; x++) {
		for (u32 y = 0; y < ROWS; y++) {
			for (u32 width = 1; x + width <= COLUMNS; width++) {
				for (u32 height = 1; y + height <= ROWS; height++, n++) {
					ts_judged v;
					assert_int_equal(judge_crop(&v, x, y, width, height, false), TS_OK);
					assert_true(v.verdict.judgement == TS_SAME && v.verdict.n_ref == (u64)3 * width * height);
					assert_int_equal(judge_crop(&v, x, y, width, height, true), TS_DIFFERENT);
					assert_true(!v.shape_differs && v.verdict.n_different == 1);
					assert_int_equal(v.verdict.first.element, 3 * width * height - 1);
				}
			}
		}
	}
	assert_int_equal(n, ROWS * (ROWS + 1) / 2 * COLUMNS * (COLUMNS + 1) / 2);
	static const u32 beyond[][4] = {{0, 0, 5, 1}, {3, 0, 2, 2}, {4, 4, 1, 1}, {0, 0, 1, 6}, {1, 4, 2, 2}, {0, 5, 1, 1}};
	for (u32 i = 0; i < sizeof beyond / sizeof *beyond; i++) {
		ts_judged v;
		const u32 *crop = beyond[i];
		assert_int_equal(judge_crop(&v, crop[0], crop[1], crop[2], crop[3], false), TS_DIFFERENT);
		assert_true(v.shape_differs && v.verdict.n_different == 0);
	}
}

/* Things that the stage counts are compared as far as they go. */
static void counts_are_compared_as_far_as_possible(void **state)
{
	(void)state;
	u32 keep[] = {1, 0, 1, 1, 0}, found[] = {1, 0, 1, 1, 0};
	load.run.frame.buffer[TS_B_cull_keep] = (ts_buffer){.data = keep, .n = 4, .n_dims = 1, .shape = {4}, .made = true};
	static const char *const texts[] = {"element 3: missing", "", "element 4: beside the right ones"};
	for (u32 i = 0; i < 3; i++) {
		ts_judged v = {.id = TS_B_none};
		give(&candidate, TS_B_cull_keep, found, (ts_npy){.n_dims = 1, .shape = {3 + i}});
		assert_int_equal(ts_judge(&v, &load, TS_B_cull_keep, NULL), i == 1 ? TS_OK : TS_DIFFERENT);
		assert_true(!v.shape_differs && v.verdict.n_ref == 4 && v.verdict.n_cand == 3 + i);
		assert_string_equal(v.text, texts[i]);
	}
}

/* Points are found by their keys: those of the run, in whatever order the candidate's stand. */
static void points_are_found_by_their_keys(void **state)
{
	(void)state;
	u64 right[] = {3, 5, 8, 9}, turned[] = {9, 3, 8, 5}, other[] = {9, 3, 8, 6};
	const ts_npy npy = {.n_dims = 1, .shape = {4}};
	load.run.frame.buffer[TS_B_points_key] =
		(ts_buffer){.data = right, .n = 4, .n_dims = 1, .shape = {4}, .made = true};
	candidate.arrival = true;
	ts_judged v = {.id = TS_B_none};
	give(&reference, TS_B_points_key, other, npy);
	give(&candidate, TS_B_points_key, turned, npy);
	assert_int_equal(ts_judge(&v, &load, TS_B_points_key, NULL), TS_OK);
	give(&candidate, TS_B_points_key, other, npy);
	assert_int_equal(ts_judge(&v, &load, TS_B_points_key, NULL), TS_DIFFERENT);
	assert_string_equal(v.text, "1 records missing, 1 beside");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test_setup(the_candidates_file_is_judged_first, begin),
		cmocka_unit_test_setup(any_other_shape_is_told, begin),
		cmocka_unit_test_setup(crops_are_compared_with_their_part, begin),
		cmocka_unit_test_setup(counts_are_compared_as_far_as_possible, begin),
		cmocka_unit_test_setup(points_are_found_by_their_keys, begin),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

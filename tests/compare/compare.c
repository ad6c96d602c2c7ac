/* Comparing a traced frame with copies of it that differ in one place, everywhere, and in what may differ. */
#include <math.h>
#include "compare/compare.h"
#include "kernels/base/num.h"
#include "tests/lcg.h"
#include "tests/trace/small.h"

static ts_trace *ref, *cand;
static char dir[2][SCRATCH_PATH];
static ts_comparison c;

static void open_both(void)
{
	if (ts_trace_open_folder(&ref, dir[0]) != TS_OK || ts_trace_open_folder(&cand, dir[1]) != TS_OK)
		fail_msg("%s", ts_error_message());
}

static int begin(void **state)
{
	ts_params params = small_params();
	ts_trace_options options = {.without = {[TS_B_scene_texel] = true}};
	if (scratch_begin(state) != 0) return -1;
	ts_scene *scene = small_scene(&params);
	snprintf(dir[0], sizeof dir[0], "%s", scratch_path("ref"));
	snprintf(dir[1], sizeof dir[1], "%s", scratch_path("cand"));
	small_trace(dir[0], "epr", scene, &params, options);
	small_copy(dir[1], dir[0]);
	ts_scene_free(scene);
	open_both();
	return 0;
}

static int end(void **state)
{
	ts_trace_close(ref);
	ts_trace_close(cand);
	return scratch_remove(state);
}

/* Replaces bytes of an element of a trace; returns those that were there in `old`, if wanted. */
static void poke(const ts_trace *trace, ts_buffer_id id, u64 element, u32 offset, const void *data, size_t n, void *old)
{
	FILE *file = fopen(trace->item[id].path, "r+b");
	long at = (long)(trace->item[id].npy.data_at + element * ts_buffer_table[id].element_bytes + offset);
	assert_non_null(file);
	assert_int_equal(fseek(file, at, SEEK_SET), 0);
	if (old != NULL) assert_int_equal(fread(old, 1, n, file), n);
	assert_int_equal(fseek(file, at, SEEK_SET), 0);
	assert_int_equal(fwrite(data, 1, n, file), n);
	assert_int_equal(fclose(file), 0);
}

static ts_status compare(ts_relaxations relaxations) { return ts_compare_traces(&c, ref, cand, &relaxations); }

static void a_trace_is_the_same_as_itself(void **state)
{
	(void)state;
	assert_int_equal(compare((ts_relaxations){.ulp = 0}), TS_OK);
	assert_true(c.n_judged >= 39 && c.n_unlike == 0 && c.n_missing == 0 && c.first == TS_N_BUFFERS);
	for (u32 id = 0; id < TS_N_BUFFERS; id++)
		assert_true(c.verdict[id].n_different == 0 && c.verdict[id].n_relaxed == 0);
}

/* One bit of one component of every field of every buffer: found there, and nowhere else. */
static void a_bit_of_every_field_is_found(void **state)
{
	(void)state;
	u32 seed = 17, n = 0;
	for (u32 id = 0; id < TS_N_BUFFERS; id++) {
		ts_fields fields = ts_fields_of((ts_buffer_id)id);
		u64 elements = ref->item[id].path != NULL ? ref->item[id].npy.n : 0;
		for (u32 f = 0; f < fields.n && elements > 0; f++) {
			const ts_field *field = &fields.field[f];
			u8 old, new;
			u64 element = lcg_below(&seed, (u32)elements);
			u32 component = (seed >> 8) % field->count, offset = field->offset + component * field->bytes;
			poke(cand, (ts_buffer_id)id, element, offset, "", 1, &old);
			new = old ^ 1;
			poke(cand, (ts_buffer_id)id, element, offset, &new, 1, NULL);
			assert_int_equal(compare((ts_relaxations){.ulp = 0}), TS_DIFFERENT);
			const ts_verdict *v = &c.verdict[id];
			bool sums = ts_sum_of((ts_buffer_id)id) != NULL; /* one sum is in two counts */
			u64 wrong = sums && element + 1 < elements ? 2 : 1;
			assert_true(c.n_unlike == 1 && c.first == id && v->n_different == wrong && v->has_first);
			assert_true(v->first.element == element && v->first.field == f && v->first.component == component);
			assert_true(sums ? llabs((i64)(v->first.ref - v->first.cand)) == 1 : (v->first.ref ^ v->first.cand) == 1);
			for (u32 k = 0; k < fields.n; k++) assert_int_equal(v->n_field[k], k == f ? wrong : 0);
			poke(cand, (ts_buffer_id)id, element, offset, &old, 1, NULL);
			n++;
		}
	}
	assert_true(n > 100);
	assert_int_equal(compare((ts_relaxations){.ulp = 0}), TS_OK);
}

/* Values of one float, the reference's and the candidate's, and what each relaxation says of them. */
static void each_relaxation_passes_what_it_says(void **state)
{
	(void)state;
	enum { ULP1, ULP3, ABS, REL, N };
	static const ts_relaxations relaxed[N] = {{.ulp = 1}, {.ulp = 3}, {.abs = 0.25}, {.rel = 0.25}};
	static const struct {
		f32 ref, cand;
		bool same, passes[N];
	} cases[] = {
		{1.0f, 1.0f, true, {true, true, true, true}},
		{1.0f, 0x1.000002p+0f, false, {true, true, true, true}},
		{1.0f, 0x1.000006p+0f, false, {false, true, true, true}},
		{1.0f, 1.25f, false, {false, false, true, true}},
		{1.0f, 1.2500001f, false, {false, false, false, false}},
		{0x1.000002p+0f, 1.0f, false, {true, true, true, true}},
		{0x1.000006p+0f, 1.0f, false, {false, true, true, true}},
		{4.0f, 3.0f, false, {false, false, false, true}},
		{0.0f, -0.0f, false, {true, true, true, true}},
		{0.0f, 0x1p-149f, false, {true, true, true, false}},
		{0.0f, 0.25f, false, {false, false, true, false}},
		{INFINITY, 5.0f, false, {false, false, false, false}},
		{5.0f, INFINITY, false, {false, false, false, false}},
		{INFINITY, -INFINITY, false, {false, false, false, false}},
		{INFINITY, INFINITY, true, {true, true, true, true}},
		{NAN, NAN, false, {false, false, false, false}},
		{1.0f, NAN, false, {false, false, false, false}},
		{NAN, 1.0f, false, {false, false, false, false}},
		{-1.0f, 1.0f, false, {false, false, false, false}},
	};
	f32 old;
	for (u32 i = 0; i < sizeof cases / sizeof *cases; i++) {
		poke(ref, TS_B_image_radiance, 777, 0, &cases[i].ref, 4, &old);
		poke(cand, TS_B_image_radiance, 777, 0, &cases[i].cand, 4, NULL);
		ts_status exact = compare((ts_relaxations){.ulp = 0});
		if (exact != (cases[i].same ? TS_OK : TS_DIFFERENT)) fail_msg("case %u, exactly", (unsigned)i);
		for (u32 r = 0; r < N; r++) {
			if (compare(relaxed[r]) != (cases[i].passes[r] ? TS_OK : TS_DIFFERENT))
				fail_msg("case %u, %u", (unsigned)i, (unsigned)r);
			bool used = cases[i].passes[r] && !cases[i].same;
			assert_int_equal(c.verdict[TS_B_image_radiance].n_relaxed, used);
		}
		poke(ref, TS_B_image_radiance, 777, 0, &old, 4, NULL);
		poke(cand, TS_B_image_radiance, 777, 0, &old, 4, NULL);
	}
}

/* A NaN in a record of other fields, in both, with all else equal; none in what only looks like one. */
static void a_nan_in_both_is_different(void **state)
{
	(void)state;
	u32 nan = 0xffc00000u, old, centre;
	for (u32 i = 0; i < 2; i++) {
		ts_trace *t = i == 0 ? ref : cand;
		poke(t, TS_B_points_record, 3, offsetof(ts_point, flags), &nan, 4, &old);
	}
	assert_int_equal(compare((ts_relaxations){.ulp = 0}), TS_OK);
	for (u32 i = 0; i < 2; i++) {
		ts_trace *t = i == 0 ? ref : cand;
		poke(t, TS_B_points_record, 3, offsetof(ts_point, flags), &old, 4, NULL);
		poke(t, TS_B_points_record, 3, offsetof(ts_point, centre) + 8, &nan, 4, i == 0 ? &centre : NULL);
	}
	assert_int_equal(compare((ts_relaxations){.ulp = 9, .abs = 9, .rel = 9}), TS_DIFFERENT);
	assert_true(c.first == TS_B_points_record && c.verdict[c.first].first.element == 3 &&
	            c.verdict[c.first].first.component == 2);
	assert_int_equal(compare((ts_relaxations){.ignore = "points.record.centre"}), TS_OK);
	for (u32 i = 0; i < 2; i++)
		poke(i == 0 ? ref : cand, TS_B_points_record, 3, offsetof(ts_point, centre) + 8, &centre, 4, NULL);
}

static void allowed_and_ignored_elements_pass(void **state)
{
	(void)state;
	static const struct {
		const char *ignore;
		ts_status status;
	} cases[] = {
		{"mirror_pixel.record", TS_OK},
		{"mirror_pixel.record.normal", TS_OK},
		{"cull.keep,mirror_pixel.record.normal", TS_OK},
		{"mirror_pixel.record.position", TS_DIFFERENT},
		{"mirror_pixel.offset", TS_DIFFERENT},
		{"mirror_pixel", TS_ERROR},
		{"mirror_pixel.record.", TS_ERROR},
		{"mirror_pixel.record.normals", TS_ERROR},
		{"mirror_pixel.record,", TS_ERROR},
		{"", TS_ERROR},
		{" mirror_pixel.record", TS_ERROR},
		{"image.srgb.", TS_ERROR},
		{"mirror_pixel.record.norma", TS_ERROR},
	};
	f32 old[2], value = 0.123f;
	u32 at = offsetof(ts_pixel, normal);
	for (u32 i = 0; i < 2; i++) poke(cand, TS_B_mirror_pixel_record, 5 + i, at, &value, 4, &old[i]);
	for (u32 i = 0; i < sizeof cases / sizeof *cases; i++) {
		if (compare((ts_relaxations){.ignore = cases[i].ignore}) != cases[i].status)
			fail_msg("--ignore \"%s\"", cases[i].ignore);
		if (cases[i].status == TS_ERROR) says("no buffer and no field");
	}
	assert_int_equal(compare((ts_relaxations){.allow = 1}), TS_DIFFERENT);
	assert_int_equal(c.verdict[TS_B_mirror_pixel_record].n_different, 2);
	assert_int_equal(compare((ts_relaxations){.allow = 2}), TS_OK);
	assert_int_equal(c.verdict[TS_B_mirror_pixel_record].n_different, 2);
	for (u32 i = 0; i < 2; i++) poke(cand, TS_B_mirror_pixel_record, 5 + i, at, &old[i], 4, NULL);
	assert_int_equal(compare((ts_relaxations){.ignore = "image.srgb"}), TS_OK);
	assert_int_equal(c.verdict[TS_B_image_srgb].judgement, TS_IGNORED);
}

static void masked_pixels_are_not_judged(void **state)
{
	(void)state;
	static u8 mask[64 * 36];
	u8 old, new;
	u64 pixel = 20 * 64 + 33;
	poke(cand, TS_B_image_srgb, 3 * pixel + 1, 0, "", 1, &old);
	new = old ^ 0x55;
	poke(cand, TS_B_image_srgb, 3 * pixel + 1, 0, &new, 1, NULL);
	memset(mask, 1, sizeof mask);
	ts_relaxations r = {.mask = mask, .mask_width = 64, .mask_height = 36};
	assert_int_equal(compare(r), TS_DIFFERENT);
	assert_int_equal(c.verdict[TS_B_image_srgb].first.element, 3 * pixel + 1);
	mask[pixel] = 0;
	assert_int_equal(compare(r), TS_OK);
	assert_true(c.verdict[TS_B_image_srgb].n_masked == 3 && c.verdict[TS_B_eye_depth_triangle].n_masked == 1);
	assert_int_equal(c.verdict[TS_B_points_record].n_masked, 0);
	mask[pixel] = 1;
	mask[pixel + 1] = 0;
	assert_int_equal(compare(r), TS_DIFFERENT);
	static u8 marks[64 * 36 * 3];
	ts_verdict v = {.marks = marks};
	const ts_order same = {.given = false};
	r.mask = NULL;
	assert_int_equal(ts_compare_buffer(&v, TS_B_image_srgb, ref, cand, &same, &r), TS_OK);
	for (u64 i = 0; i < sizeof marks; i++) assert_int_equal(marks[i], i == 3 * pixel + 1);
	poke(cand, TS_B_image_srgb, 3 * pixel + 1, 0, &old, 1, NULL);
}

/* Sums of a trace, or those of the candidate written again. */
static u32 *sums_of(ts_buffer_id id)
{
	size_t bytes;
	char *data = file_read(ref->item[id].path, &bytes);
	u64 at = ref->item[id].npy.data_at;
	memmove(data, data + at, bytes - at);
	return (u32 *)(void *)data;
}

static void put_sums(ts_buffer_id id, const u32 *sums) { poke(cand, id, 0, 0, sums, ref->item[id].npy.n * 4, NULL); }

/* A wrong count, which moves all sums behind it: the first, the last, and where parts of the file begin and end. */
static void a_wrong_count_is_one_difference(void **state)
{
	(void)state;
	const ts_relaxations exact = {.ulp = 0};
	const ts_buffer_id id = TS_B_split_offset;
	ts_comparison *listed = ts_comparison_make(3);
	u64 n = ref->item[id].npy.n;
	u32 *right = sums_of(id), *wrong = sums_of(id);
	const u64 counts[] = {0, 1, 254, 255, 256, 257, n / 2, n - 3, n - 2};
	assert_non_null(listed);
	assert_true(n > 1000);
	for (u32 i = 0; i < sizeof counts / sizeof *counts; i++) {
		u64 at = counts[i];
		char where[TS_WHERE_TEXT];
		for (u64 k = 0; k < n; k++) wrong[k] = right[k] + (k > at ? 3 : 0);
		put_sums(id, wrong);
		assert_int_equal(ts_compare_traces(listed, ref, cand, &exact), TS_DIFFERENT);
		const ts_verdict *v = &listed->verdict[id];
		const ts_difference *d = &v->list.items[0].difference;
		assert_true(v->n_different == 1 && v->list.n == 1 && listed->n_unlike == 1);
		assert_int_equal(d->ref, right[at + 1] - right[at]);
		assert_int_equal(d->cand, right[at + 1] - right[at] + 3);
		snprintf(where, sizeof where, "count of triangle %u (element %u less element %u)", (unsigned)at,
		         (unsigned)at + 1, (unsigned)at);
		assert_string_equal(v->list.items[0].where, where);
	}
	put_sums(id, right);
	ts_comparison_free(listed);
	free(right);
	free(wrong);
}

/* What a plain look at all counts finds, of sums that begin elsewhere, fall, and move back. */
static void sums_are_judged_by_their_counts(void **state)
{
	(void)state;
	const ts_buffer_id id = TS_B_points_offset;
	u64 n = ref->item[id].npy.n;
	u32 *right = sums_of(id), *wrong = sums_of(id), seed = 5;
	for (u32 round = 0; round < 30; round++) {
		u64 first = n, n_wrong = 0;
		u32 moved = round % 3 == 0 ? 7 : 0;
		for (u64 k = 0; k < n; k++) {
			if (lcg_next(&seed) >> 8 < 1u << 24 >> round / 2) moved += (seed & 3) - 1;
			wrong[k] = right[k] + moved;
			u32 ours = k > 0 ? right[k] - right[k - 1] : right[k], theirs = k > 0 ? wrong[k] - wrong[k - 1] : wrong[k];
			if (ours != theirs && n_wrong++ == 0) first = k;
		}
		put_sums(id, wrong);
		assert_int_equal(compare((ts_relaxations){.ulp = 0}), n_wrong > 0 ? TS_DIFFERENT : TS_OK);
		assert_int_equal(c.verdict[id].n_different, n_wrong);
		if (n_wrong > 0) assert_int_equal(c.verdict[id].first.element, first);
		if (round % 3 == 0) assert_true(first == 0 && c.verdict[id].first.cand != 0);
		assert_int_equal(compare((ts_relaxations){.allow = n_wrong}), TS_OK);
	}
	put_sums(id, right);
	free(right);
	free(wrong);
}

/* Records that differ in one field, another and both; what is ignored, or near enough, is in no count. */
static void differences_are_counted_by_field(void **state)
{
	(void)state;
	const ts_buffer_id id = TS_B_mirror_pixel_record;
	enum { N = 15 };
	ts_pixel old[N];
	const ts_verdict *v = &c.verdict[id];
	for (u32 i = 0; i < N; i++) {
		ts_pixel new = {.index = 0};
		poke(cand, id, 3 * i, 0, &new, sizeof new, &old[i]);
		new = old[i];
		if (i < 12) new.position[0] = ts_u2f(ts_f2u(new.position[0]) ^ 1);
		if (i < 12) new.position[2] = ts_u2f(ts_f2u(new.position[2]) ^ 1);
		if (i > 9) new.normal[1] = -new.normal[1] - 1;
		poke(cand, id, 3 * i, 0, &new, sizeof new, NULL);
	}
	static const struct {
		ts_relaxations relaxations;
		u64 n, position, normal;
	} cases[] = {
		{{.ulp = 0}, 15, 12, 5},
		{{.ulp = 1}, 5, 0, 5},
		{{.ignore = "mirror_pixel.record.position"}, 5, 0, 5},
		{{.ignore = "mirror_pixel.record.normal"}, 12, 12, 0},
	};
	for (u32 i = 0; i < sizeof cases / sizeof *cases; i++) {
		assert_int_equal(compare(cases[i].relaxations), TS_DIFFERENT);
		const ts_fields fields = ts_fields_of(id);
		assert_int_equal(v->n_different, cases[i].n);
		for (u32 f = 0; f < fields.n; f++) {
			bool position = strcmp(fields.field[f].name, "position") == 0;
			bool normal = strcmp(fields.field[f].name, "normal") == 0;
			assert_int_equal(v->n_field[f], position ? cases[i].position : normal ? cases[i].normal : 0);
		}
	}
	for (u32 i = 0; i < N; i++) poke(cand, id, 3 * i, 0, &old[i], sizeof old[i], NULL);
}

/* The first differences of each buffer, as many as there is room for, or as there are. */
static void the_first_differences_are_listed(void **state)
{
	(void)state;
	const ts_relaxations exact = {.ulp = 0};
	u8 old[7], wrong;
	for (u32 i = 0; i < 7; i++) {
		poke(cand, TS_B_image_srgb, 100 * i + 1, 0, "", 1, &old[i]);
		wrong = old[i] ^ 0x11;
		poke(cand, TS_B_image_srgb, 100 * i + 1, 0, &wrong, 1, NULL);
	}
	for (u32 most = 1; most < 10; most++) {
		ts_comparison *listed = ts_comparison_make(most);
		assert_non_null(listed);
		for (u32 again = 0; again < 2; again++) {
			assert_int_equal(ts_compare_traces(listed, ref, cand, &exact), TS_DIFFERENT);
			const ts_differences *list = &listed->verdict[TS_B_image_srgb].list;
			assert_int_equal(list->n, most < 7 ? most : 7);
			assert_int_equal(listed->verdict[TS_B_image_radiance].list.n, 0);
			for (u32 i = 0; i < list->n; i++) {
				const ts_difference *d = &list->items[i].difference;
				assert_true(d->how == TS_UNEQUAL && d->element == 100 * i + 1 && d->ref == old[i]);
				assert_int_equal(d->cand, old[i] ^ 0x11);
			}
			assert_string_equal(list->items[0].where, "pixel (0, 0) [1]");
		}
		ts_comparison_free(listed);
	}
	for (u32 i = 0; i < 7; i++) poke(cand, TS_B_image_srgb, 100 * i + 1, 0, &old[i], 1, NULL);
}

/* Writes a buffer of the candidate again with other rows, and opens it. */
static void resized(ts_buffer_id id, const char *shape, i64 rows)
{
	size_t bytes;
	char descr[TS_NPY_DESCR];
	u64 at = cand->item[id].npy.data_at, row = ts_buffer_table[id].element_bytes;
	char *data = file_read(ref->item[id].path, &bytes), *path = strdup(cand->item[id].path);
	data = realloc(data, bytes + 4096);
	assert_non_null(data);
	memset(data + bytes, 0, 4096);
	ts_npy_descr(descr, id);
	npy_write(path, descr, shape, data + at, (size_t)((i64)(ref->item[id].npy.n * row) + rows * (i64)row));
	ts_trace_close(cand);
	if (ts_trace_open_folder(&cand, dir[1]) != TS_OK) fail_msg("%s", ts_error_message());
	free(path);
	free(data);
}

static void restored(ts_buffer_id id)
{
	size_t bytes;
	char *data = file_read(ref->item[id].path, &bytes);
	file_write(cand->item[id].path, data, bytes);
	free(data);
	ts_trace_close(cand);
	assert_int_equal(ts_trace_open_folder(&cand, dir[1]), TS_OK);
}

static void another_number_of_elements_is_told(void **state)
{
	(void)state;
	char shape[64];
	u64 n = ref->item[TS_B_split_piece].npy.n;
	snprintf(shape, sizeof shape, "(%u,)", (unsigned)n - 2);
	resized(TS_B_split_piece, shape, -2);
	assert_int_equal(compare((ts_relaxations){.ulp = 0}), TS_DIFFERENT);
	const ts_verdict *v = &c.verdict[TS_B_split_piece];
	assert_true(c.first == TS_B_split_piece && v->n_different == 2 && !v->has_first && v->n_cand == n - 2);
	snprintf(shape, sizeof shape, "(%u,)", (unsigned)n + 3);
	resized(TS_B_split_piece, shape, 3);
	assert_int_equal(compare((ts_relaxations){.ulp = 0}), TS_DIFFERENT);
	assert_int_equal(v->n_different, 3);
	restored(TS_B_split_piece);
	resized(TS_B_image_srgb, "(35, 64, 3)", -64 * 3);
	assert_int_equal(compare((ts_relaxations){.ulp = 0}), TS_ERROR);
	says("shape 35 x 64 x 3; the reference's is 36 x 64 x 3");
	resized(TS_B_image_srgb, "(64, 36, 3)", 0);
	assert_int_equal(compare((ts_relaxations){.ulp = 0}), TS_ERROR);
	restored(TS_B_image_srgb);
}

static void nothing_to_judge_is_an_error(void **state)
{
	(void)state;
	ts_trace *none, *other;
	ts_relaxations exact = {.ulp = 0};
	assert_int_equal(ts_trace_open_layout(&none, dir[1], "", false, ref), TS_OK);
	assert_int_equal(ts_compare_traces(&c, ref, none, &exact), TS_ERROR);
	says("nothing to judge");
	assert_true(c.n_missing >= 39 && c.verdict[TS_B_image_srgb].judgement == TS_MISSING);
	none->pipeline = ts_pipeline_find("reflections", "mvr");
	assert_int_equal(ts_compare_traces(&c, ref, none, &exact), TS_ERROR);
	says("a trace of mvr; the reference's is of epr");
	ts_trace_close(none);
	assert_int_equal(ts_trace_open_layout(&other, dir[1], "points.key=11-points.key.npy", true, ref), TS_OK);
	assert_int_equal(ts_compare_traces(&c, other, ref, &exact), TS_ERROR);
	says("in order of arrival, so it is no reference");
	ts_trace_close(other);
}

int main(void)
{
	const struct CMUnitTest compare_tests[] = {
		cmocka_unit_test(a_trace_is_the_same_as_itself),       cmocka_unit_test(a_bit_of_every_field_is_found),
		cmocka_unit_test(each_relaxation_passes_what_it_says), cmocka_unit_test(a_nan_in_both_is_different),
		cmocka_unit_test(allowed_and_ignored_elements_pass),   cmocka_unit_test(masked_pixels_are_not_judged),
		cmocka_unit_test(another_number_of_elements_is_told),  cmocka_unit_test(nothing_to_judge_is_an_error),
		cmocka_unit_test(a_wrong_count_is_one_difference),     cmocka_unit_test(sums_are_judged_by_their_counts),
		cmocka_unit_test(differences_are_counted_by_field),    cmocka_unit_test(the_first_differences_are_listed),
	};
	return cmocka_run_group_tests(compare_tests, begin, end);
}

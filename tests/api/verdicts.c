/* All that verdicts say: bits planted at random places of several buffers are listed, counted by field and marked there
 * and nowhere else; and a part of a comparison says what the whole does. */
#include <unistd.h>
#include "tests/api/run.h"
#include "tests/lcg.h"

enum { PLANTED = 7 };

static ts_trace *candidate;

static int begin(void **state)
{
	run_begin(state);
	candidate = candidate_of(reference, 0);
	return 0;
}

static int end(void **state)
{
	ts_trace_close(candidate);
	return run_end(state);
}

/* A copy of a buffer with the bit `bit` of each of at most n elements the other way, which `wrong` marks. */
static uint8_t *plant(const ts_buffer_view *v, size_t bit, uint32_t n, uint8_t *wrong, uint32_t *seed)
{
	uint8_t *copy = malloc(bytes_of(v));
	assert_non_null(copy);
	memcpy(copy, v->data, bytes_of(v));
	for (uint32_t i = 0; i < n; i++) {
		size_t e = lcg_below(seed, (uint32_t)count_of(v));
		if (wrong[e] != 0) continue;
		copy[e * v->element_bytes + bit / 8] ^= (uint8_t)(1 << bit % 8);
		wrong[e] = 1;
	}
	return copy;
}

static size_t place_of(const ts_verdicts *verdicts, const char *buffer)
{
	size_t i = 0;
	while (strcmp(ts_verdicts_at(verdicts, i)->buffer, buffer) != 0) i++;
	return i;
}

/* The list, the count, the first and the marks are those of `wrong`. */
static void check(const ts_buffer_view *v, const uint8_t *wrong, const char *field, uint32_t most)
{
	ts_verdicts *verdicts;
	const ts_divergence *d;
	const ts_compare_options options = {.bytes = sizeof options, .first = most};
	uint8_t *marks = malloc(count_of(v));
	size_t n = 0, listed = 0;
	assert_non_null(marks);
	memset(marks, 7, count_of(v));
	assert_int_equal(ts_compare(context, &verdicts, reference, candidate, &options), TS_DIFFERENT);
	size_t place = place_of(verdicts, v->name);
	for (size_t e = 0; e < count_of(v); e++) {
		if (wrong[e] == 0) continue;
		d = ts_verdicts_difference(verdicts, place, listed);
		if (n++ >= (most > 0 ? most : 1)) continue;
		assert_int_equal(d->element, e);
		assert_string_equal(d->field, field);
		assert_int_equal(strncmp(d->spot, field, strlen(field)), 0);
		assert_int_equal(d->bytes, 4);
		assert_non_null(strstr(d->line, d->where));
		assert_true(d->reference[0] != 0 && strcmp(d->reference, d->candidate) != 0);
		assert_non_null(strstr(d->line, d->reference));
		listed++;
	}
	assert_null(ts_verdicts_difference(verdicts, place, listed));
	const ts_verdict_info *info = ts_verdicts_at(verdicts, place);
	assert_int_equal(info->n_different, n);
	assert_int_equal(info->judgement, TS_UNLIKE);
	assert_true(info->has_first && wrong[info->first_element] != 0);
	assert_string_equal(info->line, ts_verdicts_difference(verdicts, place, 0)->line);
	if (field[0] != 0) {
		assert_string_equal(ts_verdicts_field(verdicts, place, 0)->field, field);
		assert_int_equal(ts_verdicts_field(verdicts, place, 0)->n_different, n);
		assert_non_null(strstr(info->note, field));
	}
	assert_null(ts_verdicts_field(verdicts, place, field[0] != 0));
	assert_int_equal(ts_compare_marks(context, marks, count_of(v), v->name, reference, candidate, &options),
	                 TS_DIFFERENT);
	assert_memory_equal(marks, wrong, count_of(v));
	ts_verdicts_free(verdicts);
	free(marks);
}

static void planted_bits_are_listed_and_marked(void **state)
{
	(void)state;
	static const struct {
		const char *buffer, *field;
		size_t bit;
		uint32_t n;
	} places[] = {{"image.radiance", "", 0, PLANTED},
	              {"mirror_pixel.record", "normal", 8 * offsetof(ts_pixel, normal), PLANTED},
	              {"pose.vertex", "normal", 8 * offsetof(ts_vertex, normal) + 3, PLANTED},
	              {"pose.vertex", "position", 8 * offsetof(ts_vertex, position), 1}};
	uint32_t seed = 5;
	for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
		const ts_buffer_view *v = ts_trace_buffer(reference, places[i].buffer);
		assert_non_null(v);
		uint8_t *wrong = calloc(count_of(v), 1);
		assert_non_null(wrong);
		uint8_t *copy = plant(v, places[i].bit, places[i].n, wrong, &seed);
		put(candidate, v, copy);
		check(v, wrong, places[i].field, 0);
		check(v, wrong, places[i].field, 3);
		check(v, wrong, places[i].field, 100);
		put(candidate, v, v->data);
		free(copy);
		free(wrong);
	}
}

/* Too few marks, and a file that has become shorter since its trace was opened. */
static void too_few_marks_are_refused(void **state)
{
	(void)state;
	const ts_buffer_view *v = ts_trace_buffer(reference, "pose.vertex");
	char folder[FOLDER], path[PATH];
	ts_trace *saved;
	uint8_t *marks = malloc(count_of(v));
	assert_non_null(marks);
	refused(ts_compare_marks(context, marks, count_of(v) - 1, v->name, reference, candidate, NULL), "marks");
	make_folder(folder);
	snprintf(path, sizeof path, "%s/saved", folder);
	done(ts_trace_save(context, reference, path, NULL));
	done(ts_trace_open(context, &saved, path));
	snprintf(path, sizeof path, "%s/saved/02-pose.vertex.npy", folder);
	assert_int_equal(truncate(path, 4096), 0);
	refused(ts_compare_marks(context, marks, count_of(v), v->name, reference, saved, NULL), "shorter");
	ts_trace_close(saved);
	remove_folder(folder);
	free(marks);
}

/* The candidate with wrong bits in two buffers. */
typedef struct {
	const ts_buffer_view *early, *late;
	uint8_t *wrong, *copies[2];
} planted;

static planted plant_two(const char *early, const char *late, uint32_t seed)
{
	planted p = {.early = ts_trace_buffer(reference, early), .late = ts_trace_buffer(reference, late)};
	p.wrong = calloc(count_of(p.early) + count_of(p.late), 1);
	assert_non_null(p.wrong);
	p.copies[0] = plant(p.early, 0, PLANTED, p.wrong, &seed);
	p.copies[1] = plant(p.late, 0, PLANTED, p.wrong + count_of(p.early), &seed);
	put(candidate, p.early, p.copies[0]);
	put(candidate, p.late, p.copies[1]);
	return p;
}

static void mend_two(planted *p)
{
	put(candidate, p->early, p->early->data);
	put(candidate, p->late, p->late->data);
	free(p->wrong);
	free(p->copies[0]);
	free(p->copies[1]);
}

/* Of two buffers that differ each has its list; the first divergence is that of the first stage. */
static void each_buffer_that_differs_has_its_list(void **state)
{
	(void)state;
	ts_verdicts *verdicts;
	planted p = plant_two("pose.vertex", "image.radiance", 9);
	assert_int_equal(ts_compare(context, &verdicts, reference, candidate, NULL), TS_DIFFERENT);
	const ts_divergence *first = ts_verdicts_first(verdicts);
	assert_string_equal(first->buffer, "pose.vertex");
	ts_tree *tree = ts_verdicts_tree(verdicts);
	const ts_tree *all = ts_tree_get(tree, "differences"), *divergence = ts_tree_get(tree, "divergence");
	assert_int_equal(ts_tree_n(all), 2);
	assert_string_equal(ts_tree_text(ts_tree_get(ts_tree_at(all, 0), "buffer")), "pose.vertex");
	assert_string_equal(ts_tree_text(ts_tree_get(ts_tree_at(all, 1), "buffer")), "image.radiance");
	assert_string_equal(ts_tree_text(ts_tree_get(tree, "first_divergence")), first->line);
	assert_string_equal(ts_tree_text(ts_tree_get(divergence, "stage")), "pose");
	assert_int_equal(ts_tree_integer(ts_tree_get(divergence, "element")), first->element);
	ts_tree_free(tree);
	ts_verdicts_free(verdicts);
	mend_two(&p);
}

/* Only what the named stages make is judged; what they read is looked at, to say whether it is the same. */
static void only_named_stages_are_judged(void **state)
{
	(void)state;
	ts_verdicts *verdicts;
	const ts_verdict_info *info;
	planted p = plant_two("pose.vertex", "eye.depth_triangle", 11);
	ts_compare_options options = {.bytes = sizeof options, .stages = "eye,image"};
	assert_int_equal(ts_compare(context, &verdicts, reference, candidate, &options), TS_DIFFERENT);
	for (size_t i = 0; (info = ts_verdicts_at(verdicts, i)) != NULL; i++) {
		const bool own = strcmp(info->stage, "eye") == 0 || strcmp(info->stage, "image") == 0;
		assert_int_equal(info->judgement >= TS_SAME, own);
	}
	assert_string_equal(ts_verdicts_first(verdicts)->buffer, "eye.depth_triangle");
	assert_string_equal(ts_verdicts_first(verdicts)->inputs, "inputs differ: pose.vertex");
	ts_verdicts_free(verdicts);
	options.stages = "image";
	done(ts_compare(context, &verdicts, reference, candidate, &options));
	ts_verdicts_free(verdicts);
	options.stages = "";
	done(ts_compare(context, &verdicts, reference, candidate, &options));
	ts_verdicts_free(verdicts);
	options.stages = "image,eyes";
	refused(ts_compare(context, &verdicts, reference, candidate, &options), "\"eyes\" is no stage of epr");
	options = (ts_compare_options){.bytes = sizeof options, .stages = "eye", .forced = 1};
	assert_int_equal(ts_compare(context, &verdicts, reference, candidate, &options), TS_DIFFERENT);
	ts_verdicts_free(verdicts);
	mend_two(&p);
}

static void equal_buffers_have_no_marks(void **state)
{
	(void)state;
	const ts_buffer_view *image = ts_trace_buffer(reference, "image.srgb");
	uint8_t *marks = malloc(count_of(image));
	assert_non_null(marks);
	memset(marks, 1, count_of(image));
	done(ts_compare_marks(context, marks, count_of(image), "image.srgb", reference, candidate, NULL));
	for (size_t i = 0; i < count_of(image); i++) assert_int_equal(marks[i], 0);
	refused(ts_compare_marks(context, marks, 5, "image.srgb", reference, candidate, NULL), "5 marks");
	refused(ts_compare_marks(context, marks, 5, "image.blue", reference, candidate, NULL), "image.blue");
	refused(ts_compare_marks(context, marks, 0, "mirror.radiance", reference, candidate, NULL), "mirror.radiance");
	const ts_compare_options below = {.bytes = sizeof below, .abs = -1};
	refused(ts_compare_marks(context, marks, count_of(image), "image.srgb", reference, candidate, &below), "abs: -1");
	free(marks);
}

/* Another number of elements than the reference has is told, without a difference that could be listed. */
static void a_shorter_buffer_has_no_difference(void **state)
{
	(void)state;
	ts_verdicts *verdicts;
	const ts_buffer_view *v = ts_trace_buffer(reference, "split.piece");
	const uint64_t shape[] = {v->shape[0] - 1};
	assert_int_equal(v->n_dims, 1);
	done(ts_trace_put(candidate, v->name, 1, shape, v->data, bytes_of(v) - v->element_bytes));
	assert_int_equal(ts_compare(context, &verdicts, reference, candidate, NULL), TS_DIFFERENT);
	const size_t place = place_of(verdicts, "split.piece");
	assert_null(ts_verdicts_difference(verdicts, place, 0));
	assert_string_equal(ts_verdicts_first(verdicts)->buffer, "split.piece");
	assert_int_equal(ts_verdicts_at(verdicts, place)->has_first, 0);
	assert_non_null(strstr(ts_verdicts_first(verdicts)->line, "equal as far as both go"));
	assert_string_equal(ts_verdicts_first(verdicts)->line, ts_verdicts_at(verdicts, place)->line);
	ts_verdicts_free(verdicts);
	put(candidate, v, v->data);
}

/* The pairs of a traversal are a set with an order of its own: in any order they are the same, and one that is repeated
 * in the place of another is beside, the other missing. */
static void pairs_are_the_same_in_any_order(void **state)
{
	(void)state;
	ts_trace *trace, *arrived;
	ts_verdicts *verdicts;
	done(ts_trace_run(context, &trace, scene, params, "indirect", "megaviews", NULL));
	const ts_buffer_view *pairs = ts_trace_buffer(trace, "traverse.rendered");
	const size_t n = count_of(pairs);
	const uint64_t *right = pairs->data;
	uint64_t *turned = malloc(bytes_of(pairs));
	assert_true(turned != NULL && n > 10);
	for (size_t i = 0; i < n; i++) turned[i] = right[n - 1 - i];
	arrived = candidate_of(trace, 1);
	put(arrived, pairs, turned);
	done(ts_compare(context, &verdicts, trace, arrived, NULL));
	assert_int_equal(ts_verdicts_at(verdicts, place_of(verdicts, pairs->name))->judgement, TS_SAME);
	ts_verdicts_free(verdicts);
	turned[2] = turned[5];
	assert_int_equal(ts_compare(context, &verdicts, trace, arrived, NULL), TS_DIFFERENT);
	const ts_verdict_info *info = ts_verdicts_at(verdicts, place_of(verdicts, pairs->name));
	assert_true(info->n_missing == 1 && info->n_extra == 1 && info->n_different == 2);
	assert_string_equal(ts_verdicts_first(verdicts)->how, "missing");
	assert_int_equal(ts_verdicts_first(verdicts)->element, n - 1 - 2);
	ts_verdicts_free(verdicts);
	ts_trace_close(arrived);
	ts_trace_close(trace);
	free(turned);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(planted_bits_are_listed_and_marked),    cmocka_unit_test(too_few_marks_are_refused),
		cmocka_unit_test(each_buffer_that_differs_has_its_list), cmocka_unit_test(only_named_stages_are_judged),
		cmocka_unit_test(equal_buffers_have_no_marks),           cmocka_unit_test(a_shorter_buffer_has_no_difference),
		cmocka_unit_test(pairs_are_the_same_in_any_order),
	};
	return cmocka_run_group_tests(tests, begin, end);
}

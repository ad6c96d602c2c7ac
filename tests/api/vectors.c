/* Vectors in memory: right outputs pass; of wrong ones the verdict names the item, the value in it, how far it is off,
 * and a known fault. */
#include <math.h>
#include "tests/api/api.h"

static ts_context *context;

static int begin(void **state)
{
	(void)state;
	context = open_context(1);
	return 0;
}

static int end(void **state)
{
	(void)state;
	ts_context_close(context);
	return 0;
}

static const ts_vector_info *primitive(const char *name)
{
	const ts_vector_info *v;
	for (size_t i = 0; (v = ts_vector_at(i)) != NULL && strcmp(v->name, name) != 0; i++) {
	}
	assert_non_null(v);
	return v;
}

/* Words of a primitive, by free(). */
typedef struct {
	uint32_t *in, *out;
} words;

static words words_of(const ts_vector_info *v)
{
	words w = {calloc(v->items, v->in_words * sizeof *w.in), calloc(v->items, v->out_words * sizeof *w.out)};
	assert_true(w.in != NULL && w.out != NULL);
	done(ts_vector_words(context, w.in, w.out, v->name));
	return w;
}

static void drop(words *w)
{
	free(w->in);
	free(w->out);
}

/* The verdict on outputs that are wrong. */
static ts_vector_judged wrong(const ts_vector_info *v, const uint32_t *found)
{
	ts_vector_judged judged = {.bytes = sizeof judged};
	assert_int_equal(ts_vector_check(context, &judged, v->name, found), TS_DIFFERENT);
	return judged;
}

static uint32_t width_of(ts_vector_type type) { return type == TS_VECTOR_I64 || type == TS_VECTOR_U64 ? 2 : 1; }

static uint32_t check_columns(const ts_vector_column_info *columns, uint32_t n)
{
	uint32_t word = 0;
	assert_true(n > 0);
	for (uint32_t i = 0; i < n; i++) {
		assert_true(columns[i].count > 0);
		assert_int_equal(columns[i].word, word);
		word += columns[i].count * width_of(columns[i].type);
	}
	return word;
}

/* Columns fill rows without a gap, and shape and dtype say the same as they. */
static void columns_fill_rows_without_a_gap(void **state)
{
	(void)state;
	const ts_vector_info *v;
	uint32_t n_records = 0, n_arrays = 0;
	for (size_t i = 0; (v = ts_vector_at(i)) != NULL; i++) {
		const ts_vector_column_info *first = v->outputs;
		assert_int_equal(check_columns(v->inputs, v->n_inputs), v->in_words);
		assert_int_equal(check_columns(v->outputs, v->n_outputs), v->out_words);
		assert_true(v->inputs[0].name[0] != 0 && strstr(v->in_dtype, v->inputs[v->n_inputs - 1].name) != NULL);
		assert_int_equal(v->record != 0, v->out_dtype[0] == '[');
		assert_int_equal(v->record != 0, first->name[0] != 0);
		assert_int_equal(v->shape[0], v->items);
		assert_int_equal(v->n_dims, v->record || first->count == 1 ? 1 : 2);
		assert_int_equal(v->shape[1], v->n_dims == 2 ? first->count : 0);
		if (!v->record) assert_int_equal(v->n_outputs, 1);
		n_records += v->record != 0;
		n_arrays += v->n_dims == 2;
	}
	assert_true(n_records > 5 && n_arrays > 5);
	v = primitive("edge");
	assert_int_equal(v->outputs[0].type, TS_VECTOR_I64);
	assert_string_equal(v->out_dtype, "'<i8'");
}

/* Right outputs, and one bit of the last word of one item. */
static void a_wrong_word_is_named(void **state)
{
	(void)state;
	const ts_vector_info *v;
	size_t n = 0;
	for (; (v = ts_vector_at(n)) != NULL; n++) {
		words w = words_of(v);
		ts_vector_judged judged = {.bytes = sizeof judged, .n_wrong = 7, .first_apart = 7, .first_fault = "none"};
		const ts_vector_judged right = {.bytes = sizeof right};
		assert_true(v->rule[0] != 0 && v->in_dtype[0] != 0 && v->out_dtype[0] != 0);
		done(ts_vector_check(context, &judged, v->name, w.out));
		assert_memory_equal(&judged, &right, sizeof right);
		const uint32_t item = (uint32_t)n * 61 % v->items, last = item * v->out_words + v->out_words - 1;
		w.out[last] ^= 0x100;
		judged = wrong(v, w.out);
		const ts_vector_column_info *column = &v->outputs[v->n_outputs - 1];
		const uint32_t width = width_of(column->type);
		assert_int_equal(judged.n_wrong, 1);
		assert_int_equal(judged.first, item);
		assert_int_equal(judged.first_word, v->out_words - width);
		assert_int_equal(judged.first_column, v->n_outputs - 1);
		assert_int_equal(judged.first_element, column->count - 1);
		assert_true(judged.first_nan || llabs(judged.first_apart) == (width == 2 ? 0x100ll << 32 : 0x100));
		assert_int_equal(judged.n_explained, judged.fault != NULL);
		assert_true(judged.first_fault == judged.fault && judged.first_remedy == judged.remedy);
		drop(&w);
	}
	assert_true(n > 40);
}

/* A port that contracts a * b + c. */
static void a_contracting_port_is_told_its_fault(void **state)
{
	(void)state;
	const ts_vector_info *v = primitive("muladd");
	assert_true(v->in_words == 3 && v->out_words == 1);
	words w = words_of(v);
	uint32_t *right = calloc(v->items, sizeof *right);
	assert_non_null(right);
	memcpy(right, w.out, v->items * sizeof *right);
	for (uint32_t i = 0; i < v->items; i++) {
		float x[3], fused;
		memcpy(x, w.in + 3 * i, sizeof x);
		fused = fmaf(x[0], x[1], x[2]);
		memcpy(&w.out[i], &fused, sizeof fused);
	}
	ts_vector_judged judged = wrong(v, w.out);
	assert_true(judged.n_wrong > 100 && judged.fault != NULL && judged.remedy[0] != 0);
	assert_int_equal(judged.n_explained, judged.n_wrong);
	assert_string_equal(judged.fault, "fused multiply-add");
	assert_true(judged.first_fault == judged.fault && judged.first_remedy == judged.remedy);
	/* The first wrong item is nobody's fault. */
	assert_true(judged.first > 0);
	const uint32_t n_wrong = judged.n_wrong;
	w.out[0] = right[0] ^ 0x00300000u;
	judged = wrong(v, w.out);
	assert_int_equal(judged.n_wrong, n_wrong + 1);
	assert_int_equal(judged.n_explained, n_wrong);
	assert_int_equal(judged.first, 0);
	assert_string_equal(judged.fault, "fused multiply-add");
	assert_true(judged.first_fault == NULL && judged.first_remedy == NULL);
	free(right);
	drop(&w);
}

/* The first row whose word `at` can be added to without another word or sign. */
static uint32_t plain_row(const ts_vector_info *v, const uint32_t *out, uint32_t at)
{
	uint32_t item = 0;
	for (; item < v->items; item++) {
		const uint32_t low = out[item * v->out_words + at] & 0x7fffffffu;
		if (low > 100 && low < 0x7fffff00u) break;
	}
	assert_true(item < v->items);
	return item;
}

/* Each type of output, off by so much; a float that is no number. */
static void each_type_tells_its_distance(void **state)
{
	(void)state;
	static const struct {
		const char *primitive;
		ts_vector_type type;
		uint32_t word, add; /* of the row */
		int64_t apart;
	} cases[] = {
		{"sqrt", TS_VECTOR_F32, 0, 2, 2},
		{"floor_i32", TS_VECTOR_I32, 0, 5, 5},
		{"floor_i32", TS_VECTOR_I32, 0, 0u - 2, -2},
		{"pcg", TS_VECTOR_U32, 0, 3, 3},
		{"edge", TS_VECTOR_I64, 0, 1, 1},
		{"edge", TS_VECTOR_I64, 1, 2, (int64_t)2 << 32},
		{"edge", TS_VECTOR_I64, 1, 0u - 1, -((int64_t)1 << 32)},
	};
	for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
		const ts_vector_info *v = primitive(cases[i].primitive);
		words w = words_of(v);
		const uint32_t item = plain_row(v, w.out, cases[i].word);
		assert_int_equal(v->outputs[0].type, cases[i].type);
		w.out[item * v->out_words + cases[i].word] += cases[i].add;
		const ts_vector_judged judged = wrong(v, w.out);
		assert_int_equal(judged.first, item);
		assert_true(judged.first_apart == cases[i].apart && !judged.first_nan);
		drop(&w);
	}
	const ts_vector_info *v = primitive("cross");
	words w = words_of(v);
	uint32_t *at = w.out + 7 * v->out_words + 1;
	*at += 3;
	ts_vector_judged judged = wrong(v, w.out);
	assert_true(judged.first == 7 && judged.first_word == 1 && judged.first_element == 1 && judged.first_column == 0);
	assert_int_equal(llabs(judged.first_apart), 3);
	*at = 0x7fc00000u;
	judged = wrong(v, w.out);
	assert_true(judged.first_nan && judged.first_apart == 0 && judged.first_element == 1);
	drop(&w);
}

/* A program of an older header passes less, one of a newer header more: what it has not, or we, is left alone. */
static void older_and_newer_headers_are_served(void **state)
{
	(void)state;
	const ts_vector_info *v = primitive("add");
	words w = words_of(v);
	struct {
		ts_vector_judged judged;
		uint32_t newer[4];
	} more = {.judged = {.bytes = sizeof more}, .newer = {1, 2, 3, 4}}, before = more;
	w.out[5] ^= 1;
	assert_int_equal(ts_vector_check(context, &more.judged, v->name, w.out), TS_DIFFERENT);
	assert_int_equal(more.judged.first, 5);
	assert_memory_equal(more.newer, before.newer, sizeof more.newer);
	ts_vector_judged less = {.bytes = offsetof(ts_vector_judged, n_explained), .n_explained = 99, .first_apart = 99};
	assert_int_equal(ts_vector_check(context, &less, v->name, w.out), TS_DIFFERENT);
	assert_int_equal(less.first, 5);
	assert_true(less.n_explained == 99 && less.first_apart == 99);
	less.bytes--;
	refused(ts_vector_check(context, &less, v->name, w.out), "bytes");
	refused(ts_vector_check(context, &more.judged, "magic", w.out), "magic");
	assert_int_equal(more.judged.n_wrong, 1);
	drop(&w);
}

/* A context asked for one primitive and for another by turns, whose caller writes into what it was given. */
static void primitives_may_be_asked_by_turns(void **state)
{
	(void)state;
	const ts_vector_info *a = primitive("add"), *b = primitive("cross");
	words of_a = words_of(a), of_b = words_of(b);
	ts_vector_judged judged = {.bytes = sizeof judged};
	memset(of_b.in, 0, b->items * b->in_words * sizeof *of_b.in);
	done(ts_vector_check(context, &judged, b->name, of_b.out));
	done(ts_vector_check(context, &judged, a->name, of_a.out));
	words again = words_of(a);
	assert_memory_equal(again.in, of_a.in, a->items * a->in_words * sizeof *again.in);
	refused(ts_vector_words(context, NULL, NULL, "magic"), "magic");
	done(ts_vector_check(context, &judged, a->name, of_a.out));
	drop(&again);
	drop(&of_a);
	drop(&of_b);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(columns_fill_rows_without_a_gap),      cmocka_unit_test(a_wrong_word_is_named),
		cmocka_unit_test(a_contracting_port_is_told_its_fault), cmocka_unit_test(each_type_tells_its_distance),
		cmocka_unit_test(older_and_newer_headers_are_served),   cmocka_unit_test(primitives_may_be_asked_by_turns),
	};
	return cmocka_run_group_tests(tests, begin, end);
}

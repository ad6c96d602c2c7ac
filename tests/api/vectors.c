/* Vectors in memory: right outputs pass, each wrong word is told with its item, and a known fault by its name. */
#include "api.h"
#include <math.h>

static void test_words(void **state)
{
	(void)state;
	ts_context *context = open_context(1);
	const ts_vector_info *v;
	size_t n = 0;
	for (; (v = ts_vector_at(n)) != NULL; n++) {
		uint32_t *in = calloc(v->items, v->in_words * sizeof *in), *out = calloc(v->items, v->out_words * sizeof *out);
		assert_true(in != NULL && out != NULL && v->rule[0] != 0 && v->in_dtype[0] != 0 && v->out_dtype[0] != 0);
		done(ts_vector_words(context, in, out, v->name));
		ts_vector_judged judged = {.bytes = sizeof judged};
		done(ts_vector_check(context, &judged, v->name, out));
		assert_int_equal(judged.n_wrong, 0);
		assert_null(judged.fault);
		uint32_t item = (uint32_t)n * 61 % v->items;
		out[item * v->out_words + v->out_words - 1] ^= 0x100;
		assert_int_equal(ts_vector_check(context, &judged, v->name, out), TS_DIFFERENT);
		assert_int_equal(judged.n_wrong, 1);
		assert_int_equal(judged.first, item);
		assert_true(judged.first_word < v->out_words);
		free(in);
		free(out);
	}
	assert_true(n > 40);
	ts_context_close(context);
}

/* A port that contracts a * b + c. */
static void test_fault(void **state)
{
	(void)state;
	ts_context *context = open_context(1);
	const ts_vector_info *v = NULL;
	for (size_t i = 0; (v = ts_vector_at(i)) != NULL && strcmp(v->name, "muladd") != 0; i++) {
	}
	assert_non_null(v);
	assert_true(v->in_words == 3 && v->out_words == 1);
	uint32_t *in = calloc(v->items, 3 * sizeof *in), *out = calloc(v->items, sizeof *out);
	assert_true(in != NULL && out != NULL);
	done(ts_vector_words(context, in, NULL, v->name));
	for (uint32_t i = 0; i < v->items; i++) {
		float x[3], fused;
		memcpy(x, in + 3 * i, sizeof x);
		fused = fmaf(x[0], x[1], x[2]);
		memcpy(&out[i], &fused, sizeof fused);
	}
	ts_vector_judged judged = {.bytes = sizeof judged};
	assert_int_equal(ts_vector_check(context, &judged, v->name, out), TS_DIFFERENT);
	assert_true(judged.n_wrong > 100 && judged.fault != NULL && judged.remedy[0] != 0);
	refused(ts_vector_check(context, &judged, "magic", out), "magic");
	free(in);
	free(out);
	ts_context_close(context);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(test_words), cmocka_unit_test(test_fault)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

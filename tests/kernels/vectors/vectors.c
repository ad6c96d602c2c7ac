/* The kernels of the arithmetic vectors: each primitive of the lists is the one of that place and name in the tables,
 * and gives the rows that ts_vector_make gives, whatever the threads. */
#include "backends/backend.h"
#include "backends/kernels.h"
#include "tests/model/test.h"
#include "vectors/vectors.h"

enum { MOST_WORDS = TS_VECTOR_ITEMS * TS_VECTOR_WORDS, AFTER = 8 };

static u32 in[MOST_WORDS];
static _Alignas(8) u32 out[MOST_WORDS], found[MOST_WORDS + AFTER];

static void lists_and_tables_name_the_same_primitives(void **state)
{
	(void)state;
#define NAME(name) #name,
	static const char *const names[] = {TS_LIST_vectors(NAME)};
#undef NAME
	for (u32 p = 0; p < ts_vectors_count(); p++) {
		ts_vector_place at = ts_vectors_place(p);
		assert_int_equal(at.launch->kernel == TS_KERNEL_vectors, p < TS_N_vectors);
		if (p < TS_N_vectors) assert_string_equal(at.vector->name, names[p]);
	}
}

static void kernels_give_the_rows_of_the_vectors(void **state)
{
	(void)state;
	for (u32 p = 0; p < ts_vectors_count(); p++) {
		ts_vector_place at = ts_vectors_place(p);
		const ts_vector *v = at.vector;
		u32 out_words = ts_vector_out_words(v), n_words = TS_VECTOR_ITEMS * out_words;
		ts_vectors_args args = {in, found, at.primitive, ts_vector_in_words(v), out_words};
		ts_vector_make(v, in, out);
		for (u32 threads = 1; threads <= 3; threads++) {
			memset(found, 0xee, sizeof found);
			ts_c_launch(at.launch->kernel, &args, TS_VECTOR_ITEMS, threads);
			if (memcmp(found, out, n_words * sizeof *out) != 0) print_error("%s on %u threads\n", v->name, threads);
			assert_memory_equal(found, out, n_words * sizeof *out);
			for (u32 k = 0; k < AFTER; k++) assert_int_equal(found[n_words + k], 0xeeeeeeee);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(lists_and_tables_name_the_same_primitives),
		cmocka_unit_test(kernels_give_the_rows_of_the_vectors),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

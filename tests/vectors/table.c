/* Where elements of what a primitive gives stand in its rows. */
#include "tests/model/test.h"
#include "vectors/vectors.h"

/* Every element of every primitive, counted column by column. */
static void every_element_has_its_spot(void **state)
{
	(void)state;
	u32 n = 0;
	for (u32 i = 0; i < ts_vectors_count(); i++) {
		const ts_vector *v = ts_vectors_at(i);
		u32 element = 0, word = 0;
		for (const ts_vector_column *c = v->out; c->name != NULL; c++) {
			for (u32 k = 0; k < c->count; k++) {
				ts_vector_spot spot = ts_vector_out_spot(v, element++);
				assert_ptr_equal(spot.column, c);
				assert_int_equal(spot.element, k);
				assert_int_equal(spot.word, word);
				word += ts_vector_type_words(c->type);
				n++;
			}
		}
		assert_int_equal(ts_vector_out_words(v), word);
	}
	assert_true(n > ts_vectors_count());
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(every_element_has_its_spot)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Every pipeline and stage of the families is registered once; the pipelines of an effect stand together. */
#include "families/families.h"
#include "methods/registry.h"
#include "tests/model/test.h"
#include "vectors/vectors.h"

#define PIPELINE(name) extern const ts_pipeline ts_pipeline_##name;
#include "families.def"
#define PIPELINE(name) &ts_pipeline_##name,
static const ts_pipeline *const pipelines[] = {
#include "families.def"
};
enum { N = sizeof pipelines / sizeof *pipelines };

static u32 place_of(const char *effect)
{
	u32 i = 0;
	while (strcmp(pipelines[i]->effect->name, effect) != 0) i++;
	return i;
}

/* The effects in the order in which the families name them first, and the methods of each in theirs. */
static void pipelines_stand_by_their_effects(void **state)
{
	(void)state;
	const ts_pipeline *const *listed = ts_registered()->pipelines;
	u32 n = 0;
	for (u32 i = 0; i < N; i++) {
		if (place_of(pipelines[i]->effect->name) != i) continue;
		for (u32 k = i; k < N; k++) {
			if (pipelines[k]->effect == pipelines[i]->effect) assert_ptr_equal(listed[n++], pipelines[k]);
		}
	}
	assert_int_equal(n, N);
	assert_null(listed[N]);
}

static void every_pipeline_is_found_by_its_names(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++)
		assert_ptr_equal(ts_pipeline_find(pipelines[i]->effect->name, pipelines[i]->name), pipelines[i]);
	assert_non_null(ts_vectors_find("sg_cosine")); /* a vector of a family */
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(pipelines_stand_by_their_effects),
	                                   cmocka_unit_test(every_pipeline_is_found_by_its_names)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

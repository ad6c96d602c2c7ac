/* Rules of two families are found by their buffer; without one, nothing is. */
#include "compare/decided.h"
#include "tests/model/test.h"

static ts_status open_none(void **ties, const ts_trace *reference)
{
	(void)reference;
	*ties = NULL;
	return TS_OK;
}

static const ts_tie_rule one[] = {
	{TS_B_eye_view, open_none, NULL, NULL}, {TS_B_scene_texel, open_none, NULL, NULL}, {0}};
static const ts_tie_rule other[] = {{TS_B_image_radiance, open_none, NULL, NULL}, {0}};

static void rules_are_found_by_their_buffer(void **state)
{
	(void)state;
	static const ts_tie_rule *const both[] = {one, other, NULL}, *const none[] = {NULL};
	ts_tie_use(both);
	assert_ptr_equal(ts_tie_find(TS_B_eye_view), &one[0]);
	assert_ptr_equal(ts_tie_find(TS_B_image_radiance), &other[0]);
	assert_null(ts_tie_find(TS_B_image_srgb));
	ts_tie_use(none);
	assert_null(ts_tie_find(TS_B_eye_view));
}

int main(void)
{
	const struct CMUnitTest tie[] = {cmocka_unit_test(rules_are_found_by_their_buffer)};
	return cmocka_run_group_tests(tie, NULL, NULL);
}

/* Old names, of a planted table: what they are now, what is said of them, and how often. */
#include "test.h"
#include "../../src/model/param.h"
#include "../../src/model/renamed.h"
#include "said.h"

static const ts_renamed planted[] = {
	{TS_NAME_stage, "width", "stage.width"},
	{TS_NAME_param, "width_px", "width"},
	{TS_NAME_param, "rows", "height"},
	{0},
};

static int begin(void **state)
{
	(void)state;
	ts_renamed_use(planted);
	return 0;
}

static int end(void **state)
{
	(void)state;
	ts_renamed_use(NULL);
	return 0;
}

static void names_are_of_their_kind(void **state)
{
	(void)state;
	const char *none = "none";
	said_begin();
	assert_string_equal(ts_name_now(TS_NAME_stage, "width"), "stage.width");
	assert_string_equal(ts_name_now(TS_NAME_param, "width"), "width");
	assert_string_equal(ts_name_now(TS_NAME_param, "rows"), "height");
	assert_ptr_equal(ts_name_now(TS_NAME_buffer, none), none);
	assert_ptr_equal(ts_name_typed(TS_NAME_size, none), none);
	assert_string_equal(said_end(), "");
}

static void each_is_said_once(void **state)
{
	(void)state;
	said_begin();
	for (int i = 0; i < 3; i++) assert_string_equal(ts_name_typed(TS_NAME_param, "width_px"), "width");
	assert_string_equal(ts_name_typed(TS_NAME_param, "rows"), "height");
	assert_string_equal(said_end(), "width_px is now called width; the old name works until 0.2\n"
	                                "rows is now called height; the old name works until 0.2\n");
}

static void parameters_are_set_by_old_names(void **state)
{
	(void)state;
	ts_params params;
	ts_params_default(&params);
	said_begin();
	assert_int_equal(ts_params_set(&params, "rows", "36"), TS_OK);
	assert_int_equal(ts_params_set(&params, "rows", "a"), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "parameter height: \"a\""));
	assert_int_equal(ts_params_set(&params, "stage.width", "64"), TS_ERROR);
	assert_string_equal(said_end(), "rows is now called height; the old name works until 0.2\n");
	assert_int_equal(params.height, 36);
}

static void the_table_is_given_back(void **state)
{
	(void)state;
	ts_renamed_use(NULL);
	assert_string_equal(ts_name_now(TS_NAME_param, "rows"), "rows");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test_setup_teardown(names_are_of_their_kind, begin, end),
		cmocka_unit_test_setup_teardown(each_is_said_once, begin, end),
		cmocka_unit_test_setup_teardown(parameters_are_set_by_old_names, begin, end),
		cmocka_unit_test_setup_teardown(the_table_is_given_back, begin, end),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

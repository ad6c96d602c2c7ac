/* What a trace says of who made it: this program and its arithmetic, or a backend's that was measured. */
#include "model/core.h"
#include "tests/trace/folder.h"
#include "trace/describe.h"

static void is(const json_t *root, const char *key, const char *text)
{
	const char *value = json_string_value(json_object_get(root, key));
	assert_non_null(value);
	assert_string_equal(value, text);
}

/* The arithmetic of the numeric contract, measured, and the C backend's names. */
static void this_program_tells_its_own_arithmetic(void **state)
{
	(void)state;
	ts_run run = {.backend = NULL};
	ts_c_begin(&run.c, 1);
	const ts_backend *c = ts_run_backend(&run);
	json_t *who = ts_producer(&run), *how = ts_arithmetic(&run);
	is(who, "name", "touchstone");
	is(who, "version", TS_VERSION);
	is(who, "commit", ts_commit());
	is(who, "backend", "c");
	is(who, "device", c->device);
	is(who, "compiler", c->compiler);
	is(who, "flags", c->flags);
	is(how, "rounding", "nearest even");
	is(how, "denormals", "kept");
	assert_true(json_is_false(json_object_get(how, "contraction")));
	assert_int_equal(json_integer_value(json_object_get(how, "selftest")), 0);
	assert_int_equal(json_object_size(how), 4);
	json_decref(who);
	json_decref(how);
}

/* Each property of another backend, as it was measured. */
static void a_backend_tells_what_was_measured(void **state)
{
	(void)state;
	for (u32 k = 0; k < 8; k++) {
		const ts_measured m = {k & 1, (k & 2) != 0, (k & 4) != 0, 5 * k};
		ts_backend backend = {
			.name = "other", .device = "a device", .compiler = "a compiler", .flags = "-some", .arithmetic = m};
		const ts_run run = {.backend = &backend};
		json_t *who = ts_producer(&run), *how = ts_arithmetic(&run);
		is(who, "backend", "other");
		is(who, "device", "a device");
		is(who, "compiler", "a compiler");
		is(who, "flags", "-some");
		is(how, "rounding", k & 1 ? "nearest even" : "other");
		is(how, "denormals", k & 4 ? "kept" : "flushed");
		assert_int_equal(json_is_true(json_object_get(how, "contraction")), (k & 2) != 0);
		assert_int_equal(json_integer_value(json_object_get(how, "selftest")), 5 * k);
		json_decref(who);
		json_decref(how);
	}
}

int main(void)
{
	const struct CMUnitTest producer[] = {cmocka_unit_test(this_program_tells_its_own_arithmetic),
	                                      cmocka_unit_test(a_backend_tells_what_was_measured)};
	return cmocka_run_group_tests(producer, NULL, NULL);
}

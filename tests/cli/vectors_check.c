/* How far the first wrong item of a primitive is off: steps between floats, differences of integers of each width, and
 * no number where a float is none. */
#include <sys/stat.h>
#include "tests/cli/typed.h"
#include "tests/trace/folder.h"

static int begin(void **state)
{
	char line[TYPED_LINE];
	json_t *said;
	if (scratch_begin(state) != 0) return -1;
	snprintf(line, sizeof line, "vectors -o %s --json", scratch_path("v"));
	assert_int_equal(typed_run(&said, line), TS_OK);
	json_decref(said);
	return 0;
}

/* The outputs of a primitive, by free(), and where the first of them stands. */
static char *outputs(const char *primitive, size_t *bytes, size_t *at)
{
	char *data = file_read(scratch_path("v/%s.out.npy", primitive), bytes);
	*at = 10 + (size_t)(unsigned char)data[8] + 256 * (size_t)(unsigned char)data[9];
	return data;
}

/* Puts the low bytes of `now` in the place of the first output. Returns what was there. */
static u64 put(const char *primitive, size_t width, u64 now)
{
	u64 before = 0;
	size_t bytes, at;
	char *data = outputs(primitive, &bytes, &at);
	memcpy(&before, data + at, width);
	memcpy(data + at, &now, width);
	file_write(scratch_path("v/%s.out.npy", primitive), data, bytes);
	free(data);
	return before;
}

/* The distance that the report gives of the only wrong item; the caller releases it by json_decref. */
static json_t *apart_now(const char *primitive)
{
	char line[TYPED_LINE];
	json_t *said;
	snprintf(line, sizeof line, "vectors --check %s --json", scratch_path("v"));
	assert_int_equal(typed_run(&said, line), TS_DIFFERENT);
	const json_t *wrong = json_object_get(said, "first_wrong"), *first = json_array_get(wrong, 0);
	assert_int_equal(json_array_size(wrong), 1);
	assert_string_equal(json_string_value(json_object_get(first, "primitive")), primitive);
	assert_int_equal(json_integer_value(json_object_get(first, "item")), 0);
	json_t *apart = json_incref(json_object_get(first, "apart"));
	json_decref(said);
	return apart;
}

/* The first primitive of one output of that dtype; NULL: there is none. */
static const char *primitive_of(const json_t *index, const char *dtype)
{
	const json_t *list = json_object_get(index, "primitives");
	for (size_t i = 0; i < json_array_size(list); i++) {
		const json_t *out = json_object_get(json_array_get(list, i), "out");
		const bool one = json_array_size(json_object_get(out, "shape")) == 1;
		if (one && strcmp(json_string_value(json_object_get(out, "dtype")), dtype) == 0)
			return json_string_value(json_object_get(json_array_get(list, i), "name"));
	}
	return NULL;
}

static void assert_apart(const char *primitive, size_t width, u64 now, i64 right)
{
	u64 before = put(primitive, width, now);
	json_t *apart = apart_now(primitive);
	assert_true(json_is_integer(apart));
	assert_true(json_integer_value(apart) == right);
	json_decref(apart);
	put(primitive, width, before);
}

static void wrong_integers_are_apart_by_their_difference(void **state)
{
	(void)state;
	static const char *const dtypes[] = {"<u4", "<i4", "<u8", "<i8"};
	json_t *index = json_load_file(scratch_path("v/vectors.json"), 0, NULL);
	u32 n_found = 0;
	for (u32 i = 0; i < 4; i++) {
		const char *primitive = primitive_of(index, dtypes[i]);
		if (primitive == NULL) continue;
		n_found++;
		size_t width = (size_t)(dtypes[i][2] - '0');
		u64 right = put(primitive, width, 0);
		put(primitive, width, right);
		u64 step = right % 1000 > 500 || right == 0 ? 1 : (u64)-1;
		assert_apart(primitive, width, right + step * 3, (i64)(step * 3));
	}
	assert_true(n_found >= 2);
	json_decref(index);
}

static void wrong_floats_are_apart_by_their_steps(void **state)
{
	(void)state;
	json_t *index = json_load_file(scratch_path("v/vectors.json"), 0, NULL);
	const char *primitive = primitive_of(index, "<f4");
	assert_non_null(primitive);
	const u32 infinity = 0x7f800000u;
	u32 right = (u32)put(primitive, 4, infinity);
	put(primitive, 4, right);
	i64 steps = right >> 31 != 0 ? -(i64)(right & 0x7fffffffu) : right;
	assert_apart(primitive, 4, infinity, (i64)infinity - steps);
	put(primitive, 4, infinity + 1);
	json_t *apart = apart_now(primitive);
	assert_true(json_is_null(apart));
	json_decref(apart);
	put(primitive, 4, right);
	json_decref(index);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(wrong_integers_are_apart_by_their_difference),
	                                   cmocka_unit_test(wrong_floats_are_apart_by_their_steps)};
	return cmocka_run_group_tests(tests, begin, scratch_remove);
}

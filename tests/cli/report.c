/* `report` of two traces of a method: the page is written, and has the verdict of the second by the first. */
#include "tests/cli/typed.h"
#include "tests/trace/small.h"

static int begin(void **state)
{
	ts_params params = small_params();
	if (scratch_begin(state) != 0) return -1;
	ts_scene *scene = small_scene(&params);
	small_trace(scratch_path("epr"), "epr", scene, &params, (ts_trace_options){.margins = false});
	small_trace(scratch_path("mvr"), "mvr", scene, &params, (ts_trace_options){.margins = false});
	small_copy(scratch_path("wrong"), scratch_path("epr"));
	ts_scene_free(scene);
	return 0;
}

/* What the page of these two traces holds, of which the program knows that it is JSON; by json_decref. */
static json_t *page_of(const char *a, const char *b)
{
	static const char mark[] = "<script type=\"application/json\" id=\"data\">";
	char line[TYPED_LINE];
	json_t *said;
	size_t bytes;
	const char *path = scratch_path("page.html");
	snprintf(line, sizeof line, "report %s %s -o %s", scratch_path("%s", a), scratch_path("%s", b), path);
	assert_int_equal(typed_run(&said, line), TS_OK);
	json_decref(said);
	char *text = file_read(path, &bytes), *from = strstr(text, mark);
	assert_non_null(from);
	json_t *page = json_loads(from + strlen(mark), JSON_DISABLE_EOF_CHECK, NULL);
	assert_non_null(page);
	free(text);
	unlink(path);
	return page;
}

/* How often the page, or a part of it, has that verdict. */
static u32 verdicts(const json_t *part, const char *verdict)
{
	u32 n = 0;
	const char *key;
	size_t i;
	json_t *member;
	if (json_is_object(part)) {
		const char *own = json_string_value(json_object_get(part, "verdict"));
		n += own != NULL && strcmp(own, verdict) == 0;
		json_object_foreach ((json_t *)part, key, member) n += verdicts(member, verdict);
	}
	json_array_foreach (part, i, member) n += verdicts(member, verdict);
	return n;
}

static void a_trace_is_the_same_as_itself(void **state)
{
	(void)state;
	json_t *page = page_of("epr", "epr");
	assert_true(verdicts(page, "same") > 10);
	assert_int_equal(verdicts(page, "different"), 0);
	json_decref(page);
}

static void a_wrong_pixel_is_different(void **state)
{
	(void)state;
	size_t bytes;
	const char *path = scratch_path("wrong/20-image.srgb.npy");
	char *data = file_read(path, &bytes);
	data[bytes - 1] ^= 1;
	file_write(path, data, bytes);
	free(data);
	json_t *page = page_of("epr", "wrong");
	assert_true(verdicts(page, "same") > 10);
	assert_true(verdicts(page, "different") > 0);
	json_decref(page);
}

/* Traces of different methods are shown beside each other, without a verdict. */
static void traces_of_other_methods_have_no_verdict(void **state)
{
	(void)state;
	json_t *page = page_of("epr", "mvr");
	assert_int_equal(verdicts(page, "same"), 0);
	json_decref(page);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_trace_is_the_same_as_itself),
		cmocka_unit_test(a_wrong_pixel_is_different),
		cmocka_unit_test(traces_of_other_methods_have_no_verdict),
	};
	return cmocka_run_group_tests(tests, begin, scratch_remove);
}

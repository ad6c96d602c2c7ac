/* The page as a file: the data that it holds are those that were put in, no text ends the script early, and the file
 * appears whole; and JSON that is read. */
#include "image/falsecolour.h"
#include "tests/report/pages.h"

static char *written(ts_page *page, size_t *bytes)
{
	const char *path = scratch_path("page.html");
	require(ts_page_write(page, path));
	assert_int_not_equal(access(scratch_path("page.html.partial"), F_OK), 0);
	char *text = file_read(path, bytes);
	unlink(path);
	return text;
}

static const char BEGIN[] = "<script type=\"application/json\" id=\"data\">", END[] = "</script>";

/* The JSON between the tags, and what stands before and behind. */
static json_t *data_of(char *html, const char **before, const char **behind)
{
	char *begin = strstr(html, BEGIN), *end = begin != NULL ? strstr(begin, END) : NULL;
	json_error_t why;
	assert_non_null(end);
	*end = 0;
	*begin = 0;
	*before = html;
	*behind = end + strlen(END);
	const char *text = begin + strlen(BEGIN);
	assert_null(strchr(text, '<'));
	json_t *data = json_loads(text, 0, &why);
	if (data == NULL) fail_msg("%s", why.text);
	return data;
}

static void an_empty_page_holds_empty_lists(void **state)
{
	(void)state;
	static const char *const lists[] = {"folders", "traces", "comparisons", "pairs", "pictures"};
	const char *before, *behind;
	size_t bytes;
	ts_page *page = ts_page_make(42.5, 7);
	char *html = written(page, &bytes);
	assert_int_equal(strlen(html), bytes);
	json_t *data = data_of(html, &before, &behind);
	assert_memory_equal(before, "<!doctype html>", 15);
	assert_non_null(strstr(before, "<style>"));
	assert_non_null(strstr(behind, "<script>"));
	assert_string_equal(html + bytes - 8, "</html>\n");
	assert_string_equal(text_of(data, "version"), TS_VERSION);
	assert_true(json_real_value(get(data, "ppd")) == 42.5 && number_of(data, "most_probes") == 7);
	for (u32 i = 0; i < 5; i++)
		assert_true(json_is_array(get(data, lists[i])) && json_array_size(get(data, lists[i])) == 0);
	json_decref(data);
	free(html);
	ts_page_free(page);
	ts_page_free(NULL);
}

static void the_page_holds_the_false_colours(void **state)
{
	(void)state;
	static const char *const lists[] = {"ramp", "names"};
	ts_page *page = new_page(0);
	for (u32 k = 0; k < 2; k++) {
		const json_t *list = get(page->root, lists[k]);
		assert_int_equal(json_array_size(list), 256);
		for (u32 i = 0; i < 256; i++) {
			uint8_t rgb[3];
			if (k == 0) ts_falsecolour_ramp(rgb, i / 255.0);
			if (k == 1) ts_falsecolour_name(rgb, i);
			assert_int_equal(json_array_size(at(list, i)), 3);
			for (u32 c = 0; c < 3; c++) assert_int_equal(json_integer_value(at(at(list, i), c)), rgb[c]);
		}
	}
	ts_page_free(page);
}

/* Every character, and every short text of the characters that end scripts, comes back as it was. */
static void no_text_ends_the_script(void **state)
{
	(void)state;
	static const char some[] = "<>/!-&\"\\s";
	const u32 n = sizeof some - 1;
	const char *before, *behind;
	size_t bytes;
	ts_page *page = new_page(0);
	json_t *texts = json_array(), *copy;
	for (u32 c = 1; c < 128; c++) ts_page_append(page, texts, json_sprintf("%c", (char)c));
	for (u32 i = 0; i < n * n * n; i++) {
		ts_page_append(page, texts, json_sprintf("%c%c%c", some[i % n], some[i / n % n], some[i / n / n]));
	}
	ts_page_append(page, texts, json_string("</script><script>window.hacked = 1</script><!-- <script"));
	ts_page_append(page, texts, json_string("<"));
	ts_page_put(page, page->root, "texts", texts);
	copy = json_deep_copy(page->root);
	char *html = written(page, &bytes);
	json_t *data = data_of(html, &before, &behind);
	json_object_del(data, "ppd"); /* the one number that is no integer */
	json_object_del(copy, "ppd");
	assert_true(json_equal(data, copy));
	json_decref(data);
	json_decref(copy);
	free(html);
	ts_page_free(page);
}

/* Two pictures, put in, are judged when the page is written; the bytes are the same again. */
static void pictures_are_judged_when_written(void **state)
{
	(void)state;
	static const u8 rgb[2][12] = {{1, 2, 3}, {4, 5, 6}};
	const char *before, *behind;
	char *html[2];
	size_t bytes[2];
	for (u32 i = 0; i < 2; i++) {
		ts_page *page = new_page(0);
		require(ts_page_add_picture(page, "a", "x", rgb[0], 2, 2));
		require(ts_page_add_picture(page, "b", "y", rgb[1], 2, 2));
		html[i] = written(page, &bytes[i]);
		ts_page_free(page);
	}
	assert_int_equal(bytes[0], bytes[1]);
	assert_memory_equal(html[0], html[1], bytes[0]);
	json_t *data = data_of(html[0], &before, &behind);
	assert_int_equal(json_array_size(get(data, "pairs")), 1);
	json_decref(data);
	free(html[0]);
	free(html[1]);
}

static void a_page_that_fails_is_not_written(void **state)
{
	(void)state;
	ts_page *page = new_page(0);
	refused(ts_page_write(page, scratch_path("no/page.html")), "no/page.html");
	ts_page_append(page, page->pairs, NULL);
	refused(ts_page_write(page, scratch_path("page.html")), "the page: out of memory");
	assert_int_not_equal(access(scratch_path("page.html"), F_OK), 0);
	ts_page_free(page);
}

/* ---- JSON that is read ---- */

static void put(const char *name, const char *text) { file_write(scratch_path("%s", name), text, strlen(text)); }

static void json_files_are_read_where_they_are(void **state)
{
	(void)state;
	json_t *root;
	put("good.json", "{\"a\": [1, \"<\"]}");
	require(ts_page_read(&root, scratch_root, "good.json", false));
	assert_int_equal(json_integer_value(at(get(root, "a"), 0)), 1);
	json_decref(root);
	require(ts_page_read(&root, scratch_root, "good.json", true));
	assert_non_null(root);
	json_decref(root);
	require(ts_page_read(&root, scratch_root, "absent.json", true));
	assert_null(root);
	refused(ts_page_read(&root, scratch_root, "absent.json", false), "absent.json");
	unlink(scratch_path("good.json"));
}

static void what_is_no_json_object_is_refused(void **state)
{
	(void)state;
	static const char *const bad[][2] = {{"", "bad.json: "},
	                                     {"{\"a\": ", "bad.json: "},
	                                     {"{} {}", "bad.json: "},
	                                     {"[1]", "bad.json: no JSON object; what render or compare wrote is expected"}};
	const size_t most = 1 << 24;
	json_t *root;
	for (u32 i = 0; i < sizeof bad / sizeof *bad; i++) {
		put("bad.json", bad[i][0]);
		refused(ts_page_read(&root, scratch_root, "bad.json", true), bad[i][1]);
		assert_null(root);
	}
	char *blanks = malloc(most + 1);
	memset(blanks, ' ', most + 1);
	memcpy(blanks, "{}", 2);
	file_write(scratch_path("bad.json"), blanks, most);
	require(ts_page_read(&root, scratch_root, "bad.json", false));
	json_decref(root);
	file_write(scratch_path("bad.json"), blanks, most + 1);
	refused(ts_page_read(&root, scratch_root, "bad.json", false),
	        "bad.json: 16777217 bytes; at most 16777216 are read");
	free(blanks);
	unlink(scratch_path("bad.json"));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(an_empty_page_holds_empty_lists),   cmocka_unit_test(the_page_holds_the_false_colours),
		cmocka_unit_test(no_text_ends_the_script),           cmocka_unit_test(pictures_are_judged_when_written),
		cmocka_unit_test(a_page_that_fails_is_not_written),  cmocka_unit_test(json_files_are_read_where_they_are),
		cmocka_unit_test(what_is_no_json_object_is_refused),
	};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_end);
}

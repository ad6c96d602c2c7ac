/* Pages by the library: they hold what was added, the same bytes each time, and refuse what cannot be shown. */
#include <unistd.h>
#include "tests/api/api.h"

static ts_context *context;
static ts_trace *reference;

static char *read_all(const char *path, size_t *bytes)
{
	FILE *file = fopen(path, "rb");
	assert_non_null(file);
	assert_int_equal(fseek(file, 0, SEEK_END), 0);
	*bytes = (size_t)ftell(file);
	rewind(file);
	char *text = malloc(*bytes + 1);
	assert_non_null(text);
	assert_int_equal(fread(text, 1, *bytes, file), *bytes);
	text[*bytes] = 0;
	fclose(file);
	return text;
}

static ts_html *open_page(void)
{
	ts_html *page;
	done(ts_html_open(context, &page,
	                  &(ts_html_options){.bytes = sizeof(ts_html_options), .probes_said = 1, .probes = 2}));
	return page;
}

/* A page of a reference and a candidate with a wrong pixel. */
static char *compared_page(const char *path, size_t *bytes, const char *json)
{
	ts_trace *candidate;
	ts_verdicts *verdicts;
	ts_html *page = open_page();
	const ts_buffer_view *image = ts_trace_buffer(reference, "image.srgb");
	uint8_t *copy = malloc(bytes_of(image));
	assert_non_null(copy);
	memcpy(copy, image->data, bytes_of(image));
	copy[3 * (64 * 20 + 11)] ^= 8;
	done(ts_trace_candidate(context, &candidate, reference, 0));
	done(ts_trace_put(candidate, "image.srgb", image->n_dims, image->shape, copy, bytes_of(image)));
	assert_int_equal(ts_compare(context, &verdicts, reference, candidate, NULL), TS_DIFFERENT);
	done(ts_html_add_trace(page, reference));
	done(ts_html_add_trace(page, candidate));
	done(ts_html_add_verdicts(page, verdicts, reference, candidate, NULL, json));
	ts_trace *bare;
	done(ts_trace_candidate(context, &bare, reference, 0));
	refused(ts_html_add_verdicts(page, verdicts, reference, bare, NULL, NULL), "verdicts of other traces");
	ts_trace_close(bare);
	const ts_compare_options nonsense = {.bytes = sizeof nonsense, .ignore = "nonsense"};
	refused(ts_html_add_verdicts(page, verdicts, reference, candidate, &nonsense, NULL), "nonsense");
	done(ts_html_write(page, path));
	ts_html_close(page);
	ts_verdicts_free(verdicts);
	ts_trace_close(candidate);
	free(copy);
	return read_all(path, bytes);
}

static void a_page_is_the_same_each_time(void **state)
{
	(void)state;
	char folder[FOLDER], path[PATH];
	size_t n, m;
	make_folder(folder);
	snprintf(path, sizeof path, "%s/page.html", folder);
	char *page = compared_page(path, &n, NULL), *again = compared_page(path, &m, NULL);
	assert_int_equal(n, m);
	assert_memory_equal(page, again, n);
	assert_non_null(strstr(page, "buffer image.srgb, pixel (11, 20)"));
	assert_non_null(strstr(page, "\"x\":11,\"y\":20"));
	assert_null(strstr(page, "magic words"));
	free(again);
	free(page);
	page = compared_page(path, &n, "{\"verdict\": \"different\", \"relaxations\": \"magic words\"}");
	assert_non_null(strstr(page, "magic words"));
	free(page);
	free(compared_page(path, &n, "{\"differences\": [{}, {\"buffer\": 3}]}"));
	remove_folder(folder);
}

/* Of two candidates of one name the one that was judged is shown. */
static void the_judged_candidate_is_shown(void **state)
{
	(void)state;
	char folder[FOLDER], path[PATH];
	size_t n;
	ts_trace *candidates[2];
	ts_verdicts *verdicts;
	ts_html *page = open_page();
	const ts_buffer_view *image = ts_trace_buffer(reference, "image.srgb");
	make_folder(folder);
	snprintf(path, sizeof path, "%s/page.html", folder);
	done(ts_html_add_trace(page, reference));
	for (int i = 0; i < 2; i++) {
		done(ts_trace_candidate(context, &candidates[i], reference, 0));
		done(ts_trace_put(candidates[i], "image.srgb", image->n_dims, image->shape, image->data, bytes_of(image)));
		done(ts_html_add_trace(page, candidates[i]));
	}
	assert_int_equal(ts_compare(context, &verdicts, reference, candidates[0], NULL), TS_OK);
	done(ts_html_add_verdicts(page, verdicts, reference, candidates[0], NULL, NULL));
	done(ts_html_write(page, path));
	char *text = read_all(path, &n);
	assert_non_null(strstr(text, "\"judged\":1,"));
	assert_non_null(strstr(text, "\"reference\":0,\"image\":1"));
	free(text);
	ts_html_close(page);
	ts_verdicts_free(verdicts);
	for (int i = 0; i < 2; i++) ts_trace_close(candidates[i]);
	remove_folder(folder);
}

static void a_page_holds_its_pictures(void **state)
{
	(void)state;
	char folder[FOLDER], path[PATH];
	uint8_t rgb[2][4 * 4 * 3] = {{0}};
	size_t n;
	make_folder(folder);
	snprintf(path, sizeof path, "%s/page.html", folder);
	ts_html *page = open_page();
	rgb[1][5] = 255;
	refused(ts_html_add_pair(page, "{}"), "fewer");
	refused(ts_html_add_picture(page, "a", "a.png", rgb[0], 0, 4), "0 x 4");
	done(ts_html_add_picture(page, "first picture", "a.png", rgb[0], 4, 4));
	refused(ts_html_add_pair(page, "{}"), "fewer");
	done(ts_html_add_picture(page, "second picture", "b.png", rgb[1], 4, 4));
	refused(ts_html_add_pair(page, "[]"), "an object would be right");
	refused(ts_html_add_pair(page, "{"), "json: ");
	done(ts_html_add_pair(page, "{\"verdict\": \"different\"}"));
	done(ts_html_write(page, path));
	char *text = read_all(path, &n);
	assert_non_null(strstr(text, "first picture"));
	assert_non_null(strstr(text, "second picture"));
	refused(ts_html_add_folder(page, "/proc/none"), "/proc/none");
	refused(ts_html_write(page, "/proc/none/page.html"), "/proc/none");
	ts_html_close(page);
	free(text);
	remove_folder(folder);
}

static void wrong_options_of_a_page_are_refused(void **state)
{
	(void)state;
	ts_html *page;
	refused(ts_html_open(context, &page, &(ts_html_options){.bytes = 1}), "bytes");
	refused(ts_html_open(context, &page, &(ts_html_options){.bytes = sizeof(ts_html_options), .ppd = -1}), "ppd: -1");
	assert_null(page);
}

static int set_up(void **state)
{
	(void)state;
	context = open_context(2);
	ts_params *params = small_params();
	ts_scene *scene = small_scene(context, params);
	const ts_run_options options = {.bytes = sizeof options, .buffers = "image.srgb,image.radiance"};
	done(ts_trace_run(context, &reference, scene, params, "reflections", "mvr", &options));
	ts_scene_free(scene);
	ts_params_free(params);
	return 0;
}

static int tear_down(void **state)
{
	(void)state;
	ts_trace_close(reference);
	ts_context_close(context);
	return 0;
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_page_is_the_same_each_time),
		cmocka_unit_test(the_judged_candidate_is_shown),
		cmocka_unit_test(a_page_holds_its_pictures),
		cmocka_unit_test(wrong_options_of_a_page_are_refused),
	};
	return cmocka_run_group_tests(tests, set_up, tear_down);
}

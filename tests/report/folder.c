/* Folders that render or compare wrote: which of their files are pictures, which are judged, what is said of each, and
 * what is refused. */
#include <errno.h>
#include "tests/report/pages.h"

enum { W = 3, H = 2 };

/* A folder of the scratch folder that holds a report and pictures. */
static void put(const char *path, const char *text) { file_write(scratch_path("%s", path), text, strlen(text)); }

static void put_png(const char *path, u32 channels)
{
	u8 pixels[W * H * 4];
	for (u32 i = 0; i < sizeof pixels; i++) pixels[i] = (u8)(channels == 4 && i % 4 == 3 ? 255 : i * 37 + strlen(path));
	require(ts_image_write_png(scratch_path("%s", path), pixels, W, H, channels, NULL));
}

static ts_page *page_of(const char *report)
{
	ts_page *page = new_page(0);
	put("report.json", report);
	require(ts_page_add_folder(page, scratch_root));
	return page;
}

static const json_t *named(const ts_page *page, const char *name)
{
	const json_t *found = NULL;
	for (size_t i = 0; i < json_array_size(page->pictures); i++) {
		if (strcmp(text_of(at(page->pictures, i), "name"), name) == 0) found = at(page->pictures, i);
	}
	if (found == NULL) fail_msg("no picture %s", name);
	return found;
}

/* ---- names ---- */

/* A file is a picture where its name, in the folder or one below, is STEM.png, and neither hidden nor a difference. */
static bool is_picture(const char *file)
{
	const char *slash = strchr(file, '/'), *name = slash != NULL ? slash + 1 : file;
	size_t n = strlen(name);
	if (file[0] == '.' || name[0] == '.' || slash == file || strchr(name, '/') != NULL) return false;
	return n > 4 && strcmp(name + n - 4, ".png") == 0 && strncmp(name, "difference-", 11) != 0;
}

/* One report with every name of up to four of these parts: the pictures of the page are those that it should have, in
 * order. A file that is no picture is not there, and to open it would be refused. */
static void pictures_are_found_by_their_names(void **state)
{
	(void)state;
	static const char *const parts[] = {"", ".", "/", "a", "difference-", ".png", "../"};
	static char right[400][64];
	const u32 n = sizeof parts / sizeof *parts;
	u32 n_right = 0;
	char name[64];
	json_t *files = json_array(), *report;
	put_png("any", 3);
	mkdir(scratch_path("a"), 0777);
	for (u32 i = 0; i < n * n * n * n; i++) {
		snprintf(name, sizeof name, "%s%s%s%s", parts[i % n], parts[i / n % n], parts[i / n / n % n],
		         parts[i / n / n / n]);
		bool is = is_picture(name);
		if (is && strchr(name, '/') != NULL && strncmp(name, "a/", 2) != 0)
			continue; /* of a folder that is not there */
		json_array_append_new(files, json_string(name));
		if (!is) continue;
		assert_true(link(scratch_path("any"), scratch_path("%s", name)) == 0 || errno == EEXIST);
		assert_true(n_right < 400);
		strcpy(right[n_right++], name);
	}
	report = json_pack("{s:s, s:o}", "program", "touchstone", "files", files);
	char *text = json_dumps(report, 0);
	ts_page *page = page_of(text);
	assert_int_equal(page->n_pictures, n_right);
	assert_in_range(n_right, 30, 400);
	for (u32 i = 0; i < n_right; i++) {
		const ts_page_picture *p = &page->picture[i];
		snprintf(name, sizeof name, "%s%s%s.png", p->group, p->group[0] != 0 ? "/" : "", p->name);
		assert_string_equal(name, right[i]);
		unlink(scratch_path("%s", name));
	}
	unlink(scratch_path("any"));
	rmdir(scratch_path("a"));
	free(text);
	json_decref(report);
	ts_page_free(page);
}

static void other_files_are_no_pictures(void **state)
{
	(void)state;
	char name[400], report[500];
	for (u32 i = 0; i < 2; i++) { /* too long a name, too long a group */
		memset(name, 'n', sizeof name);
		strcpy(name + (i == 0 ? 252 : 256), i == 0 ? ".png" : "/a.png");
		snprintf(report, sizeof report, "{\"program\": \"touchstone\", \"files\": [\"%s\", 3, null, [], \"\"]}", name);
		ts_page *page = page_of(report);
		assert_int_equal(json_array_size(page->pictures), 0);
		assert_int_equal(page->n_folders, 1);
		ts_page_free(page);
	}
}

/* ---- pictures ---- */

static const char REPORT[] =
	"{\"program\": \"touchstone\", \"methods\": [\"one\", \"two\"], \"files\": [\"one.png\", \"two.png\", "
	"\"truth-a.png\", \"heat.png\", \"untruth-a.png\", \"g/one.png\", \"methods.png\", \"report.json\"], "
	"\"pictures\": [{\"name\": \"one.pngs\", \"shows\": \"another file\"}, {\"name\": 5, \"shows\": \"no name\"}, "
	"{\"name\": \"on\", \"shows\": \"less\"}, {\"name\": \"one.png (enlarged)\", \"shows\": \"the first\"}, "
	"{\"name\": \"one.png\", \"shows\": \"the second\"}, {\"name\": \"truth-a.png\", \"shows\": \"a truth\"}, "
	"{\"name\": \"heat.png\"}]}";

static void put_pictures(void)
{
	mkdir(scratch_path("g"), 0777);
	put_png("one.png", 4);
	put_png("two.png", 3);
	put_png("truth-a.png", 3);
	put_png("heat.png", 4);
	put_png("untruth-a.png", 1);
	put_png("methods.png", 1);
	put_png("g/one.png", 3);
}

static void remove_pictures(void)
{
	static const char *const all[] = {"one.png",       "two.png",   "truth-a.png", "heat.png",
	                                  "untruth-a.png", "g/one.png", "methods.png"};
	for (u32 i = 0; i < sizeof all / sizeof *all; i++) unlink(scratch_path("%s", all[i]));
	rmdir(scratch_path("g"));
}

static void pictures_of_methods_and_truths_are_judged(void **state)
{
	(void)state;
	static const struct {
		const char *name, *group;
		bool judged, truth;
		u32 channels;
	} right[] = {{"one", "", true, false, 4},     {"two", "", true, false, 3},        {"truth-a", "", true, true, 3},
	             {"heat", "", false, false, 4},   {"untruth-a", "", false, false, 1}, {"one", "g", true, false, 3},
	             {"methods", "", false, false, 1}};
	put_pictures();
	ts_page *page = page_of(REPORT);
	assert_int_equal(page->n_pictures, 7);
	for (u32 i = 0; i < 7; i++) {
		const ts_page_picture *p = &page->picture[i];
		const json_t *o = at(page->pictures, i);
		assert_string_equal(p->name, right[i].name);
		assert_string_equal(p->group, right[i].group);
		assert_string_equal(text_of(o, "name"), right[i].name);
		assert_string_equal(text_of(o, "from"), right[i].group[0] == 0 ? scratch_root : scratch_path("g"));
		assert_true(p->folder == 0 && p->width == W && p->height == H && p->truth == right[i].truth);
		assert_true((p->rgb != NULL) == right[i].judged && json_is_true(get(o, "judged")) == right[i].judged);
		u32 width, height;
		u8 *shown = pixels_of(get(o, "png"), &width, &height);
		assert_true(width == W && height == H);
		u8 seed = (u8)(strlen(right[i].name) + strlen(".png") + (right[i].group[0] != 0 ? 2 : 0));
		for (u32 k = 0; k < W * H * 3; k++) {
			u32 n = right[i].channels, pixel = k / 3, c = k % 3;
			u8 value = (u8)((pixel * n + (n == 1 ? 0 : c)) * 37 + seed);
			assert_int_equal(shown[4 * pixel + c], value);
			if (p->rgb != NULL) assert_int_equal(p->rgb[k], value);
		}
		free(shown);
	}
	ts_page_free(page);
	remove_pictures();
}

/* The words of the row of a picture's own name, or of its name and a remark behind a blank. */
static void pictures_show_the_words_of_their_row(void **state)
{
	(void)state;
	put_pictures();
	ts_page *page = page_of(REPORT);
	assert_string_equal(text_of(at(page->pictures, 0), "shows"), "the first");
	assert_string_equal(text_of(named(page, "truth-a"), "shows"), "a truth");
	static const char *const without[] = {"two", "heat", "untruth-a"};
	for (u32 i = 0; i < 3; i++) assert_false(has_key(named(page, without[i]), "shows"));
	ts_page_free(page);
	remove_pictures();
}

/* A method's picture names its trace where the folder holds it. */
static void a_picture_names_its_trace(void **state)
{
	(void)state;
	static const char *const folders[] = {"trace-one", "trace-heat", "trace-truth-a", "g/trace-one", "trace-two"};
	put_pictures();
	for (u32 i = 0; i < 5; i++) {
		char file[64];
		mkdir(scratch_path("%s", folders[i]), 0777);
		snprintf(file, sizeof file, "%s/trace.json", folders[i]);
		if (i < 4) put(file, "");
	}
	ts_page *page = page_of(REPORT);
	for (u32 i = 0; i < 7; i++) {
		assert_true(has_key(at(page->pictures, i), "trace") == (i == 0 || i == 5));
	}
	assert_string_equal(text_of(at(page->pictures, 0), "trace"), scratch_path("trace-one"));
	assert_string_equal(text_of(at(page->pictures, 5), "trace"), scratch_path("g/trace-one"));
	ts_page_free(page);
	for (u32 i = 0; i < 5; i++) {
		unlink(scratch_path("%s/trace.json", folders[i]));
		rmdir(scratch_path("%s", folders[i]));
	}
	remove_pictures();
}

/* ---- tables ---- */

/* Each folder gives its report, without the list of files, and its times where it has some. */
static void each_folder_gives_its_report(void **state)
{
	(void)state;
	ts_page *page = page_of("{\"program\": \"touchstone\", \"files\": [], \"notes\": [\"<b>\"]}");
	put("times.json", "{\"x\": 5}");
	put("report.json", "{\"program\": \"touchstone\", \"scene\": \"s\"}");
	require(ts_page_add_folder(page, scratch_root));
	const json_t *first = at(page->folders, 0), *second = at(page->folders, 1);
	assert_true(json_array_size(page->folders) == 2 && page->n_folders == 2);
	assert_string_equal(text_of(first, "dir"), scratch_root);
	assert_false(has_key(first, "times") || has_key(get(first, "report"), "files"));
	assert_string_equal(json_string_value(at(get(get(first, "report"), "notes"), 0)), "<b>");
	assert_int_equal(number_of(get(second, "times"), "x"), 5);
	assert_string_equal(text_of(get(second, "report"), "scene"), "s");
	ts_page_free(page);
	unlink(scratch_path("times.json"));
}

/* A picture of the second folder is numbered with it, and judged by its namesake of the first. */
static void the_first_folder_judges_the_second(void **state)
{
	(void)state;
	static const char report[] = "{\"program\": \"touchstone\", \"methods\": [\"one\"], \"files\": [\"one.png\"]}";
	put_png("one.png", 3);
	ts_page *page = page_of(report);
	require(ts_page_add_folder(page, scratch_root));
	require(ts_page_add_pairs(page));
	assert_true(page->picture[0].folder == 0 && page->picture[1].folder == 1);
	assert_int_equal(json_array_size(page->pairs), 1);
	ts_page_free(page);
	unlink(scratch_path("one.png"));
}

/* ---- what is refused ---- */

static void wrong_reports_are_refused(void **state)
{
	(void)state;
	static const char *const reports[][2] = {
		{"{\"program\": \"other\"}", "report.json: of no touchstone"},
		{"{\"program\": 5}", "report.json: of no touchstone"},
		{"{}", "report.json: of no touchstone"},
		{"[]", "report.json: no JSON object"},
		{"{\"program\": \"touchstone\", \"files\": [\"absent.png\"]}", "absent.png"},
		{"{\"program\": \"touchstone\", \"files\": [\"text.png\"]}", "text.png: no PNG"},
		{"{\"program\": \"touchstone\", \"files\": [\"short.png\"]}", "short.png: no PNG"},
		{"{\"program\": \"touchstone\", \"files\": [\"cut.png\"]}", "cut.png: "},
		{"{\"program\": \"touchstone\", \"files\": [\"wide.png\"]}",
	     "wide.png: 16385 x 1 pixels; at most 16384 a side are shown"},
		{"{\"program\": \"touchstone\", \"files\": [\"high.png\", \"text.png\"]}",
	     "high.png: 1 x 16385 pixels; at most 16384 a side are shown"},
	};
	static const char *const files[] = {"text.png", "short.png", "cut.png", "wide.png", "high.png"};
	static u8 row[16385];
	size_t bytes;
	put("text.png", "a text that is long enough");
	put("short.png", "\x89PNG\r\n\x1a\n");
	put_png("cut.png", 3);
	char *whole = file_read(scratch_path("cut.png"), &bytes);
	file_write(scratch_path("cut.png"), whole, bytes / 2);
	free(whole);
	require(ts_image_write_png(scratch_path("wide.png"), row, 16385, 1, 1, NULL));
	require(ts_image_write_png(scratch_path("high.png"), row, 1, 16385, 1, NULL));
	for (u32 i = 0; i < sizeof reports / sizeof *reports; i++) {
		ts_page *page = new_page(0);
		put("report.json", reports[i][0]);
		refused(ts_page_add_folder(page, scratch_root), reports[i][1]);
		assert_true(page->n_folders == 0 && page->n_pictures == 0);
		ts_page_free(page);
	}
	require(ts_image_write_png(scratch_path("wide.png"), row, 16384, 1, 1, NULL));
	ts_page_free(page_of(reports[8][0]));
	for (u32 i = 0; i < 5; i++) unlink(scratch_path("%s", files[i]));
}

/* Whatever is a link, of a folder that somebody else wrote, is not read. */
static void links_are_refused(void **state)
{
	(void)state;
	static const char all[] = "{\"program\": \"touchstone\", \"files\": [\"%s\"]}";
	static const char *const names[] = {"link.png", "link.svg", "way/one.png", "times.json", "report.json"};
	put_png("one.png", 3);
	for (u32 i = 0; i < 5; i++) {
		char text[128], told[128];
		ts_page *page = new_page(0);
		snprintf(text, sizeof text, all, names[i]);
		put("report.json", text);
		if (i == 4) assert_int_equal(rename(scratch_path("report.json"), scratch_path("real.json")), 0);
		const char *to = i == 2 ? "." : i == 4 ? "real.json" : "one.png";
		assert_int_equal(symlink(to, scratch_path("%s", i == 2 ? "way" : names[i])), 0);
		snprintf(told, sizeof told, i == 2 ? "%s: Not a directory" : "%s: a link; the file itself would be right",
		         names[i]);
		refused(ts_page_add_folder(page, scratch_root), told);
		unlink(scratch_path("%s", i == 2 ? "way" : names[i]));
		ts_page_free(page);
	}
	unlink(scratch_path("real.json"));
	unlink(scratch_path("one.png"));
}

static void damaged_times_are_refused(void **state)
{
	(void)state;
	ts_page *page = new_page(0);
	put("report.json", "{\"program\": \"touchstone\"}");
	put("times.json", "[");
	refused(ts_page_add_folder(page, scratch_root), "times.json");
	unlink(scratch_path("report.json"));
	refused(ts_page_add_folder(page, scratch_root), "report.json");
	unlink(scratch_path("times.json"));
	ts_page_free(page);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(pictures_are_found_by_their_names),
		cmocka_unit_test(other_files_are_no_pictures),
		cmocka_unit_test(pictures_of_methods_and_truths_are_judged),
		cmocka_unit_test(pictures_show_the_words_of_their_row),
		cmocka_unit_test(a_picture_names_its_trace),
		cmocka_unit_test(each_folder_gives_its_report),
		cmocka_unit_test(the_first_folder_judges_the_second),
		cmocka_unit_test(wrong_reports_are_refused),
		cmocka_unit_test(links_are_refused),
		cmocka_unit_test(damaged_times_are_refused),
	};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_end);
}

/* params.txt of a golden: what each line sets, and nothing of the file before; and what is refused. */
#include "golden/params.h"
#include "tests/golden/dir.h"

static ts_status read_text(ts_golden_settings *settings, const char *text, size_t n)
{
	write_file("params.txt", text, n);
	return ts_golden_read_params(settings, &dir);
}

static void reads(ts_golden_settings *settings, const char *text)
{
	if (read_text(settings, text, strlen(text)) != TS_OK) fail_msg("%s", ts_error_message());
}

static void each_line_sets_its_parameter(void **state)
{
	(void)state;
	ts_golden_settings settings;
	ts_params usual;
	ts_params_default(&usual);
	reads(&settings, "effect=reflections\nmethod=epr\nscene=atrium:texels=32\nwidth=48\n");
	assert_string_equal(settings.effect, "reflections");
	assert_string_equal(settings.method, "epr");
	assert_string_equal(settings.scene, "atrium:texels=32");
	assert_int_equal(settings.params.width, 48);
	assert_int_equal(settings.params.height, usual.height);
	reads(&settings, "height=20\nmethod=mvr"); /* without a last end of line */
	assert_string_equal(settings.effect, "");
	assert_string_equal(settings.method, "mvr");
	assert_string_equal(settings.scene, "");
	assert_int_equal(settings.params.width, usual.width);
	assert_int_equal(settings.params.height, 20);
	reads(&settings, "");
	assert_memory_equal(&settings.params, &usual, sizeof usual);
}

static void refuses(const char *text, size_t n, const char *words)
{
	ts_golden_settings settings;
	refused(read_text(&settings, text, n), words);
}

static void wrong_lines_are_refused(void **state)
{
	(void)state;
	ts_golden_settings settings;
	refuses("width\n", 6, "params.txt: \"width\" is not NAME=VALUE");
	refuses("width=48\n\n", 10, "params.txt: \"\" is not NAME=VALUE");
	refuses("width=48\0\n", 10, "params.txt: a byte that is no text");
	refuses("breadth=48\n", 11, "there is no parameter \"breadth\"");
	refuses("width=0\n", 8, "params.txt: ");
	remove(scratch_path("params.txt"));
	assert_int_equal(ts_golden_read_params(&settings, &dir), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "params.txt: No such file"));
}

static ts_status bound(u32 width, u32 height, u32 frame)
{
	ts_golden_settings settings = {.scene = "atrium"};
	ts_params_default(&settings.params);
	settings.params.width = width;
	settings.params.height = height;
	settings.params.frame = frame;
	return ts_golden_bound(&settings);
}

static void a_golden_has_a_bound_of_pixels(void **state)
{
	(void)state;
	assert_int_equal(bound(1024, 1024, 1000), TS_OK);
	assert_int_equal(bound(1024, 1025, 1000), TS_ERROR);
	assert_non_null(strstr(ts_error_message(), "1024 x 1025 pixels, frame 1000: a golden has at most 1048576 pixels"));
	assert_int_equal(bound(1025, 1024, 0), TS_ERROR);
	assert_int_equal(bound(16, 16, 1001), TS_ERROR);
	assert_int_equal(bound(65536, 65536, 0), TS_ERROR); /* whose product is 0 in 32 bits */
}

static void only_relative_scenes_are_accepted(void **state)
{
	(void)state;
	static const struct {
		const char *spec;
		ts_status status;
	} scenes[] = {{"atrium", TS_OK},         {"gallery:triangles=10000", TS_OK},
	              {"room.gltf", TS_OK},      {"../a/b.glb", TS_OK},
	              {"points.ply", TS_OK},     {"", TS_ERROR},
	              {"/etc/passwd", TS_ERROR}, {"/room.gltf", TS_ERROR},
	              {"room.obj", TS_ERROR},    {"room", TS_ERROR},
	              {"room.gltf/x", TS_ERROR}};
	for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
		ts_golden_settings settings = {.params.width = 16, .params.height = 16};
		strcpy(settings.scene, scenes[i].spec);
		assert_int_equal(ts_golden_bound(&settings), scenes[i].status);
	}
}

/* Options of the scene stay in their order; more than there is room for are refused. */
static void options_of_the_scene_keep_their_order(void **state)
{
	(void)state;
	ts_golden_settings settings;
	char mirrors[TS_GOLDEN_PLACES + 32] = "";
	reads(&settings, "camera=door=1\nwidth=48\nmirror=1,2,3,4\nmirror=5,6,7,8\n");
	assert_string_equal(settings.places, "camera=door=1\nmirror=1,2,3,4\nmirror=5,6,7,8\n");
	assert_int_equal(settings.params.width, 48);
	while (strlen(mirrors) < TS_GOLDEN_PLACES) strcat(mirrors, "mirror=1,2,3,4\n");
	refuses(mirrors, strlen(mirrors), "params.txt: mirror: the options of the scene are too long");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(each_line_sets_its_parameter),          cmocka_unit_test(wrong_lines_are_refused),
		cmocka_unit_test(a_golden_has_a_bound_of_pixels),        cmocka_unit_test(only_relative_scenes_are_accepted),
		cmocka_unit_test(options_of_the_scene_keep_their_order),
	};
	return cmocka_run_group_tests(tests, dir_begin, dir_end);
}

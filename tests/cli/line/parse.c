/* Command lines: what is typed wrongly is refused by one line that says what would be right; what is right is taken,
 * and what was not typed has its default. */
#include "tests/cli/typed.h"

static void assert_refused(const char *line, const char *why)
{
	assert_int_equal(typed_parse(line), TS_ERROR);
	assert_string_equal(ts_error_message(), why);
}

static void options_want_their_values(void **state)
{
	(void)state;
	assert_refused("render -o", "render: option -o needs a value, DIR");
	assert_refused("render --output", "render: option --output needs a value, DIR");
	assert_refused("render --size", "render: option --size needs a value, WxH");
	assert_refused("render --json=3", "render: option --json takes no value");
	assert_refused("render --metod epr",
	               "render: no option --metod; the nearest is --method, and \"touchstone help render\" lists all");
	assert_refused("render", "render: too few arguments; write touchstone render EFFECT [SCENE]");
	assert_refused("list params more yet", "list: one argument too many, \"yet\"; write touchstone list WHAT [NAME]");
}

/* Each byte as a letter: a character of text as it is, any other as its number. */
static void unknown_letters_are_refused_as_typed(void **state)
{
	(void)state;
	for (u32 letter = 1; letter < 256; letter++) {
		char line[32], why[80], shown[8];
		const bool good = letter == 'o' || letter == 'q' || letter == 'h' || letter == '-';
		if (good || letter == ' ' || letter == ':' || letter == '?') continue;
		snprintf(line, sizeof line, "render -%c", (char)letter);
		snprintf(shown, sizeof shown, letter > ' ' && letter <= '~' ? "%c" : "\\x%02x", letter);
		snprintf(why, sizeof why, "render: no option -%s; \"touchstone help render\" lists all", shown);
		assert_refused(line, why);
	}
}

/* A command line that was refused within a word leaves nothing to the next one. */
static void a_refused_line_leaves_nothing_behind(void **state)
{
	(void)state;
	assert_refused("compare -xq", "compare: no option -x; \"touchstone help compare\" lists all");
	assert_int_equal(typed_parse("compare a b"), TS_OK);
	assert_int_equal(typed_cli.n_typed, 0);
	assert_string_equal(typed_cli.arguments[0], "a");
}

static void assert_floats(const f32 *found, const f32 *right, u32 n)
{
	for (u32 i = 0; i < n; i++) assert_true(found[i] == right[i]);
}

static void places_have_three_numbers(void **state)
{
	(void)state;
	static const char *const options[] = {"eye", "target", "lamp"};
	static const char *const wrong[] = {"1,2", "1,2,3,4", "1,2,x", "1,,3", ",2,3", "1,2,3,", "1;2;3", "1,2,3m"};
	char line[64], why[80];
	for (u32 i = 0; i < 3; i++) {
		for (u32 k = 0; k < sizeof wrong / sizeof *wrong; k++) {
			snprintf(line, sizeof line, "render reflections --%s %s", options[i], wrong[k]);
			snprintf(why, sizeof why, "--%s: \"%s\" is not X,Y,Z", options[i], wrong[k]);
			assert_refused(line, why);
		}
	}
	assert_int_equal(typed_parse("render reflections --eye 1,-2.5,3e1 --target 0.125,0,-0 --lamp 7,8,9"), TS_OK);
	assert_floats(typed_cli.job.scene.eye, (const f32[]){1, -2.5f, 30}, 3);
	assert_floats(typed_cli.job.scene.target, (const f32[]){0.125f, 0, 0}, 3);
	assert_floats(typed_cli.job.scene.lamp, (const f32[]){7, 8, 9}, 3);
}

/* Balls are the only mirrors, unless others were asked for. */
static void given_balls_are_the_only_mirrors(void **state)
{
	(void)state;
	char line[TYPED_LINE] = "render reflections";
	assert_refused("render reflections --mirror 1,2,3", "--mirror: \"1,2,3\" is not X,Y,Z,R");
	assert_int_equal(typed_parse("render reflections --mirror 1,2,3,4 --mirror 5,6,7,8"), TS_OK);
	assert_int_equal(typed_cli.job.scene.options.n_mirrors, 2);
	assert_floats(typed_cli.job.scene.mirrors[0], (const f32[]){1, 2, 3, 4, 5, 6, 7, 8}, 8);
	assert_int_equal(TS_PARAM(&typed_cli.job.params, reflectors_count), 0);
	assert_int_equal(typed_parse("render reflections --mirror 1,2,3,4 --reflectors 3"), TS_OK);
	assert_int_equal(TS_PARAM(&typed_cli.job.params, reflectors_count), 3);
	assert_int_equal(typed_parse("render reflections"), TS_OK);
	assert_int_equal(TS_PARAM(&typed_cli.job.params, reflectors_count), 10);
	for (u32 i = 0; i < TS_MAX_MIRRORS; i++) strcat(line, " --mirror 1,2,3,4");
	assert_int_equal(typed_parse(line), TS_OK);
	assert_int_equal(typed_cli.job.scene.options.n_mirrors, TS_MAX_MIRRORS);
	strcat(line, " --mirror 1,2,3,4");
	assert_refused(line, "--mirror: at most 64 can be given");
}

static void what_was_not_typed_has_its_default(void **state)
{
	(void)state;
	assert_int_equal(typed_parse("compare a b"), TS_OK);
	assert_string_equal(typed_cli.arguments[0], "a");
	assert_string_equal(typed_cli.arguments[1], "b");
	assert_int_equal(typed_cli.n_arguments, 2);
	assert_int_equal(typed_cli.judging.first, 1);
	assert_int_equal(typed_cli.n_typed, 0);
	for (u32 i = 0; i < TS_N_OPTIONS; i++) assert_false(typed_cli.given[i]);
	assert_int_equal(typed_parse("compare a --ulp 4294967295 b --rel 1e-3"), TS_OK);
	assert_true(typed_cli.judging.relaxations.ulp == 4294967295u && typed_cli.judging.relaxations.rel == 1e-3);
	assert_int_equal(typed_cli.n_typed, 2);
	assert_true(typed_cli.given[TS_OPTION_ULP] && typed_cli.given[TS_OPTION_REL] && !typed_cli.given[TS_OPTION_ABS]);
	assert_refused("compare a b --ulp 4294967296", "--ulp: \"4294967296\" is not a whole number from 0 to 4294967295");
	assert_refused("compare a b --rel -1", "--rel: \"-1\" is not a number from 0 to 1e30");
	assert_refused("compare a b --rel 1x", "--rel: \"1x\" is not a number from 0 to 1e30");
	assert_refused("compare a b --abs 0x10", "--abs: \"0x10\" is not a number from 0 to 1e30");
	assert_refused("render reflections --eye 0x1,2,3", "--eye: \"0x1,2,3\" is not X,Y,Z");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(options_want_their_values),
		cmocka_unit_test(unknown_letters_are_refused_as_typed),
		cmocka_unit_test(a_refused_line_leaves_nothing_behind),
		cmocka_unit_test(places_have_three_numbers),
		cmocka_unit_test(given_balls_are_the_only_mirrors),
		cmocka_unit_test(what_was_not_typed_has_its_default),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

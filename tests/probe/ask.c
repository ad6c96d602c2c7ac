/* The rows of the probe: which answers, and what is refused. */
#include "tests/probe/probed.h"
#include "tests/whole.h"
#include "tools/tools.h"

enum { MOST_ROWS = 64, MOST_TRACES = 32 };

static traced epr, soft, each[MOST_TRACES];
static u32 n_each;

static u32 make_each(void);

static int make_all(void **state)
{
	(void)state;
	ts_params params = small_params(32, 24);
	params.reflectors_count = 2;
	make(&epr, "reflections", "epr", &params);
	params.lamp_views = params.lamp_cubes = 2;
	params.depth_map_px = 32;
	make(&soft, "soft-shadows", "mvr", &params);
	n_each = make_each();
	return 0;
}

static int drop_all(void **state)
{
	(void)state;
	drop(&epr);
	drop(&soft);
	for (u32 i = 0; i < n_each; i++) drop(&each[i]);
	return 0;
}

/* Every row names a stage, and answers for a method. */
static void every_row_answers_for_a_method(void **state)
{
	(void)state;
	const ts_probe_part *part;
	char methods[TS_PROBE_TEXT];
	u32 n = 0;
	for (; (part = ts_probe_part_at(n)) != NULL; n++) {
		assert_non_null(ts_stage_find(part->stage));
		assert_true((part->view != NULL) == (part->subject == TS_PROBE_TEXEL));
		ts_probe_methods(methods, part);
		assert_true(methods[0] != 0 && strlen(methods) + 1 < TS_PROBE_TEXT);
	}
	assert_true(n > 8);
}

static void a_refusal_names_what_can_be_asked(void **state)
{
	(void)state;
	json_t *answer;
	assert_refused(ask_triangle(&soft, 0, &answer), "no triangles of soft-shadows by mvr, only the eye's pixels");
	assert_refused(ask_texel(&epr, "0.front", 0, 0, &answer), "no view 0.front of reflections by epr, only the eye's");
	static const char *const views[] = {"",     ".",    "0",    "0.",   "0.+XX", "0.6",
	                                    "0.00", "+0.0", "-1.0", "x0.0", "0x0.0", "99999999999999999999.0"};
	for (u32 i = 0; i < sizeof views / sizeof *views; i++) {
		assert_refused(ask_texel(&epr, views[i], 0, 0, &answer),
		               "texels (view REFLECTOR.FACE, for instance 3.+X or 3.0)");
		assert_null(answer);
	}
	assert_refused(ask_texel(&epr, "4294967296.0", 0, 0, &answer), "no face 4294967296.0; there are 2 reflectors");
}

static const char *one_side(u32 side) { return side == 0 ? "inside" : "outside"; }

static ts_status say(ts_probe *probe, const ts_probe_question *question, json_t *object)
{
	(void)probe;
	json_object_set_new(object, "index", json_integer((json_int_t)question->index));
	json_object_set_new(object, "side", json_integer((json_int_t)question->side));
	return question->x == 0 ? TS_OK : ts_fail("not there");
}

/* A trace of a method that no row answers for is not opened, and what it could be compared by is said. */
static void assert_unexplained(const ts_probe_part *none)
{
	static const ts_probe_part hulls[] = {{TS_PROBE_PIXEL, "hull", say, "hulls", NULL}, {0}};
	static const ts_probe_part splats[] = {{TS_PROBE_PIXEL, "forward", say, "colours", NULL}, {0}};
	const ts_probe_part *const others[] = {none, hulls, NULL}, *const of_effect[] = {splats, NULL};
	ts_probe *probe;
	ts_probe_use(others);
	assert_refused(ts_probe_open(&probe, epr.trace),
	               ": probe explains other effects; this is reflections by epr, which compare and replay judge");
	assert_null(probe);
	ts_probe_use(of_effect);
	assert_refused(ts_probe_open(&probe, epr.trace), ": probe explains reflections by epr-forward; this is ");
	assert_null(probe);
}

/* A family of its own is asked, and the first of its rows that fits answers. */
static void the_first_row_that_fits_answers(void **state)
{
	(void)state;
	static const ts_probe_view of_shell = {.form = "shellN.inside", .prefix = "shell", .side = one_side, .n_sides = 2};
	static const ts_probe_part none[] = {{0}};
	static const ts_probe_part shells[] = {
		{TS_PROBE_TEXEL, "depth_map", say, "shells", &of_shell},
		{TS_PROBE_TRIANGLE, "splat", say, "splats", NULL},
		{0},
	};
	static const ts_probe_part *const families[] = {none, shells, NULL};
	json_t *answer;
	char methods[TS_PROBE_TEXT];
	ts_probe_use(families);
	assert_ptr_equal(ts_probe_part_at(0), &shells[0]);
	assert_null(ts_probe_part_at(2));
	ts_probe_methods(methods, &shells[1]);
	assert_string_equal(methods, "reflections by epr");
	require(ask_texel(&soft, "shell12.outside", 0, 0, &answer));
	assert_int_equal(figure(answer, "index"), 12);
	assert_int_equal(figure(answer, "side"), 1);
	json_decref(answer);
	assert_refused(ask_texel(&soft, "shell12.outside", 1, 0, &answer), "not there");
	assert_null(answer);
	assert_refused(ask_pixel(&soft, 0, 0, &answer), "only texels (view shellN.inside)");
	assert_refused(ask_texel(&epr, "shell0.inside", 0, 0, &answer), "only triangles");
	assert_null(answer);
	assert_unexplained(none);
	ts_tools_begin();
	require(ask_pixel(&soft, 0, 0, &answer));
	json_decref(answer);
}

/* ---- every row of every method ---- */

static bool is_for(const ts_probe_part *part, const ts_pipeline *pipeline)
{
	const ts_step *step = ts_pipeline_steps(pipeline);
	while (step->stage != NULL && strcmp(step->stage, part->stage) != 0) step++;
	return step->stage != NULL;
}

/* Traces of all methods that have a row which none of their effect had before. */
static u32 make_each(void)
{
	const ts_effect *had[MOST_ROWS] = {NULL};
	u32 n = 0;
	for (const ts_pipeline *const *at = ts_pipelines(); *at != NULL; at++) {
		const ts_probe_part *part;
		bool found = false;
		ts_params params = small_params_of_all();
		for (u32 i = 0; (part = ts_probe_part_at(i)) != NULL; i++) {
			assert_true(i < MOST_ROWS);
			found |= is_for(part, *at) && had[i] != (*at)->effect;
			if (is_for(part, *at)) had[i] = (*at)->effect;
		}
		if (!found) continue;
		assert_true(n < MOST_TRACES);
		params.surfels_from_mesh = ts_pipeline_reads(*at, TS_B_scene_surfel) ? 500 : 0;
		params.depth_grid_px = 32;
		params.lookup_bounces = params.vpl_bounces = 2;
		params.gloss_lobe = 1;
		make(&each[n++], (*at)->effect->name, (*at)->name, &params);
	}
	return n;
}

/* A question for a row of the probe, of a pixel; or of what it shows, or what its number names. */
static ts_probe_question question_of(const traced *t, const ts_probe_part *part, u32 pixel, char view[32])
{
	u32 width = t->run.params.width;
	ts_probe_question q = {.subject = part->subject, .x = pixel % width, .y = pixel / width};
	if (part->subject == TS_PROBE_TRIANGLE) q.index = (u32)((const u64 *)data(t, TS_B_eye_depth_triangle))[pixel];
	if (part->subject == TS_PROBE_POINT) q.index = pixel;
	if (part->subject != TS_PROBE_TEXEL) return q;
	q.x = q.y = pixel % 8;
	snprintf(view, 32, "%s0.%s", part->view->prefix, part->view->side(pixel % part->view->n_sides));
	q.view = view;
	return q;
}

/* What lacks anything is refused by the name of what it lacks, or told as far as it goes. */
static void without_a_buffer_nothing_else_is_told(void **state)
{
	(void)state;
	u32 n_rows = 0, n_needed = 0;
	for (u32 k = 0; k < n_each; k++) {
		const ts_probe_part *part;
		for (u32 i = 0; (part = ts_probe_part_at(i)) != NULL; i++) {
			char view[32];
			if (!is_for(part, each[k].run.pipeline)) continue;
			ts_probe_question q = question_of(&each[k], part, 9 * 32 + 16, view);
			n_needed += try_without(&each[k], &q, whole_or(1, 5));
			n_rows++;
		}
	}
	assert_true(n_rows > 20 && n_needed > 3 * n_rows);
}

/* Adds the members of an object, as "place: name"; those of numbers with their bits are none. */
static void add_members(json_t *set, const json_t *of, const char *place)
{
	const char *key;
	json_t *member;
	size_t i;
	char at[200];
	json_object_foreach ((json_t *)of, key, member) {
		if (json_object_get(of, "bits") != NULL && json_object_size(of) == 2) return;
		snprintf(at, sizeof at, "%s: %s", place, key);
		json_object_set_new(set, at, json_true());
		snprintf(at, sizeof at, "%s%s%s", place, *place != 0 ? "." : "", key);
		add_members(set, member, at);
	}
	snprintf(at, sizeof at, "%s[]", place);
	json_array_foreach ((json_t *)of, i, member) add_members(set, member, at);
}

static int by_text(const void *a, const void *b) { return strcmp(*(const char *const *)a, *(const char *const *)b); }

/* A row's members by places, a line each. */
static void print_members(FILE *out, const ts_probe_part *part, json_t *set)
{
	const char *names[2000], *key, *last = "";
	json_t *member;
	size_t n = 0;
	json_object_foreach (set, key, member) {
		assert_true(n < 2000);
		names[n++] = key;
	}
	qsort(names, n, sizeof *names, by_text);
	fprintf(out, "%s, %s", ts_probe_option(part->subject), part->stage);
	for (size_t i = 0; i < n; i++) {
		size_t place = (size_t)(strstr(names[i], ": ") - names[i]) + 1;
		if (i == 0 || strncmp(last, names[i], place) != 0) fprintf(out, "\n\t%.*s", (int)place, names[i]);
		fputs(names[i] + place, out);
		last = names[i];
	}
	fputc('\n', out);
}

/* Asks each method of the row about some pixels, and what they show. */
static void print_row(FILE *out, const ts_probe_part *part)
{
	json_t *set = json_object();
	n_random = 0;
	for (u32 k = 0; k < n_each; k++) {
		u32 n = each[k].run.params.width * each[k].run.params.height;
		for (u32 tried = 0; is_for(part, each[k].run.pipeline) && tried < 20; tried++) {
			char view[32];
			json_t *answer;
			ts_probe_question q = question_of(&each[k], part, below(n), view);
			if (part->subject == TS_PROBE_TRIANGLE && q.index == TS_NONE) continue;
			require(ts_probe_ask(each[k].probe, &q, &answer));
			add_members(set, answer, "");
			json_decref(answer);
		}
	}
	print_members(out, part, set);
	json_decref(set);
}

/* As far as both texts have the same lines. */
static size_t same_lines(const char *a, const char *b)
{
	size_t n = 0, end;
	while (a[n] != 0 && (end = n + strcspn(a + n, "\n") + 1, strncmp(a + n, b + n, end - n) == 0)) n = end;
	return n;
}

/* Those of members.txt, which programs rely on: a commit that adds, loses or moves one changes that file. */
static void answers_have_the_members_that_are_listed(void **state)
{
	(void)state;
	static char found[64000], listed[64000], path[4096];
	const ts_probe_part *part;
	const char *build = getenv("BUILD");
	FILE *out = fmemopen(found, sizeof found, "w"), *file = fopen("tests/probe/members.txt", "r");
	assert_true(out != NULL && file != NULL);
	for (u32 i = 0; (part = ts_probe_part_at(i)) != NULL; i++) print_row(out, part);
	fclose(out);
	listed[fread(listed, 1, sizeof listed - 1, file)] = 0;
	fclose(file);
	if (strcmp(found, listed) == 0) return;
	snprintf(path, sizeof path, "%.4000s/members.txt", build != NULL ? build : "build/release");
	file = fopen(path, "w");
	assert_non_null(file);
	fputs(found, file);
	fclose(file);
	const char *a = found + same_lines(found, listed), *b = listed + same_lines(found, listed);
	fail_msg("%s has: %.*s; tests/probe/members.txt: %.*s", path, (int)strcspn(a, "\n"), a, (int)strcspn(b, "\n"), b);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(every_row_answers_for_a_method),
		cmocka_unit_test(a_refusal_names_what_can_be_asked),
		cmocka_unit_test(the_first_row_that_fits_answers),
		cmocka_unit_test(without_a_buffer_nothing_else_is_told),
		cmocka_unit_test(answers_have_the_members_that_are_listed),
	};
	return cmocka_run_group_tests(tests, make_all, drop_all);
}

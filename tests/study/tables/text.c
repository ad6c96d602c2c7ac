/* Tables of text: a mistake is said with file, line and column, what a table says is what it has, and no cut or changed
 * text does harm. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "study/tables/text.h"
#include "tests/model/test.h"
#include "tools/tools.h"

#define HEAD "table small\neffect reflections\nscenes atrium\n"
#define EPR "variant epr = epr seen\n"
#define PART "part one \"One\"\n\tpoints \"Points\" whole = epr.count.points\n"

static ts_table_texts *texts_of(const char *text)
{
	ts_table_texts *texts;
	if (ts_table_texts_read(&texts, text, "my.table") != TS_OK) fail_msg("%s", ts_error_message());
	return texts;
}

static void a_mistake_is_said_with_its_place(void **state)
{
	(void)state;
	static const char *const bad[][2] = {
		{"tables x", "my.table:1:1: \"table\", \"stages\", \"shows\", \"frame\", \"speed\" or \"growth\" is expected"},
		{"title x", "my.table:1:1: \"table\", \"stages\", \"shows\", \"frame\", \"speed\" or \"growth\" is expected"},
		{"# a comment\n\n \t\ntable", "my.table:4:6: a name is expected"},
		{"table ../x", "my.table:1:7: \"../x\": a name has at most 40 letters, digits, _, - and ."},
		{"table x y", "my.table:1:9: nothing more is expected"},
		{"table x", "my.table:1:1: the table \"x\" above: it has no \"variant\""},
		{HEAD EPR, "my.table:5:1: the table \"small\" above: it has no \"part\""},
		{"table x\nscenes a\n" EPR "part p \"P\"\n", "my.table:5:1: the table \"x\" above: it has no \"effect\""},
		{HEAD EPR "part p \"P\"\n", "my.table:6:1: the table \"small\" above: a part has no figure"},
		{HEAD "colour red", "my.table:4:1: no key \"colour\""},
		{HEAD "\ttitle x", "my.table:4:2: an indented line belongs to"},
		{HEAD "title", "my.table:4:6: a text is expected"},
		{HEAD "timed yes", "my.table:4:7: nothing more is expected"},
		{HEAD "surfels few", "my.table:4:9: \"few\" is no number"},
		{HEAD "surfels 1.5", "my.table:4:9: a whole number up to 4294967294 is expected"},
		{HEAD "variant epr epr", "my.table:4:13: \"=\" is expected"},
		{HEAD "variant epr =", "my.table:4:14: a method is expected"},
		{HEAD EPR "variant epr = mvr", "my.table:5:9: the variant \"epr\" stands above"},
		{HEAD "variant epr = epr often", "my.table:4:19: \"often\": seen, once, first, alone, long or NAME=VALUE"},
		{HEAD EPR "figure a \"A\" 10 = 1", "my.table:5:14: \"10\": decimals are 0 to 9, or \"whole\""},
		{HEAD EPR "figure a \"A 2 = 1", "my.table:5:10: a text without its second '\"'"},
		{HEAD EPR "figure a \"A\" 2 = ", "my.table:5:17: an expression is expected"},
		{HEAD EPR "figure a \"A\" 2 = 1 + (2", "my.table:5:24: a ')' is missing"},
		{HEAD EPR "figure a \"A\" 2 = epr.ms.nothing", "my.table:5:18: nothing is no stage"},
		{HEAD EPR "figure a \"A\" 2 = epr.rmse.A", "my.table:5:18: A is no variant; the table's truth is \"truth\""},
		{HEAD EPR "figure a \"A\" 2 = b", "my.table:5:18: b: no figure or variant above begins so"},
		{HEAD EPR "figure a \"A\" 2 = 1\nfigure a \"A\" 2 = 1", "my.table:6:8: the figure \"a\" stands above"},
		{HEAD EPR PART "\tpoint", "my.table:7:2: no figure \"point\" above; the nearest is points"},
		{HEAD EPR PART "part one \"Again\"", "my.table:7:6: the part \"one\" stands above"},
		{HEAD EPR PART "claim \"c\" points", "my.table:7:17: a bound is expected"},
		{HEAD EPR PART "claim \"c\" points near 4", "my.table:7:18: \"near\": at most, at least, from, rises, falls,"},
		{HEAD EPR PART "claim \"c\" points at best 4", "my.table:7:21: \"most\" or \"least\" is expected"},
		{HEAD EPR PART "claim \"c\" points at most inf", "my.table:7:26: \"inf\" is no number"},
		{HEAD EPR PART "claim \"c\" points at most 4 today",
	     "my.table:7:28: \"today\": where, beside, else or nothing"},
		{HEAD EPR PART "paper points\n\tA atrium sponza 1", "my.table:8:19: a number is expected"},
		{HEAD EPR PART "paper points\n\tA atrium sponza 1 2 3", "my.table:8:22: nothing more is expected"},
		{HEAD EPR PART "paper point", "my.table:7:7: no figure \"point\" above"},
		{HEAD EPR "picture p = mvr", "my.table:5:13: no variant \"mvr\" above"},
		{HEAD EPR "picture a/b = epr", "my.table:5:9: \"a/b\": a name has at most 40 letters"},
		{HEAD EPR PART "plot \"x\" \"y\" points", "my.table:7:20: a figure is expected"},
		{"table t\neffect mirrors", "my.table:2:8: no effect \"mirrors\""},
		{HEAD "variant epr = eprr", "my.table:4:15: no method \"eprr\""},
		{HEAD "variant epr = epr seed", "my.table:4:19: \"seed\": seen, once,"},
		{HEAD "variant epr = epr cube.px=x", "my.table:4:19: "},
		{HEAD "set seed=1,seen", "my.table:4:5: \"seen\": NAME=VALUE,... is expected"},
		{HEAD "defaults sead=1", "my.table:4:10: "},
		{HEAD "size 8x8", "my.table:4:6: \"8x8\": NAME=VALUE,... is expected"},
		{HEAD "objects mirrors reflector.count 1", "my.table:4:17: no parameter \"reflector.count\""},
		{HEAD EPR "variant wide = epr width=64", "my.table:5:20: width: variants have the size of their row"},
		{HEAD EPR "variant b = epr lookup.bounces=2,reflectors.count=3", "my.table:5:17: reflectors.count: variants"},
		{HEAD EPR "variant b = epr lookup.bounces=1 cube.px=64",
	     "my.table:5:34: \"cube.px=64\": all that is set is one"},
		{HEAD "set truth.rays=5", "my.table:4:5: truth.rays: tables judge by whole truths"},
		{HEAD "scenes gallery", "my.table:4:1: \"scenes\" stands above, too"},
		{HEAD "effect reflections", "my.table:4:1: \"effect\" stands above, too"},
		{HEAD EPR PART HEAD, "my.table:7:7: the table \"small\" stands above"},
		{HEAD "objects a,b reflectors.count 1", "my.table:4:9: \"a,b\": a column's head has at most 40"},
		{HEAD "objects mirrors reflectors.count 1,,3", "my.table:4:34: --objects"},
		{HEAD "objects mirrors reflectors.count 0.5", "my.table:4:34: --objects"},
		{HEAD "objects mirrors reflectors.count 60 50", "my.table:4:34: --objects"},
		{HEAD "objects pixels size 8", "my.table:4:21: --objects"},
		{HEAD EPR "figure 2 \"\" 2 = 1", "my.table:5:8: \"2\": a key is a letter, then"},
		{HEAD EPR "figure a-b \"\" 2 = 1", "my.table:5:8: \"a-b\": a key is a letter, then"},
		{HEAD "variant truth = epr", "my.table:4:9: \"truth\": a name is a letter, then"},
		{HEAD EPR PART "\tscene \"\" 0 = 1", "my.table:7:2: \"scene\" is the key of a row's beginning"},
		{HEAD "part relations \"\"", "my.table:4:6: \"relations\" is a key of every report"},
		{HEAD "part times-x \"\"", "my.table:4:6: \"times-x\" is a key of every report"},
		{HEAD EPR "picture truth-b = epr", "my.table:5:9: \"truth-b\": such pictures are written beside"},
		{HEAD EPR "picture p = epr\npicture p = epr", "my.table:6:9: the picture \"p\" stands above"},
		{HEAD EPR PART "claim \"c\" points at most \"\"", "my.table:7:27: \"\" is no number"},
		{"stages s = splat\nstages s = splat", "my.table:2:8: the list \"s\" stands above"},
		{HEAD "variant epr = pcss\n" PART "\n",
	     "my.table:8:1: the table \"small\" above: a variant is of another effect"},
		{HEAD EPR "part p \"\"\n\ta \"\" 2 = epr.rmse.truth\n",
	     "my.table:7:1: the table \"small\" above: a figure is to the"},
		{HEAD EPR PART "truth Z\n", "my.table:8:1: the table \"small\" above: --truth Z: no truth of reflections"},
		{HEAD "look away", "my.table:4:6: nothing computes \"away\""},
		{HEAD "work sweeps", "my.table:4:6: nothing computes \"sweeps\""},
		{HEAD "work projected_size", "my.table:4:6: nothing computes \"projected_size\""},
		{"stages s = splat,sprat", "my.table:1:12: no stage \"sprat\""},
		{"shows EPR \"table 1\" \"x\" by epr-1", "my.table:1:25: \"by\": \"in\" or \"not\" is expected"},
	};
	for (u32 i = 0; i < sizeof bad / sizeof *bad; i++) {
		ts_table_texts *texts;
		assert_int_equal(ts_table_texts_read(&texts, bad[i][0], "my.table"), TS_ERROR);
		assert_null(texts);
		if (strncmp(ts_error_message(), bad[i][1], strlen(bad[i][1])) != 0)
			fail_msg("%s\n%s, not\n%s", bad[i][0], ts_error_message(), bad[i][1]);
	}
}

static void a_table_has_what_its_text_says(void **state)
{
	(void)state;
	ts_table_texts *texts = texts_of(
		"stages both = splat,lookup\n" HEAD "title A title\nbrief\nset seed=1\ntimed\nsurfels 7\n"
		"objects sizes size 64x64,16x16 50\nlook projected_size\ntruth A\n" EPR
		"variant slow = mvr long cube.px=64\n" PART "\tms \"Time\" 2 = epr.ms.both\n\ttwice \"\" 1 = 2 * ms\n"
		"claim \"c\" points from 1 to 2 of paper where twice from 3 to 4 beside ms else ours: because\n"
		"claim \"d\" ms falls with points\nnearest points\npaper twice points\n\t\"No 1\" atrium sponza 10 - 2e3\r\n"
		"picture p = slow\nplot \"x\" \"y\" rising points ms\nshows EPR \"table 1\" \"what\" in small \"c|d\"\n");
	const ts_bench_row *row = ts_table_texts_at(texts, 0);
	const ts_paper_table *of = row->paper;
	assert_true(strcmp(of->title, "A title") == 0 && strcmp(row->brief, "") == 0 && of->timed && !of->rays);
	assert_true(of->sampled == 7 && of->most == 50 && of->objects_param == NULL && of->look != NULL);
	assert_true(strcmp(of->objects_head, "sizes") == 0 && strcmp(of->objects, "64x64,16x16") == 0);
	assert_true(of->variants[0].seen && of->variants[1].runs == TS_LONG && of->variants[2].method == NULL);
	assert_string_equal(of->variants[1].set, "cube.px=64");
	assert_true(of->figures[1].timed && of->figures[2].timed && !of->figures[0].timed);
	assert_true(of->figures[1].measured && !of->figures[2].measured && of->figures[3].key == NULL);
	assert_string_equal(of->measured[1].what, "splat,lookup");
	const ts_paper_relation *c = of->relations;
	assert_true(c->kind == TS_OF_PAPER && c->low == 1 && c->high == 2 && c->figure == 0);
	assert_true(c->given == 2 && c->least == 3 && c->most == 4 && c->cause == 1);
	assert_string_equal(c->because, "ours: because");
	assert_true(c[1].kind == TS_RISES_WITH && c[1].falls && c[1].low == 0 && c[1].given == TS_NO_FIGURE &&
	            c[2].text == NULL);
	assert_true(of->rows[0].objects == 10 && isnan(of->rows[0].figures[2]) && of->rows[0].figures[0] == 2000);
	assert_string_equal(of->rows[0].name, "No 1");
	assert_true(of->nearest == 0 && of->pictures[0].variant == 1 && of->plot->rises && of->plot->curves[0] == 1);
	const ts_claim *claims = ts_table_texts_claims(texts);
	assert_true(strcmp(claims[0].rows, "c|d") == 0 && claims[0].cannot == NULL && claims[1].paper == NULL);
	assert_null(ts_table_texts_at(texts, 1));
	ts_table_texts_free(texts);
}

/* Lists are as long as there is room for. */
static void too_many_of_anything_are_refused(void **state)
{
	(void)state;
	static const char *const lines[][2] = {{"variant v%u = epr\n", "variants"},
	                                       {"figure f%u \"\" 0 = 1\n", "figures"},
	                                       {"part p%u \"\"\n", "parts"},
	                                       {"stages s%u = splat\n", "lists of stages"},
	                                       {"picture p%u = epr\n", "pictures"}};
	for (u32 k = 0; k < sizeof lines / sizeof *lines; k++) {
		static char text[100000];
		ts_table_texts *texts;
		char *end = text + sprintf(text, "%s", HEAD EPR);
		for (unsigned i = 0; i < 1000; i++) {
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
			end += sprintf(end, lines[k][0], i);
		}
		assert_int_equal(ts_table_texts_read(&texts, text, "my.table"), TS_ERROR);
		if (strstr(ts_error_message(), lines[k][1]) == NULL) fail_msg("%s: %s", lines[k][1], ts_error_message());
	}
}

/* As long as they may be, and longer. */
static void reasons_and_heads_have_room(void **state)
{
	(void)state;
	for (u32 more = 0; more < 2; more++) {
		char text[2000], head[TS_PAPER_HEAD + 2], reason[TS_PAPER_REASON + 2];
		for (u32 k = 0; k < 2; k++) {
			ts_table_texts *texts;
			snprintf(head, sizeof head, "%0*d", TS_PAPER_HEAD + (int)(k == 0 ? more : 0), 7);
			snprintf(reason, sizeof reason, "%0*d", TS_PAPER_REASON + (int)(k == 1 ? more : 0), 7);
			snprintf(text, sizeof text, HEAD EPR "part one \"\"\n\ta \"%s\" 0 = 1\nclaim \"c\" a at most 0 else %s\n",
			         head, reason);
			bool read = ts_table_texts_read(&texts, text, "my.table") == TS_OK;
			assert_int_equal(read, more == 0);
			if (read) {
				ts_report report;
				ts_paper_line line = {.scene = "atrium", .here = {5}};
				ts_report_begin(&report, true);
				ts_paper_report(&report, ts_table_texts_at(texts, 0)->paper, &line, 1);
				assert_int_equal(ts_report_check(&report), TS_OK);
				ts_report_discard(&report);
			}
			ts_table_texts_free(texts);
		}
	}
}

/* As many figures as a part may have are columns of its report. */
static void a_part_has_as_many_figures_as_fit(void **state)
{
	(void)state;
	for (u32 n = TS_PAPER_COLUMNS; n <= TS_PAPER_COLUMNS + 1; n++) {
		char text[4000] = HEAD EPR "objects mirrors reflectors.count 1\npart one \"\"\n";
		ts_table_texts *texts;
		for (u32 i = 0; i < n; i++) snprintf(text + strlen(text), 40, "\tf%u \"\" 0 = %u\n", (unsigned)i, (unsigned)i);
		bool read = ts_table_texts_read(&texts, text, "my.table") == TS_OK;
		assert_int_equal(read, n == TS_PAPER_COLUMNS);
		if (!read) continue;
		ts_report report;
		ts_paper_line line = {.scene = "atrium", .here = {[TS_PAPER_COLUMNS - 1] = 7}};
		ts_report_begin(&report, true);
		ts_paper_report(&report, ts_table_texts_at(texts, 0)->paper, &line, 1);
		const json_t *row = json_array_get(json_object_get(report.root, "one"), 0);
		assert_int_equal(json_object_size(row), TS_PAPER_COLUMNS + 3);
		assert_true(json_number_value(json_object_get(row, "f12")) == 7);
		ts_report_discard(&report);
		ts_table_texts_free(texts);
	}
}

/* Of a table that has each key: cut anywhere, and with a byte changed anywhere. */
static void no_text_does_harm(void **state)
{
	(void)state;
	static const char whole[] =
		"stages both = splat,lookup\n" HEAD "truth A\nobjects mirrors reflectors.count 1,2 50\n" EPR PART
		"\tms \"Time\" 2 = growth(points, points) * (epr.ms.both - 2) / epr.rmse.truth\n"
		"claim \"c\" points from 1 to 2 of paper where ms from 3 to 4 beside ms else ours: because\n"
		"paper ms points\n\t\"No 1\" atrium sponza 10 - 2e3\nplot \"x\" \"y\" rising points ms\n";
	static const char bytes[] = "\t \"\n=(*09.-,x\x01\xff";
	char text[sizeof whole];
	u32 n_read = 0;
	for (size_t i = 0; i < sizeof whole; i++) {
		for (size_t k = 0; k < sizeof bytes; k++) {
			ts_table_texts *texts;
			memcpy(text, whole, sizeof whole);
			text[i] = i + 1 < sizeof whole ? bytes[k] : 0;
			bool read = ts_table_texts_read(&texts, text, "my.table") == TS_OK;
			n_read += read;
			assert_true(read == (texts != NULL));
			ts_table_texts_free(texts);
		}
	}
	assert_true(n_read > 100);
}

int main(void)
{
	ts_tools_begin();
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_mistake_is_said_with_its_place),  cmocka_unit_test(a_table_has_what_its_text_says),
		cmocka_unit_test(too_many_of_anything_are_refused),  cmocka_unit_test(reasons_and_heads_have_room),
		cmocka_unit_test(a_part_has_as_many_figures_as_fit), cmocka_unit_test(no_text_does_harm),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

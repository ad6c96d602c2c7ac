/* Verdicts on a paper's claims: one holds, one differs and says why, one is of a time of a busy machine. */
#include <math.h>
#include "study/busy.h"
#include "study/tables/text.h"
#include "tests/model/test.h"
#include "tools/tools.h"

enum { MS, COUNT, RATE };
static const char text[] =
	"table test\neffect reflections\nscenes atrium\nobjects mirrors reflectors.count 1\nvariant one = epr\npart one \"One\"\n"
	"\tms \"ms\" 2 = one.ms.frame\n\tcount \"count\" whole = one.count.points\n\trate \"1/s\" 2 = 1000 / ms\n"
	"claim \"a time\" ms at most 10 beside count else ours: slow\n"
	"claim \"a count\" count at least 5 else ours: few\n"
	"claim \"a count by the paper's\" count from 0.5 to 2 of paper beside ms else ours: fewer\n"
	"claim \"a rate, from row to row\" rate grows 1 beside ms else ours: falls\n"
	"claim \"times with counts\" ms rises with count beside ms else ours: they fall\n"
	"claim \"times against counts\" ms falls with count beside ms else ours: they rise\n";
static ts_table_texts *texts;
static const ts_paper_table *table;

static int begin(void **state)
{
	(void)state;
	ts_tools_begin();
	if (ts_table_texts_read(&texts, text, "test") != TS_OK) fail_msg("%s", ts_error_message());
	table = ts_table_texts_at(texts, 0)->paper;
	return 0;
}

static int end(void **state)
{
	(void)state;
	ts_table_texts_free(texts);
	return 0;
}

/* The verdicts of two rows, in the order of the relations. */
static void check(double others, const char *const wanted[8])
{
	ts_report report;
	ts_report_begin(&report, true);
	ts_paper_line lines[2] = {{.scene = "a", .others = others}, {.scene = "a", .others = 0}};
	const double here[2][3] = {{20, 4, 50}, {8, 6, 125}};
	for (u32 i = 0; i < 2; i++) {
		memcpy(lines[i].here, here[i], sizeof here[i]);
		for (u32 f = 0; f < TS_BENCH_FIGURES; f++) lines[i].paper[f] = NAN;
	}
	lines[0].paper[COUNT] = 10; /* the other row has none */
	ts_paper_report(&report, table, lines, 2);
	const json_t *found = json_object_get(report.root, "relations");
	assert_int_equal(json_array_size(found), 8);
	for (size_t i = 0; i < 8; i++) {
		const char *verdict = json_string_value(json_object_get(json_array_get(found, i), "verdict"));
		if (strncmp(verdict, wanted[i], strlen(wanted[i])) != 0) fail_msg("%zu: %s, not %s", i, verdict, wanted[i]);
	}
	const json_t *all = json_array_get(found, 6);
	assert_string_equal(json_string_value(json_object_get(all, "scene")), "all");
	assert_int_equal(json_integer_value(json_object_get(all, "mirrors")), 0);
	ts_report_discard(&report);
}

static void times_of_busy_machines_are_not_judged(void **state)
{
	(void)state;
	const char *const quiet[8] = {"differs: ours: slow",
	                              "holds",
	                              "differs: ours: few",
	                              "holds",
	                              "differs: ours: fewer (ms 20 here)",
	                              "holds",
	                              "differs: ours: they fall",
	                              "holds"};
	const char *const busy[8] = {"not judged: others used", "holds",      "differs: ours: few", "holds",
	                             "differs: ours: fewer",    "not judged", "not judged",         "not judged"};
	check(0, quiet);
	check(NAN, quiet);
	check(ts_busy_limit(), quiet);
	check(ts_busy_limit() + 0.01, busy);
}

/* Two scenes whose files have one name do not go on from each other. */
static void scenes_of_one_name_are_two(void **state)
{
	(void)state;
	ts_report report;
	ts_report_begin(&report, true);
	ts_paper_line lines[2] = {{.scene = "a", .of_scene = 1, .here = {1, 1, 9}},
	                          {.scene = "a", .of_scene = 2, .here = {1, 1, 1}}};
	ts_paper_report(&report, table, lines, 2);
	const json_t *row;
	size_t i, grows = 0;
	json_array_foreach (json_object_get(report.root, "relations"), i, row)
		grows += strncmp(json_string_value(json_object_get(row, "relation")), "a rate", 6) == 0;
	assert_int_equal(grows, 0);
	ts_report_discard(&report);
}

/* Of two frames; only programs are told. */
static void figures_over_frames_have_their_extremes(void **state)
{
	(void)state;
	ts_report report;
	ts_report_begin(&report, false);
	ts_paper_line line = {.scene = "a", .here = {[MS] = 3, [COUNT] = 5}};
	ts_frame_spread_add(&line.over[COUNT], 4, 8);
	ts_frame_spread_add(&line.over[COUNT], 6, 9);
	ts_frame_spread_add(&line.over[MS], 3, 8);
	ts_paper_report_frames(&report, table, &line, 1);
	const json_t *counts = json_object_get(report.root, "over_frames"), *row = json_array_get(counts, 0);
	const json_t *times = json_object_get(report.root, "milliseconds_over_frames");
	assert_true(json_array_size(counts) == 1 && json_array_size(times) == 1);
	assert_true(ts_report_is_timed(&report, "milliseconds_over_frames") && !ts_report_is_timed(&report, "over_frames"));
	assert_string_equal(json_string_value(json_object_get(row, "figure")), "count");
	assert_true(json_real_value(json_object_get(row, "mean")) == 5 &&
	            json_real_value(json_object_get(row, "least")) == 4);
	assert_int_equal(json_integer_value(json_object_get(row, "most_at")), 9);
	assert_int_equal(ts_report_check(&report), TS_OK);
	assert_int_equal(report.text.bytes, 0);
	ts_report_discard(&report);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(times_of_busy_machines_are_not_judged),
	                                   cmocka_unit_test(scenes_of_one_name_are_two),
	                                   cmocka_unit_test(figures_over_frames_have_their_extremes)};
	return cmocka_run_group_tests(tests, begin, end);
}

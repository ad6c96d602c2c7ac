/* The output of a judging command. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "cli/reports/outcomes.h"
#include "cli/reports/sharded.h"
#include "study/results/folder.h"

void ts_relaxed_text(char text[TS_RELAXED_TEXT], const ts_cli *cli)
{
	const ts_judging *judging = &cli->judging;
	const ts_relaxed *r = &judging->relaxations;
	const ts_tolerances *t = &judging->tolerances;
	FILE *out = fmemopen(text, TS_RELAXED_TEXT, "w");
	text[0] = 0;
	if (out == NULL) return;
	if (r->ulp > 0) fprintf(out, " --ulp %" PRIu64, r->ulp);
	if (r->abs > 0) fprintf(out, " --abs %.17g", r->abs);
	if (r->rel > 0) fprintf(out, " --rel %.17g", r->rel);
	if (cli->given[TS_OPTION_ALLOW]) fprintf(out, " --allow %" PRIu64, r->allow);
	if (cli->given[TS_OPTION_PERCENT]) fprintf(out, " --percent %.17g", t->percent);
	if (cli->given[TS_OPTION_HARDFAIL]) fprintf(out, " --hardfail %.17g", t->hardfail);
	if (cli->given[TS_OPTION_RMSE]) fprintf(out, " --rmse %.17g", t->rmse);
	if (cli->given[TS_OPTION_EXPOSURE]) {
		fprintf(out, " --exposure %.9g", (double)TS_PARAM(&cli->job.params, image_exposure));
	}
	if (r->decided) fprintf(out, " --decided");
	if (r->ignore != NULL) fprintf(out, " --ignore %.200s", r->ignore);
	if (judging->mask != NULL) fprintf(out, " --mask %.200s", judging->mask);
	if (judging->baseline != NULL) fprintf(out, " --baseline %.200s", judging->baseline);
	if (judging->skip != NULL) fprintf(out, " --skip %.200s", judging->skip);
	fclose(out);
	if (text[0] != 0) memmove(text, text + 1, strlen(text));
	ts_line_clean(text);
}

static ts_status write_files(ts_report *report, const ts_cli *cli, const ts_outcomes_output *t)
{
	ts_status status = t->draw != NULL ? t->draw(t->user) : TS_OK;
	if (status != TS_OK) return status;
	ts_report_value(report, "program", json_string(ts_program));
	if (cli->job.shard.of == 0) return ts_results_report(report);
	ts_report_timed(report, "seconds", json_incref(t->outcomes->seconds));
	ts_report_timed(report, "seconds_in_all", json_real(ts_seconds() - cli->began));
	const ts_sharded sharded = {t->command, t->outcomes->class_name, t->cases, t->status, NULL};
	return ts_sharded_write(report, cli, &sharded);
}

static ts_status write_folder(ts_report *report, const ts_cli *cli, const ts_outcomes_output *t)
{
	ts_status status = ts_results_begin(cli->job.output.dir, cli->job.output.force);
	if (status == TS_OK) status = write_files(report, cli, t);
	if (status == TS_OK) status = ts_folder_commit();
	if (status != TS_OK) ts_folder_discard();
	return status;
}

static ts_status write_junit(const ts_cli *cli, const ts_outcomes_output *t)
{
	ts_junit junit;
	char suite[64];
	snprintf(suite, sizeof suite, "touchstone %s", t->command);
	if (cli->judging.junit == NULL) return TS_OK;
	if (ts_junit_begin(&junit, cli->judging.junit, suite) != TS_OK) return TS_ERROR;
	ts_outcomes_junit(t->outcomes, &junit);
	return ts_junit_end(&junit, t->relaxed, ts_seconds() - cli->began);
}

static ts_status write_markdown(const ts_cli *cli, const ts_outcomes_output *t)
{
	ts_file_text text;
	if (cli->judging.markdown == NULL) return TS_OK;
	if (ts_file_text_begin(&text, cli->judging.markdown) != TS_OK) return TS_ERROR;
	ts_outcomes_markdown(t->outcomes, t->command, t->relaxed, text.out);
	return ts_file_text_replace(&text, cli->judging.markdown);
}

static ts_status write_page(const ts_report *report, const ts_cli *cli, const ts_outcomes_output *t)
{
	char *json = json_dumps(report->root, JSON_COMPACT);
	ts_status status = json != NULL ? t->show(cli, json, t->user) : ts_fail("the page: out of memory");
	free(json);
	return status;
}

static ts_status print_tap(const ts_outcomes_output *t)
{
	ts_file_text text;
	if (ts_file_text_begin(&text, "the verdicts") != TS_OK) return TS_ERROR;
	ts_outcomes_tap(t->outcomes, t->relaxed, text.out);
	return ts_file_text_print(&text);
}

ts_status ts_outcomes_report(ts_cli *cli, const ts_outcomes_output *t, bool print)
{
	ts_report report;
	ts_report_begin(&report, cli->job.output.json);
	report.quiet = cli->job.output.quiet;
	t->report(&report, t->user);
	if (report.quiet && !t->lines) ts_outcomes_lines(&report, t->outcomes);
	ts_status status = ts_outcomes_check(t->outcomes);
	if (status == TS_OK) status = ts_report_check(&report);
	if (status == TS_OK) {
		status = write_junit(cli, t);
		if (status == TS_OK) status = write_markdown(cli, t);
		cli->judging.reported = status == TS_OK;
	}
	if (status == TS_OK && cli->job.output.dir != NULL) status = write_folder(&report, cli, t);
	if (status == TS_OK && cli->job.output.report != NULL) status = write_page(&report, cli, t);
	if (status == TS_OK && print && !cli->judging.tap) return ts_report_end(&report);
	if (status == TS_OK && cli->judging.tap) status = print_tap(t);
	ts_report_discard(&report);
	return status;
}

void ts_outcomes_report_failed(const ts_cli *cli, const char *command, ts_status status)
{
	ts_outcomes outcomes;
	char class_name[64], relaxed[TS_RELAXED_TEXT], why[1024];
	bool skipped = status == TS_SKIPPED;
	snprintf(why, sizeof why, "%s", ts_error_message());
	if (cli->judging.reported) return;
	if (skipped && cli->judging.tap) printf("1..0 # SKIP %s\n", why);
	if (cli->judging.junit == NULL && cli->judging.markdown == NULL) return;
	snprintf(class_name, sizeof class_name, "touchstone.%.*s", (int)strcspn(command, " "), command);
	const ts_outcomes_output output = {.command = command, .outcomes = &outcomes, .relaxed = relaxed};
	ts_relaxed_text(relaxed, cli);
	if (ts_outcomes_begin(&outcomes, "case", class_name) == TS_OK) {
		ts_outcomes_add(&outcomes, "comparison", "not compared", skipped ? TS_LEFT_OUT : TS_BROKEN, skipped ? why : "",
		                0);
		if (!skipped) ts_outcomes_line(&outcomes, why);
		if (!outcomes.failed && write_junit(cli, &output) == TS_OK) write_markdown(cli, &output);
	}
	ts_outcomes_end(&outcomes);
}

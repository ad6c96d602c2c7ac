/* What a comparison found, in the forms that were asked for. */
#include "compare.h"
#include "junit.h"
#include "../study/folder.h"

static ts_status write_folder(ts_report *report, const ts_cli *cli, const ts_compare_forms *forms, const void *user)
{
	ts_status status = ts_results_begin(cli->job.output.dir, cli->job.output.force);
	if (status == TS_OK) status = forms->draw(user);
	if (status == TS_OK) {
		ts_report_value(report, "program", json_string(ts_program));
		status = ts_results_report(report);
	}
	if (status == TS_OK) status = ts_folder_commit();
	if (status != TS_OK) ts_folder_discard();
	return status;
}

static ts_status write_junit(const ts_cli *cli, const ts_compare_forms *forms, const void *user)
{
	ts_junit junit;
	char relaxed[TS_RELAXED_TEXT];
	ts_compare_relaxed(relaxed, cli);
	if (ts_junit_begin(&junit, cli->judging.junit) != TS_OK) return TS_ERROR;
	forms->junit(&junit, user);
	return ts_junit_end(&junit, relaxed, ts_seconds() - cli->began);
}

static void print_tap(const ts_cli *cli, const ts_compare_forms *forms, const void *user)
{
	char relaxed[TS_RELAXED_TEXT];
	ts_compare_relaxed(relaxed, cli);
	if (relaxed[0] != 0) printf("# relaxed: %s\n", relaxed);
	forms->tap(stdout, user);
}

ts_status ts_compare_tell(const ts_cli *cli, const ts_compare_forms *forms, const void *user)
{
	ts_report report;
	ts_report_begin(&report, cli->job.output.json);
	forms->report(&report, user);
	ts_status status = ts_report_check(&report);
	if (status == TS_OK && cli->judging.junit != NULL) status = write_junit(cli, forms, user);
	if (status == TS_OK && cli->job.output.dir != NULL) status = write_folder(&report, cli, forms, user);
	if (status == TS_OK && !cli->judging.tap) return ts_report_end(&report);
	if (status == TS_OK) print_tap(cli, forms, user);
	ts_report_discard(&report);
	return status;
}

static void put_error(ts_junit *junit, const void *why)
{
	ts_junit_case(junit, "touchstone.compare", "comparison", 0);
	ts_junit_say(junit, TS_JUNIT_ERROR, "not compared", why);
	ts_junit_case_end(junit);
}

void ts_compare_failed(const ts_cli *cli)
{
	static const ts_compare_forms forms = {.junit = put_error};
	char why[1024];
	snprintf(why, sizeof why, "%s", ts_error_message());
	if (cli->judging.junit != NULL) write_junit(cli, &forms, why);
}

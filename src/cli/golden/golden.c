/* `golden check|new|bless [CASE...]`: digests under reference/goldens/. */
#include "cli/golden/golden.h"
#include <fnmatch.h>
#include <stdio.h>
#include <string.h>
#include "scene/sources.h"

static const struct {
	const char *name;
	ts_status (*run)(const ts_goldens *goldens);
} actions[] = {
	{"check", ts_golden_check_action},
	{"new", ts_golden_new_action},
	{"bless", ts_golden_bless_action},
};

enum { N_ACTIONS = sizeof actions / sizeof *actions };

/* Refuses options that only another action uses. */
static ts_status check_options(const ts_cli *cli, u32 action)
{
	static const struct {
		u32 option;
		const char *action, *why;
	} limited[] = {
		{TS_OPTION_REASON, "bless", ", which writes it down"},
		{TS_OPTION_SHARD, "check", ""},
		{TS_OPTION_JSON, "check", ""},
		{TS_OPTION_TAP, "check", ""},
		{TS_OPTION_JUNIT, "check", ""},
		{TS_OPTION_MARKDOWN, "check", ""},
		{TS_OPTION_OUTPUT, "check", ""},
		{TS_OPTION_FORCE, "check", ""},
		{TS_OPTION_BASELINE, "check", ""},
		{TS_OPTION_SKIP, "check", ""},
	};
	for (u32 i = 0; i < sizeof limited / sizeof *limited; i++) {
		const char *option = ts_option_table[limited[i].option].name;
		if (!cli->given[limited[i].option] || strcmp(limited[i].action, actions[action].name) == 0) continue;
		return ts_fail("golden %s: --%s is for %s%s; leave it out", actions[action].name, option, limited[i].action,
		               limited[i].why);
	}
	return TS_OK;
}

static ts_status method_of(const void *user, const char *name, const char **effect, const char **method)
{
	const ts_case *found = ts_cases_find(user, name);
	if (found == NULL) return TS_ERROR;
	*effect = found->pipeline->effect->name;
	*method = found->pipeline->name;
	return TS_OK;
}

static ts_status check_name(const void *user, const char *name)
{
	return ts_cases_find(user, name) != NULL ? TS_OK : TS_ERROR;
}

static ts_status read_lists(ts_goldens *goldens, const ts_cli *cli)
{
	ts_status status = TS_OK;
	const char *baseline = cli->judging.baseline, *skip = cli->judging.skip;
	if (baseline != NULL) status = ts_baseline_read(&goldens->known, baseline, method_of, goldens);
	if (skip != NULL && status == TS_OK) status = ts_baseline_skips(&goldens->skips, skip, check_name, goldens);
	return status;
}

/* Marks the cases that a name or a pattern matches. */
static ts_status mark(bool meant[TS_MAX_CASES], const ts_goldens *goldens, const char *name)
{
	bool any = false;
	for (u32 i = 0; i < goldens->n_cases; i++) {
		if (fnmatch(name, goldens->cases[i].name, 0) == 0) meant[i] = any = true;
	}
	return any || ts_cases_find(goldens, name) != NULL ? TS_OK : TS_ERROR;
}

/* In the order of cases.txt, each once. */
static ts_status choose(ts_goldens *goldens, const char *const *names, u32 n)
{
	bool meant[TS_MAX_CASES] = {false};
	for (u32 i = 0; i < n; i++) {
		if (mark(meant, goldens, names[i]) != TS_OK) return TS_ERROR;
	}
	goldens->n_chosen = 0;
	for (u32 i = 0; i < goldens->n_cases; i++) {
		if (n == 0 || meant[i]) goldens->chosen[goldens->n_chosen++] = &goldens->cases[i];
	}
	return TS_OK;
}

ts_status ts_golden_command(ts_cli *cli)
{
	static ts_goldens goldens;
	u32 action = 0;
	char help[64];
	const char *typed = cli->arguments[0];
	ts_nearest nearest = ts_nearest_begin(typed);
	for (u32 i = 0; i < N_ACTIONS; i++) {
		ts_nearest_offer(&nearest, actions[i].name);
		if (strcmp(typed, actions[i].name) == 0) action = i;
	}
	snprintf(help, sizeof help, "%s help golden", ts_program);
	if (nearest.distance != 0) return ts_fail("golden: no action \"%.60s\"%s", typed, ts_nearest_hint(&nearest, help));
	if (check_options(cli, action) != TS_OK || ts_judging_check(cli) != TS_OK) return TS_ERROR;
	goldens.cli = cli;
	const char *dir = cli->golden.dir != NULL ? cli->golden.dir : "reference/goldens";
	if (ts_selftest_require() != TS_OK || ts_golden_dir_open(&goldens.dir, NULL, dir) != TS_OK) return TS_ERROR;
	ts_builtin_keep();
	ts_status status = ts_cases_read(&goldens);
	if (status == TS_OK) status = read_lists(&goldens, cli);
	if (status == TS_OK) status = choose(&goldens, cli->arguments + 1, cli->n_arguments - 1);
	if (status == TS_OK && cli->no_device[0] != 0 && actions[action].run != ts_golden_check_action) {
		ts_fail("%s", cli->no_device);
		status = TS_SKIPPED;
	}
	if (status == TS_OK) status = actions[action].run(&goldens);
	ts_golden_dir_close(&goldens.dir);
	ts_baseline_free(&goldens.known);
	ts_baseline_free(&goldens.skips);
	return status;
}

void ts_case_path(char path[TS_CASE_PATH], const ts_goldens *goldens, const ts_case *c, const char *suffix)
{
	snprintf(path, TS_CASE_PATH, "%s/%s%s", goldens->dir.path, c->name, suffix);
}

ts_status ts_case_compute(ts_golden *golden, const ts_goldens *goldens, const ts_case *c, const ts_how *how)
{
	return ts_golden_make(golden, c->name, c->pipeline, &c->settings, goldens->dir.path, ts_golden_by.open, how);
}

/* `golden check|new|bless [CASE]`: digests under reference/. */
#include <stdio.h>
#include <string.h>
#include "../scene/sources.h"
#include "golden.h"

static const struct {
	const char *name;
	ts_status (*run)(const ts_goldens *goldens, const ts_case *only);
} actions[] = {
	{"check", ts_golden_check_action},
	{"new", ts_golden_new_action},
	{"bless", ts_golden_bless_action},
};

enum { N_ACTIONS = sizeof actions / sizeof *actions };

static ts_status run_action(const ts_goldens *goldens, u32 action, const char *name)
{
	const ts_case *only = name != NULL ? ts_cases_find(goldens, name) : NULL;
	if (name != NULL && only == NULL) return TS_ERROR;
	return actions[action].run(goldens, only);
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
	if (cli->given[TS_OPTION_REASON] && actions[action].run != ts_golden_bless_action) {
		return ts_fail("golden %s: --reason is for bless, which writes it down; leave it out", typed);
	}
	goldens.job = &cli->job;
	goldens.reason = cli->golden.reason;
	const char *dir = cli->golden.dir != NULL ? cli->golden.dir : "reference";
	if (ts_selftest_require() != TS_OK || ts_golden_dir_open(&goldens.dir, NULL, dir) != TS_OK) return TS_ERROR;
	ts_status status = ts_cases_read(&goldens);
	if (status == TS_OK) status = run_action(&goldens, action, cli->n_arguments > 1 ? cli->arguments[1] : NULL);
	ts_golden_dir_close(&goldens.dir);
	return status;
}

void ts_case_path(char path[TS_CASE_PATH], const ts_goldens *goldens, const ts_case *c, const char *suffix)
{
	snprintf(path, TS_CASE_PATH, "%s/%s%s", goldens->dir.path, c->name, suffix);
}

ts_status ts_case_compute(ts_golden *golden, const ts_case *c, const ts_how *how)
{
	ts_scene *scene;
	memset(golden, 0, sizeof *golden);
	if (ts_builtin_open(&scene, c->scene, &c->params, NULL) != TS_OK) return TS_ERROR;
	u64 need = ts_pipeline_estimate(c->pipeline, scene, &c->params, true), limit = ts_memory_limit();
	ts_golden_job job = {c->pipeline, scene, &c->params, *how};
	ts_status status = need <= limit ? ts_golden_compute(golden, &job)
	                                 : ts_fail("%s: needs about %llu MiB; %llu are there", c->name,
	                                           (unsigned long long)(need >> 20), (unsigned long long)(limit >> 20));
	ts_scene_free(scene);
	return status;
}

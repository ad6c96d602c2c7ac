/* The scenes that a table measures. */
#include <stdlib.h>
#include <unistd.h>
#include "study/asked/words.h"
#include "study/bench.h"

enum { SPEC_BYTES = 4096 };

bool ts_bench_model(char *path, size_t bytes, const char *file)
{
	const char *folder = getenv("TS_SCENES") != NULL ? getenv("TS_SCENES") : "scenes";
	snprintf(path, bytes, "%s/%s", folder, file);
	return access(path, R_OK) == 0;
}

static ts_status each_model(const char *list, ts_report *report, ts_bench_scene *each, void *user)
{
	char item[64], path[SPEC_BYTES];
	ts_status status = TS_OK;
	while (status == TS_OK && ts_words_item(&list, item, sizeof item)) {
		if (ts_bench_model(path, sizeof path, item)) {
			status = each(user, path);
		} else {
			ts_report_line(report, "%s: not in TS_SCENES; left out", item);
		}
	}
	return status;
}

ts_status ts_bench_scenes(const ts_job *job, const char *scenes, const char *models, ts_report *report,
                          ts_bench_scene *each, void *user)
{
	const char *list = job->scenes != NULL ? job->scenes : scenes;
	char spec[SPEC_BYTES];
	ts_status status = TS_OK;
	while (status == TS_OK && ts_words_item(&list, spec, sizeof spec)) status = each(user, spec);
	return status == TS_OK && job->scenes == NULL ? each_model(models, report, each, user) : status;
}

/* `bench speed`: stages, other ways to draw the same views, and limits of the machine, in one run. Rows take turns, so
 * that other load on the machine affects all equally; a first turn is not counted. */
#include <stdlib.h>
#include <string.h>
#include "study/asked/words.h"
#include "study/speed_work.h"

enum { MOST_SETS = 24, PATH_BYTES = 4096 };

bool ts_speed_wants(const ts_job *job, const char *name)
{
	return job->scenes == NULL || ts_words_listed(job->scenes, name);
}

static void offer(ts_nearest *nearest, char *names, size_t bytes, const char *name)
{
	const size_t used = strlen(names);
	ts_nearest_offer(nearest, name);
	snprintf(names + used, bytes - used, "%s%s", used != 0 ? ", " : "", name);
}

/* Offers all names, and lists them. */
static void offer_names(ts_nearest *nearest, char *names, size_t bytes, const ts_speed_of *const *lists)
{
	names[0] = 0;
	for (; *lists != NULL; lists++) {
		const ts_speed_scene *scene = (*lists)->scenes;
		const ts_speed_growth *growth = (*lists)->growths;
		for (; scene->name != NULL; scene++) offer(nearest, names, bytes, scene->name);
		for (; growth->of.name != NULL; growth++) offer(nearest, names, bytes, growth->of.name);
	}
}

static ts_status check_names(const ts_job *job, const ts_speed_of *const *lists)
{
	const char *names = job->scenes;
	char item[32], all[256];
	u32 n = 0;
	while (names != NULL && ts_words_item(&names, item, sizeof item)) {
		ts_nearest nearest = ts_nearest_begin(item);
		offer_names(&nearest, all, sizeof all, lists);
		n++;
		if (nearest.distance > 0)
			return ts_fail("bench speed: --scene %s: nothing of that name is measured%s; there are %s", item,
			               ts_nearest_hint(&nearest, NULL), all);
	}
	if (job->objects != NULL && n != 1)
		return ts_fail("bench speed: --objects are the values of one growth, which --scene names");
	return TS_OK;
}

static bool is_measured(const ts_speed_of *const *lists, const char *method)
{
	for (; *lists != NULL; lists++) {
		for (const ts_speed_scene *scene = (*lists)->scenes; scene->name != NULL; scene++)
			for (const char *const *name = scene->methods; *name != NULL; name++)
				if (strcmp(*name, method) == 0) return true;
	}
	return false;
}

static ts_status check_methods(const ts_job *job, const ts_speed_of *const *lists)
{
	const char *names = job->method;
	char item[32];
	if (names == NULL || strcmp(names, "all") == 0) return TS_OK;
	while (ts_words_item(&names, item, sizeof item)) {
		if (!is_measured(lists, item)) return ts_fail("bench speed: --method %s: no frame is measured by it", item);
	}
	return TS_OK;
}

static ts_status open_set(ts_speed *speed, const ts_speed_scene *of)
{
	char path[PATH_BYTES];
	const char *spec = of->spec;
	if (!ts_speed_wants(speed->job, of->name)) return TS_OK;
	if (of->model) {
		if (!ts_bench_model(path, sizeof path, of->spec)) {
			ts_report_line(speed->report, "%s: %s is not in TS_SCENES; left out", of->name, of->spec);
			return TS_OK;
		}
		spec = path;
	}
	ts_speed_set *set = &speed->sets[speed->n_sets];
	ts_status status = ts_speed_set_open(set, spec, of, speed->job, speed->n_runs);
	speed->n_sets++;
	if (status != TS_SKIPPED) return status;
	ts_report_line(speed->report, "%s: left out: %s", of->name, ts_error_message());
	ts_speed_set_close(set);
	memset(set, 0, sizeof *set);
	speed->n_sets--;
	return TS_OK;
}

static ts_status open_sets(ts_speed *speed)
{
	ts_status status = TS_OK;
	speed->sets = ts_alloc_zero(MOST_SETS, sizeof *speed->sets, "frames");
	if (speed->sets == NULL) return TS_ERROR;
	for (const ts_speed_of *const *list = speed->lists; *list != NULL; list++) {
		const ts_speed_scene *scene = (*list)->scenes;
		for (; status == TS_OK && scene->name != NULL; scene++) status = open_set(speed, scene);
	}
	return status;
}

static ts_status take_turns(ts_speed *speed, u32 run)
{
	ts_status status = ts_speed_machine_run(&speed->machine, run, &speed->quiet);
	for (u32 i = 0; i < speed->n_sets && status == TS_OK; i++) {
		status = ts_speed_set_run(&speed->sets[i], run, &speed->quiet);
		if (status == TS_OK)
			ts_say("%s: run %u of %u", speed->sets[i].name, (unsigned)run + 1, (unsigned)speed->n_runs);
	}
	return status;
}

static ts_status measure(ts_speed *speed)
{
	ts_status status = ts_speed_machine_begin(&speed->machine, speed->job->how.threads, speed->n_runs);
	if (status == TS_OK) status = open_sets(speed);
	for (u32 run = 0; run < speed->n_runs && status == TS_OK; run++) status = take_turns(speed, run);
	return status;
}

static void end(ts_speed *speed)
{
	for (u32 i = 0; i < speed->n_sets; i++) ts_speed_set_close(&speed->sets[i]);
	free(speed->sets);
	speed->sets = NULL;
	speed->n_sets = 0;
	ts_speed_machine_end(&speed->machine);
}

static ts_status print(ts_speed *speed)
{
	ts_report_line(speed->report, "medians of %u, by turns; spread: the slowest less the fastest",
	               (unsigned)speed->n_runs);
	ts_speed_print_limits(speed);
	if (speed->n_sets > 0) ts_speed_print_stages(speed);
	if (speed->n_sets > 0) ts_speed_print_figures(speed);
	return TS_OK;
}

static ts_status work(const ts_job *job, ts_report *report, const void *user)
{
	ts_speed speed = {.job = job, .lists = user, .report = report, .n_runs = job->runs};
	ts_bench_head(report, job, true);
	ts_speed_machine_print(&speed);
	ts_status status = ts_quiet_begin(&speed.quiet, report, job->how.threads, job->busy);
	if (status == TS_OK) status = measure(&speed);
	if (status == TS_OK) status = print(&speed);
	end(&speed);
	if (status == TS_OK) status = ts_speed_print_growths(&speed);
	if (status == TS_OK) ts_report_line(report, "%u rows were not quiet", (unsigned)speed.quiet.n_busy);
	ts_report_timed(report, "busy_rows", json_integer(speed.quiet.n_busy));
	return status;
}

ts_status ts_bench_speed(const ts_job *job, const ts_speed_of *const *lists)
{
	ts_status status = check_names(job, lists);
	if (status == TS_OK) status = check_methods(job, lists);
	return status == TS_OK ? ts_bench_with_report(job, work, lists) : status;
}

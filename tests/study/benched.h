/* What tests of tables of `bench` share: a table that is run into a folder, quietly, and its report. */
#ifndef TS_TESTS_STUDY_BENCHED_H
#define TS_TESTS_STUDY_BENCHED_H
#include "study/bench.h"
#include "tests/trace/folder.h"

/* A job of a small image, whose files go to the folder "out" of the scratch folder. */
static inline ts_job benched_job(void)
{
	ts_job job = {.program = "touchstone", .backend = &ts_c_kind, .runs = 1, .how.threads = 2};
	job.output = (ts_output){.dir = scratch_path("out"), .quiet = true, .json = true, .force = true};
	ts_params_default(&job.params);
	return job;
}

/* What `measure` reports of the job, by json_decref(). */
static inline json_t *benched(ts_status (*measure)(const ts_job *job, const void *user), const ts_job *job,
                              const void *user)
{
	fflush(stdout);
	int kept = dup(STDOUT_FILENO);
	assert_non_null(freopen("/dev/null", "w", stdout));
	ts_status status = measure(job, user);
	fflush(stdout);
	dup2(kept, STDOUT_FILENO);
	close(kept);
	if (status != TS_OK) fail_msg("%s", ts_error_message());
	json_t *root = json_load_file(scratch_path("out/report.json"), 0, NULL);
	assert_non_null(root);
	return root;
}

static inline double benched_real(const json_t *row, const char *key)
{
	const json_t *value = json_object_get(row, key);
	if (!json_is_number(value)) fail_msg("%s is no number", key);
	return json_number_value(value);
}

/* Every relation holds where its figure keeps its bound, and differs where not. Returns how many there are. */
static inline size_t benched_relations(const json_t *rows)
{
	for (size_t i = 0; i < json_array_size(rows); i++) {
		const json_t *row = json_array_get(rows, i);
		const char *bound = json_string_value(json_object_get(row, "bound"));
		const char *verdict = json_string_value(json_object_get(row, "verdict"));
		double here = benched_real(row, "here"), limit = strtod(bound + strcspn(bound, "0123456789"), NULL);
		bool holds = strncmp(bound, "at most", 7) == 0    ? here <= limit
		             : strncmp(bound, "at least", 8) == 0 ? here >= limit
		                                                  : here == limit;
		if (strncmp(verdict, holds ? "holds" : "differs: ", 5) != 0) fail_msg("%g, %s: %s", here, bound, verdict);
	}
	return json_array_size(rows);
}

#endif

/* Speed against accuracy: every mark has its row, its error is to the truth that is named, and relations hold where
 * their figures keep their bounds. */
#include "methods/points/tools/benches.h"
#include "tests/study/benched.h"

static ts_status sweep(const ts_job *job, const void *user)
{
	(void)user;
	return ts_bench_sweep(job);
}

static ts_job small_job(void)
{
	ts_job job = benched_job();
	TS_PARAM_SET(&job.params, width, 32);
	TS_PARAM_SET(&job.params, height, 18);
	job.scenes = "atrium:triangles=10000:texels=32";
	job.objects = "2";
	return job;
}

static void every_mark_has_its_row(void **state)
{
	(void)state;
	ts_job job = small_job();
	job.judged = true;
	job.truth = "A";
	json_t *root = benched(sweep, &job, NULL), *times = json_load_file(scratch_path("out/times.json"), 0, NULL);
	const json_t *rows = json_object_get(times, "epr_6");
	u32 n_of_epr = 0;
	assert_int_equal(json_array_size(rows), 17);
	for (size_t i = 0; i < json_array_size(rows); i++) {
		const json_t *row = json_array_get(rows, i);
		bool epr = strncmp(json_string_value(json_object_get(row, "curve")), "EPR", 3) == 0;
		assert_true(benched_real(row, "ms") > 0 && benched_real(row, "rmse") >= 0);
		assert_int_equal(json_is_null(json_object_get(row, "points")), !epr);
		n_of_epr += epr;
	}
	assert_int_equal(n_of_epr, 11);
	assert_int_equal(benched_relations(json_object_get(root, "relations")), 3);
	assert_int_equal(access(scratch_path("out/times-epr_6.svg"), F_OK), 0);
	json_decref(times);
	json_decref(root);
}

static void accuracy_without_a_truth_is_refused(void **state)
{
	(void)state;
	ts_job job = small_job();
	job.judged = true;
	job.truth = "none";
	assert_int_equal(ts_bench_sweep(&job), TS_ERROR);
	says("accuracy needs a truth; write --truth=A, B or C");
	job.truth = "A";
	job.objects = "0";
	assert_int_equal(ts_bench_sweep(&job), TS_ERROR);
	says("--objects");
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(every_mark_has_its_row),
	                                   cmocka_unit_test(accuracy_without_a_truth_is_refused)};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_remove);
}

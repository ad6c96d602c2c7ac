/* Tables of SSAGH that are no rows of a paper: the curves of its integrals against quadrature in double precision, and
 * labels beside components, whose figures follow from each other. */
#include <math.h>
#include "kernels/hulls/segment.h"
#include "methods/hulls/tools/tools.h"
#include "tests/study/benched.h"

static ts_status curves(const ts_job *job, const void *user)
{
	(void)user;
	return ts_bench_curves(job);
}

/* Integral of a spherical Gaussian and the clamped cosine, over the polar angle from the lobe's axis and around it. */
static double quadrature(double lambda, double beta)
{
	enum { POLAR = 400, AROUND = 64 };
	const double pi = acos(-1);
	double sum = 0;
	for (u32 i = 0; i < POLAR; i++) {
		double z = 1 - 2 * pow((i + 0.5) / POLAR, 2), dz = 4 * (i + 0.5) / POLAR / POLAR, r = sqrt(1 - z * z);
		for (u32 k = 0; k < AROUND; k++) {
			double cosine = z * cos(beta) + r * sin(beta) * cos(2 * pi * (k + 0.5) / AROUND);
			sum += exp(lambda * (z - 1)) * fmax(0, cosine) * dz * 2 * pi / AROUND;
		}
	}
	return sum;
}

/* A dot of the plot for each value by the closed form, and no other. */
static void assert_dots(const char *file, const json_t *rows, const char *prefix)
{
	static char svg[1 << 20];
	FILE *in = fopen(scratch_path(file), "rb");
	assert_non_null(in);
	svg[fread(svg, 1, sizeof svg - 1, in)] = 0;
	fclose(in);
	const char *key;
	json_t *value;
	size_t values = 0, dots = 0;
	for (size_t i = 0; i < json_array_size(rows); i++) {
		json_object_foreach (json_array_get(rows, i), key, value)
			values += strncmp(key, prefix, 2) == 0 && strstr(key, "closed") != NULL && json_is_number(value);
	}
	for (const char *at = svg; (at = strstr(at, "<circle")) != NULL; at++) dots++;
	assert_int_equal(dots, values);
}

static void curves_match_quadrature(void **state)
{
	(void)state;
	static const struct {
		double lambda;
		const char *key, *closed;
	} sharp[] = {{1, "c_1", "c_closed_1"}, {5, "c_5", "c_closed_5"}, {20, "c_20", "c_closed_20"}};
	ts_job job = benched_job();
	json_t *root = benched(curves, &job, NULL);
	const json_t *c = json_object_get(root, "ssagh_5_c"), *s = json_object_get(root, "ssagh_5_s");
	assert_true(json_array_size(c) == 37 && json_array_size(s) == 37);
	for (u32 k = 0; k < 3; k++) {
		double upper = quadrature(sharp[k].lambda, 0), lower = quadrature(sharp[k].lambda, acos(-1));
		for (u32 i = 0; i < 37; i++) {
			const json_t *row = json_array_get(c, i);
			double right = (quadrature(sharp[k].lambda, i * acos(-1) / 36) - lower) / (upper - lower);
			assert_true(benched_real(row, "beta") == 5 * i);
			assert_true(fabs(benched_real(row, sharp[k].key) - right) < 5e-3);
			assert_true(fabs(benched_real(row, sharp[k].closed) - right) < 0.02);
		}
	}
	assert_int_equal(benched_relations(json_object_get(root, "relations")), 3);
	assert_dots("out/ssagh_5_c.svg", c, "c_");
	assert_dots("out/ssagh_5_s.svg", s, "s_");
	json_decref(root);
}

static ts_status segments(const ts_job *job, const void *user)
{
	(void)user;
	return ts_bench_segments(job);
}

static void judge_row(const json_t *row, json_int_t blocks)
{
	double labels = benched_real(row, "labels"), components = benched_real(row, "components"),
		   n = benched_real(row, "blocks");
	if (blocks > 0) assert_true(n == (double)blocks);
	assert_true(n >= 0 && labels >= components && fabs(benched_real(row, "excess") - (labels - components)) < 1e-9);
	assert_true(benched_real(row, "most_labels") >= labels && benched_real(row, "most_components") >= components);
	assert_true(benched_real(row, "equal_percent") <= 100 && benched_real(row, "joined") == 0);
	assert_true(components >= 1 && labels <= TS_BLOCK_TEXELS);
}

/* Of each scene all blocks, and those in parts among them; last what FIGURES has of discs. */
static void rows_of_segments_follow_from_each_other(void **state)
{
	(void)state;
	enum { GRID = 64 };
	ts_job job = benched_job();
	TS_PARAM_SET(&job.params, width, 64);
	TS_PARAM_SET(&job.params, height, 36);
	TS_PARAM_SET(&job.params, depth_grid_px, GRID);
	job.scenes = "atrium:triangles=10000:texels=32,dining";
	json_t *root = benched(segments, &job, NULL);
	const json_t *rows = json_object_get(root, "ssagh_segments"), *last = json_array_get(rows, 4);
	assert_int_equal(json_array_size(rows), 5);
	for (u32 i = 0; i < 4; i++) {
		const json_t *row = json_array_get(rows, i);
		assert_string_equal(json_string_value(json_object_get(row, "of")), i % 2 == 0 ? "all" : "parted");
		judge_row(row, i % 2 == 0 ? GRID * GRID / TS_BLOCK_TEXELS : 0);
		if (i % 2 == 1) assert_true(benched_real(row, "components") >= 2 && benched_real(row, "blocks") > 0);
	}
	assert_true(benched_real(last, "blocks") == 300 && benched_real(last, "most_labels") == 63);
	assert_true(benched_real(last, "most_components") == 21 && benched_real(last, "equal_percent") == 32);
	assert_true(fabs(benched_real(last, "labels") - benched_real(last, "components") - benched_real(last, "excess")) <
	            1e-9);
	assert_true(benched_real(last, "joined") == 0);
	assert_int_equal(benched_relations(json_object_get(root, "relations")), 2);
	json_decref(root);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(curves_match_quadrature),
	                                   cmocka_unit_test(rows_of_segments_follow_from_each_other)};
	return cmocka_run_group_tests(tests, scratch_begin, scratch_remove);
}

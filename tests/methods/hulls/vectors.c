/* The primitives of light against the integrals in double precision: spherical Gaussians and triangles that shine. */
#include "../../model/test.h"
#include "../../../src/kernels/hulls/vectors.h"
#include "../../../src/vectors/row.h"
#include "../../kernels/hulls/form_factor_truth.h"
#include "../../kernels/hulls/gaussian_truth.h"

static u32 in[TS_VECTOR_ITEMS * TS_VECTOR_WORDS];
static _Alignas(8) u32 out[TS_VECTOR_ITEMS * TS_VECTOR_WORDS];

/* Of the printed forms, where they neither cancel nor overflow. */
static double cosine_error(f32 ours, double lambda, double c, u32 method, bool printed)
{
	if (method == TS_COSINE_IS_OURS && printed && (lambda < 2 || lambda > 30)) return 0;
	double right = method == TS_COSINE_IS_OURS       ? sg_closed(lambda, c)
	               : method == TS_COSINE_IS_SG       ? sg_as_sg(lambda, c)
	               : method == TS_COSINE_IS_CONSTANT ? fmax(0, c) * sg_sphere(lambda)
	                                                 : sg_truth(lambda, c);
	return fabs(ours - right) / sg_up(lambda);
}

/* A triangle behind the first words of a row. Where it is seen from the side by so little that rounding decides, any
 * value in range is right. */
static void judge_light(const u32 *row, u32 at, f32 ours, bool factor)
{
	double3 p = d3_of(ts_row_v3(row, 0)), corner[3];
	double size = 0;
	for (u32 k = 0; k < 3; k++) {
		corner[k] = d3_sub(d3_of(ts_row_v3(row, at + 3 * k)), p);
		size = fmax(size, d3_length(corner[k]));
	}
	double3 normal = d3_cross(d3_sub(corner[1], corner[0]), d3_sub(corner[2], corner[0]));
	double side = -d3_dot(normal, corner[0]), limit = factor ? 1 : 2 * ff_pi;
	assert_true(ours >= 0 && ours <= (f32)limit);
	if (fabs(side) < 1e-2 * size * size * size) return;
	double right = !factor    ? ff_solid(corner[0], corner[1], corner[2])
	               : side > 0 ? ff_factor(d3_of(ts_row_v3(row, 3)), corner)
	                          : 0;
	assert_near(ours, right, factor ? 1e-6 : 2e-5);
}

/* All that there are, within rounding. */
static void test_light(void **state)
{
	(void)state;
	assert_int_equal(TS_N_HULLS_PRIMITIVES, 4);
	ts_vector_make(ts_vectors_find("sg_cosine"), in, out);
	for (u32 i = 0; i < TS_VECTOR_ITEMS; i++) {
		const u32 *row = in + (size_t)i * 4;
		double c = fmin(fmax(ts_row_f32(row, 1), -1), 1);
		double error = cosine_error(ts_u2f(out[i]), ts_row_f32(row, 0), c, row[2], row[3] != 0);
		assert_true(error <= (row[3] != 0 ? 6e-6 : 1.3e-6));
	}
	ts_vector_make(ts_vectors_find("sg_sharpness"), in, out);
	for (u32 i = 0; i < TS_VECTOR_ITEMS; i++) {
		double r = fmin(ts_u2f(in[2 * i]), 0.999989986), k = ts_u2f(out[i]);
		double mean = in[2 * i + 1] == 0 ? k / (1 + k) : k < 0.01 ? k / 3 - k * k * k / 45 : 1 / tanh(k) - 1 / k;
		assert_true(fabs(mean - r) <= 3e-6 * r);
	}
	ts_vector_make(ts_vectors_find("solid_angle"), in, out);
	for (u32 i = 0; i < TS_VECTOR_ITEMS; i++) judge_light(in + (size_t)i * 12, 3, ts_u2f(out[i]), false);
	ts_vector_make(ts_vectors_find("form_factor"), in, out);
	for (u32 i = 0; i < TS_VECTOR_ITEMS; i++) judge_light(in + (size_t)i * 15, 6, ts_u2f(out[i]), true);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(test_light)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

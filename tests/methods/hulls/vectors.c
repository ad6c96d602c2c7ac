/* The primitives of light against the integrals in double precision: spherical Gaussians and triangles that shine. */
#include "kernels/hulls/vectors.h"
#include "tests/kernels/hulls/form_factor_truth.h"
#include "tests/kernels/hulls/gaussian_truth.h"
#include "tests/model/test.h"
#include "vectors/row.h"

static u32 in[TS_VECTOR_ITEMS * TS_VECTOR_WORDS];
static _Alignas(8) u32 out[TS_VECTOR_ITEMS * TS_VECTOR_WORDS];

/* Of the printed forms, where they neither cancel nor overflow. */
static double cosine_error(f32 ours, double lambda, double c, u32 method, bool printed)
{
	if (method == TS_COSINE_OURS && printed && (lambda < 2 || lambda > 30)) return 0;
	double right = method == TS_COSINE_OURS       ? sg_closed(lambda, c)
	               : method == TS_COSINE_SG       ? sg_as_sg(lambda, c)
	               : method == TS_COSINE_CONSTANT ? fmax(0, c) * sg_sphere(lambda)
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
static void integrals_of_light_match_double_precision(void **state)
{
	(void)state;
	assert_int_equal(TS_N_hulls_vectors, 6);
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

/* By the sum of the vectors lambda phi in double precision. */
static void judge_product(const u32 *row, const u32 *made)
{
	double lambda1 = ts_row_f32(row, 1), lambda2 = ts_row_f32(row, 6), mu = (double)ts_row_f32(row, 0);
	double3 phi1 = d3_of(ts_row_v3(row, 2)), phi2 = d3_of(ts_row_v3(row, 7));
	double3 both = d3_add(d3_scale(phi1, lambda1), d3_scale(phi2, lambda2));
	double lambda = d3_length(both), lost = lambda1 + lambda2 - lambda, all = lambda1 + lambda2;
	double peak = mu * (double)ts_row_f32(row, 5) * exp(-lost);
	assert_near(ts_row_f32(made, 1), lambda, 3e-7 * all);
	if (lambda > 1e-3 * all) assert_true(d3_distance(d3_of(ts_row_v3(made, 2)), d3_scale(both, 1 / lambda)) < 1e-3);
	if (lost < 20) assert_near(ts_row_f32(made, 0), peak, (1e-6 + 1e-6 * all) * peak + 1e-30);
}

static void judge_gloss(const u32 *row, const u32 *made)
{
	double3 n = d3_of(ts_row_v3(row, 0)), v = d3_of(ts_row_v3(row, 3)), phi = d3_of(ts_row_v3(made, 2));
	double a2 = ts_row_f32(row, 6), n_v = d3_dot(n, v), across = fmax(fabs(n_v), 0x1p-10);
	assert_near(ts_row_f32(made, 0), 1 / (ff_pi * a2), 1e-6 / a2);
	assert_near(ts_row_f32(made, 1) * (f32)across, (1 - a2) * (2 / a2 + 1) / 4, 1e-3 / a2);
	assert_true(d3_distance(phi, d3_sub(d3_scale(n, 2 * n_v), v)) < 1e-6);
}

static void products_of_lobes_match_double_precision(void **state)
{
	(void)state;
	ts_vector_make(ts_vectors_find("sg_product"), in, out);
	for (u32 i = 0; i < TS_VECTOR_ITEMS; i++) judge_product(in + (size_t)i * 10, out + (size_t)i * 5);
	ts_vector_make(ts_vectors_find("gloss_lobe"), in, out);
	for (u32 i = 0; i < TS_VECTOR_ITEMS; i++) judge_gloss(in + (size_t)i * 7, out + (size_t)i * 5);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(integrals_of_light_match_double_precision),
	                                   cmocka_unit_test(products_of_lobes_match_double_precision)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

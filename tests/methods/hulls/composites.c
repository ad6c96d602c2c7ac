/* The composites of hulls against their formulas in double precision. */
#include "kernels/hulls/composites.h"
#include "tests/kernels/hulls/form_factor_truth.h"
#include "tests/kernels/hulls/gaussian_truth.h"
#include "tests/vectors/composites.h"

/* Exitance times solid angle times how much counts, a third of it each way to the corners. */
static judgement gather(const u32 *in, const u32 *out)
{
	double3 p = d3_row(in, 16), corner[3], ways = {0, 0, 0}, w = d3_row(out, 0), right, exitance = d3_row(in, 12);
	double side = d3_distance(d3_row(in, 3), d3_row(in, 0)), height = d3_dot(d3_row(in, 9), d3_sub(p, d3_row(in, 0)));
	for (u32 k = 0; k < 3; k++) {
		corner[k] = d3_sub(d3_row(in, 3 * k), p);
		if (d3_length(corner[k]) < 0.05) return NOT_JUDGED;
		ways = d3_add(ways, d3_unit(corner[k]));
	}
	if (fatness(d3_row(in, 0), d3_row(in, 3), d3_row(in, 6)) < 0.05 || fabs(height) < 0.01) return NOT_JUDGED;
	double counts = height < 0 ? 0 : in[19] == 0 ? 1 : fmin(fmax((height - side / 16) / (side / 4), 0), 1);
	right = d3_scale(exitance, ff_solid(corner[0], corner[1], corner[2]) * counts);
	double error = 1e-3 * d3_length(right) + 1e-5 * d3_length(exitance);
	bool green = d3_distance(d3_row(out, 6), d3_scale(ways, right.y / 3)) <= 3 * error;
	return right_if(d3_distance(w, right) <= error && green);
}

/* Its integral over the sphere is the sum of the weights, its direction the mean one. */
static judgement lobe_fit(const u32 *in, const u32 *out)
{
	double m = ts_row_f32(in, 0), mu = ts_row_f32(out, 0), lambda = ts_row_f32(out, 1);
	double3 directions = d3_row(in, 1);
	if (m == 0) return right_if(mu == 0 && lambda == 1 && d3_length(d3_row(out, 2)) == 0);
	if (!is_near(mu * sg_sphere(lambda), m, 2e-6 * m)) return WRONG;
	double r = d3_length(directions) / m, toksvig = r * 1 / (1 - r);
	if (r < 1e-5) return NOT_JUDGED;
	if (d3_distance(d3_row(out, 2), d3_unit(directions)) > 1e-5) return WRONG;
	if (in[4] != 0 || r > 0.99) return RIGHT;
	return right_if(is_near(lambda, toksvig, 1e-4 * toksvig));
}

static judgement hull_lobe(const u32 *in, const u32 *out)
{
	double mu = 0, lambda = 0, lit = 0;
	double3 phi = {0, 0, 0};
	u32 channel = in[68];
	for (u32 k = 0; k < 4; k++) {
		double share = ts_row_f32(in, 64 + k);
		double lit_share = ts_row_f32(in, 16 * k + channel) > 0 ? share : 0;
		mu += share * ts_row_f32(in, 16 * k + channel);
		lambda += lit_share * ts_row_f32(in, 16 * k + 3 + channel);
		lit += lit_share;
		phi = d3_mad(phi, d3_row(in, 16 * k + 6 + 3 * channel), share);
	}
	lambda = lit > 0 ? lambda / lit : 1;
	bool near = is_near(ts_row_f32(out, 0), mu, 1e-6 * mu) && is_near(ts_row_f32(out, 1), lambda, 1e-6 * lambda);
	if (near && d3_length(phi) < 1e-2) return NOT_JUDGED;
	return right_if(near && d3_distance(d3_row(out, 2), d3_unit(phi)) <= 1e-4);
}

/* A pi-th of the integral with the cosine; printed forms only where they neither cancel nor overflow. */
static judgement lobe_irradiance(const u32 *in, const u32 *out)
{
	double mu = ts_row_f32(in, 0), lambda = ts_row_f32(in, 1), pi = acos(-1);
	double c = fmin(fmax(d3_dot(d3_row(in, 2), d3_row(in, 5)), -1), 1), e = ts_row_f32(out, 0);
	if (e < 0) return WRONG;
	if (in[9] != 0 && (lambda < 2 || lambda > 30)) return NOT_JUDGED;
	double right = in[8] == TS_COSINE_OURS       ? sg_closed(lambda, c)
	               : in[8] == TS_COSINE_SG       ? sg_as_sg(lambda, c)
	               : in[8] == TS_COSINE_CONSTANT ? fmax(0, c) * sg_sphere(lambda)
	                                             : sg_truth(lambda, c);
	return right_if(is_near(e, mu * right / pi, 1e-5 * mu * sg_up(lambda) / pi));
}

/* An eighth of the disc's area, or of the ball's surface, seen from outside; the middle is where it should be. */
static judgement lamp_triangle(const u32 *in, const u32 *out)
{
	double3 p = d3_row(in, 0), a = d3_row(out, 0), b = d3_row(out, 3), c = d3_row(out, 6), n = d3_row(out, 9);
	double r = ts_row_f32(in, 6), pi = acos(-1), whole = in[8] != 0 ? 4 * pi * r * r : pi * r * r;
	double3 normal = d3_cross(d3_sub(b, a), d3_sub(c, a));
	if (r < 0.05) return NOT_JUDGED;
	double error = PLACE_ERROR / r;
	bool area = is_near(d3_length(normal) / 2, whole / 8, error * whole);
	bool turned = d3_distance(d3_unit(normal), n) <= 10 * error && is_near(d3_length(n), 1, 1e-6);
	bool away = in[8] != 0 ? d3_dot(n, d3_sub(a, p)) > 0 : d3_distance(a, p) == 0 && d3_distance(n, d3_row(in, 3)) == 0;
	double3 axis = in[8] != 0 ? (double3){in[7] & 1 ? 1 : -1, in[7] & 2 ? 1 : -1, in[7] & 4 ? 1 : -1} : n;
	return right_if(area && turned && away && d3_distance(n, d3_unit(axis)) <= 1e-6 && out[12] == 0);
}

static void composites_match_double_precision(void **state)
{
	(void)state;
	static const composite composites[] = {TS_LIST_hulls_composites(COMPOSITE)};
	judge_all(composites, TS_N_hulls_composites);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(composites_match_double_precision)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Spherical Gaussians against quadrature of the integrals that define them, in double precision: the integrals, their
 * stable forms and the printed ones, the cosine by each method, and sharpness. */
#include "kernels/hulls/gaussian.h"
#include "tests/kernels/hulls/gaussian_truth.h"
#include "tests/kernels/seeded.h"

enum { N_LAMBDA = 61, N_BETA = 181 };

/* From 1e-5 to `most`, evenly by the logarithm. */
static f32 sharpness(u32 i, double most) { return (f32)(1e-5 * pow(most / 1e-5, (double)i / (N_LAMBDA - 1))); }
static f32 cosine(u32 k) { return ts_cos_turn((f32)k / (2 * (N_BETA - 1))); }

static double relative(double found, double right) { return fabs(found - right) / right; }

/* FIGURES 9: numbers worked out apart from this project. */
static void integrals_are_those_of_the_figures(void **state)
{
	(void)state;
	const double upper[][2] = {{1, 2.31145}, {10, 0.56549}, {100, 0.0622035}};
	const double lower[][2] = {{1, 0.610781}, {10, 2.85114e-6}};
	const double slanted[][3] = {{5, 1.0, 0.5785985338}, {0.5, 2.5, 1.4828886581}, {20, 1.4, 0.0599112485}};
	for (u32 i = 0; i < 3; i++) assert_true(relative(ts_k_sg_upper((f32)upper[i][0], 0), upper[i][1]) < 3e-6);
	for (u32 i = 0; i < 2; i++) assert_true(relative(ts_k_sg_lower((f32)lower[i][0], 0), lower[i][1]) < 3e-6);
	for (u32 i = 0; i < 3; i++) {
		double c = cos(slanted[i][1]);
		assert_near(sg_truth(slanted[i][0], c), slanted[i][2], 1e-10);
		f32 found = ts_k_sg_cosine((f32)slanted[i][0], (f32)c, TS_COSINE_QUADRATURE, 0);
		assert_true(relative(found, slanted[i][2]) < 3e-6);
	}
}

/* Eqs 2, 9 and 10. */
static void stable_forms_match_the_integrals(void **state)
{
	(void)state;
	double sphere = 0, upper = 0, lower = 0, lower_absolute = 0;
	for (u32 i = 0; i < 4000; i++) {
		f32 lambda = (f32)(1e-5 * pow(1e10, i / 3999.0));
		double up = sg_up(lambda), down = sg_down(lambda);
		sphere = fmax(sphere, relative(ts_k_sg_integral(lambda), sg_sphere(lambda)));
		upper = fmax(upper, relative(ts_k_sg_upper(lambda, 0), up));
		lower_absolute = fmax(lower_absolute, fabs(ts_k_sg_lower(lambda, 0) - down) / up);
		if (lambda < 69) lower = fmax(lower, relative(ts_k_sg_lower(lambda, 0), down));
	}
	assert_true(sphere > 0 && sphere < 3e-7);
	assert_true(upper > 0 && upper < 8e-7);
	assert_true(lower > 0 && lower < 8e-7);
	assert_true(lower_absolute < 4e-7);
	assert_near(ts_k_sg_integral(0), 4 * sg_pi, 4e-7);
	assert_near(ts_k_sg_upper(0, 0), sg_pi, 2e-7);
	assert_near(ts_k_sg_lower(0, 0), sg_pi, 2e-7);
}

/* What the printed forms lose: digits where they cancel, and with the C library's exponential, which overflows, all. */
static void printed_forms_lose_digits(void **state)
{
	(void)state;
	const f32 lambda = 1e-3f;
	double upper = relative(ts_k_sg_upper(lambda, 1), sg_up(lambda));
	double lower = relative(ts_k_sg_lower(lambda, 1), sg_down(lambda));
	assert_true(upper > 0.015 && upper < 0.06 && lower > 0.015 && lower < 0.06);
	assert_true(relative(ts_k_sg_upper(1e-4f, 1), sg_pi) > 1);
	volatile f32 sharp = 90;
	assert_true(isnan(expf(-2 * sharp) * (expf(sharp) - 1 - sharp)));
	assert_true(ts_k_sg_lower(sharp, 1) == 0 && ts_k_sg_lower(sharp, 0) >= 0);
	for (f32 moderate = 2; moderate < 30; moderate *= 1.5f) {
		assert_true(relative(ts_k_sg_upper(moderate, 1), sg_up(moderate)) < 1e-6);
		assert_true(relative(ts_k_sg_lower(moderate, 1), sg_down(moderate)) < 4e-6);
	}
}

/* At each angle; those of the last lambda are kept. */
static const double *truths_of(f32 lambda)
{
	static double truth[N_BETA];
	static f32 last = -1;
	for (u32 k = 0; k < N_BETA && lambda != last; k++) truth[k] = sg_truth(lambda, cosine(k));
	last = lambda;
	return truth;
}

/* The root of the mean of the squares of the errors over beta, and the greatest. */
typedef struct {
	double rmse, most;
} errors;

static errors errors_of(f32 lambda, u32 method)
{
	errors r = {0, 0};
	const double *truth = truths_of(lambda);
	for (u32 k = 0; k < N_BETA; k++) {
		double d = fabs(ts_k_sg_cosine(lambda, cosine(k), method, 0) - truth[k]);
		r.rmse += d * d / N_BETA;
		r.most = fmax(r.most, d);
	}
	r.rmse = sqrt(r.rmse);
	return r;
}

/* Eq 12: the nodes are enough, at every sharpness and angle. */
static void nodes_suffice_at_every_sharpness(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_LAMBDA; i++) {
		f32 lambda = sharpness(i, 1e5);
		assert_true(errors_of(lambda, TS_COSINE_QUADRATURE).most < 1.2e-6 * sg_up(lambda));
	}
	for (u32 i = 0; i < 5000; i++) {
		f32 lambda = sharpness(below(N_LAMBDA), 1e5), c = uniform(-1, 1);
		f32 found = ts_k_sg_cosine(lambda, c, TS_COSINE_QUADRATURE, 0);
		assert_near(found, sg_truth(lambda, c), 1.2e-6 * sg_up(lambda));
	}
	assert_near(ts_k_sg_cosine(0, 0.3f, TS_COSINE_QUADRATURE, 0), sg_pi, 4e-6);
}

/* Eqs 15 to 18: as near as FIGURES 9 says, and nearer than the rivals. */
static void our_cosine_is_nearer_than_its_rivals(void **state)
{
	(void)state;
	double most = 0, rmse = 0, relative_rmse = 0;
	for (u32 i = 0; i < N_LAMBDA; i++) {
		f32 lambda = sharpness(i, 700);
		double up = sg_up(lambda);
		errors e = errors_of(lambda, TS_COSINE_OURS);
		most = fmax(most, e.most / up);
		rmse = fmax(rmse, e.rmse);
		relative_rmse = fmax(relative_rmse, e.rmse / up);
		assert_true(e.rmse < errors_of(lambda, TS_COSINE_CONSTANT).rmse);
		assert_true(e.rmse < errors_of(lambda, TS_COSINE_SG).rmse);
	}
	assert_true(most > 0.008 && most < 0.009);
	assert_true(rmse > 4.7e-3 * 0.98 && rmse < 4.7e-3 * 1.02);
	assert_true(relative_rmse > 0.0034 && relative_rmse < 0.0036);
	for (f32 lambda = 700; lambda < 1e5f; lambda *= 3) {
		assert_true(errors_of(lambda, TS_COSINE_OURS).most < 2.5e-4 * sg_up(lambda));
	}
}

/* Rounding; where n is phi or -phi the closed form is that of eqs 9 and 10, and it never is more or less than they
 * are. */
static void the_closed_form_stays_within_its_ends(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_LAMBDA; i++) {
		f32 lambda = sharpness(i, 1e5), up = ts_k_sg_upper(lambda, 0), down = ts_k_sg_lower(lambda, 0);
		double right_up = sg_up(lambda), right_down = sg_down(lambda);
		assert_true(same_bits(ts_k_sg_cosine(lambda, 1, TS_COSINE_OURS, 0), up));
		assert_true(same_bits(ts_k_sg_cosine(lambda, -1, TS_COSINE_OURS, 0), down));
		assert_true(same_bits(ts_k_sg_cosine(lambda, 2, TS_COSINE_OURS, 0), up));
		for (u32 k = 0; k < N_BETA; k++) {
			f32 found = ts_k_sg_cosine(lambda, cosine(k), TS_COSINE_OURS, 0);
			double share = sg_share(lambda, cosine(k));
			assert_near(found, share * right_up + (1 - share) * right_down, 1.2e-6 * up);
			assert_true(found >= down * (1 - 1e-6f) && found <= up * (1 + 1e-6f));
		}
	}
	assert_near(ts_k_sg_cosine(0, 0.5f, TS_COSINE_OURS, 0), sg_pi, 1e-6);
	assert_near(ts_k_sg_s(0, 0.5f), 0.5 / 0.5033, 1e-6);
}

/* The rivals by their own definitions, and figures of FIGURES 9. */
static void rivals_match_their_definitions(void **state)
{
	(void)state;
	const double rows[][3] = {
		{1e-5, 4.935, 5.75e-2},   {0.0837, 4.441, 5.82e-2}, {0.509, 2.670, 0.105},
		{1.26, 1.228, 0.132},     {3.1, 0.317, 0.102},      {7.65, 5.99e-2, 5.10e-2},
		{18.9, 1.09e-2, 2.29e-2}, {115, 3.76e-4, 4.20e-3},  {700, 1.5e-5, 7.1e-4},
	};
	for (u32 i = 0; i < sizeof rows / sizeof rows[0]; i++) {
		f32 lambda = (f32)rows[i][0];
		assert_true(relative(errors_of(lambda, TS_COSINE_CONSTANT).rmse, rows[i][1]) < 0.04);
		assert_true(relative(errors_of(lambda, TS_COSINE_SG).rmse, rows[i][2]) < 0.02);
	}
	for (u32 i = 0; i < 20000; i++) {
		f32 lambda = sharpness(below(N_LAMBDA), 1e5), c = uniform(-1, 1);
		assert_true(relative(ts_k_sg_cosine(lambda, c, TS_COSINE_SG, 0), sg_as_sg(lambda, c)) < 4e-6);
		assert_true(relative(ts_k_sg_cosine(lambda, 0.5f, TS_COSINE_CONSTANT, 0), 0.5 * sg_sphere(lambda)) < 4e-7);
		assert_true(ts_k_sg_cosine(lambda, -ts_abs(c), TS_COSINE_CONSTANT, 0) == 0);
	}
}

static double value_of(const ts_sg *g, ts_v3 w) { return sg_value(g->mu, g->lambda, ts_dot(g->phi, w)); }

/* Eq 3: in every direction the product of the values. */
static void products_have_the_product_of_values(void **state)
{
	(void)state;
	for (u32 i = 0; i < 20000; i++) {
		ts_sg a = ts_sg_make(uniform(0.1f, 9), sharpness(20 + below(25), 1e5), direction());
		ts_sg b = ts_sg_make(uniform(0.1f, 9), sharpness(20 + below(25), 1e5), direction());
		ts_sg product = ts_k_sg_product(&a, &b);
		ts_v3 w = direction();
		double right = value_of(&a, w) * value_of(&b, w);
		assert_near(value_of(&product, w), right, 2e-5 * (a.mu * b.mu));
		assert_near(ts_length(product.phi), 1, 1e-6);
	}
	ts_v3 up = ts_v3_make(0, 0, 1);
	ts_sg a = ts_sg_make(2, 3, up), b = ts_sg_make(5, 3, ts_neg(up)), none = ts_sg_make(4, 0, up);
	ts_sg flat = ts_k_sg_product(&a, &b), same = ts_k_sg_product(&none, &none);
	assert_true(flat.lambda == 0 && same.lambda == 0 && same.mu == 16);
	assert_near(flat.mu, 10 * exp(-6), 1e-7);
}

/* Eq 4, and the inverse of coth k - 1 / k; FIGURES 8 has the table. */
static void sharpness_inverts_the_mean_length(void **state)
{
	(void)state;
	const double rows[][3] = {
		{0.01, 0.030, 0.010}, {0.1, 0.302, 0.111}, {0.25, 0.780, 0.333}, {0.5, 1.797, 1},
		{0.75, 3.989, 3},     {0.9, 10, 9},        {0.95, 20, 19},       {0.99, 100, 99},
	};
	for (u32 i = 0; i < sizeof rows / sizeof rows[0]; i++) {
		assert_near(ts_k_sg_sharpness((f32)rows[i][0], 1), rows[i][1], 6e-4 * fmax(1, rows[i][1]));
		assert_near(ts_k_sg_sharpness((f32)rows[i][0], 0), rows[i][2], 6e-4 * fmax(1, rows[i][2]));
	}
	for (u32 i = 1; i < 100000; i++) {
		f32 r = (f32)i * 0.99998e-5f;
		double k = ts_k_sg_sharpness(r, 1), mean = k < 0.01 ? k / 3 - k * k * k / 45 : 1 / tanh(k) - 1 / k;
		double slope = k < 0.01 ? 1.0 / 3 : 1 / (k * k) - 1 / (sinh(k) * sinh(k));
		assert_near((mean - r) / slope, 0, 3e-6 * k);
		assert_true(relative(ts_k_sg_sharpness(r, 0), (double)r / (1 - (double)r)) < 1e-6);
	}
	for (u32 vmf = 0; vmf < 2; vmf++) {
		f32 most = ts_k_sg_sharpness(1, vmf);
		assert_true(most > 9.98e4f && most <= 1e5f && ts_k_sg_sharpness(7, vmf) == most);
		assert_true(ts_k_sg_sharpness(0, vmf) == 0 && ts_k_sg_sharpness(-1, vmf) == 0);
	}
}

/* Products with the lobes of smooth surfaces: hardly wider than a direction, 2 pi cos / lambda. */
static void sharp_lobes_act_as_directions(void **state)
{
	(void)state;
	for (f32 lambda = 1e6f; lambda < 2e8f; lambda *= 10) {
		for (f32 c = 0.1f; c < 1; c += 0.1f) {
			double right = 2 * sg_pi * (double)c / (double)lambda;
			assert_near(ts_k_sg_cosine(lambda, c, TS_COSINE_OURS, 0), right, 1e-4 * right);
			assert_near(ts_k_sg_cosine(lambda, c, TS_COSINE_QUADRATURE, 0), right, 1e-4 * right);
			assert_near(ts_k_sg_cosine(lambda, c, TS_COSINE_CONSTANT, 0), right, 1e-4 * right);
		}
		assert_near(ts_k_sg_cosine(lambda, -0.1f, TS_COSINE_OURS, 0), 0, 1e-15);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(integrals_are_those_of_the_figures),
		seeded_test(stable_forms_match_the_integrals),
		seeded_test(printed_forms_lose_digits),
		seeded_test(nodes_suffice_at_every_sharpness),
		seeded_test(our_cosine_is_nearer_than_its_rivals),
		seeded_test(the_closed_form_stays_within_its_ends),
		seeded_test(rivals_match_their_definitions),
		seeded_test(products_have_the_product_of_values),
		seeded_test(sharpness_inverts_the_mean_length),
		seeded_test(sharp_lobes_act_as_directions),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

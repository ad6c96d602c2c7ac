/* `bench ssagh-7`: the error of each way to integrate a spherical Gaussian with the cosine, over all angles between
 * the two; SSAGH's figure 7. Quadrature and methods are the kernels', in single precision, whose rounding errors are
 * below 1e-6.
 * And eqs 9 and 10 in single precision: as printed they cancel where lambda is small, and e^lambda overflows where it
 * is large: with the C library's exponential A_b then is 0 times infinity, with the kernels', which is at most the
 * largest float, 0. */
#include <math.h>
#include "kernels/hulls/gaussian.h"
#include "methods/hulls/tools/tools.h"

static const f32 sharpness[] = {1e-4f, 1e-3f, 1e-2f, 0.1f, 1, 10, 60, 88, 90, 700};

static const ts_column printed_columns[] = {{"lambda", "lambda", true},
                                            {"upper_stable", "A_u: by_ours", true},
                                            {"upper_printed", "printed", true},
                                            {"upper_expf", "by expf", true},
                                            {"lower_stable", "A_b: by_ours", true},
                                            {"lower_printed", "printed", true},
                                            {"lower_expf", "by expf", true},
                                            {0}};

typedef struct {
	double upper, lower;
} integrals;

/* In double precision, by the forms that do not cancel; below 1/100 by the first terms of their series. */
static integrals right_integrals(double x)
{
	double pi2 = 6.283185307179586, e = exp(-x);
	if (x < 0.01) return (integrals){pi2 * (0.5 - x / 6 + x * x / 24), pi2 * e * (0.5 - x / 3 + x * x / 8)};
	return (integrals){pi2 * (expm1(-x) + x) / (x * x), pi2 * e * (-expm1(-x) - x * e) / (x * x)};
}

static integrals by_ours(f32 lambda, u32 printed)
{
	return (integrals){ts_k_sg_upper(lambda, printed), ts_k_sg_lower(lambda, printed)};
}

static integrals by_library(f32 lambda)
{
	f32 scale = 6.283185482025146484375f / (lambda * lambda);
	f32 upper = expf(-lambda) - 1.0f + lambda, rest = expf(lambda) - 1.0f - lambda;
	return (integrals){scale * upper, scale * expf(-2.0f * lambda) * rest};
}

static void printed_cell(ts_table *t, double error)
{
	char text[16];
	snprintf(text, sizeof text, isnan(error) ? "NaN" : "%.1e", error);
	ts_table_text(t, text);
}

static void put_printed(ts_report *report)
{
	ts_table t =
		ts_table_begin("printed", "Equations 9 and 10 in single precision: errors, as parts of A_u", printed_columns);
	for (u32 i = 0; i < sizeof sharpness / sizeof sharpness[0]; i++) {
		integrals r = right_integrals(sharpness[i]);
		integrals all[] = {by_ours(sharpness[i], 0), by_ours(sharpness[i], 1), by_library(sharpness[i])};
		ts_table_real(&t, sharpness[i], 4);
		for (u32 k = 0; k < 3; k++) printed_cell(&t, fabs(all[k].upper - r.upper) / r.upper);
		for (u32 k = 0; k < 3; k++) printed_cell(&t, fabs(all[k].lower - r.lower) / r.upper);
	}
	ts_report_table(report, &t);
}

enum { N_SHARP = 61, N_ANGLES = 181, N_METHODS = 3, DOT_STEP = 3 };

/* clang-format off */
static const char *const methods[N_METHODS] = {
	[TS_COSINE_OURS] = "SSAGH (eqs 15 to 18)",
	[TS_COSINE_CONSTANT] = "constant cosine (eq 7)",
	[TS_COSINE_SG] = "cosine as a Gaussian (eq 8)",
};
/* clang-format on */

/* For one sharpness: the root mean square error, over all angles equally and weighted by solid angle. */
typedef struct {
	f32 lambda;
	double alike[N_METHODS], solid[N_METHODS];
} errors;

/* Expected greatest errors, within 2 %: computed independently in double precision; and the paper's. */
typedef struct {
	u32 method;
	bool solid;
	double right, paper;
} claim;

/* clang-format off */
static const claim claims[] = {
	{ TS_COSINE_CONSTANT, true, 4.056, 4 },
	{ TS_COSINE_SG, false, 0.1319, NAN },
	{ TS_COSINE_OURS, false, 4.722e-3, NAN },
};

static const ts_column columns[] = { { "lambda", "lambda", true }, { "ssagh", "SSAGH", true },
	{ "constant", "constant", true }, { "gaussian", "Gaussian", true },
	{ "ssagh_solid", "by solid angle: SSAGH", true },
	{ "constant_solid", "constant", true }, { "gaussian_solid", "Gaussian", true }, { 0 } };

/* clang-format on */

static errors compare(f32 lambda)
{
	errors r = {.lambda = lambda};
	double sines = 0;
	for (u32 k = 0; k < N_ANGLES; k++) {
		f32 turn = (f32)k / (2 * (N_ANGLES - 1)), c = ts_cos_turn(turn);
		double right = ts_k_sg_cosine(lambda, c, TS_COSINE_QUADRATURE, 0), sine = ts_sin_turn(turn);
		for (u32 m = 0; m < N_METHODS; m++) {
			double d = ts_k_sg_cosine(lambda, c, m, 0) - right;
			r.alike[m] += d * d;
			r.solid[m] += sine * d * d;
		}
		sines += sine;
	}
	for (u32 m = 0; m < N_METHODS; m++) {
		r.alike[m] = sqrt(r.alike[m] / N_ANGLES);
		r.solid[m] = sqrt(r.solid[m] / sines);
	}
	return r;
}

static void add_row(ts_table *t, const errors *row)
{
	ts_table_real(t, row->lambda, 6);
	for (u32 m = 0; m < N_METHODS; m++) ts_table_real(t, row->alike[m], 8);
	for (u32 m = 0; m < N_METHODS; m++) ts_table_real(t, row->solid[m], 8);
	ts_table_say(t);
}

static void claim_row(ts_table *t, const claim *c, const errors *rows)
{
	char text[96], bound[48], because[48];
	u32 at = 0;
	double most = 0;
	for (u32 i = 0; i < N_SHARP; i++) {
		double error = c->solid ? rows[i].solid[c->method] : rows[i].alike[c->method];
		at = error > most ? i : at;
		most = error > most ? error : most;
	}
	snprintf(text, sizeof text, "greatest RMSE of %s%s", methods[c->method], c->solid ? ", by solid angle" : "");
	snprintf(bound, sizeof bound, "%g within 2 %%", c->right);
	snprintf(because, sizeof because, TS_OURS "at lambda %g", rows[at].lambda);
	ts_bench_relation_add(t, &(ts_bench_relation){.text = text,
	                                              .bound = bound,
	                                              .here = most,
	                                              .paper = c->paper,
	                                              .decimals = 5,
	                                              .holds = fabs(most / c->right - 1) <= 0.02,
	                                              .because = because});
}

static void report_claims(ts_report *report, const errors *rows)
{
	ts_table t = ts_bench_relations_begin();
	u32 n_least = 0;
	for (u32 k = 0; k < sizeof claims / sizeof claims[0]; k++) claim_row(&t, &claims[k], rows);
	for (u32 i = 0; i < N_SHARP; i++) {
		const double *e = rows[i].alike, *s = rows[i].solid;
		n_least += e[0] < e[1] && e[0] < e[2] && s[0] < s[1] && s[0] < s[2];
	}
	ts_bench_relation_add(&t, &(ts_bench_relation){.text = "sharpnesses at which SSAGH has the least error",
	                                               .bound = "61",
	                                               .here = n_least,
	                                               .paper = NAN,
	                                               .holds = n_least == N_SHARP,
	                                               .because = TS_OURS "another is nearer"});
	ts_report_table(report, &t);
}

static ts_status plot(const errors *rows)
{
	ts_plot_point points[2 * N_METHODS * N_SHARP];
	ts_plot p = {.title = "SSAGH, figure 7. Lines: all angles alike; dots: by solid angle",
	             .x_axis = "lambda",
	             .y_axis = "RMSE over the angle",
	             .curves = {methods[0], methods[1], methods[2]},
	             .n_curves = N_METHODS,
	             .points = points};
	for (u32 m = 0; m < N_METHODS; m++) {
		for (u32 i = 0; i < N_SHARP; i++) {
			double lambda = rows[i].lambda;
			points[p.n_points++] = (ts_plot_point){m, NULL, lambda, rows[i].alike[m], false};
			if (i % DOT_STEP == 0) points[p.n_points++] = (ts_plot_point){m, "", lambda, rows[i].solid[m], true};
		}
	}
	return ts_bench_plot("ssagh_7.svg", &p);
}

static ts_status work_on(const ts_job *job, ts_report *report, const void *user)
{
	(void)user;
	errors rows[N_SHARP];
	ts_table t = ts_table_begin("ssagh_7", "SSAGH, figure 7: RMSE to quadrature, amplitude 1", columns);
	for (u32 i = 0; i < N_SHARP; i++) {
		rows[i] = compare((f32)(1e-5 * pow(700 / 1e-5, (double)i / (N_SHARP - 1))));
		add_row(&t, &rows[i]);
	}
	ts_report_run(report, job);
	ts_report_table(report, &t);
	report_claims(report, rows);
	put_printed(report);
	return job->output.dir != NULL ? plot(rows) : TS_OK;
}

ts_status ts_bench_cosines(const ts_job *job) { return ts_bench_with_report(job, work_on, NULL); }

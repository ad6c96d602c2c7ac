/* `bench ssagh-6`: the steepness t of the logistic curve that fits s best (eq 17), for each sharpness, beside that of
 * eq 18; SSAGH's figure 6, and the errors of the fits. In double precision. The Gaussian of sharpness 0 is subtracted
 * before integration, so that nothing cancels where sharpness is small. */
#include <math.h>
#include "kernels/hulls/gaussian.h"
#include "methods/hulls/tools/tools.h"

enum { N_SHARP = 41, N_ANGLES = 181, N_NODES = 161 };

static const double pi = 3.14159265358979323846;

/* Nodes in (-1, 1) and their weights, by x = tanh(pi / 2 sinh k h): exact except for rounding, whatever happens at the
 * ends. */
typedef struct {
	double at[N_NODES], weight[N_NODES];
} nodes;

/* For one sharpness. */
typedef struct {
	double lambda, t, per_u; /* of the best curve: 1 / u */
	double fit, closed;      /* RMSE of the best curve, and of eqs 17 and 18 */
} fitted;

static nodes nodes_of(void)
{
	nodes n;
	const double step = 6.4 / (N_NODES - 1);
	for (int k = 0; k < N_NODES; k++) {
		double x = step * (k - N_NODES / 2), y = pi / 2 * sinh(x);
		n.at[k] = tanh(y);
		n.weight[k] = step * pi / 2 * cosh(x) / (cosh(y) * cosh(y));
	}
	return n;
}

/* The integral of the clamped cosine to the normal over the circle of directions at theta to the lobe, which is beta
 * away from the normal. */
static double cosines(double theta, double beta)
{
	double p = cos(theta) * cos(beta), q = sin(theta) * sin(beta);
	double edge = q > 0 ? acos(fmax(-1, fmin(1, -p / q))) : p > 0 ? pi : 0;
	return 2 * (p * edge + q * sin(edge));
}

/* Integrates over theta. All integrals leave out the factor exp(-lambda), which they share. */
static double above(const nodes *n, double lambda, double beta, double from, double to)
{
	double sum = 0, half = (to - from) / 2;
	for (int k = 0; k < N_NODES; k++) {
		double theta = from + half * (1 + n->at[k]);
		sum += n->weight[k] * expm1(lambda * cos(theta)) * sin(theta) * cosines(theta, beta);
	}
	return half * sum;
}

/* In pieces, which end where circles about the lobe leave the hemisphere. */
static double whole(const nodes *n, double lambda, double beta)
{
	double bend = fabs(pi / 2 - beta);
	return above(n, lambda, beta, 0, bend) + above(n, lambda, beta, bend, pi - bend) +
	       above(n, lambda, beta, pi - bend, pi);
}

/* s by quadrature: eq 16, solved for s. */
static double s_of(const nodes *n, double lambda, double beta, double lower, double upper)
{
	double c = (whole(n, lambda, beta) - lower) / (upper - lower), clamped = fmax(0, cos(beta));
	return (c - clamped) / (0.5 * cos(beta) + 0.5 - clamped);
}

/* RMSE of a steepness with its best u. */
static double error_of(const double *s, const double *cosine, double t, double *per_u)
{
	double sf = 0, ff = 0, sum = 0;
	for (u32 i = 0; i < N_ANGLES; i++) {
		double f = 1 / (exp(cosine[i] * t) + 1);
		sf += s[i] * f;
		ff += f * f;
	}
	*per_u = ff / sf;
	for (u32 i = 0; i < N_ANGLES; i++) {
		double e = s[i] - 1 / (exp(cosine[i] * t) + 1) / *per_u;
		sum += e * e;
	}
	return sqrt(sum / N_ANGLES);
}

/* By golden section. */
static double best_t(const double *s, const double *cosine, double most)
{
	const double golden = 0.6180339887498949;
	double from = 0, to = most, per_u;
	for (u32 i = 0; i < 90; i++) {
		double a = to - golden * (to - from), b = from + golden * (to - from);
		bool left = error_of(s, cosine, a, &per_u) < error_of(s, cosine, b, &per_u);
		from = left ? from : a;
		to = left ? b : to;
	}
	return (from + to) / 2;
}

static fitted fit(const nodes *n, double lambda)
{
	double s[N_ANGLES], cosine[N_ANGLES], sum = 0, t = (double)ts_k_sg_t((f32)lambda);
	double upper = whole(n, lambda, 0), lower = whole(n, lambda, pi);
	for (u32 i = 0; i < N_ANGLES; i++) {
		double beta = pi * (i + 0.5) / N_ANGLES;
		cosine[i] = fabs(cos(beta));
		s[i] = s_of(n, lambda, beta, lower, upper);
		double e = s[i] - 1 / (exp(cosine[i] * t) + 1) / (0.2958 * t + 0.5033);
		sum += e * e;
	}
	fitted r = {.lambda = lambda, .t = best_t(s, cosine, 2 * t + 1), .closed = sqrt(sum / N_ANGLES)};
	r.fit = error_of(s, cosine, r.t, &r.per_u);
	return r;
}

/* clang-format off */
static const ts_column columns[] = { { "lambda", "lambda", true }, { "t", "t, fitted", true },
	{ "t_18", "eq 18", true }, { "per_u", "1 / u, fitted", true }, { "per_u_17", "0.2958 t + 0.5033", true },
	{ "fit_rmse", "RMSE of the fit", true }, { "closed_rmse", "of eqs 17 and 18", true }, { 0 } };
/* clang-format on */

static void add_row(ts_table *t, const fitted *row)
{
	ts_table_real(t, row->lambda, 6);
	ts_table_real(t, row->t, 6);
	ts_table_real(t, (double)ts_k_sg_t((f32)row->lambda), 6);
	ts_table_real(t, row->per_u, 6);
	ts_table_real(t, 0.2958 * row->t + 0.5033, 6);
	ts_table_real(t, row->fit, 12);
	ts_table_real(t, row->closed, 12);
	ts_table_say(t);
}

static void report_claims(ts_report *report, const fitted *rows)
{
	double least = rows[0].fit, most = rows[0].fit;
	for (u32 i = 1; i < N_SHARP; i++) {
		least = fmin(least, rows[i].fit);
		most = fmax(most, rows[i].fit);
	}
	ts_table t = ts_bench_relations_begin();
	ts_bench_relation_add(&t, &(ts_bench_relation){.text = "greatest RMSE of the fits",
	                                               .bound = "at most 0.0038, within 5 %",
	                                               .here = most,
	                                               .paper = 3.8e-3,
	                                               .decimals = 5,
	                                               .holds = most <= 3.8e-3 * 1.05,
	                                               .because = TS_OURS "angles are weighted otherwise"});
	ts_bench_relation_add(&t, &(ts_bench_relation){.text = "least",
	                                               .bound = "at most 4.38e-11",
	                                               .here = least,
	                                               .paper = 4.38e-11,
	                                               .decimals = 14,
	                                               .holds = least <= 4.38e-11,
	                                               .because = TS_OURS "the integrals are not exact"});
	ts_report_table(report, &t);
}

static ts_status plot(const fitted *rows)
{
	ts_plot_point points[2 * N_SHARP];
	ts_plot p = {.title = "SSAGH, figure 6. Dots: fitted; line: eq 18",
	             .x_axis = "lambda",
	             .y_axis = "t",
	             .curves = {"t"},
	             .n_curves = 1,
	             .points = points};
	for (u32 i = 0; i < N_SHARP; i++) {
		double lambda = rows[i].lambda, t = (double)ts_k_sg_t((f32)lambda);
		points[p.n_points++] = (ts_plot_point){0, NULL, lambda, t, false};
		points[p.n_points++] = (ts_plot_point){0, "", lambda, rows[i].t, true};
	}
	return ts_bench_plot("ssagh_6.svg", &p);
}

static ts_status work_on(const ts_job *job, ts_report *report, const void *user)
{
	(void)user;
	fitted rows[N_SHARP];
	nodes n = nodes_of();
	ts_table t = ts_table_begin("ssagh_6", "SSAGH, figure 6: logistic curves nearest to s", columns);
	for (u32 i = 0; i < N_SHARP; i++) {
		rows[i] = fit(&n, 1e-5 * pow(700 / 1e-5, (double)i / (N_SHARP - 1)));
		add_row(&t, &rows[i]);
	}
	ts_report_run(report, job);
	ts_report_table(report, &t);
	report_claims(report, rows);
	return job->output.dir != NULL ? plot(rows) : TS_OK;
}

ts_status ts_bench_logistic(const ts_job *job) { return ts_bench_with_report(job, work_on, NULL); }

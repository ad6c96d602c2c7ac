/* For `bench ssagh-7`: eqs 9 and 10 in single precision. As printed they cancel where lambda is small, and e^lambda
 * overflows where it is large: with the C library's exponential A_b then is 0 times infinity, with the kernels', which
 * is at most the largest float, 0. */
#include <math.h>
#include "kernels/hulls/gaussian.h"
#include "methods/hulls/tools/tools.h"

static const f32 sharpness[] = {1e-4f, 1e-3f, 1e-2f, 0.1f, 1, 10, 60, 88, 90, 700};

static const ts_column columns[] = {{"lambda", "lambda", true},          {"upper_stable", "A_u: ours", true},
                                    {"upper_printed", "printed", true},  {"upper_expf", "by expf", true},
                                    {"lower_stable", "A_b: ours", true}, {"lower_printed", "printed", true},
                                    {"lower_expf", "by expf", true},     {0}};

typedef struct {
	double upper, lower;
} integrals;

/* In double precision, by the forms that do not cancel; below 1/100 by the first terms of their series. */
static integrals right(double x)
{
	double pi2 = 6.283185307179586, e = exp(-x);
	if (x < 0.01) return (integrals){pi2 * (0.5 - x / 6 + x * x / 24), pi2 * e * (0.5 - x / 3 + x * x / 8)};
	return (integrals){pi2 * (expm1(-x) + x) / (x * x), pi2 * e * (-expm1(-x) - x * e) / (x * x)};
}

static integrals ours(f32 lambda, u32 printed)
{
	return (integrals){ts_k_sg_upper(lambda, printed), ts_k_sg_lower(lambda, printed)};
}

static integrals by_library(f32 lambda)
{
	f32 scale = 6.283185482025146484375f / (lambda * lambda);
	f32 upper = expf(-lambda) - 1.0f + lambda, rest = expf(lambda) - 1.0f - lambda;
	return (integrals){scale * upper, scale * expf(-2.0f * lambda) * rest};
}

static void cell(ts_table *t, double error)
{
	char text[16];
	snprintf(text, sizeof text, isnan(error) ? "NaN" : "%.1e", error);
	ts_table_text(t, text);
}

void ts_bench_printed(ts_report *report)
{
	ts_table t = ts_table_begin("printed", "Equations 9 and 10 in single precision: errors, as parts of A_u", columns);
	for (u32 i = 0; i < sizeof sharpness / sizeof sharpness[0]; i++) {
		integrals r = right(sharpness[i]);
		integrals all[] = {ours(sharpness[i], 0), ours(sharpness[i], 1), by_library(sharpness[i])};
		ts_table_real(&t, sharpness[i], 4);
		for (u32 k = 0; k < 3; k++) cell(&t, fabs(all[k].upper - r.upper) / r.upper);
		for (u32 k = 0; k < 3; k++) cell(&t, fabs(all[k].lower - r.lower) / r.upper);
	}
	ts_report_table(report, &t);
}

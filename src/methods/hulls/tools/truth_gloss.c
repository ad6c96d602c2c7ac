/* The microfacet BRDF in double precision: for one direction, integrated over a triangle, and sampled. */
#include "methods/hulls/tools/truth_gloss.h"
#include <math.h>

enum { DEEPEST = 10 }; /* a triangle ends as 4^10 parts */
#define PART 0.15      /* radius of a part, in units of the angle over which the BRDF changes */
#define WIDEST 0.1     /* radius of a part in radians, for any roughness */

ts_status ts_truth_gloss(ts_run *run, const ts_gloss **gloss, ts_v3 *eye)
{
	if (ts_truth_make(run, TS_B_gloss_pixel) != TS_OK) return TS_ERROR;
	*gloss = ts_frame_data(&run->frame, TS_B_gloss_pixel);
	*eye = ts_load3(((const ts_view *)ts_frame_data(&run->frame, TS_B_eye_view))->eye);
	return TS_OK;
}

ts_truth_glossy ts_truth_glossy_of(const ts_gloss *gloss, ts_v3 p, ts_v3 n, ts_v3 eye)
{
	return (ts_truth_glossy){.n = ts_double3_of(n),
	                         .v = ts_double3_unit(ts_double3_from_to(p, eye)),
	                         .f0 = ts_double3_of(ts_load3(gloss->f0)),
	                         .alpha = sqrt((double)gloss->alpha_squared)};
}

static double smith(double a2, double n_l, double n_v)
{
	double left = n_l * sqrt(n_v * n_v * (1 - a2) + a2), right = n_v * sqrt(n_l * n_l * (1 - a2) + a2);
	return 0.5 / (left + right);
}

static ts_double3 fresnel(ts_double3 f0, double v_h)
{
	double x = pow(1 - v_h, 5);
	return (ts_double3){f0.x + (1 - f0.x) * x, f0.y + (1 - f0.y) * x, f0.z + (1 - f0.z) * x};
}

static double across(double cosine) { return fmax(fabs(cosine), 0x1p-10); }

ts_double3 ts_truth_gloss_brdf(const ts_truth_glossy *at, ts_double3 l)
{
	double n_l = ts_double3_dot(at->n, l), a2 = at->alpha * at->alpha;
	if (!(n_l > 0)) return (ts_double3){0, 0, 0};
	ts_double3 h = ts_double3_unit(ts_double3_mad(l, at->v, 1));
	double n_h = fmin(fmax(ts_double3_dot(at->n, h), 0), 1), v_h = fmin(fmax(ts_double3_dot(at->v, h), 0), 1);
	double t = n_h * n_h * (a2 - 1) + 1, d = a2 / (TS_PI * t * t);
	double scale = d * smith(a2, n_l, across(ts_double3_dot(at->n, at->v))) * n_l;
	return ts_double3_mad((ts_double3){0, 0, 0}, fresnel(at->f0, v_h), scale);
}

/* Van Oosterom and Strackee 1983, for unit vectors. */
static double solid_angle(const ts_double3 c[3])
{
	double volume = fabs(ts_double3_dot(c[0], ts_double3_cross(c[1], c[2])));
	double sum = 1 + ts_double3_dot(c[0], c[1]) + ts_double3_dot(c[1], c[2]) + ts_double3_dot(c[2], c[0]);
	return 2 * atan2(volume, sum);
}

static double radius(const ts_double3 c[3], ts_double3 middle)
{
	double least = 1;
	for (unsigned k = 0; k < 3; k++) least = fmin(least, ts_double3_dot(c[k], middle));
	return acos(fmax(least, -1));
}

/* The angle between half vector and peak of the BRDF, plus the peak's width. */
static double change(const ts_truth_glossy *at, ts_double3 l)
{
	ts_double3 h = ts_double3_unit(ts_double3_mad(l, at->v, 1));
	return at->alpha + acos(fmin(fmax(ts_double3_dot(at->n, h), -1), 1));
}

/* Corners: unit vectors, a triangle on the sphere. */
static ts_double3 integral(const ts_truth_glossy *at, const ts_double3 c[3], unsigned depth)
{
	ts_double3 sum = {0, 0, 0};
	ts_double3 middle = ts_double3_unit(ts_double3_mad(ts_double3_mad(c[0], c[1], 1), c[2], 1));
	double wide = radius(c, middle), above = -1;
	for (unsigned k = 0; k < 3; k++) above = fmax(above, ts_double3_dot(at->n, c[k]));
	if (above <= 0 && wide < WIDEST) return sum;
	if (depth == DEEPEST || wide < fmin(PART * change(at, middle), WIDEST)) {
		return ts_double3_mad(sum, ts_truth_gloss_brdf(at, middle), solid_angle(c));
	}
	ts_double3 ab = ts_double3_unit(ts_double3_mad(c[0], c[1], 1));
	ts_double3 bc = ts_double3_unit(ts_double3_mad(c[1], c[2], 1));
	ts_double3 ca = ts_double3_unit(ts_double3_mad(c[2], c[0], 1));
	const ts_double3 parts[4][3] = {{c[0], ab, ca}, {ab, c[1], bc}, {ca, bc, c[2]}, {ab, bc, ca}};
	for (unsigned k = 0; k < 4; k++) sum = ts_double3_mad(sum, integral(at, parts[k], depth + 1), 1);
	return sum;
}

ts_double3 ts_truth_gloss_triangle(const ts_truth_glossy *at, const ts_double3 corner[3])
{
	const ts_double3 unit[3] = {ts_double3_unit(corner[0]), ts_double3_unit(corner[1]), ts_double3_unit(corner[2])};
	return integral(at, unit, 0);
}

ts_double3 ts_truth_gloss_sample(const ts_truth_glossy *at, double s, double t, ts_double3 *l)
{
	double a2 = at->alpha * at->alpha, cosine = sqrt((1 - s) / (1 + (a2 - 1) * s)), sine = sqrt(1 - cosine * cosine);
	ts_double3 pole = fabs(at->n.y) < 0.75 ? (ts_double3){0, 1, 0} : (ts_double3){1, 0, 0};
	ts_double3 u = ts_double3_unit(ts_double3_cross(pole, at->n)), v = ts_double3_cross(at->n, u);
	ts_double3 h = ts_double3_mad((ts_double3){0, 0, 0}, at->n, cosine);
	h = ts_double3_mad(ts_double3_mad(h, u, sine * cos(2 * TS_PI * t)), v, sine * sin(2 * TS_PI * t));
	double v_h = ts_double3_dot(at->v, h);
	*l = ts_double3_mad((ts_double3){-at->v.x, -at->v.y, -at->v.z}, h, 2 * v_h);
	double n_l = ts_double3_dot(at->n, *l);
	if (!(n_l > 0 && v_h > 0)) return (ts_double3){0, 0, 0};
	double scale = smith(a2, n_l, across(ts_double3_dot(at->n, at->v))) * n_l * 4 * v_h / cosine;
	return ts_double3_mad((ts_double3){0, 0, 0}, fresnel(at->f0, v_h), scale);
}

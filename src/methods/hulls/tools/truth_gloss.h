/* Specular reflection in double precision: the BRDF of glTF 2.0 (appendix B) itself, not its lobe (METHODS 17). */
#ifndef TS_METHODS_HULLS_TOOLS_TRUTH_GLOSS_H
#define TS_METHODS_HULLS_TOOLS_TRUTH_GLOSS_H
#include "methods/hulls/tools/double.h"
#include "truth/truth.h"

/* Makes gloss.pixel in a run that has its eye. *gloss: that of the pixels; *eye: its position. */
ts_status ts_truth_gloss(ts_run *run, const ts_gloss **gloss, ts_v3 *eye);

/* A surface that reflects to v; n and v are unit. */
typedef struct {
	ts_double3 n, v, f0;
	double alpha;
} ts_truth_glossy;

ts_truth_glossy ts_truth_glossy_of(const ts_gloss *gloss, ts_v3 p, ts_v3 n, ts_v3 eye);
/* BRDF times n.l, of red, green and blue; 0 below the horizon of n. l: unit. */
ts_double3 ts_truth_gloss_brdf(const ts_truth_glossy *at, ts_double3 l);
/* The integral of the BRDF times n.l over the directions of a triangle, whose corners are relative to the surface: by
 * parts that are small against the change of the BRDF, each with the value at its middle. */
ts_double3 ts_truth_gloss_triangle(const ts_truth_glossy *at, const ts_double3 corner[3]);
/* Samples a direction of light l for the place (s, t) of the unit square, with the density of the BRDF without Fresnel
 * and Smith (Walter, Marschner, Li and Torrance 2007). Returns BRDF times n.l over that density; 0 below the
 * horizon. */
ts_double3 ts_truth_gloss_sample(const ts_truth_glossy *at, double s, double t, ts_double3 *l);

#endif

/* Specular reflection in double precision: the BRDF of glTF 2.0 (appendix B) itself, not its lobe (METHODS 17). */
#ifndef TS_HULLS_TOOLS_TRUTH_GLOSS_H
#define TS_HULLS_TOOLS_TRUTH_GLOSS_H
#include "../../../truth/query.h"
#include "double.h"

/* Makes gloss.pixel in a run that has its eye; the pixels' gloss, and where the eye is. */
ts_status ts_truth_gloss(ts_run *run, const ts_gloss **gloss, ts_v3 *eye);

/* A surface that reflects to v; n and v are unit. */
typedef struct {
	ts_double3 n, v, f0;
	double alpha;
} ts_truth_glossy;

ts_truth_glossy ts_truth_glossy_of(const ts_gloss *gloss, ts_v3 p, ts_v3 n, ts_v3 eye);
/* BRDF times n.l, of red, green and blue; 0 below the horizon of n. l: unit. */
ts_double3 ts_truth_gloss_brdf(const ts_truth_glossy *at, ts_double3 l);
/* Its integral over the directions of a triangle, by its corners seen from the surface: by parts that are small beside
 * the change of the BRDF, each with that of its middle. */
ts_double3 ts_truth_gloss_triangle(const ts_truth_glossy *at, const ts_double3 corner[3]);
/* A direction of light l by the k-th place (s, t) of the unit square, as dense as the BRDF without Fresnel and Smith
 * would have it (Walter, Marschner, Li and Torrance 2007), and BRDF times n.l over that density; 0: below the
 * horizon. */
ts_double3 ts_truth_gloss_sample(const ts_truth_glossy *at, double s, double t, ts_double3 *l);

#endif

/* Rays into surfels themselves: Embree finds the candidates, double precision tells where a ray meets an ellipse. None
 * of the kernels that draw surfels has a part in it. */
#ifndef TS_TRUTH_DISCS_H
#define TS_TRUTH_DISCS_H
#include "../../../truth/truth.h"

typedef struct ts_discs ts_discs;

/* World space. */
typedef struct {
	double origin[3], direction[3]; /* the direction is unit, so that distances are in world units */
	double near;                    /* no hit before this */
} ts_disc_ray;

/* Where a ray meets the front of a surfel: in the ellipse c + a u + b v, a a + b b <= 1. */
typedef struct {
	u32 surfel;
	double t;  /* along the ray */
	double r2; /* a a + b b */
} ts_disc_met;

/* Builds a tree over surfels, which must stay. *discs by ts_discs_free; NULL on failure: no memory, or Embree's
 * error. */
ts_status ts_discs_new(ts_discs **discs, const ts_surfel *surfels, u32 n, u32 threads);
/* Releases it; NULL is allowed. */
void ts_discs_free(ts_discs *discs);

/* The nearest, of several the first; its t is infinite if there is none. This and the next from any number of
 * threads. */
ts_disc_met ts_discs_nearest(const ts_discs *discs, const ts_disc_ray *ray);
/* Hands every one that is no farther than `far` to `take`, each once, in any order. */
void ts_discs_each(const ts_discs *discs, const ts_disc_ray *ray, double far,
                   void (*take)(void *user, const ts_disc_met *met), void *user);

#endif

/* Rays into the surfels themselves: Embree finds the candidates, and double precision computes where a ray meets an
 * ellipse. No kernel that draws surfels is used. */
#ifndef TS_METHODS_SURFELS_TOOLS_DISCS_H
#define TS_METHODS_SURFELS_TOOLS_DISCS_H
#include "truth/truth.h"

typedef struct ts_discs ts_discs;

/* A ray in world space. */
typedef struct {
	double origin[3], direction[3]; /* the direction is unit, so that distances are in world units */
	double near;                    /* no hit before this */
} ts_disc_ray;

/* The place where a ray meets the front of a surfel, in the ellipse c + a u + b v, a a + b b <= 1. */
typedef struct {
	u32 surfel;
	double t;  /* along the ray */
	double r2; /* a a + b b */
} ts_disc_met;

/* Builds a tree over surfels, which must stay. Release *discs by ts_discs_free; NULL on failure: no memory, or Embree's
 * error. */
ts_status ts_discs_new(ts_discs **discs, const ts_surfel *surfels, u32 n, u32 threads);
/* Releases it; NULL is allowed. */
void ts_discs_free(ts_discs *discs);

/* The nearest surfel that the ray meets, of several the first; t is infinite if there is none. Any number of threads
 * may call this function and the next. */
ts_disc_met ts_discs_nearest(const ts_discs *discs, const ts_disc_ray *ray);
/* Hands every surfel that the ray meets up to the distance `far` to `take`, each once, in any order. */
void ts_discs_each(const ts_discs *discs, const ts_disc_ray *ray, double far,
                   void (*take)(void *user, const ts_disc_met *met), void *user);

#endif

/* The composites that all methods share: functions made of primitives. */
#ifndef TS_KERNELS_VECTORS_COMPOSITES_H
#define TS_KERNELS_VECTORS_COMPOSITES_H
#include "kernels/vectors/composites_geometry.h"
#include "kernels/vectors/composites_lattice.h"
#include "kernels/vectors/composites_shade.h"

/* A composite stands after those that it calls. The composites of families follow: kernels/<family>/composites.h. */
#define TS_LIST_composites(VECTOR) \
	VECTOR(longest_edge) \
	VECTOR(closest_on_triangle) \
	VECTOR(closest_on_border) \
	VECTOR(circumcentre) \
	VECTOR(hit) \
	VECTOR(footprint) \
	VECTOR(pose) \
	VECTOR(clip) \
	VECTOR(light) \
	VECTOR(brdf) \
	VECTOR(shade) \
	VECTOR(surface) \
	VECTOR(shadow_bias) \
	VECTOR(align) \
	VECTOR(lattice_weights) \
	VECTOR(sample_centre)
/* map over rows */
TS_VECTORS(composites)

#endif

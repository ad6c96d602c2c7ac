/* Surfels sampled from the triangles of a scene: surfels.from_mesh. */
#ifndef TS_SCENE_SAMPLE_H
#define TS_SCENE_SAMPLE_H
#include "scene/build.h"

/* Adds surfels to a build whose triangles have been checked: about params->surfels_from_mesh of them, none if that is
 * 0. Each triangle is aligned in its own plane and sampled there as pieces are (EPR 3.2, 3.3; METHODS 2), by a lattice
 * whose spacing, the same for all triangles, gives that number over the whole area. A surfel is a circle in the
 * triangle's plane of params->surfels_radius spacings, coloured as the surface there: base colour times 1 - metallic,
 * textures filtered to the spacing. A double-sided triangle gets each surfel twice, the second turned over, unless
 * params->surfels_sides leaves the second out. Every triangle with an area gets at least one surfel, so fine meshes get
 * more than were asked for; every point of the triangle is within 1.6 spacings of a centre. The order is that of
 * triangles, then of the lattice, and does not depend on threads. */
void ts_sample_add(ts_build *build, const ts_params *params);

#endif

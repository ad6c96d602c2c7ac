/* Surfaces of one material in vector lanes, with the bits of ts_k_surface: vector loops evaluate textures, normal maps
 * and corners of many samples at once. */
#ifndef TS_BACKENDS_C_RASTER_SURFACE_BATCH_H
#define TS_BACKENDS_C_RASTER_SURFACE_BATCH_H
#include "backends/c/raster/lanes.h"
#include "kernels/base/surface.h"

/* The samples. */
typedef struct {
	u32 material, n;
	u32 triangle[TS_ABREAST];
	ts_lanes3 w;      /* weights of the triangle's corners */
	ts_lanes3 normal; /* (b - a) x (c - a) */
	ts_lanes3 p, viewer;
	f32 footprint[TS_ABREAST];
	const u32 *lit[TS_ABREAST]; /* samples of each lamp that reach the surface, or NULL */
	u64 place[TS_ABREAST];      /* the caller's */
} ts_surface_batch;

/* Their surfaces, with the members of ts_surface. */
typedef struct {
	ts_lanes3 face, n, base, emissive;
	f32 metallic[TS_ABREAST], roughness[TS_ABREAST], occlusion[TS_ABREAST];
} ts_surfaces;

/* Surface i, without the members that only lighting reads. */
static inline ts_surface ts_surface_lane(const ts_surface_batch *of, const ts_surfaces *found, u32 i)
{
	return (ts_surface){.p = ts_lane3(&of->p, i),
	                    .n = ts_lane3(&found->n, i),
	                    .face = ts_lane3(&found->face, i),
	                    .base = ts_lane3(&found->base, i),
	                    .metallic = found->metallic[i]};
}

void ts_surfaces_find(ts_surfaces *to, const ts_arrays *scene, const ts_surface_batch *of);

#endif

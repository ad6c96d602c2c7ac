/* Surfaces of one material in vector lanes, with the bits of ts_k_surface: vector loops evaluate textures, normal maps
 * and corners of many samples at once. */
#ifndef TS_BACKENDS_C_RASTER_SURFACE_BATCH_H
#define TS_BACKENDS_C_RASTER_SURFACE_BATCH_H
#include "backends/c/raster/lanes.h"
#include "kernels/base/shade.h"
#include "kernels/base/surface.h"

/* The samples. */
typedef struct {
	u32 material, n;
	u32 triangle[TS_ABREAST];
	ts_lanes3 w;      /* weights of the triangle's corners */
	ts_lanes3 normal; /* (b - a) x (c - a) */
	ts_lanes3 p, viewer;
	f32 footprint[TS_ABREAST];
	/* Those above have values in whole vectors (ts_repeat_last). */
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

/* Their outgoing radiance towards the viewers, with the bits of ts_k_shade_lit (light_batch.c). lamps may be NULL if
 * of->lit is. */
void ts_light_batch(ts_lanes3 *radiance, const ts_arrays *scene, const ts_lamp *lamps, const ts_surface_batch *of,
                    const ts_surfaces *s);

/* The corners' texture coordinates in the slot's set. */
typedef struct {
	f32 u[3][TS_ABREAST], v[3][TS_ABREAST];
} ts_uv_batch;

/* ts_k_slot_uv */
static inline ts_v2 ts_uv_lane(const f32 transform[6], const ts_uv_batch *uv, u32 corner, u32 i)
{
	f32 x = uv->u[corner][i], y = uv->v[corner][i];
	f32 u = transform[0] * x + transform[1] * y, v = transform[3] * x + transform[4] * y;
	return ts_v2_make(u + transform[2], v + transform[5]);
}

/* Red, green and blue of `slot` at the samples of `of`, with the bits of ts_k_slot_sample; area: |normal|
 * (texture_batch.c). */
void ts_texture_batch(ts_lanes3 *to, const ts_arrays *scene, const ts_slot *slot, const ts_surface_batch *of,
                      const ts_uv_batch *uv, const f32 *area);

#endif

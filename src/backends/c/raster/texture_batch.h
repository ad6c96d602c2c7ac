/* One texture at many places in vector lanes, with the bits of ts_k_slot_sample. */
#ifndef TS_BACKENDS_C_RASTER_TEXTURE_BATCH_H
#define TS_BACKENDS_C_RASTER_TEXTURE_BATCH_H
#include "backends/c/raster/surface_batch.h"

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

/* Red, green and blue of `slot` at the samples of `of`; area: |normal|. */
void ts_texture_batch(ts_lanes3 *to, const ts_arrays *scene, const ts_slot *slot, const ts_surface_batch *of,
                      const ts_uv_batch *uv, const f32 *area);

#endif

/* Parts of answers that families share: lamps and their depth maps, the G-buffer, reflective shadow maps. */
#ifndef TS_METHODS_RASTER_TOOLS_PROBE_H
#define TS_METHODS_RASTER_TOOLS_PROBE_H
#include "kernels/raster/shadow_map.h"
#include "probe/parts.h"

/* ---- lamps and their views (probe_lamps.c) ---- */
/* The views of a light's samples. */
typedef enum {
	TS_PROBE_A_VIEW,       /* one view per sample */
	TS_PROBE_A_CUBE,       /* six views per sample, the faces of a cube */
	TS_PROBE_VIEW_OR_CUBE, /* one sample, with a view or a cube as the light's kind needs */
	TS_PROBE_TAPS,         /* one view per light, whatever its samples are */
} ts_probe_lens;

typedef struct {
	ts_probe_lens lens;
	const ts_light *lights;
	const ts_lamp *lamps;
	const ts_offscreen *views;
	u32 n_lights, n_views;
} ts_probe_lamps;

/* Reads the lamps and their views, and checks them and the shapes of buffers with an element per texel of a view. The
 * eye must be read before. */
ts_status ts_probe_read_lamps(ts_probe *probe, ts_probe_lens lens, ts_probe_lamps *lamps);
/* The view of a light's sample, or the first of its cube. */
u32 ts_probe_lamp_view(const ts_probe_lamps *lamps, u32 light, u32 sample);
bool ts_probe_lamp_has_cube(const ts_probe_lamps *lamps, u32 light);
/* "3", or "0.+X" of a cube. */
json_t *ts_probe_lamp_view_name(const ts_probe_lamps *lamps, const ts_offscreen *view, u32 light);

/* ---- what light reaches a pixel (probe_shadow.c) ---- */
/* A receiver that is looked up in depth maps; `depths` holds some rows of one map, from first_texel on. */
typedef struct {
	ts_probe_lamps lamps;
	ts_shadow_test_args args;
	ts_receiver at;
	f32 moves; /* the step of the point from pixel to pixel */
	u32 *depths;
	u64 first_texel;
	u32 *lit; /* samples of each light that reach the point */
} ts_probe_shadow;

/* Puts the results of a light's samples, and counts the samples that reach the point in shadow->lit[light]. */
typedef ts_status ts_probe_samples(ts_probe *probe, json_t *object, ts_probe_shadow *shadow, u32 light);
ts_probe_samples ts_probe_put_samples;

/* Reads rows [first, first + n) of a depth map. */
ts_status ts_probe_read_rows(ts_probe *probe, ts_probe_shadow *shadow, const ts_offscreen *view, u32 first, u32 n);
/* Puts the light that reaches row y and column x of the eye's buffers, where the eye sees `at`; shadow->lamps must be
 * read. Release by ts_probe_shadow_free, also on failure. */
ts_status ts_probe_put_shadow(ts_probe *probe, ts_probe_shadow *shadow, u32 x, u32 y, const ts_receiver *at,
                              ts_probe_samples *put_samples, json_t *object);
void ts_probe_shadow_free(ts_probe_shadow *shadow);
/* Puts the light that reaches a pixel, and its shading with this light; reads the lamps. */
ts_status ts_probe_put_shadowed(ts_probe *probe, const ts_probe_seen *seen, ts_probe_lens lens,
                                ts_probe_samples *put_samples, json_t *object, ts_v3 *radiance);
/* A pixel of shadows by depth maps. */
ts_status ts_probe_shadow_pixel(ts_probe *probe, const ts_probe_question *question, json_t *object);

/* ---- indirect light (probe_indirect.c) ---- */
typedef struct {
	f32 irradiance[3], specular[3];
	bool reflects; /* specularly; false: `specular` is not set */
} ts_probe_gathered;

/* Puts the parts of a pixel's light, and sets the light; `pixel` is that of the G-buffer. */
typedef ts_status ts_probe_irradiance(ts_probe *probe, const ts_probe_seen *at, const ts_gpixel *pixel, json_t *object,
                                      ts_probe_gathered *gathered);
/* Puts the G-buffer's pixel, the parts of its irradiance, the irradiance, and the reflected light. */
ts_status ts_probe_put_indirect(ts_probe *probe, const ts_probe_seen *at, ts_probe_irradiance *put_from, json_t *object,
                                ts_v3 *radiance);

/* ---- triangles of light (probe_indirect.c) ---- */
/* Puts the place of a triangle of light, and its exitance. */
void ts_probe_put_shining(ts_probe *probe, json_t *object, const ts_patch *patch);
/* Puts a texel as a triangle of light. */
ts_status ts_probe_put_patch(ts_probe *probe, json_t *object, const ts_probe_lamps *lamps, u32 index,
                             const ts_patch *patch);

#endif

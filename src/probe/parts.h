/* Shared by the answers of all families: checked access to the trace, the scene in memory, JSON, surfaces, and the
 * contest of triangles. */
#ifndef TS_PROBE_PARTS_H
#define TS_PROBE_PARTS_H
#include "kernels/base/shade.h"
#include "kernels/raster/view.h"
#include "probe/probe.h"
#include "trace/field.h"
#include "trace/load.h"
#include "trace/reader.h"

enum { TS_PROBE_SIDE = 16384 }; /* the largest of views and images */

struct ts_probe {
	ts_trace *trace;                 /* a copy, to which buffers that no file holds may be added */
	ts_reader *reader[TS_N_BUFFERS]; /* NULL: not opened yet */
	ts_fields fields[TS_N_BUFFERS];
	ts_sizes sizes;            /* of records.def: counted, and what the parameters give */
	void *whole[TS_N_BUFFERS]; /* buffers that ts_probe_whole read; else NULL */
	ts_view view;              /* the eye, after ts_probe_scene */
	ts_arrays scene;           /* after ts_probe_scene; this frame's vertices; lights are the lamps, if any */
	u64 *texels;               /* of images that ts_probe_textures read */
	u8 *image_read;
	ts_load *load; /* what ts_probe_load_for loaded; NULL: nothing yet */
	bool failed;   /* out of memory while an answer was made */
};

/* ---- access (read.c) ---- */
/* Fails unless a row answers for the trace's method (ask.c). */
ts_status ts_probe_explains(const ts_trace *trace);
/* Whether the trace's method makes a buffer. */
bool ts_probe_makes(const ts_probe *probe, ts_buffer_id id);
/* Fails with the names of all buffers of `ids`, ended by TS_N_BUFFERS, that the trace lacks. */
ts_status ts_probe_require(const ts_probe *probe, const ts_buffer_id *ids);
bool ts_probe_has(const ts_probe *probe, ts_buffer_id id);
u64 ts_probe_n(const ts_probe *probe, ts_buffer_id id);
/* Copies elements [first, first + n) of a buffer. Fails if they do not exist, if a float is not finite, or if an index
 * is out of range; the message tells file, element and value. */
ts_status ts_probe_fetch(ts_probe *probe, ts_buffer_id id, u64 first, u64 n, void *to);
/* The `n` elements at row y and column x of a buffer of rows and columns; *there is false outside the buffer's crop, or
 * if the trace lacks the buffer. */
ts_status ts_probe_fetch_pixel(ts_probe *probe, ts_buffer_id id, u32 x, u32 y, u32 n, void *to, bool *there);
/* All ts_probe_n elements of a buffer, read once, checked as ts_probe_fetch does, and kept; NULL on failure. */
void *ts_probe_whole(ts_probe *probe, ts_buffer_id id);
/* Loads into probe->load the buffers that these stages, a list ended by NULL, read, and checks them as for the last
 * stage. If all of them are loaded already, nothing is done. */
ts_status ts_probe_load_for(ts_probe *probe, const char *const *stages);
const void *ts_probe_loaded(const ts_probe *probe, ts_buffer_id id);

/* ---- the scene (scene.c) ---- */
/* Reads the scene's arrays without texels, and the eye, and checks all shapes of the trace. Further calls do
 * nothing. */
ts_status ts_probe_scene(ts_probe *probe);
/* Reads the images of a triangle's material; to be called before its surface or alpha is computed. */
ts_status ts_probe_textures(ts_probe *probe, u32 triangle);
/* Checks all shapes of the trace against its sizes. texels: of all cubes or views; TS_UNKNOWN leaves shapes that depend
 * on them unchecked. */
ts_status ts_probe_shapes(const ts_probe *probe, u64 texels);

/* ---- answers (json.c) ---- */
/* Sets object[key] to value and takes value over; out of memory it sets probe->failed. */
void ts_probe_put(ts_probe *probe, json_t *object, const char *key, json_t *value);
void ts_probe_append(ts_probe *probe, json_t *array, json_t *value);
json_t *ts_probe_int(u64 value);
json_t *ts_probe_pair(u32 x, u32 y);
json_t *ts_probe_real(f32 value);
json_t *ts_probe_v3(ts_v3 value);
/* {"value": 1.5, "bits": "3fc00000"} */
json_t *ts_probe_bits(f32 value);
json_t *ts_probe_v3_bits(ts_v3 value);
/* "3.+X" */
json_t *ts_probe_face_name(u32 reflector, u32 face);
/* Puts the method of the trace. */
void ts_probe_put_method(ts_probe *probe, json_t *object);
/* Puts {"behind": world units, "behind_ulps": units in the last place}: how far `depth` lies behind `winner`. */
void ts_probe_put_margin(ts_probe *probe, json_t *object, f32 winner, f32 depth);
/* Puts `check`: "bits agree with BUFFER" or "bits differ from BUFFER: <its bits>" . */
void ts_probe_put_check(ts_probe *probe, json_t *object, ts_buffer_id id, const f32 *computed, const f32 *held, u32 n);
/* As ts_probe_put_check, for one element; the text names the first field that differs. */
void ts_probe_put_record_check(ts_probe *probe, json_t *object, ts_buffer_id id, const void *computed,
                               const void *held);
/* As ts_probe_put_check, for keys, depth << 32 | index. */
void ts_probe_put_key_check(ts_probe *probe, json_t *object, ts_buffer_id id, u64 found, u64 held);
/* Puts `sum`: whether the sum of the terms that were put has the bits of the total. */
void ts_probe_put_sum(ts_probe *probe, json_t *object, ts_v3 sum, ts_v3 total);

/* ---- surfaces (surface.c) ---- */
/* Puts the triangle and its material, object and reflector. */
void ts_probe_put_triangle(ts_probe *probe, json_t *object, u32 triangle);
/* Position, normals, material values, and texture slots with their values. */
json_t *ts_probe_surface(ts_probe *probe, u32 triangle, const ts_surface *surface, ts_v3 weights, f32 footprint);
/* The terms of ts_k_shade_lit towards v, in the order of their sum, and the total, which is also returned in *total. */
json_t *ts_probe_shading(ts_probe *probe, const ts_surface *surface, ts_v3 v, const u32 *lit, const ts_lamp *lamps,
                         ts_v3 *total);

/* ---- competition (contest.c) ---- */
typedef struct {
	u64 key; /* depth << 32 | index */
	u32 triangle;
	bool cut; /* alpha test rejected it */
} ts_offer;
typedef struct {
	ts_offer *offer;
	size_t n, capacity;
} ts_offers;

/* Puts what the index of an offer is of, where it is of no triangle. */
typedef ts_status ts_probe_put_index(ts_probe *probe, json_t *object, u32 index);

ts_status ts_probe_offers_add(ts_offers *offers, ts_offer offer);
void ts_probe_offers_sort(ts_offers *offers);
/* All triangles that cover pixel (x, y) of a view, nearest first; `own`: a reflector whose triangles are not drawn, or
 * TS_NONE. Release offers->offer by free(), also on failure. */
ts_status ts_probe_contest(ts_probe *probe, const ts_camera_k *view, u32 own, u32 x, u32 y, ts_offers *offers);
/* Puts the offers in the order of keys, each with its distance behind the first, and whether the first is `held`, the
 * key in buffer `id`. put_index NULL: indices are of triangles and depths are axial; otherwise depths are distances. */
ts_status ts_probe_put_offers(ts_probe *probe, json_t *object, const ts_offers *offers, ts_buffer_id id, u64 held,
                              ts_probe_put_index *put_index);

/* ---- pixels of the eye (pixel.c) ---- */
/* A pixel where the eye sees a triangle, or a sample of one. */
typedef struct {
	u32 x, y, row; /* row: of the eye's buffers */
	ts_camera_k view;
	u64 key;
	ts_surface surface;
} ts_probe_seen;

/* Puts the terms of a pixel's radiance, and sets *radiance. */
typedef ts_status ts_probe_light(ts_probe *probe, const ts_probe_seen *at, json_t *object, ts_v3 *radiance);

/* Puts the pixel and the method; fails if the pixel is outside the eye's image. */
ts_status ts_probe_put_pixel(ts_probe *probe, const ts_probe_question *question, json_t *object);
/* Puts the radiance, and the image's values at the pixel. */
ts_status ts_probe_put_image(ts_probe *probe, json_t *object, u32 x, u32 y, ts_v3 radiance);
/* Puts the answer about a pixel at which the eye sees triangles: the triangles that cover it, the surface and its
 * light, for each sample, and the image. `needed`: buffers that the trace must have beside the scene, ended by
 * TS_N_BUFFERS. */
ts_status ts_probe_eye_pixel(ts_probe *probe, const ts_probe_question *question, const ts_buffer_id *needed,
                             ts_probe_light *light, json_t *object);
/* Puts the shading of a surface. lit: which samples of the lamps reach it; lit and lamps may be NULL. */
void ts_probe_put_shading(ts_probe *probe, const ts_probe_seen *at, const u32 *lit, const ts_lamp *lamps,
                          json_t *object, ts_v3 *radiance);

#endif

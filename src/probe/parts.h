/* What the parts of answers share, in whatever family: checked access to the trace, the scene in memory, JSON,
 * surfaces, and who competed. */
#ifndef TS_TRACE_PROBE_PARTS_H
#define TS_TRACE_PROBE_PARTS_H
#include "../kernels/base/shade.h"
#include "../kernels/raster/draw.h"
#include "../trace/field.h"
#include "../trace/load.h"
#include "probe.h"
#include "../trace/reader.h"

enum { TS_PROBE_SIDE = 16384 }; /* the largest of views and images */

struct ts_probe {
	ts_trace *trace;                 /* a copy, which may get buffers that nobody stored */
	ts_reader *reader[TS_N_BUFFERS]; /* NULL: not opened yet */
	ts_fields fields[TS_N_BUFFERS];
	ts_sizes sizes;            /* of records.def: counted, and what the parameters give */
	void *whole[TS_N_BUFFERS]; /* buffers that ts_probe_whole read; else NULL */
	ts_view view;              /* the eye, after ts_probe_scene */
	ts_arrays scene;           /* after ts_probe_scene; vertices are this frame's, with lamps lights are these */
	u64 *texels;               /* of images that were asked for */
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
/* Copies elements [first, first + n) of a buffer. Fails with file, element and value if they are not there, if a float
 * is not finite, or if an index names nothing. */
ts_status ts_probe_fetch(ts_probe *probe, ts_buffer_id id, u64 first, u64 n, void *to);
/* The elements of row y and column x, `n` of them, of a buffer of rows and columns; *there is false outside its crop,
 * or if the trace lacks it. */
ts_status ts_probe_fetch_pixel(ts_probe *probe, ts_buffer_id id, u32 x, u32 y, u32 n, void *to, bool *there);
/* All ts_probe_n elements of a buffer, read once, checked as ts_probe_fetch does, and kept; NULL on failure. */
void *ts_probe_whole(ts_probe *probe, ts_buffer_id id);
/* Loads into p->load what these stages read, ended by NULL, and checks it all as for the last of them; what was loaded
 * stays if all of that is there. */
ts_status ts_probe_load_for(ts_probe *probe, const char *const *stages);
const void *ts_probe_loaded(const ts_probe *probe, ts_buffer_id id);

/* ---- the scene (scene.c) ---- */
/* Reads the scene's arrays but the texels, and the eye, and checks all shapes of the trace. Once is enough. */
ts_status ts_probe_scene(ts_probe *probe);
/* Reads the images of a triangle's material; before its surface or alpha is computed. */
ts_status ts_probe_textures(ts_probe *probe, u32 triangle);
/* Checks all shapes of the trace against its sizes. texels: of all cubes or views; TS_UNKNOWN leaves shapes that depend
 * on them unchecked. */
ts_status ts_probe_shapes(const ts_probe *probe, u64 texels);

/* ---- answers (json.c) ---- */
/* object[key] = value, which is taken over; without memory probe->failed is set. */
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
/* Puts {"behind": world units, "behind_ulps": floats} of a depth behind the winner's. */
void ts_probe_put_margin(ts_probe *probe, json_t *object, f32 winner, f32 depth);
/* Puts `check`: "bits agree with BUFFER" or "bits differ from BUFFER: <its bits>" . */
void ts_probe_put_check(ts_probe *probe, json_t *object, ts_buffer_id id, const f32 *computed, const f32 *held, u32 n);
/* The same of one element, by its first field that differs. */
void ts_probe_put_record_check(ts_probe *probe, json_t *object, ts_buffer_id id, const void *computed,
                               const void *held);
/* The same of keys, depth << 32 | index. */
void ts_probe_put_key_check(ts_probe *probe, json_t *object, ts_buffer_id id, u64 found, u64 held);
/* Puts `sum`: whether the terms that were put have the bits of the total. */
void ts_probe_put_sum(ts_probe *probe, json_t *object, ts_v3 sum, ts_v3 total);

/* ---- surfaces (surface.c) ---- */
/* Puts triangle, material, object, reflector. */
void ts_probe_put_triangle(ts_probe *probe, json_t *object, u32 triangle);
/* Position, normals, material values, texture slots with what they gave. */
json_t *ts_probe_surface(ts_probe *probe, u32 triangle, const ts_surface *surface, ts_v3 weights, f32 footprint);
/* The terms of ts_k_shade_lit towards v, in the order of their sum, and the total, which is also returned in *total. */
json_t *ts_probe_shading(ts_probe *probe, const ts_surface *surface, ts_v3 v, const u32 *lit, const ts_lamp *lamps,
                         ts_v3 *total);

/* ---- competition (contest.c) ---- */
typedef struct {
	u64 key; /* depth << 32 | index */
	u32 triangle;
	bool cut; /* alpha took it away */
} ts_offer;
typedef struct {
	ts_offer *offer;
	size_t n, capacity;
} ts_offers;

/* Puts what the index of an offer names, if that is no triangle. */
typedef ts_status ts_probe_put_index(ts_probe *probe, json_t *object, u32 index);

ts_status ts_probe_offers_add(ts_offers *offers, ts_offer offer);
void ts_probe_offers_sort(ts_offers *offers);
/* All triangles that cover pixel (x, y) of a view, nearest first; `own`: a reflector whose triangles are not drawn, or
 * TS_NONE. Release offers->offer by free(), also on failure. */
ts_status ts_probe_contest(ts_probe *probe, const ts_camera_k *view, u32 own, u32 x, u32 y, ts_offers *offers);
/* Puts the offers by key, with their distance behind the first, and whether the first is `held`, the key of buffer id.
 * put_index NULL: indices are triangles and depths axial, else they are distances. */
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

/* Puts what a pixel's radiance is made of, and sets it. */
typedef ts_status ts_probe_light(ts_probe *probe, const ts_probe_seen *at, json_t *object, ts_v3 *radiance);

/* Puts pixel and method; fails if the eye has no such pixel. */
ts_status ts_probe_put_pixel(ts_probe *probe, const ts_probe_question *question, json_t *object);
/* Puts the radiance and what the image holds. */
ts_status ts_probe_put_image(ts_probe *probe, json_t *object, u32 x, u32 y, ts_v3 radiance);
/* Puts all of a pixel whose eye sees triangles: who covers it, the surface and its light, of each sample if it has
 * several, and the image. `needed`: buffers that must be there beside the scene, ended by TS_N_BUFFERS. */
ts_status ts_probe_eye_pixel(ts_probe *probe, const ts_probe_question *question, const ts_buffer_id *needed,
                             ts_probe_light *light, json_t *object);
/* Puts the shading of a surface; lit and lamps: which samples reach it, or NULL. */
void ts_probe_put_shading(ts_probe *probe, const ts_probe_seen *at, const u32 *lit, const ts_lamp *lamps,
                          json_t *object, ts_v3 *radiance);

#endif

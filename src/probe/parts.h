/* What the files of the probe share: checked access to the trace, the scene in memory, and parts of answers. */
#ifndef TS_TRACE_PROBE_PARTS_H
#define TS_TRACE_PROBE_PARTS_H
#include "../kernels/raster/draw.h"
#include "../kernels/hulls/hull.h"
#include "../kernels/points/pcss.h"
#include "../kernels/views/vpl_gather.h"
#include "../trace/field.h"
#include "../trace/load.h"
#include "probe.h"
#include "../trace/reader.h"

enum { TS_PROBE_SIDE = 16384 }; /* the largest of views and images */

struct ts_probe {
	ts_trace *trace;
	ts_reader *reader[TS_N_BUFFERS]; /* NULL: not opened yet */
	ts_fields fields[TS_N_BUFFERS];
	ts_sizes sizes;       /* of records.def: counted, and what the parameters give */
	ts_arrays scene;      /* after ts_probe_scene; vertices are this frame's, with lamps lights are these */
	u64 n_vertices, n_materials, n_slots, n_images, n_texels, n_lights, n_objects;
	u64 *texels;          /* of images that were asked for */
	u8 *image_read;
	ts_view view;         /* the eye, after ts_probe_scene */
	ts_face *cubes;       /* after ts_probe_scene */
	u32 n_cubes, n_words;
	bool mirrors, faces;  /* of reflections; triangles are drawn into the faces of cubes */
	bool has_taps;        /* many, of the one view of each light */
	bool surfels;         /* pixels show surfels, no triangles */
	bool gathers;         /* pixels have indirect light or that of particles, and no other */
	bool has_lamps;       /* the lights are lamps, with views of their own */
	ts_load *load;        /* of MegaViews and surfels: what the answer is made from, checked; NULL: not loaded yet */
	ts_offscreen *views;  /* of the lamps; else NULL */
	u32 n_views;
	ts_lamp *lamps;
	u32 *lit;             /* samples of each that reach the pixel; NULL: all light does */
	bool failed;          /* out of memory while an answer was made */
};

/* ---- access (probe_read.c) ---- */
/* Fails with the names of all buffers of `ids`, ended by TS_N_BUFFERS, that the trace lacks. */
ts_status ts_probe_require(const ts_probe *probe, const ts_buffer_id *ids);
bool ts_probe_has(const ts_probe *probe, ts_buffer_id id);
u64 ts_probe_n(const ts_probe *probe, ts_buffer_id id);
/* Copies elements [first, first + n) of a buffer. Fails with file, element and value if they are not there, if a float
 * is not finite, or if an index names nothing. */
ts_status ts_probe_fetch(ts_probe *probe, ts_buffer_id id, u64 first, u64 n, void *to);
/* The elements of pixel (x, y), `n` of them, of a buffer of rows and columns; *there is false outside its crop, or if
 * the trace lacks it. */
ts_status ts_probe_fetch_pixel(ts_probe *probe, ts_buffer_id id, u32 x, u32 y, u32 n, void *to, bool *there);
/* Loads into p->load what these stages read, ended by NULL, and checks it all as for the last of them; what was loaded
 * stays if all of that is there. */
ts_status ts_probe_load_for(ts_probe *probe, const char *const *stages);
const void *ts_probe_loaded(const ts_probe *probe, ts_buffer_id id);
/* The piece of a point, its record, and the triangle. */
ts_status ts_probe_fetch_point(ts_probe *probe, u64 point, ts_point *record, ts_piece *piece);

/* ---- the scene (probe_scene.c) ---- */
/* Reads the scene's arrays but the texels, the eye and the cubes, and checks all shapes of the trace. Once is enough.
 */
ts_status ts_probe_scene(ts_probe *probe);
/* Reads the images of a triangle's material; before its surface or alpha is computed. */
ts_status ts_probe_textures(ts_probe *probe, u32 triangle);
/* All shapes of the trace against its sizes. */
ts_status ts_probe_shapes(const ts_probe *probe);
void ts_probe_scene_free(ts_probe *probe);
/* A whole buffer, released by free(); NULL on failure. */
void *ts_probe_load(ts_probe *probe, ts_buffer_id id, u64 *n);

/* ---- answers (probe_json.c) ---- */
/* object[key] = value, which is taken over; without memory probe->failed is set. */
void ts_probe_put(ts_probe *probe, json_t *object, const char *key, json_t *value);
void ts_probe_append(ts_probe *probe, json_t *array, json_t *value);
/* The answer, or a failure if memory ran out; takes it over. */
ts_status ts_probe_answer(ts_probe *probe, json_t *made, ts_status status, json_t **answer);
json_t *ts_probe_int(u64 value);
json_t *ts_probe_pair(u32 x, u32 y);
json_t *ts_probe_real(f32 value);
json_t *ts_probe_v3(ts_v3 value);
/* {"value": 1.5, "bits": "3fc00000"} */
json_t *ts_probe_bits(f32 value);
json_t *ts_probe_v3_bits(ts_v3 value);
/* "piece,x,y" */
json_t *ts_probe_key(u64 key);
/* "3.+X" */
json_t *ts_probe_face_name(u32 reflector, u32 face);
/* Puts {"behind": world units, "behind_ulps": floats} of a depth behind the winner's. */
void ts_probe_put_margin(ts_probe *probe, json_t *object, f32 winner, f32 depth);
/* Puts `check`: "bits agree with BUFFER" or "bits differ from BUFFER: <its bits>" . */
void ts_probe_put_check(ts_probe *probe, json_t *object, ts_buffer_id id, const f32 *computed, const f32 *held, u32 n);
/* The same of one element, by its first field that differs. */
void ts_probe_put_record_check(ts_probe *probe, json_t *object, ts_buffer_id id, const void *computed, const void *held);
/* The same of keys, depth << 32 | index. */
void ts_probe_put_key_check(ts_probe *probe, json_t *object, ts_buffer_id id, u64 found, u64 held);
/* Puts `sum`: whether the terms that were put have the bits of the total. */
void ts_probe_put_sum(ts_probe *probe, json_t *object, ts_v3 sum, ts_v3 total);

/* ---- surfaces (probe_surface.c) ---- */
/* Puts triangle, material, object, reflector. */
void ts_probe_put_triangle(ts_probe *probe, json_t *object, u32 triangle);
/* Position, normals, material values, texture slots with what they gave. */
json_t *ts_probe_surface(ts_probe *probe, u32 triangle, const ts_surface *surface, ts_v3 weights, f32 footprint);
/* The terms of ts_k_shade towards v, in the order of their sum, and the total, which is also returned in *total. */
json_t *ts_probe_shading(ts_probe *probe, const ts_surface *surface, ts_v3 v, ts_v3 *total);

/* ---- competition (probe_contest.c, probe_spread.c) ---- */
typedef struct {
	u64 key;   /* depth << 32 | index */
	u32 triangle;
	bool cut;  /* alpha took it away */
} ts_offer;
typedef struct { ts_offer *offer; size_t n, capacity; } ts_offers;

/* All triangles that cover pixel (x, y) of a view, nearest first; `own`: a reflector whose triangles are not drawn, or
 * TS_NONE. Release offers->offer by free(), also on failure. */
ts_status ts_probe_contest(ts_probe *probe, const ts_camera_k *view, u32 own, u32 x, u32 y, ts_offers *offers);
void ts_probe_offers_sort(ts_offers *offers);
/* Puts the offers by key, with their distance behind the first, and whether the first is `held`, the key of buffer id.
 * Indices are triangles, or points. */
ts_status ts_probe_put_offers(ts_probe *probe, json_t *object, const ts_offers *offers, ts_buffer_id id, u64 held,
                              bool points);

/* Who took texels from whom. */
typedef struct { u32 triangle; u64 texels, ties; f32 least; i64 least_ulps; } ts_rival;
typedef struct {
	u64 offered, won, lost, ties, lost_to_own, odd; /* texels; odd: the buffer holds what is farther */
	ts_rival *rival; size_t n_rivals, capacity;
	size_t last; /* place of the rival found last */
} ts_spread;

/* Holds what a triangle or its points wrote alone, n keys, against elements from `first` on of buffer `id` of depths.
 * `index` are the points that these keys' low halves number, ascending, n_index of them; NULL: they are triangles.
 * won[i], if not NULL, receives how many texels index[i] holds. */
ts_status ts_probe_spread_add(ts_probe *probe, ts_spread *spread, const u64 *alone, u64 n, ts_buffer_id id, u64 first,
                              u32 triangle, const u32 *index, size_t n_index, u64 *won);
/* Place of a point in an ascending list; n: it is not in it. */
size_t ts_probe_place(const u32 *index, size_t n, u32 point);
/* Puts the figures, and the rivals that took most. */
void ts_probe_put_spread(ts_probe *probe, json_t *object, const ts_spread *spread);
void ts_probe_spread_free(ts_spread *spread);

/* ---- points in faces (probe_points.c) ---- */
/* Points of one triangle, or one of them. */
typedef struct {
	u32 *index;           /* in points.record, ascending */
	ts_point *point;      /* their piece is one of these pieces */
	u64 *offered, *won;   /* texels, in all faces */
	size_t n, capacity;
	ts_piece *piece;
	ts_align *frame;
	u64 first_piece, n_pieces;
	u32 triangle;
} ts_probe_set;

/* The points of pieces [first_piece, first_piece + n_pieces); only point `only` unless that is TS_NONE. Release by
 * ts_probe_set_free, also on failure. */
ts_status ts_probe_set_make(ts_probe *probe, ts_probe_set *set, u64 first_piece, u64 n_pieces, u32 only);
void ts_probe_set_free(ts_probe_set *set);
/* Splats them into every face that may see them; faces: an entry a face that they touch. */
ts_status ts_probe_set_splat(ts_probe *probe, ts_probe_set *set, ts_spread *spread, json_t *faces);
/* Puts how many samples of reflective pixels, and of later bounces, see one of them. */
ts_status ts_probe_put_samples(ts_probe *probe, json_t *object, const ts_probe_set *set, u64 *n_samples);

/* ---- parts of answers ---- */
/* What a reflective pixel, element `entry` of pixel.record, shows (probe_mirror.c; of MVR probe_mip.c). *total has the
 * bits of shade.radiance if all is well. */
ts_status ts_probe_mirror(ts_probe *probe, u64 entry, json_t *object, ts_v3 *total);
ts_status ts_probe_mip(ts_probe *probe, u64 entry, json_t *object, ts_v3 *total);
/* Off-screen views and lamps, read and checked with the scene; what light reaches pixel (x, y), where the eye sees
 * `at`: sets probe->lit (probe_shadow.c). */
ts_status ts_probe_lamps(ts_probe *probe);
ts_status ts_probe_shadow(ts_probe *probe, u32 x, u32 y, const ts_receiver *at, json_t *object);
/* Indirect light at pixel (x, y), whose key is not empty: the radiance, and what led to it (probe_indirect.c). */
ts_status ts_probe_indirect(ts_probe *probe, u32 x, u32 y, u64 key, json_t *object, ts_v3 *total);
/* Its irradiance by hulls (probe_hull.c), of one channel from its lobe (probe_lobe.c), and by direct
 * (probe_direct.c). */
ts_status ts_probe_hull(ts_probe *probe, u32 x, u32 y, const ts_gpixel *pixel, json_t *object, f32 irradiance[3]);
json_t *ts_probe_lobe(ts_probe *probe, const ts_hull_args *args, const ts_sg *g, ts_v3 n, u32 channel);
ts_status ts_probe_direct(ts_probe *probe, const ts_gpixel *pixel, json_t *object, f32 irradiance[3]);
/* Its irradiance from virtual point lights: what culling leaves, what is drawn (probe_views.c), what the filter
 * makes of that (probe_filter.c). */
ts_status ts_probe_views(ts_probe *p, u32 x, u32 y, json_t *object, f32 irradiance[3]);
ts_status ts_probe_filter(ts_probe *p, u32 x, u32 y, json_t *object, f32 irradiance[3]);
/* What those parts share. */
typedef struct {
	ts_vpl_gather_args args;
	ts_gpixel pixel;         /* of the G-buffer */
	ts_vpl_args vpl;         /* indirect light: where its paths come from, of which there are n_paths */
	u32 *offset, *paths;
	u64 n_paths;
} ts_probe_gather;
/* Pixel (x, y) of surfels: what is nearest, what is blended and what that makes, of which `pixel` is the G-buffer's
 * (probe_surfel.c); its light, and whether it is outlined (probe_deferred.c). */
ts_status ts_probe_load_surfels(ts_probe *probe);
ts_status ts_probe_surfels(ts_probe *probe, u32 x, u32 y, json_t *object);
ts_status ts_probe_deferred(ts_probe *probe, u32 x, u32 y, json_t *object, ts_v3 *total);
/* Loads p->load of it. */
ts_status ts_probe_load_views(ts_probe *probe);
/* The paths that virtual point lights stand on; offset and paths are released by free(), also on failure
 * (probe_vpl.c). */
ts_status ts_probe_read_paths(ts_probe *probe, ts_probe_gather *gather);
/* Puts a virtual point light or particle: where it comes from, what it sends to the pixel, and what its map answers. */
ts_status ts_probe_vpl(ts_probe *probe, json_t *object, const ts_probe_gather *gather, u32 view);
/* The nodes of views from the root to one of them, each the parent of the next, with their maps alone
 * (probe_pair.c). */
enum { TS_PROBE_LEVELS = 12 };
typedef struct {
	u32 n, id[TS_PROBE_LEVELS];
	ts_node nodes[TS_PROBE_LEVELS];
	u64 *texels;
	ts_fuse_args args;
} ts_probe_chain;
/* Reads the chain to a node. Release by free() of texels, also on failure. */
ts_status ts_probe_read_chain(ts_probe *probe, ts_probe_chain *chain, u32 node);
/* What a node of the chain has of its own in a texel. */
u64 ts_probe_own_key(const ts_probe_chain *chain, u32 i, u32 texel);
/* Puts a pair of nodes that is in a map: what decided that, by numbers. */
void ts_probe_put_decision(ts_probe *probe, json_t *object, const ts_traverse_args *how, u64 pair);
/* Puts the pair of nodes that a texel of the whole map of a node of views shows. */
ts_status ts_probe_put_pair(ts_probe *probe, json_t *object, u32 node, u32 texel);
/* Puts what a texel of a reflective shadow map is as a light (probe_direct.c). */
ts_status ts_probe_put_patch(ts_probe *probe, json_t *object, u32 index, const ts_patch *patch);
/* Fails with what is explained of the others. */
ts_status ts_probe_of_reflections(const ts_probe *probe);
/* A piece of a triangle: density, culling, frame (probe_piece.c). */
ts_status ts_probe_piece(ts_probe *probe, u64 piece, json_t *object, bool *kept);
/* Which faces may see a triangle, and why others may not; its density and who set it (probe_density.c). `bits` receives
 * the triangle's words, probe->n_words. */
ts_status ts_probe_visibility(ts_probe *probe, u32 triangle, u64 *bits, json_t *object, bool *seen, const char **why);
ts_status ts_probe_density(ts_probe *probe, u32 triangle, const u64 *bits, json_t *object);

#endif

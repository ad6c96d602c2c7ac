/* Answers of the probe about the family of points, and functions that its parts share. */
#ifndef TS_METHODS_POINTS_TOOLS_PROBE_H
#define TS_METHODS_POINTS_TOOLS_PROBE_H
#include "kernels/raster/cube.h"
#include "probe/parts.h"

/* ---- answers ---- */
/* Pixels of reflections by EPR and MVR, of PCSS (probe_pixel.c). */
ts_status ts_probe_epr_pixel(ts_probe *probe, const ts_probe_question *question, json_t *object);
ts_status ts_probe_mvr_pixel(ts_probe *probe, const ts_probe_question *question, json_t *object);
ts_status ts_probe_pcss_pixel(ts_probe *probe, const ts_probe_question *question, json_t *object);
ts_status ts_probe_forward_pixel(ts_probe *probe, const ts_probe_question *question, json_t *object);
/* Texels of a cube's face (probe_texel.c). */
extern const ts_probe_view ts_probe_face;
ts_status ts_probe_epr_texel(ts_probe *probe, const ts_probe_question *question, json_t *object);
ts_status ts_probe_forward_texel(ts_probe *probe, const ts_probe_question *question, json_t *object);
ts_status ts_probe_mvr_texel(ts_probe *probe, const ts_probe_question *question, json_t *object);
/* The way of a triangle or a point through the stages, or the stage that dropped it (probe_triangle.c). */
ts_status ts_probe_epr_triangle(ts_probe *probe, const ts_probe_question *question, json_t *object);
ts_status ts_probe_mvr_triangle(ts_probe *probe, const ts_probe_question *question, json_t *object);
ts_status ts_probe_epr_point(ts_probe *probe, const ts_probe_question *question, json_t *object);

/* ---- cubes (probe_cubes.c) ---- */
/* Reads the scene and the cubes of reflectors, and checks both. Makes points that the method does not store. */
ts_status ts_probe_read_cubes(ts_probe *probe);
/* After that: the cubes, their number, and the words of visibility.bits per triangle. */
const ts_face *ts_probe_cubes(const ts_probe *probe);
u32 ts_probe_n_cubes(const ts_probe *probe);
u32 ts_probe_n_words(const ts_probe *probe);
/* The words of one triangle. */
ts_status ts_probe_fetch_bits(ts_probe *probe, u32 triangle, u64 *bits);

/* ---- what a reflective pixel shows ---- */
/* Element `entry` of mirror_pixel.record (probe_mirror.c; of MVR probe_mip.c; of colours of points probe_forward.c).
 * *total has the bits of shade.radiance if all is well. */
typedef ts_status ts_probe_reflection(ts_probe *probe, u64 entry, json_t *object, ts_v3 *total);
ts_probe_reflection ts_probe_mirror, ts_probe_mip, ts_probe_colours;

/* ---- who took texels from whom (probe_spread.c) ---- */
typedef struct {
	u32 triangle;
	u64 texels, ties;
	f32 least;
	i64 least_ulps;
} ts_rival;
typedef struct {
	u64 offered, won, lost, ties, lost_to_own, odd; /* texels; odd: the buffer holds a farther key */
	ts_rival *rival;
	size_t n_rivals, capacity;
	size_t last; /* place of the rival found last */
} ts_spread;

/* Compares n keys that a triangle or its points alone would write with the elements from `first` on of buffer `id`.
 * `index`: the n_index points, ascending, that the keys' low halves name; NULL: they name triangles. won[i], if not
 * NULL, receives the number of texels that index[i] holds. */
ts_status ts_probe_spread_add(ts_probe *probe, ts_spread *spread, const u64 *alone, u64 n, ts_buffer_id id, u64 first,
                              u32 triangle, const u32 *index, size_t n_index, u64 *won);
/* The index of a point in an ascending list of n; n: it is not in the list. */
size_t ts_probe_place(const u32 *index, size_t n, u32 point);
/* Puts the figures, and the rivals that took most. */
void ts_probe_put_spread(ts_probe *probe, json_t *object, const ts_spread *spread);
void ts_probe_spread_free(ts_spread *spread);

/* ---- points (probe_points.c) ---- */
/* Makes points.record and points.key for the probe where the method counts points and does not store them
 * (probe_points.c). */
ts_status ts_probe_points_again(ts_probe *probe);
/* "piece,x,y" */
json_t *ts_probe_key(u64 key);
/* The record of a point, and its piece. */
ts_status ts_probe_fetch_point(ts_probe *probe, u64 point, ts_point *record, ts_piece *piece);

/* Points of one triangle, or one of them. */
typedef struct {
	u32 *index;         /* in points.record, ascending */
	ts_point *point;    /* their piece is one of these pieces */
	u64 *offered, *won; /* texels, in all faces */
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
/* Splats the points into every face that may see them; faces: one entry per face that they touch. */
ts_status ts_probe_set_splat(ts_probe *probe, ts_probe_set *set, ts_spread *spread, json_t *faces);
/* Puts the number of samples of reflective pixels, and of later bounces, that see one of the points. */
ts_status ts_probe_put_lookups(ts_probe *probe, json_t *object, const ts_probe_set *set, u64 *n_samples);

/* ---- pieces and densities ---- */
/* A piece of a triangle: density, culling, frame (probe_density.c). */
ts_status ts_probe_piece(ts_probe *probe, u64 piece, json_t *object, bool *kept);
/* Puts the faces that may see a triangle, and the reasons why others may not; its density, and the cube that sets it
 * (probe_density.c). `bits` receives the triangle's words, ts_probe_n_words of them. */
ts_status ts_probe_visibility(ts_probe *probe, u32 triangle, u64 *bits, json_t *object, bool *seen, const char **why);
ts_status ts_probe_density(ts_probe *probe, u32 triangle, const u64 *bits, json_t *object);

#endif

/* Why a pixel, a texel, a triangle or a point of a trace is what it is: who competed, who won by how much, and which
 * stage lost the others. What the buffers do not hold is computed again by the kernels, and held against the buffers.
 */
#ifndef TS_TRACE_PROBE_H
#define TS_TRACE_PROBE_H
#include <jansson.h>
#include "../trace/read.h"

typedef struct ts_probe ts_probe;

/* Opens the trace in folder `dir`: of reflections by EPR or MVR, or of shadows, indirect light, particles or surfels, of
 * which pixels are told. On failure *probe is NULL; else release it by ts_probe_close. */
ts_status ts_probe_open(ts_probe **probe, const char *dir);
/* NULL is allowed. */
void ts_probe_close(ts_probe *probe);

/* Each of these sets *answer to a new object, or fails: if there is no such thing, if the trace lacks buffers (all of
 * which are named), or if one of them names what is not there. On failure *answer is NULL. Floats that decide are
 * objects of "value" and "bits"; each "check" says whether what was computed again has the bits of a buffer. */

/* Pixel (x, y) of the eye: the triangles that cover it, the surface, and what it shows, term by term, or sample by
 * sample where it is a mirror. Of shadows also what each sample of each light found in its depth map: the texel, its depth
 * and that of the pixel's point, the bias, the answer, and how near it was to another
 * (kernels/raster/resolve_margin.h). Of indirect light by hulls the boxes of the pixel's block in the order of their
 * claims, what the corners of its box gathered and how much each counts, and its lobes with the terms of their
 * integrals; by direct the brightest triangles of light; by many views, and of particles, the nodes of views that
 * culling leaves it, the brightest of the lights that it draws, each with its path and what its map answers, and the
 * neighbours that the filter takes it with. Of surfels the nearest, the heaviest of those that are blended and of those
 * that epsilon hides, their sums, and the light and the outline of what is made of them. */
ts_status ts_probe_pixel(ts_probe *probe, u32 x, u32 y, json_t **answer);
/* Texel (x, y) of a face, 0 to 5, of a reflector's cube: the points, of MVR the triangles, that competed for it. */
ts_status ts_probe_texel(ts_probe *probe, u32 reflector, u32 face, u32 x, u32 y, json_t **answer);
/* Texel (x, y) of half a map of MegaViews: the pairs of nodes that were rendered into it, by what tests, and what fusion
 * made of them, for each of the nodes of views from the root to that of the map. */
typedef struct {
	u32 index;      /* of a node of views, or of a light, whose leaf it is then */
	bool of_light, back;
} ts_probe_map_id;
ts_status ts_probe_map(ts_probe *probe, ts_probe_map_id map, u32 x, u32 y, json_t **answer);
/* A triangle: where it went, or which stage lost it. */
ts_status ts_probe_triangle(ts_probe *probe, u64 triangle, json_t **answer);
/* A point of EPR, by its index: the same. */
ts_status ts_probe_point(ts_probe *probe, u64 point, json_t **answer);
/* The index of the point of that key of points.key. */
ts_status ts_probe_point_of_key(ts_probe *probe, u64 key, u64 *point);

#endif

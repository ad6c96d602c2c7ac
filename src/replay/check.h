/* Checks of loaded buffers before a stage runs on them. A port's files are untrusted and kernels trust their
 * inputs, so whatever could make a stage read or write elsewhere, never end, or do what C leaves undefined is
 * refused first:
 *
 * - sizes: every buffer has the shape of records.def. What is fixed or counted is taken from the first dimensions of what
 *   is there, the number of reflectors from scene.info; the rest is computed as a run does it (methods/sizes.c). So an
 *   index below its size is an element of its array.
 * - indices: every INDEX row of records.def. A key is all ones or its low half is an index: kernels ask for the
 *   former. An index of a size that is not known has no array that is loaded, and no stage follows it.
 * - floats are finite. No kernel turns a float into an integer but by ts_f2i and ts_fix, which take any float, so
 *   that overflow on the way, even to NaN, leads to wrong numbers only.
 * - prefix sums begin at 0, never fall and end at what they count: emit kernels, shading and the picture read
 *   where they say. Stage points also writes there: its sums must be those that stage count makes of the same
 *   align.frame.
 * - eye.view has the size of the picture; resize.face has no face larger than the parameters allow, and offsets
 *   that are the sums of 6 n^2: texels are addressed by both. offscreen.view: the same, square, six a cube where there
 *   are cubes, of stage deferred_lit one a light and six a point light; lights of stage resolve; lamp.shape: samples, of
 *   stage lamp_view one a view, in order, for views are written where they say; resolve.lit: at most the samples;
 *   lamp.light: at least one, and its kind.
 * - scene.image: whole mip chains inside scene.texel, sides below 2^22, so that 24.8 fixed point names every
 *   texel; scene.slot: uv_set and wrap; scene.object: ranges one after the other inside scene.vertex, and for each
 *   reflector just one object, with vertices; scene.light: kind; scene.info: at most 2^20 reflectors.
 * - voxel.mask, voxel.before and those of the views are what stages voxel and view_voxel make of the same triangles and
 *   views, for lists are written where their bits say. octree.level and view_octree.level begin at 0, never fall and end at
 *   the nodes; a node has the level that they say, its parent before it, and, but for leaves, children behind it that
 *   name it. Every leaf of the views has some, and those name it; view_cone.node names views that are there.
 * - align.frame: q within 24.8 of the lattice, so that edges fit 64 bits, s not negative; for count, points and what
 *   makes points without storing them, fewer than 2^34 lattice squares in the boxes of all pieces.
 *
 * What remains: time. Views of absurd sharpness ask for 4096 pieces of every triangle. Splats and triangles may cover
 * every texel of every face, so that damaged files can make a stage as slow as its elements times its texels, but not
 * endless. Splats of arrival-order points never take the fast path, which trusts that the points of a piece stand
 * together (ts_replay_stage).
 *
 * Every refusal is one line: file, element, field, value, and what would be right. */
#ifndef TS_TRACE_CHECK_H
#define TS_TRACE_CHECK_H
#include "../trace/load.h"

/* Checks all that was loaded for `stage`, and sets the sizes, the run's plan and scene.info.n_reflectors. */
ts_status ts_check(ts_load *load, const ts_stage *stage);

/* Parts of it. What the sizes are: those of other buffers than the stage's outputs, but for C and C4; and the plan that
 * follows from them. */
void ts_check_sizes(ts_load *load, const ts_stage *stage);
/* Values that kernels loop over or address by, other than indices (check_values.c); sizes must be known. */
ts_status ts_check_values(const ts_load *load, const ts_stage *stage);
/* The largest side of a cube face or depth map that the parameters allow. */
u32 ts_check_largest(const ts_run *run);
/* Sizes and offsets of the cubes, if they were loaded. */
ts_status ts_check_faces(const ts_load *load);
/* The same of the off-screen views; the cubes must have been checked (check_views.c). */
ts_status ts_check_views(const ts_load *load);
/* Area lights, their samples, and what reaches pixels; shapes and indices must have been checked. */
ts_status ts_check_lamps(const ts_load *load, const ts_stage *stage);
/* Masks, levels, nodes and cones of the octrees; shapes, indices and sums must have been checked. */
ts_status ts_check_octrees(const ts_load *load, const ts_stage *stage);
/* Boxes of surfels, and which of them are heaviest. */
ts_status ts_check_surfels(const ts_load *load);
/* Lists of views that pixels draw from (check_gather.c); cones must have been checked. */
ts_status ts_check_gather(const ts_load *load, const ts_stage *stage);
/* What was loaded of a stage's outputs is just what the stage makes of the rest, which `from` stands for. */
ts_status ts_check_again(const ts_load *load, const char *maker, const char *from);
/* Fails with one line about a loaded buffer: its file, the place, its value, and "RIGHT would be right". */
ts_status ts_check_refuse(const ts_load *load, ts_buffer_id id, u64 element, const char *field, u32 component,
                          const char *right, ...) __attribute__((format(printf, 6, 7)));

#endif

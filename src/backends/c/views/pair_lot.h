/* Lots of pairs of the traversal for maps, one pair per lane: their fates, and the texels that they are rendered into.
 * A lot is laid from rows: the children of a split node, which follow each other. */
#ifndef TS_BACKENDS_C_VIEWS_PAIR_LOT_H
#define TS_BACKENDS_C_VIEWS_PAIR_LOT_H
#include "backends/c/raster/lanes.h"
#include "kernels/views/view_map.h"

enum { TS_ROW = 8, TS_LOT_PAIRS = TS_ABREAST, TS_LOT_ROOM = TS_LOT_PAIRS + TS_LANES };

/* The nodes of an octree by number; each array has room for a row behind the last node. */
typedef struct {
	f32 *at[3], *radius;
	u32 *leaf; /* 1: a leaf */
} ts_lane_nodes;

/* The cones of views: axis and ts_k_pair_psi. */
typedef struct {
	f32 *axis[3], *cosine, *sine;
	u32 *views;
} ts_lane_cones;

/* The pairs of n nodes of one octree, from `first` on, with a node of the other. */
typedef struct {
	u32 first, other;
	u8 n, step;
	u8 of_views; /* 1: the n nodes are of views */
	u8 mine;     /* 1: the pairs are rendered and counted here; 0: only their children may be */
} ts_pair_row;

/* What is the same for all lots. */
typedef struct {
	ts_lane_nodes scene, views;
	ts_lane_cones cones;
	ts_pyramid pyramid;
	f32 apart;
} ts_lot_job;

/* Counts of pairs by fate, and `served`, the views of rendered pairs. */
typedef struct {
	u64 pairs, culled, near, rendered, wide, several, served;
} ts_pair_counts;

/* For each pair, in half a map: the cap of its node; the first and the last column and row of the cap's box; and the
 * texels to fill, which are 2 x 2 at most. Bit 2 * row + column of `mask` stands for a texel from `texel` on. With
 * TS_LOT_MANY in `mask` they are those of ts_k_cap_fill. */
#define TS_LOT_MANY 16u
typedef struct {
	f32 b[TS_LOT_ROOM], c[TS_LOT_ROOM], y[TS_LOT_ROOM], z[TS_LOT_ROOM];
	i32 left[TS_LOT_ROOM], right[TS_LOT_ROOM], top[TS_LOT_ROOM], bottom[TS_LOT_ROOM];
	u32 texel[TS_LOT_ROOM], mask[TS_LOT_ROOM];
} ts_lot_half;

typedef struct {
	u32 n;
	u32 node[TS_LOT_ROOM], view[TS_LOT_ROOM], step[TS_LOT_ROOM], mine[TS_LOT_ROOM];
	f32 x[TS_LOT_ROOM], y[TS_LOT_ROOM], z[TS_LOT_ROOM]; /* from the middle of the views to that of the node */
	f32 node_radius[TS_LOT_ROOM], view_radius[TS_LOT_ROOM];
	u32 node_leaf[TS_LOT_ROOM], view_leaf[TS_LOT_ROOM];
	f32 axis_x[TS_LOT_ROOM], axis_y[TS_LOT_ROOM], axis_z[TS_LOT_ROOM], cosine[TS_LOT_ROOM], sine[TS_LOT_ROOM];
	u32 views[TS_LOT_ROOM];
	u32 split[TS_LOT_ROOM], rendered[TS_LOT_ROOM]; /* 1: it is; split is 2 if it is the views' node that is split */
	u32 depth[TS_LOT_ROOM];                        /* bits of the distance */
	u32 middle[TS_LOT_ROOM];                       /* the texel of the node's middle, for view_map.texel=point */
	ts_lot_half half[2];
} ts_pair_lot;

/* Makes a lot of rows, which have no more than TS_LOT_PAIRS pairs. */
void ts_pair_lot_lay(ts_pair_lot *lot, const ts_lot_job *job, const ts_pair_row *row, u32 n_rows);
/* Decides the pairs, sets `split` and `rendered`, and counts those that are `mine`. */
void ts_pair_lot_decide(ts_pair_lot *lot, const ts_lot_job *job, ts_pair_counts *counts);
/* Whether a node fills the texels of its caps, at least where it is wide. */
static inline bool ts_lot_fills(const ts_pyramid *pyramid) { return pyramid->point == 0 || pyramid->fill > 0; }
/* Sets what is needed to render pairs: depths; for view_map.texel=point middles; halves if ts_lot_fills. */
void ts_pair_lot_place(ts_pair_lot *lot, const ts_lot_job *job);

#endif

/* What methods of many views answer to the probe, and what its parts share. */
#ifndef TS_VIEWS_TOOLS_PROBE_H
#define TS_VIEWS_TOOLS_PROBE_H
#include "../../../kernels/views/view_map_fuse.h"
#include "../../../kernels/views/traverse.h"
#include "../../../kernels/views/vpl.h"
#include "../../../kernels/views/vpl_gather.h"
#include "../../raster/tools/probe.h"

/* ---- answers ---- */
/* A pixel's irradiance from virtual point lights or particles: what culling leaves, what is drawn (probe_views.c), what
 * the filter makes of that (probe_filter.c). */
ts_status ts_probe_views_pixel(ts_probe *probe, const ts_probe_question *question, json_t *object);
ts_status ts_probe_filter(ts_probe *probe, const ts_probe_seen *at, json_t *object, f32 irradiance[3]);
/* Texels of half the map of a node of views, or of a light's leaf: the pairs of nodes that were rendered into it, by
 * what tests, and what fusion made of them, for each of the nodes of views from the root down (probe_map.c). */
extern const ts_probe_view ts_probe_map_of_light, ts_probe_map_of_node;
ts_status ts_probe_light_texel(ts_probe *probe, const ts_probe_question *question, json_t *object);
ts_status ts_probe_node_texel(ts_probe *probe, const ts_probe_question *question, json_t *object);

/* ---- virtual point lights (probe_vpl.c) ---- */
typedef struct {
	ts_vpl_gather_args args;
	ts_gpixel pixel;      /* of the G-buffer */
	ts_vpl_args vpl;      /* indirect light: where its paths come from, of which there are n_paths */
	ts_probe_lamps lamps; /* and the lamps whose light they carry on */
	u32 *paths;           /* NULL: particles, which have none */
	u64 n_paths;
} ts_probe_gather;

/* The paths that virtual point lights stand on. */
ts_status ts_probe_read_paths(ts_probe *probe, ts_probe_gather *gather);
/* Puts a virtual point light or particle: where it comes from, what it sends to the pixel, and what its map answers. */
ts_status ts_probe_vpl(ts_probe *probe, json_t *object, const ts_probe_gather *gather, u32 view);

/* ---- pairs of nodes (probe_pair.c) ---- */
/* The nodes of views from the root to one of them, each the parent of the next, with their maps alone. */
enum { TS_PROBE_LEVELS = 12 };
typedef struct {
	u32 n, id[TS_PROBE_LEVELS];
	ts_node nodes[TS_PROBE_LEVELS];
	u64 *texels;
	ts_view_map_fuse_args args;
} ts_probe_chain;

/* Reads the chain to a node. Release by free() of texels, also on failure. */
ts_status ts_probe_read_chain(ts_probe *probe, ts_probe_chain *chain, u32 node);
/* What a node of the chain has of its own in a texel. */
u64 ts_probe_own_key(const ts_probe_chain *chain, u32 i, u32 texel);
/* Puts a pair of nodes that is in a map: what decided that, by numbers. */
void ts_probe_put_decision(ts_probe *probe, json_t *object, const ts_traverse_args *how, u64 pair);
/* Puts the pair of nodes that a texel of the whole map of a node of views shows. */
ts_status ts_probe_put_pair(ts_probe *probe, json_t *object, u32 node, u32 texel);

#endif

/* Answers of the probe about methods of many views, and functions that its parts share. */
#ifndef TS_METHODS_VIEWS_TOOLS_PROBE_H
#define TS_METHODS_VIEWS_TOOLS_PROBE_H
#include "kernels/views/traverse.h"
#include "kernels/views/view_map_fuse.h"
#include "kernels/views/vpl.h"
#include "kernels/views/vpl_gather.h"
#include "methods/raster/tools/probe.h"

/* ---- answers ---- */
/* A pixel's irradiance from virtual point lights or particles: the lights that culling leaves, those that are drawn
 * (probe_views.c), and the result of the filter (probe_filter.c). */
ts_status ts_probe_views_pixel(ts_probe *probe, const ts_probe_question *question, json_t *object);
ts_status ts_probe_filter(ts_probe *probe, const ts_probe_seen *at, json_t *object, f32 irradiance[3]);
/* Texels of half the map of a node of views, or of a light's leaf: the pairs of nodes that were rendered into the
 * texel, the tests that decided, and the result of fusion, for each node of views from the root down (probe_map.c). */
extern const ts_probe_view ts_probe_map_of_light, ts_probe_map_of_node;
ts_status ts_probe_light_texel(ts_probe *probe, const ts_probe_question *question, json_t *object);
ts_status ts_probe_node_texel(ts_probe *probe, const ts_probe_question *question, json_t *object);

/* ---- virtual point lights (probe_vpl.c) ---- */
typedef struct {
	ts_vpl_gather_args args;
	ts_gpixel pixel;      /* of the G-buffer */
	ts_vpl_args vpl;      /* indirect light: the source of its n_paths paths */
	ts_probe_lamps lamps; /* the lamps whose light the paths carry */
	u32 *paths;           /* NULL: particles, which have no paths */
	u64 n_paths;
} ts_probe_gather;

/* Reads the paths of virtual point lights. */
ts_status ts_probe_read_paths(ts_probe *probe, ts_probe_gather *gather);
/* Puts a virtual point light or particle: its origin, the light that it sends to the pixel, and the answer of its
 * map. */
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
/* The key of a node's own map in a texel. */
u64 ts_probe_own_key(const ts_probe_chain *chain, u32 i, u32 texel);
/* Puts a pair of nodes that is in a map, with the numbers that decided it. */
void ts_probe_put_decision(ts_probe *probe, json_t *object, const ts_traverse_args *how, u64 pair);
/* Puts the pair of nodes that a texel of the fused map of a node of views shows. */
ts_status ts_probe_put_pair(ts_probe *probe, json_t *object, u32 node, u32 texel);

#endif

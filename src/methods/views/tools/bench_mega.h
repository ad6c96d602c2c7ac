/* Figures that tables of MegaViews share: of MegaViews and ManyLoDs as X grows. Each table has its own X. */
#ifndef TS_METHODS_VIEWS_TOOLS_BENCH_MEGA_H
#define TS_METHODS_VIEWS_TOOLS_BENCH_MEGA_H
#include "methods/views/tools/tools.h"

/* Variants. */
enum { M_MEGA, M_LODS };

enum {
	X,
	MS,
	LODS_MS,
	SPEEDUP,
	MS_GROWTH,
	LODS_MS_GROWTH,
	PAIRS,
	LODS_PAIRS,
	SAVED,
	PAIRS_GROWTH,
	SERVED,
	RENDERED,
	SHARING,
	SHARING_GROWTH,
	WIDER,
	WIDER_SHARE,
	SEVERAL,
	SEVERAL_SHARE,
	QUEUE_MIB,
	MAPS_MIB,
	LODS_QUEUE_MIB,
	LODS_MAPS_MIB,
	MAPS_LESS,
	RMSE,
	EMPTY
};

/* clang-format off */
#define TS_MEGA_FIGURES \
	[MS] = { "megaviews_ms", "MegaViews", TS_FIGURE_STAGE_TIME, M_MEGA, 0, 2, "view_map,view_map.fuse" }, \
	[LODS_MS] = { "manylods_ms", "ManyLoDs", TS_FIGURE_STAGE_TIME, M_LODS, 0, 2, "view_map,view_map.fuse" }, \
	[SPEEDUP] = { "speedup", "ManyLoDs / MegaViews", TS_FIGURE_RATIO, LODS_MS, MS, 2, "" }, \
	[MS_GROWTH] = { "ms_exponent", "exponent", TS_FIGURE_GROWTH, MS, X, 3, "" }, \
	[LODS_MS_GROWTH] = { "manylods_ms_exponent", "ManyLoDs'", TS_FIGURE_GROWTH, LODS_MS, X, 3, "" }, \
	[PAIRS] = { "pairs", "pairs", TS_FIGURE_COUNTER, M_MEGA, 0, TS_WHOLE, "pairs" }, \
	[LODS_PAIRS] = { "manylods_pairs", "ManyLoDs'", TS_FIGURE_COUNTER, M_LODS, 0, TS_WHOLE, "pairs" }, \
	[SAVED] = { "pairs_ratio", "by ours", TS_FIGURE_RATIO, LODS_PAIRS, PAIRS, 2, "" }, \
	[PAIRS_GROWTH] = { "pairs_exponent", "exponent", TS_FIGURE_GROWTH, PAIRS, X, 3, "" }, \
	[SERVED] = { "served", "views served", TS_FIGURE_COUNTER, M_MEGA, 0, TS_WHOLE, "views served" }, \
	[RENDERED] = { "rendered", "rendered", TS_FIGURE_COUNTER, M_MEGA, 0, TS_WHOLE, "pairs rendered" }, \
	[SHARING] = { "sharing", "views a pair", TS_FIGURE_RATIO, SERVED, RENDERED, 2, "" }, \
	[SHARING_GROWTH] = { "sharing_exponent", "exponent", TS_FIGURE_GROWTH, SHARING, X, 3, "" }, \
	[WIDER] = { "wider", "wider than a texel", TS_FIGURE_COUNTER, M_MEGA, 0, TS_WHOLE, "pairs wider than a texel" }, \
	[WIDER_SHARE] = { "wider_percent", "wider, %", TS_FIGURE_PERCENT, WIDER, RENDERED, 2, "" }, \
	[SEVERAL] = { "wider_several", "of several views", TS_FIGURE_COUNTER, M_MEGA, 0, TS_WHOLE, \
	  "of these of several views" }, \
	[SEVERAL_SHARE] = { "wider_several_percent", "of several views, %", TS_FIGURE_PERCENT, SEVERAL, RENDERED, 2, "" }, \
	[QUEUE_MIB] = { "queue_mib", "longest step, MiB", TS_FIGURE_MEMORY, M_MEGA, 8, 1, "longest queue" }, \
	[MAPS_MIB] = { "maps_mib", "maps, MiB", TS_FIGURE_BUFFERS, M_MEGA, 0, 1, "view_map,view_map.fuse" }, \
	[LODS_QUEUE_MIB] = { "manylods_queue_mib", "ManyLoDs' step", TS_FIGURE_MEMORY, M_LODS, 8, 1, "longest queue" }, \
	[LODS_MAPS_MIB] = { "manylods_maps_mib", "maps", TS_FIGURE_BUFFERS, M_LODS, 0, 1, "view_map,view_map.fuse" }, \
	[MAPS_LESS] = { "maps_ratio", "by ours", TS_FIGURE_RATIO, LODS_MAPS_MIB, MAPS_MIB, 2, "" }, \
	[RMSE] = { "rmse", "RMSE to ManyLoDs'", TS_FIGURE_RMSE, M_MEGA, M_LODS, 3, "" }

/* For tables whose look is ts_empty_share. */
#define TS_MEGA_EMPTY [EMPTY] = { "empty_percent", "empty, %", TS_FIGURE_LOOKED, M_MEGA, 0, 1, "" }
/* clang-format on */

#endif

/* `bench speed` of many views: MegaViews against ManyLoDs, 131,072 paths of light, as in `bench mega-10`. The paper's
 * ratio is 10 at a million views. */
#include "methods/views/tools/tools.h"

/* clang-format off */
static const ts_speed_scene scenes[] = {
	{ "V", "atrium", NULL, "indirect", "megaviews,manylods",
	  "width=320,height=180,reflectors.count=0,octree.levels=7,rsm.px=1024,vpl.paths=131072", false, false },
	{ 0 },
};

#define TIME(method, stages) { TS_SPEED_TIME, "V", method, stages, NULL }
#define VIEWS "view_map,view_map.fuse"
#define GATHERING "vpl_gather.pairs,vpl_gather"

static const ts_speed_figure figures[] = {
	{ "ManyLoDs' maps by MegaViews'", "times", 1, 2, TIME("manylods", VIEWS), TIME("megaviews", VIEWS), TS_SPEED_LEAST,
	  10 },
	{ "the same of frames", "times", 1, 2, TIME("manylods", ""), TIME("megaviews", ""), TS_SPEED_SHOWN, 0 },
	{ "gathering, of MegaViews' frame", "%", 100, 1, TIME("megaviews", GATHERING), TIME("megaviews", ""),
	  TS_SPEED_SHOWN, 0 },
	{ 0 },
};
/* clang-format on */

const ts_speed_of ts_views_speed = {.scenes = scenes, .figures = figures};

/* `bench speed` of surfels: how many per second, and that those near an eye cost no more per fragment. NV40 drew 23
 * million per second. */
#include "methods/surfels/tools/tools.h"

/* clang-format off */
#define SAMPLED "surfels.from_mesh=300000"
static const ts_speed_scene scenes[] = {
	{ "dragon", "", "dragon_splats.glb", "surfels", "deferred", "eye.distance=outside", false, false },
	{ "court", "atrium", NULL, "surfels", "deferred", SAMPLED, false, false },
	{ "outside", "atrium", NULL, "surfels", "deferred", SAMPLED ",eye.distance=outside", false, false },
	{ 0 },
};

#define RATE(scene, bound, goal) \
	{ "surfels, " scene, "M/s", 1e-6, 2, { TS_SPEED_SURFELS, scene, NULL, "", NULL }, \
	  { TS_SPEED_TIME, scene, "deferred", "", NULL }, bound, goal }
#define EACH(scene) { TS_SPEED_CORES, scene, "deferred", "", "fragments" }

static const ts_speed_figure figures[] = {
	RATE("dragon", TS_SPEED_LEAST, 10), RATE("court", TS_SPEED_SHOWN, 0), RATE("outside", TS_SPEED_SHOWN, 0),
	{ "a fragment, dragon", "ns of a core", 1e9, 0, EACH("dragon"), { TS_SPEED_ONE, "", NULL, "", NULL },
	  TS_SPEED_SHOWN, 0 },
	{ "a fragment, court", "ns of a core", 1e9, 0, EACH("court"), { TS_SPEED_ONE, "", NULL, "", NULL },
	  TS_SPEED_SHOWN, 0 },
	{ "a fragment of the court by the dragon's", "times", 1, 2, EACH("court"), EACH("dragon"), TS_SPEED_MOST, 3 },
	{ "the same by the court's from outside", "times", 1, 2, EACH("court"), EACH("outside"), TS_SPEED_MOST, 3 },
	{ 0 },
};
/* clang-format on */

const ts_speed_of ts_surfels_speed = {.scenes = scenes, .figures = figures};

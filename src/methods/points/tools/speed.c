/* `bench speed` of points, compared with standard rasterization. Goals: EPR's views in the time of rays, and at most
 * three times that of as many bare points; equal faces by either method in the same time; MVR's faces at most twice as
 * long as an occlusion rasterizer without ids, which took 0.44, 1.16 and 1.20 times Embree's time. */
#include "methods/points/tools/benches.h"

/* The stages that make points, and those that fill off-screen views as well. */
#define POINT_STAGES "visibility,offscreen.visibility,split,split.views,split.shadow,cull,align,points.count,points"
#define MAP_STAGES \
	POINT_STAGES \
	",splat,scatter,scatter.colour,environment_map,cube_face,depth_map,shadow_cube_size,shadow_splat"

/* clang-format off */
#define FIXED "cube.px="
#define MIRRORS "reflectors.count="
#define MAPS "reflectors.count=0,lamp.views="

static const ts_speed_scene scenes[] = {
	{ "S", "", "sponza.glb", "reflections", "epr,mvr", MIRRORS "10," FIXED "256", true, true },
	{ "A", "atrium:triangles=262144", NULL, "reflections", "epr,mvr", MIRRORS "50," FIXED "128", true, true },
	{ "M", "atrium:triangles=1M", NULL, "reflections", "epr,mvr", MIRRORS "10," FIXED "256", true, true },
	{ "A300", "atrium:triangles=262144", NULL, "reflections", "epr,mvr", MIRRORS "300," FIXED "64", true, false },
	{ "paper", "atrium:triangles=262144", NULL, "reflections", "epr,mvr", MIRRORS "50", false, false },
	{ "L32", "atrium:triangles=262144", NULL, "soft-shadows", "ivir,mvr", MAPS "32", true, false },
	{ "L128", "atrium:triangles=262144", NULL, "soft-shadows", "ivir,mvr", MAPS "128", false, false },
	{ 0 },
};

#define FACES "cube_face"
#define SCATTERING "scatter," POINT_STAGES
#define TIME(scene, method, stages) { TS_SPEED_TIME, scene, method, stages, NULL }
#define CORES(scene, method, stages) { TS_SPEED_CORES, scene, method, stages, NULL }
#define COUNT(scene, method, counter) { TS_SPEED_COUNT, scene, method, counter, NULL }
#define OF(kind, scene) { kind, scene, NULL, "", NULL }
#define ONE { TS_SPEED_ONE, "", NULL, "", NULL }

#define OF_SCENE(name, rasterizer) \
	{ "EPR's views by Embree's rays, " name, "times", 1, 2, TIME(name, "epr", MAP_STAGES), \
	  OF(TS_SPEED_RAYS, name), TS_SPEED_MOST, 1 }, \
	{ "EPR's views by bare points, as many, " name, "times", 1, 2, TIME(name, "epr", MAP_STAGES), \
	  OF(TS_SPEED_POINTS, name), TS_SPEED_MOST, 3 }, \
	{ "MVR's faces by Embree's rays, " name, "times", 1, 2, TIME(name, "mvr", FACES), OF(TS_SPEED_RAYS, name), \
	  TS_SPEED_MOST, rasterizer }, \
	{ "MVR's frame by EPR's, equal faces, " name, "times", 1, 2, TIME(name, "mvr", ""), TIME(name, "epr", ""), \
	  TS_SPEED_LEAST, 1 }, \
	{ "scatters of EPR's splat, " name, "M/s and core", 1e-6, 1, COUNT(name, "epr", "texel writes"), \
	  CORES(name, "epr", "splat"), TS_SPEED_SHOWN, 0 }, \
	{ "the same, of prefetched minima in such a face, " name, "%", 100, 1, \
	  { TS_SPEED_MINIMA, name, "epr", "texel writes", NULL }, TIME(name, "epr", "splat"), TS_SPEED_LEAST, 50 }, \
	{ "EPR's texel writes as bare minima, by Embree's rays, " name, "times", 1, 2, \
	  { TS_SPEED_MINIMA, name, "epr", "texel writes", NULL }, OF(TS_SPEED_RAYS, name), TS_SPEED_SHOWN, 0 }, \
	{ "casting of truths, of Embree's rate, " name, "%", 100, 1, OF(TS_SPEED_RAYS, name), \
	  { TS_SPEED_CASTING, name, "epr", "", NULL }, TS_SPEED_LEAST, 90 }, \
	{ "Embree's rays, " name, "M/s", 1e-6, 1, OF(TS_SPEED_TEXELS, name), OF(TS_SPEED_RAYS, name), TS_SPEED_SHOWN, 0 }, \
	{ "shading a texel, MVR's illuminate, " name, "ns of a core", 1e9, 0, CORES(name, "mvr", "illuminate"), \
	  COUNT(name, "mvr", "cube texels"), TS_SPEED_MOST, 86 }, \
	{ "shading a pixel, MVR's image, " name, "ns of a core", 1e9, 0, CORES(name, "mvr", "image"), \
	  OF(TS_SPEED_PIXELS, name), TS_SPEED_MOST, 106 }, \
	{ "shading a point, EPR's shade, " name, "ns of a core", 1e9, 0, CORES(name, "epr", "shade"), \
	  COUNT(name, "epr", "distinct points shaded"), TS_SPEED_MOST, 317 }

#define OF_MAPS(name, maps) \
	{ "MVR's maps by iVIR's, " maps, "times", 1, 2, TIME(name, "mvr", "depth_map"), TIME(name, "ivir", SCATTERING), \
	  TS_SPEED_SHOWN, 0 }, \
	{ "MVR's frame by iVIR's, " maps, "times", 1, 2, TIME(name, "mvr", ""), TIME(name, "ivir", ""), TS_SPEED_LEAST, 1 }

static const ts_speed_figure figures[] = {
	OF_SCENE("S", 0.875), OF_SCENE("A", 2.33), OF_SCENE("M", 2.39),
	{ "EPR's views of 300 mirrors of 64² by 50 of 128²", "times", 1, 2, TIME("A300", "epr", MAP_STAGES),
	  TIME("A", "epr", MAP_STAGES), TS_SPEED_MOST, 3 },
	{ "MVR's frame of 512² by EPR's of adaptive faces", "times", 1, 2, TIME("paper", "mvr", ""),
	  TIME("paper", "epr", ""), TS_SPEED_SHOWN, 0 },
	{ "32 depth maps by Embree's rays", "times", 1, 2, TIME("L32", "mvr", "depth_map"), OF(TS_SPEED_RAYS, "L32"),
	  TS_SPEED_MOST, 1 },
	OF_MAPS("L32", "32"), OF_MAPS("L128", "128"),
	{ "iVIR's scatter of 128 maps by 32", "times", 1, 2, TIME("L128", "ivir", "scatter"),
	  TIME("L32", "ivir", "scatter"), TS_SPEED_MOST, 5 },
	{ 0 },
};

#define ATRIUM "atrium:triangles=262144"
static const ts_speed_growth growths[] = {
	{ "triangles", "atrium:triangles=", "", "10k,100k,1M,4M", "reflections", "epr,mvr", MIRRORS "10," FIXED "256",
	  MAP_STAGES, "views" },
	{ "mirrors", ATRIUM, "reflectors.count", "1,10,50,300", "reflections", "epr,mvr", FIXED "64", MAP_STAGES,
	  "views" },
	{ "maps", ATRIUM, "lamp.views", "1,8,32,128", "soft-shadows", "ivir,mvr", MIRRORS "0", MAP_STAGES, "maps" },
	{ "pixels", ATRIUM, "size", "480x270,960x540,1920x1080,3840x2160", "reflections", "epr,mvr",
	  MIRRORS "10," FIXED "256", MAP_STAGES, "views" },
	{ "threads", ATRIUM, "threads", "1,2,4,8,16,32,64,128", "reflections", "epr,mvr", MIRRORS "10," FIXED "256",
	  MAP_STAGES, "views" },
	{ 0 },
};
/* clang-format on */

const ts_speed_of ts_points_speed = {.scenes = scenes, .figures = figures, .growths = growths};

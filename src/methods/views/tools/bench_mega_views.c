/* MegaViews compared with ManyLoDs for views that are less clustered than those of figure 10: of four bounces; and
 * anywhere in the air, the paper's particles (section 5.2). */
#include "methods/views/tools/bench_mega.h"

#define MILLION X, 800e3, 1e9
#define ALL TS_NO_FIGURE, 0, 0

/* clang-format off */
static const ts_bench_variant variants[] = {
	[M_MEGA] = { "megaviews", "", true, TS_TIMED },
	[M_LODS] = { "manylods", "", true, TS_TIMED },
	{ 0 },
};

/* Two parts of a table; the last rows are figures of the first part. */
#define PARTS(key, title, ...) { \
	{ key, title ": maps, ms; exponents of views since the row above", { __VA_ARGS__, LODS_MS, SPEEDUP, MS_GROWTH, \
	  LODS_MS_GROWTH, RMSE, TS_NO_FIGURE } }, \
	{ key "_pairs", "Pairs, and ManyLoDs'", { PAIRS, LODS_PAIRS, SAVED, PAIRS_GROWTH, SHARING, SHARING_GROWTH, \
	  WIDER_SHARE, SEVERAL_SHARE, EMPTY, TS_NO_FIGURE } }, \
	{ key "_mib", "Memory", { QUEUE_MIB, MAPS_MIB, LODS_QUEUE_MIB, LODS_MAPS_MIB, MAPS_LESS, TS_NO_FIGURE } }, \
	{ 0 } \
}

#define GROWTH \
	{ "pairs grow slower than views: exponent", PAIRS_GROWTH, TS_AT_MOST, 0, 1, ALL, \
	  TS_ELSEWHERE "few leaves have several views; see octree.levels", SHARING }, \
	{ "views that share a pair, from row to row", SHARING, TS_GROWS, 1, 0, ALL, \
	  TS_ELSEWHERE "few leaves have several views; see octree.levels", SHARING }

static const ts_paper_plot plot = { "views", "maps, ms", X, { MS, LODS_MS, TS_NO_FIGURE }, true };

/* Four bounces. */
static const ts_bench_figure bounce_figures[] = {
	[X] = { "views", "views", TS_FIGURE_COUNTER, M_MEGA, 0, TS_WHOLE, "virtual point lights" }, TS_MEGA_FIGURES,
	TS_MEGA_EMPTY, { 0 },
};

static const ts_paper_part bounce_parts[] = PARTS("mega_10_bounces", "MegaViews, figure 10, four bounces", X, MS);

static const ts_paper_relation bounce_relations[] = {
	{ "time of ManyLoDs / MegaViews, a million views", SPEEDUP, TS_AT_LEAST, 10, 0, MILLION,
	  TS_ELSEWHERE "fewer views share a leaf; see octree.levels", SHARING },
	GROWTH, { 0 },
};

/* Means over four scenes. */
static const ts_paper_row bounce_rows[] = {
	{ "four scenes", "atrium", "sponza", 262144, { [SPEEDUP] = 10, [MAPS_LESS] = 10 } },
	{ 0 },
};

const ts_paper_table ts_mega_10_bounces = {
	.name = "mega-10-bounces", .title = "MegaViews, figure 10, four bounces", .effect = "indirect", .scenes = "atrium",
	.objects_head = "paths", .objects_param = "vpl.paths", .objects = "64,256,1024", .most = 1 << 22,
	.set = "reflectors.count=0,vpl.bounces=4", .defaults = "octree.levels=7,rsm.px=1024",
	.size = "width=320,height=180", .timed = true,
	.note = "A path leaves up to four views; the paper has 256K paths, and 11 levels.", .variants = variants,
	.look = ts_empty_share, .figures = bounce_figures, .parts = bounce_parts, .relations = bounce_relations,
	.plot = &plot, .rows = bounce_rows,
};

/* Particles. */
static const ts_bench_figure particle_figures[] = {
	[X] = { "views", "views", TS_FIGURE_PARAM, M_MEGA, 0, TS_WHOLE, "particle.count" }, TS_MEGA_FIGURES,
	TS_MEGA_EMPTY, { 0 },
};

static const ts_paper_part particle_parts[] = PARTS("mega_particles", "MegaViews, particles", MS);

static const ts_paper_relation particle_relations[] = {
	{ "time of ManyLoDs / MegaViews, 65,536 views", SPEEDUP, TS_BETWEEN, 1.5, 2.5, X, 60000, 70000,
	  TS_ELSEWHERE "leaves are larger, so that more views share them; see octree.levels", SHARING },
	{ "empty texels, %", EMPTY, TS_BETWEEN, 25, 35, ALL,
	  TS_ELSEWHERE "12.5 are outside the discs; of the rest those to the sky and into walls; see view_map.texel",
	  EMPTY },
	GROWTH, { 0 },
};

static const ts_paper_row particle_rows[] = {
	{ "San Miguel", "atrium", "sponza", 4096, { [MS] = 21 } },
	{ "San Miguel", "atrium", "sponza", 65536, { [MS] = 184, [SPEEDUP] = 2 } },
	{ 0 },
};

const ts_paper_table ts_mega_particles = {
	.name = "mega-particles", .title = "MegaViews, particles", .effect = "particles", .scenes = "atrium",
	.objects_head = "particles", .objects_param = "particle.count", .objects = "256,1024,4096", .most = 1 << 24,
	.set = "reflectors.count=0", .defaults = "octree.levels=7,view_map.texel=point", .size = "width=320,height=180",
	.timed = true, .note = "Nothing is culled. Texels are the paper's. The paper has 4,096 and 65,536, and 11 levels.",
	.look = ts_empty_share, .variants = variants,
	.figures = particle_figures, .parts = particle_parts, .relations = particle_relations,
	.plot = &plot, .rows = particle_rows,
};
/* clang-format on */

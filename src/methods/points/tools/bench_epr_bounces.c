/* EPR's figure 5: deferred shading of one, two and three bounces between two cylinders that face each other, 25 samples
 * of the first and 4 of the others. No bounce takes a pass over the geometry. In the long atrium two mirrors are too
 * far apart to be seen in each other: they stand in dining, in a frame that shows both from the side. */
#include "methods/points/tools/benches.h"

/* clang-format off */
static const ts_bench_variant variants[] = {
	{ "epr", "", true, TS_TIMED },
	{ 0 },
};

enum { LOOKUPS, OPS, PASSES, POINTS, MS, FRAME_MS, RMSE, SSIM };

static const ts_bench_figure figures[] = {
	TS_COUNT(LOOKUPS, "lookups", "look-ups", 0, "look-ups"),
	TS_COUNT(OPS, "ops", "shading ops", 0, "shading operations"),
	TS_COUNT(PASSES, "passes", "passes", 0, "geometry traversals"),
	TS_COUNT(POINTS, "points", "points", 0, "points"),
	TS_PART_MS(MS, "deferred_ms", "deferred", 0, "lookup,lookup.second,lookup.third,shade.third,shade.second,shade"),
	TS_MS(FRAME_MS, "ms", "frame", 0),
	TS_RMSE(RMSE, "rmse", "RMSE", 0),
	TS_SSIM(SSIM, "ssim", "SSIM", 0),
	{ 0 },
};

static const ts_paper_part parts[] = {
	{ "epr_5", "EPR, figure 5: two cylinders, work and errors", { LOOKUPS, OPS, PASSES, POINTS, RMSE, SSIM,
	  TS_NO_FIGURE } },
	{ "epr_5_ms", "EPR, figure 5: deferred shading, ms", { MS, FRAME_MS, TS_NO_FIGURE } },
	{ 0 },
};

static const ts_paper_relation relations[] = {
	{ "shading operations, from bounce to bounce", OPS, TS_GROWS, 1, 0, TS_ANY,
	  TS_ELSEWHERE "no mirror sees a mirror; see reflectors.count", LOOKUPS },
	{ "passes over the geometry, most by least", PASSES, TS_STEADY, 0, 1, TS_ANY,
	  TS_OURS "bounces take passes; see lookup.bounces", PASSES },
	{ "RMSE to rays of as many bounces, most by least", RMSE, TS_STEADY, 0, 1.25, TS_ANY,
	  TS_OURS "bounces add errors; see cube.px", OPS },
	{ "deferred shading, from bounce to bounce", MS, TS_GROWS, 1, 0, TS_ANY,
	  TS_ELSEWHERE "no mirror sees a mirror; see reflectors.count", OPS },
	{ 0 },
};

#define ROW(n, ms) { "Sponza", "dining", "sponza", n, { [MS] = ms } }
static const ts_paper_picture pictures[] = { { 0, "epr" }, { 0 } };
static const ts_paper_row rows[] = { ROW(1, 1.64), ROW(2, 2.92), ROW(3, 3.80), { 0 } };

const ts_paper_table ts_epr_5 = {
	.name = "epr-5", .title = "EPR, figure 5: who runs", .effect = "reflections", .scenes = "dining",
	.objects_head = "bounces", .objects_param = "lookup.bounces", .objects = "1,2,3", .most = 3,
	.set = "reflectors.count=2,reflectors.shape=cylinder", .defaults = "reflectors.px=960,eye.turns=2,frame=40",
	.timed = true, .judge = "A", .pictures = pictures, .variants = variants, .figures = figures, .parts = parts,
	.relations = relations, .rows = rows,
};
/* clang-format on */

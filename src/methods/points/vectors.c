/* The primitive of culling (kernels/points/cull.h). */
#include "kernels/points/vectors.h"
#include "vectors/row.h"

WORD_ITEM(cull_fused, ts_max_i32(ts_fix(fmaf(-10.0f, A, 1.0f), 24, 25), 0))

static const f32 cull_edges[] = {0.1f, 0.05f, 0.01f, 0.001f, 0.0999999f, 0x1p-28f};

/* clang-format off */
static const ts_vector culling[] = {
	{ PRIMITIVE(cull_threshold), "29", "fix(1 - 10 pixels, 24, 25), not below 0", { POSITIVE("pixels", 1, 88, 150) },
	  GIVES(I32, 1), { { TS_FAULT_FMA, cull_fused } }, EDGES(cull_edges) },
	{ 0 },
};
/* clang-format on */

static const ts_launch launch = TS_LAUNCH(points_vectors, TS_ALL);

const ts_vector_set ts_points_vectors = {&launch, false, TS_TABLES(culling)};

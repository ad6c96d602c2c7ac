/* Composites of hulls (kernels/hulls/composites.h). */
#include "kernels/hulls/composites.h"
#include "vectors/relate.h"

enum { PATCH_NORMAL = 9, GATHER_P = 16 };

/* Places before the triangle, behind it, near its plane, and at its corners. */
static void relate_gather(u32 *in, u32 random)
{
	u32 *a = in, *b = in + 3, *c = in + 6, *p = in + GATHER_P;
	ts_relate_triangle(a, b, c, &random);
	ts_v3 pa = ts_row_v3(a, 0), ab = ts_sub(ts_row_v3(b, 0), pa), ac = ts_sub(ts_row_v3(c, 0), pa);
	ts_relate_v3(in + PATCH_NORMAL, ts_normalize(ts_cross(ab, ac)));
	ts_v3 n = ts_relate_unit(in + PATCH_NORMAL);
	f32 height = ts_dot(n, ts_sub(ts_row_v3(p, 0), pa)), up = ts_uniform(ts_more(&random));
	u32 k = (ts_more(&random) >> 8) % 8;
	if (k == 0) memcpy(p, b, 3 * sizeof *p);
	if (k < 5 && k > 0 && height < 0) ts_relate_v3(p, ts_mad(ts_row_v3(p, 0), n, -2 * height));
	if (k > 5) ts_relate_v3(p, ts_mad(ts_mad(pa, ab, up), n, ts_length(ab) * (0.5f * up)));
}

enum { FIT_DIRECTIONS = 1 };

/* A sum of directions that is at most as long as the sum of weights. */
static void relate_fit(u32 *in, u32 random)
{
	f32 m = ts_row_f32(in, 0), r = ts_uniform(ts_more(&random));
	u32 k = (ts_more(&random) >> 8) % 16;
	r = k == 0 ? 1 : k == 1 ? 0 : k == 2 ? r * 0.00000095367431640625f : r;
	ts_relate_v3(in + FIT_DIRECTIONS, ts_scale(ts_relate_unit(in + FIT_DIRECTIONS), m * r));
}

enum { LOBES_WORDS = 16, LOBES_PHI = 6, SHARES = 64 };

static void relate_lobes(u32 *in, u32 random)
{
	f32 sum = 0;
	for (u32 k = 0; k < 12; k++) {
		u32 *phi = in + k / 3 * LOBES_WORDS + LOBES_PHI + k % 3 * 3;
		ts_relate_unit(phi);
		if (ts_once_in(&random, 16)) ts_relate_v3(phi, ts_v3_make(0, 0, 0));
		if (ts_once_in(&random, 8)) ts_relate_f32(in + k / 3 * LOBES_WORDS + k % 3, 0);
	}
	for (u32 k = 0; k < 4; k++) sum += ts_row_f32(in, SHARES + k);
	for (u32 k = 0; k < 4; k++) ts_relate_f32(in + SHARES + k, sum > 0 ? ts_row_f32(in, SHARES + k) / sum : 0.25f);
}

static void relate_irradiance(u32 *in, u32 random)
{
	ts_v3 phi = ts_relate_unit(in + 2);
	ts_relate_unit(in + 5);
	u32 k = (ts_more(&random) >> 8) % 16;
	if (k == 0) ts_relate_v3(in + 5, phi);
	if (k == 1) ts_relate_v3(in + 5, ts_neg(phi));
	if (k == 2) ts_relate_across(in + 5, phi);
}

static void relate_lamp(u32 *in, u32 random)
{
	ts_relate_unit(in + 3);
	if (ts_once_in(&random, 8)) ts_relate_v3(in + 3, ts_v3_make(0, (random & 256) != 0 ? 1 : -1, 0));
}

/* clang-format off */
#define SPHERE(name) { name, TS_VECTOR_F32, 9, 88, 127, true }
#define SHARP(name, count) POSITIVE(name, count, 107, 140)
#define LOBES(name) LENGTH(name ".mu", 3), SHARP(name ".lambda", 3), SPHERE(name ".phi"), ZERO(name ".pad", 1)
#define LOBE_OUT COLUMN("mu", F32, 1), COLUMN("lambda", F32, 1), COLUMN("phi", F32, 3)

static const ts_vector gathered[] = {
	{ PRIMITIVE(gather), "ts_k_gather",
	  "weights w, and weights times direction, that a corner of a box at p gathers of a triangle of light",
	  { NEAR("patch.a", 3), NEAR("patch.b", 3), NEAR("patch.c", 3), UNIT("patch.normal"), LENGTH("patch.exitance", 3),
	    ZERO("patch.pad", 1), WORLD("p", 3), FLAG("ramp") },
	  { COLUMN("w", F32, 3), COLUMN("red", F32, 3), COLUMN("green", F32, 3), COLUMN("blue", F32, 3) },
	  .relate = relate_gather },
	{ PRIMITIVE(lobe_fit), "ts_k_fit",
	  "lobe of weights whose sum is m; vmf 0: Toksvig's sharpness, 1: von Mises-Fisher's",
	  { LENGTH("m", 1), { "directions", TS_VECTOR_F32, 3, 88, 131, true }, FLAG("vmf") }, { LOBE_OUT },
	  .relate = relate_fit },
	{ PRIMITIVE(hull_lobe), "ts_k_lobe_of_lobes", "a channel's lobe, interpolated between the four corners of a box",
	  { LOBES("0"), LOBES("1"), LOBES("2"), LOBES("3"), SHARE("shares", 4), UNSIGNED("channel", 1, 0, 2) },
	  { LOBE_OUT }, .relate = relate_lobes },
	{ PRIMITIVE(lobe_irradiance), "ts_k_lobe_irradiance",
	  "irradiance of a surface with normal n by a lobe; method and printed as in sg_cosine",
	  { LENGTH("mu", 1), SHARP("lambda", 1), UNIT("phi"), UNIT("n"),
	    UNSIGNED("method", 1, TS_COSINE_OURS, TS_COSINE_QUADRATURE), FLAG("printed") }, GIVES(F32, 1),
	  .relate = relate_irradiance },
	{ PRIMITIVE(lamp_triangle), "ts_k_polygon_disc, ts_k_polygon_ball", "triangle k of a disc or of a ball of radius r",
	  { NEAR("p", 3), UNIT("n"), LENGTH("r", 1), UNSIGNED("k", 1, 0, 7), FLAG("ball") },
	  { COLUMN("a", F32, 3), COLUMN("b", F32, 3), COLUMN("c", F32, 3), COLUMN("normal", F32, 3),
	    COLUMN("exitance", F32, 3), COLUMN("pad", U32, 1) }, .relate = relate_lamp },
	{ 0 },
};
/* clang-format on */

static const ts_launch launch = TS_LAUNCH(hulls_composites, TS_ALL);

const ts_vector_set ts_hulls_composites_vectors = {&launch, true, TS_TABLES(gathered)};

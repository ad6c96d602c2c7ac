/* Composites of MegaViews and ManyLoDs (kernels/views/composites.h). */
#include "kernels/views/composites.h"
#include "vectors/relate.h"

/* Along an axis, across the border between the two maps, no direction. */
static void relate_direction(u32 *in, u32 random)
{
	u32 k = (ts_more(&random) >> 8) % 16;
	if (k == 0) in[0] = 0;
	if (k == 1) in[1] = in[2] = 0;
	if (k == 2) in[0] = in[1] = in[2] = 0;
	if (k == 3) in[2] = in[1];
}

static void relate_texel(u32 *in, u32 random)
{
	(void)random;
	in[0] %= 2 * in[1] * in[1];
}

/* A cosine, and balls that barely exclude the eye. */
static void relate_size(u32 *in, u32 random)
{
	for (u32 k = 0; k < 2; k++) ts_relate_f32(in + k, ts_min(ts_row_f32(in, k), 1));
	if (ts_once_in(&random, 16)) ts_relate_f32(in + 1, 1);
	if (ts_once_in(&random, 16)) in[0] = 0;
}

enum { NODE_RADIUS = 3, NODE_CHILDREN = 5, OTHER = 8, AXIS = 16, COSINE = 19, PHI = 24, CUTOFF = 30 };

static void relate_node(u32 *node, u32 *random)
{
	f32 power = 1 / (f32)(1u << (ts_more(random) >> 8) % 8);
	ts_relate_f32(node + NODE_RADIUS, ts_max(ts_row_f32(node, NODE_RADIUS), 0.25f) * power);
	if (ts_once_in(random, 3)) node[NODE_CHILDREN] = 0;
}

/* Nodes side by side, one inside the other, and on the border of the cone. */
static void relate_pair(u32 *in, u32 random)
{
	relate_node(in, &random);
	relate_node(in + OTHER, &random);
	ts_v3 axis = ts_relate_unit(in + AXIS);
	f32 theta = 0.5f * ts_uniform(ts_more(&random)), phi = 0.5f * ts_uniform(ts_more(&random));
	ts_relate_f32(in + COSINE, ts_cos_turn(theta));
	ts_relate_f32(in + PHI, ts_cos_turn(phi));
	ts_relate_f32(in + PHI + 1, ts_sin_turn(phi));
	if (ts_once_in(&random, 2)) in[CUTOFF] = 0;
	u32 k = (ts_more(&random) >> 8) % 16;
	if (k == 0) memcpy(in, in + OTHER, 3 * sizeof *in);
	if (k == 1) ts_relate_v3(in, ts_mad(ts_row_v3(in, OTHER), axis, -4));
	if (k == 2) memcpy(in + NODE_RADIUS, in + OTHER + NODE_RADIUS, sizeof *in);
}

enum { CAP_N = 5, CAP_LEVEL = 6, CAP_PLACE = 7 };

/* A map whose side is a power of two, and a place in it. */
static void relate_cap(u32 *in, u32 random)
{
	in[CAP_N] = 1u << (3 + (random >> 8) % 6);
	u32 side = in[CAP_N] >> in[CAP_LEVEL];
	in[CAP_PLACE] %= side;
	in[CAP_PLACE + 1] %= side;
	if (ts_once_in(&random, 16)) ts_relate_f32(in + 3, ts_length(ts_row_v3(in, 0)));
}

enum { LAST = 9, VOXEL = 10 };

/* The greatest voxel of any of the octrees' levels, and voxels in the triangle or beside it. */
static void relate_voxel(u32 *in, u32 random)
{
	in[LAST] = (1u << (1 + (random >> 8) % 11)) - 1;
	u32 most = 256 * (in[LAST] + 1), grain = (ts_more(&random) & 256) != 0 ? 1 : 256;
	for (u32 k = 0; k < 9; k++) in[k] = in[k] % (most + 1) / grain * grain;
	if (ts_once_in(&random, 4)) memcpy(in + 3, in, 3 * sizeof *in);
	if (ts_once_in(&random, 4)) in[6] = in[0];
	u32 s = (ts_more(&random) >> 8) & 255, t = ((ts_more(&random) >> 8) & 255) * (256 - s) / 256;
	for (u32 k = 0; k < 3; k++) {
		i64 at = ((i64)in[k] * (256 - s - t) + (i64)in[3 + k] * s + (i64)in[6 + k] * t) / 65536;
		i64 beside = at + (i64)((ts_more(&random) >> 8) % 5 / 2) - ((random & 64) != 0 ? 1 : 0);
		in[VOXEL + k] = (u32)(beside < 0 ? 0 : beside > (i64)in[LAST] ? (i64)in[LAST] : beside);
	}
}

/* Towards the triangle, its corners, its edges. */
static void relate_cast(u32 *in, u32 random)
{
	ts_relate_triangle(in + 6, in + 9, in + 12, &random);
	ts_v3 a = ts_row_v3(in, 6), ab = ts_sub(ts_row_v3(in, 9), a), ac = ts_sub(ts_row_v3(in, 12), a);
	f32 s = ts_uniform(ts_more(&random)), t = ts_uniform(ts_more(&random));
	u32 k = (ts_more(&random) >> 8) % 8;
	if (k == 0) t = 0;
	if (k == 1) s = t = 0;
	if (k == 2) s = 1 - t;
	if (k < 7) ts_relate_v3(in + 3, ts_sub(ts_mad(ts_mad(a, ab, s), ac, t), ts_row_v3(in, 0)));
	ts_relate_unit(in + 3);
}

enum { FROM = 3, FORM_N = 6 };

/* Lights that send to one side or to all. */
static void relate_form(u32 *in, u32 random)
{
	ts_v3 way = ts_row_v3(in, 0);
	ts_relate_unit(in + FROM);
	ts_relate_unit(in + FORM_N);
	if (ts_dot(way, ts_row_v3(in, FROM)) < 0) ts_relate_v3(in + FROM, ts_neg(ts_row_v3(in, FROM)));
	bool away = ts_dot(way, ts_row_v3(in, FORM_N)) > 0 && !ts_once_in(&random, 4);
	if (away) ts_relate_v3(in + FORM_N, ts_neg(ts_row_v3(in, FORM_N)));
	if (ts_once_in(&random, 4)) ts_relate_v3(in + FROM, ts_v3_make(0, 0, 0));
	if (ts_once_in(&random, 32)) ts_relate_v3(in, ts_v3_make(0, 0, 0));
}

/* clang-format off */
#define NODE(name) NEAR(name ".centre", 3), POSITIVE(name ".radius", 1, 107, 131), ANY_INDEX(name ".child", 1), \
	UNSIGNED(name ".children", 1, 0, 255), ANY_INDEX(name ".parent", 1), UNSIGNED(name ".level", 1, 0, 11)
#define PLACE(name) UNSIGNED(name, 3, 0, 1 << 19)

static const ts_vector maps[] = {
	{ PRIMITIVE(paraboloid_texel), "ts_k_paraboloid_texel",
	  "place in the map that shows direction d, in texels, and its texel",
	  { NEAR("d", 3), UNSIGNED("n", 1, 1, 4096) }, { COLUMN("at", F32, 2), COLUMN("texel", U32, 1) },
	  .relate = relate_direction },
	{ PRIMITIVE(paraboloid_direction), "ts_k_paraboloid_direction", "direction that the middle of a texel shows",
	  { ALL_U32("texel", 1), UNSIGNED("n", 1, 1, 512) }, GIVES(F32, 3), .relate = relate_texel },
	{ PRIMITIVE(paraboloid_size), "ts_k_paraboloid_size", "width of a ball in a map, in texels",
	  { SHARE("cos_alpha", 1), SHARE("sin_rho", 1), UNSIGNED("n", 1, 1, 4096) }, GIVES(F32, 1),
	  .relate = relate_size },
	{ PRIMITIVE(pair_fate), "ts_k_pair_fate",
	  "fate of a node and a node of views: 0 the node splits, 1 the node of views splits, 2 rendered, 3 culled, 4 near",
	  { NODE("node"), NODE("view"), UNIT("cone.axis"), { "cone.cosine", TS_VECTOR_F32, 1, 88, 127, true },
	    ANY_INDEX("cone.first", 1), UNSIGNED("cone.views", 1, 1, UINT32_MAX), ZERO("cone.pad", 2),
	    { "phi.cosine", TS_VECTOR_F32, 1, 88, 127, true }, { "phi.sine", TS_VECTOR_F32, 1, 88, 127, true },
	    UNSIGNED("n", 1, 1, 512), LENGTH("apart", 1), UNSIGNED("last", 1, 0, 12), FLAG("to_last"),
	    LENGTH("cutoff", 1) },
	  GIVES(U32, 1), .relate = relate_pair },
	{ PRIMITIVE(cap_inside), "ts_k_cap_inside", "at least 0 if a texel of a level is in the image of a ball",
	  { NEAR("vs", 3), POSITIVE("radius", 1, 107, 140), FLAG("back"), UNSIGNED("n", 1, 8, 256),
	    UNSIGNED("level", 1, 0, 3), UNSIGNED("column", 1, 0, 255), UNSIGNED("row", 1, 0, 255) },
	  GIVES(F32, 1), .relate = relate_cap },
	{ PRIMITIVE(voxel_touches), "ts_k_touch",
	  "1 if a voxel touches triangle a b c, whose coordinates are in 1/256 of a voxel",
	  { PLACE("a"), PLACE("b"), PLACE("c"), UNSIGNED("last", 1, 1, 2047), UNSIGNED("voxel", 3, 0, 2047) },
	  GIVES(U32, 1), .relate = relate_voxel },
	{ PRIMITIVE(cast_inside), "ts_k_cast_inside", "1 if the ray o + t d passes all edges of a b c on the same side",
	  { NEAR("o", 3), UNIT("d"), NEAR("a", 3), NEAR("b", 3), NEAR("c", 3) }, GIVES(U32, 1), .relate = relate_cast },
	{ PRIMITIVE(vpl_form), "ts_k_vpl_form", "form factor of a light that sends to the side of `from`; 0: to all sides",
	  { NEAR("way", 3), UNIT("from"), UNIT("n"), LENGTH("near", 1) }, GIVES(F32, 1), .relate = relate_form },
	{ 0 },
};
/* clang-format on */

static const ts_launch launch = TS_LAUNCH(views_composites, TS_ALL);

const ts_vector_set ts_views_composites_vectors = {&launch, true, TS_TABLES(maps)};

/* Composites of triangles (kernels/vectors/composites_geometry.h). */
#include "kernels/vectors/composites_geometry.h"
#include "vectors/relate.h"

static void relate_corners(u32 *in, u32 random) { ts_relate_triangle(in, in + 3, in + 6, &random); }

/* The point at a corner, on an edge, in the plane, or anywhere. */
static void relate_point(u32 *in, u32 random)
{
	ts_relate_triangle(in + 3, in + 6, in + 9, &random);
	ts_v3 a = ts_row_v3(in, 3), b = ts_row_v3(in, 6), c = ts_row_v3(in, 9);
	f32 s = ts_uniform(ts_more(&random)), t = ts_uniform(ts_more(&random));
	u32 k = (ts_more(&random) >> 8) % 16;
	if (k < 3) memcpy(in, in + 3 + 3 * k, 3 * sizeof *in);
	if (k == 3) ts_relate_v3(in, ts_mad(a, ts_sub(b, a), s));
	if (k == 4) ts_relate_v3(in, ts_mad(b, ts_sub(c, b), s));
	if (k == 5) ts_relate_v3(in, ts_mad(c, ts_sub(a, c), s));
	if (k == 6) ts_relate_v3(in, ts_scale(ts_add(a, b), 0.5f));
	if (k > 6 && k < 11) ts_relate_v3(in, ts_mad(ts_mad(a, ts_sub(b, a), s), ts_sub(c, a), t - s * t));
}

enum { O = 0, D = 3, TA = 6, TB = 9, TC = 12, N = 15 };

/* Towards the triangle as a rule; now and then along its plane, or a zero vector. */
static void relate_hit(u32 *in, u32 random)
{
	ts_relate_triangle(in + TA, in + TB, in + TC, &random);
	ts_v3 a = ts_row_v3(in, TA), ab = ts_sub(ts_row_v3(in, TB), a), ac = ts_sub(ts_row_v3(in, TC), a);
	ts_relate_v3(in + N, ts_cross(ab, ac));
	f32 s = ts_uniform(ts_more(&random)), t = ts_uniform(ts_more(&random));
	ts_v3 to = ts_mad(ts_mad(a, ab, s), ac, t - s * t);
	u32 k = (ts_more(&random) >> 8) % 16;
	if (k > 3) ts_relate_v3(in + D, ts_scale(ts_sub(to, ts_row_v3(in, O)), 0.25f + 2 * ts_uniform(ts_more(&random))));
	if (k == 0) ts_relate_v3(in + D, ab);
	if (k == 1) ts_relate_v3(in + D, ts_v3_make(0, 0, 0));
}

/* Along the normal, across it, or nearly; a zero normal or vector. */
static void relate_footprint(u32 *in, u32 random)
{
	u32 *d = in + 1, *n = in + 4;
	u32 k = (ts_more(&random) >> 8) % 16;
	if (k == 0) memcpy(d, n, 3 * sizeof *d);
	if (k == 1) ts_relate_v3(d, ts_neg(ts_row_v3(n, 0)));
	if (k == 2) ts_relate_v3(d, ts_cross(ts_row_v3(d, 0), ts_row_v3(n, 0)));
	if (k == 3) ts_relate_v3(n, ts_v3_make(0, 0, 0));
	if (k == 4) ts_relate_v3(d, ts_v3_make(0, 0, 0));
	if (k == 5) ts_relate_v3(d, ts_mad(ts_cross(ts_row_v3(d, 0), ts_row_v3(n, 0)), ts_row_v3(n, 0), 0.015625f));
}

enum { PERIOD = 3, MOVES = 33, POSE_FRAME = 36, N_MOTION = 37, POSE_N = 41 };

/* On an ellipse, by the file's motion, mirrored or not; a static object, a file without motions. */
static void relate_pose(u32 *in, u32 random)
{
	if (ts_once_in(&random, 8)) in[PERIOD] = 0;
	if (ts_once_in(&random, 4)) in[MOVES] = 0;
	in[N_MOTION] = ts_once_in(&random, 3) ? 0 : 1;
	ts_relate_unit(in + POSE_N);
}

enum { FOCAL = 2, CLIP_NEAR = 3, CORNERS = 5 };

/* Corners in front and behind, in the plane, and so far aside that the range of snapping ends. */
static void relate_clip(u32 *in, u32 random)
{
	if (in[FOCAL] == 0) ts_relate_f32(in + FOCAL, 0.5f * (f32)in[0]);
	if (in[CLIP_NEAR] == 0) ts_relate_f32(in + CLIP_NEAR, 0.0009765625f);
	f32 near = ts_u2f(in[CLIP_NEAR]);
	for (u32 k = 0; k < 3; k++) {
		u32 *z = in + CORNERS + 3 * k + 2, choice = (ts_more(&random) >> 8) % 8;
		if (choice < 4) ts_relate_f32(z, ts_abs(ts_u2f(*z)));
		if (choice == 4) ts_relate_f32(z, near);
		if (choice == 5) ts_relate_f32(z, near * (1 + ts_uniform(ts_more(&random))));
		if (choice == 6) ts_relate_f32(z, near * ts_uniform(ts_more(&random)));
	}
}

/* clang-format off */
#define CORNERS(a, b, c) NEAR(a, 3), NEAR(b, 3), NEAR(c, 3)

const ts_vector ts_composites_geometry[] = {
	{ PRIMITIVE(longest_edge), "ts_k_longest_edge",
	  "edge k runs from corner k to the next; of equal lengths the lowest k",
	  { CORNERS("a", "b", "c") }, { COLUMN("edge", U32, 1), COLUMN("length", F32, 1) }, .relate = relate_corners },
	{ PRIMITIVE(closest_on_triangle), "ts_k_closest_on_triangle", "the point of triangle a b c that is closest to p",
	  { NEAR("p", 3), CORNERS("a", "b", "c") }, GIVES(F32, 3), .relate = relate_point },
	{ PRIMITIVE(closest_on_border), "ts_k_closest_on_border",
	  "the point of the edges of a b c that is closest to p; of equal distances the first edge",
	  { NEAR("p", 3), CORNERS("a", "b", "c") }, GIVES(F32, 3), .relate = relate_point },
	{ PRIMITIVE(circumcentre), "ts_k_circumcentre",
	  "circumcentre of a b c; a if there is none, or it is too far away",
	  { CORNERS("a", "b", "c") }, GIVES(F32, 3), .relate = relate_corners },
	{ PRIMITIVE(hit), "ts_k_hit", "where the ray o + t d meets the plane of triangle a b c; n = (b - a) x (c - a)",
	  { NEAR("o", 3), WORLD("d", 3), CORNERS("a", "b", "c"), WORLD("n", 3) },
	  { COLUMN("t", F32, 1), COLUMN("weights", F32, 3) }, .relate = relate_hit },
	{ PRIMITIVE(footprint), "ts_k_footprint",
	  "footprint of a pixel of this width on a surface with normal n; d runs from the eye to the surface",
	  { LENGTH("width", 1), WORLD("d", 3), WORLD("n", 3) }, GIVES(F32, 1), .relate = relate_footprint },
	{ PRIMITIVE(pose), "ts_k_pose_at",
	  "place, normal, tangent at a frame: by the ellipse, or by the motion if n_motion and motion.moves are not 0",
	  { ANY_INDEX("object.first_vertex", 1), ANY_INDEX("object.n_vertices", 1), ANY_INDEX("object.reflector", 1),
	    UNSIGNED("object.period", 1, 0, 4096), NEAR("object.centre", 3), SHARE("object.phase", 1),
	    NEAR("object.axis", 2), NEAR("object.bob", 1), NEAR("object.spin", 1), NEAR("motion.linear", 9),
	    NEAR("motion.origin", 3), NEAR("motion.normal", 9), UNSIGNED("motion.moves", 1, 0, 2), ZERO("motion.pad", 2),
	    UNSIGNED("frame", 1, 0, 65535), UNSIGNED("n_motion", 1, 0, 1), NEAR("p", 3), UNIT("n") },
	  { COLUMN("p", F32, 3), COLUMN("n", F32, 3), COLUMN("t", F32, 3) }, .relate = relate_pose },
	{ PRIMITIVE(clip), "ts_k_clip_to_range",
	  "triangle a b c in view space, clipped by rule 16: n corners, each x, y, z and three weights",
	  { UNSIGNED("size", 2, 1, 4096), POSITIVE("focal", 1, 126, 140), POSITIVE("near", 1, 117, 127),
	    FLAG("orthographic"),
	    { "a", TS_VECTOR_F32, 3, 88, 137, true }, { "b", TS_VECTOR_F32, 3, 88, 137, true },
	    { "c", TS_VECTOR_F32, 3, 88, 137, true } },
	  { COLUMN("n", U32, 1), COLUMN("corners", F32, 48) }, .relate = relate_clip },
	{ 0 },
};
/* clang-format on */

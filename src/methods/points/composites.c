/* Composites of points (kernels/points/composites.h). */
#include "kernels/points/composites.h"
#include "vectors/relate.h"

enum { EYE = 0, CENTRE = 3, RADIUS = 6, CORNER = 7 };

/* The eye in the ball, a triangle that intersects it or has no area. */
static void relate_path(u32 *in, u32 random)
{
	ts_relate_triangle(in + CORNER, in + CORNER + 3, in + CORNER + 6, &random);
	u32 k = (ts_more(&random) >> 8) % 16;
	if (k == 0) memcpy(in + EYE, in + CENTRE, 3 * sizeof *in);
	if (k == 1) memcpy(in + CENTRE, in + CORNER, 3 * sizeof *in);
	if (k == 2) ts_relate_v3(in + EYE, ts_add(ts_row_v3(in, CENTRE), ts_v3_make(ts_row_f32(in, RADIUS), 0, 0)));
	if (k == 3) in[RADIUS] = 0;
}

/* The radius of a ball, not 0, and often small. */
static void relate_ball(u32 *in, u32 random)
{
	if (in[0] == 0) ts_relate_f32(in, 1);
	if (ts_once_in(&random, 2)) ts_relate_f32(in, ts_row_f32(in, 0) * 0.03125f);
}

enum { FACE_RADIUS = 3, DENSITY_VIEW = 16, DENSITY_BITS = 32, DENSITY_CORNER = 39 };

static void relate_eye_density(u32 *in, u32 random)
{
	relate_ball(in + FACE_RADIUS, ts_more(&random));
	ts_relate_view(in + DENSITY_VIEW);
	in[DENSITY_BITS] = ts_once_in(&random, 16) ? 0 : in[DENSITY_BITS] % 64;
	in[DENSITY_BITS + 1] = 0;
	ts_relate_triangle(in + DENSITY_CORNER, in + DENSITY_CORNER + 3, in + DENSITY_CORNER + 6, &random);
	if (ts_once_in(&random, 16)) memcpy(in, in + DENSITY_CORNER, 3 * sizeof *in);
}

/* Moves a point from behind the view to its front. */
static void turn_to_front(u32 *p, const ts_camera_k *view)
{
	f32 z = ts_k_to_view(view, ts_row_v3(p, 0)).z;
	if (z < 0) ts_relate_v3(p, ts_mad(ts_row_v3(p, 0), view->back, 2 * z));
}

enum { REACH = 16, SEEN = 24, RATE_CORNER = 27 };

static void relate_view_density(u32 *in, u32 random)
{
	ts_offscreen of;
	ts_relate_view(in);
	f32 focal = ts_row_f32(in, TS_VIEW_FOCAL);
	ts_relate_f32(in + REACH, 0.5f * (f32)in[TS_VIEW_WIDTH] / focal);
	ts_relate_f32(in + REACH + 1, 0.5f * (f32)in[TS_VIEW_HEIGHT] / focal);
	in[SEEN] = ts_once_in(&random, 16) ? 0 : 1;
	in[SEEN + 1] = 0;
	memcpy(&of, in, sizeof of);
	ts_camera_k view = ts_k_offscreen(&of);
	ts_relate_triangle(in + RATE_CORNER, in + RATE_CORNER + 3, in + RATE_CORNER + 6, &random);
	bool behind = ts_once_in(&random, 8);
	for (u32 k = 0; k < 3 && !behind; k++) turn_to_front(in + RATE_CORNER + 3 * k, &view);
}

enum { PATH = 7 };

static void relate_cull(u32 *in, u32 random)
{
	ts_relate_piece(in, &random);
	if (ts_once_in(&random, 2)) in[PATH] = 1;
}

enum { SPLAT_C = 16, SPLAT_U = 19, SPLAT_V = 22 };

/* A square in front of the view, as a rule. */
static void relate_splat(u32 *in, u32 random)
{
	ts_view of;
	ts_relate_view(in);
	memcpy(&of, in, sizeof of);
	ts_camera_k view = ts_k_view(&of);
	ts_relate_across(in + SPLAT_V, ts_relate_unit(in + SPLAT_U));
	if (!ts_once_in(&random, 8)) turn_to_front(in + SPLAT_C, &view);
	f32 shift = ts_uniform(ts_more(&random));
	if (ts_once_in(&random, 4)) ts_relate_v3(in + SPLAT_C, ts_mad(view.eye, view.back, -view.near * (1 + shift)));
}

enum { PLANE_N = 16, PLANE_C = 19, DISTANCE = 22 };

static void relate_plane(u32 *in, u32 random)
{
	ts_view of;
	ts_relate_view(in);
	memcpy(&of, in, sizeof of);
	ts_camera_k view = ts_k_view(&of);
	ts_v3 n = ts_relate_unit(in + PLANE_N);
	turn_to_front(in + PLANE_C, &view);
	ts_v3 way = ts_sub(ts_row_v3(in, PLANE_C), view.eye);
	if (ts_once_in(&random, 8)) ts_relate_v3(in + PLANE_N, ts_normalize(ts_cross(n, way)));
	ts_relate_unit(in + PLANE_N);
	ts_relate_f32(in + DISTANCE, ts_length(way));
}

enum { PIXEL_NORMAL = 4, NORMAL_DX = 16, NORMAL_DY = 20, RAY_EYE = 24 };

static void relate_ray(u32 *in, u32 random)
{
	ts_relate_unit(in + PIXEL_NORMAL);
	ts_relate_v3(in + NORMAL_DX, ts_scale(ts_row_v3(in, NORMAL_DX), 0.0625f));
	ts_relate_v3(in + NORMAL_DY, ts_scale(ts_row_v3(in, NORMAL_DY), 0.0625f));
	if (ts_once_in(&random, 16)) memcpy(in + RAY_EYE, in, 3 * sizeof *in);
}

enum { BOUNCE_N = 3, BOUNCE_U = 6, BOUNCE_V = 9, BOUNCE_FROM = 12 };

static void relate_bounce(u32 *in, u32 random)
{
	ts_v3 n = ts_relate_unit(in + BOUNCE_N), u = ts_relate_across(in + BOUNCE_U, n);
	ts_relate_v3(in + BOUNCE_V, ts_cross(n, u));
	ts_relate_unit(in + BOUNCE_V);
	if (ts_once_in(&random, 16)) memcpy(in + BOUNCE_FROM, in, 3 * sizeof *in);
}

/* As many doublings of the near depth as codes distinguish, and fewer. */
static void relate_depth(u32 *in, u32 random)
{
	if (in[1] == 0) ts_relate_f32(in + 1, 1);
	f32 near = ts_row_f32(in, 1), power = (f32)(1u << random % 22);
	if (ts_once_in(&random, 2)) ts_relate_f32(in, near * power);
	if (ts_once_in(&random, 2)) ts_relate_f32(in, (near * power) * (1 + ts_uniform(ts_more(&random))));
}

static const f32 code_edges[] = {65280, 65408, 65535, 511, 511.5f, 0x1p-16f, 0x1p-17f, 0x1.ffp0f, 0x1.fep0f};

/* clang-format off */
#define CORNERS NEAR("a", 3), NEAR("b", 3), NEAR("c", 3)
#define MASK(name) { name, TS_VECTOR_U64, 1, INT64_MIN, INT64_MAX, false }

static const ts_vector density[] = {
	{ PRIMITIVE(path_length), "ts_k_path_length",
	  "length of the shortest way of light from triangle a b c to the eye by a ball",
	  { NEAR("eye", 3), NEAR("centre", 3), LENGTH("radius", 1), CORNERS, FLAG("paper") }, GIVES(F32, 1),
	  .relate = relate_path },
	{ PRIMITIVE(ball_spread), "ts_k_ball_spread", "length that eq. 3 adds to the way for the curvature of a ball",
	  { POSITIVE("radius", 1, 107, 131), LENGTH("to_eye", 1), LENGTH("to_triangle", 1) }, GIVES(F32, 1),
	  .relate = relate_ball },
	{ PRIMITIVE(eye_density), "ts_k_density", "samples per world unit on triangle a b c, which one cube sees",
	  { NEAR("face.centre", 3), POSITIVE("face.radius", 1, 107, 131), NEAR("face.box_min", 3),
	    UNSIGNED("face.n", 1, 1, 4096),
	    NEAR("face.box_max", 3), LENGTH("face.near", 1), MASK("face.offset"), ANY_INDEX("face.object", 1),
	    ZERO("face.pad", 1), VIEW("view"), MASK("bits"), POSITIVE("rho", 1, 126, 128), FLAG("paper"), FLAG("cap"),
	    FLAG("offaxis"), FLAG("ball"), CORNERS }, { COLUMN("s", F32, 1), COLUMN("limited", U32, 1) },
	  .relate = relate_eye_density },
	{ PRIMITIVE(view_density), "ts_k_view_density",
	  "the same for an off-screen view; rate 1 watertight, 2 exact, 3 the paper's, 4 VIR's",
	  { VIEW("view"), POSITIVE("view.reach", 2, 88, 150), MASK("view.offset"), FLAG("view.orthographic"),
	    ANY_INDEX("view.object", 1), ANY_INDEX("view.light", 1), ZERO("view.pad", 1), MASK("bits"),
	    UNSIGNED("rate", 1, 1, 4), CORNERS }, { COLUMN("s", F32, 1), COLUMN("uneven", F32, 1) },
	  .relate = relate_view_density },
	{ PRIMITIVE(cull_chance), "ts_k_cull_chance", "random number of a piece, in steps of 2^-24",
	  { PIECE("piece"), ALL_U32("seed", 1) }, GIVES(I32, 1), .relate = relate_cull },
	{ 0 },
};

static const ts_vector splats[] = {
	{ PRIMITIVE(splat_box), "ts_k_splat_box",
	  "texels x0, y0, x1, y1 whose centres the box of the square about c with axes u and v holds, or that it touches",
	  { VIEW("view"), NEAR("c", 3), UNIT("u"), UNIT("v"), LENGTH("length", 1), LENGTH("slack", 1), FLAG("touched") },
	  GIVES(I32, 4),
	  .relate = relate_splat },
	{ PRIMITIVE(plane_distance), "ts_k_plane_distance",
	  "distance, through the middle of texel (i, j), to the plane through c with normal n",
	  { VIEW("view"), UNIT("n"), WORLD("c", 3), POSITIVE("distance", 1, 88, 150), LENGTH("length", 1),
	    INTEGER("i", 1, 0, 4095), INTEGER("j", 1, 0, 4095) }, GIVES(F32, 1), .relate = relate_plane },
	{ PRIMITIVE(sample_ray), "ts_k_sample_ray",
	  "position of sample k of a reflective pixel, and the direction of its reflected ray",
	  { NEAR("pixel.position", 3), ALL_U32("pixel.index", 1), UNIT("pixel.normal"), ANY_INDEX("pixel.reflector", 1),
	    NEAR("pixel.position_dx", 3), SHARE("pixel.tint_r", 1), NEAR("pixel.position_dy", 3), SHARE("pixel.tint_g", 1),
	    { "pixel.normal_dx", TS_VECTOR_F32, 3, 107, 131, true }, SHARE("pixel.tint_b", 1),
	    { "pixel.normal_dy", TS_VECTOR_F32, 3, 107, 131, true }, ZERO("pixel.pad", 1), NEAR("eye", 3),
	    UNSIGNED("k", 1, 0, 24) }, { COLUMN("p", F32, 3), COLUMN("direction", F32, 3) }, .relate = relate_ray },
	{ PRIMITIVE(bounce_direction), "ts_k_bounce_direction", "direction of sample k of a later bounce from p",
	  { NEAR("p", 3), UNIT("n"), UNIT("u"), UNIT("v"), NEAR("from", 3), LENGTH("spread", 1), UNSIGNED("k", 1, 0, 3) },
	  GIVES(F32, 3), .relate = relate_bounce },
	{ PRIMITIVE(depth_code), "ts_k_depth_code", "13 bits of the logarithm of a distance",
	  { LENGTH("distance", 1), LENGTH("near", 1) }, GIVES(U32, 1), .relate = relate_depth },
	{ PRIMITIVE(colour_code), "ts_k_colour_code", "19 bits of a colour: 6 of red, 7 of green, 6 of blue",
	  { { "radiance", TS_VECTOR_F32, 3, 107, 131, true }, LENGTH("exposure", 1) }, GIVES(U32, 1) },
	{ PRIMITIVE(shared_code), "ts_k_shared_code", "32 bits of a colour: 9 per channel and a common exponent of 5",
	  { { "radiance", TS_VECTOR_F32, 3, 100, 150, true } }, GIVES(U32, 1), EDGES(code_edges) },
	{ 0 },
};
/* clang-format on */

static const ts_launch launch = TS_LAUNCH(points_composites, TS_ALL);

const ts_vector_set ts_points_composites_vectors = {&launch, true, TS_TABLES(density, splats)};

/* Composites of surfels (kernels/surfels/composites.h). */
#include "kernels/surfels/composites.h"
#include "vectors/relate.h"

enum { SURFEL = 24, SURFEL_U = 27, SURFEL_V = 30, SURFEL_COLOUR = 33 };

/* A place at depth z, in the image or slightly beside it. */
static ts_v3 place_in(const ts_camera_k *view, f32 z, u32 *random)
{
	f32 pixel = view->orthographic != 0 ? 1 / view->focal : z / view->focal;
	f32 x = (ts_uniform(ts_more(random)) - 0.5f) * (1.25f * (f32)view->width) * pixel;
	f32 y = (ts_uniform(ts_more(random)) - 0.5f) * (1.25f * (f32)view->height) * pixel;
	return ts_mad(ts_mad(ts_mad(view->eye, view->back, -z), view->right, x), view->up, y);
}

/* Ellipses in front of the view, as a rule; also seen from the side, across the near plane, from behind. */
static void relate_disc(u32 *in, u32 random)
{
	ts_view of;
	ts_relate_view(in);
	memcpy(&of, in, sizeof of);
	ts_camera_k view = ts_k_view(&of);
	view.orthographic = in[TS_VIEW_WORDS];
	f32 power = 1 / (f32)(1u << (ts_more(&random) >> 8) % 8);
	ts_v3 u = ts_relate_unit(in + SURFEL_U), v, centre = ts_row_v3(in, SURFEL);
	if (!ts_once_in(&random, 8)) centre = place_in(&view, 1 + ts_abs(ts_k_to_view(&view, centre).z), &random);
	if (ts_once_in(&random, 8)) centre = ts_mad(view.eye, view.back, -view.near * (2 * ts_uniform(ts_more(&random))));
	if (ts_once_in(&random, 16)) u = ts_normalize(ts_sub(centre, view.eye));
	if (ts_once_in(&random, 16)) u = view.back;
	v = ts_relate_across(in + SURFEL_V, u);
	ts_v3 to_eye = view.orthographic != 0 ? view.back : ts_sub(view.eye, centre);
	bool back = ts_dot(ts_cross(u, v), to_eye) < 0 && !ts_once_in(&random, 8);
	ts_relate_v3(in + SURFEL, centre);
	ts_relate_v3(in + SURFEL_U, ts_scale(u, power * (0.5f + ts_uniform(ts_more(&random)))));
	ts_relate_v3(in + SURFEL_V, ts_scale(v, back ? -power : power));
	ts_relate_shares(in + SURFEL_COLOUR, 3);
}

enum {
	FRACTION = 2,
	DEPTH = 10,
	DISC_FLAGS = 11,
	CONIC = 16,
	DISC_NORMAL = 20,
	FRAGMENT_FILTER = 24,
	FRAGMENT_NEAR = 31,
	AT = 32
};

/* A pixel about the centre; a Gaussian that falls in all directions. */
static void relate_fragment(u32 *in, u32 random)
{
	for (u32 k = 0; k < 2; k++) {
		ts_relate_f32(in + FRACTION + k, ts_uniform(ts_more(&random)) - 0.5f);
		in[AT + k] = (u32)(ts_row_i32(in, k) + (i32)((ts_more(&random) >> 8) % 9) - 4);
	}
	f32 most = ts_sqrt(ts_abs(ts_row_f32(in, CONIC)) * ts_abs(ts_row_f32(in, CONIC + 2)));
	if (in[FRAGMENT_FILTER] >= TS_FILTER_SCREEN) in[DISC_FLAGS] &= ~TS_DISC_CROSSES;
	bool crosses = (in[DISC_FLAGS] & TS_DISC_CROSSES) != 0;
	ts_relate_f32(in + CONIC, ts_abs(ts_row_f32(in, CONIC)));
	ts_relate_f32(in + CONIC + 1, crosses ? 0.5f : (ts_uniform(ts_more(&random)) - 0.5f) * most);
	ts_relate_f32(in + CONIC + 2, ts_abs(ts_row_f32(in, CONIC + 2)));
	ts_relate_shares(in + CONIC + 3, 1);
	ts_relate_unit(in + DISC_NORMAL);
	if (ts_once_in(&random, 8)) memcpy(in + FRAGMENT_NEAR, in + DEPTH, sizeof *in);
}

enum { LIT_SHARE = 16, LIT_P = 18, LIT_N = 21, LIT_V = 24, ALBEDO = 27 };

/* Some of the light in the middle of the highlight. */
static void relate_light(u32 *in, u32 random)
{
	ts_relate_light(in, ts_row_v3(in, LIT_P), &random);
	ts_relate_shares(in + LIT_SHARE, 1);
	ts_relate_unit(in + LIT_N);
	ts_v3 l = ts_normalize(ts_sub(ts_row_v3(in, 0), ts_row_v3(in, LIT_P)));
	if (ts_dot(l, ts_row_v3(in, LIT_N)) < 0) ts_relate_v3(in + LIT_N, ts_neg(ts_row_v3(in, LIT_N)));
	ts_v3 mirrored = ts_reflect(ts_neg(l), ts_row_v3(in, LIT_N));
	if (ts_once_in(&random, 2)) ts_relate_v3(in + LIT_V, ts_mad(mirrored, ts_relate_unit(in + LIT_V), 0.125f));
	ts_relate_unit(in + LIT_V);
	ts_relate_shares(in + ALBEDO, 3);
}

/* clang-format off */
#define FILTER UNSIGNED("filter", 1, TS_FILTER_MIN, TS_FILTER_EWA), FLAG("botsch"), LENGTH("per_sigma2", 1), \
	LENGTH("reach", 1), LENGTH("fall", 1), SHARE("object2", 1), SHARE("screen2", 1)
#define SCREEN(name) { name, TS_VECTOR_F32, 2, 102, 126, true }

static const ts_vector surfels[] = {
	{ PRIMITIVE(disc), "ts_k_disc",
	  "a surfel in a view: surfel_setup.disc; fate 0 drawn, 1 turned away, 2 before the near plane, 3 beside; filter 0 "
	  "min, 1 object, 2 screen, 3 exact EWA; per_sigma2 1/r^2 of the screen filter's radius r, 0 without one; reach "
	  "the half side of the square; fall 1/(2 s^2), object2 s^2, s ewa.sigma_k; screen2 the square of sigma_h",
	  { VIEW("view"), FLAG("orthographic"), FILTER, WORLD("surfel.centre", 3),
	    { "surfel.u", TS_VECTOR_F32, 3, 88, 131, true }, { "surfel.v", TS_VECTOR_F32, 3, 88, 131, true },
	    SHARE("surfel.colour", 3) },
	  { COLUMN("pixel", I32, 2), COLUMN("fraction", F32, 2), COLUMN("a", F32, 2), COLUMN("b", F32, 2),
	    COLUMN("g", F32, 2), COLUMN("depth", F32, 1), COLUMN("flags", U32, 1), COLUMN("low", I32, 2),
	    COLUMN("high", I32, 2), COLUMN("conic", F32, 3), COLUMN("peak", F32, 1), COLUMN("normal", F32, 3),
	    COLUMN("pad", U32, 1), COLUMN("fate", U32, 1) }, .relate = relate_disc },
	{ PRIMITIVE(surfel_fragment), "ts_k_surfel_fragment",
	  "fragment of a surfel at pixel (x, y): covers by its filter, inside by r3D alone; other inputs as in disc",
	  { INTEGER("disc.pixel", 2, -4096, 4096), SCREEN("disc.fraction"), SCREEN("disc.a"), SCREEN("disc.b"),
	    SCREEN("disc.g"), LENGTH("disc.depth", 1), UNSIGNED("disc.flags", 1, 0, 7), INTEGER("disc.low", 2, -4096, 4096),
	    INTEGER("disc.high", 2, -4096, 4096), { "disc.conic", TS_VECTOR_F32, 3, 88, 131, true }, SHARE("disc.peak", 1),
	    UNIT("disc.normal"), ZERO("disc.pad", 1), FILTER, LENGTH("near", 1), INTEGER("x", 1, -4100, 4100),
	    INTEGER("y", 1, -4100, 4100) },
	  { COLUMN("covers", U32, 1), COLUMN("inside", U32, 1), COLUMN("z", F32, 1), COLUMN("weight", F32, 1) },
	  .relate = relate_fragment },
	{ PRIMITIVE(surfel_light), "ts_k_shade_by", "light of one lamp times its share; shader 0: Phong's, 1: NPR's tones",
	  { LIGHT("light"), SHARE("share", 1), FLAG("shader"), NEAR("p", 3), UNIT("n"), UNIT("v"), SHARE("albedo", 3) },
	  GIVES(F32, 3), .relate = relate_light },
	{ 0 },
};
/* clang-format on */

static const ts_launch launch = TS_LAUNCH(surfels_composites, TS_ALL);

const ts_vector_set ts_surfels_composites_vectors = {&launch, true, TS_TABLES(surfels)};

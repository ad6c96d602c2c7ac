/* Primitives of gathered light (kernels/hulls/gaussian.h, form_factor.h). */
#include "kernels/hulls/vectors.h"
#include "vectors/row.h"

enum { P = 0, NORMAL = 3 };

/* Sizes from 1/2 to 2, so that triangles and points are near each other. */
static void bring_near(u32 *words, u32 n)
{
	for (u32 k = 0; k < n; k++) {
		if (words[k] != 0) words[k] = (words[k] & 0x80ffffffu) | 0x3f000000u;
	}
}

/* Three times in four close together; now and then the point is a corner. */
static void relate_point(u32 *in, u32 random)
{
	if ((random & 3) != 0) bring_near(in, 12);
	if ((random & 63) == 1) memcpy(in + P, in + 9, 3 * sizeof *in);
}

/* Also makes n a unit vector. */
static void relate_surface(u32 *in, u32 random)
{
	ts_v3 n = ts_v3_make((f32)(random >> 8 & 255) - 128, (f32)(random >> 16 & 255) - 128, (f32)(random >> 24) - 127.5f);
	if ((random & 3) != 0) bring_near(in, 15);
	if ((random & 63) == 1) memcpy(in + P, in + 12, 3 * sizeof *in);
	ts_set_v3(in + NORMAL, ts_normalize(n));
}

static ts_v3 unit_of(u32 random)
{
	ts_v3 d = ts_v3_make((f32)(random & 255) - 128, (f32)(random >> 8 & 255) - 128, (f32)(random >> 16 & 255) - 127.5f);
	return ts_normalize(d);
}

/* Directions are unit vectors, now and then equal or opposite. */
static void relate_lobes(u32 *in, u32 random)
{
	ts_v3 phi = unit_of(random);
	ts_set_v3(in + 2, phi);
	ts_set_v3(in + 7, random >> 27 == 0 ? phi : random >> 27 == 1 ? ts_neg(phi) : unit_of(random * 2654435769u));
}

static void relate_gloss(u32 *in, u32 random)
{
	ts_v3 n = unit_of(random);
	ts_set_v3(in, n);
	ts_set_v3(in + 3, random >> 27 == 0 ? n : unit_of(random * 2654435769u));
}

static const f32 sharpness_edges[] = {0.5f, 0.25f, 0.89999998f, 0.99998999f, 1, 0.16395f};

/* clang-format off */
#define SPACE(name) { name, TS_VECTOR_F32, 3, 107, 137, true }
#define LOBE(name) POSITIVE("mu" name, 1, 107, 137), POSITIVE("lambda" name, 1, 107, 143), SPACE("phi" name)
/* clang-format on */

/* clang-format off */
static const ts_vector light[] = {
	{ PRIMITIVE(sg_cosine), "ts_k_sg_cosine",
	  "integral of a spherical Gaussian and the cosine; method 0 SSAGH's, 1 constant, 2 a Gaussian, 3 quadrature",
	  { POSITIVE("lambda", 1, 107, 143), { "cos_beta", TS_VECTOR_F32, 1, 97, 127, true },
	    UNSIGNED("method", 1, TS_COSINE_OURS, TS_COSINE_QUADRATURE), UNSIGNED("printed", 1, 0, 1) },
	  GIVES(F32, 1) },
	{ PRIMITIVE(sg_sharpness), "ts_k_sg_sharpness", "of the length of a mean; vmf 0 Toksvig's, 1 of a von Mises-Fisher",
	  { POSITIVE("r", 1, 97, 127), UNSIGNED("vmf", 1, 0, 1) }, GIVES(F32, 1), EDGES(sharpness_edges) },
	{ PRIMITIVE(solid_angle), "ts_k_solid_angle", "of a triangle seen from p",
	  { SPACE("p"), SPACE("a"), SPACE("b"), SPACE("c") }, GIVES(F32, 1), .relate = relate_point },
	{ PRIMITIVE(form_factor), "ts_k_form_factor", "of a triangle that shines on p, n the normal there",
	  { SPACE("p"), SPACE("n"), SPACE("a"), SPACE("b"), SPACE("c") }, GIVES(F32, 1), .relate = relate_surface },
	{ PRIMITIVE(sg_product), "ts_k_sg_product", "of two spherical Gaussians: mu, lambda, phi",
	  { LOBE("1"), LOBE("2") }, GIVES(F32, 5), .relate = relate_lobes },
	{ PRIMITIVE(gloss_lobe), "ts_k_gloss_lobe", "of a surface, n its normal, v to the eye: mu, lambda, phi",
	  { SPACE("n"), SPACE("v"), POSITIVE("alpha_squared", 1, 109, 126) }, GIVES(F32, 5),
	  .relate = relate_gloss },
	{ 0 },
};
/* clang-format on */

static const ts_launch launch = TS_LAUNCH(hulls_vectors, TS_ALL);

const ts_vector_set ts_hulls_vectors = {&launch, false, TS_TABLES(light)};

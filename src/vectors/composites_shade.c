/* Composites of visible surfaces (kernels/vectors/composites_shade.h). */
#include "kernels/vectors/composites_shade.h"
#include "vectors/relate.h"

/* The point at the light, at the end of its range, or anywhere. */
static void relate_light(u32 *in, u32 random)
{
	u32 *p = in + TS_LIGHT_WORDS;
	ts_relate_light(in, ts_row_v3(p, 0), &random);
	ts_v3 position = ts_row_v3(in, 0), direction = ts_row_v3(in, TS_LIGHT_DIRECTION);
	u32 k = (ts_more(&random) >> 8) % 16;
	if (k == 0) memcpy(p, in, 3 * sizeof *p);
	if (k == 1) ts_relate_v3(p, ts_mad(position, direction, ts_row_f32(in, TS_LIGHT_RANGE)));
	if (k == 2) ts_relate_v3(p, ts_sub(position, direction));
	if (k > 2 && k < 7) ts_relate_v3(p, ts_mad(ts_add(position, ts_row_v3(p, 0)), direction, 16));
}

enum { N = 0, V = 3, L = 6, N_L = 9, BASE = 10 };

/* Light that comes from the viewer, from behind the surface, along it; a viewer beside the surface. */
static void relate_brdf(u32 *in, u32 random)
{
	ts_v3 n = ts_relate_unit(in + N), v = ts_relate_unit(in + V);
	ts_relate_unit(in + L);
	u32 k = (ts_more(&random) >> 8) % 16;
	if (k == 0) memcpy(in + L, in + V, 3 * sizeof *in);
	if (k == 1) ts_relate_v3(in + L, ts_neg(v));
	if (k == 2) v = ts_relate_across(in + V, n);
	if (k == 3) memcpy(in + L, in + N, 3 * sizeof *in), memcpy(in + V, in + N, 3 * sizeof *in);
	if (k == 4) ts_relate_v3(in + L, ts_normalize(ts_reflect(ts_neg(v), n)));
	if (k == 5) ts_relate_v3(in + L, ts_normalize(ts_mad(ts_relate_across(in + L, n), n, 0.0009765625f)));
	if (ts_dot(n, ts_row_v3(in, L)) < 0) ts_relate_v3(in + L, ts_neg(ts_row_v3(in, L)));
	if (!(ts_flush(ts_dot(n, ts_row_v3(in, L))) > 0)) memcpy(in + L, in + N, 3 * sizeof *in);
	ts_relate_f32(in + N_L, ts_dot(n, ts_row_v3(in, L)));
	ts_relate_shares(in + BASE, 5);
}

enum { FACE = 6, SURFACE_BASE = 9, METALLIC = 15, SHADE_V = 19, SHADE_LIGHT = 23 };

/* The viewer, and the light, on either side. */
static void relate_shade(u32 *in, u32 random)
{
	ts_v3 n = ts_relate_unit(in + 3), face = ts_relate_unit(in + FACE);
	if (ts_dot(n, face) < 0) ts_relate_v3(in + 3, ts_neg(n));
	ts_relate_shares(in + SURFACE_BASE, 3);
	ts_relate_shares(in + METALLIC, 3);
	if (ts_once_in(&random, 8)) ts_relate_across(in + SHADE_V, face);
	ts_relate_unit(in + SHADE_V);
	ts_relate_light(in + SHADE_LIGHT, ts_row_v3(in, 0), &random);
	ts_v3 light = ts_row_v3(in, SHADE_LIGHT);
	if (ts_once_in(&random, 32)) memcpy(in, in + SHADE_LIGHT, 3 * sizeof *in);
	if (ts_once_in(&random, 2)) ts_relate_v3(in, ts_mad(light, ts_row_v3(in, SHADE_LIGHT + TS_LIGHT_DIRECTION), 4));
	bool behind = ts_dot(ts_row_v3(in, 3), ts_sub(light, ts_row_v3(in, 0))) < 0 && !ts_once_in(&random, 4);
	for (u32 k = 3; k < SURFACE_BASE && behind; k++) ts_relate_f32(in + k, -ts_row_f32(in, k));
}

enum {
	IMAGE = 10,
	SLOT = 16,
	MATERIAL = 28,
	TRIANGLE = 48,
	OBJECT = 52,
	VERTEX = 64,
	VERTEX_WORDS = 20,
	WEIGHTS = 124
};

static void relate_vertex(u32 *vertex, u32 *random)
{
	u32 *normal = vertex + 4, *tangent = vertex + 8;
	ts_relate_unit(normal);
	ts_relate_unit(tangent);
	ts_relate_f32(tangent + 3, (ts_more(random) & 256) != 0 ? -1 : 1);
	if (ts_once_in(random, 16)) ts_relate_v3(normal, ts_v3_make(0, 0, 0));
	ts_relate_shares(vertex + 16, 4);
}

/* An image of two levels; each of the five textures is that or none; sometimes uv without area. */
static void relate_texture(u32 *in, u32 *random)
{
	static const u32 image[6] = {2, 2, 2};
	memcpy(in + IMAGE, image, sizeof image);
	in[SLOT] = 0;
	if (ts_once_in(random, 4)) {
		static const f32 identity[6] = {1, 0, 0, 0, 1, 0};
		for (u32 k = 0; k < 6; k++) ts_relate_f32(in + SLOT + 4 + k, identity[k]);
	}
	for (u32 k = 0; k < 5; k++) in[MATERIAL + 12 + k] = ts_once_in(random, 3) ? TS_NONE : 0;
}

static void relate_surface(u32 *in, u32 random)
{
	static const u32 triangle[4] = {0, 1, 2, 0};
	u32 *a = in + VERTEX, *b = a + VERTEX_WORDS, *c = b + VERTEX_WORDS;
	bool no_tangents = ts_once_in(&random, 2), is_flat = ts_once_in(&random, 4);
	relate_texture(in, &random);
	memcpy(in + TRIANGLE, triangle, sizeof triangle);
	for (u32 k = 0; k < 3; k++) relate_vertex(a + k * VERTEX_WORDS, &random);
	for (u32 k = 0; k < 3 && no_tangents; k++) ts_relate_v3(a + k * VERTEX_WORDS + 8, ts_v3_make(0, 0, 0));
	if (is_flat) memcpy(b + 12, a + 12, 4 * sizeof *a);
	ts_relate_triangle(a, b, c, &random);
	ts_relate_area(a, b, c);
	ts_relate_shares(in + MATERIAL, 4);
	ts_relate_shares(in + MATERIAL + 7, 2);
	ts_relate_shares(in + MATERIAL + 10, 2);
	in[OBJECT + 2] = ts_once_in(&random, 8) ? 0 : TS_NONE;
	ts_relate_weights(in + WEIGHTS);
}

enum { BIAS_P = 19, BIAS_N = 22, BIAS_Z = 25 };

/* A point in front of the view, its axial depth, and normals towards the view, along it, and away. */
static void relate_bias(u32 *in, u32 random)
{
	ts_view of;
	ts_relate_view(in);
	memcpy(&of, in, sizeof of);
	ts_camera_k view = ts_k_view(&of);
	ts_v3 p = ts_row_v3(in, BIAS_P);
	ts_relate_unit(in + BIAS_N);
	f32 z = ts_k_to_view(&view, p).z;
	ts_relate_v3(in + BIAS_P, z < view.near ? ts_mad(p, view.back, z - 2 * view.near) : p);
	if (ts_once_in(&random, 8)) ts_relate_across(in + BIAS_N, view.back);
	if (ts_once_in(&random, 8)) ts_relate_v3(in + BIAS_N, view.back);
	ts_relate_f32(in + BIAS_Z, ts_k_to_view(&view, ts_row_v3(in, BIAS_P)).z);
}

/* clang-format off */
#define SURFACE_OUT COLUMN("p", F32, 3), COLUMN("n", F32, 3), COLUMN("face", F32, 3), COLUMN("base", F32, 3), \
	COLUMN("emissive", F32, 3), COLUMN("metallic", F32, 1), COLUMN("roughness", F32, 1), COLUMN("occlusion", F32, 1), \
	COLUMN("flags", U32, 1)
#define VERTEX(name) NEAR(name ".position", 3), ZERO(name ".object", 1), UNIT(name ".normal"), ZERO(name ".pad", 1), \
	{ name ".tangent", TS_VECTOR_F32, 4, 88, 127, true }, NEAR(name ".uv", 4), SHARE(name ".colour", 4)

const ts_vector ts_composites_shade[] = {
	{ PRIMITIVE(light), "ts_k_light",
	  "direction l from p to the light, and the factor by which its intensity arrives (KHR_lights_punctual)",
	  { LIGHT("light"), NEAR("p", 3) }, { COLUMN("l", F32, 3), COLUMN("arrives", F32, 1) }, .relate = relate_light },
	{ PRIMITIVE(brdf), "ts_k_brdf", "BRDF of glTF 2.0 times n.l; n, v and l are unit vectors, n.l is above 0",
	  { UNIT("n"), UNIT("v"), UNIT("l"), POSITIVE("n_l", 1, 88, 127), SHARE("base", 3), SHARE("metallic", 1),
	    SHARE("roughness", 1) }, GIVES(F32, 3), .relate = relate_brdf },
	{ PRIMITIVE(shade), "ts_k_shade", "radiance towards v of a surface that one light shines on",
	  { NEAR("p", 3), UNIT("n"), UNIT("face"), SHARE("base", 3), LENGTH("emissive", 3), SHARE("metallic", 1),
	    SHARE("roughness", 1), SHARE("occlusion", 1), UNSIGNED("flags", 1, 0, 7), UNIT("v"), SHARE("ambient", 1),
	    LIGHT("light") }, GIVES(F32, 3), .relate = relate_shade },
	{ PRIMITIVE(surface), "ts_k_surface",
	  "surface of a triangle a b c at these weights, with normal map, tangents and textures, all of one image",
	  { { "texels", TS_VECTOR_U64, 5, INT64_MIN, INT64_MAX, false }, UNSIGNED("image.width", 1, 2, 2),
	    UNSIGNED("image.height", 1, 2, 2), UNSIGNED("image.n_levels", 1, 2, 2), ZERO("image.pad", 1),
	    { "image.first_texel", TS_VECTOR_U64, 1, 0, 0, false }, ZERO("slot.image", 1), FLAG("slot.uv_set"),
	    UNSIGNED("slot.wrap", 2, 0, 2), NEAR("slot.transform", 6), ZERO("slot.pad", 2), SHARE("material.base", 4),
	    LENGTH("material.emissive", 3), SHARE("material.metallic", 1), SHARE("material.roughness", 1),
	    LENGTH("material.normal_scale", 1), SHARE("material.occlusion", 1), SHARE("material.alpha_cutoff", 1),
	    ANY_INDEX("material.slot", 5), UNSIGNED("material.flags", 1, 0, 7), ZERO("material.pad", 2),
	    UNSIGNED("triangle.vertex", 3, 0, 2), ZERO("triangle.material", 1), ZERO("object.first_vertex", 1),
	    UNSIGNED("object.n_vertices", 1, 3, 3), ANY_INDEX("object.reflector", 1), ZERO("object.period", 1),
	    NEAR("object.centre", 3), NEAR("object.phase", 1), NEAR("object.axis", 2), NEAR("object.bob", 1),
	    NEAR("object.spin", 1), VERTEX("a"), VERTEX("b"), VERTEX("c"), SHARE("w", 3), LENGTH("footprint", 1) },
	  { SURFACE_OUT }, .relate = relate_surface },
	{ PRIMITIVE(shadow_bias), "ts_k_shadow_bias",
	  "bias of a depth map at a point p with normal n; z is the axial depth of p",
	  { VIEW("view"), FLAG("orthographic"), LENGTH("bias", 1), LENGTH("slope", 1),
	    { "p", TS_VECTOR_F32, 3, 107, 133, true }, UNIT("n"), POSITIVE("z", 1, 107, 150) }, GIVES(F32, 1),
	  .relate = relate_bias },
	{ 0 },
};
/* clang-format on */

/* Eye-based point rendering of cube-mapped reflections.
 * Paper: "Eye-Based Point Rendering for Dynamic Multiview Effects" (2022), sections 3 and 4.
 *
 * Once per frame the triangles become points, no denser than the eye can distinguish in any mirror (section 4.1.1). The
 * points are splatted into cube maps sized for the eye, which store indices, not colours (3.5). The eye's reflective
 * pixels shade just the points they see, recursively where those lie on mirrors (4.1.2 to 4.1.4).
 *
 * Deviations, each with the switch that restores the paper:
 * - density uses the triangle's point nearest the path, not its circumcentre, which can lie far outside
 *   (density.path=paper);
 * - visibility clears a bit only if all corners lie outside one plane: corners in enlarged frusta, the paper's test,
 *   lose large triangles (visibility.test=vertex);
 * - triangles of more than 2^16 samples are bisected, so that one density serves each piece (points.split=off);
 * - a sub-pixel triangle keeps the splat length 1/s inside its own box: the square root of its area leaves gaps
 *   (splat.size=paper);
 * - an edge of more than 2^14 samples is bisected and limited too, so that lattices stay within 2^15
 *   (points.split=off);
 * - points lie in the order of the pieces, so that two runs have the same bytes (--order arrival);
 * - one bounce by default, so that MVR and truth C show the same thing (lookup.bounces=2, lookup.bounces=3).
 *
 * Two variants that the paper mentions and does not follow, with all of the above:
 * - epr-bufferless (3.4) stores no points. The paper does not define its texels; ours hold the index that the point
 *   would have, so that the picture equals EPR's to the bit, and bounces work;
 * - epr-forward (3.5) has cubes of colours. The paper does not define how view-dependent light is computed "once per
 *   point": ours is lit for the mirror with the shortest path to the eye, eq. 2, or for the eye (forward.viewer=eye).
 *   Nor does it name the format of colours: ours share an exponent. There is always one bounce, for colours on mirrors
 *   are not followed.
 *
 * Omnidirectional soft shadows (section 5): points no denser than the eye can distinguish in any shadow are written or
 * splatted into the cubes of a light's samples, which are resolved as iVIR's. Deviations:
 * - eq. 5 compares a ratio of distances with a scale; by default the rate is a bound on what the eye can distinguish,
 *   with the magnification from occluder to receiver, and at most iVIR's (shadow_splat.rate=paper: the ratio is a share
 *   of iVIR's scale, at the light sample where it is largest; shadow_splat.rate=unit: pixels per unit of distance);
 * - iVIR's scale is the one that gives each texel a sample, as there (density.rate=paper), for one light sample, not
 *   all;
 * - splats have the depth of the triangle's plane in each texel: one depth per splat shadows its own surface
 *   (shadow_splat.depth=point);
 * - eq. 6 takes the distances from triangles, not from pixels, and one resolution serves all cubes, as printed. It is a
 *   multiple of 32 (cube.hysteresis), as hysteresis would need the G-buffers of all frames before;
 * - points are made for every eight views, not kept (points.buffered=on); what is counted is one pass over the geometry
 *   per batch. */
#include "kernels/points/samples.h"
#include "methods/points/pipelines.h"
#include "methods/points/points.h"
#include "methods/stages.h"

static const ts_step piece_run[] = {
	{.stage = "cube_size"},    /* 3.5: cubes as large as their reflectors in the eye */
	{.stage = "eye"},          /* the eye's G-buffer */
	{.stage = "mirror_pixel"}, /* 4.1.3: reflective pixels and their normal gradients */
	{.stage = "visibility"},   /* 3.1: which faces may see a triangle */
	{.stage = "split"},        /* 4.1.1: eye-resolution density */
	{.stage = "cull"},         /* 3.2: stochastic culling */
	{.stage = "align"},        /* 3.2: T_epr */
	{0},
};

static const ts_step point_run[] = {
	{.stage = "points.count", .only_ordered = true}, /* 3.3: conservative rasterization in the triangle's plane */
	{.stage = "points"},                             /* 3.4: the point buffers */
	{0},
};

/* Stages of look-ups read points.offset only for epr-bufferless: EPR stores its points and frees the offsets early. */
static bool stores(const ts_params *params)
{
	(void)params;
	return true;
}
#define STORED .spares = stores, .spared = TS_B_points_offset

static const ts_step epr_steps[] = {
	{.run = ts_frame_run},
	{.run = piece_run},
	{.run = point_run},
	{.stage = "splat"}, /* 3.5: indexed G-buffer cubes */
	{.stage = "splat.tie", .only_traced = true},
	{.stage = "lookup"},                                    /* 4.1.3: 25 samples per reflective pixel */
	{.stage = "lookup.second", .least_bounces = 2, STORED}, /* 4.1.4: points on mirrors look up again */
	{.stage = "lookup.third", .least_bounces = 3, STORED},
	{.stage = "shade.third", .least_bounces = 3, STORED}, /* 4.1.2: only points that were looked up are shaded */
	{.stage = "shade.second", .least_bounces = 2, STORED},
	{.stage = "shade", STORED},
	{.stage = "image"},
	{0},
};

/* 3.4: "a bufferless implementation in which the fragment shader splatted points directly". Texels are EPR's, and
 * readers of an index make its point again, from the counts of points. */
static const ts_step bufferless_steps[] = {
	{.run = ts_frame_run},
	{.run = piece_run},
	{.stage = "points.count"},
	{.stage = "splat.direct"},
	{.stage = "splat.direct_tie", .only_traced = true},
	{.stage = "lookup"},
	{.stage = "lookup.second", .least_bounces = 2},
	{.stage = "lookup.third", .least_bounces = 3},
	{.stage = "shade.third", .least_bounces = 3},
	{.stage = "shade.second", .least_bounces = 2},
	{.stage = "shade"},
	{.stage = "image"},
	{0},
};

/* 3.5: "If the buffers contain forward rendering results, the lighting computation need only be performed once per
 * point". */
static const ts_step forward_steps[] = {
	{.run = ts_frame_run},      {.run = piece_run},
	{.run = point_run},         {.stage = "forward"}, /* every point is lit */
	{.stage = "splat.colour"},                        /* cubes of colours */
	{.stage = "lookup.colour"}, {.stage = "shade.colour"},
	{.stage = "image"},         {0},
};

static const ts_step epr_omni_steps[] = {
	{.run = ts_frame_run},
	{.stage = "lamp.ball"},
	{.stage = "eye"},
	{.stage = "shadow_cube_size"}, /* eq. 6: cubes as large as the eye needs */
	{.stage = "offscreen"},
	{.stage = "offscreen.visibility"},
	{.stage = "split.shadow"}, /* eq. 5: eye-resolution density */
	{.stage = "cull"},
	{.stage = "align"},
	{.stage = "points.count", .only_ordered = true, .stored = TS_STORED_IF_ASKED},
	{.stage = "points", .stored = TS_STORED_IF_ASKED},
	{.stage = "shadow_splat", .each_batch = true}, /* small points directly, large ones as splats */
	{.run = ts_resolve_run},
	{0},
};

/* Points: two for each small triangle, and as many as the cubes' texels can hold or the eye's pixels distinguish. */
static void epr_expect(ts_expected *expected, const ts_scene *scene, const ts_params *params)
{
	u64 triangles = scene->n_triangles;
	u64 pixels = (u64)TS_PARAM(params, width) * TS_PARAM(params, height);
	u64 face = ts_expected_face(params);
	u64 texels = 6 * face * face * scene->info.n_reflectors, limiting = ts_greatest_side(params);
	double rho = (double)ts_samples_a_pixel(params), wanted = 6.0 * rho * rho * (double)pixels;
	u64 most = 4 * (limiting != 0 ? 6 * limiting * limiting * scene->info.n_reflectors : texels);
	u64 points = TS_PARAM(params, density_cap) && wanted > (double)most ? most : (u64)wanted;
	u64 *n = expected->sizes.n, entries = ts_expect_mirrors(expected, scene, params);
	n[TS_DIM_pieces] = triangles + triangles / 16;
	n[TS_DIM_points] = 2 * triangles + points;
	n[TS_DIM_texels] = texels;
	n[TS_DIM_second_bounces] = entries * TS_N_SAMPLES / 8;
	n[TS_DIM_third_bounces] = entries * TS_N_SAMPLES / 16;
}

const ts_pipeline ts_pipeline_epr_reflections = {
	.name = "epr",
	.effect = &ts_effect_reflections,
	.paper = "EPR 3 and 4",
	.doc = "eye-based point rendering: one pass over the geometry for all cubes",
	.steps = epr_steps,
	.expect = epr_expect,
};

const ts_pipeline ts_pipeline_epr_bufferless = {
	.name = "epr-bufferless",
	.effect = &ts_effect_reflections,
	.paper = "EPR 3.4",
	.doc = "epr without buffers of points: points are splatted as they are made, and made again where they are seen",
	.steps = bufferless_steps,
	.expect = epr_expect,
	.only_named = true,
};

const ts_pipeline ts_pipeline_epr_forward = {
	.name = "epr-forward",
	.effect = &ts_effect_reflections,
	.paper = "EPR 3.5",
	.doc = "epr with cubes of colours: every point is lit once for all cubes",
	.steps = forward_steps,
	.expect = epr_expect,
	.only_named = true,
};

const ts_pipeline ts_pipeline_epr_omni = {
	.name = "epr",
	.effect = &ts_effect_omni_shadows,
	.paper = "EPR 5",
	.doc = "points no denser than the eye can resolve in a shadow, splatted into the cubes of all light samples",
	.steps = epr_omni_steps,
	.plan = ts_ivir_omni_plan,
	.expect = ts_omni_expect,
};

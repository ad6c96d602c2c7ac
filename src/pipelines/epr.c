/* Eye-based point rendering of cube-mapped reflections.
 * Paper: "Eye-Based Point Rendering for Dynamic Multiview Effects" (2022), sections 3 and 4.
 *
 * Once a frame the triangles become points, no denser than the eye can tell in any mirror (section 4.1.1); the points are
 * splatted into cube maps sized for the eye, which store indices, not colours (3.5); and the eye's reflective pixels shade
 * just the points they see, recursively where those lie on mirrors (4.1.2 to 4.1.4).
 *
 * Deviations, each with the switch that restores the paper:
 * - density uses the triangle's point nearest the path, not its circumcentre, which can lie far outside (density=paper);
 * - visibility clears a bit only if all corners lie outside one plane: corners in enlarged frusta, the paper's test, lose
 *   large triangles (visibility=vertex);
 * - triangles of more than 2^16 samples are bisected, so that one density serves each piece (split=off);
 * - the tenth of a pixel below which triangles may be culled is the eye's, not the point raster's, whose survivors are
 *   too few at rho_scale 1/2 (cull_unit=raster);
 * - a sub-pixel triangle keeps the splat length 1/s inside its own box: the square root of its area leaves gaps
 *   (splat=paper);
 * - an edge of more than 2^14 samples is bisected and limited too, so that lattices stay within 2^15 (split=off);
 * - plane depth stays within a tile of the point's own distance (planedepth=off);
 * - one bounce by default, so that MVR and truth C show the same thing (bounces=2). */
#include "pipelines.h"

#include "../stages/stages.h"

static const char *const points[] = {
	"view",       /* where the eye is */
	"pose",       /* where everything else is */
	"resize",     /* 3.5: cubes as large as their reflectors in the eye */
	"eye",        /* the eye's G-buffer */
	"pixel",      /* 4.1.3: reflective pixels and their normal gradients */
	"visibility", /* 3.1: which faces may see a triangle */
	"split",      /* 4.1.1: eye-resolution density */
	"cull",       /* 3.2: stochastic culling */
	"align",      /* 3.2: T_epr */
	"count",      /* 3.3: conservative rasterization in the triangle's plane */
	"points",     /* 3.4: the point buffers */
	"splat",      /* 3.5: indexed G-buffer cubes */
	"lookup",     /* 4.1.3: 25 samples a reflective pixel */
	NULL,
};
static const char *const second_bounce[] = {"lookup2", NULL};
static const char *const third_bounce[] = {"lookup3", "shade3", NULL};
static const char *const shade_second[] = {"shade2", NULL};
static const char *const picture[] = {"shade", "image", NULL};

ts_status ts_epr_run(ts_run *run)
{
	u32 bounces = run->params.bounces;
	if (ts_run_stages(run, points) != TS_OK) return TS_ERROR;
	if (bounces > 1 && ts_run_stages(run, second_bounce) != TS_OK) return TS_ERROR;
	if (bounces > 2 && ts_run_stages(run, third_bounce) != TS_OK) return TS_ERROR;
	if (bounces > 1 && ts_run_stages(run, shade_second) != TS_OK) return TS_ERROR;
	return ts_run_stages(run, picture);
}

/* Points: two for each small triangle, and what the mirrors' pixels can tell apart of the large ones. */
u64 ts_epr_estimate(const ts_scene *scene, const ts_params *params)
{
	u64 triangles = scene->n_triangles;
	u64 words = ((u64)scene->n_reflectors * 6 + 63) / 64;
	u64 pixels = (u64)params->width * params->height;
	u64 face = params->face_px != 0 ? params->face_px : ts_largest_face(params);
	u64 n_points = 2 * triangles + (u64)((double)params->rho_scale * params->rho_scale * 8.0 * (double)pixels);
	u64 pieces = triangles + triangles / 4;
	return ts_common_estimate(scene, params) + triangles * (words * sizeof(u64) + sizeof(u32)) +
	       pieces * (sizeof(ts_piece) + sizeof(ts_align) + 3 * sizeof(u32)) + n_points * (sizeof(ts_point) + sizeof(u64)) +
	       6 * face * face * scene->n_reflectors * sizeof(u64) + pixels / 4 * TS_N_SAMPLES * sizeof(u32);
}

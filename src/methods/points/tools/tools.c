/* The tables of points for the tools. */
#include "methods/points/tools/tools.h"
#include "methods/points/tools/benches.h"
#include "methods/points/tools/probe.h"
#include "methods/tools/family.h"

static const ts_tie_rule ties[] = {
	{TS_B_splat_depth_index, ts_splat_ties_open, ts_splat_tie_allows, ts_splat_ties_close},
	{0},
};

#define CHANCE 0.00000095367431640625f /* 2^-20 of a random number's range */

static const ts_margin_rule margins[] = {
	{TS_B_cull_keep, TS_B_cull_margin, .of = 1, .steps = CHANCE},
	{TS_B_splat_depth_index, TS_B_splat_tie, .of = 1},
	{0},
};

static const ts_buffer_id of_epr[] = {TS_B_eye_view,           TS_B_pose_vertex,         TS_B_cube_size_face,
                                      TS_B_eye_depth_triangle, TS_B_mirror_pixel_offset, TS_B_mirror_pixel_record,
                                      TS_B_lookup_point,       TS_B_shade_radiance,      TS_N_BUFFERS};

/* Truth C rasterizes: it has no rays to sample. */
static ts_status large_mvr(f32 **radiance, const ts_scene *scene, const ts_params *params, u32 threads,
                           ts_sampling *sampling)
{
	(void)sampling;
	return ts_truth_c(radiance, scene, params, TS_TRUTH_C_FACTOR, threads);
}

#define OF_SHADOWS .begin = ts_truth_shadow_begin, .image = "image.shadow", .bytes = ts_truth_shadow_bytes

/* A method differs from A by its sampling, and A from B by the use of cube centres, which all methods share. It differs
 * from rays to the samples of lights by its own error, and these from rays to whole lights by the sampling of
 * lights. */
static const ts_truth_kind truths[] = {
	{"A", "reflections", "rays from the cube's centre along EPR's own directions", "sampling", "B", "method",
     .needs = of_epr, .trace = ts_truth_a, .image = "image", .missed = ts_truth_missed},
	{"B", "reflections", "true reflections from the surface", "both", "", "", .needs = of_epr, .trace = ts_truth_b,
     .image = "image"},
	{"C", "reflections", "MVR at 4 times the resolution, box-filtered", "", "", "", .radiance = large_mvr,
     .rays = ts_truth_c_rays, .bytes = ts_truth_c_bytes},
	{"samples", "soft-shadows omni-shadows", "rays to the very samples of the lights", "method", "area", "sampling",
     .trace = ts_truth_samples, OF_SHADOWS},
	{"area", "soft-shadows omni-shadows", "rays to truth.area_samples samples of each light", "both", "", "",
     .trace = ts_truth_area, OF_SHADOWS},
	{0},
};

static const ts_texel_rule texels[] = {
	{TS_B_depth_map_depth, ts_truth_texels},
	{TS_B_scatter_colour, ts_truth_texels},
	{TS_B_cube_face_depth_triangle, ts_truth_texels},
	{0},
};

/* clang-format off */
static const ts_probe_part parts[] = {
	{TS_PROBE_PIXEL, "lookup", ts_probe_epr_pixel, "what samples of a mirror looked up, and the bounces behind it",
	NULL},
	{TS_PROBE_PIXEL, "lookup.colour", ts_probe_forward_pixel, "the colours that samples of a mirror looked up",
	NULL},
	{TS_PROBE_PIXEL, "mirror", ts_probe_mvr_pixel, "what a mirror looked up in the levels of its cube", NULL},
	{TS_PROBE_PIXEL, "pcss", ts_probe_pcss_pixel, "of each light the blockers, and how wide its taps are spread", NULL},
	{TS_PROBE_TEXEL, "splat", ts_probe_epr_texel, "the points that competed for it", &ts_probe_face},
	{TS_PROBE_TEXEL, "splat.direct", ts_probe_epr_texel, "the same of points that are not stored", &ts_probe_face},
	{TS_PROBE_TEXEL, "splat.colour", ts_probe_forward_texel, "the colours of points that competed for it",
	&ts_probe_face},
	{TS_PROBE_TEXEL, "cube_face", ts_probe_mvr_texel, "the triangles that competed for it, and its light",
	&ts_probe_face},
	{TS_PROBE_TRIANGLE, "splat", ts_probe_epr_triangle, "its pieces and points, and which stage lost it", NULL},
	{TS_PROBE_TRIANGLE, "splat.direct", ts_probe_epr_triangle, "the same of points that are not stored", NULL},
	{TS_PROBE_TRIANGLE, "cube_face", ts_probe_mvr_triangle, "the texels that it won, and who took the others", NULL},
	{TS_PROBE_POINT, "splat", ts_probe_epr_point, "the texels that it won, and which stage lost it", NULL},
	{TS_PROBE_POINT, "splat.direct", ts_probe_epr_point, "the same of points that are not stored", NULL},
	{0},
};
/* clang-format on */

static const ts_viewer_rule viewers[] = {
	{TS_B_points_record, ts_points_view},
	{0},
};

/* The mask of reflective pixels. */
static const ts_buffer_id keeps[] = {TS_B_mirror_pixel_record, TS_B_lamp_light, TS_N_BUFFERS};

const ts_family_tools ts_points_tools = {
	.places = ts_points_places,
	.ties = ties,
	.margins = margins,
	.checks = ts_points_checks,
	.pictures = ts_points_pictures,
	.truths = truths,
	.texels = texels,
	.codes = ts_points_codes,
	.parts = parts,
	.marks = ts_points_marks,
	.viewers = viewers,
	.keeps = keeps,
	.bytes = ts_points_bytes,
	.figures = ts_points_figures,
};

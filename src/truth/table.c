/* The ground truths. */
#include "table.h"

static const ts_buffer_id of_epr[] = { TS_B_eye_view, TS_B_pose_vertex, TS_B_resize_face, TS_B_eye_depth_triangle,
	TS_B_pixel_offset, TS_B_pixel_record, TS_B_lookup_point, TS_B_shade_radiance, TS_N_BUFFERS };

static ts_status large_mvr(f32 **radiance, const ts_scene *scene, const ts_params *params, u32 threads)
{
	return ts_truth_c(radiance, scene, params, TS_TRUTH_C_FACTOR, threads);
}

#define OF_SHADOWS .begin = ts_truth_shadow_begin, .image = "shadow_image", .bytes = ts_truth_shadow_bytes
#define OF_INDIRECT .begin = ts_truth_indirect_begin, .image = "indirect_image"

/* A method is apart from A by its sampling, and A from B by what the cube's centre costs every method. It is apart from
 * rays to the samples of lights by its own error, and these from the whole lights by what sampling them costs. */
const ts_truth_kind ts_truth_table[] = {
	{ "A", "reflections", "rays from the cube's centre along EPR's own directions", "sampling", "B", "method",
	  .needs = of_epr, .trace = ts_truth_a, .image = "image", .counts_missed = true },
	{ "B", "reflections", "true reflections from the surface", "both", "", "",
	  .needs = of_epr, .trace = ts_truth_b, .image = "image" },
	{ "C", "reflections", "MVR at 4 times the resolution, box-filtered", "", "", "",
	  .radiance = large_mvr, .bytes = ts_truth_c_bytes },
	{ "samples", "soft-shadows omni-shadows", "rays to the very samples of the lights", "method", "area", "sampling",
	  .trace = ts_truth_samples, OF_SHADOWS },
	{ "area", "soft-shadows omni-shadows", "rays to area_samples samples of each light", "both", "", "",
	  .trace = ts_truth_area, OF_SHADOWS },
	{ "lights", "indirect", "the method's triangles of light, where they are seen", "", "bounce", "",
	  .trace = ts_truth_lights, OF_INDIRECT },
	{ "bounce", "indirect", "light after one bounce, path by path", "", "", "",
	  .trace = ts_truth_bounce, OF_INDIRECT },
	{ "vpls", "indirect", "all virtual point lights, where they are seen", "method", "", "",
	  .trace = ts_truth_vpls, OF_INDIRECT },
	{ "glow", "particles", "all particles, where they are seen", "method", "", "",
	  .begin = ts_truth_particles_begin, .trace = ts_truth_glow, .image = "indirect_image" },
	{ "discs", "surfels", "rays into the surfels themselves", "method", "surface", "sampling",
	  .radiance = ts_truth_discs, .bytes = ts_truth_discs_bytes },
	{ "surface", "surfels", "rays into what the surfels are samples of", "both", "", "",
	  .radiance = ts_truth_surface, .bytes = ts_truth_surface_bytes,
	  .exists = ts_truth_has_surface, .why_not = "what its surfels are samples of is not known" },
	{ 0 }
};
_Static_assert(sizeof ts_truth_table / sizeof ts_truth_table[0] <= TS_MAX_TRUTHS + 1, "sets of truths have 32 bits");

bool ts_truth_starts_from(const ts_truth_kind *kind, const ts_pipeline *method)
{
	return kind->needs != NULL && ts_pipeline_makes(method, kind->needs);
}

/* What stages there are: what each reads, writes and computes. */
#include "stages.h"

#define SCENE \
	TS_B_pose_vertex, TS_B_scene_triangle, TS_B_scene_material, TS_B_scene_slot, TS_B_scene_image, TS_B_scene_texel, \
		TS_B_scene_light, TS_B_scene_object, TS_B_scene_info
#define SHAPES TS_B_pose_vertex, TS_B_scene_triangle, TS_B_scene_material, TS_B_scene_object
/* What turns a point into a surface. */
#define POINTS SCENE, TS_B_resize_face, TS_B_split_triangle, TS_B_align_frame, TS_B_points_key, TS_B_points_record
#define LAMPS TS_B_lamp_light, TS_B_lamp_shape
/* What points are made from without being stored. */
#define PIECES SCENE, TS_B_split_triangle, TS_B_align_frame
#define END TS_N_BUFFERS

const ts_stage ts_stage_table[] = {
	{"view", "map", {TS_B_scene_info, END}, {TS_B_eye_view, END}, ts_stage_view, "EPR 4.2",
	 "the eye, circling the scene or the file's camera"},
	{"pose", "map", {TS_B_scene_vertex, TS_B_scene_object, END}, {TS_B_pose_vertex, END}, ts_stage_pose, "EPR 4.2",
	 "moving objects to their place in this frame"},
	{"resize", "map", {TS_B_scene_vertex, TS_B_scene_object, TS_B_scene_info, END}, {TS_B_resize_face, END},
	 ts_stage_resize, "EPR 3.5", "box, ball and cube size of every reflector"},
	{"eye", "scatter", {SCENE, TS_B_eye_view, END}, {TS_B_eye_depth_triangle, END}, ts_stage_eye, "EPR 4.1.3",
	 "standard rasterization of the eye's view"},
	{"eye_margin", "scatter", {SCENE, TS_B_eye_view, TS_B_eye_depth_triangle, END}, {TS_B_eye_margin, END},
	 ts_stage_eye_margin, "EPR 4.1.3", "how near the eye's coverage and depths were to another answer"},
	{"pixel", "emit", {SCENE, TS_B_eye_view, TS_B_eye_depth_triangle, END}, {TS_B_pixel_offset, TS_B_pixel_record, END},
	 ts_stage_pixel, "EPR 4.1.3", "reflective pixels with gradients of position and normal"},
	{"visibility", "map", {SHAPES, TS_B_resize_face, END}, {TS_B_visibility_bits, END}, ts_stage_visibility, "EPR 3.1",
	 "one bit a triangle and cube face"},
	{"split", "emit", {SHAPES, TS_B_resize_face, TS_B_eye_view, TS_B_visibility_bits, END},
	 {TS_B_split_scale, TS_B_split_offset, TS_B_split_triangle, TS_B_density_scale, END}, ts_stage_split,
	 "EPR 4.1.1, eqs 2 and 3",
	 "density of every triangle; large ones in pieces"},
	{"cull", "map", {TS_B_split_triangle, TS_B_density_scale, END}, {TS_B_cull_keep, END}, ts_stage_cull, "EPR 3.2",
	 "stochastic culling of sub-pixel pieces"},
	{"cull_margin", "map", {TS_B_split_triangle, TS_B_density_scale, END}, {TS_B_cull_margin, END}, ts_stage_cull_margin,
	 "EPR 3.2", "how near the random numbers were to their thresholds"},
	{"align", "map", {TS_B_split_triangle, TS_B_density_scale, TS_B_cull_keep, END}, {TS_B_align_frame, END},
	 ts_stage_align, "EPR 3.2, eq. 1", "T_epr: every piece in its own plane"},
	{"count", "emit", {SCENE, TS_B_split_triangle, TS_B_align_frame, END}, {TS_B_count_offset, END}, ts_stage_count,
	 "EPR 3.3", "points of every piece, counted and summed"},
	{"points", "emit", {SCENE, TS_B_split_triangle, TS_B_align_frame, TS_B_count_offset, END},
	 {TS_B_points_key, TS_B_points_record, END}, ts_stage_points, "EPR 3.4, eq. 4", "points with splat lengths"},
	{"splat", "scatter",
	 {TS_B_resize_face, TS_B_split_triangle, TS_B_align_frame, TS_B_visibility_bits, TS_B_count_offset, TS_B_points_record,
	  END},
	 {TS_B_splat_depth_index, END}, ts_stage_splat, "EPR 3.5", "points into cube faces by 64-bit minimum"},
	{"tie", "scatter",
	 {TS_B_resize_face, TS_B_split_triangle, TS_B_align_frame, TS_B_visibility_bits, TS_B_points_record,
	  TS_B_splat_depth_index, END},
	 {TS_B_splat_tie, END}, ts_stage_tie, "EPR 3.5", "texels that another point of the same distance might have won"},
	{"lookup", "map",
	 {TS_B_eye_view, TS_B_resize_face, TS_B_splat_depth_index, TS_B_pixel_record, END}, {TS_B_lookup_point, END},
	 ts_stage_lookup, "EPR 4.1.3", "25 look-ups a reflective pixel"},
	{"lookup2", "emit",
	 {POINTS, TS_B_splat_depth_index, TS_B_pixel_record, TS_B_lookup_point, END},
	 {TS_B_lookup2_offset, TS_B_lookup2_parent, TS_B_lookup2_point, END}, ts_stage_lookup2, "EPR 4.1.4",
	 "four look-ups for each sample that sees a mirror"},
	{"lookup3", "emit",
	 {POINTS, TS_B_splat_depth_index, TS_B_lookup2_point, TS_B_lookup2_parent, END},
	 {TS_B_lookup3_offset, TS_B_lookup3_parent, TS_B_lookup3_point, END}, ts_stage_lookup3, "EPR 4.1.4",
	 "the same once more"},
	{"shade3", "map", {POINTS, TS_B_lookup3_point, TS_B_lookup3_parent, END},
	 {TS_B_shade3_radiance, END}, ts_stage_shade3, "EPR 4.1.4", "deferred shading of the third bounce"},
	{"shade2", "map",
	 {POINTS, TS_B_lookup2_point, TS_B_lookup2_parent, TS_B_lookup3_offset, TS_B_shade3_radiance, END},
	 {TS_B_shade2_radiance, END}, ts_stage_shade2, "EPR 4.1.4", "deferred shading of the second bounce"},
	{"shade", "map",
	 {POINTS, TS_B_pixel_record, TS_B_lookup_point, TS_B_lookup2_offset, TS_B_lookup2_point, TS_B_lookup3_point,
	  TS_B_shade2_radiance, END},
	 {TS_B_shade_radiance, TS_B_shade_used, END}, ts_stage_shade, "EPR 4.1.2", "eye-based deferred shading"},
	{"face", "scatter", {SCENE, TS_B_resize_face, END}, {TS_B_face_depth_triangle, END}, ts_stage_face, "EPR 4.2",
	 "MVR: standard rasterization into six faces a reflector"},
	{"face_margin", "scatter", {SCENE, TS_B_resize_face, TS_B_face_depth_triangle, END}, {TS_B_face_margin, END},
	 ts_stage_face_margin, "EPR 4.2", "how near the faces' coverage and depths were to another answer"},
	{"illuminate", "map", {SCENE, TS_B_resize_face, TS_B_face_depth_triangle, END}, {TS_B_face_mip, END},
	 ts_stage_illuminate, "EPR 4.2", "MVR: deferred shading of every texel, and the mip chain"},
	{"mirror", "map", {TS_B_eye_view, TS_B_resize_face, TS_B_pixel_record, TS_B_face_mip, END},
	 {TS_B_shade_radiance, END}, ts_stage_mirror, "EPR 4.2", "MVR: mip-mapped look-ups of the reflective pixels"},
	{"image", "map", {SCENE, TS_B_eye_view, TS_B_eye_depth_triangle, TS_B_pixel_offset, TS_B_shade_radiance, END},
	 {TS_B_image_radiance, TS_B_image_srgb, END}, ts_stage_image, "EPR 4.1.2", "the picture"},
	{"lamp", "map", {TS_B_scene_info, TS_B_scene_light, END}, {LAMPS, END}, ts_stage_lamp, "iVIR 4",
	 "the lights whose shadows are soft"},
	{"lamp_view", "map", {TS_B_scene_info, LAMPS, END}, {TS_B_offscreen_view, END}, ts_stage_lamp_view, "iVIR 4",
	 "a depth map for each sample of each light"},
	{"lamp_ball", "map", {TS_B_scene_info, END}, {LAMPS, END}, ts_stage_lamp_ball, "iVIR 6",
	 "the light whose shadows fall all around it"},
	{"lamp_cube", "map", {TS_B_scene_info, LAMPS, END}, {TS_B_resize_face, END}, ts_stage_lamp_cube, "iVIR 6",
	 "a cube for each sample of the light"},
	{"offscreen", "map", {TS_B_resize_face, TS_B_lamp_light, END}, {TS_B_offscreen_view, END}, ts_stage_offscreen, "iVIR 5",
	 "six off-screen views a cube"},
	{"offscreen_visibility", "map", {SHAPES, TS_B_offscreen_view, END}, {TS_B_visibility_bits, END},
	 ts_stage_offscreen_visibility, "iVIR 3.1", "one bit a triangle and off-screen view"},
	{"view_split", "emit", {SHAPES, TS_B_eye_view, TS_B_offscreen_view, TS_B_visibility_bits, END},
	 {TS_B_split_scale, TS_B_split_offset, TS_B_split_triangle, TS_B_density_scale, END}, ts_stage_view_split,
	 "iVIR 3.1, eqs 2 and 3", "density of every triangle from the off-screen views; uneven and large ones in pieces"},
	{"scatter", "scatter",
	 {PIECES, TS_B_resize_face, TS_B_offscreen_view, TS_B_visibility_bits, TS_B_points_key, TS_B_points_record, END},
	 {TS_B_scatter_depth, END}, ts_stage_scatter, "iVIR 4", "points into depth maps by 32-bit minimum"},
	{"scatter_colour", "scatter",
	 {PIECES, TS_B_resize_face, TS_B_offscreen_view, TS_B_visibility_bits, TS_B_points_key, TS_B_points_record, END},
	 {TS_B_scatter_colour, END}, ts_stage_scatter_colour, "iVIR 5",
	 "points into environment maps: 13 bits of depth, 19 of colour"},
	{"shadow_resize", "scatter", {SHAPES, TS_B_scene_info, TS_B_eye_view, TS_B_eye_depth_triangle, LAMPS, END},
	 {TS_B_shadow_resize_least, TS_B_resize_face, END}, ts_stage_shadow_resize, "EPR 5.1, eq. 6",
	 "a cube for each sample of the light, as large as the eye needs it"},
	{"shadow_split", "emit", {SHAPES, TS_B_eye_view, TS_B_offscreen_view, TS_B_visibility_bits, END},
	 {TS_B_split_scale, TS_B_split_offset, TS_B_split_triangle, TS_B_density_scale, END}, ts_stage_shadow_split,
	 "EPR 5.1, eq. 5", "density of every triangle from the off-screen views and the eye"},
	{"shadow_splat", "scatter",
	 {PIECES, TS_B_resize_face, TS_B_offscreen_view, TS_B_visibility_bits, TS_B_points_key, TS_B_points_record, END},
	 {TS_B_scatter_depth, END}, ts_stage_shadow_splat, "EPR 5.1",
	 "points into depth maps: small ones as they are, large ones as squares"},
	{"copy", "map", {TS_B_resize_face, TS_B_scatter_colour, END}, {TS_B_face_mip, END}, ts_stage_copy, "iVIR 5",
	 "environment maps into mip chains"},
	{"depth", "scatter", {SCENE, TS_B_resize_face, TS_B_offscreen_view, END}, {TS_B_scatter_depth, END}, ts_stage_depth,
	 "iVIR 4", "MVR: standard rasterization into every depth map"},
	{"depth_margin", "scatter", {SCENE, TS_B_resize_face, TS_B_offscreen_view, TS_B_scatter_depth, END},
	 {TS_B_depth_margin, END}, ts_stage_depth_margin, "iVIR 4",
	 "how near the depth maps' coverage and depths were to another answer"},
	{"resolve", "map",
	 {SCENE, TS_B_resize_face, TS_B_eye_view, TS_B_eye_depth_triangle, TS_B_lamp_shape, TS_B_offscreen_view,
	  TS_B_scatter_depth, END},
	 {TS_B_resolve_lit, END}, ts_stage_resolve, "iVIR 4", "how many light samples reach each pixel"},
	{"resolve_margin", "map",
	 {SCENE, TS_B_resize_face, TS_B_eye_view, TS_B_eye_depth_triangle, TS_B_lamp_shape, TS_B_offscreen_view,
	  TS_B_scatter_depth, END},
	 {TS_B_resolve_margin, END}, ts_stage_resolve_margin, "iVIR 4",
	 "how near the comparisons with depth maps were to another answer"},
	{"pcss", "map",
	 {SCENE, TS_B_eye_view, TS_B_eye_depth_triangle, TS_B_lamp_shape, TS_B_offscreen_view, TS_B_scatter_depth, END},
	 {TS_B_resolve_lit, END}, ts_stage_pcss, "iVIR 4", "how many taps about each pixel let light through"},
	{"shadow_image", "map",
	 {SCENE, TS_B_eye_view, TS_B_eye_depth_triangle, LAMPS, TS_B_resolve_lit, END},
	 {TS_B_image_radiance, TS_B_image_srgb, END}, ts_stage_shadow_image, "iVIR 4", "the picture with its shadows"},
	{"rsm_view", "map", {TS_B_scene_info, TS_B_lamp_light, END}, {TS_B_offscreen_view, END}, ts_stage_rsm_view, "SSAGH 5",
	 "a reflective shadow map for each light, six for a point light"},
	{"rsm", "scatter", {SCENE, TS_B_offscreen_view, END}, {TS_B_rsm_depth_triangle, END}, ts_stage_rsm, "SSAGH 5",
	 "standard rasterization into every reflective shadow map"},
	{"rsm_patch", "map", {SCENE, TS_B_lamp_light, TS_B_offscreen_view, TS_B_rsm_depth_triangle, END},
	 {TS_B_rsm_patch, END}, ts_stage_rsm_patch, "SSAGH 5", "what each of their texels sees as a triangle of light"},
	{"gbuffer", "map", {SCENE, TS_B_eye_view, TS_B_eye_depth_triangle, END}, {TS_B_gbuffer_pixel, END}, ts_stage_gbuffer,
	 "SSAGH 3", "position, normal and albedo of every pixel"},
	{"nearest", "map", {TS_B_gbuffer_pixel, END}, {TS_B_nearest_depth, END}, ts_stage_nearest, "SSAGH 3",
	 "the screen's depth down-sampled"},
	{"segment", "map", {TS_B_nearest_depth, END}, {TS_B_segment_label, END}, ts_stage_segment, "SSAGH 3, algorithm 1",
	 "segments of like depth in each block"},
	{"range", "scatter", {TS_B_nearest_depth, TS_B_segment_label, END}, {TS_B_range_least, END}, ts_stage_range, "SSAGH 3",
	 "extent of each segment by integer minimum"},
	{"box", "emit", {TS_B_range_least, END}, {TS_B_box_offset, TS_B_box_record, END}, ts_stage_box, "SSAGH 3",
	 "the segments' boxes, but of the sky"},
	{0},
};

const ts_stage *ts_stage_find(const char *name)
{
	for (const ts_stage *stage = ts_stage_table; stage->name != NULL; stage++) {
		if (strcmp(stage->name, name) == 0) return stage;
	}
	return NULL;
}

static bool is_in(const ts_buffer_id *list, ts_buffer_id id)
{
	for (; *list != TS_N_BUFFERS; list++) {
		if (*list == id) return true;
	}
	return false;
}

bool ts_stage_reads(const ts_stage *stage, ts_buffer_id id) { return is_in(stage->reads, id); }
bool ts_stage_writes(const ts_stage *stage, ts_buffer_id id) { return is_in(stage->writes, id); }

/* The scene of an untrusted trace: what is refused of views, images and shapes, and that textures are read whole. */
#include "tests/probe/mvr.h"

/* Reads the scene of a trace with another first element of a buffer. */
static ts_status scene_with(ts_buffer_id id, const void *element)
{
	damaged d;
	memcpy(damage(&d, &mvr, id), element, ts_buffer_table[id].element_bytes);
	ts_status status = ts_probe_scene(d.probe);
	damage_end(&d);
	return status;
}

/* A view is as large as the parameters say, and never too large for an index of a pixel. */
static void wrong_sizes_of_views_are_refused(void **state)
{
	(void)state;
	static const struct {
		u32 width, height;
		const char *words;
	} rows[] = {
		{WIDTH, HEIGHT + 1, "24 x 17 pixels; 24 x 16, as the parameters, would be right"},
		{WIDTH - 1, HEIGHT, "23 x 16 pixels; 24 x 16, as the parameters, would be right"},
		{WIDTH, TS_PROBE_SIDE, "24 x 16384 pixels; 24 x 16, as the parameters, would be right"},
		{TS_PROBE_SIDE, HEIGHT, "16384 x 16 pixels; 24 x 16, as the parameters, would be right"},
		{WIDTH, TS_PROBE_SIDE + 1, "24 x 16385 pixels; at most 16384 x 16384"},
		{TS_PROBE_SIDE + 1, HEIGHT, "16385 x 16 pixels; at most 16384 x 16384"},
		{0, HEIGHT, "0 x 16 pixels; at most 16384 x 16384"},
		{WIDTH, 0, "24 x 0 pixels; at most 16384 x 16384"},
	};
	ts_view view = *(const ts_view *)data(&mvr, TS_B_eye_view);
	for (u32 row = 0; row < sizeof rows / sizeof *rows; row++) {
		view.width = rows[row].width;
		view.height = rows[row].height;
		assert_refused(scene_with(TS_B_eye_view, &view), rows[row].words);
	}
	require(scene_with(TS_B_eye_view, data(&mvr, TS_B_eye_view)));
}

/* A chain of mips stands among the texels, up to the last one. */
static void mip_chains_must_stand_among_the_texels(void **state)
{
	(void)state;
	static const struct {
		u32 width, height, n_levels, texels;
	} rows[] = {{1, 1, 1, 1}, {4, 4, 3, 21}, {8, 2, 4, 23}, {2, 8, 4, 23}, {5, 3, 3, 18}, {1, 6, 3, 10}, {4, 4, 2, 20}};
	const char *words = "scene.image.npy: element 0: no mip chain within scene.texel";
	u64 n = count(&mvr, TS_B_scene_texel);
	for (u32 row = 0; row < sizeof rows / sizeof *rows; row++) {
		ts_image image = {.first_texel = n - rows[row].texels,
		                  .width = rows[row].width,
		                  .height = rows[row].height,
		                  .n_levels = rows[row].n_levels};
		require(scene_with(TS_B_scene_image, &image));
		image.first_texel++;
		assert_refused(scene_with(TS_B_scene_image, &image), words);
		image.first_texel = n + 1;
		assert_refused(scene_with(TS_B_scene_image, &image), words);
		image.first_texel = 0;
		image.n_levels = 0;
		assert_refused(scene_with(TS_B_scene_image, &image), words);
		image.n_levels = 16;
		assert_refused(scene_with(TS_B_scene_image, &image), words);
		image.n_levels = 1;
		image.width = TS_PROBE_SIDE + 1;
		assert_refused(scene_with(TS_B_scene_image, &image), words);
	}
}

static void wrong_slots_are_refused(void **state)
{
	(void)state;
	ts_slot slot = *(const ts_slot *)data(&mvr, TS_B_scene_slot);
	for (slot.uv_set = 0; slot.uv_set < 2; slot.uv_set++) require(scene_with(TS_B_scene_slot, &slot));
	assert_refused(scene_with(TS_B_scene_slot, &slot),
	               "scene.slot.npy: element 0 field uv_set is 2; 0 or 1 would be right");
}

/* The texels of a triangle's images are read, to the last of their last level, and no others. */
static void only_texels_of_the_triangle_are_read(void **state)
{
	(void)state;
	const ts_triangle *triangles = data(&mvr, TS_B_scene_triangle);
	const ts_material *materials = data(&mvr, TS_B_scene_material);
	const ts_slot *slots = data(&mvr, TS_B_scene_slot);
	const ts_image *images = data(&mvr, TS_B_scene_image);
	const u64 *texels = data(&mvr, TS_B_scene_texel);
	u32 n_images = (u32)count(&mvr, TS_B_scene_image), n_read = 0;
	ts_probe *probe;
	require(ts_probe_open(&probe, mvr.trace));
	require(ts_probe_scene(probe));
	for (u32 i = 0; i < n_images; i++) assert_int_equal(probe->image_read[i], 0);
	for (u32 tried = 0; tried < 40; tried++) {
		u32 t = below((u32)count(&mvr, TS_B_scene_triangle));
		const ts_material *material = &materials[triangles[t].material];
		require(ts_probe_textures(probe, t));
		for (u32 s = 0; s < 5; s++) {
			if (material->slot[s] == TS_NONE) continue;
			u32 i = slots[material->slot[s]].image;
			const ts_image *image = &images[i];
			u64 end = i + 1 < n_images ? images[i + 1].first_texel : count(&mvr, TS_B_scene_texel);
			assert_int_equal(probe->image_read[i], 1);
			assert_memory_equal(probe->texels + image->first_texel, texels + image->first_texel,
			                    (size_t)(end - image->first_texel) * sizeof *texels);
		}
	}
	for (u32 i = 0; i < n_images; i++) {
		n_read += probe->image_read[i];
		if (probe->image_read[i] == 0) assert_int_equal(probe->texels[images[i].first_texel], 0);
	}
	assert_true(n_read > 0);
	ts_probe_close(probe);
}

static void the_scene_is_read_once(void **state)
{
	(void)state;
	ts_probe *probe;
	require(ts_probe_open(&probe, mvr.trace));
	require(ts_probe_scene(probe));
	const u64 *texels = probe->texels;
	require(ts_probe_scene(probe));
	assert_ptr_equal(probe->texels, texels);
	assert_int_equal(probe->scene.n_triangles, count(&mvr, TS_B_scene_triangle));
	assert_int_equal(probe->scene.n_lights, count(&mvr, TS_B_scene_light));
	assert_bits(probe->scene.ambient, ((const ts_info *)data(&mvr, TS_B_scene_info))->ambient);
	ts_probe_close(probe);
}

/* Both shapes are told where they differ; crops and what is not known are not compared. */
static void both_shapes_are_told_where_they_differ(void **state)
{
	(void)state;
	damaged d;
	damage(&d, &mvr, TS_B_image_srgb);
	ts_trace_item *item = &d.probe->trace->item[TS_B_image_srgb];
	require(ts_probe_shapes(d.probe, TS_UNKNOWN));
	item->npy.shape[1]--;
	assert_refused(ts_probe_shapes(d.probe, TS_UNKNOWN),
	               "image.srgb.npy: shape 16 x 23 x 3; 16 x 24 x 3, height width 3, would be right");
	item->cropped = true;
	require(ts_probe_shapes(d.probe, TS_UNKNOWN));
	item->cropped = false;
	item->path = NULL;
	require(ts_probe_shapes(d.probe, TS_UNKNOWN));
	u64 texels = mvr.trace->item[TS_B_cube_face_depth_triangle].npy.n; /* of all batches */
	require(ts_probe_shapes(d.probe, texels));
	assert_refused(ts_probe_shapes(d.probe, texels + 1), "cube_face.depth_triangle.npy: shape ");
	damage_end(&d);
}

static void all_that_is_lacking_is_named(void **state)
{
	(void)state;
	ts_trace trace = *mvr.trace;
	ts_probe *probe;
	trace.item[TS_B_scene_slot].path = trace.item[TS_B_pose_vertex].path = NULL;
	require(ts_probe_open(&probe, &trace));
	assert_refused(ts_probe_scene(probe),
	               "this needs scene.slot, pose.vertex; a trace that was written whole has them");
	ts_probe_close(probe);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(wrong_sizes_of_views_are_refused),
		cmocka_unit_test(mip_chains_must_stand_among_the_texels),
		cmocka_unit_test(wrong_slots_are_refused),
		cmocka_unit_test(the_scene_is_read_once),
		cmocka_unit_test(both_shapes_are_told_where_they_differ),
		cmocka_unit_test(only_texels_of_the_triangle_are_read),
		cmocka_unit_test(all_that_is_lacking_is_named),
	};
	return cmocka_run_group_tests(tests, mvr_make, mvr_drop);
}

/* Checks of the scene: faults planted in the arrays that a stage reads, and the least and the most that is right. */
#include <inttypes.h>
#include "tests/replay/loaded.h"

enum { MIRRORS = 3 };

static int begin(void **state)
{
	(void)state;
	ts_params params = small_params(64, 48);
	params.reflectors_count = MIRRORS;
	params.reflectors_px = 8;
	params.cube_max_px = 16;
	loaded_run(ts_pipeline_find("reflections", "vir"), &params);
	return 0;
}

static void assert_refused(ts_status status, const char *words)
{
	if (status != TS_ERROR || strstr(ts_error_message(), words) == NULL) {
		fail_msg("status %d: \"%s\" says nothing of \"%s\"", (int)status, ts_error_message(), words);
	}
}

/* Checks the scene with another image in place of the first. */
static ts_status check_image(ts_image image)
{
	ts_image *first = ts_frame_data(&run.frame, TS_B_scene_image), kept = *first;
	*first = image;
	ts_status status = check_for("eye");
	*first = kept;
	return status;
}

/* A chain has as many levels as halvings end at one texel, each at least one texel wide and high, and is whole. */
static void a_chain_has_its_levels_and_texels(void **state)
{
	(void)state;
	static const struct {
		u32 width, height, n_levels, texels;
	} rows[] = {
		{1, 1, 1, 1},  {2, 2, 2, 5},  {4, 4, 3, 21}, {8, 2, 4, 23},
		{2, 8, 4, 23}, {5, 3, 3, 18}, {1, 6, 3, 10}, {7, 1, 3, 11},
	};
	u64 n = ts_frame_n(&run.frame, TS_B_scene_texel);
	for (u32 row = 0; row < sizeof rows / sizeof *rows; row++) {
		char words[96];
		u32 texels = rows[row].texels;
		ts_image image = {.first_texel = n - texels, .width = rows[row].width, .height = rows[row].height};
		snprintf(words, sizeof words, "field n_levels: %u (%08x); %u would be right", 0u, 0u,
		         (unsigned)rows[row].n_levels);
		assert_refused(check_image(image), words);
		image.n_levels = rows[row].n_levels;
		if (check_image(image) != TS_OK) fail_msg("%s", ts_error_message());
		image.first_texel++;
		snprintf(words, sizeof words, "a place before which %u of %" PRIu64 " texels are left", (unsigned)texels, n);
		assert_refused(check_image(image), words);
		image.first_texel = UINT64_MAX;
		assert_refused(check_image(image), words);
		image.n_levels++;
		assert_refused(check_image(image), "field n_levels");
	}
}

/* Sides for which 24.8 fixed point names every texel. */
static void sides_beyond_fixed_point_are_refused(void **state)
{
	(void)state;
	const u32 most = 1u << 22;
	for (u32 side = 0; side < 2; side++) {
		const char *field = side == 0 ? "width" : "height";
		refuses("eye", TS_B_scene_image, 0, field, 0);
		refuses("eye", TS_B_scene_image, 0, field, most + 1);
		refuses("eye", TS_B_scene_image, 0, field, TS_NONE);
		assert_refused(check_with("eye", TS_B_scene_image, 0, field, most), "field n_levels");
	}
}

static void unknown_kinds_are_refused(void **state)
{
	(void)state;
	for (u32 set = 0; set < 2; set++) accepts("eye", TS_B_scene_slot, 0, "uv_set", set);
	for (u32 wrap = 0; wrap < 3; wrap++) accepts("eye", TS_B_scene_slot, 0, "wrap", wrap);
	refuses("eye", TS_B_scene_slot, 0, "uv_set", 2);
	for (u32 k = 0; k < 2; k++) {
		char words[96];
		snprintf(words, sizeof words, "scene.slot: element 0, field wrap[%u]: 3 (00000003); 0, 1 or 2 would be right",
		         (unsigned)k);
		assert_refused(check_component("eye", TS_B_scene_slot, 0, "wrap", k, 3), words);
	}
	for (u32 kind = 0; kind < 3; kind++) accepts("image", TS_B_scene_light, 0, "kind", kind);
	refuses("image", TS_B_scene_light, 0, "kind", 3);
}

/* Ranges stand one behind the other and end within the vertices. */
static void ranges_of_objects_follow_one_another(void **state)
{
	(void)state;
	const ts_object *objects = ts_frame_data(&run.frame, TS_B_scene_object);
	u64 last = ts_frame_n(&run.frame, TS_B_scene_object) - 1, n = ts_frame_n(&run.frame, TS_B_scene_vertex);
	u64 most = n - objects[last].first_vertex;
	assert_true(last > 0);
	refuses("cube_size", TS_B_scene_object, 0, "first_vertex", 1);
	for (u64 i = 1; i <= last; i++) {
		refuses("cube_size", TS_B_scene_object, i, "first_vertex", objects[i].first_vertex + 1);
		refuses("cube_size", TS_B_scene_object, i, "first_vertex", objects[i].first_vertex - 1);
	}
	accepts("cube_size", TS_B_scene_object, last, "n_vertices", most);
	refuses("cube_size", TS_B_scene_object, last, "n_vertices", most + 1);
	refuses("cube_size", TS_B_scene_object, 0, "n_vertices", TS_NONE);
}

/* Every reflector is one object, of vertices. */
static void every_reflector_is_one_object(void **state)
{
	(void)state;
	const ts_object *objects = ts_frame_data(&run.frame, TS_B_scene_object);
	u64 n = ts_frame_n(&run.frame, TS_B_scene_object), mirror[MIRRORS], other = n;
	for (u64 i = 0; i < n; i++) {
		if (objects[i].reflector != TS_NONE) mirror[objects[i].reflector] = i;
		if (objects[i].reflector == TS_NONE) other = i;
	}
	assert_true(other < n);
	for (u32 r = 0; r < MIRRORS; r++) {
		char words[96];
		u64 before = mirror[r] < other ? mirror[r] : other, behind = mirror[r] < other ? other : mirror[r];
		snprintf(words, sizeof words,
		         "scene.object: element %" PRIu64 ", field reflector: %u (%08x); one that object %" PRIu64, behind,
		         (unsigned)r, (unsigned)r, before);
		assert_refused(check_with("cube_size", TS_B_scene_object, other, "reflector", r), words);
		assert_refused(check_with("cube_size", TS_B_scene_object, mirror[r], "reflector", TS_NONE),
		               "scene.object: 2 objects are reflectors; 3 (reflectors) would be right");
		refuses("cube_size", TS_B_scene_object, mirror[r], "reflector", MIRRORS);
	}
	u64 last = n - 1; /* may be empty, where no reflector is */
	if (objects[last].reflector == TS_NONE) accepts("cube_size", TS_B_scene_object, last, "n_vertices", 0);
	if (objects[last].reflector != TS_NONE) refuses("cube_size", TS_B_scene_object, last, "n_vertices", 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_chain_has_its_levels_and_texels), cmocka_unit_test(sides_beyond_fixed_point_are_refused),
		cmocka_unit_test(unknown_kinds_are_refused),         cmocka_unit_test(ranges_of_objects_follow_one_another),
		cmocka_unit_test(every_reflector_is_one_object),
	};
	return cmocka_run_group_tests(tests, begin, end);
}

/* What the probe says of reflections, against the buffers of the run that wrote the trace. */
#include "methods/points/tools/probe.h"
#include "tests/probe/probed.h"

enum { N_TRIED = 50 };

/* plane: EPR with the depth of planes, which ties often, and with the second reading of the limit */
static traced epr, mvr, bufferless, forward, plane;

static int make_all(void **state)
{
	(void)state;
	ts_params params = small_params(96, 64);
	params.reflectors_count = 3;
	params.reflectors_px = 40;
	params.lookup_bounces = 2;
	params.mvr_faces = TS_MVR_FACES_ADAPTIVE;
	make(&epr, "reflections", "epr", &params);
	make(&mvr, "reflections", "mvr", &params);
	make(&bufferless, "reflections", "epr-bufferless", &params);
	make(&forward, "reflections", "epr-forward", &params);
	params.splat_plane_depth = 1;
	params.density_cap = TS_DENSITY_CAP_GREATEST;
	params.reflectors_px = 20; /* cubes smaller than the greatest */
	make(&plane, "reflections", "epr", &params);
	return 0;
}

static int drop_all(void **state)
{
	(void)state;
	drop(&epr);
	drop(&mvr);
	drop(&bufferless);
	drop(&forward);
	drop(&plane);
	return 0;
}

/* Every term of every one of these pixels adds up to the bits of the picture. */
static void pixels_of(const traced *t)
{
	const ts_pixel *records = data(t, TS_B_mirror_pixel_record);
	u32 n = (u32)count(t, TS_B_mirror_pixel_record);
	assert_true(n > N_TRIED);
	for (u32 i = 0; i < N_TRIED; i++) try_pixel(t, records[below(n)].index);
	for (u32 i = 0; i < N_TRIED; i++) try_pixel(t, below(t->run.params.width * t->run.params.height));
}

static void terms_of_epr_make_up_the_picture(void **state)
{
	(void)state;
	pixels_of(&epr);
}

static void terms_of_mvr_make_up_the_picture(void **state)
{
	(void)state;
	pixels_of(&mvr);
}

static void terms_of_bounces_make_up_the_picture(void **state)
{
	(void)state;
	const ts_bounce *queue = data(&epr, TS_B_lookup_second_parent);
	const ts_pixel *records = data(&epr, TS_B_mirror_pixel_record);
	assert_true(count(&epr, TS_B_lookup_second_parent) > 0);
	for (u32 i = 0; i < 8; i++) {
		try_pixel(&epr, records[queue[below((u32)count(&epr, TS_B_lookup_second_parent))].parent / 25].index);
	}
}

/* The first of the competitors is the key that the buffer holds. */
static json_t *try_texel(const traced *t, u64 texel, u64 key, const char *depth, const char *index)
{
	json_t *answer;
	char view[32];
	const ts_face *cubes = data(t, TS_B_cube_size_face);
	u32 r = 0;
	while (texel - cubes[r].offset >= (u64)6 * cubes[r].n * cubes[r].n) r++;
	u64 n = cubes[r].n, inside = texel - cubes[r].offset;
	snprintf(view, sizeof view, "%u.%u", (unsigned)r, (unsigned)(inside / (n * n)));
	require(ask_texel(t, view, (u32)(inside % n), (u32)(inside / n % n), &answer));
	assert_true(assert_agrees(answer) >= 1);
	assert_int_equal(figure(answer, "element"), texel);
	const json_t *first = json_array_get(json_object_get(answer, "by_depth"), 0);
	assert_int_equal(figure(first, index), (u32)key);
	assert_int_equal(bits_of(json_object_get(json_object_get(first, depth), "bits")), key >> 32);
	return answer;
}

static void the_first_competitor_has_the_texel(void **state)
{
	(void)state;
	const u64 *keys = data(&epr, TS_B_splat_depth_index);
	for (u32 i = 0; i < N_TRIED;) {
		u64 texel = below((u32)count(&epr, TS_B_splat_depth_index));
		if (keys[texel] == TS_EMPTY) continue;
		json_decref(try_texel(&epr, texel, keys[texel], "distance", "point"));
		i++;
	}
}

/* A texel that is marked as tied has two competitors at the least distance. */
static void a_tied_texel_has_two_nearest(void **state)
{
	(void)state;
	const u8 *tie = data(&plane, TS_B_splat_tie);
	const u64 *keys = data(&plane, TS_B_splat_depth_index);
	u32 n_tried = 0;
	for (u64 texel = 0; texel < count(&plane, TS_B_splat_tie) && n_tried < N_TRIED; texel++) {
		if (tie[texel] == 0) continue;
		json_t *answer = try_texel(&plane, texel, keys[texel], "distance", "point");
		assert_int_equal(figure(answer, "won_by_ulps"), 0);
		assert_true(json_is_true(json_object_get(answer, "tied")));
		json_decref(answer);
		n_tried++;
	}
	assert_int_equal(n_tried, N_TRIED);
}

/* The frame keeps the last reflector's faces alone. */
static void faces_of_mvr_name_their_first_competitor(void **state)
{
	(void)state;
	const u64 *keys = data(&mvr, TS_B_cube_face_depth_triangle);
	const ts_face *cubes = data(&mvr, TS_B_cube_size_face);
	u64 first = cubes[count(&mvr, TS_B_cube_size_face) - 1].offset;
	for (u32 i = 0; i < N_TRIED;) {
		u64 inside = below((u32)count(&mvr, TS_B_cube_face_depth_triangle));
		if (keys[inside] == TS_EMPTY) continue;
		json_decref(try_texel(&mvr, first + inside, keys[inside], "depth", "triangle"));
		i++;
	}
}

static u32 triangle_of(u32 point)
{
	const ts_point *points = data(&epr, TS_B_points_record);
	return ((const ts_piece *)data(&epr, TS_B_split_piece))[points[point].piece].triangle;
}

/* What became of a triangle, counted from the buffers. */
typedef struct {
	bool seen, kept;
	u64 points, won, samples;
} truth;

static truth truth_of(u32 triangle)
{
	const u64 *bits = data(&epr, TS_B_visibility_bits), *keys = data(&epr, TS_B_splat_depth_index);
	const u32 *offset = data(&epr, TS_B_split_offset), *keep = data(&epr, TS_B_cull_keep);
	const u32 *before = data(&epr, TS_B_points_offset), *found = data(&epr, TS_B_lookup_point);
	const u32 *found2 = data(&epr, TS_B_lookup_second_point);
	truth t = {.seen = bits[triangle] != 0};
	for (u32 q = offset[triangle]; q < offset[triangle + 1]; q++) t.kept |= keep[q] != 0;
	t.points = before[offset[triangle + 1]] - before[offset[triangle]];
	for (u64 i = 0; i < count(&epr, TS_B_splat_depth_index); i++) {
		t.won += keys[i] != TS_EMPTY && triangle_of((u32)keys[i]) == triangle;
	}
	for (u64 i = 0; i < count(&epr, TS_B_lookup_point); i++)
		t.samples += found[i] != TS_NONE && triangle_of(found[i]) == triangle;
	for (u64 i = 0; i < count(&epr, TS_B_lookup_second_point); i++) {
		t.samples += found2[i] != TS_NONE && triangle_of(found2[i]) == triangle;
	}
	return t;
}

static const char *stage_of(const truth *t)
{
	if (!t->seen) return "visibility";
	if (!t->kept) return "cull";
	if (t->points == 0) return "points.count";
	return t->won == 0 ? "splat" : t->samples == 0 ? "lookup" : "no stage";
}

static void try_triangle(u32 triangle)
{
	json_t *answer;
	truth t = truth_of(triangle);
	require(ask_triangle(&epr, triangle, &answer));
	assert_true(assert_agrees(answer) >= 2);
	assert_int_equal(json_integer_value(get(answer, "cubes", "points")), t.points);
	assert_int_equal(json_integer_value(get(answer, "cubes", "texels_won")), t.won);
	const json_t *lost = json_object_get(answer, "lost_at");
	const char *stage =
		json_is_string(lost) ? json_string_value(lost) : json_string_value(json_object_get(lost, "stage"));
	bool tie = strcmp(stage, "splat.tie") == 0 && strcmp(stage_of(&t), "splat") == 0;
	if (!tie) assert_string_equal(stage, stage_of(&t));
	json_decref(answer);
}

static u64 shows(const traced *t, ts_buffer_id id, u32 triangle)
{
	const u64 *keys = data(t, id);
	u64 n = 0;
	for (u64 i = 0; i < count(t, id); i++) n += keys[i] != TS_EMPTY && (u32)keys[i] == triangle;
	return n;
}

/* The texels of the eye that show a triangle are those that it won; of cubes the run keeps the last one. */
static void a_triangle_won_what_shows_it(void **state)
{
	(void)state;
	const u64 *seen = data(&mvr, TS_B_eye_depth_triangle), *keys = data(&mvr, TS_B_cube_face_depth_triangle);
	for (u32 i = 0; i < 8;) {
		json_t *answer;
		bool by_eye = i % 2 == 0;
		u64 key = by_eye ? seen[below((u32)count(&mvr, TS_B_eye_depth_triangle))]
		                 : keys[below((u32)count(&mvr, TS_B_cube_face_depth_triangle))];
		if (key == TS_EMPTY) continue;
		require(ask_triangle(&mvr, (u32)key, &answer));
		assert_int_equal(json_integer_value(get(answer, "eye", "texels_won")),
		                 shows(&mvr, TS_B_eye_depth_triangle, (u32)key));
		assert_true((u64)json_integer_value(get(answer, "cubes", "texels_won")) >=
		            shows(&mvr, TS_B_cube_face_depth_triangle, (u32)key));
		json_decref(answer);
		i++;
	}
}

/* Triangles that each stage loses, as many as there are, up to 6 each. */
static void each_lost_triangle_is_told_its_stage(void **state)
{
	(void)state;
	static const char *const stages[] = {"visibility", "cull", "splat", "lookup", "no stage"};
	u32 tried[5] = {0}, n = (u32)count(&epr, TS_B_scene_triangle);
	for (u32 i = 0; i < 1500; i++) {
		u32 triangle = below(n);
		truth t = truth_of(triangle);
		for (u32 s = 0; s < 5; s++) {
			if (strcmp(stages[s], stage_of(&t)) != 0 || tried[s] == 3) continue;
			tried[s]++;
			try_triangle(triangle);
		}
	}
	for (u32 s = 0; s < 5; s++) {
		if (tried[s] == 0) fail_msg("no triangle was lost at %s", stages[s]);
	}
}

/* Densities that the second reading of the limit lowers are those of the run. */
static void lowered_densities_are_those_of_the_run(void **state)
{
	(void)state;
	u32 n_lowered = 0;
	for (u32 i = 0; i < 1500 && n_lowered < N_TRIED; i++) {
		json_t *answer;
		require(ask_triangle(&plane, below((u32)count(&plane, TS_B_scene_triangle)), &answer));
		const json_t *cap = json_object_get(json_object_get(answer, "density"), "cap");
		n_lowered += json_is_string(cap) && strcmp(json_string_value(cap), "lowered the density") == 0;
		assert_agrees(answer);
		json_decref(answer);
	}
	assert_int_equal(n_lowered, N_TRIED);
}

static void index_and_key_tell_the_same_point(void **state)
{
	(void)state;
	const u64 *keys = data(&epr, TS_B_points_key), *texels = data(&epr, TS_B_splat_depth_index);
	for (u32 i = 0; i < 20; i++) {
		json_t *answer, *by_key;
		u64 won = 0;
		u32 point = below((u32)count(&epr, TS_B_points_key));
		require(ask_key(&epr, keys[point], &by_key));
		require(ask_point(&epr, point, &answer));
		assert_int_equal(figure(by_key, "point"), point);
		assert_true(json_equal(answer, by_key));
		const ts_point *record = (const ts_point *)data(&epr, TS_B_points_record) + point;
		unsigned piece;
		int x, y;
		json_t *key = ts_probe_key(keys[point]);
		assert_int_equal(sscanf(json_string_value(key), "%u,%d,%d", &piece, &x, &y), 3);
		assert_true(piece == keys[point] >> 32 && piece == record->piece);
		assert_true(x == (int)(keys[point] & 0xffff) - 32768 && y == (int)(keys[point] >> 16 & 0xffff) - 32768);
		json_decref(key);
		json_decref(by_key);
		for (u64 k = 0; k < count(&epr, TS_B_splat_depth_index); k++)
			won += texels[k] != TS_EMPTY && (u32)texels[k] == point;
		assert_int_equal(json_integer_value(get(answer, "cubes", "texels_won")), won);
		assert_int_equal(figure(answer, "triangle"), triangle_of(point));
		const json_t *made = json_object_get(answer, "piece");
		assert_int_equal(figure(made, "piece"), record->piece);
		assert_int_equal(figure(made, "path"), ((const ts_piece *)data(&epr, TS_B_split_piece))[record->piece].path);
		assert_agrees(answer);
		json_decref(answer);
	}
}

/* Points that are not stored are told of as if they were. */
static void assert_reported_alike(json_t *a, json_t *b)
{
	assert_agrees(b);
	assert_string_equal(json_string_value(json_object_get(a, "method")), "epr");
	assert_string_equal(json_string_value(json_object_get(b, "method")), "epr-bufferless");
	json_object_set_new(b, "method", json_string("epr"));
	json_t *lost = json_object_get(b, "lost_at");
	if (json_is_object(lost) && strcmp(json_string_value(json_object_get(lost, "stage")), "splat.direct") == 0) {
		json_object_set_new(lost, "stage", json_string("splat"));
	}
	assert_true(json_equal(a, b));
	json_decref(a);
	json_decref(b);
}

static void points_not_stored_are_told_alike(void **state)
{
	(void)state;
	json_t *a, *b;
	const ts_pixel *records = data(&epr, TS_B_mirror_pixel_record);
	const u64 *keys = data(&epr, TS_B_splat_depth_index), *of_points = data(&epr, TS_B_points_key);
	pixels_of(&bufferless);
	for (u32 i = 0; i < 12; i++) {
		u32 pixel = records[below((u32)count(&epr, TS_B_mirror_pixel_record))].index, width = epr.run.params.width;
		require(ask_pixel(&epr, pixel % width, pixel / width, &a));
		require(ask_pixel(&bufferless, pixel % width, pixel / width, &b));
		assert_reported_alike(a, b);
		u32 point = below((u32)count(&epr, TS_B_points_key));
		require(ask_point(&epr, point, &a));
		require(ask_key(&bufferless, of_points[point], &b));
		assert_reported_alike(a, b);
		require(ask_triangle(&epr, triangle_of(point), &a));
		require(ask_triangle(&bufferless, triangle_of(point), &b));
		assert_reported_alike(a, b);
		u64 texel = below((u32)count(&epr, TS_B_splat_depth_index));
		if (keys[texel] != TS_EMPTY) json_decref(try_texel(&bufferless, texel, keys[texel], "distance", "point"));
	}
}

/* A texel's first competitor has the colour that the buffer holds, of 8 digits. */
static void forward_texels_are_told_by_colour(void **state)
{
	(void)state;
	const u64 *keys = data(&forward, TS_B_splat_depth_colour);
	const ts_face *cubes = data(&forward, TS_B_cube_size_face);
	u64 n = (u64)cubes[0].n * cubes[0].n;
	u32 n_tried = 0;
	pixels_of(&forward);
	for (u32 i = 0; i < N_TRIED; i++) {
		json_t *answer;
		char view[16], colour[9];
		u32 inside = below((u32)(6 * n));
		if (keys[inside] == TS_EMPTY) continue;
		snprintf(view, sizeof view, "0.%u", (unsigned)(inside / n));
		snprintf(colour, sizeof colour, "%08x", (unsigned)keys[inside]);
		require(ask_texel(&forward, view, inside % cubes[0].n, (u32)(inside / cubes[0].n % cubes[0].n), &answer));
		assert_true(assert_agrees(answer) >= 1);
		const json_t *first = json_array_get(json_object_get(answer, "by_depth"), 0);
		assert_string_equal(json_string_value(json_object_get(first, "colour")), colour);
		json_decref(answer);
		n_tried++;
	}
	assert_true(n_tried > N_TRIED / 2);
	json_t *none;
	assert_int_equal(ask_triangle(&forward, 0, &none), TS_ERROR);
}

static void what_is_not_there_is_refused(void **state)
{
	(void)state;
	json_t *answer;
	assert_int_equal(ask_pixel(&epr, 96, 0, &answer), TS_ERROR);
	assert_null(answer);
	assert_int_equal(ask_texel(&epr, "3.+X", 0, 0, &answer), TS_ERROR);
	assert_int_equal(ask_texel(&epr, "0.6", 0, 0, &answer), TS_ERROR);
	assert_int_equal(ask_texel(&epr, "0.+X", 4096, 0, &answer), TS_ERROR);
	assert_int_equal(ask_triangle(&epr, count(&epr, TS_B_scene_triangle), &answer), TS_ERROR);
	assert_int_equal(ask_point(&epr, count(&epr, TS_B_points_key), &answer), TS_ERROR);
	assert_int_equal(ask_point(&mvr, 0, &answer), TS_ERROR);
	assert_int_equal(ask_key(&epr, UINT64_MAX, &answer), TS_ERROR);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(terms_of_epr_make_up_the_picture),
		cmocka_unit_test(terms_of_mvr_make_up_the_picture),
		cmocka_unit_test(terms_of_bounces_make_up_the_picture),
		cmocka_unit_test(the_first_competitor_has_the_texel),
		cmocka_unit_test(faces_of_mvr_name_their_first_competitor),
		cmocka_unit_test(a_tied_texel_has_two_nearest),
		cmocka_unit_test(each_lost_triangle_is_told_its_stage),
		cmocka_unit_test(a_triangle_won_what_shows_it),
		cmocka_unit_test(index_and_key_tell_the_same_point),
		cmocka_unit_test(points_not_stored_are_told_alike),
		cmocka_unit_test(forward_texels_are_told_by_colour),
		cmocka_unit_test(what_is_not_there_is_refused),
		cmocka_unit_test(lowered_densities_are_those_of_the_run),
	};
	return cmocka_run_group_tests(tests, make_all, drop_all);
}

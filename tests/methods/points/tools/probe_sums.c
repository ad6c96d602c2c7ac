/* What the probe says of reflections adds up: texels that are offered, won and lost, pieces, points and samples,
 * against each other and the buffers of the run. */
#include "kernels/raster/cube.h"
#include "tests/probe/probed.h"

enum { N_TRIED = 18, SAMPLES = 25, MOST_RIVALS = 8, MOST_PIECES = 32, MOST_POINTS = 64 };

static traced epr, mvr, adaptive;

static int make_all(void **state)
{
	(void)state;
	ts_params params = small_params(64, 40);
	params.reflectors_count = 3;
	params.reflectors_px = 24;
	params.lookup_bounces = 2;
	make(&epr, "reflections", "epr", &params);
	make(&mvr, "reflections", "mvr", &params);
	params.lookup_samples = TS_SAMPLES_ADAPTIVE;
	make(&adaptive, "reflections", "epr", &params);
	return 0;
}

static int drop_all(void **state)
{
	(void)state;
	drop(&epr);
	drop(&mvr);
	drop(&adaptive);
	return 0;
}

/* Of integer members of all objects of a list. */
static u64 total(const json_t *list, const char *key)
{
	u64 sum = 0;
	size_t i;
	json_t *member;
	json_array_foreach ((json_t *)list, i, member) sum += figure(member, key);
	return sum;
}

/* The others' triangles are told in order, the one that holds most texels first, and they hold all that is lost. */
static void try_spread(const json_t *o)
{
	const json_t *rivals = json_object_get(o, "lost_to"), *odd = json_object_get(o, "texels_that_hold_what_is_farther");
	u64 lost = figure(o, "texels_lost"), listed = total(rivals, "texels"), n = json_array_size(rivals);
	assert_int_equal(figure(o, "texels_offered"),
	                 figure(o, "texels_won") + lost + (odd != NULL ? json_integer_value(odd) : 0));
	bool all = json_object_get(o, "rivals") == NULL;
	assert_true(all ? listed == lost : listed < lost && n == MOST_RIVALS && figure(o, "rivals") > n);
	assert_true(all ? total(rivals, "ties") == figure(o, "lost_by_ties")
	                : total(rivals, "ties") <= figure(o, "lost_by_ties"));
	for (size_t i = 0; i < n; i++) {
		const json_t *rival = json_array_get(rivals, i), *next = json_array_get(rivals, i + 1);
		double margin = json_real_value(json_object_get(rival, "least_margin"));
		json_int_t ulps = json_integer_value(json_object_get(rival, "least_margin_ulps"));
		assert_true(figure(rival, "texels") >= figure(rival, "ties") && figure(rival, "texels") > 0 && margin >= 0);
		assert_true((figure(rival, "ties") > 0) == (ulps == 0) && (ulps == 0) == (margin == 0));
		if (next == NULL) continue;
		assert_true(figure(rival, "texels") > figure(next, "texels") ||
		            (figure(rival, "texels") == figure(next, "texels") &&
		             figure(rival, "triangle") < figure(next, "triangle")));
	}
}

static void try_corners(const traced *t, const json_t *o, u32 triangle)
{
	const u32 *corners = ((const ts_triangle *)data(t, TS_B_scene_triangle))[triangle].vertex;
	for (u32 k = 0; k < 3; k++) {
		const ts_vertex *vertex = (const ts_vertex *)data(t, TS_B_pose_vertex) + corners[k];
		const json_t *corner = json_array_get(json_object_get(o, "corners"), k);
		for (u32 c = 0; c < 3; c++)
			assert_true(json_real_value(json_array_get(corner, c)) == (double)vertex->position[c]);
	}
	assert_int_equal(figure(o, "triangle"), triangle);
}

/* Points by their texels: those of the list, and how many won any of the buffer's. */
static void try_points(const traced *t, const json_t *cubes, u32 first, u32 n)
{
	const u64 *keys = data(t, TS_B_splat_depth_index);
	const json_t *list = json_object_get(cubes, "each_point"), *faces = json_object_get(cubes, "faces");
	u64 *won = calloc(n + 1, sizeof *won), winners = 0;
	assert_non_null(won);
	for (u64 i = 0; i < count(t, TS_B_splat_depth_index); i++) {
		if (keys[i] != TS_EMPTY && (u32)keys[i] - first < n) winners += won[(u32)keys[i] - first]++ == 0;
	}
	assert_int_equal(figure(cubes, "points"), n);
	assert_int_equal(figure(cubes, "points_that_won_texels"), winners);
	assert_int_equal(json_array_size(list), n < MOST_POINTS ? n : MOST_POINTS);
	assert_int_equal(json_object_get(cubes, "points_listed") != NULL, n > MOST_POINTS);
	for (size_t i = 0; i < json_array_size(list); i++) {
		const json_t *point = json_array_get(list, i);
		assert_int_equal(figure(point, "point"), first + i);
		assert_int_equal(figure(point, "won"), won[i]);
		assert_true(figure(point, "offered") >= won[i]);
	}
	free(won);
	assert_int_equal(total(faces, "offered"), figure(cubes, "texels_offered"));
	assert_int_equal(total(faces, "won"), figure(cubes, "texels_won"));
	assert_int_equal(total(faces, "lost"), figure(cubes, "texels_lost"));
	assert_true(figure(cubes, "lost_to_its_own_triangle") <= figure(cubes, "texels_lost"));
	try_spread(cubes);
}

/* Samples that found one of the points, and the first of them. */
static void try_lookups(const traced *t, const json_t *cubes, u32 first, u32 n)
{
	static const struct {
		ts_buffer_id id;
		const char *key;
	} bounces[] = {{TS_B_lookup_point, "samples"}, {TS_B_lookup_second_point, "samples_bounce2"}};
	for (u32 b = 0; b < 2; b++) {
		const u32 *found = data(t, bounces[b].id);
		u64 n_found = 0, sample = 0;
		for (u64 i = count(t, bounces[b].id); i-- > 0;) {
			if (found[i] - first >= n) continue;
			n_found++;
			sample = i;
		}
		assert_int_equal(figure(cubes, bounces[b].key), n_found);
		const json_t *told = json_object_get(cubes, "first_sample");
		if (b == 0) assert_int_equal(told != NULL, n_found > 0);
		if (b > 0 || n_found == 0) continue;
		u32 pixel = ((const ts_pixel *)data(t, TS_B_mirror_pixel_record))[sample / SAMPLES].index;
		const json_t *place = json_object_get(told, "pixel");
		assert_int_equal(json_integer_value(json_array_get(place, 0)), pixel % t->run.params.width);
		assert_int_equal(json_integer_value(json_array_get(place, 1)), pixel / t->run.params.width);
		assert_int_equal(figure(told, "k"), sample % SAMPLES);
	}
}

static void try_pieces(const traced *t, const json_t *o, u32 first, u32 n)
{
	const ts_piece *pieces = data(t, TS_B_split_piece);
	const u32 *keep = data(t, TS_B_cull_keep);
	const json_t *list = json_object_get(o, "each_piece");
	u32 kept = 0;
	for (u32 i = 0; i < n; i++) kept += keep[first + i];
	assert_int_equal(figure(o, "pieces"), n);
	assert_int_equal(figure(o, "pieces_kept"), kept);
	assert_int_equal(json_array_size(list), n < MOST_PIECES ? n : MOST_PIECES);
	for (size_t i = 0; i < json_array_size(list); i++) {
		assert_int_equal(figure(json_array_get(list, i), "piece"), first + i);
		assert_int_equal(figure(json_array_get(list, i), "path"), pieces[first + i].path);
	}
}

/* Every third triangle is of a point, the others are those that the eye sees. */
static void what_becomes_of_a_triangle_adds_up(void **state)
{
	(void)state;
	const u32 *offset = data(&epr, TS_B_split_offset), *points = data(&epr, TS_B_points_offset);
	const u64 *seen = data(&epr, TS_B_eye_depth_triangle);
	u32 n_points = 0;
	for (u32 i = 0; i < N_TRIED; i++) {
		json_t *o;
		const ts_point *point =
			(const ts_point *)data(&epr, TS_B_points_record) + below((u32)count(&epr, TS_B_points_record));
		u32 triangle = ((const ts_piece *)data(&epr, TS_B_split_piece))[point->piece].triangle;
		u64 key = seen[below((u32)count(&epr, TS_B_eye_depth_triangle))];
		if (i % 3 != 0 && key != TS_EMPTY) triangle = (u32)key;
		require(ask_triangle(&epr, triangle, &o));
		u32 from = offset[triangle], to = offset[triangle + 1], first = points[from], n = points[to] - first;
		try_corners(&epr, o, triangle);
		try_spread(json_object_get(o, "eye"));
		try_pieces(&epr, o, from, to - from);
		try_points(&epr, json_object_get(o, "cubes"), first, n);
		try_lookups(&epr, json_object_get(o, "cubes"), first, n);
		n_points += n;
		json_decref(o);
		require(ask_triangle(&mvr, triangle, &o));
		try_corners(&mvr, o, triangle);
		try_spread(json_object_get(o, "eye"));
		try_spread(json_object_get(o, "cubes"));
		json_decref(o);
	}
	assert_true(n_points > MOST_POINTS);
}

static void what_becomes_of_a_point_adds_up(void **state)
{
	(void)state;
	for (u32 i = 0; i < N_TRIED; i++) {
		json_t *o;
		u32 point = below((u32)count(&epr, TS_B_points_record));
		const ts_point *record = (const ts_point *)data(&epr, TS_B_points_record) + point;
		require(ask_point(&epr, point, &o));
		try_corners(&epr, o, ((const ts_piece *)data(&epr, TS_B_split_piece))[record->piece].triangle);
		try_points(&epr, json_object_get(o, "cubes"), point, 1);
		try_lookups(&epr, json_object_get(o, "cubes"), point, 1);
		assert_bits(shown(o, "splat_length", 0), record->length);
		for (u32 c = 0; c < 3; c++) assert_bits(shown(o, "centre", c), record->centre[c]);
		assert_int_equal(json_is_true(json_object_get(o, "tiny")), record->flags & 1);
		assert_int_equal(figure(o, "point"), point);
		json_decref(o);
	}
}

/* A sample's direction leads to the face and texel that are told, and that has the point of the look-up. */
static void try_sample(const traced *t, const json_t *sample, const ts_face *cube, u32 reflector, u32 found)
{
	char face[16];
	f32 d[3];
	for (u32 c = 0; c < 3; c++) d[c] = (f32)json_real_value(json_array_get(json_object_get(sample, "direction"), c));
	ts_cube_place place = ts_k_cube_place(ts_load3(d));
	const json_t *texel = json_object_get(sample, "texel");
	u32 x = (u32)json_integer_value(json_array_get(texel, 0)), y = (u32)json_integer_value(json_array_get(texel, 1));
	double s = ((double)place.s + 1) / 2 * cube->n, r = ((double)place.t + 1) / 2 * cube->n;
	snprintf(face, sizeof face, "%u.%c%c", (unsigned)reflector, place.face % 2 == 0 ? '+' : '-', "XXYYZZ"[place.face]);
	assert_string_equal(json_string_value(json_object_get(sample, "face")), face);
	assert_true(fabs(s - x - 0.5) < 0.501 && fabs(r - y - 0.5) < 0.501);
	u64 key = ((const u64 *)data(
		t, TS_B_splat_depth_index))[cube->offset + (u64)place.face * cube->n * cube->n + (u64)y * cube->n + x];
	const json_t *point = json_object_get(sample, "point"), *distance = json_object_get(sample, "distance");
	assert_int_equal(json_is_integer(point), found != TS_NONE);
	assert_int_equal((u32)key, found);
	assert_int_equal(distance != NULL, key != TS_EMPTY);
	if (found == TS_NONE) return;
	const ts_point *record = (const ts_point *)data(t, TS_B_points_record) + found;
	assert_int_equal(json_integer_value(point), found);
	assert_int_equal(bits_of(json_object_get(distance, "bits")), key >> 32);
	assert_int_equal(figure(sample, "piece"), record->piece);
	assert_int_equal(figure(sample, "triangle"), ((const ts_piece *)data(t, TS_B_split_piece))[record->piece].triangle);
}

/* The mean is that of the samples which are used. Returns how many are not. */
static u32 try_mirror(const traced *t, u32 entry)
{
	json_t *o;
	const ts_pixel *record = (const ts_pixel *)data(t, TS_B_mirror_pixel_record) + entry;
	u32 width = t->run.params.width, used = 0, n_bounces = 0;
	require(ask_pixel(t, record->index % width, record->index / width, &o));
	const json_t *mirror = json_object_get(o, "reflection"), *samples = json_object_get(mirror, "samples");
	u32 reflector = (u32)figure(mirror, "reflector");
	const ts_face *cube = (const ts_face *)data(t, TS_B_cube_size_face) + reflector;
	double mean[3] = {0, 0, 0};
	assert_int_equal(json_array_size(samples), SAMPLES);
	assert_int_equal(figure(mirror, "cube_size"), cube->n);
	for (u32 k = 0; k < SAMPLES; k++) {
		const json_t *sample = json_array_get(samples, k);
		bool is_used = json_object_get(sample, "used") == NULL;
		assert_int_equal(figure(sample, "k"), k);
		assert_true(is_used == (k < figure(mirror, "samples_used")));
		try_sample(t, sample, cube, reflector, ((const u32 *)data(t, TS_B_lookup_point))[(u64)entry * SAMPLES + k]);
		for (u32 c = 0; is_used && c < 3; c++) mean[c] += (double)shown(sample, "radiance", c);
		used += is_used;
		n_bounces += json_object_get(sample, "bounce") != NULL;
	}
	const f32 tint[3] = {record->tint_r, record->tint_g, record->tint_b};
	for (u32 c = 0; c < 3; c++) {
		double told = (double)shown(mirror, "mean", c);
		assert_bits(shown(mirror, "tint", c), tint[c]);
		assert_true(n_bounces > 0 || fabs(told - mean[c] / used) <= 1e-5 * told + 1e-7);
	}
	json_decref(o);
	return SAMPLES - used;
}

static void a_mirror_shows_the_mean_of_its_samples(void **state)
{
	(void)state;
	u32 n_unused = 0;
	for (u32 i = 0; i < N_TRIED; i++) {
		u32 entry = below((u32)count(&epr, TS_B_mirror_pixel_record));
		assert_int_equal(try_mirror(&epr, entry), 0);
		n_unused += try_mirror(&adaptive, entry);
	}
	assert_true(n_unused > N_TRIED);
}

int main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(what_becomes_of_a_triangle_adds_up),
	                                   cmocka_unit_test(what_becomes_of_a_point_adds_up),
	                                   cmocka_unit_test(a_mirror_shows_the_mean_of_its_samples)};
	return cmocka_run_group_tests(tests, make_all, drop_all);
}

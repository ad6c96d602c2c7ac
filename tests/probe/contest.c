/* Who competed: offers in the order of their keys, by how much each lost, and all triangles that a pixel has. */
#include "probe/parts.h"
#include "tests/probe/probed.h"

static ts_probe p;

/* A scene of four triangles of two objects, and four squares before the eye, by hand. */
enum { N_SQUARES = 4 };
static const ts_triangle triangles[] = {
	{{0, 1, 2}, 0},
	{{3, 4, 5}, 0},
	{{6, 7, 8}, 0},
	{{9, 10, 11}, 0},
};
static const ts_object objects[] = {{.reflector = TS_NONE}, {.reflector = 0}};
static const ts_material materials[] = {{.slot = {TS_NONE, TS_NONE, TS_NONE, TS_NONE, TS_NONE}}};
static ts_vertex vertices[3 * N_SQUARES];

/* Triangle t lies at depth 1 + t in front of the eye, which looks along -z, and covers the left half of its view. The
 * last one turns its back. */
static int begin(void **state)
{
	(void)state;
	for (u32 t = 0; t < N_SQUARES; t++) {
		f32 z = -(1.0f + (f32)t), far = 100.0f;
		const f32 corners[3][3] = {{0, -far, z}, {0, far, z}, {-2 * far, 0, z}};
		for (u32 c = 0; c < 3; c++) {
			ts_vertex *v = &vertices[3 * t + (t == 3 ? 2 - c : c)];
			*v = (ts_vertex){.object = t == 1 ? 1 : 0};
			memcpy(v->position, corners[c], sizeof v->position);
		}
	}
	p = (ts_probe){.scene = {.vertices = vertices,
	                         .triangles = triangles,
	                         .materials = materials,
	                         .objects = objects,
	                         .n_triangles = N_SQUARES}};
	return 0;
}

static ts_camera_k camera(void)
{
	const ts_view eye = {
		.focal = 8, .right = {1, 0, 0}, .width = 16, .up = {0, 1, 0}, .height = 16, .back = {0, 0, 1}, .near = 0.5f};
	return ts_k_view(&eye);
}

static u64 key_of(f32 depth, u32 index) { return (u64)ts_f2u(depth) << 32 | index; }

/* However many are added, all are there, in the order of their keys. */
static void offers_stand_in_order_of_keys(void **state)
{
	(void)state;
	ts_offers offers = {.offer = NULL};
	ts_probe_offers_sort(&offers);
	for (u32 i = 0; i < 1000; i++) {
		ts_offer offer = {.key = (u64)ts_random(i, 1, 2) << 32 | ts_random(i, 1, 3), .triangle = i};
		assert_int_equal(ts_probe_offers_add(&offers, offer), TS_OK);
		assert_int_equal(offers.n, i + 1);
	}
	ts_probe_offers_sort(&offers);
	bool seen[1000] = {false};
	for (u32 i = 0; i < 1000; i++) {
		const ts_offer *offer = &offers.offer[i];
		assert_true(i == 0 || offer[-1].key <= offer->key);
		assert_true(!seen[offer->triangle] && offer->key >> 32 == ts_random(offer->triangle, 1, 2));
		seen[offer->triangle] = true;
	}
	free(offers.offer);
}

/* Those that cover the pixel, face the eye and are not the viewer's own, nearest first. */
static void all_that_cover_the_pixel_compete(void **state)
{
	(void)state;
	const ts_camera_k view = camera();
	for (u32 x = 0; x < 16; x++) {
		for (u32 own = 0; own < 2; own++) {
			ts_offers offers = {.offer = NULL};
			static const u32 all[] = {0, 1, 2}, others[] = {0, 2};
			u32 n = x >= 8 ? 0 : own != 0 ? 2 : 3;
			assert_int_equal(ts_probe_contest(&p, &view, own != 0 ? 0 : TS_NONE, x, 5, &offers), TS_OK);
			assert_int_equal(offers.n, n);
			for (u32 i = 0; i < n; i++) {
				u32 t = own != 0 ? others[i] : all[i];
				const ts_offer *offer = &offers.offer[i];
				assert_true(offer->triangle == t && !offer->cut && (u32)offer->key == t);
				assert_true(fabsf(ts_u2f((u32)(offer->key >> 32)) - (f32)(1 + t)) < 1e-6f * (f32)(1 + t));
			}
			free(offers.offer);
		}
	}
}

/* Winner, second and losers of offers at these depths; the index of each is its triangle. */
static json_t *contest_of(const f32 *depths, const bool *cut, u32 n, u64 held, ts_probe_put_index *put_index)
{
	ts_offer offer[8];
	json_t *o = json_object();
	assert_true(n <= 8);
	for (u32 i = 0; i < n; i++) offer[i] = (ts_offer){key_of(depths[i], i), i % N_SQUARES, cut != NULL && cut[i]};
	const ts_offers offers = {.offer = offer, .n = n};
	assert_int_equal(ts_probe_put_offers(&p, o, &offers, TS_B_eye_depth_triangle, held, put_index), TS_OK);
	assert_false(p.failed);
	assert_int_equal(figure(o, "competitors"), n);
	assert_int_equal(json_array_size(json_object_get(o, "by_depth")), n);
	return o;
}

static const char *text(const json_t *o, const char *key) { return json_string_value(json_object_get(o, key)); }
static double real(const json_t *o, const char *key) { return json_real_value(json_object_get(o, key)); }

/* Each loser is as far behind as the depths say. */
static void losers_are_behind_by_their_depths(void **state)
{
	(void)state;
	static const f32 depths[] = {1.0f, 1.5f, 4.0f};
	json_t *o = contest_of(depths, NULL, 3, key_of(1.0f, 0), NULL), *list = json_object_get(o, "by_depth");
	assert_string_equal(text(o, "check"), "bits agree with eye.depth_triangle");
	assert_true(real(o, "won_by") == 0.5);
	assert_int_equal(figure(o, "won_by_ulps"), 1 << 22);
	assert_null(json_object_get(o, "tie"));
	for (u32 i = 0; i < 3; i++) {
		const json_t *row = json_array_get(list, i);
		assert_bits(shown(row, "depth", 0), depths[i]);
		assert_true(figure(row, "triangle") == i && figure(row, "object") == (i == 1) && figure(row, "material") == 0);
		assert_int_equal(json_object_get(row, "reflector") != NULL, i == 1);
		assert_null(json_object_get(row, "distance"));
		assert_int_equal(json_object_get(row, "behind") != NULL, i > 0);
		if (i > 0) assert_true(real(row, "behind") == (double)depths[i] - 1.0);
		if (i > 0) assert_int_equal(figure(row, "behind_ulps"), ts_f2u(depths[i]) - ts_f2u(1.0f));
		assert_null(json_object_get(row, "tie"));
	}
	json_decref(o);
}

static void equal_depths_go_to_the_lower_index(void **state)
{
	(void)state;
	static const f32 depths[] = {2.0f, 2.0f, 3.0f};
	json_t *o = contest_of(depths, NULL, 3, key_of(2.0f, 1), NULL), *list = json_object_get(o, "by_depth");
	assert_string_equal(text(o, "tie"), "equal depths go to the lower index");
	assert_int_equal(figure(o, "won_by_ulps"), 0);
	assert_string_equal(text(o, "check"),
	                    "bits differ from eye.depth_triangle, which holds 40000000_00000001: depth 2, index 1");
	assert_null(json_object_get(json_array_get(list, 0), "tie"));
	assert_string_equal(text(json_array_get(list, 1), "tie"), "lost by its index, or its colour, alone");
	assert_null(json_object_get(json_array_get(list, 2), "tie"));
	json_decref(o);
}

/* What alpha takes away neither wins nor is second. */
static void what_alpha_cuts_neither_wins_nor_loses(void **state)
{
	(void)state;
	static const f32 depths[] = {1.0f, 2.0f, 3.0f, 6.0f};
	static const bool cut[] = {true, false, true, false}, all[] = {true, true, true, true};
	json_t *o = contest_of(depths, cut, 4, key_of(2.0f, 1), NULL), *list = json_object_get(o, "by_depth");
	assert_string_equal(text(o, "check"), "bits agree with eye.depth_triangle");
	assert_true(real(o, "won_by") == 4.0);
	for (u32 i = 0; i < 4; i++) {
		const json_t *row = json_array_get(list, i);
		assert_int_equal(json_object_get(row, "cut") != NULL, cut[i]);
		assert_int_equal(json_object_get(row, "behind") != NULL, i == 3);
	}
	json_decref(o);
	o = contest_of(depths, all, 4, TS_EMPTY, NULL);
	assert_string_equal(text(o, "check"), "bits agree with eye.depth_triangle");
	assert_null(json_object_get(o, "won_by"));
	json_decref(o);
	o = contest_of(depths, NULL, 0, key_of(1.0f, 0), NULL);
	assert_memory_equal(text(o, "check"), "bits differ", 11);
	json_decref(o);
}

static ts_status put_twice(ts_probe *probe, json_t *o, u32 index)
{
	ts_probe_put(probe, o, "twice", ts_probe_int(2 * (u64)index));
	return index < 2 ? TS_OK : ts_fail("no such thing");
}

/* Indices of other things than triangles are told by who knows them, who may fail. */
static void other_indices_are_told_by_their_kind(void **state)
{
	(void)state;
	static const f32 depths[] = {1.0f, 1.5f};
	json_t *o = contest_of(depths, NULL, 2, key_of(1.0f, 0), put_twice), *list = json_object_get(o, "by_depth");
	for (u32 i = 0; i < 2; i++) {
		assert_int_equal(figure(json_array_get(list, i), "twice"), 2 * i);
		assert_bits(shown(json_array_get(list, i), "distance", 0), depths[i]);
		assert_null(json_object_get(json_array_get(list, i), "depth"));
	}
	json_decref(o);
	ts_offer offer[] = {{key_of(1.0f, 2), 0, false}};
	o = json_object();
	assert_int_equal(ts_probe_put_offers(&p, o, &(ts_offers){offer, 1, 1}, TS_B_splat_depth_index, 0, put_twice),
	                 TS_ERROR);
	json_decref(o);
}

/* Of many only the nearest are listed, which is said. */
static void only_the_nearest_of_many_are_listed(void **state)
{
	(void)state;
	ts_offer offer[100];
	for (u32 n = 63; n <= 100; n += n < 65 ? 1 : 35) {
		json_t *o = json_object();
		for (u32 i = 0; i < n; i++) offer[i] = (ts_offer){key_of(1.0f, i), 0, i < n - 2};
		const ts_offers offers = {offer, n, n};
		assert_int_equal(ts_probe_put_offers(&p, o, &offers, TS_B_eye_depth_triangle, offer[n - 2].key, NULL), TS_OK);
		assert_int_equal(figure(o, "competitors"), n);
		assert_int_equal(json_array_size(json_object_get(o, "by_depth")), n < 64 ? n : 64);
		assert_int_equal(json_object_get(o, "listed") != NULL, n > 64);
		assert_string_equal(text(o, "check"), "bits agree with eye.depth_triangle");
		json_decref(o);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(offers_stand_in_order_of_keys),
		cmocka_unit_test(all_that_cover_the_pixel_compete),
		cmocka_unit_test(losers_are_behind_by_their_depths),
		cmocka_unit_test(equal_depths_go_to_the_lower_index),
		cmocka_unit_test(what_alpha_cuts_neither_wins_nor_loses),
		cmocka_unit_test(other_indices_are_told_by_their_kind),
		cmocka_unit_test(only_the_nearest_of_many_are_listed),
	};
	return cmocka_run_group_tests(tests, begin, NULL);
}

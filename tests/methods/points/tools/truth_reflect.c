/* Truths A and B over reflectors made by hand: closed forms, what both must agree on, and where they must differ. */
#include "kernels/base/shade.h"
#include "kernels/points/samples.h"
#include "kernels/raster/cube.h"
#include "methods/points/tools/tools.h"
#include "tests/model/test.h"
#include "tests/truth/world.h"
#include "truth/truth.h"

enum { N_PIXELS = 2000, SEED = 3, STREAM = 6 };

typedef struct {
	world world;
	ts_view eye;
	ts_face faces[WORLD_OBJECTS - 1];
	ts_pixel pixels[N_PIXELS];
	u32 n_pixels;
	ts_truth *truth;
} stand;

static stand *stand_new(ts_v3 eye)
{
	stand *s = calloc(1, sizeof(*s));
	assert_non_null(s);
	world_begin(&s->world);
	s->eye = (ts_view){.focal = 256, .width = 512, .height = 512};
	ts_store3(s->eye.eye, eye);
	for (u32 i = 0; i < WORLD_OBJECTS - 1; i++) s->faces[i] = (ts_face){.n = 64, .radius = 1};
	return s;
}

static void place_cube(stand *s, u32 reflector, ts_v3 centre) { ts_store3(s->faces[reflector].centre, centre); }

static ts_pixel *add_pixel(stand *s, ts_v3 p, ts_v3 n, u32 reflector, f32 tint)
{
	assert_true(s->n_pixels < N_PIXELS);
	ts_pixel *pixel = &s->pixels[s->n_pixels++];
	*pixel = (ts_pixel){.reflector = reflector, .tint_r = tint, .tint_g = tint, .tint_b = tint};
	ts_store3(pixel->position, p);
	ts_store3(pixel->normal, n);
	return pixel;
}

static void grow(stand *s)
{
	ts_frame *frame = &s->world.run.frame;
	world_pose(&s->world);
	ts_frame_borrow(frame, TS_B_eye_view, &s->eye, 1);
	ts_frame_borrow(frame, TS_B_cube_size_face, s->faces, WORLD_OBJECTS - 1);
	ts_frame_borrow(frame, TS_B_mirror_pixel_record, s->pixels, s->n_pixels);
	assert_int_equal(ts_truth_new(&s->truth, &s->world.run), TS_OK);
}

/* A copy of the answer, P x 3. */
static f32 *answer(stand *s, ts_status (*method)(ts_truth *, ts_run *, ts_sampling *), u32 bounces, u32 threads)
{
	s->world.run.params.lookup_bounces = bounces;
	s->world.run.c.threads = threads;
	assert_int_equal(method(s->truth, &s->world.run, NULL), TS_OK);
	assert_int_equal(ts_frame_n(&s->world.run.frame, TS_B_shade_radiance), s->n_pixels * 3);
	f32 *copy = malloc((size_t)s->n_pixels * 3 * sizeof(f32));
	assert_non_null(copy);
	memcpy(copy, ts_frame_data(&s->world.run.frame, TS_B_shade_radiance), (size_t)s->n_pixels * 3 * sizeof(f32));
	return copy;
}

static void assert_radiance(stand *s, ts_status (*method)(ts_truth *, ts_run *, ts_sampling *), u32 bounces,
                            ts_v3 expected)
{
	f32 *got = answer(s, method, bounces, 2);
	f32 want[3] = {expected.x, expected.y, expected.z};
	for (u32 i = 0; i < s->n_pixels * 3; i++) assert_true(ts_abs(got[i] - want[i % 3]) <= 1e-5f);
	free(got);
}

static void end(stand *s)
{
	ts_truth_free(s->truth);
	ts_run_end(&s->world.run);
	free(s);
}

static ts_v3 wall_colour(const stand *s, u32 wall) { return ts_load3(s->world.materials[WALL + wall].base); }

static void quad_x(stand *s, f32 x, u32 material, u32 object)
{
	world_quad(&s->world, ts_v3_make(x, -1, -1), ts_v3_make(x, 1, -1), ts_v3_make(x, 1, 1), ts_v3_make(x, -1, 1),
	           material, object);
}

static f32 uniform(u32 id) { return ts_uniform(ts_random(id, STREAM, SEED)) * 2 - 1; }

/* Pixels of a reflector, a ball of this radius about the origin, as far as an eye on +z sees it. */
static void ball_pixels(stand *s, f32 radius)
{
	ts_v3 eye = ts_load3(s->eye.eye);
	for (u32 id = 0; s->n_pixels < N_PIXELS; id += 3) {
		ts_v3 n = ts_v3_make(uniform(id), uniform(id + 1), uniform(id + 2));
		f32 l = ts_length(n);
		n = ts_normalize(n);
		ts_v3 p = ts_scale(n, radius);
		if (l > 0.1f && l <= 1 && ts_dot(n, ts_sub(eye, p)) > 0) add_pixel(s, p, n, 0, 0.5f);
	}
}

static stand *ball_in_room(f32 half, bool with_reflector)
{
	stand *s = stand_new(ts_v3_make(0, 0, 4));
	world_room(&s->world, ts_v3_make(-half, -half, -half), ts_v3_make(half, half, half), WALL, 0);
	for (u32 i = 0; i < 12; i++) s->world.triangles[i].material = WALL + i / 2;
	if (with_reflector) quad_x(s, 3, WALL, 2);
	ball_pixels(s, 1);
	grow(s);
	return s;
}

static u32 n_unequal(const f32 *a, const f32 *b, u32 n)
{
	u32 unequal = 0;
	for (u32 i = 0; i < n; i++) unequal += ts_abs(a[i * 3] - b[i * 3]) > 1e-6f;
	return unequal;
}

/* Where nothing is hit, both see the background through the tint. */
static void where_nothing_is_hit_the_background_shows(void **state)
{
	(void)state;
	stand *s = stand_new(ts_v3_make(0, 0, 4));
	ball_pixels(s, 1);
	grow(s);
	assert_radiance(s, ts_truth_a, 3, ts_scale(ts_k_background(), 0.5f));
	assert_radiance(s, ts_truth_b, 3, ts_scale(ts_k_background(), 0.5f));
	end(s);
}

/* Of an environment at infinity it does not matter from where the reflector looks; of a near one it does. */
static void at_infinity_both_truths_agree(void **state)
{
	(void)state;
	static const struct {
		f32 half;
		u32 least, most;
	} cases[] = {{1048576, 0, 2}, {8, 20, N_PIXELS / 4}};
	for (u32 i = 0; i < 2; i++) {
		stand *s = ball_in_room(cases[i].half, false);
		f32 *a = answer(s, ts_truth_a, 1, 2), *b = answer(s, ts_truth_b, 1, 2);
		u32 unequal = n_unequal(a, b, s->n_pixels);
		assert_true(unequal >= cases[i].least && unequal <= cases[i].most);
		free(a);
		free(b);
		end(s);
	}
}

/* The axis of the greatest component, or 3 if two of them are nearly equal. */
static u32 main_axis(const f32 c[3])
{
	for (u32 i = 0; i < 3; i++) {
		f32 others = ts_max(ts_abs(c[(i + 1) % 3]), ts_abs(c[(i + 2) % 3]));
		if (ts_abs(c[i]) > others + 1e-5f) return i;
	}
	return 3;
}

/* Each pixel sees the wall along the greatest component of its direction from the room's middle. */
static void each_pixel_sees_its_directions_wall(void **state)
{
	(void)state;
	stand *s = ball_in_room(8, false);
	f32 *a = answer(s, ts_truth_a, 1, 2);
	for (u32 i = 0; i < s->n_pixels; i++) {
		f32 d[3];
		ts_store3(d, ts_k_sample_ray(&s->pixels[i], ts_load3(s->eye.eye), 0).direction);
		u32 axis = main_axis(d);
		if (axis == 3) continue;
		ts_v3 wall = wall_colour(s, axis * 2 + (d[axis] > 0));
		assert_true(ts_abs(a[i * 3] - 0.5f * wall.x) <= 1e-6f);
		assert_true(ts_abs(a[i * 3 + 2] - 0.5f * wall.z) <= 1e-6f);
	}
	free(a);
	end(s);
}

/* A wall of the reflector itself: B sees it, A looks through it to the wall behind. */
static void only_truth_b_sees_the_own_reflector(void **state)
{
	(void)state;
	stand *s = stand_new(ts_v3_make(0.5f, 0, 0));
	quad_x(s, 0, TWO_SIDED, 1);
	quad_x(s, 1, WALL + 1, 1);
	quad_x(s, 2, WALL + 4, 0);
	place_cube(s, 0, ts_v3_make(0.25f, 0, 0));
	add_pixel(s, ts_v3_make(0, 0, 0), ts_v3_make(1, 0, 0), 0, 1);
	grow(s);
	assert_radiance(s, ts_truth_a, 1, wall_colour(s, 4));
	assert_radiance(s, ts_truth_b, 1, wall_colour(s, 1));
	end(s);
}

/* Two reflectors face to face, a coloured wall behind the first: tint, then the second one's colour, then the wall. */
static void bounces_tint_one_after_the_other(void **state)
{
	(void)state;
	stand *s = stand_new(ts_v3_make(0.5f, 0, 0));
	quad_x(s, -1, WALL + 2, 0);
	quad_x(s, 2, WALL + 5, 2);
	place_cube(s, 0, ts_v3_make(0, 0, 0));
	place_cube(s, 1, ts_v3_make(2, 0, 0));
	add_pixel(s, ts_v3_make(0, 0, 0), ts_v3_make(1, 0, 0), 0, 0.5f);
	grow(s);
	ts_v3 second = wall_colour(s, 5), wall = wall_colour(s, 2);
	for (u32 m = 0; m < 2; m++) {
		ts_status (*method)(ts_truth *, ts_run *, ts_sampling *) = m == 0 ? ts_truth_a : ts_truth_b;
		assert_radiance(s, method, 1, ts_scale(second, 0.5f));
		assert_radiance(s, method, 2, ts_scale(ts_mul(second, wall), 0.5f));
		assert_radiance(s, method, 3, ts_scale(ts_mul(second, wall), 0.5f));
	}
	end(s);
}

static void threads_change_no_truth(void **state)
{
	(void)state;
	stand *s = ball_in_room(8, true);
	for (u32 i = 0; i < s->n_pixels; i++) ts_store3(s->pixels[i].normal_dx, ts_v3_make(0.01f, 0.02f, 0));
	for (u32 m = 0; m < 2; m++) {
		f32 *one = answer(s, m == 0 ? ts_truth_a : ts_truth_b, 3, 1);
		f32 *two = answer(s, m == 0 ? ts_truth_a : ts_truth_b, 3, 2);
		assert_memory_equal(one, two, (size_t)s->n_pixels * 3 * sizeof(f32));
		free(one);
		free(two);
	}
	end(s);
}

/* The hits are those of single rays from the cube's centre through the centres of texels. */
static void hits_are_those_of_single_rays(void **state)
{
	(void)state;
	stand *s = ball_in_room(8, false);
	u32 *hits;
	assert_int_equal(ts_truth_hits(s->truth, &s->world.run, NULL, &hits), TS_OK);
	for (u32 i = 0; i < s->n_pixels; i++)
		for (u32 k = 0; k < TS_N_SAMPLES; k++) {
			ts_v3 d = ts_k_sample_ray(&s->pixels[i], ts_load3(s->eye.eye), k).direction;
			ts_cube_place at = ts_k_cube_place(d);
			f32 x = (floorf((at.s + 1) * 32) + 0.5f) / 32 - 1, y = (floorf((at.t + 1) * 32) + 0.5f) / 32 - 1;
			d = ts_normalize(ts_k_cube_direction(at.face, x, y));
			ts_truth_query query = {.origin = ts_load3(s->faces[0].centre), .direction = d};
			u32 hit = ts_truth_cast(s->truth, &query).triangle;
			assert_int_not_equal(hit, TS_NONE);
			assert_int_equal(hits[i * TS_N_SAMPLES + k], hit);
		}
	free(hits);
	end(s);
}

/* What rays hit, and the look-ups that are empty there; a look-up behind the last is none. */
static void missed_look_ups_are_counted(void **state)
{
	(void)state;
	stand *s = ball_in_room(8, false);
	u64 n = (u64)s->n_pixels * TS_N_SAMPLES, n_hits = 3, n_missed = 4, n_empty = 0;
	u32 *found = ts_frame_make1(&s->world.run.frame, TS_B_lookup_point, n + 1);
	for (u64 i = 0; i <= n; i++) found[i] = i % 7 == 0 || i == n ? TS_NONE : (u32)i;
	for (u64 i = 0; i < n; i++) n_empty += found[i] == TS_NONE;
	ts_frame_cut(&s->world.run.frame, TS_B_lookup_point, n);
	assert_int_equal(ts_truth_missed(&n_hits, &n_missed, s->truth, &s->world.run, NULL), TS_OK);
	assert_int_equal(n_hits, 3 + n);
	assert_int_equal(n_missed, 4 + n_empty);
	end(s);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(where_nothing_is_hit_the_background_shows),
		cmocka_unit_test(at_infinity_both_truths_agree),
		cmocka_unit_test(each_pixel_sees_its_directions_wall),
		cmocka_unit_test(only_truth_b_sees_the_own_reflector),
		cmocka_unit_test(bounces_tint_one_after_the_other),
		cmocka_unit_test(threads_change_no_truth),
		cmocka_unit_test(hits_are_those_of_single_rays),
		cmocka_unit_test(missed_look_ups_are_counted),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

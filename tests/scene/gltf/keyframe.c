/* Between keyframes, against closed forms in doubles: the shorter arc, lines, and Hermite's cubic. STEP and the order
 * of keys are judged by tests/cli/animation.sh, from whole files. */
#include "scene/gltf/keyframe.h"
#include "tests/kernels/seeded.h"

enum { N = 20000 };

static void random_turn(f32 q[4])
{
	double square = 0;
	for (u32 i = 0; i < 4; i++) q[i] = uniform(-1, 1);
	for (u32 i = 0; i < 4; i++) square += (double)q[i] * q[i];
	if (square < 0.01) q[3] = 1;
}

static double dot4(const f32 *a, const f32 *b)
{
	double sum = 0;
	for (u32 i = 0; i < 4; i++) sum += (double)a[i] * b[i];
	return sum;
}

/* From a about an axis by s of the whole angle, on the shorter of the two arcs. */
static void a_turn_follows_the_shorter_arc(void **state)
{
	(void)state;
	for (u32 k = 0; k < N; k++) {
		f32 a[4], b[4], to[4], s = uniform(0, 1);
		random_turn(a);
		random_turn(b);
		double length_a = sqrt(dot4(a, a)), length_b = sqrt(dot4(b, b)), cosine = dot4(a, b) / (length_a * length_b);
		double sign = cosine < 0 ? -1 : 1, angle = acos(fmin(fabs(cosine), 1));
		if (angle < 1e-3) continue;
		ts_keyframe_turn(to, a, b, s);
		for (u32 i = 0; i < 4; i++) {
			double of_a = sin((1 - (double)s) * angle) * a[i] / length_a, of_b = sin(s * angle) * b[i] / length_b;
			assert_near(to[i], (of_a + sign * of_b) / sin(angle), 4e-6);
		}
		assert_near(dot4(to, to), 1, 4e-6);
	}
}

/* Half a degree down to nothing: neither a jump where the arc becomes a line nor a division by 0. */
static void small_turns_do_not_jump(void **state)
{
	(void)state;
	for (double angle = 0.01; angle > 1e-9; angle *= 0.9) {
		f32 a[4] = {0, 0, 0, 2}, b[4] = {(f32)(-3 * sin(angle)), 0, 0, (f32)(-3 * cos(angle))}, to[4];
		ts_keyframe_turn(to, a, b, 0.25f);
		assert_near(to[0], sin(angle / 4), 1e-7);
		assert_near(to[3], cos(angle / 4), 1e-6);
	}
}

/* Quaternions that are opposite turn nothing; those at a right angle have a middle. */
static void opposite_quaternions_turn_nothing(void **state)
{
	(void)state;
	const f32 a[4] = {0, 0, 0, 1}, opposite[4] = {0, 0, 0, -5}, half[4] = {0, 1, 0, 0};
	f32 to[4];
	ts_keyframe_turn(to, a, opposite, 0.5f);
	assert_true(to[0] == 0 && to[1] == 0 && to[2] == 0 && to[3] == 1);
	ts_keyframe_turn(to, a, half, 0.5f);
	assert_near(to[1], sqrt(0.5), 1e-6);
	assert_near(to[3], sqrt(0.5), 1e-6);
}

static void a_line_is_in_proportion(void **state)
{
	(void)state;
	for (u32 k = 0; k < N; k++) {
		f32 a[3], b[3], to[3], s = uniform(0, 1);
		ts_store3(a, uniform3(-9, 9));
		ts_store3(b, uniform3(-9, 9));
		ts_keyframe_line(to, a, b, 3, s);
		for (u32 i = 0; i < 3; i++) assert_near(to[i], a[i] + (double)s * ((double)b[i] - a[i]), 2e-6);
	}
}

/* A cubic in seconds is its own interpolation: its values and slopes at the ends give it back. */
static void a_cubic_gives_itself_back(void **state)
{
	(void)state;
	for (u32 k = 0; k < N; k++) {
		double c[4], h = uniform(0.1f, 2);
		for (u32 i = 0; i < 4; i++) c[i] = uniform(-2, 2);
		f32 seconds = (f32)h, s = uniform(0, 1), to;
		f32 a = (f32)c[0], from = (f32)c[1];
		f32 b = (f32)(c[0] + h * (c[1] + h * (c[2] + h * c[3]))), into = (f32)(c[1] + h * (2 * c[2] + 3 * h * c[3]));
		double t = s * h;
		ts_keyframe_cubic(&to, &a, &from, &into, &b, 1, s, seconds);
		assert_near(to, c[0] + t * (c[1] + t * (c[2] + t * c[3])), 4e-5);
	}
}

static void keyframes_give_themselves_unrounded(void **state)
{
	(void)state;
	for (u32 k = 0; k < N; k++) {
		f32 a = uniform(-9, 9), b = uniform(-9, 9), from = uniform(-9, 9), into = uniform(-9, 9), to;
		ts_keyframe_line(&to, &a, &b, 1, 0);
		assert_true(to == a);
		ts_keyframe_line(&to, &a, &b, 1, 1);
		assert_true(to == b);
		ts_keyframe_cubic(&to, &a, &from, &into, &b, 1, 0, 2);
		assert_true(to == a);
		ts_keyframe_cubic(&to, &a, &from, &into, &b, 1, 1, 2);
		assert_true(to == b);
	}
}

static void a_path_has_thirty_frames_a_second(void **state)
{
	(void)state;
	assert_int_equal(ts_keyframe_count(0), 1);
	assert_int_equal(ts_keyframe_count(0.01f), 1);
	assert_int_equal(ts_keyframe_count(1), 30);
	assert_int_equal(ts_keyframe_count(1.25f), 38);
	assert_int_equal(ts_keyframe_count(2184), 65520);
	for (u32 frame = 0; frame < 65520; frame++) assert_near(ts_keyframe_time(frame), frame / 30.0, frame * 1e-7 / 30);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(a_turn_follows_the_shorter_arc),    seeded_test(small_turns_do_not_jump),
		seeded_test(opposite_quaternions_turn_nothing), seeded_test(a_line_is_in_proportion),
		seeded_test(a_cubic_gives_itself_back),         seeded_test(keyframes_give_themselves_unrounded),
		seeded_test(a_path_has_thirty_frames_a_second),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

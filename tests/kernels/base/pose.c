/* Moving objects against the closed form of their path: an ellipse, a bob of twice the frequency, a spin about y;
 * and of those of the file against their matrices. */
#include "kernels/base/pose.h"
#include "tests/kernels/seeded.h"

enum { N = 20000 };

static ts_object random_object(void)
{
	ts_object o = {.period = 1 + below(500), .phase = uniform(0, 1), .bob = uniform(0, 2), .spin = (f32)below(7) - 3};
	ts_store3(o.centre, uniform3(-9, 9));
	o.axis[0] = uniform(0, 5);
	o.axis[1] = uniform(0, 5);
	return o;
}

static ts_vertex random_vertex(void)
{
	ts_vertex v = {.tangent = {0, 0, 0, -1}, .uv = {1, 2, 3, 4}, .colour = {5, 6, 7, 8}};
	ts_store3(v.position, uniform3(-2, 2));
	ts_store3(v.normal, direction());
	ts_store3(v.tangent, direction());
	return v;
}

static ts_vertex posed(const ts_object *object, ts_vertex v, u32 frame)
{
	ts_vertex out;
	ts_pose_args args = {.vertices = &v, .objects = object, .posed = &out, .frame = frame};
	ts_k_pose_item(&args, 0);
	return out;
}

static double3 turned(ts_v3 p, double cosine, double sine)
{
	return (double3){cosine * p.x + sine * p.z, p.y, cosine * p.z - sine * p.x};
}

static void moving_objects_follow_their_ellipse(void **state)
{
	(void)state;
	double turn = 2 * acos(-1);
	for (u32 i = 0; i < N; i++) {
		ts_object o = random_object();
		ts_vertex v = random_vertex();
		u32 frame = below(2000);
		double angle = turn * ((double)o.phase + (double)(frame % o.period) / o.period), spin = o.spin * angle;
		double3 path = {o.axis[0] * cos(angle), o.bob * sin(2 * angle), o.axis[1] * sin(angle)};
		double3 centre = d3_add(d3_of(ts_load3(o.centre)), path);
		ts_vertex w = posed(&o, v, frame);
		double3 p = d3_add(centre, turned(ts_load3(v.position), cos(spin), sin(spin)));
		assert_true(d3_distance(d3_of(ts_load3(w.position)), p) <= 2e-5);
		assert_true(d3_distance(d3_of(ts_load3(w.normal)), turned(ts_load3(v.normal), cos(spin), sin(spin))) <= 1e-5);
		assert_true(d3_distance(d3_of(ts_load3(w.tangent)), turned(ts_load3(v.tangent), cos(spin), sin(spin))) <= 1e-5);
		assert_near(d3_length(d3_of(ts_load3(w.normal))), 1, 1e-6);
		assert_memory_equal(&v.tangent[3], &w.tangent[3], sizeof v - offsetof(ts_vertex, tangent) - 12);
	}
}

/* A turn later everything is where it was, bit for bit, however many turns. */
static void a_turn_later_nothing_has_changed(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_object o = random_object();
		ts_vertex v = random_vertex();
		u32 frame = below(o.period);
		ts_vertex a = posed(&o, v, frame), b = posed(&o, v, frame + o.period * (1 + below(1000)));
		assert_memory_equal(&a, &b, sizeof a);
	}
}

/* What stands still keeps its bits, -0 and all. */
static void what_stands_still_keeps_its_bits(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_object o = random_object();
		ts_vertex v = random_vertex();
		o.period = 0;
		v.position[0] = -0.0f;
		ts_vertex w = posed(&o, v, below(2000));
		assert_memory_equal(&v, &w, sizeof v);
	}
}

/* Four frames a turn: the ends of the two axes, and quarter turns, without rounding. */
static void quarter_turns_are_exact(void **state)
{
	(void)state;
	ts_object o = {.period = 4, .axis = {2, 3}, .spin = 1, .centre = {10, 20, 30}};
	ts_vertex v = {.position = {0.5f, 1, 0}};
	const f32 expected[4][3] = {{12.5f, 21, 30}, {10, 21, 32.5f}, {7.5f, 21, 30}, {10, 21, 27.5f}};
	for (u32 frame = 0; frame < 8; frame++) {
		ts_vertex w = posed(&o, v, frame);
		for (u32 axis = 0; axis < 3; axis++) assert_true(w.position[axis] == expected[frame % 4][axis]);
	}
	ts_pose quarter = ts_k_pose(&o, 1);
	assert_true(quarter.cos == 0 && quarter.sin == 1 && quarter.moves == 1);
}

static void each_vertex_follows_its_own_object(void **state)
{
	(void)state;
	ts_object objects[2] = {{.period = 0}, {.period = 10, .centre = {0, 7, 0}}};
	ts_vertex in[2] = {{.position = {1, 2, 3}}, {.position = {1, 2, 3}, .object = 1}}, out[2];
	ts_pose_args args = {.vertices = in, .objects = objects, .posed = out};
	for (u32 i = 0; i < 2; i++) ts_k_pose_item(&args, i);
	assert_true(out[0].position[1] == 2 && out[1].position[1] == 9);
	assert_true(out[0].object == 0 && out[1].object == 1);
}

static ts_motion random_motion(void)
{
	ts_motion m = {.moves = 1 + below(2)};
	for (u32 i = 0; i < 9; i++) {
		m.linear[i] = uniform(-2, 2);
		m.normal[i] = uniform(-2, 2);
	}
	ts_store3(m.origin, uniform3(-9, 9));
	return m;
}

static double3 through(const f32 *rows, ts_v3 v)
{
	double to[3];
	for (u32 i = 0; i < 3; i++)
		to[i] = (double)rows[3 * i] * v.x + (double)rows[3 * i + 1] * v.y + (double)rows[3 * i + 2] * v.z;
	return (double3){to[0], to[1], to[2]};
}

static void assert_along(const f32 *found, double3 right)
{
	double length = d3_length(right);
	if (length < 0.1) return;
	double3 unit = {right.x / length, right.y / length, right.z / length};
	assert_true(d3_distance(d3_of(ts_load3(found)), unit) <= 2e-5);
}

/* The motion of the frame and of the object is taken, again after the last; a record that does not move leaves the
 * object as it is, on its ellipse or still. */
static void objects_of_files_follow_their_matrices(void **state)
{
	(void)state;
	enum { FRAMES = 5, OBJECTS = 3 };
	for (u32 k = 0; k < N; k++) {
		ts_object objects[OBJECTS] = {{.period = 0}, {.period = FRAMES}, random_object()};
		ts_motion motions[FRAMES * OBJECTS] = {0};
		for (u32 i = 0; i < FRAMES; i++) motions[i * OBJECTS + 1] = random_motion();
		ts_vertex v = random_vertex(), out;
		u32 frame = below(2000);
		ts_pose_args args = {.vertices = &v,
		                     .objects = objects,
		                     .motions = motions,
		                     .posed = &out,
		                     .n_objects = OBJECTS,
		                     .n_motion = FRAMES,
		                     .frame = frame};
		v.object = 1;
		ts_k_pose_item(&args, 0);
		const ts_motion *m = &motions[frame % FRAMES * OBJECTS + 1];
		double3 right = d3_add(through(m->linear, ts_load3(v.position)), d3_of(ts_load3(m->origin)));
		assert_true(d3_distance(d3_of(ts_load3(out.position)), right) <= 1e-5);
		assert_along(out.normal, through(m->normal, ts_load3(v.normal)));
		assert_along(out.tangent, through(m->linear, ts_load3(v.tangent)));
		assert_true(out.tangent[3] == (m->moves == 2 ? -v.tangent[3] : v.tangent[3]));
		out.tangent[3] = v.tangent[3];
		assert_memory_equal(&v.tangent[3], &out.tangent[3], sizeof v - offsetof(ts_vertex, tangent) - 12);
		v.object = 0;
		ts_k_pose_item(&args, 0);
		assert_memory_equal(&v, &out, sizeof v);
		v.object = 2;
		ts_k_pose_item(&args, 0);
		v.object = 0;
		ts_vertex ellipse = posed(&objects[2], v, frame);
		ellipse.object = 2;
		assert_memory_equal(&ellipse, &out, sizeof v);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(moving_objects_follow_their_ellipse), seeded_test(a_turn_later_nothing_has_changed),
		seeded_test(what_stands_still_keeps_its_bits),    seeded_test(quarter_turns_are_exact),
		seeded_test(each_vertex_follows_its_own_object),  seeded_test(objects_of_files_follow_their_matrices),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

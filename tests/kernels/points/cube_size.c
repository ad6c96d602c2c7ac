/* Cube sizes against the projected box in double precision, cube.hysteresis, and the box and ball of the vertices. */
#include "kernels/points/cube_size.h"
#include "tests/kernels/small.h"

enum { N = 20000, N_VERTICES = 12 };

static const ts_view eye = {
	.focal = 100,
	.right = {1, 0, 0},
	.width = 320,
	.up = {0, 1, 0},
	.height = 180,
	.back = {0, 0, 1},
	.near = 0.5f,
};

static ts_vertex vertices[N_VERTICES + 2];
static ts_object objects[2];
static u32 reflector_objects[1] = {1};
static ts_face cube;

/* Vertices 1 to N_VERTICES are the reflector's; those beside them are not. */
static void make_object(ts_v3 centre, f32 size)
{
	memset(vertices, 0, sizeof vertices);
	for (u32 k = 0; k < N_VERTICES + 2; k++) {
		ts_store3(vertices[k].position, ts_add(centre, uniform3(-size, size)));
	}
	vertices[0].position[0] = vertices[N_VERTICES + 1].position[1] = 1e6f;
	objects[1] = (ts_object){.first_vertex = 1, .n_vertices = N_VERTICES};
	cube = (ts_face){.n = 0};
}

static ts_cube_size_args plain(void)
{
	return (ts_cube_size_args){
		.vertices = vertices,
		.objects = objects,
		.reflector_objects = reflector_objects,
		.view = &eye,
		.cubes = &cube,
		.n_max = 512,
		.hysteresis = 32,
	};
}

static u32 resized(const ts_cube_size_args *args)
{
	ts_k_cube_size_item(args, 0);
	return cube.n;
}

static void box(double3 *lo, double3 *hi)
{
	*lo = *hi = d3_of(ts_load3(vertices[1].position));
	for (u32 k = 2; k <= N_VERTICES; k++) {
		double3 p = d3_of(ts_load3(vertices[k].position));
		*lo = (double3){fmin(lo->x, p.x), fmin(lo->y, p.y), fmin(lo->z, p.z)};
		*hi = (double3){fmax(hi->x, p.x), fmax(hi->y, p.y), fmax(hi->z, p.z)};
	}
}

/* Box, centre, radius and near plane of this frame's vertices, and of no others. */
static void box_and_ball_hold_the_reflector_alone(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		make_object(uniform3(-5, 5), uniform(0.1f, 3));
		ts_cube_size_args args = plain();
		resized(&args);
		double3 lo, hi;
		box(&lo, &hi);
		assert_true(d3_distance(d3_of(ts_load3(cube.box_min)), lo) == 0);
		assert_true(d3_distance(d3_of(ts_load3(cube.box_max)), hi) == 0);
		double3 c = d3_of(ts_load3(cube.centre));
		assert_true(d3_distance(c, d3_scale(d3_add(lo, hi), 0.5)) <= 1e-6);
		double radius = 0;
		for (u32 k = 1; k <= N_VERTICES; k++) {
			radius = fmax(radius, d3_distance(d3_of(ts_load3(vertices[k].position)), c));
		}
		assert_near(cube.radius, radius, 1e-6);
		assert_true(cube.near == cube.radius / 1024 && cube.object == 1);
	}
}

typedef struct {
	double x0, y0, x1, y1;
} extent;

static void add(extent *e, double3 p)
{
	double x = 160 + 100 * p.x / -p.z, y = 90 - 100 * p.y / -p.z;
	*e = (extent){fmin(e->x0, x), fmin(e->y0, y), fmax(e->x1, x), fmax(e->y1, y)};
}

static double3 box_corner(double3 lo, double3 hi, u32 k)
{
	return (double3){k & 1 ? hi.x : lo.x, k & 2 ? hi.y : lo.y, k & 4 ? hi.z : lo.z};
}

/* The part of a box before the near plane is the hull of its corners there and of its face in the plane. */
static extent project(double3 lo, double3 hi)
{
	extent e = {INFINITY, INFINITY, -INFINITY, -INFINITY};
	for (u32 k = 0; k < 8; k++) {
		double3 p = box_corner(lo, hi, k);
		if (-p.z >= 0.5) add(&e, p);
		p.z = -0.5;
		if (hi.z > -0.5 && lo.z < -0.5) add(&e, p);
	}
	return e;
}

/* The larger side of the projected box, rounded up, in [16, n_max]; nothing where it is off the screen. */
static void sides_are_those_of_the_projected_box(void **state)
{
	(void)state;
	u32 n_cut = 0, n_off = 0, n_between = 0;
	for (u32 i = 0; i < N; i++) {
		make_object(uniform3(-6, 6), uniform(0.1f, 2));
		ts_cube_size_args args = plain();
		double3 lo, hi;
		box(&lo, &hi);
		extent e = project(lo, hi);
		double side = fmax(e.x1 - e.x0, e.y1 - e.y0);
		double off = fmax(fmax(-e.x1, -e.y1), fmax(e.x0 - 320, e.y0 - 180));
		u32 n = resized(&args);
		if (fabs(off) < 0.01 || fabs(lo.z + 0.5) < 1e-4) continue;
		if (off > 0 || lo.z > -0.5) {
			n_off++;
			assert_int_equal(n, 0);
			args.all = 1;
			if (off < INFINITY) assert_true(resized(&args) >= 16);
			continue;
		}
		n_cut += hi.z > -0.5;
		n_between += n > 16 && n < 512;
		if (fabs(side - rint(side)) > 0.01 * fmax(1, side / 512)) {
			assert_int_equal(n, (u32)fmin(fmax(floor(side) + 1, 16), 512));
		}
	}
	assert_true(n_cut > N / 100 && n_off > N / 4 && n_between > N / 10);
}

/* A change below the cube.hysteresis keeps the size; one as large takes the new one. */
static void small_changes_keep_the_size(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		make_object(ts_v3_make(0, 0, -8), uniform(0.2f, 3));
		ts_cube_size_args args = plain();
		u32 wanted = resized(&args), before = 16 + below(400);
		cube.n = before;
		u32 change = wanted > before ? wanted - before : before - wanted;
		assert_int_equal(resized(&args), change < 32 ? before : wanted);
	}
	make_object(ts_v3_make(0, 0, -8), 1);
	ts_cube_size_args args = plain();
	u32 wanted = resized(&args);
	for (u32 change = 30; change < 34; change++) {
		cube.n = wanted + change;
		assert_int_equal(resized(&args), change < 32 ? wanted + change : wanted);
	}
	args.hysteresis = 0;
	cube.n = wanted + 1;
	assert_int_equal(resized(&args), wanted);
}

/* A fixed size is everyone's on the screen; off it only where all are wanted. */
static void a_fixed_size_is_everyones(void **state)
{
	(void)state;
	ts_cube_size_args args = plain();
	args.fixed = 77;
	make_object(ts_v3_make(0, 0, -8), 1);
	assert_int_equal(resized(&args), 77);
	make_object(ts_v3_make(0, 0, 8), 1);
	assert_int_equal(resized(&args), 0);
	args.all = 1;
	assert_int_equal(resized(&args), 77);
	args.fixed = 0;
	assert_int_equal(resized(&args), 16);
	make_object(ts_v3_make(0, 0, -2), 1.4f);
	args = plain();
	args.n_max = 64;
	assert_int_equal(resized(&args), 64);
}

static void the_reflector_moves_before_it_is_measured(void **state)
{
	(void)state;
	make_object(ts_v3_make(0, 0, 0), 1);
	objects[1].period = 4;
	objects[1].axis[0] = 3;
	ts_cube_size_args args = plain();
	for (u32 frame = 0; frame < 8; frame++) {
		args.frame = frame;
		resized(&args);
		double3 lo, hi, moved = {frame % 4 == 0 ? 3 : frame % 4 == 2 ? -3 : 0, 0, 0};
		box(&lo, &hi);
		assert_true(d3_distance(d3_of(ts_load3(cube.box_min)), d3_add(lo, moved)) <= 1e-6);
		assert_true(d3_distance(d3_of(ts_load3(cube.box_max)), d3_add(hi, moved)) <= 1e-6);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(box_and_ball_hold_the_reflector_alone),
		seeded_test(sides_are_those_of_the_projected_box),
		seeded_test(small_changes_keep_the_size),
		seeded_test(a_fixed_size_is_everyones),
		seeded_test(the_reflector_moves_before_it_is_measured),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

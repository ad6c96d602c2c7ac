/* Reflective pixels: the surface that a ray in double precision finds, gradients between the records of neighbours, one
 * side at borders, and no look at other objects. */
#include "kernels/points/mirror_pixel.h"
#include "kernels/raster/eye.h"
#include "tests/kernels/small.h"

enum { WIDTH = 48, HEIGHT = 32, N_PIXELS = WIDTH * HEIGHT, N_SCENES = 24 };

static const ts_view eye = {
	.eye = {1, 2, 3},
	.focal = 40,
	.right = {1, 0, 0},
	.width = WIDTH,
	.up = {0, 1, 0},
	.height = HEIGHT,
	.back = {0, 0, 1},
	.near = 0.25f,
};

static small_scene scene;
static u64 keys[N_PIXELS];
static u32 offset[N_PIXELS + 1];
static ts_pixel records[N_PIXELS];
static const ts_pixel *at[N_PIXELS]; /* the record of each pixel, or null */

static ts_mirror_pixel_args arguments(void)
{
	return (ts_mirror_pixel_args){
		.scene = small_arrays(&scene), .view = &eye, .depth_triangle = keys, .offset = offset, .pixels = records};
}

/* Counts, prefix sums, records: as the stage does. */
static u32 find_records(void)
{
	ts_mirror_pixel_args args = arguments();
	u32 n = 0;
	for (u32 i = 0; i < N_PIXELS; i++) ts_k_mirror_pixel_count_item(&args, i);
	for (u32 i = 0; i < N_PIXELS; i++) {
		u32 count = offset[i];
		assert_true(count <= 1);
		at[i] = count == 1 ? &records[n] : NULL;
		offset[i] = n;
		n += count;
	}
	offset[N_PIXELS] = n;
	memset(records, 0xee, sizeof records);
	for (u32 i = 0; i < N_PIXELS; i++) ts_k_mirror_pixel_item(&args, i);
	return n;
}

static u32 draw(void)
{
	ts_eye_args args = {.scene = small_arrays(&scene), .view = &eye, .texels = keys};
	for (u32 i = 0; i < N_PIXELS; i++) keys[i] = TS_EMPTY;
	for (u32 t = 0; t < scene.n_triangles; t++) ts_k_eye_item(&args, t);
	return find_records();
}

static ts_v3 in_sight(f32 z) { return ts_v3_make(1 + uniform(-0.8f, 0.8f) * z, 2 + uniform(-0.6f, 0.6f) * z, 3 - z); }

/* Two reflectors and something dull, in pieces all over the picture, all double-sided. */
static void make_scene(void)
{
	small_mirrors(&scene);
	for (u32 k = 0; k < 12; k++) {
		ts_v3 a = in_sight(uniform(2, 6)), b = in_sight(uniform(2, 6)), c = in_sight(uniform(2, 6));
		small_add(&scene, a, b, c, k % 3, k % 3);
	}
	for (u32 k = 0; k < 36; k++) ts_store3(scene.vertices[k].normal, direction());
}

static double3 ray(u32 i)
{
	return (double3){(i % WIDTH + 0.5 - WIDTH / 2) / 40, (HEIGHT / 2 - (i / WIDTH + 0.5)) / 40, -1};
}

static double3 corner(u32 t, u32 k) { return d3_of(ts_load3(scene.vertices[3 * t + k].position)); }

/* Where the ray of a pixel meets the plane of its triangle, and how steeply. */
static double3 meet(u32 i, double *cosine)
{
	u32 t = (u32)keys[i];
	double3 a = corner(t, 0), n = d3_unit(d3_cross(d3_sub(corner(t, 1), a), d3_sub(corner(t, 2), a)));
	double3 o = d3_of(ts_load3(eye.eye)), d = ray(i);
	*cosine = fabs(d3_dot(n, d3_unit(d)));
	return d3_mad(o, d, d3_dot(n, d3_sub(a, o)) / d3_dot(n, d));
}

/* One record a pixel that shows a reflector, in order, with the surface there turned to the viewer. */
static void each_reflective_pixel_has_a_record(void **state)
{
	(void)state;
	for (u32 n = 0; n < N_SCENES; n++) {
		make_scene();
		u32 n_records = draw(), n_found = 0;
		for (u32 i = 0; i < N_PIXELS; i++) {
			u32 object = keys[i] == TS_EMPTY ? 0 : (u32)keys[i] % 3;
			assert_true((at[i] != NULL) == (object != 0));
			if (at[i] == NULL) continue;
			const ts_pixel *p = &records[n_found++];
			assert_true(p == at[i] && p->index == i && p->reflector == object - 1 && p->pad == 0);
			const f32 *base = scene.materials[object].base;
			assert_near(p->tint_r, base[0], 1e-6);
			assert_near(p->tint_g, base[1], 1e-6);
			assert_near(p->tint_b, base[2], 1e-6);
			double cosine;
			double3 q = meet(i, &cosine);
			if (cosine < 0.1) continue;
			assert_true(d3_distance(d3_of(ts_load3(p->position)), q) <= 0.005);
			assert_near(d3_length(d3_of(ts_load3(p->normal))), 1, 1e-6);
		}
		assert_int_equal(n_found, n_records);
		assert_true(n_records > 100);
	}
}

/* The record beside a record, if both show the same reflector. */
static const ts_pixel *beside(const ts_pixel *p, i32 dx, i32 dy)
{
	i32 x = (i32)(p->index % WIDTH) + dx, y = (i32)(p->index / WIDTH) + dy;
	if (x < 0 || y < 0 || x >= WIDTH || y >= HEIGHT) return NULL;
	const ts_pixel *q = at[y * WIDTH + x];
	return q != NULL && q->reflector == p->reflector ? q : NULL;
}

static void judge_gradient(const f32 *gradient, const f32 *before, const f32 *here, const f32 *after)
{
	for (u32 c = 0; c < 3; c++) {
		f32 forward = after ? after[c] - here[c] : 0, backward = before ? here[c] - before[c] : 0;
		f32 d = before && after ? (after[c] - before[c]) * 0.5f : after ? forward : backward;
		assert_true(same_bits(gradient[c], ts_put(d)));
	}
}

/* Central differences of the records beside it; one-sided at the object's border; else 0. */
static void gradients_are_differences_of_neighbours(void **state)
{
	(void)state;
	u32 n_of[3] = {0};
	for (u32 n = 0; n < N_SCENES; n++) {
		make_scene();
		u32 n_records = draw();
		for (u32 k = 0; k < n_records; k++) {
			const ts_pixel *p = &records[k], *left = beside(p, -1, 0), *right = beside(p, 1, 0);
			const ts_pixel *up = beside(p, 0, -1), *down = beside(p, 0, 1);
			n_of[(left != NULL) + (right != NULL)]++;
			judge_gradient(p->position_dx, left ? left->position : NULL, p->position, right ? right->position : NULL);
			judge_gradient(p->position_dy, up ? up->position : NULL, p->position, down ? down->position : NULL);
			judge_gradient(p->normal_dx, left ? left->normal : NULL, p->normal, right ? right->normal : NULL);
			judge_gradient(p->normal_dy, up ? up->normal : NULL, p->normal, down ? down->normal : NULL);
		}
	}
	assert_true(n_of[0] > 0 && n_of[1] > 100 && n_of[2] > 1000);
}

/* A wall across the view at depth 4: a pixel is a tenth wide, its normal faces the eye, from either side, and nothing
 * bends; the picture's border has one-sided differences of the same size. */
static void a_wall_ahead_does_not_bend(void **state)
{
	(void)state;
	for (u32 turned = 0; turned < 2; turned++) {
		small_clear(&scene);
		scene.materials[0].flags = TS_DOUBLE_SIDED;
		scene.objects[1].reflector = 0;
		ts_v3 a = {-49, -48, -1}, b = {151, -48, -1}, c = {-49, 152, -1};
		small_add(&scene, a, turned ? c : b, turned ? b : c, 0, 1);
		assert_int_equal(draw(), N_PIXELS);
		for (u32 i = 0; i < N_PIXELS; i++) {
			const ts_pixel *p = &records[i];
			assert_true(p->normal[0] == 0 && p->normal[1] == 0 && p->normal[2] == 1);
			assert_near(p->position[0], 1 + 4 * ray(i).x, 1e-3);
			assert_near(p->position[1], 2 + 4 * ray(i).y, 1e-3);
			assert_near(p->position_dx[0], 0.1, 1e-3);
			assert_near(p->position_dy[1], -0.1, 1e-3);
			assert_near(p->position_dx[1], 0, 1e-3);
			assert_near(p->position_dy[0], 0, 1e-3);
			for (u32 k = 0; k < 3; k++) assert_true(p->normal_dx[k] == 0 && p->normal_dy[k] == 0);
		}
	}
}

static void a_pixel_alone_has_no_gradients(void **state)
{
	(void)state;
	small_clear(&scene);
	scene.objects[1].reflector = 0;
	ts_v3 middle = {1 + 0.0125f, 2 + 0.0125f, 2};
	small_add(&scene, ts_add(middle, ts_v3_make(-0.01f, -0.01f, 0)), ts_add(middle, ts_v3_make(0.01f, -0.01f, 0)),
	          ts_add(middle, ts_v3_make(0, 0.01f, 0)), 0, 1);
	assert_int_equal(draw(), 1);
	const f32 *all[4] = {records[0].position_dx, records[0].position_dy, records[0].normal_dx, records[0].normal_dy};
	for (u32 k = 0; k < 12; k++) assert_int_equal(ts_f2u(all[k / 3][k % 3]), 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(each_reflective_pixel_has_a_record),
		seeded_test(gradients_are_differences_of_neighbours),
		seeded_test(a_wall_ahead_does_not_bend),
		seeded_test(a_pixel_alone_has_no_gradients),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

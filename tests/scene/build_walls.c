/* The hall of a scene: rooms of known size with all that could mislead the rays. */
#include "kernels/base/scene.h"
#include "scene/build.h"
#include "tests/model/test.h"

static ts_params params;
static u32 masked, two_sided;

static ts_build *start(void)
{
	ts_params_default(&params);
	ts_build *build = ts_build_new("rooms");
	assert_non_null(build);
	ts_material material = ts_material_default();
	material.flags = TS_MASKED;
	masked = ts_build_material(build, &material);
	material.flags = TS_DOUBLE_SIDED;
	two_sided = ts_build_material(build, &material);
	return build;
}

static void corner(ts_build *build, f32 x, f32 y, f32 z)
{
	ts_vertex v = {.position = {x, y, z}};
	ts_build_vertex(build, &v);
}

/* An upright wall, seen from where (x0, z0) to (x1, z1) runs to the right. */
static void wall(ts_build *build, f32 x0, f32 z0, f32 x1, f32 z1, f32 low, f32 high, u32 material)
{
	u32 a = ts_build_peek(build)->n_vertices;
	corner(build, x0, low, z0);
	corner(build, x1, low, z1);
	corner(build, x1, high, z1);
	corner(build, x0, high, z0);
	ts_build_triangle(build, a, a + 1, a + 2, material);
	ts_build_triangle(build, a, a + 2, a + 3, material);
}

/* Four walls that face inwards, or outwards. */
static void walls(ts_build *build, const f32 low[2], const f32 high[2], f32 bottom, f32 top, bool outwards,
                  u32 material)
{
	f32 x0 = outwards ? high[0] : low[0], x1 = outwards ? low[0] : high[0];
	wall(build, x0, low[1], x1, low[1], bottom, top, material);
	wall(build, x1, high[1], x0, high[1], bottom, top, material);
	f32 z0 = outwards ? high[1] : low[1], z1 = outwards ? low[1] : high[1];
	wall(build, low[0], z1, low[0], z0, bottom, top, material);
	wall(build, high[0], z0, high[0], z1, bottom, top, material);
}

static const f32 house_low[2] = {-20.0f, -10.0f}, house_high[2] = {20.0f, 10.0f};

static ts_build *house(void)
{
	ts_build *build = start();
	walls(build, house_low, house_high, 0.0f, 8.0f, false, TS_NONE);
	return build;
}

static void expect(ts_build *build, double x0, double z0, double x1, double z1)
{
	ts_scene *scene;
	assert_int_equal(ts_build_finish(build, &params, NULL, &scene), TS_OK);
	const double wanted[4] = {x0, z0, x1, z1};
	const ts_info *info = &scene->info;
	const f32 found[4] = {info->hall_min[0], info->hall_min[1], info->hall_max[0], info->hall_max[1]};
	for (u32 i = 0; i < 4; i++)
		if (fabs((double)found[i] - wanted[i]) > 1e-4)
			fail_msg("side %u at %g, not %g", i, (double)found[i], wanted[i]);
	ts_scene_free(scene);
}

static void the_hall_is_the_house(void **state)
{
	(void)state;
	expect(house(), -19.0, -9.5, 19.0, 9.5);
}

/* A room in the house, beside its middle: the hall is that room. */
static void a_room_off_the_middle_is_found(void **state)
{
	(void)state;
	const f32 low[2] = {-6.0f, -1.0f}, high[2] = {2.0f, 7.0f};
	ts_build *build = house();
	walls(build, low, high, 0.0f, 8.0f, false, TS_NONE);
	expect(build, -2.0 - 3.8, 3.0 - 3.8, -2.0 + 3.8, 3.0 + 3.8);
}

/* Backs of walls are not walls, unless the material has two sides. */
static void only_two_sided_backs_are_walls(void **state)
{
	(void)state;
	const f32 low[2] = {-4.0f, -4.0f}, high[2] = {4.0f, 4.0f};
	ts_build *build = house();
	walls(build, low, high, 0.0f, 8.0f, true, TS_NONE);
	expect(build, -19.0, -9.5, 19.0, 9.5);
	build = house();
	walls(build, low, high, 0.0f, 8.0f, true, two_sided);
	expect(build, -3.8, -3.8, 3.8, 3.8);
}

/* Furniture, what hangs from the ceiling, leaves, a post and what stands in the very middle. */
static void furniture_and_leaves_are_no_walls(void **state)
{
	(void)state;
	const f32 low[2] = {-4.0f, -4.0f}, high[2] = {4.0f, 4.0f};
	ts_build *build = house();
	walls(build, low, high, 0.0f, 4.0f, false, TS_NONE);
	expect(build, -19.0, -9.5, 19.0, 9.5);
	build = house();
	walls(build, low, high, 4.0f, 8.0f, false, TS_NONE);
	expect(build, -19.0, -9.5, 19.0, 9.5);
	build = house();
	walls(build, low, high, 0.0f, 8.0f, false, masked);
	expect(build, -19.0, -9.5, 19.0, 9.5);
	build = house();
	const f32 post_low[2] = {5.0f, -0.15f}, post_high[2] = {5.3f, 0.15f};
	walls(build, post_low, post_high, 0.0f, 8.0f, true, TS_NONE);
	expect(build, -19.0, -9.5, 19.0, 9.5);
	build = house();
	const f32 pillar_low[2] = {-0.5f, -0.5f}, pillar_high[2] = {0.5f, 0.5f};
	walls(build, pillar_low, pillar_high, 0.0f, 8.0f, true, two_sided);
	expect(build, -19.0, -9.5, 19.0, 9.5);
}

/* Without a fourth wall it is no hall. */
static void three_walls_are_no_hall(void **state)
{
	(void)state;
	ts_build *build = start();
	wall(build, -20.0f, -10.0f, 20.0f, -10.0f, 0.0f, 8.0f, TS_NONE);
	wall(build, -20.0f, 10.0f, -20.0f, -10.0f, 0.0f, 8.0f, TS_NONE);
	wall(build, 20.0f, -10.0f, 20.0f, 10.0f, 0.0f, 8.0f, TS_NONE);
	expect(build, -20.0, -10.0, 20.0, 10.0);
	build = start();
	walls(build, house_low, house_high, 0.0f, 8.0f, true, TS_NONE);
	expect(build, -20.0, -10.0, 20.0, 10.0);
}

/* The added reflectors belong to other objects. */
static void reflectors_are_no_walls(void **state)
{
	(void)state;
	const f32 low[2] = {-4.0f, -4.0f}, high[2] = {4.0f, 4.0f};
	ts_build *build = house();
	ts_object turning = {.period = 240};
	ts_build_object(build, &turning, true);
	walls(build, low, high, 0.0f, 8.0f, false, two_sided);
	expect(build, -19.0, -9.5, 19.0, 9.5);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(the_hall_is_the_house),          cmocka_unit_test(a_room_off_the_middle_is_found),
		cmocka_unit_test(only_two_sided_backs_are_walls), cmocka_unit_test(furniture_and_leaves_are_no_walls),
		cmocka_unit_test(three_walls_are_no_hall),        cmocka_unit_test(reflectors_are_no_walls),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

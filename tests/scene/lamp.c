/* Area lights: where their samples lie and what the views from them see, against double arithmetic. */
#include "kernels/base/shade.h"
#include "scene/lamp.h"
#include "scene/view.h"
#include "tests/kernels/seeded.h"

enum { N = 400 };

static ts_params params;
static ts_lens lens;
static ts_info infos[3];

/* A room, a room longer than high, and a thing seen from outside. */
static int set_up(void **state)
{
	ts_params_default(&params);
	lens = (ts_lens){.side = 256, .fov = params.lamp_fov};
	infos[0] = (ts_info){.box_min = {-3, -1, 10}, .box_max = {5, 5, 40}, .hall_min = {-2, 12}, .hall_max = {4, 36}};
	infos[1] = (ts_info){.box_min = {-50, 0, -9}, .box_max = {50, 8, 9}, .hall_min = {-40, -8}, .hall_max = {40, 8}};
	infos[2] = (ts_info){.box_min = {-1, -2, -3}, .box_max = {2, 1, 4}, .hall_min = {-1, -3}, .hall_max = {2, 4}};
	return restart(state);
}

#define lamp_test(f) cmocka_unit_test_setup(f, set_up)

static ts_light random_light(u32 kind)
{
	ts_light light = {.kind = kind};
	ts_store3(light.position, uniform3(-9, 9));
	ts_store3(light.direction, direction());
	f32 outer = uniform(0.3f, 0.99f), inner = outer + (1 - outer) * uniform(0.2f, 0.9f);
	light.spot_scale = 1 / (inner - outer);
	light.spot_offset = -outer * light.spot_scale;
	return light;
}

static double3 load(const f32 *p) { return d3_of(ts_load3(p)); }

static void check_axes(const ts_offscreen *view)
{
	const double3 axes[3] = {load(view->right), load(view->up), load(view->back)};
	for (u32 i = 0; i < 3; i++) {
		for (u32 j = 0; j < 3; j++) assert_near(d3_dot(axes[i], axes[j]), i == j, 1e-6);
	}
	assert_true(d3_dot(d3_cross(axes[0], axes[1]), axes[2]) > 0.99);
	assert_true(view->width == lens.side && view->height == lens.side && view->object == TS_NONE);
	assert_true(view->near > 0 && view->reach[0] == view->reach[1]);
	assert_near(view->focal * view->reach[0] * 2, view->width, 1e-4 * view->width);
}

/* Pixels and depth. */
static double3 project(const ts_offscreen *view, double3 p)
{
	double3 d = d3_sub(p, load(view->eye));
	double z = -d3_dot(load(view->back), d), unit = view->orthographic != 0 ? 1 : z;
	return (double3){view->width * 0.5 + view->focal * d3_dot(load(view->right), d) / unit,
	                 view->height * 0.5 - view->focal * d3_dot(load(view->up), d) / unit, z};
}

/* Of spot and point lights on the disc across the axis: the k-th of n within sqrt((k + 1) / n) of the radius, no two
 * alike; one alone in the middle. All look the same way. */
static void samples_of_a_disc_lie_within_it(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_light light = random_light(i & 1 ? TS_LIGHT_KIND_POINT : TS_LIGHT_KIND_SPOT);
		f32 radius = uniform(0, 2);
		u32 n = 1 + below(40);
		double3 mean = {0, 0, 0}, position = load(light.position);
		ts_offscreen first, before;
		for (u32 k = 0; k < n; k++) {
			ts_offscreen view;
			ts_lamp_view(&view, &light, radius, k, n, &infos[i % 3], &lens);
			check_axes(&view);
			assert_true(view.orthographic == 0);
			double3 at = d3_sub(load(view.eye), position);
			assert_near(d3_dot(at, load(view.back)), 0, 1e-5);
			assert_true(d3_length(at) <= radius * sqrt((k + 1.0) / n) + 1e-5);
			if (n == 1) assert_true(d3_length(at) == 0);
			if (k > 0) assert_memory_equal(view.back, first.back, sizeof view.back);
			if (k > 0 && radius > 0.1f)
				assert_true(d3_distance(load(view.eye), load(before.eye)) > 0.05 * (double)radius);
			if (k == 0) first = view;
			before = view;
			mean = d3_mad(mean, at, 1.0 / n);
		}
		if (n > 20) assert_true(d3_length(mean) <= 0.1 * (double)radius + 1e-5);
	}
}

/* A spot light looks along its direction, as wide as its cone; a point light, which has none, into the hall. */
static void a_spot_looks_along_its_direction(void **state)
{
	(void)state;
	lens.own = true;
	for (u32 i = 0; i < N; i++) {
		ts_light light = random_light(TS_LIGHT_KIND_SPOT);
		ts_offscreen view;
		ts_lamp_view(&view, &light, 0, 0, 1, &infos[i % 3], &lens);
		assert_near(d3_dot(load(view.back), load(light.direction)), -1, 1e-6);
		double cosine = -(double)light.spot_offset / light.spot_scale, tangent = sqrt(1 - cosine * cosine) / cosine;
		assert_near(view.reach[0], fmin(tangent, 3.7320508), 2e-4 * tangent);
		light.kind = TS_LIGHT_KIND_POINT;
		ts_lamp_view(&view, &light, 0, 0, 1, &infos[i % 3], &lens);
		assert_near(view.reach[0], tan(22.5 * 0.017453292519943295), 1e-6);
		ts_space hall = ts_view_hall(&infos[i % 3]);
		double3 way =
			d3_mad(load(light.position), load(view.back), -d3_distance(load(light.position), d3_of(hall.middle)));
		double3 off = d3_sub(way, d3_of(hall.middle));
		assert_true(d3_length(off) <= 2 * d3_length(d3_of(hall.half)));
	}
}

/* A sun's views see all of the scene's box, from outside of it, from directions within the tangent of its radius. */
static void a_sun_sees_all_of_the_box(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		ts_light sun = random_light(TS_LIGHT_KIND_DIRECTIONAL);
		const ts_info *info = &infos[i % 3];
		if (i % 7 == 0) ts_store3(sun.direction, ts_v3_make(0, i % 2 != 0 ? -1 : 1, 0));
		params.lamp_radius = uniform(0, 1);
		f32 radius = ts_lamp_radius(&sun, info, &params);
		assert_true(radius == params.lamp_radius);
		u32 n = 1 + below(9);
		for (u32 k = 0; k < n; k++) {
			ts_offscreen view;
			ts_lamp_view(&view, &sun, radius, k, n, info, &lens);
			check_axes(&view);
			assert_true(view.orthographic == 1);
			double cosine = -d3_dot(load(view.back), load(sun.direction));
			assert_true(sqrt(fmax(1 - cosine * cosine, 0)) <= cosine * (radius + 1e-3));
			if (n == 1) assert_near(cosine, 1, 1e-6);
			for (u32 c = 0; c < 8; c++) {
				double3 at = project(&view, (double3){c & 1 ? info->box_min[0] : info->box_max[0],
				                                      c & 2 ? info->box_min[1] : info->box_max[1],
				                                      c & 4 ? info->box_min[2] : info->box_max[2]});
				assert_true(at.x > 1 && at.y > 1 && at.x < view.width - 1 && at.y < view.height - 1 &&
				            at.z > view.near);
			}
		}
	}
}

/* The lamp: in the box, above its target. Where its light falls at the target's distance all samples' maps reach, up to
 * a radius of 1/36 of the hall's half diagonal; its irradiance there is what was asked for. */
static void maps_reach_where_the_spot_shines(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		const ts_info *info = &infos[i % 3];
		params.lamp_fov = lens.fov = uniform(40, 60);
		params.lamp_radius = uniform(0, 1.0f / 36);
		ts_light lamp;
		ts_lamp_spot(&lamp, info, NULL, &params);
		double cosine = -(double)lamp.spot_offset / lamp.spot_scale, tangent = sqrt(1 - cosine * cosine) / cosine;
		double distance = sqrt(lamp.intensity[0] / (double)params.light_irradiance);
		double radius = ts_lamp_radius(&lamp, info, &params);
		assert_near(radius, params.lamp_radius * d3_length(d3_of(ts_view_hall(info).half)), 1e-5 * (1 + radius));
		double3 target = d3_mad(load(lamp.position), load(lamp.direction), distance);
		assert_true(lamp.direction[1] < 0 && target.y >= info->box_min[1] && target.y <= info->box_max[1]);
		for (u32 k = 0; k < 24; k++) {
			ts_offscreen view;
			ts_lamp_view(&view, &lamp, (f32)radius, k, 24, info, &lens);
			for (u32 turn = 0; turn < 32; turn++) {
				double a = turn * 0.19634954084936207, r = distance * tangent;
				double3 p = d3_mad(d3_mad(target, load(view.right), r * cos(a)), load(view.up), r * sin(a));
				double3 at = project(&view, p);
				assert_true(at.x >= 0 && at.y >= 0 && at.x <= view.width && at.y <= view.height);
			}
		}
	}
}

static ts_info random_thing(void)
{
	ts_info info = {.circles = 3};
	ts_v3 low = uniform3(-9, 9);
	ts_store3(info.box_min, low);
	for (u32 axis = 0; axis < 3; axis++) {
		f32 extent = below(8) == 0 ? 0.0f : axis == below(3) ? uniform(1, 40) : uniform(0.5f, 2);
		info.box_max[axis] = info.box_min[axis] + extent;
	}
	for (u32 axis = 0; axis < 2; axis++) {
		info.hall_min[axis] = info.box_min[2 * axis];
		info.hall_max[axis] = info.box_max[2 * axis];
	}
	return info;
}

static double3 corner_of(const ts_info *info, u32 c)
{
	const f32 *low = info->box_min, *high = info->box_max;
	return (double3){c & 1 ? low[0] : high[0], c & 2 ? low[1] : high[1], c & 4 ? low[2] : high[2]};
}

/* A spot light's share of its full light that way, before it is squared. */
static double ramp(const ts_light *light, double3 p)
{
	double3 way = d3_sub(p, load(light->position));
	double cosine = d3_dot(way, load(light->direction)) / d3_length(way);
	return cosine * light->spot_scale + light->spot_offset;
}

/* Of a thing without walls all is in the full light, and in the maps of all samples; where it throws shadows the maps
 * reach, too, as these are on the same rays. No farther than that: some thing fills the cone. */
static void things_are_in_full_light(void **state)
{
	(void)state;
	double least = INFINITY;
	assert_true(params.lamp_fov == TS_LAMP_FOV);
	for (u32 i = 0; i < 4 * N; i++) {
		ts_info info = random_thing();
		ts_light lamp;
		params.lamp_radius = uniform(0, 0.34f);
		ts_lamp_spot(&lamp, &info, NULL, &params);
		f32 radius = ts_lamp_radius(&lamp, &info, &params);
		for (u32 c = 0; c < 8; c++) {
			double3 p = corner_of(&info, c);
			double full = ramp(&lamp, p);
			least = fmin(least, full);
			if (full < 1 - 1e-4) fail_msg("thing %u: corner %u gets %g of the light", i, c, full);
			for (u32 k = 0; k < 16; k++) {
				ts_offscreen view;
				ts_lamp_view(&view, &lamp, radius, k, 16, &info, &lens);
				double3 at = project(&view, p);
				assert_true(at.z > view.near && at.x > 0 && at.y > 0 && at.x < view.width && at.y < view.height);
			}
		}
		double3 middle = d3_of(ts_view_box(&info).middle);
		double distance = d3_distance(middle, load(lamp.position));
		assert_near(ramp(&lamp, middle), (1 + lamp.spot_offset / (double)lamp.spot_scale) * lamp.spot_scale, 1e-3);
		assert_near(lamp.intensity[0] / (distance * distance), (double)params.light_irradiance, 1e-4);
	}
	assert_true(least < 1.1);
}

/* The ball's samples: on the sphere, and evenly; one alone in its middle; near is a part of the scene's size. */
static void samples_of_balls_lie_on_their_sphere(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		const ts_info *info = &infos[i % 3];
		ts_light ball;
		ts_lamp_ball(&ball, info, NULL, &params);
		u32 n = 1 + below(40);
		double radius = ts_lamp_radius(&ball, info, &params);
		double3 mean = {0, 0, 0};
		for (u32 k = 0; k < n; k++) {
			ts_face cube;
			ts_lamp_cube(&cube, &ball, (f32)radius, k, n, info, lens.side);
			double3 at = d3_sub(load(cube.centre), load(ball.position));
			assert_near(d3_length(at), n > 1 ? radius : 0, 1e-5 * (1 + d3_length(load(ball.position))));
			assert_true(cube.n == lens.side && cube.object == TS_NONE && cube.near * 1024 == cube.radius);
			mean = d3_mad(mean, at, 1.0 / n);
		}
		if (n > 20) assert_true(d3_length(mean) <= 0.1 * radius);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		lamp_test(samples_of_a_disc_lie_within_it), lamp_test(a_spot_looks_along_its_direction),
		lamp_test(a_sun_sees_all_of_the_box),       lamp_test(maps_reach_where_the_spot_shines),
		lamp_test(things_are_in_full_light),        lamp_test(samples_of_balls_lie_on_their_sphere),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

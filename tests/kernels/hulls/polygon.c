/* Lamps as triangles of light: their areas, the ways they face, and what they send far off and near, against form
 * factors in double precision and the closed form of a disc; and lights without extent. */
#include <string.h>
#include "kernels/hulls/corner.h"
#include "kernels/hulls/corner_lobes.h"
#include "kernels/hulls/direct.h"
#include "kernels/hulls/polygon.h"
#include "tests/kernels/hulls/form_factor_truth.h"

enum { N = 200, SIDES = TS_LAMP_TRIANGLES };

/* One lamp and what it is made to. */
typedef struct {
	ts_light light;
	ts_lamp shape;
	ts_v3 middle;
	f32 away;
	ts_patch patches[SIDES];
} lamp;

static lamp lamp_of(u32 kind, f32 radius)
{
	lamp l = {.light = {.kind = kind, .spot_scale = 4, .spot_offset = -3}, .shape = {.radius = radius}};
	l.middle = uniform3(-2, 2);
	l.away = 4096;
	ts_store3(l.light.position, uniform3(-3, 3));
	ts_store3(l.light.direction, direction());
	ts_store3(l.light.intensity, ts_v3_make(1, 2, 4));
	memset(l.patches, 0x7f, sizeof l.patches);
	ts_polygon_args args = {
		.lamps = &l.light, .shapes = &l.shape, .patches = l.patches, .middle = l.middle, .away = l.away};
	for (u32 k = 0; k < SIDES; k++) ts_k_polygon_item(&args, k);
	return l;
}

/* World units; where it stands. */
static double reach_of(const lamp *l)
{
	double r = (double)l->shape.radius;
	return l->light.kind == TS_LIGHT_KIND_DIRECTIONAL ? r * (double)l->away : r;
}
static double3 place_of(const lamp *l)
{
	if (l->light.kind != TS_LIGHT_KIND_DIRECTIONAL) return d3_of(ts_load3(l->light.position));
	return d3_mad(d3_of(l->middle), d3_of(ts_load3(l->light.direction)), -(double)l->away);
}

static double3 corner_of(const ts_patch *patch, u32 k)
{
	return d3_of(ts_load3(k == 0 ? patch->a : k == 1 ? patch->b : patch->c));
}

/* Twice its area, along the side from which its corners turn left. */
static double3 turned(const ts_patch *patch)
{
	double3 a = corner_of(patch, 0);
	return d3_cross(d3_sub(corner_of(patch, 1), a), d3_sub(corner_of(patch, 2), a));
}

/* In double precision, of the first channel. */
static double irradiance(const lamp *l, double3 p, double3 n)
{
	double sum = 0;
	for (u32 k = 0; k < SIDES; k++) {
		const ts_patch *patch = &l->patches[k];
		double3 corner[3];
		for (u32 i = 0; i < 3; i++) corner[i] = d3_sub(corner_of(patch, i), p);
		if (d3_dot(turned(patch), corner[0]) < 0) sum += patch->exitance[0] * ff_factor(n, corner);
	}
	return sum;
}

/* All triangles have the normal of their corners; together they have the area. */
static void check_surface(const lamp *l, double right)
{
	double area = 0, r = reach_of(l);
	for (u32 k = 0; k < SIDES; k++) {
		const ts_patch *patch = &l->patches[k];
		double3 n = turned(patch);
		area += d3_length(n) / 2;
		assert_true(d3_distance(d3_unit(n), d3_of(ts_load3(patch->normal))) < 1e-3);
		for (u32 c = 0; c < 3; c++) {
			assert_near(patch->exitance[c], (1 << c) / pow((double)l->shape.radius, 2), 1e-6 * patch->exitance[c]);
			double far = d3_distance(corner_of(patch, c), place_of(l));
			bool centre = far < 0.01 * r;
			assert_true(centre || (far > 1.05 * r && far < 1.35 * r));
		}
	}
	assert_near(area, right, 2e-3 * right);
}

/* A disc's triangles stand around its middle, one after the other, and shine along the light. */
static void triangles_of_a_disc_stand_around_it(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		lamp l = lamp_of(i % 2 == 0 ? TS_LIGHT_KIND_SPOT : TS_LIGHT_KIND_DIRECTIONAL, uniform(0.01f, 0.5f));
		double r = reach_of(&l);
		check_surface(&l, ff_pi * r * r);
		for (u32 k = 0; k < SIDES; k++) {
			assert_memory_equal(l.patches[k].normal, l.light.direction, sizeof l.light.direction);
			assert_memory_equal(l.patches[k].c, l.patches[(k + 1) % SIDES].b, sizeof l.patches[k].c);
			assert_true(d3_distance(corner_of(&l.patches[k], 0), place_of(&l)) < 1e-3 * r);
		}
	}
}

/* Near its axis it is a disc's, M r^2 / (r^2 + d^2); far off, aside, I cos / d^2, but for its extent. */
static void a_disc_shines_as_its_closed_form(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		lamp l = lamp_of(TS_LIGHT_KIND_SPOT, uniform(0.1f, 0.5f));
		double r = reach_of(&l), d = r * (1 + i % 8), m = l.patches[0].exitance[0];
		double3 axis = d3_of(ts_load3(l.light.direction)), at = d3_mad(place_of(&l), axis, d);
		assert_near(irradiance(&l, at, d3_scale(axis, -1)), m * r * r / (r * r + d * d),
		            6e-3 * m * r * r / (r * r + d * d));
		double3 way = d3_unit(d3_add(axis, d3_scale(d3_of(direction()), 0.9)));
		double cosine = d3_dot(way, axis), far = 400 * r;
		double found = irradiance(&l, d3_mad(place_of(&l), way, far), d3_scale(way, -1));
		assert_near(found * far * far, cosine, 2e-3);
		assert_true(irradiance(&l, d3_mad(place_of(&l), axis, -d), axis) == 0);
	}
}

/* A sun gives what it says, across a scene as in its middle. */
static void a_sun_lights_a_scene_alike(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		lamp l = lamp_of(TS_LIGHT_KIND_DIRECTIONAL, uniform(0.005f, 0.3f));
		double t = (double)l.shape.radius, right = 1 / (1 + t * t);
		double3 axis = d3_of(ts_load3(l.light.direction)), n = d3_scale(axis, -1);
		assert_near(irradiance(&l, d3_of(l.middle), n), right, 3e-3);
		assert_near(irradiance(&l, d3_add(d3_of(l.middle), d3_of(direction())), n), right, 6e-3);
	}
}

/* Far off a ball's triangles send I on average, and about that each way; their normals look out. */
static void a_ball_sends_its_intensity_on_average(void **state)
{
	(void)state;
	double sum = 0, least = 2, most = 0;
	for (u32 i = 0; i < 20 * N; i++) {
		lamp l = lamp_of(TS_LIGHT_KIND_POINT, uniform(0.1f, 0.5f));
		double r = reach_of(&l), far = 400 * r;
		if (i < N) check_surface(&l, 4 * ff_pi * r * r);
		for (u32 k = 0; k < SIDES; k++) {
			assert_true(d3_dot(turned(&l.patches[k]), d3_sub(corner_of(&l.patches[k], 0), place_of(&l))) > 0);
		}
		double3 way = d3_of(direction());
		double found = irradiance(&l, d3_mad(place_of(&l), way, far), d3_scale(way, -1)) * far * far;
		sum += found;
		least = fmin(least, found);
		most = fmax(most, found);
	}
	print_message("# a ball's light: mean %.4f, from %.3f to %.3f\n", sum / (20 * N), least, most);
	assert_near(sum / (20 * N), 1, 0.01);
	assert_true(least > 0.81 && most < 1.16);
}

static ts_v3 direct(const lamp *l, ts_v3 p, ts_v3 n)
{
	f32 e[3];
	ts_gpixel pixel;
	ts_k_gpixel_store(&pixel, p, 0.5f, n, ts_v3_make(1, 1, 1));
	ts_direct_args args = {.pixels = &pixel,
	                       .patches = l->patches,
	                       .lamps = &l->light,
	                       .shapes = &l->shape,
	                       .irradiance = e,
	                       .n_patches = SIDES,
	                       .n_lamps = 1};
	ts_k_direct_item(&args, 0);
	return ts_load3(e);
}

static ts_moment gather(const lamp *l, ts_v3 p)
{
	ts_moment m;
	const ts_corner_args args = {
		.patches = l->patches, .lamps = &l->light, .shapes = &l->shape, .n_patches = SIDES, .n_lamps = 1};
	ts_k_gather_all(&m, &args, (ts_box_corner){p, 0.5f});
	return m;
}

/* Pixels gather form factors, corners solid angles of all that faces them, however low above the plane they are. */
static void pixels_gather_factors_and_corners_angles(void **state)
{
	(void)state;
	static const u32 kinds[] = {TS_LIGHT_KIND_SPOT, TS_LIGHT_KIND_POINT};
	u32 n_low = 0;
	for (u32 i = 0; i < 10 * N; i++) {
		lamp l = lamp_of(kinds[i % 2], uniform(0.1f, 0.5f));
		ts_v3 n = direction(), p = ts_add(ts_load3(l.light.position), ts_scale(uniform3(-1, 1), 2));
		double right = 0, low = 1;
		for (u32 k = 0; k < SIDES; k++) {
			double3 to[3];
			for (u32 c = 0; c < 3; c++) to[c] = d3_sub(corner_of(&l.patches[k], c), d3_of(p));
			double height = -d3_dot(d3_unit(turned(&l.patches[k])), to[0]);
			if (height > 0) right += l.patches[k].exitance[0] * ff_solid(to[0], to[1], to[2]);
			low = fmin(low, fabs(height));
		}
		if (low < 0.002) continue;
		n_low += low < 0.02;
		ts_moment m = gather(&l, p);
		ts_v3 e = direct(&l, p, n);
		for (u32 c = 0; c < 3; c++) assert_near(m.sum[c], (1 << c) * right, (1 << c) * 2e-4 * (right + 1));
		double light = irradiance(&l, d3_of(p), d3_of(n));
		assert_near(e.x, light, 1e-4 * (light + 1));
		assert_near(e.z, 4 * light, 4e-4 * (light + 1));
	}
	assert_true(n_low > N / 8);
}

/* Without extent there are no triangles. A light is one direction, its lobe the narrowest, which gives a surface what
 * the light does: I cos / d^2. */
static void without_extent_a_light_is_one_direction(void **state)
{
	(void)state;
	for (u32 i = 0; i < 10 * N; i++) {
		lamp l = lamp_of(i % 2 == 0 ? TS_LIGHT_KIND_POINT : TS_LIGHT_KIND_DIRECTIONAL, 0);
		static const ts_patch nothing;
		for (u32 k = 0; k < SIDES; k++) assert_memory_equal(&l.patches[k], &nothing, sizeof nothing);
		ts_v3 n = direction(), p = uniform3(-3, 3);
		double3 way = d3_sub(d3_of(ts_load3(l.light.position)), d3_of(p));
		double square = d3_dot(way, way);
		if (square < 0.01) continue;
		way = d3_unit(way);
		if (i % 2 == 1) way = d3_scale(d3_of(ts_load3(l.light.direction)), -1);
		double intensity = i % 2 == 1 ? 1 : 1 / square, cosine = d3_dot(way, d3_of(n));
		ts_v3 e = direct(&l, p, n);
		assert_near(e.x, fmax(0, cosine) * intensity, 1e-5 * intensity);
		ts_moment m = gather(&l, p);
		assert_near(m.sum[0], ff_pi * intensity, 1e-5 * intensity);
		assert_true(d3_distance(d3_scale(d3_of(ts_load3(m.direction + 6)), 1 / (4 * ff_pi * intensity)), way) < 1e-5);
		ts_sg g = ts_k_fit(m.sum[0], ts_load3(m.direction), 0);
		assert_true(g.lambda > 9e4f);
		double lit = g.mu * ts_k_sg_cosine(g.lambda, ts_dot(n, g.phi), TS_COSINE_OURS, 0) / ff_pi;
		if (fabs(cosine) > 0.05) assert_near(lit, fmax(0, cosine) * intensity, 1e-3 * intensity);
	}
}

/* A spot light without extent has its cone, one with extent none. */
static void only_spots_without_extent_have_their_cone(void **state)
{
	(void)state;
	for (u32 i = 0; i < N; i++) {
		lamp point = lamp_of(TS_LIGHT_KIND_SPOT, 0), disc = lamp_of(TS_LIGHT_KIND_SPOT, 0.1f);
		for (u32 k = 0; k < 2; k++) {
			const lamp *l = k == 0 ? &point : &disc;
			ts_v3 axis = ts_load3(l->light.direction), aside = ts_normalize(ts_cross(axis, direction()));
			ts_v3 p = ts_add(ts_load3(l->light.position), ts_mad(ts_scale(axis, 4), aside, 6));
			ts_v3 e = direct(l, p, ts_normalize(ts_sub(ts_load3(l->light.position), p)));
			assert_true(k == 0 ? e.x == 0 : e.x > 0.005f);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		seeded_test(triangles_of_a_disc_stand_around_it),
		seeded_test(a_disc_shines_as_its_closed_form),
		seeded_test(a_sun_lights_a_scene_alike),
		seeded_test(a_ball_sends_its_intensity_on_average),
		seeded_test(pixels_gather_factors_and_corners_angles),
		seeded_test(without_extent_a_light_is_one_direction),
		seeded_test(only_spots_without_extent_have_their_cone),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Truth of indirect light: form factors of a square that a sun lights, what stands in the way, also of
 * particles, and a scene in which the two truths tend to each other as reflective shadow maps grow. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include "../../../../src/kernels/hulls/direct.h"
#include "../../../../src/methods/pipeline.h"
#include "../../../truth/world.h"

enum { N_RECEIVERS = 64, N_RAYS = 4096 };

/* A square of side 2 at y = 0, its front up. */
static const ts_v3 square[4] = {{-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}};

static world *world_new(void)
{
	world *w = malloc(sizeof *w);
	assert_non_null(w);
	world_begin(w);
	w->scene.info.box_max[1] = 8;
	world_quad(w, square[0], square[1], square[2], square[3], ONE_SIDED, 0);
	return w;
}

/* In a row, above the square, at random places; their normals look down, and aside. */
static ts_gpixel *make_receivers(world *w)
{
	w->run.params.width = N_RECEIVERS;
	w->run.params.height = 1;
	ts_gpixel *pixels = ts_frame_make2(&w->run.frame, TS_B_gbuffer_pixel, 1, N_RECEIVERS);
	assert_non_null(pixels);
	for (u32 i = 0; i < N_RECEIVERS; i++) {
		f32 x = ts_uniform(ts_random(i, 1, 0)) * 4 - 2, z = ts_uniform(ts_random(i, 2, 0)) * 4 - 2;
		f32 y = 0.5f + ts_uniform(ts_random(i, 3, 0)), tilt = ts_uniform(ts_random(i, 4, 0)) * 2 - 1;
		ts_store3(pixels[i].position, ts_v3_make(x, y, z));
		ts_store3(pixels[i].normal, ts_normalize(ts_v3_make(tilt, -1, 0)));
		pixels[i].depth = 0.5f;
	}
	return pixels;
}

static void shine(world *w, u32 kind)
{
	ts_light *light = ts_frame_make1(&w->run.frame, TS_B_lamp_light, 1);
	assert_non_null(light);
	*light = (ts_light){.kind = kind, .position = {0, 1000, 0}, .direction = {0, -1, 0}, .intensity = {1, 2, 4}};
	for (u32 k = 0; k < 3 && kind == TS_LIGHT_KIND_POINT; k++) light->intensity[k] *= 1e6f;
}

static void patch_of(ts_patch *patch, ts_v3 a, ts_v3 b, ts_v3 c)
{
	*patch = (ts_patch){.normal = {0, 1, 0}, .exitance = {1, 2, 4}};
	ts_store3(patch->a, a);
	ts_store3(patch->b, b);
	ts_store3(patch->c, c);
}

/* The square's two triangles as lights; none: the same without light. */
static void make_patches(world *w, u32 n)
{
	ts_patch *patches = ts_frame_make1(&w->run.frame, TS_B_rsm_patch, n);
	assert_non_null(patches);
	for (u32 i = 0; i < n; i++) patch_of(&patches[i], square[0], square[i + 1], square[i + 2]);
}

static double exact(const ts_gpixel *at)
{
	ts_v3 p = ts_load3(at->position), n = ts_load3(at->normal);
	return (double)ts_k_form_factor(p, n, square[0], square[1], square[2]) +
	       (double)ts_k_form_factor(p, n, square[0], square[2], square[3]);
}

/* Every channel is `light` times its exitance. */
static void is_lit(const f32 *irradiance, double light, double tolerance)
{
	for (u32 k = 0; k < 3; k++) assert_true(fabs((double)irradiance[k] / (1u << k) - light) <= tolerance);
}

typedef ts_status truth_of(ts_truth *truth, ts_run *run);

static const f32 *traced(world *w, truth_of *trace)
{
	ts_truth *truth;
	w->run.params.bounce_rays = N_RAYS;
	assert_int_equal(ts_truth_new(&truth, &w->run), TS_OK);
	assert_int_equal(trace(truth, &w->run), TS_OK);
	ts_truth_free(truth);
	return ts_frame_data(&w->run.frame, TS_B_indirect_irradiance);
}

static void world_done(world *w)
{
	ts_run_end(&w->run);
	free(w);
}

static void check_square(u32 kind)
{
	world *w = world_new();
	world_pose(w);
	ts_gpixel *pixels = make_receivers(w);
	pixels[N_RECEIVERS - 1].depth = TS_SKY;
	shine(w, kind);
	make_patches(w, 2);
	for (u32 pass = 0; pass < 2; pass++) {
		const f32 *found = traced(w, pass == 0 ? ts_truth_lights : ts_truth_bounce);
		for (u32 i = 0; i < N_RECEIVERS; i++) {
			double light = i < N_RECEIVERS - 1 ? exact(&pixels[i]) : 0;
			is_lit(found + (u64)i * 3, light, pass == 0 ? 1e-6 : 4e-3);
		}
	}
	world_done(w);
}

static void test_square(void **state)
{
	(void)state;
	check_square(TS_LIGHT_KIND_DIRECTIONAL);
	check_square(TS_LIGHT_KIND_POINT);
}

/* A cover above all keeps the sun off; one between the square and the receivers is lit in its place. */
static void test_covered(void **state)
{
	(void)state;
	for (u32 k = 0; k < 2; k++) {
		world *w = world_new();
		f32 y = k == 0 ? 4 : 0.25f;
		world_quad(w, ts_v3_make(-9, y, -9), ts_v3_make(-9, y, 9), ts_v3_make(9, y, 9), ts_v3_make(9, y, -9), TWO_SIDED, 0);
		world_pose(w);
		ts_gpixel *pixels = make_receivers(w);
		shine(w, TS_LIGHT_KIND_DIRECTIONAL);
		make_patches(w, 2);
		const f32 *found = traced(w, ts_truth_bounce);
		for (u32 i = 0; i < N_RECEIVERS && k == 0; i++) is_lit(found + (u64)i * 3, 0, 0);
		for (u32 i = 0; i < N_RECEIVERS && k == 1; i++) assert_true((double)found[(u64)i * 3] > exact(&pixels[i]) + 0.1);
		found = traced(w, ts_truth_lights);
		for (u32 i = 0; i < N_RECEIVERS; i++) is_lit(found + (u64)i * 3, k == 0 ? exact(&pixels[i]) : 0, 1e-6);
		world_done(w);
	}
}

/* Means of irradiance over the picture: of the truths, and of `direct`, which asks for no visibility. */
typedef struct { double lights, bounce, vpls, direct; } means;

static double mean(const ts_run *run)
{
	const f32 *e = ts_frame_data(&run->frame, TS_B_indirect_irradiance);
	u64 n = ts_frame_n(&run->frame, TS_B_indirect_irradiance);
	double sum = 0;
	for (u64 i = 0; i < n; i++) sum += (double)e[i];
	return sum / (double)n;
}

static means means_of(const char *spec, u32 rsm_px)
{
	ts_scene *scene;
	ts_run run;
	ts_truth *truth;
	ts_params params;
	means m;
	ts_params_default(&params);
	params.width = 64;
	params.height = 36;
	params.reflectors = 0;
	params.rsm_px = rsm_px;
	params.bounce_rays = 256;
	params.light_near = 1;
	if (ts_scene_open(&scene, spec, &params, NULL) != TS_OK) fail_msg("%s", ts_error_message());
	ts_run_begin(&run, scene, &params, 2);
	assert_int_equal(ts_truth_indirect_begin(&run, "indirect"), TS_OK);
	assert_int_equal(ts_run_stage(&run, ts_stage_find("direct")), TS_OK);
	m.direct = mean(&run);
	assert_int_equal(ts_truth_new(&truth, &run), TS_OK);
	assert_int_equal(ts_truth_lights(truth, &run), TS_OK);
	m.lights = mean(&run);
	assert_int_equal(ts_truth_bounce(truth, &run), TS_OK);
	m.bounce = mean(&run);
	assert_int_equal(ts_truth_vpls(truth, &run), TS_OK);
	m.vpls = mean(&run);
	ts_truth_free(truth);
	ts_run_end(&run);
	ts_scene_free(scene);
	print_message("%u px: direct %.5f, lights %.5f, bounce %.5f, vpls %.5f\n", (unsigned)rsm_px, m.direct, m.lights,
	              m.bounce, m.vpls);
	return m;
}

static void test_scene(void **state)
{
	(void)state;
	means coarse = means_of("dining:triangles=10000:texels=32", 8), fine = means_of("dining:triangles=10000:texels=32", 64);
	assert_true(fine.lights < fine.direct && coarse.lights < coarse.direct);
	assert_true(fabs(fine.lights / fine.bounce - 1) < 0.05);
	assert_true(fabs(fine.vpls / fine.lights - 1) < 0.05);
}

#define COVER 1.75f /* height of a cover above all receivers, among the particles */

/* Light of one particle in red: cos / (4 pi d^2), unless its way leads through the cover, `reach` or more away from it. */
static double from_particle(const ts_gpixel *at, const ts_vpl *light, double reach, bool covered)
{
	double way[3], d2 = 0, cosine = 0;
	for (u32 k = 0; k < 3; k++) {
		way[k] = (double)light->position[k] - (double)at->position[k];
		d2 += way[k] * way[k];
		cosine += way[k] * (double)at->normal[k];
	}
	double above = (double)light->position[1] - (double)COVER;
	if (!(cosine > 0) || (covered && above > 0 && above / way[1] * sqrt(d2) > reach)) return 0;
	return (double)light->flux[0] * cosine / (4 * acos(-1) * d2 * sqrt(d2));
}

/* Receivers below a row of particles, with a cover in between and without. */
static void test_particles(void **state)
{
	(void)state;
	double sum[2] = {0};
	for (u32 covered = 0; covered < 2; covered++) {
		world *w = world_new();
		f32 y = covered ? COVER : 9;
		world_quad(w, ts_v3_make(-9, y, -9), ts_v3_make(-9, y, 9), ts_v3_make(9, y, 9), ts_v3_make(9, y, -9), TWO_SIDED, 0);
		world_pose(w);
		ts_gpixel *pixels = make_receivers(w);
		for (u32 i = 0; i < N_RECEIVERS; i++) pixels[i].normal[1] = -pixels[i].normal[1];
		w->run.params.particles = 100;
		w->run.params.light_near = 0.0009765625f;
		const f32 *found = traced(w, ts_truth_glow);
		const ts_vpl *lights = ts_frame_data(&w->run.frame, TS_B_vpl_light);
		const ts_root *root = ts_frame_data(&w->run.frame, TS_B_root_cube);
		double reach = (double)root->side / 512 * sqrt(3);
		for (u32 i = 0; i < N_RECEIVERS; i++) {
			double light = 0;
			for (u32 k = 0; k < 100; k++) light += from_particle(&pixels[i], &lights[k], reach, covered != 0);
			double is = (double)found[(u64)i * 3];
			if (!(fabs(is - light) <= light * 1e-5)) fail_msg("receiver %u: %g for %g", (unsigned)i, is, light);
			sum[covered] += light;
		}
		world_done(w);
	}
	assert_true(sum[1] < sum[0] * 0.9);
}

int main(void)
{
	const struct CMUnitTest indirect[] = {
		cmocka_unit_test(test_square),
		cmocka_unit_test(test_covered),
		cmocka_unit_test(test_particles),
		cmocka_unit_test(test_scene),
	};
	return cmocka_run_group_tests(indirect, NULL, NULL);
}

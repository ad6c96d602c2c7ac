/* Truths of indirect light: form factors of a square that a sun lights, and what stands in the way. */
#include "kernels/hulls/direct.h"
#include "methods/hulls/tools/tools.h"
#include "tests/methods/raster/tools/receivers.h"

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

static void check_square(u32 kind)
{
	world *w = square_new();
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

static void a_lit_square_lights_by_form_factors(void **state)
{
	(void)state;
	check_square(TS_LIGHT_KIND_DIRECTIONAL);
	check_square(TS_LIGHT_KIND_POINT);
}

/* A cover above all keeps the sun off; one between the square and the receivers is lit in its place. */
static void a_cover_is_lit_in_its_place(void **state)
{
	(void)state;
	for (u32 k = 0; k < 2; k++) {
		world *w = square_new();
		f32 y = k == 0 ? 4 : 0.25f;
		cover_with(w, y);
		world_pose(w);
		ts_gpixel *pixels = make_receivers(w);
		shine(w, TS_LIGHT_KIND_DIRECTIONAL);
		make_patches(w, 2);
		const f32 *found = traced(w, ts_truth_bounce);
		for (u32 i = 0; i < N_RECEIVERS && k == 0; i++) is_lit(found + (u64)i * 3, 0, 0);
		for (u32 i = 0; i < N_RECEIVERS && k == 1; i++) {
			assert_true((double)found[(u64)i * 3] > exact(&pixels[i]) + 0.1);
		}
		found = traced(w, ts_truth_lights);
		for (u32 i = 0; i < N_RECEIVERS; i++) is_lit(found + (u64)i * 3, k == 0 ? exact(&pixels[i]) : 0, 1e-6);
		world_done(w);
	}
}

int main(void)
{
	const struct CMUnitTest lights[] = {cmocka_unit_test(a_lit_square_lights_by_form_factors),
	                                    cmocka_unit_test(a_cover_is_lit_in_its_place)};
	return cmocka_run_group_tests(lights, NULL, NULL);
}

/* Truths of lamps: form factors in double precision, and what of them a cover leaves, against many places of each. */
#include "kernels/hulls/direct.h"
#include "kernels/hulls/polygon.h"
#include "methods/hulls/tools/tools.h"
#include "tests/kernels/seeded.h"
#include "tests/methods/raster/tools/receivers.h"

enum { SIDES = TS_LAMP_TRIANGLES, STEPS = 64 };

/* At y = 0, shining up at the receivers, which look down. */
static void hang(world *w, u32 kind, f32 radius)
{
	ts_light *light = ts_frame_make1(&w->run.frame, TS_B_lamp_light, 1);
	ts_lamp *shape = ts_frame_make1(&w->run.frame, TS_B_lamp_shape, 1);
	ts_patch *patches = ts_frame_make1(&w->run.frame, TS_B_polygon_patch, SIDES);
	assert_true(light != NULL && shape != NULL && patches != NULL);
	*light = (ts_light){.kind = kind, .direction = {0, 1, 0}, .intensity = {1, 2, 4}, .spot_offset = 1};
	*shape = (ts_lamp){.radius = radius};
	ts_polygon_args args = {.lamps = light, .shapes = shape, .patches = patches, .away = 1000};
	for (u32 k = 0; k < SIDES; k++) ts_k_polygon_item(&args, k);
	w->run.params.truth_area_samples = 4096;
}

static ts_v3 direct(const world *w, const ts_gpixel *pixel)
{
	f32 e[3];
	ts_direct_args args = {.pixels = pixel,
	                       .patches = ts_frame_data(&w->run.frame, TS_B_polygon_patch),
	                       .lamps = ts_frame_data(&w->run.frame, TS_B_lamp_light),
	                       .shapes = ts_frame_data(&w->run.frame, TS_B_lamp_shape),
	                       .irradiance = e,
	                       .n_patches = SIDES,
	                       .n_lamps = 1};
	ts_k_direct_item(&args, 0);
	return ts_load3(e);
}

static void is_lit(const f32 *irradiance, double light, double tolerance)
{
	for (u32 k = 0; k < 3; k++) assert_near(irradiance[k] / (f32)(1u << k), light, tolerance);
}

/* Of the first channel by the middles of STEPS^2 parts of each triangle, of those whose way crosses y = 0.25 at an x
 * below `edge`. */
static double quadrature(const world *w, const ts_gpixel *pixel, double edge)
{
	const ts_patch *patches = ts_frame_data(&w->run.frame, TS_B_polygon_patch);
	double3 p = d3_of(ts_load3(pixel->position)), n = d3_of(ts_load3(pixel->normal));
	double sum = 0;
	for (u32 k = 0; k < SIDES; k++) {
		double3 a = d3_of(ts_load3(patches[k].a)), b = d3_sub(d3_of(ts_load3(patches[k].b)), a);
		double3 c = d3_sub(d3_of(ts_load3(patches[k].c)), a), turned = d3_cross(b, c);
		for (u32 i = 0; i < STEPS * STEPS; i++) {
			double u = (i % STEPS + 0.5) / STEPS, v = (double)(i / STEPS) / STEPS + 0.5 / STEPS;
			double3 at = d3_mad(d3_mad(a, b, u + v > 1 ? 1 - u : u), c, u + v > 1 ? 1 - v : v), way = d3_sub(at, p);
			double cosine = d3_dot(n, way), front = -d3_dot(turned, way), far = d3_dot(way, way);
			if (cosine <= 0 || front <= 0 || p.x + (p.y - 0.25) / (p.y - at.y) * way.x >= edge) continue;
			sum += (double)patches[k].exitance[0] * cosine * front / (far * far) / (2 * STEPS * STEPS);
		}
	}
	return sum / 3.14159265358979;
}

/* Nothing is in the way: both truths are what pixels gather. */
static void lamps_in_the_open_light_as_gathered(void **state)
{
	(void)state;
	static const u32 kinds[] = {TS_LIGHT_KIND_SPOT, TS_LIGHT_KIND_POINT, TS_LIGHT_KIND_DIRECTIONAL};
	for (u32 i = 0; i < 6; i++) {
		world *w = malloc(sizeof *w);
		assert_non_null(w);
		world_begin(w);
		w->scene.info.box_max[1] = 8;
		cover_with(w, 4); /* beyond the receivers */
		world_pose(w);
		ts_gpixel *pixels = make_receivers(w);
		pixels[N_RECEIVERS - 1].depth = TS_SKY;
		hang(w, kinds[i % 3], i < 3 ? 0.25f : 0);
		for (u32 pass = 0; pass < 2; pass++) {
			const f32 *found = traced(w, pass == 0 ? ts_truth_lamps_exact : ts_truth_lamps_shadowed);
			for (u32 k = 0; k < N_RECEIVERS; k++) {
				double light = k < N_RECEIVERS - 1 ? (double)direct(w, &pixels[k]).x : 0;
				double open = quadrature(w, &pixels[k], 1e9);
				if (kinds[i % 3] != TS_LIGHT_KIND_DIRECTIONAL) is_lit(found + (u64)k * 3, light, 1e-4 * light + 1e-6);
				if (i < 2 && light > 0) assert_near(found[(u64)k * 3], open, 2e-3 * open);
				if (i % 3 == 2) is_lit(found + (u64)k * 3, light, 3e-3 * light + 1e-6);
			}
		}
		world_done(w);
	}
}

/* A cover over all hides all; one over a half hides what its edge says. `exact` sees neither. */
static void a_cover_hides_what_its_edge_says(void **state)
{
	(void)state;
	for (u32 i = 0; i < 6; i++) {
		world *w = malloc(sizeof *w);
		assert_non_null(w);
		world_begin(w);
		w->scene.info.box_max[1] = 8;
		f32 edge = i < 3 ? -9 : 0;
		world_quad(w, ts_v3_make(edge, 0.25f, -9), ts_v3_make(edge, 0.25f, 9), ts_v3_make(9, 0.25f, 9),
		           ts_v3_make(9, 0.25f, -9), TWO_SIDED, 0);
		world_pose(w);
		ts_gpixel *pixels = make_receivers(w);
		hang(w, i % 3 == 0 ? TS_LIGHT_KIND_SPOT : TS_LIGHT_KIND_POINT, i % 3 < 2 ? 0.2f : 0);
		const f32 *found = traced(w, ts_truth_lamps_shadowed);
		u32 n_part = 0;
		for (u32 k = 0; k < N_RECEIVERS; k++) {
			double light = (double)direct(w, &pixels[k]).x, right = quadrature(w, &pixels[k], (double)edge);
			if (i % 3 == 2) right = pixels[k].position[0] < edge ? light : 0; /* a point in the edge's plane */
			is_lit(found + (u64)k * 3, right, 0.02 * light + 1e-6);
			n_part += right > 0.2 * light && right < 0.8 * light;
		}
		assert_true(i % 3 == 2 || (i < 3) == (n_part == 0));
		found = traced(w, ts_truth_lamps_exact);
		for (u32 k = 0; k < N_RECEIVERS; k++) {
			double light = (double)direct(w, &pixels[k]).x;
			is_lit(found + (u64)k * 3, light, 1e-4 * light + 1e-6);
		}
		world_done(w);
	}
}

int main(void)
{
	const struct CMUnitTest lamps[] = {cmocka_unit_test(lamps_in_the_open_light_as_gathered),
	                                   cmocka_unit_test(a_cover_hides_what_its_edge_says)};
	return cmocka_run_group_tests(lamps, NULL, NULL);
}

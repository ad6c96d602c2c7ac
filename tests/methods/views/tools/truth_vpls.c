/* Truth of particles: their light, and what stands in the way. */
#include "methods/views/tools/tools.h"
#include "tests/methods/raster/tools/receivers.h"

#define COVER 1.75f /* height of a cover above all receivers, among the particles */

/* Light of one particle in red: cos / (4 pi d^2), unless its way leads through the cover, `reach` or more away from
 * it. */
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
static void particles_light_what_they_see(void **state)
{
	(void)state;
	double sum[2] = {0};
	for (u32 covered = 0; covered < 2; covered++) {
		world *w = square_new();
		f32 y = covered ? COVER : 9;
		cover_with(w, y);
		world_pose(w);
		ts_gpixel *pixels = make_receivers(w);
		for (u32 i = 0; i < N_RECEIVERS; i++) pixels[i].normal[1] = -pixels[i].normal[1];
		w->run.params.particle_count = 100;
		w->run.params.vpl_gather_near = 0.0009765625f;
		const f32 *found = traced(w, ts_truth_glow);
		const ts_vpl *lights = ts_frame_data(&w->run.frame, TS_B_vpl_light);
		const ts_root *root = ts_frame_data(&w->run.frame, TS_B_octree_root);
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
	const struct CMUnitTest vpls[] = {cmocka_unit_test(particles_light_what_they_see)};
	return cmocka_run_group_tests(vpls, NULL, NULL);
}

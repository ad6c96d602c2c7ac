/* Paths of light on a scene: lights where the texels of the lamp's maps are, and at their reflections; rays, against a
 * loop over all triangles and in double precision; a lamp that meets nothing. */
#include <math.h>
#include "kernels/views/cast.h"
#include "tests/methods/views/octrees.h"

/* Flux of all lights, of red. */
static double flux_of(const ts_run *run)
{
	double sum = 0;
	const ts_vpl *lights = ts_frame_data(&run->frame, TS_B_vpl_light);
	for (u64 i = 0; i < ts_frame_n(&run->frame, TS_B_vpl_light); i++) sum += (double)lights[i].flux[0];
	return sum;
}

/* All lights send what their texels do, half a leaf above them; so many at random send as much in all. */
static void lights_send_what_their_texels_do(void **state)
{
	(void)state;
	ts_run all, some;
	ts_params params = octrees_params(6, 0);
	ts_scene *scene = small_scene(&params);
	octrees_run(&all, scene, &params);
	const ts_vpl *lights = ts_frame_data(&all.frame, TS_B_vpl_light);
	const ts_patch *patches = ts_frame_data(&all.frame, TS_B_rsm_patch);
	const ts_root *root = ts_frame_data(&all.frame, TS_B_octree_root);
	u64 n = 0;
	double sum = 0, half_leaf = (double)root->side / 128;
	for (u64 i = 0; i < ts_frame_n(&all.frame, TS_B_rsm_patch); i++) {
		const ts_patch *p = &patches[i];
		if (!(p->exitance[0] > 0 || p->exitance[1] > 0 || p->exitance[2] > 0)) continue;
		double side = 0, away = 0;
		for (u32 k = 0; k < 3; k++) {
			double middle = ((double)p->a[k] + (double)p->b[k] + (double)p->c[k]) / 3;
			side += ((double)p->b[k] - (double)p->a[k]) * ((double)p->b[k] - (double)p->a[k]);
			away += ((double)lights[n].position[k] - middle) * (double)p->normal[k];
		}
		double flux = (double)p->exitance[0] * sqrt(3) / 4 * side;
		assert_true(fabs((double)lights[n].flux[0] - flux) <= 1e-4 * flux + 1e-9);
		assert_true(fabs(away - half_leaf) < 1e-3 * half_leaf && lights[n].bounce == 1);
		assert_memory_equal(lights[n].normal, p->normal, sizeof p->normal);
		sum += flux;
		n++;
	}
	assert_int_equal(n, ts_frame_n(&all.frame, TS_B_vpl_light));
	params.vpl_paths = 100000;
	octrees_run(&some, scene, &params);
	assert_int_equal(ts_frame_n(&some.frame, TS_B_vpl_light), 100000);
	assert_true(fabs(flux_of(&some) - sum) < 0.02 * sum);
	ts_run_end(&some);
	ts_run_end(&all);
	ts_scene_free(scene);
}

static ts_cast_args cast_of(const ts_run *run, u32 levels)
{
	const ts_root *root = ts_frame_data(&run->frame, TS_B_octree_root);
	return (ts_cast_args){
		.scene = ts_run_arrays(run),
		.nodes = ts_frame_data(&run->frame, TS_B_octree_node),
		.offset = ts_frame_data(&run->frame, TS_B_octree_offset),
		.triangles = ts_frame_data(&run->frame, TS_B_octree_triangle),
		.first_leaf = ((const u32 *)ts_frame_data(&run->frame, TS_B_octree_level))[levels],
		.leaf = root->side / (f32)(1 << levels),
	};
}

static f32 uniform(u32 n) { return ts_uniform(ts_random(n, 6, 3)); }

/* In double precision: where the ray meets the triangle's plane, or 0 if that is not well inside it and in front. */
static double meets(const ts_corners *t, ts_v3 o, ts_v3 d, double margin)
{
	double e1[3] = {(double)t->b.x - (double)t->a.x, (double)t->b.y - (double)t->a.y, (double)t->b.z - (double)t->a.z};
	double e2[3] = {(double)t->c.x - (double)t->a.x, (double)t->c.y - (double)t->a.y, (double)t->c.z - (double)t->a.z};
	double s[3] = {(double)o.x - (double)t->a.x, (double)o.y - (double)t->a.y, (double)o.z - (double)t->a.z};
	double r[3] = {(double)d.x, (double)d.y, (double)d.z};
	double p[3] = {r[1] * e2[2] - r[2] * e2[1], r[2] * e2[0] - r[0] * e2[2], r[0] * e2[1] - r[1] * e2[0]};
	double q[3] = {s[1] * e1[2] - s[2] * e1[1], s[2] * e1[0] - s[0] * e1[2], s[0] * e1[1] - s[1] * e1[0]};
	double whole = e1[0] * p[0] + e1[1] * p[1] + e1[2] * p[2];
	double u = (s[0] * p[0] + s[1] * p[1] + s[2] * p[2]) / whole, v = (r[0] * q[0] + r[1] * q[1] + r[2] * q[2]) / whole;
	double at = (e2[0] * q[0] + e2[1] * q[1] + e2[2] * q[2]) / whole;
	return u > margin && v > margin && u + v < 1 - margin && at > 1e-4 ? at : 0;
}

/* A ray meets what a loop over all triangles finds, and what is in its way in double precision. */
static void rays_meet_what_a_loop_finds(void **state)
{
	(void)state;
	ts_run run;
	u32 n_hits = 0;
	ts_params params = octrees_params(5, 0);
	ts_scene *scene = small_scene(&params);
	octrees_run(&run, scene, &params);
	const ts_cast_args args = cast_of(&run, 5);
	for (u32 i = 0; i < 1500; i++) {
		ts_v3 o = ts_v3_make(12 * uniform(6 * i) - 6, 8 * uniform(6 * i + 1) - 4, 12 * uniform(6 * i + 2) - 6);
		ts_v3 d = ts_v3_make(uniform(6 * i + 3) - 0.5f, uniform(6 * i + 4) - 0.5f, uniform(6 * i + 5) - 0.5f);
		d = i % 10 == 0 ? ts_v3_make(0, i % 20 == 0 ? 1 : -1, 0) : ts_normalize(d);
		ts_cast_ray ray = ts_k_cast_ray(o, d);
		ts_cast_hit found = ts_k_cast(&args, o, d), all = {.t = 4611686018427387904.0f, .triangle = TS_NONE};
		double sure = 1e30;
		for (u32 t = scene->n_triangles; t-- > 0;) {
			ts_corners corners = ts_k_corners(&args.scene, t);
			ts_k_cast_triangle(&args, &ray, t, &all);
			double at = meets(&corners, o, d, 1e-3);
			bool counts = at > 0 && ts_k_is_facing(&args.scene, t, &corners, o);
			bool whole = (args.scene.materials[args.scene.triangles[t].material].flags & TS_MASKED) == 0;
			if (counts && whole && at < sure) sure = at;
		}
		assert_memory_equal(&found, &all, sizeof found);
		assert_true((double)found.t <= sure * 1.0001);
		if (found.triangle == TS_NONE) continue;
		ts_corners corners = ts_k_corners(&args.scene, found.triangle);
		double at = meets(&corners, o, d, -1e-3);
		assert_true(at == 0 ? found.t < 1e-3f : fabs(at - (double)found.t) < 1e-3 * at);
		n_hits++;
	}
	assert_true(n_hits > 500);
	ts_run_end(&run);
	ts_scene_free(scene);
}

/* Paths begin where single lights are, lose the albedo of what they meet, and their lights hover over surfaces. */
static void paths_begin_at_single_lights(void **state)
{
	(void)state;
	ts_run once, often;
	u32 n[5] = {0}, n_lost = 0;
	ts_params params = octrees_params(5, 3000);
	ts_scene *scene = small_scene(&params);
	octrees_run(&once, scene, &params);
	params.vpl_bounces = 4;
	octrees_run(&often, scene, &params);
	const ts_vpl *first = ts_frame_data(&once.frame, TS_B_vpl_light),
				 *light = ts_frame_data(&often.frame, TS_B_vpl_light);
	const u32 *path = ts_frame_data(&often.frame, TS_B_vpl_path);
	const ts_cast_args args = cast_of(&often, 5);
	for (u32 k = 0; k < 3000; k++) {
		assert_memory_equal(&light[path[k]], &first[k], sizeof *first);
		for (u32 i = path[k]; i < path[k + 1]; i++) {
			const ts_v3 normal = ts_load3(light[i].normal), p = ts_load3(light[i].position);
			assert_int_equal(light[i].bounce, i - path[k] + 1);
			n[light[i].bounce]++;
			f32 below = ts_k_cast(&args, p, ts_neg(normal)).t;
			n_lost += below >= args.leaf * 0.501f; /* beside the border of its triangle, as rounding falls */
			if (i == path[k]) continue;
			for (u32 c = 0; c < 3; c++) assert_true(light[i].flux[c] <= light[i - 1].flux[c]);
		}
	}
	assert_true(n[1] == 3000 && n[2] > 1000 && n[2] >= n[3] && n[3] >= n[4] && n[4] > 300);
	assert_true(n_lost < 30);
	ts_run_end(&often);
	ts_run_end(&once);
	ts_scene_free(scene);
}

/* Lights at random hover over what rays meet, so that none is where a mask cuts the surface away, and send in all what
 * those at the lamp's texels do. */
static void random_lights_hover_over_what_rays_meet(void **state)
{
	(void)state;
	ts_run lit, any;
	u32 n_lost = 0, n_dark = 0;
	ts_params params = octrees_params(6, 0);
	params.rsm_px = 192;
	ts_scene *scene = small_scene(&params);
	octrees_run(&lit, scene, &params);
	params.vpl_place = TS_VPL_AT_RANDOM;
	params.vpl_paths = 100000;
	octrees_run(&any, scene, &params);
	const ts_cast_args args = cast_of(&any, 6);
	const ts_vpl *light = ts_frame_data(&any.frame, TS_B_vpl_light);
	u64 n = ts_frame_n(&any.frame, TS_B_vpl_light);
	for (u64 i = 0; i < n; i++) {
		f32 below = ts_k_cast(&args, ts_load3(light[i].position), ts_neg(ts_load3(light[i].normal))).t;
		n_lost += below >= args.leaf * 0.501f;
		n_dark += light[i].flux[0] == 0;
		assert_int_equal(light[i].bounce, 1);
	}
	print_message("%u lights, %u dark, %u over nothing, flux %g, of texels %g\n", (unsigned)n, n_dark, n_lost,
	              flux_of(&any), flux_of(&lit));
	assert_true(n < 100000 && n > 50000 && n_dark > n / 2 && n_lost < n / 1000);
	assert_true(fabs(flux_of(&any) - flux_of(&lit)) < 0.03 * flux_of(&lit));
	ts_run_end(&any);
	ts_run_end(&lit);
	ts_scene_free(scene);
}

/* A lamp that meets nothing: no lights, an octree without nodes. */
static void a_lamp_without_hits_makes_no_lights(void **state)
{
	(void)state;
	ts_run run;
	ts_params params = octrees_params(4, 50);
	params.light_irradiance = 0;
	ts_scene *scene = small_scene(&params);
	octrees_run(&run, scene, &params);
	assert_int_equal(ts_frame_n(&run.frame, TS_B_vpl_light), 0);
	assert_int_equal(ts_frame_n(&run.frame, TS_B_view_octree_node), 0);
	assert_int_equal(ts_frame_n(&run.frame, TS_B_view_octree_cone), 0);
	assert_true(ts_frame_n(&run.frame, TS_B_octree_node) > 0);
	ts_run_end(&run);
	ts_scene_free(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(lights_send_what_their_texels_do),
		cmocka_unit_test(rays_meet_what_a_loop_finds),
		cmocka_unit_test(paths_begin_at_single_lights),
		cmocka_unit_test(random_lights_hover_over_what_rays_meet),
		cmocka_unit_test(a_lamp_without_hits_makes_no_lights),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
